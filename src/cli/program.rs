//! What a program of Effigy's does around its command: arguments, logging, and how an error is
//! said.

use crate::{advice, gone, output, train};
use clap::ArgMatches;
use std::{io::IsTerminal, process::ExitCode};

/// Options of every command.
#[derive(clap::Args, Clone, Debug)]
pub struct GlobalArgs {
    /// Print more about what happens: -v for steps, -vv for details. RUST_LOG overrides it
    #[arg(short, long, global = true, action = clap::ArgAction::Count)]
    verbose: u8,
    /// Replace a file that the command reads, or the pictures of a capture, where OUT is one
    #[arg(long, global = true)]
    overwrite: bool,
}

/// Runs a program whose options are [`GlobalArgs`] and its own. An error is printed to standard
/// error in one line, with advice in a second line where there is any.
pub fn run(
    command: clap::Command,
    act: impl FnOnce(&ArgMatches) -> anyhow::Result<()>,
) -> ExitCode {
    end_quietly_on_closed_pipe();
    if let Some(commit) = option_env!("EFFIGY_COMMIT") {
        effigy_measure::set_commit(commit);
    }
    let matches = command
        .try_get_matches()
        .unwrap_or_else(|error| gone::explained(error).exit());
    start_logging(matches.get_count("verbose"));
    let result = output::check_arguments(&matches).and_then(|()| act(&matches));
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
