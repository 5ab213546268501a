//! Tests that need no device: files, the reference, baking and fitting, the governor, and what the
//! viewer decides.

#[macro_use]
#[path = "../common/mod.rs"]
mod common;
mod architecture;
mod bake;
mod capture;
mod drift;
#[cfg(feature = "window")]
mod dropped;
mod facing;
mod files;
mod flicker;
mod fuzz;
mod gltf_motion;
mod governor;
mod kernels;
mod large;
mod layout;
mod levels;
mod memory;
mod mmlphuman;
mod motion;
mod onesweep;
mod perceptual;
mod ply;
mod projection;
mod prune;
mod reference;
mod reference_bodies;
mod rules;
mod score;
mod shaders;
mod smpl;
mod sources;
mod splats;
#[cfg(target_os = "linux")]
mod thermals;
#[cfg(feature = "window")]
mod viewer;
mod webavatar;
mod work;

use crate::common::harness::{self, Group};
use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: memory::Counting = memory::Counting;

fn main() -> ExitCode {
    harness::main(
        "host",
        Group::Host,
        modules![
            architecture,
            bake,
            capture,
            capture::hostile,
            capture::masks,
            capture::wrong,
            drift,
            #[cfg(feature = "window")]
            dropped,
            files,
            files::adversarial,
            files::kept,
            files::packed,
            files::rules,
            files::scans,
            facing,
            flicker,
            fuzz,
            gltf_motion,
            gltf_motion::hostile,
            governor,
            kernels,
            layout,
            large,
            mmlphuman,
            mmlphuman::hostile,
            levels,
            motion,
            motion::axes,
            motion::hostile,
            motion::limbs,
            onesweep,
            perceptual,
            ply,
            ply::cameras,
            ply::adversarial,
            ply::columns,
            projection,
            prune,
            reference,
            reference_bodies,
            rules,
            score,
            shaders,
            smpl,
            smpl::hostile,
            sources,
            splats,
            splats::bad_rows,
            splats::containers,
            splats::drafts,
            splats::hostile,
            splats::streamed,
            splats::written,
            #[cfg(target_os = "linux")]
            thermals,
            #[cfg(feature = "window")]
            viewer,
            webavatar,
            webavatar::hostile,
        ],
    )
}
