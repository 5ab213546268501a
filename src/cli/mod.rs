//! The command line: one binary, `effigy`, a subcommand a file.

mod analyse;
mod bake;
mod bench;
mod bench_sort;
mod capture;
mod compare;
mod dataset;
mod devices;
mod evaluate;
mod export_ply;
mod fit;
mod inspect;
mod options;
mod pack;
mod render;
mod soak;
pub mod source;
mod stress;
mod through;
mod view;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Draws animatable human avatars made of Gaussians.
///
/// Without a subcommand it opens a window with the built-in demo avatar moving, or, where there is no display, renders a short
/// turntable of it to PNG files.
#[derive(Parser)]
#[command(version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    /// Say more about what happens: -v for steps, -vv for details. RUST_LOG overrides it
    #[arg(short, long, global = true, action = clap::ArgAction::Count)]
    verbose: u8,
}

#[derive(Subcommand)]
enum Command {
    /// Show an avatar moving in a window
    View(view::Args),
    /// Render pictures to PNG files
    Render(render::Args),
    /// Measure time, error and memory
    Bench(bench::Args),
    /// Set two measurements against each other
    Compare(compare::Args),
    /// Have RenderDoc capture a frame
    Capture(capture::Args),
    /// Draw for minutes on end at a promised rate, and watch rate, heat and memory
    Soak(soak::Args),
    /// Draw hard cases and hold them against the f64 reference
    Stress(stress::Args),
    /// Measure the sort alone: keys a second by count, key bits and variant
    BenchSort(bench_sort::Args),
    /// Say what an avatar or motion file holds
    Inspect(inspect::Args),
    /// List the GPUs: what each has, lacks and would use
    Devices(devices::Args),
    /// Write an avatar in one pose as a 3DGS .ply, for other viewers
    ExportPly(export_ply::Args),
    /// Make an avatar's file smaller, and say what each step saved and cost
    Pack(pack::Args),
    /// Make an avatar from the MakeHuman body, or a clip from motion capture
    Bake(bake::Args),
    /// Work out what every Gaussian of the baked body should look like in the frames of some clips
    Dataset(dataset::Args),
    /// Learn an avatar's correctives from a dataset
    Fit(fit::FitArgs),
    /// Keep the correctives that are worth most, and fine-tune them
    Prune(fit::PruneArgs),
    /// Draw a learned avatar and its dataset, and say how alike they are
    Evaluate(evaluate::Args),
    /// Make the paper's tables and curves of a dataset
    Analyse(analyse::Args),
}

/// Where nobody reads on, as in `effigy devices | head -3`, there is nothing to report: the program ends as others do.
fn end_quietly() {
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let said = panic.payload().downcast_ref::<String>().map_or("", String::as_str);
        if said.starts_with("failed printing to stdout: Broken pipe") {
            std::process::exit(141);
        }
        report(panic);
    }));
}

/// Runs the program and says how it ended.
pub fn main() -> ExitCode {
    end_quietly();
    let cli = Cli::parse();
    let level = ["warn", "info", "debug"][usize::from(cli.verbose).min(2)];
    let filter = tracing_subscriber::EnvFilter::try_from_default_env()
        .unwrap_or_else(|_| tracing_subscriber::EnvFilter::new(format!("effigy={level}")));
    tracing_subscriber::fmt().with_env_filter(filter).with_writer(std::io::stderr).without_time().with_target(false).init();
    let outcome = match cli.command {
        None => view::run_default(),
        Some(Command::View(args)) => view::run(args),
        Some(Command::Render(args)) => render::run(args),
        Some(Command::Bench(args)) => bench::run(args),
        Some(Command::Compare(args)) => compare::run(args),
        Some(Command::Capture(args)) => capture::run(args),
        Some(Command::Soak(args)) => soak::run(args),
        Some(Command::Stress(args)) => stress::run(args),
        Some(Command::BenchSort(args)) => bench_sort::run(args),
        Some(Command::Inspect(args)) => inspect::run(args),
        Some(Command::Devices(args)) => devices::run(args),
        Some(Command::ExportPly(args)) => export_ply::run(args),
        Some(Command::Pack(args)) => pack::run(args),
        Some(Command::Bake(args)) => bake::run(args),
        Some(Command::Dataset(args)) => dataset::run(args),
        Some(Command::Fit(args)) => fit::run(args),
        Some(Command::Prune(args)) => fit::run_prune(args),
        Some(Command::Evaluate(args)) => evaluate::run(args),
        Some(Command::Analyse(args)) => analyse::run(args),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
