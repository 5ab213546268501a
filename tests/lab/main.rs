//! Tests of the laboratory's command line. What its commands do on a device is among the tests of
//! `system` and `gpu`.

#[macro_use]
#[path = "../common/mod.rs"]
mod common;
mod commands;
mod phone;

use crate::common::harness::{self, Group};
use std::process::ExitCode;

fn main() -> ExitCode {
    harness::main("lab", Group::Host, modules![commands, phone])
}
