//! The benchmark: an avatar, a clip and a device go in; time, error, memory, counters and bytes come out.
//!
//! [`case`] names what is drawn, [`scene`] makes the scenes, [`run`] draws them against the clock, [`check`] compares them with the
//! reference, [`measured`] makes a case's report of it all. [`sweep`] turns the [`knob`]s that trade time for error one at a
//! time, [`pareto`] finds which settings nothing beats and [`plot`] draws them. [`report`] is the JSON, [`table`] the CSV; [`compare`] sets
//! two reports against each other.

pub mod backend;
pub mod case;
pub mod check;
pub mod compare;
pub mod knob;
mod label;
pub mod measured;
pub mod pareto;
pub mod plot;
pub mod report;
pub mod run;
pub mod scene;
pub mod sweep;
pub mod table;

pub use case::Case;
pub use knob::Knob;
pub use report::Report;
pub use run::{Devices, Setting};
pub use scene::Set;

use crate::{
    avatar::{Avatar, motion::Player},
    frame::{Camera, KeyBits},
};
use backend::Opened;
use report::{Options, Program, SCHEMA, Subject};
pub use run::Backend;

/// What to draw and how long, whatever the case.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    pub avatar: &'a Avatar,
    pub player: &'a Player,
    /// As in [`Set`].
    pub cameras: &'a [Camera],
    /// Frames to time, at least 1.
    pub frames: usize,
    /// Views around the avatar, at least 1.
    pub views: usize,
    /// How many of the frames to compare with the reference.
    pub checked: usize,
    /// Whether to compute FLIP of them too.
    pub flip: bool,
    /// Frames drawn before the clock starts.
    pub warm_up: usize,
}

impl<'a> Task<'a> {
    /// What a case's scenes are made of, drawn with a setting.
    pub fn set(&self, setting: &Setting) -> Set<'a> {
        let Self { avatar, player, cameras, frames, views, .. } = *self;
        Set { avatar, player, size: setting.options.size, cameras, frames, views, hold: setting.hold }
    }

    /// A report without any case yet. `command` is the command line.
    pub fn report(&self, gpu: &Opened, setting: &Setting, command: Vec<String>) -> Report {
        Report {
            schema: SCHEMA.to_owned(),
            program: program(command),
            device: gpu.describe(),
            avatar: subject(self.avatar, self.player),
            size: setting.options.size,
            options: options(setting),
            cases: Vec::new(),
            sweep: None,
        }
    }
}

/// This program. `command` is the command line.
pub(super) fn program(command: Vec<String>) -> Program {
    Program {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        commit: option_env!("EFFIGY_COMMIT").map(str::to_owned),
        date: humantime::format_rfc3339_seconds(std::time::SystemTime::now()).to_string(),
        command,
    }
}

pub(super) fn subject(avatar: &Avatar, player: &Player) -> Subject {
    Subject {
        name: avatar.name.clone(),
        clip: player.clip().name.clone(),
        gaussians: avatar.gaussians.len() as u64,
        parts: avatar.parts.len() as u64,
        nodes: avatar.nodes.len() as u64,
        rows: [&avatar.rotation_rows.gaussian, &avatar.scale_rows.gaussian, &avatar.color_rows.gaussian].map(|rows| rows.len() as u64),
    }
}

pub(super) fn options(setting: &Setting) -> Options {
    let options = &setting.options;
    Options {
        color: format!("{:?}", options.color.unwrap_or_default()).to_lowercase(),
        raster: options.method.map_or("", |method| method.name()).to_owned(),
        key_bits: key_bits(options.key_bits),
        skip: options.skip.to_string(),
        cutoff: options.cutoff,
        margin: options.margin,
        detail: options.detail.to_string(),
        storage: if setting.packed_words { "words" } else { "half" }.to_owned(),
        rows: setting.rows,
        hold: setting.hold,
    }
}

/// The number in a key width's name.
fn key_bits(bits: KeyBits) -> u32 {
    8 * bits.passes()
}
