//! `effigy pack`: an avatar goes in, a smaller file of it comes out, with what each step saved and what it cost.

use super::{
    options,
    render::progress,
    source::{Project, Source},
};
use crate::{
    avatar::{Avatar, import, motion::Player, pack::Quality},
    measure::packing::{self, Line, Views},
};
use anyhow::{Context, ensure};
use clap::ValueEnum;
use std::{
    path::{Path, PathBuf},
    time::Instant,
};

#[derive(clap::Args)]
pub struct Args {
    /// The avatar to pack [default: the built-in demo]
    avatar: Option<PathBuf>,
    /// The file to write
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// How much may be lost
    #[arg(long, value_enum, default_value_t = By::High)]
    quality: By,
    /// A clip to take pictures of [default: the built-in demo clip]
    #[arg(long, value_name = "FILE")]
    motion: Option<PathBuf>,
    /// Pictures to compare after each step, spread over the clip, each from another side and drawn by the f64 reference, which takes
    /// seconds; 0 compares none
    #[arg(long, value_name = "N", default_value_t = 4)]
    pictures: usize,
    /// Width and height of the pictures, px
    #[arg(long, value_parser = options::size, default_value = "512x640")]
    size: [u32; 2],
    /// Write the table as JSON too
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// [`Quality`] as the command line has it.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum By {
    /// Nothing that any picture shows: bytes are arranged and deflated, numbers that nothing reads become zeros
    Lossless,
    /// What the renderers round anyway: quaternions, log scales, colours and bases in fewer bits; they draw the same pictures
    High,
    /// Weights of networks with 10 bits that count in place of 11 too
    Medium,
    /// Weights of networks in bytes, also in the device's memory
    Small,
}

impl From<By> for Quality {
    fn from(by: By) -> Self {
        match by {
            By::Lossless => Self::Lossless,
            By::High => Self::High,
            By::Medium => Self::Medium,
            By::Small => Self::Small,
        }
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let ply = args.avatar.as_deref().filter(|path| import::is_ply(path));
    ensure!(ply.is_none(), "a .ply has neither networks nor bases to pack: give an .avatar file");
    let source = Source { avatar: args.avatar.clone(), motion: args.motion.iter().cloned().collect(), up: None, project: Project::On };
    let (avatar, clips) = source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    let views = Views { player: &player, pictures: args.pictures, size: args.size };
    let bar = progress(0, "pictures");
    let (lines, packed) = packing::steps(&avatar, args.quality.into(), &views, |what, done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    })?;
    bar.finish_and_clear();
    packed.write_packed(&args.out)?;
    print(&lines);
    println!("wrote {}", args.out.display());
    if let Some(path) = &args.avatar {
        println!("reading takes {:.0} ms, of {} {:.0} ms", reading(&args.out)?, path.display(), reading(path)?);
    }
    if let Some(path) = &args.json {
        std::fs::write(path, serde_json::to_string_pretty(&lines)? + "\n")
            .with_context(|| format!("{} can't be written", path.display()))?;
    }
    Ok(())
}

/// How long a file takes to read, ms: the middle of five times.
fn reading(path: &Path) -> anyhow::Result<f64> {
    let once = |_| -> anyhow::Result<f64> {
        let from = Instant::now();
        Avatar::read(path)?;
        Ok(from.elapsed().as_secs_f64() * 1e3)
    };
    let mut times = (0..5).map(once).collect::<Result<Vec<_>, _>>()?;
    times.sort_by(f64::total_cmp);
    Ok(times[times.len() / 2])
}

fn print(lines: &[Line]) {
    let megabytes = |bytes: usize| format!("{:.2}", bytes as f64 / 1e6);
    let decibels = |db: Option<f64>| match db {
        None => "–".to_owned(),
        Some(db) if db.is_infinite() => "exact".to_owned(),
        Some(db) => format!("{db:.2}"),
    };
    println!("{:<46}{:>9}{:>9}{:>9}{:>9}{:>12}{:>10}{:>9}", "MB", "file", "saved", "raw", "device", "rounded dB", "drawn dB", "cost dB");
    let mut before = lines.first();
    for line in lines {
        let saved = before.map_or(0.0, |before| (before.file as f64 - line.file as f64) / 1e6);
        let cost = lines.first().and_then(|first| Some(first.drawn_db? - line.drawn_db?)).filter(|cost| cost.is_finite());
        let cost = cost.map_or_else(|| "–".to_owned(), |cost| format!("{:.3}", if cost.abs() < 5e-4 { 0.0 } else { cost }));
        let [file, raw, device] = [line.file, line.raw, line.device].map(megabytes);
        let [rounded, drawn] = [line.rounded_db, line.drawn_db].map(decibels);
        println!("{:<46}{file:>9}{saved:>9.2}{raw:>9}{device:>9}{rounded:>12}{drawn:>10}{cost:>9}", line.what);
        before = Some(line);
    }
    if lines.iter().any(|line| line.drawn_db.is_some()) {
        println!(
            "rounded: against the avatar as it is, both exact; drawn: what a device holds, against the same; cost: what drawn falls by"
        );
    }
}
