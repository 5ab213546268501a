//! `effigy bake`: the source files that tools/fetch_assets.sh gets go in; an avatar or a clip comes out.

use crate::avatar::{Avatar, Clip, Skeleton, limits};
use crate::bake::{self, Assets, Options, Shape, Sizes};
use anyhow::{Context, ensure};
use clap::builder::RangedU64ValueParser;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::time::Instant;

#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(clap::Subcommand)]
enum What {
    /// Make an avatar from the MakeHuman body
    Body(BodyArgs),
    /// Make a clip from CMU motion capture
    Motion(MotionArgs),
}

pub(super) fn count(low: usize, high: usize) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low as u64..=high as u64)
}

/// The body that the assets make.
#[derive(clap::Args)]
pub(super) struct Body {
    /// Folder that tools/fetch_assets.sh filled
    #[arg(long, value_name = "DIR", default_value = Assets::DEFAULT)]
    assets: PathBuf,
    #[arg(long, value_enum, default_value = "male")]
    pub shape: Shape,
    #[arg(long, default_value = "200000", value_parser = count(1000, limits::GAUSSIANS))]
    gaussians: usize,
    /// Body parts, each with a network of its own
    #[arg(long, default_value = "256", value_parser = count(1, limits::PARTS))]
    parts: usize,
    /// Points that carry the position correctives
    #[arg(long, default_value = "10000", value_parser = count(3, limits::NODES))]
    nodes: usize,
    #[arg(long, default_value = "1")]
    pub seed: u64,
}

impl Body {
    pub fn assets(&self) -> Assets {
        Assets::new(&self.assets)
    }

    /// With so many rows of correctives.
    pub fn sizes(&self, rows: usize) -> anyhow::Result<Sizes> {
        let &Self { gaussians, parts, nodes, seed, .. } = self;
        for (name, number) in [("parts", parts), ("nodes", nodes), ("rows", rows)] {
            ensure!(number <= gaussians, "--{name} {number} can't be above --gaussians, {gaussians}");
        }
        Ok(Sizes { gaussians, parts, nodes, rows, seed })
    }
}

#[derive(clap::Args)]
struct BodyArgs {
    /// The avatar file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    #[command(flatten)]
    body: Body,
    /// Gaussians that keep a corrective, for each of rotation, scale and colour
    #[arg(long, default_value = "20000", value_parser = count(0, limits::GAUSSIANS))]
    rows: usize,
    /// A clip whose poses decide the pose components and which correctives are kept; repeat for several [default: the assets' 01_01.bvh]
    #[arg(long, value_name = "FILE")]
    motion: Vec<PathBuf>,
}

#[derive(clap::Args)]
struct MotionArgs {
    /// The capture, a .bvh file with CMU's joint names; a bare name is looked for among the assets too
    capture: PathBuf,
    /// The motion file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Folder that tools/fetch_assets.sh filled
    #[arg(long, value_name = "DIR", default_value = Assets::DEFAULT)]
    assets: PathBuf,
    /// Take the skeleton from this avatar instead of the assets
    #[arg(long, value_name = "FILE")]
    avatar: Option<PathBuf>,
    #[arg(long, value_enum, default_value = "male")]
    shape: Shape,
    /// Frames a second
    #[arg(long, default_value = "60", value_parser = clap::value_parser!(u16).range(1..=240))]
    rate: u16,
    /// Seconds into the capture
    #[arg(long, value_name = "SECONDS", default_value = "0")]
    from: f64,
    /// Seconds into the capture [default: its end]
    #[arg(long, value_name = "SECONDS")]
    to: Option<f64>,
    /// Keep the hips near the origin, the first frame facing the camera
    #[arg(long)]
    in_place: bool,
    /// Where a clip that repeats begins, seconds into the capture [default: --from]
    #[arg(long, value_name = "SECONDS")]
    start: Option<f64>,
    /// Let this much of the end fade into what comes before the start, so that the clip repeats without a jump
    #[arg(long, value_name = "SECONDS", default_value = "0")]
    fade: f64,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    match args.what {
        What::Body(args) => body(&args),
        What::Motion(args) => motion(&args),
    }
}

/// A progress bar of so many steps.
pub(super) fn bar(steps: u64) -> anyhow::Result<ProgressBar> {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg} {elapsed}").context("the bar's template is wrong")?;
    Ok(ProgressBar::new(steps).with_style(style))
}

fn body(args: &BodyArgs) -> anyhow::Result<()> {
    let start = Instant::now();
    let (assets, shape, sizes) = (args.body.assets(), args.body.shape, args.body.sizes(args.rows)?);
    let clips = if args.motion.is_empty() {
        let skeleton = bake::skeleton(&assets, shape)?;
        let options = Options { rate: 30.0, from: 0.0, to: None, in_place: false, start: None, fade: 0.0 };
        vec![bake::motion(&assets.path("01_01.bvh"), &skeleton, &options)?]
    } else {
        args.motion.iter().map(|path| Ok(Clip::read(path)?)).collect::<anyhow::Result<_>>()?
    };
    let bar = bar(bake::STEPS)?;
    let begun = std::cell::Cell::new(0);
    let step = |name: &'static str| {
        bar.set_position(begun.get());
        bar.set_message(name);
        begun.set(begun.get() + 1);
    };
    let avatar = bake::body(&assets, shape, &clips, &sizes, &step)?;
    bar.finish_and_clear();
    avatar.write(&args.out)?;
    summarise(&avatar, &args.out, start)
}

fn summarise(avatar: &Avatar, out: &Path, start: Instant) -> anyhow::Result<()> {
    println!(
        "{}: {} Gaussians, {} parts ({} of the head), {} nodes, {} + {} + {} corrective rows, {} joints; {:.1} MB in {:.1} s",
        out.display(),
        avatar.gaussians.len(),
        avatar.parts.len(),
        avatar.parts.head,
        avatar.nodes.len(),
        avatar.rotation_rows.gaussian.len(),
        avatar.scale_rows.gaussian.len(),
        avatar.color_rows.gaussian.len(),
        avatar.skeleton.len(),
        size(out)?,
        start.elapsed().as_secs_f64(),
    );
    Ok(())
}

fn size(path: &Path) -> anyhow::Result<f64> {
    Ok(std::fs::metadata(path).with_context(|| format!("cannot look at {}", path.display()))?.len() as f64 / 1e6)
}

fn motion(args: &MotionArgs) -> anyhow::Result<()> {
    let assets = Assets::new(&args.assets);
    let skeleton: Skeleton = match &args.avatar {
        Some(path) => Avatar::read(path)?.skeleton,
        None => bake::skeleton(&assets, args.shape)?,
    };
    let among = assets.path(&args.capture.to_string_lossy());
    let capture = if !args.capture.exists() && among.exists() { &among } else { &args.capture };
    let options =
        Options { rate: f64::from(args.rate), from: args.from, to: args.to, in_place: args.in_place, start: args.start, fade: args.fade };
    let clip = bake::motion(capture, &skeleton, &options)?;
    clip.write(&args.out)?;
    let (frames, rate) = (clip.frames(), args.rate);
    println!("{}: {frames} frames at {rate} Hz, {:.1} s; {:.1} MB", args.out.display(), frames as f64 / f64::from(rate), size(&args.out)?);
    Ok(())
}
