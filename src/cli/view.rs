//! `effigy view`, and what `effigy` does without a subcommand.

use crate::{
    advice::Advised,
    backdrop::{self, BackdropArg},
    options::{self, QualityArgs},
    output::{self, Output},
    render,
    source::Source,
};
#[cfg(feature = "window")]
use crate::{backdrop::Backdrop, soak};
use clap::Parser;
#[cfg(feature = "window")]
use effigy_app::{
    file_list::{self, FileList, LoadedAvatar},
    scene::{BACKGROUND, BehindImage},
};
#[cfg(feature = "window")]
use effigy_core::scene::FrameImage;
#[cfg(feature = "window")]
use effigy_render::vulkan::RendererOptions;
use std::path::{Path, PathBuf};
#[cfg(feature = "window")]
use std::sync::{Arc, Mutex, PoisonError};

#[derive(clap::Args, Debug)]
#[cfg_attr(feature = "window", command(after_help = effigy_app::action::help()))]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Another avatar, for the panel's list and the key A; repeat for several
    #[arg(long, value_name = "FILE")]
    also: Vec<PathBuf>,
    /// Width and height of the window, pixels
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "1280x800")]
    size: [u32; 2],
    /// Fill the screen
    #[arg(long)]
    fullscreen: bool,
    /// Colour behind the avatar, or a picture, PNG or JPEG, that covers the window
    #[arg(long, value_name = "RRGGBB|FILE", default_value = options::BACKGROUND, value_parser = backdrop::argument)]
    background: BackdropArg,
    /// Draw without pause, quit after this many frames, 1 or more, and print how long they took
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    frames: Option<u32>,
    #[cfg(feature = "window")]
    #[arg(long, value_name = "surface@N, device@N or memory@N", value_parser = rehearsal, hide = true)]
    rehearse: Vec<effigy_app::Rehearsal>,
    /// Give up quality as needed to hold the display's rate, or that of --fps
    #[arg(long)]
    governor: bool,
    /// Rate to hold, frames per second, 0.5 to 1000 [default: the display's]
    #[arg(long, value_name = "N", value_parser = options::rate)]
    fps: Option<f64>,
    /// Soak in the window for this many minutes, 0.01 to 10000, write effigy-soak.json, .csv, .svg
    /// and .png, and quit
    #[arg(long, value_name = "MINUTES", value_parser = options::minutes)]
    soak: Option<f64>,
    /// Also write a timeline of host and device, a .json for ui.perfetto.dev
    #[arg(long, value_name = "FILE", value_parser = output::TRACE.parser())]
    trace: Option<Output>,
    #[command(flatten, next_help_heading = "Quality")]
    quality: QualityArgs,
}

/// Reads `surface@N` or `device@N`, a loss before frame N, or `memory@N`, too little memory for the
/// Nth device that is opened.
#[cfg(feature = "window")]
fn rehearsal(text: &str) -> Result<effigy_app::Rehearsal, String> {
    use effigy_app::{DriverLoss, Rehearsal};
    let parse = || {
        let (name, number) = text.split_once('@')?;
        let loss = match name {
            "surface" => DriverLoss::Surface,
            "device" => DriverLoss::Device,
            "memory" => DriverLoss::Memory,
            _ => return None,
        };
        let number = number.parse().ok()?;
        Some(Rehearsal { loss, number })
    };
    parse().ok_or_else(|| format!("`{text}` is none of surface@N, device@N and memory@N"))
}

/// [`Args`] as a command of its own, for their defaults.
#[derive(Parser)]
struct Defaults {
    #[command(flatten)]
    args: Args,
}

#[cfg(feature = "window")]
pub fn run(args: Args) -> anyhow::Result<()> {
    match effigy_app::Display::open() {
        Ok(display) => show(display, args),
        Err(error) => {
            Err(Advised::new(error.to_string(), "`effigy render` draws without a display").into())
        }
    }
}

#[cfg(feature = "window")]
impl Args {
    /// The avatar called `name`, which is shown first, and those of `--also`.
    fn file_list(&self, name: &str) -> FileList {
        let also = self.also.iter().map(|path| file_list::stem(path));
        let names = std::iter::once(name.to_owned()).chain(also).collect();
        let source = self.source.clone();
        let also = self.also.clone();
        FileList::new(names, 0, move |number| {
            let (avatar, clips) = match number.checked_sub(1).and_then(|number| also.get(number)) {
                Some(path) => source.for_avatar(path).load(),
                None => source.load(),
            }?;
            Ok(LoadedAvatar { avatar, clips })
        })
    }

    fn quality_control(&self) -> Option<effigy_app::quality_control::QualityControl> {
        use effigy_app::quality_control::{QualityControl, SoakOptions};
        use effigy_measure::soak::faults::SoakLimits;
        let soak = self.soak.map(|minutes| SoakOptions {
            seconds: 60.0 * minutes,
            out: Some(SOAK.into()),
            bounds: SoakLimits::default(),
        });
        (self.governor || soak.is_some()).then_some(QualityControl {
            rate: self.fps,
            governed: self.governor,
            soak,
        })
    }
}

/// Begins the names of a soak's files.
#[cfg(feature = "window")]
const SOAK: &str = "effigy-soak";

#[cfg(feature = "window")]
fn show(display: effigy_app::Display, args: Args) -> anyhow::Result<()> {
    let quality_control = args.quality_control();
    anyhow::ensure!(
        args.fps.is_none() || quality_control.is_some(),
        "--fps is a rate to hold: give --governor or --soak with it"
    );
    if args.soak.is_some() {
        soak::check_files(Path::new(SOAK))?;
    }
    let background = Background::open(&args.background)?;
    let (avatar, clips) = args.source.load()?;
    let file_list = args.file_list(&avatar.name);
    let renderer = RendererOptions {
        count: args.soak.is_some(),
        ..args.quality.renderer(args.size)
    };
    let options = effigy_app::ViewerOptions {
        gpu: args.quality.gpu(),
        full_screen: args.fullscreen,
        background: background.color,
        picture: background.picture,
        frames: args.frames,
        rehearse: args.rehearse,
        file_list,
        opener: Some(Arc::new(args.source)),
        quality_control,
        trace: args.trace.as_deref().map(Path::to_path_buf),
        ..effigy_app::ViewerOptions::new(renderer)
    };
    display.show(avatar, clips, options)
}

/// What is behind the avatar.
#[cfg(feature = "window")]
struct Background {
    /// Display-referred RGB, 0 to 1.
    color: [f32; 3],
    picture: Option<BehindImage>,
}

#[cfg(feature = "window")]
impl Background {
    /// Reads the picture, if it is one.
    fn open(argument: &BackdropArg) -> anyhow::Result<Self> {
        Ok(match Backdrop::open(argument)? {
            Backdrop::Transparent => {
                anyhow::bail!(
                    "a window has no transparency: give --background a colour or a picture"
                )
            }
            Backdrop::Color(color) => Self {
                color,
                picture: None,
            },
            picture => {
                let picture = Mutex::new(picture);
                let behind = move |image: &FrameImage| {
                    let picture = &mut picture.lock().unwrap_or_else(PoisonError::into_inner);
                    picture.behind(image)
                };
                Self {
                    color: BACKGROUND,
                    picture: Some(Arc::new(behind)),
                }
            }
        })
    }
}

#[cfg(not(feature = "window"))]
pub fn run(_: Args) -> anyhow::Result<()> {
    Err(Advised::new(
        "this program was built without its window",
        "build it with `--features window`, or use `effigy render`",
    )
    .into())
}

/// Shows the demo in a window, or renders images of it where there is no display.
pub fn run_default() -> anyhow::Result<()> {
    let Defaults { args } = Defaults::parse_from(["effigy"]);
    #[cfg(feature = "window")]
    match effigy_app::Display::open() {
        Ok(display) => return show(display, args),
        Err(error) => println!("{error}: rendering a turntable of the demo avatar instead"),
    }
    render::turntable(&args.source, Path::new("effigy-turntable"))
}
