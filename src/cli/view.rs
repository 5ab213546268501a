//! `effigy view`, and what `effigy` does without a subcommand.

use super::{
    options::{self, Quality},
    render,
    source::Source,
};
use clap::Parser;
use std::path::Path;

#[derive(clap::Args)]
#[cfg_attr(feature = "window", command(after_help = crate::app::action::help()))]
pub struct Args {
    #[command(flatten)]
    source: Source,
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
    #[arg(long, value_name = "surface@N or device@N", value_parser = loss, hide = true)]
    rehearse: Vec<(crate::app::Loss, u32)>,
    #[command(flatten)]
    quality: Quality,
}

/// Reads `surface@N` or `device@N`: a loss before frame N.
#[cfg(feature = "window")]
fn loss(text: &str) -> Result<(crate::app::Loss, u32), String> {
    use crate::app::Loss;
    let parsed = text.split_once('@').and_then(|(what, frame)| {
        let what = [("surface", Loss::Surface), ("device", Loss::Device)].into_iter().find(|known| known.0 == what)?.1;
        Some((what, frame.parse().ok()?))
    });
    parsed.ok_or_else(|| format!("`{text}` is neither surface@N nor device@N"))
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
fn show(display: crate::app::Display, args: Args) -> anyhow::Result<()> {
    let (avatar, clips) = args.source.load()?;
    let options = crate::app::Options {
        gpu: args.quality.gpu(),
        drawing: args.quality.renderer(args.size),
        full_screen: args.fullscreen,
        background: args.background,
        frames: args.frames,
        rehearse: args.rehearse,
        shelf: Default::default(),
        folders: crate::app::screenshot::folders(),
        said: None,
        report: None,
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
