//! The command line of Effigy: one binary, `effigy`, with one module per subcommand.
//!
//! ```text
//! lib ── a module per subcommand ──┬─ source: the avatar and clips that the user names
//!  │                               ├─ options: arguments that several subcommands share
//!  │                               ├─ backend: Vulkan or WebGPU
//!  │                               ├─ assets: the folder of source files and weights
//!  │                               └─ output, picture, progress: what is written and shown
//!  ├─ program: logging, and how an error is said
//!  ├─ groups: the subcommands as `effigy --help` lists them
//!  └─ advice: what a user can do about an error
//! ```

mod advice;
mod assets;
mod backdrop;
mod backend;
mod bake;
mod bench;
mod budget;
mod camera_path;
mod capture;
mod cast;
mod compare;
mod convert;
mod dataset;
mod devices;
mod distil;
#[cfg(feature = "window")]
mod dropped;
mod evaluate;
mod evaluate_video;
mod export;
mod export_ply;
#[doc(hidden)]
pub mod files;
mod gone;
mod groups;
mod import;
mod inspect;
#[doc(hidden)]
pub mod interrupt;
mod kept;
#[cfg(feature = "window")]
mod live;
#[doc(hidden)]
pub mod options;
#[doc(hidden)]
pub mod output;
mod pack;
#[doc(hidden)]
pub mod picture;
#[doc(hidden)]
pub mod program;
#[doc(hidden)]
pub mod progress;
mod prune;
mod render;
mod soak;
pub mod source;
#[cfg(test)]
mod spellings;
mod thumbnail;
mod train;
mod view;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::process::ExitCode;

/// Draws animatable human avatars made of Gaussians.
///
/// Without a subcommand it opens a window with the built-in demo avatar moving. Where there is no
/// display, it renders a short turntable of the demo to PNG files instead.
#[derive(Debug, Parser)]
#[command(name = "effigy", version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    global: program::GlobalArgs,
}

/// Every subcommand. [`groups`] says under which heading each is listed.
#[derive(Debug, Subcommand)]
enum Command {
    /// Show an avatar moving in a window
    View(view::Args),
    /// Render images
    Render(render::Args),
    /// Capture a frame with RenderDoc
    Capture(capture::Args),
    /// Measure time, error and memory
    Bench(bench::Args),
    /// Draw for minutes at a promised rate, and watch rate, heat and memory
    Soak(soak::Args),
    /// Compare two measurements: of `bench --json`, or of `soak`
    Compare(compare::Args),
    /// List the GPUs: what each has, what is missing and what Effigy would use
    Devices(devices::Args),
    /// Make an avatar from the MakeHuman body, or a clip from motion capture
    Bake(bake::Args),
    /// Shoot a capture of the MakeHuman body: pictures, masks, cameras and poses
    Dataset(dataset::Args),
    /// Learn an avatar from a capture: pictures, masks, cameras and poses
    Train(train::Args),
    /// Keep the most valuable correctives of an avatar
    Prune(prune::Args),
    /// Compare an avatar, or another program's pictures, with those of a capture
    Evaluate(evaluate::Args),
    /// Show what a file, or each file of a folder, contains
    Inspect(inspect::Args),
    /// Make an avatar or motion file from one of another program
    Import(import::Args),
    /// Write an avatar as the paper's model
    Export(export::Args),
    /// Make an avatar's file smaller, and show what each step saves and costs
    Pack(pack::Args),
    /// Write splats, or an avatar in one pose, as .ply, .spz, .splat or .glb
    Convert(convert::Args),
    /// Write an avatar in one pose as a 3DGS .ply, for other viewers
    ExportPly(export_ply::Args),
}

impl Command {
    fn run(self) -> anyhow::Result<()> {
        match self {
            Self::View(args) => view::run(args),
            Self::Render(args) => render::run(args),
            Self::Capture(args) => capture::run(args),
            Self::Bench(args) => bench::run(args),
            Self::Soak(args) => soak::run(args),
            Self::Compare(args) => compare::run(args),
            Self::Devices(args) => devices::run(args),
            Self::Bake(args) => bake::run(args),
            Self::Dataset(args) => dataset::run(args),
            Self::Train(args) => train::run(args),
            Self::Prune(args) => prune::run(args),
            Self::Evaluate(args) => evaluate::run(args),
            Self::Inspect(args) => inspect::run(args),
            Self::Import(args) => import::run(args),
            Self::Export(args) => export::run(args),
            Self::Pack(args) => pack::run(args),
            Self::Convert(args) => convert::run(args),
            Self::ExportPly(args) => export_ply::run(args),
        }
    }
}

/// The command line as clap has it, with the subcommands listed in groups.
fn command() -> clap::Command {
    let command = Cli::command();
    let template = groups::help_template(&command);
    command.help_template(template)
}

/// Runs the program.
pub fn main() -> ExitCode {
    program::run(command(), |matches| {
        let cli = Cli::from_arg_matches(matches).unwrap_or_else(|error| error.exit());
        match cli.command {
            Some(command) => command.run(),
            None => view::run_default(),
        }
    })
}
