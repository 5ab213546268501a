//! `effigy view`, and what `effigy` does without a subcommand.

use super::{
    options::{self, Quality},
    render,
    source::Source,
};
#[cfg(feature = "window")]
use crate::vulkan::RendererOptions;
use clap::Parser;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
#[cfg_attr(feature = "window", command(after_help = crate::app::action::help()))]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Another avatar, for the panel's list and the key A; repeat for several
    #[arg(long, value_name = "FILE")]
    also: Vec<PathBuf>,
    /// Width and height of the window, px
    #[arg(long, value_parser = options::size, default_value = "1280x800")]
    size: [u32; 2],
    /// Fill the screen
    #[arg(long)]
    fullscreen: bool,
    /// Colour behind the avatar
    #[arg(long, value_name = "RRGGBB", default_value = options::BACKGROUND, value_parser = options::color)]
    background: [f32; 3],
    /// Draw without a rest, quit after so many frames and print how long they took
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    frames: Option<u32>,
    #[cfg(feature = "window")]
    #[arg(long, value_name = "surface@N, device@N or memory@N", value_parser = loss, hide = true)]
    rehearse: Vec<(crate::app::Loss, u32)>,
    /// Give up quality where it takes that to hold the display's rate, or that of --fps
    #[arg(long)]
    governor: bool,
    /// The rate to hold, frames a second [default: the display's]
    #[arg(long, value_name = "N", value_parser = options::rate)]
    fps: Option<f64>,
    /// Soak in the window for so many minutes, then write effigy-soak.json, .csv, .svg and .png and quit
    #[arg(long, value_name = "MINUTES", value_parser = options::minutes)]
    soak: Option<f64>,
    /// Write a timeline of host and device at the end, for Perfetto: a .json
    #[arg(long, value_name = "FILE", value_parser = options::trace)]
    trace: Option<PathBuf>,
    #[command(flatten)]
    quality: Quality,
}

/// Reads `surface@N` or `device@N`, a loss before frame N, or `memory@N`, too little of it for what the Nth device is opened for.
#[cfg(feature = "window")]
fn loss(text: &str) -> Result<(crate::app::Loss, u32), String> {
    use crate::app::Loss;
    let parsed = text.split_once('@').and_then(|(what, frame)| {
        let what =
            [("surface", Loss::Surface), ("device", Loss::Device), ("memory", Loss::Memory)].into_iter().find(|known| known.0 == what)?.1;
        Some((what, frame.parse().ok()?))
    });
    parsed.ok_or_else(|| format!("`{text}` is none of surface@N, device@N and memory@N"))
}

/// [`Args`] as a command of its own: the defaults are written down once.
#[derive(Parser)]
struct Defaults {
    #[command(flatten)]
    args: Args,
}

#[cfg(feature = "window")]
pub fn run(args: Args) -> anyhow::Result<()> {
    match crate::app::Display::open() {
        Ok(display) => show(display, args),
        Err(error) => anyhow::bail!("{error}; `effigy render` draws without one"),
    }
}

#[cfg(feature = "window")]
impl Args {
    /// The avatar by this name, which is shown at first, and those to choose besides.
    fn shelf(&self, name: &str) -> crate::app::shelf::Shelf {
        if self.also.is_empty() {
            return Default::default();
        }
        let stem = |path: &PathBuf| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let names = std::iter::once(name.to_owned()).chain(self.also.iter().map(stem)).collect();
        let (source, also) = (self.source.clone(), self.also.clone());
        crate::app::shelf::Shelf::new(names, 0, move |number| match number.checked_sub(1).and_then(|number| also.get(number)) {
            Some(path) => source.of(path).load(),
            None => source.load(),
        })
    }

    fn steady(&self) -> Option<crate::app::steady::Steady> {
        use crate::{
            app::steady::{Soak, Steady},
            measure::soak::verdict::Bounds,
        };
        let soak = self.soak.map(|minutes| Soak { seconds: 60.0 * minutes, out: "effigy-soak".into(), bounds: Bounds::default() });
        (self.governor || soak.is_some()).then_some(Steady { rate: self.fps, governed: self.governor, soak })
    }
}

#[cfg(feature = "window")]
fn show(display: crate::app::Display, args: Args) -> anyhow::Result<()> {
    let steady = args.steady();
    anyhow::ensure!(args.fps.is_none() || steady.is_some(), "--fps is a rate to hold: give --governor or --soak with it");
    let (avatar, clips) = args.source.load()?;
    let shelf = args.shelf(&avatar.name);
    let options = crate::app::Options {
        gpu: args.quality.gpu(),
        drawing: RendererOptions { count: args.soak.is_some(), ..args.quality.renderer(args.size) },
        full_screen: args.fullscreen,
        background: args.background,
        frames: args.frames,
        rehearse: args.rehearse,
        shelf,
        first: None,
        folders: crate::app::screenshot::folders(),
        said: None,
        report: None,
        steady,
        trace: args.trace,
    };
    display.show(avatar, clips, options)
}

#[cfg(not(feature = "window"))]
pub fn run(_: Args) -> anyhow::Result<()> {
    anyhow::bail!("this program was built without its window; build it with `--features window`, or use `effigy render`")
}

/// The demo in a window, or pictures of it where there is no display.
pub fn run_default() -> anyhow::Result<()> {
    let Defaults { args } = Defaults::parse_from(["effigy"]);
    #[cfg(feature = "window")]
    match crate::app::Display::open() {
        Ok(display) => return show(display, args),
        Err(error) => println!("{error}: rendering a turn of the demo avatar to pictures instead"),
    }
    render::turntable(&args.source, Path::new("effigy-turntable"))
}
