//! Tests that run the program as its users do.

#[macro_use]
#[path = "../common/mod.rs"]
mod common;
mod commands;
mod motion;
mod opened;
mod outputs;
mod pack;
mod shots;
mod soak;
mod splats;
mod trace;
mod train;
#[cfg(all(feature = "window", target_os = "linux"))]
mod window;

use crate::common::harness::{self, Group};
use std::process::ExitCode;

fn main() -> ExitCode {
    harness::main(
        "system",
        Group::Device,
        modules![
            commands,
            motion,
            opened,
            outputs,
            pack,
            shots,
            soak,
            splats,
            trace,
            train,
            #[cfg(all(feature = "window", target_os = "linux"))]
            window,
        ],
    )
}
