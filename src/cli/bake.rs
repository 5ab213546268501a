//! `effigy bake`: makes an avatar or a clip from the source files that tools/fetch_assets.sh gets.

use crate::{
    assets, files,
    options::{count, named},
    output::{WriteAvatar, WriteMotion},
    progress,
};
use anyhow::{Context, ensure};
use effigy_core::avatar::{Avatar, Clip, limits};
use effigy_learn::bake::{
    self, Assets, BakeSizes, BodyShape, CutOptions, Person, credits::MOTION_CREDIT,
};
use std::{
    cell::Cell,
    path::{Path, PathBuf},
    time::Instant,
};

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(subcommand)]
    command: BakeCommand,
}

#[derive(clap::Subcommand, Debug)]
enum BakeCommand {
    /// Make an avatar from the MakeHuman body
    Body(BodyArgs),
    /// Make a clip from motion capture, cut and with a face that moves
    Motion(MotionArgs),
}

/// The body's source files, and which of its shapes to make.
#[derive(clap::Args, Debug)]
pub struct AssetArgs {
    /// Folder that tools/fetch_assets.sh filled
    #[arg(long, value_name = "DIR", env = "EFFIGY_ASSETS", default_value_os_t = assets::folder())]
    assets: PathBuf,
    /// Person to make, 1 or 2: bodies, skin, hair and clothes differ
    #[arg(long, value_name = "N", value_parser = named(Person::NAMES, Person::ALL), default_value = "1")]
    person: Person,
    /// Shape of the body [default: male of person 1, female of person 2]
    #[arg(long, value_parser = named(BodyShape::NAMES, BodyShape::ALL))]
    shape: Option<BodyShape>,
}

impl AssetArgs {
    pub fn assets(&self) -> Assets {
        Assets::new(&self.assets)
    }

    pub fn person(&self) -> Person {
        Person {
            shape: self.shape.unwrap_or(self.person.shape),
            ..self.person
        }
    }
}

#[derive(clap::Args, Debug)]
struct BodyArgs {
    #[command(flatten)]
    out: WriteAvatar,
    #[command(flatten)]
    assets: AssetArgs,
    /// Gaussians, 1000 to 2000000
    #[arg(long, value_name = "N", default_value = "200000", value_parser = count(1000, limits::GAUSSIANS))]
    gaussians: usize,
    /// Body parts, 1 to 1024, each with a network of its own
    #[arg(long, value_name = "N", default_value = "256", value_parser = count(1, limits::PARTS))]
    parts: usize,
    /// Nodes, 3 to 65536: points that carry the position correctives
    #[arg(long, value_name = "N", default_value = "10000", value_parser = count(3, limits::NODES))]
    nodes: usize,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value = "1")]
    seed: u64,
    /// Gaussians that keep a corrective, 0 to --gaussians, for each of rotation, scale and colour
    #[arg(long, value_name = "N", default_value = "20000", value_parser = count(0, limits::GAUSSIANS))]
    rows: usize,
    /// Clip whose poses decide the pose components and the correctives to keep; repeat for several
    /// [default: the assets' 01_01.bvh]
    #[arg(long, value_name = "FILE")]
    motion: Vec<PathBuf>,
}

impl BodyArgs {
    /// Counts of everything. An error names all of which there are more than Gaussians.
    fn sizes(&self) -> anyhow::Result<BakeSizes> {
        let gaussians = self.gaussians;
        let counts = [
            ("parts", self.parts),
            ("nodes", self.nodes),
            ("rows", self.rows),
        ];
        let above = counts.iter().filter(|(_, number)| *number > gaussians);
        let above: Vec<String> = above.map(|(name, n)| format!("--{name} {n}")).collect();
        ensure!(
            above.is_empty(),
            "found {} with --gaussians {gaussians}, expected --parts, --nodes and --rows of at most \
             as many as --gaussians each",
            above.join(" and ")
        );
        Ok(BakeSizes {
            gaussians,
            parts: self.parts,
            nodes: self.nodes,
            rows: self.rows,
            seed: self.seed,
        })
    }
}

#[derive(clap::Args, Debug)]
struct MotionArgs {
    /// Motion capture, a .bvh file; a file name alone is also looked for among the assets
    capture: PathBuf,
    #[command(flatten)]
    out: WriteMotion,
    #[command(flatten)]
    assets: AssetArgs,
    /// Avatar that motion of another body is to move [default: the built-in demo; of `bake motion`
    /// the assets' body]
    #[arg(long, value_name = "FILE")]
    avatar: Option<PathBuf>,
    /// Frames per second of the clip, 1 to 240
    #[arg(long, alias = "rate", value_name = "N", default_value = "60", value_parser = clap::value_parser!(u16).range(1..=240))]
    fps: u16,
    /// Where the clip begins, seconds into the capture
    #[arg(long, value_name = "SECONDS", default_value = "0")]
    from: f64,
    /// Where the clip ends, seconds into the capture [default: its end]
    #[arg(long, value_name = "SECONDS")]
    to: Option<f64>,
    /// Keep the hips near the origin, and face the camera in the first frame
    #[arg(long)]
    in_place: bool,
    /// Where a clip that repeats begins, seconds into the capture [default: --from]
    #[arg(long, value_name = "SECONDS")]
    start: Option<f64>,
    /// Length of the blend at the end into the frames before the start, seconds, so that the clip
    /// repeats without a jump
    #[arg(long, value_name = "SECONDS", default_value = "0")]
    fade: f64,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    match args.command {
        BakeCommand::Body(args) => body(&args),
        BakeCommand::Motion(args) => motion(&args),
    }
}

fn body(args: &BodyArgs) -> anyhow::Result<()> {
    let start = Instant::now();
    let out = args.out.file()?;
    let assets = args.assets.assets();
    let person = args.assets.person();
    let sizes = args.sizes()?;
    let clips = if args.motion.is_empty() {
        vec![default_clip(&assets, person.shape)?]
    } else {
        let read = args.motion.iter().map(|path| Clip::read(path));
        read.collect::<Result<_, _>>()?
    };
    let bar = progress::steps(bake::STEPS);
    let begun = Cell::new(0);
    let step = |name: &'static str| {
        bar.set_position(begun.get());
        bar.set_message(name);
        begun.set(begun.get() + 1);
    };
    let avatar = bake::body(&assets, person, &clips, &sizes, &step)?;
    bar.finish_and_clear();
    avatar.write(out)?;
    summarise(&avatar, out, start)
}

/// The clip that the body is baked for unless the user names others.
fn default_clip(assets: &Assets, shape: BodyShape) -> anyhow::Result<Clip> {
    let options = CutOptions {
        rate: 30.0,
        from: 0.0,
        to: None,
        in_place: false,
        start: None,
        fade: 0.0,
        credit: MOTION_CREDIT.into(),
    };
    let skeleton = bake::skeleton(assets, shape)?;
    Ok(bake::motion(
        &assets.path("01_01.bvh"),
        &skeleton,
        &options,
    )?)
}

fn summarise(avatar: &Avatar, out: &Path, start: Instant) -> anyhow::Result<()> {
    println!(
        "{}: {}; {:.1} MB in {:.1} s",
        out.display(),
        files::describe(avatar),
        megabytes(out)?,
        start.elapsed().as_secs_f64(),
    );
    Ok(())
}

/// The size of a file, MB.
fn megabytes(path: &Path) -> anyhow::Result<f64> {
    let file =
        std::fs::metadata(path).with_context(|| format!("{} can't be read", path.display()))?;
    Ok(file.len() as f64 / 1e6)
}

fn motion(args: &MotionArgs) -> anyhow::Result<()> {
    let out = args.out.file()?;
    let assets = Assets::new(&args.assets.assets);
    let skeleton = match &args.avatar {
        Some(path) => Avatar::read(path)?.skeleton,
        None => bake::skeleton(&assets, args.assets.person().shape)?,
    };
    let asset = assets.path(&args.capture.to_string_lossy());
    let capture = if !args.capture.exists() && asset.exists() {
        &asset
    } else {
        &args.capture
    };
    let options = CutOptions {
        rate: f64::from(args.fps),
        from: args.from,
        to: args.to,
        in_place: args.in_place,
        start: args.start,
        fade: args.fade,
        credit: if capture.starts_with(&args.assets.assets) {
            MOTION_CREDIT.into()
        } else {
            String::new()
        },
    };
    let clip = bake::motion(capture, &skeleton, &options)?;
    clip.write(out)?;
    println!(
        "{}: {} frames at {} Hz, {:.1} s; {:.1} MB",
        out.display(),
        clip.frames(),
        args.fps,
        clip.frames() as f64 / f64::from(args.fps),
        megabytes(out)?
    );
    Ok(())
}
