//! Effigy's laboratory: the program `effigy-lab`, for those who develop Effigy or judge a device.
//!
//! - [`stress`] draws hard cases and compares them with the reference.
//! - [`sorts`] is the report of the sort alone, [`training`] that of training.
//! - [`verdict`] joins a run's measurements on one GPU to one report.
//! - `commands` has the subcommands.

mod commands;
pub mod sorts;
pub mod stress;
pub mod training;
pub mod verdict;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use commands::{bench_device, bench_sort, bench_train};
use effigy_cli::program::{self, GlobalArgs};
use std::process::ExitCode;

/// Tries Effigy and devices to their limits: for those who develop Effigy.
#[derive(Debug, Parser)]
#[command(name = "effigy-lab", version, propagate_version = true)]
struct Lab {
    #[command(subcommand)]
    command: LabCommand,
    #[command(flatten)]
    global: GlobalArgs,
}

#[derive(Debug, Subcommand)]
enum LabCommand {
    /// Draw hard cases and compare them with the f64 reference
    Stress(commands::stress::Args),
    /// Measure the sort alone: keys per second by count, key bits and variant
    BenchSort(bench_sort::Args),
    /// Measure the GPU itself: bandwidth of copies, and fill rates
    BenchDevice(bench_device::Args),
    /// Measure training: steps a second with the perceptual loss and without it
    BenchTrain(bench_train::Args),
    /// Print what the driver's compiler makes of every shader: instructions, registers and spills
    ShaderStats(commands::shader_stats::Args),
    /// Join what tools/gpu/run.sh measured on a GPU to one report
    Verdict(commands::verdict::Args),
}

/// Runs the program.
pub fn main() -> ExitCode {
    program::run(Lab::command(), |matches| {
        let lab = Lab::from_arg_matches(matches).unwrap_or_else(|error| error.exit());
        match lab.command {
            LabCommand::Stress(args) => commands::stress::run(args),
            LabCommand::BenchSort(args) => bench_sort::run(args),
            LabCommand::BenchDevice(args) => bench_device::run(args),
            LabCommand::BenchTrain(args) => bench_train::run(args),
            LabCommand::ShaderStats(args) => commands::shader_stats::run(args),
            LabCommand::Verdict(args) => commands::verdict::run(args),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clap_accepts_the_command_line() {
        Lab::command().debug_assert();
    }
}
