//! `effigy pack`: makes an avatar's file smaller, and shows what each step saves and costs.

use crate::{
    inspect::LevelSummary,
    options::{self, FilterArgs, UpArgs},
    output::{JSON, Output, WriteAvatar},
    progress,
    source::{self, CaptureArgs, PoseProjection, Source},
};
use anyhow::{bail, ensure};
use clap::ValueEnum;
use effigy_core::{
    avatar::{Avatar, Level, motion::Player},
    io::pack::PackQuality,
};
use effigy_formats::open::{self, OpenOptions};
use effigy_learn::levels::{LevelOptions, LevelPoses, levels_of};
use effigy_math::{facing, poses};
use effigy_measure::packing::{self, PackingStep, Views};
use std::{
    path::{Path, PathBuf},
    time::Instant,
};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Avatar to pack: an .avatar file, the paper's .npz, mmlphuman's
    /// checkpoint, or splats [default: the built-in demo]
    avatar: Option<PathBuf>,
    #[command(flatten)]
    out: WriteAvatar,
    /// How much may be lost
    #[arg(long, value_enum, default_value_t = QualityArg::High)]
    quality: QualityArg,
    /// Clip that moves the avatar in the compared frames [default: the built-in demo clip]
    #[arg(long, value_name = "FILE")]
    motion: Option<PathBuf>,
    /// Also make levels of detail for small images: merge Gaussians and fit them to supersampled
    /// images of all, in the poses of --motion, or in random ones of the poses that the avatar was
    /// trained for; splats from all sides; takes minutes
    #[arg(long)]
    levels: bool,
    /// Also find from where each Gaussian shows, so that those that face away are not drawn: in the
    /// poses of --motion, in random ones of those that the avatar was trained for, and in wilder
    /// ones; takes minutes
    #[arg(long)]
    facing: bool,
    /// Clip in whose poses the levels' errors are measured [default: other poses of the same kind]
    #[arg(long, value_name = "FILE", requires = "levels")]
    held_out: Option<PathBuf>,
    #[command(flatten)]
    up: UpArgs,
    #[command(flatten)]
    filter: FilterArgs,
    /// Frames to compare after each step, spread over the clip, each from another side; the f64
    /// reference takes seconds for each
    #[arg(long, alias = "pictures", value_name = "N", default_value_t = 4)]
    frames: usize,
    /// Width and height of the image, pixels
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "512x640")]
    size: [u32; 2],
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", value_parser = JSON.parser())]
    json: Option<Output>,
}

/// [`PackQuality`] as an argument.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum QualityArg {
    /// Lose nothing that any image shows: bytes are arranged and deflated, numbers that nothing
    /// reads become zeros
    Lossless,
    /// Round quaternions, log scales, colours and bases as the renderers do anyway; they draw the
    /// same images. Round spherical harmonics to 256ths
    High,
    /// Also round the networks' weights to 10 significant bits, from 11, and spherical harmonics to
    /// 64ths
    Medium,
    /// Also store the networks' weights as bytes, in the device's memory too
    Small,
}

impl From<QualityArg> for PackQuality {
    fn from(quality: QualityArg) -> Self {
        match quality {
            QualityArg::Lossless => Self::Lossless,
            QualityArg::High => Self::High,
            QualityArg::Medium => Self::Medium,
            QualityArg::Small => Self::Small,
        }
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    if let Some(path) = args.avatar.as_deref().filter(|path| open::is_motion(path)) {
        bail!(
            "{} is motion, expected an avatar or splats; motion goes with --motion",
            path.display()
        );
    }
    let out = args.out.file()?;
    let source = Source {
        avatar: args.avatar.clone(),
        motion: args.motion.iter().cloned().collect(),
        capture: CaptureArgs::default(),
        up: args.up.up,
        project: PoseProjection::On,
    };
    let (mut avatar, player) = source.load_player()?;
    args.filter.apply(&mut avatar);
    ensure!(
        args.held_out.is_none() || !avatar.is_static(),
        "`{}` has splats, which stand still: --held-out is for avatars that move",
        avatar.name
    );
    ensure!(
        !args.levels || !avatar.is_static() || avatar.nodes.len() == 1,
        "levels of detail need splats near enough to each other for one box of 16-bit positions; those of `{}` are in {}: leave out --levels",
        avatar.name,
        avatar.nodes.len()
    );
    ensure!(
        !args.facing || !avatar.is_static(),
        "`{}` has splats, which may surround who looks at them: --facing is for avatars that move",
        avatar.name
    );
    // Levels are made of what is drawn from everywhere, and face as the avatar does.
    let faces = args.facing || args.levels && !avatar.gaussians.facing.is_empty();
    if faces {
        avatar.gaussians.facing.clear();
        for level in &mut avatar.levels {
            level.gaussians.facing.clear();
        }
    }
    if args.levels {
        avatar.levels = make_levels(&args, &avatar, &player)?;
    }
    let faced = faces.then(|| face(&avatar, given(&args, &player)));
    let views = Views {
        player: &player,
        images: args.frames,
        size: args.size,
    };
    let bar = progress::items(0, "frames");
    let show = |step: &str, done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(step.to_owned());
    };
    let (lines, packed) =
        packing::measure_steps(&avatar, faced, args.quality.into(), &views, show)?;
    bar.finish_and_clear();
    packed.write_packed(out)?;
    print(&lines);
    let away = faces
        .then(|| packing::facing_away(&packed, &views))
        .flatten();
    if let Some(away) = away {
        println!(
            "{:.0} % of the Gaussians face away in these frames",
            100.0 * away
        );
    }
    for level in &packed.levels {
        print!("{}", LevelSummary::new(level));
    }
    println!("wrote {}", out.display());
    println!("reading it takes {:.0} ms", reading_ms(out)?);
    // What is fitted to a checkpoint is not read from it.
    let read = args.avatar.as_ref();
    if let Some(path) = read.filter(|path| !open::is_checkpoint(path)) {
        println!(
            "reading {} takes {:.0} ms",
            path.display(),
            reading_ms(path)?
        );
    }
    if let Some(json) = &args.json {
        json.write_json(&lines)?;
    }
    Ok(())
}

/// Makes the levels of detail of an avatar. `player`: the clip that moves it in compared frames.
fn make_levels(args: &Args, avatar: &Avatar, player: &Player) -> anyhow::Result<Vec<Level>> {
    let options = LevelOptions::default();
    let mut poses = LevelPoses::new(avatar, given(args, player), options.seed);
    if let Some(path) = &args.held_out {
        let clip_options = CaptureArgs::default().clip_options(None)?;
        let clip = source::clip(path, avatar, &clip_options)?;
        poses.measure_in(Player::new(clip, &avatar.skeleton));
    }
    let bar = progress::items(0, "steps");
    let levels = levels_of(avatar, &poses, &options, &mut |progress| {
        bar.set_length(progress.all as u64);
        bar.set_position(progress.done as u64);
        bar.set_message(progress.step);
    });
    bar.finish_and_clear();
    ensure!(
        !levels.is_empty(),
        "levels of detail need more Gaussians than the {} of `{}`",
        avatar.gaussians.len(),
        avatar.name
    );
    Ok(levels)
}

/// The clip that was named.
fn given<'a>(args: &Args, player: &'a Player) -> &'a [Player] {
    if args.motion.is_some() {
        std::slice::from_ref(player)
    } else {
        &[]
    }
}

/// The share of a pixel from which on a Gaussian shows (docs/experiments/072).
const SHOWN: f64 = 4.0 / 255.0;

/// Finds from where an avatar's Gaussians show.
fn face(avatar: &Avatar, players: &[Player]) -> Avatar {
    let bar = progress::items(0, "views");
    let mut faced = avatar.clone();
    let given = poses::from_clips(players, facing::GIVEN_POSES, 0.5);
    facing::face(&mut faced, &given, SHOWN, &mut |done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    faced
}

/// How long an avatar takes to read, milliseconds: the median of five times.
fn reading_ms(path: &Path) -> anyhow::Result<f64> {
    let once = |_| -> anyhow::Result<f64> {
        let start = Instant::now();
        open::avatar(path, &OpenOptions::default())?;
        Ok(start.elapsed().as_secs_f64() * 1e3)
    };
    let mut times = (0..5).map(once).collect::<Result<Vec<_>, _>>()?;
    times.sort_by(f64::total_cmp);
    Ok(times[times.len() / 2])
}

/// Prints the table of the steps.
fn print(lines: &[PackingStep]) {
    let megabytes = |bytes: usize| bytes as f64 / 1e6;
    let decibels = |db: Option<f64>| match db {
        None => "–".to_owned(),
        Some(db) if db.is_infinite() => "exact".to_owned(),
        Some(db) => format!("{db:.2}"),
    };
    println!(
        "{:<46}{:>9}{:>9}{:>9}{:>9}{:>12}{:>10}{:>9}",
        "MB", "file", "saved", "raw", "device", "rounded dB", "drawn dB", "cost dB"
    );
    let first = lines.first();
    let mut before = first;
    for line in lines {
        let saved = before.map_or(0.0, |before| megabytes(before.file) - megabytes(line.file));
        let cost = first.and_then(|first| Some(first.drawn_db? - line.drawn_db?));
        let cost = match cost {
            Some(cost) if cost.abs() < 5e-4 => "0.000".to_owned(),
            Some(cost) if cost.is_finite() => format!("{cost:.3}"),
            _ => "–".to_owned(),
        };
        println!(
            "{:<46}{:>9.2}{saved:>9.2}{:>9.2}{:>9.2}{:>12}{:>10}{cost:>9}",
            line.what,
            megabytes(line.file),
            megabytes(line.raw),
            megabytes(line.device),
            decibels(line.rounded_db),
            decibels(line.drawn_db)
        );
        before = Some(line);
    }
    if lines.iter().any(|line| line.drawn_db.is_some()) {
        println!(
            "rounded: the packed avatar against the original, both drawn exactly; drawn: what a device holds against the original; cost: how far drawn falls"
        );
    }
}
