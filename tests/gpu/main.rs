//! Tests of what runs on a Vulkan device: stages, frames, and the WebGPU backend outside of
//! browsers.

#[macro_use]
#[path = "../common/mod.rs"]
mod common;
mod clocks;
mod devices;
mod memory;
mod perceptual;
mod preflight;
mod present;
mod question;
mod rates;
#[macro_use]
mod small;
mod stages;
mod survey;
mod train;
#[cfg(feature = "webgpu")]
mod webgpu;

use crate::common::harness::{self, Group};
use std::process::ExitCode;

fn main() -> ExitCode {
    harness::main(
        "gpu",
        Group::Device,
        modules![
            stages::mlp,
            stages::nodes,
            stages::sh,
            stages::project,
            stages::sort::choice,
            stages::sort::faults,
            stages::sort::fused,
            stages::sort::matrix,
            stages::raster,
            stages::saturation,
            stages::frame,
            stages::detail,
            stages::crowd,
            stages::people,
            stages::resolve,
            stages::skip,
            stages::scene,
            stages::stress,
            train,
            perceptual,
            preflight,
            question,
            clocks,
            devices,
            memory,
            present,
            rates,
            survey,
            #[cfg(feature = "webgpu")]
            webgpu,
            #[cfg(feature = "webgpu")]
            webgpu::small,
            #[cfg(feature = "webgpu")]
            webgpu::people,
        ],
    )
}
