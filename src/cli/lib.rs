//! The command line of Effigy: one binary, `effigy`, with one module per subcommand.
//!
//! ```text
//! lib ── a module per subcommand ──┬─ source: the avatar and clips that the user names
//!  │                               ├─ options: arguments that several subcommands share
//!  │                               ├─ backend: Vulkan or WebGPU
//!  │                               ├─ assets: the folder of source files and weights
//!  │                               └─ output, picture, progress: what is written and shown
//!  ├─ groups: the subcommands as `effigy --help` lists them
//!  └─ advice: what a user can do about an error
//! ```

mod advice;
mod analyse;
mod assets;
mod backdrop;
mod backend;
mod bake;
mod bench;
mod bench_device;
mod bench_sort;
mod camera_path;
mod capture;
mod compare;
mod convert;
mod dataset;
mod devices;
mod distil;
#[cfg(feature = "window")]
mod dropped;
mod evaluate;
mod evaluate_capture;
mod evaluate_video;
mod export;
mod export_ply;
mod files;
mod fit;
mod gone;
mod groups;
mod import;
mod inspect;
mod interrupt;
mod kept;
#[cfg(feature = "window")]
mod live;
mod options;
mod output;
mod pack;
mod picture;
mod progress;
mod render;
mod soak;
pub mod source;
#[cfg(test)]
mod spellings;
mod stress;
mod thumbnail;
mod train;
mod verdict;
mod view;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::{io::IsTerminal, process::ExitCode};

/// Draws animatable human avatars made of Gaussians.
///
/// Without a subcommand it opens a window with the built-in demo avatar moving. Where there is no
/// display, it renders a short turntable of the demo to PNG files instead.
#[derive(Debug, Parser)]
#[command(name = "effigy", version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    /// Print more about what happens: -v for steps, -vv for details. RUST_LOG overrides it
    #[arg(short, long, global = true, action = clap::ArgAction::Count)]
    verbose: u8,
    /// Replace a file that the command reads, or the pictures of a capture, where OUT is one
    #[arg(long, global = true)]
    overwrite: bool,
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
    /// Measure the sort alone: keys per second by count, key bits and variant
    BenchSort(bench_sort::Args),
    /// Measure the GPU itself: bandwidth of copies, and fill rates
    BenchDevice(bench_device::Args),
    /// Draw for minutes at a promised rate, and watch rate, heat and memory
    Soak(soak::Args),
    /// Draw hard cases and compare them with the f64 reference
    Stress(stress::Args),
    /// Compare two measurements: of `bench --json`, or of `soak`
    Compare(compare::Args),
    /// Join what tools/gpu/run.sh measured on a GPU to one report
    Verdict(verdict::Args),
    /// List the GPUs: what each has, what is missing and what Effigy would use
    Devices(devices::Args),
    /// Make an avatar from the MakeHuman body, or a clip from motion capture
    Bake(bake::Args),
    /// Make a training dataset: the look of every Gaussian in the frames of some clips
    Dataset(dataset::Args),
    /// Learn an avatar from a capture: pictures, masks, cameras and poses
    Train(train::Args),
    /// Learn an avatar's correctives from a dataset
    Fit(fit::FitArgs),
    /// Keep the most valuable correctives of a learned avatar, and fine-tune them
    Prune(fit::PruneArgs),
    /// Compare images of a learned avatar with those of its dataset, or of a capture
    Evaluate(evaluate::Args),
    /// Make the paper's tables and curves from a dataset
    #[command(alias = "analyze")]
    Analyse(analyse::Args),
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
            Self::BenchSort(args) => bench_sort::run(args),
            Self::BenchDevice(args) => bench_device::run(args),
            Self::Soak(args) => soak::run(args),
            Self::Stress(args) => stress::run(args),
            Self::Compare(args) => compare::run(args),
            Self::Verdict(args) => verdict::run(args),
            Self::Devices(args) => devices::run(args),
            Self::Bake(args) => bake::run(args),
            Self::Dataset(args) => dataset::run(args),
            Self::Train(args) => train::run(args),
            Self::Fit(args) => fit::run(args),
            Self::Prune(args) => fit::run_prune(args),
            Self::Evaluate(args) => evaluate::run(args),
            Self::Analyse(args) => analyse::run(args),
            Self::Inspect(args) => inspect::run(args),
            Self::Import(args) => import::run(args),
            Self::Export(args) => export::run(args),
            Self::Pack(args) => pack::run(args),
            Self::Convert(args) => convert::run(args),
            Self::ExportPly(args) => export_ply::run(args),
        }
    }
}

/// Makes a closed pipe, as in `effigy devices | head -3`, end the program without a message, with
/// the exit code that a shell reports for SIGPIPE.
fn end_quietly_on_closed_pipe() {
    let default_hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let message = panic
            .payload()
            .downcast_ref::<String>()
            .map_or("", String::as_str);
        let is_printing = message.starts_with("failed printing to std");
        if is_printing && message.contains("Broken pipe") {
            std::process::exit(141);
        }
        default_hook(panic);
    }));
}

/// Logs to standard error: warnings, and more with each `-v`, unless RUST_LOG says otherwise.
fn start_logging(verbose: u8) {
    let level = match verbose {
        0 => "warn",
        1 => "info",
        _ => "debug",
    };
    let filter = tracing_subscriber::EnvFilter::try_from_default_env()
        .unwrap_or_else(|_| tracing_subscriber::EnvFilter::new(format!("effigy={level}")));
    tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_writer(std::io::stderr)
        .with_ansi(std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none())
        .without_time()
        .with_target(false)
        .init();
}

/// The command line as clap has it, with the subcommands listed in groups.
fn command() -> clap::Command {
    let command = Cli::command();
    let template = groups::help_template(&command);
    command.help_template(template)
}

/// Runs the program. An error is printed to standard error in one line, with advice in a second
/// line where there is any.
pub fn main() -> ExitCode {
    end_quietly_on_closed_pipe();
    if let Some(commit) = option_env!("EFFIGY_COMMIT") {
        effigy_measure::set_commit(commit);
    }
    let matches = command()
        .try_get_matches()
        .unwrap_or_else(|error| gone::explained(error).exit());
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    start_logging(cli.verbose);
    let result = output::check_arguments(&matches).and_then(|()| match cli.command {
        Some(command) => command.run(),
        None => view::run_default(),
    });
    let Err(error) = result else {
        return ExitCode::SUCCESS;
    };
    if let Some(code) = error
        .downcast_ref::<train::Ended>()
        .map(train::Ended::exit_code)
    {
        eprintln!("{error:#}");
        return ExitCode::from(code);
    }
    eprintln!("error: {error:#}");
    if let Some(advice) = advice::for_error(&error) {
        eprintln!("help: {advice}");
    }
    ExitCode::FAILURE
}
