//! What a soak found, as its JSON has it: [`Report`] is the whole file.

use crate::measure::{
    bench::report::{Device, ErrorReport, Options, Program, Subject},
    governor::{Quality, Rung},
};
use serde::{Deserialize, Serialize};

/// Names the layout of [`Report`]; changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-soak-1";

/// Everything about one soak.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// [`SCHEMA`].
    pub schema: String,
    pub program: Program,
    pub device: Device,
    pub avatar: Subject,
    /// Width and height of the screen, px.
    pub size: [u32; 2],
    pub options: Options,
    /// The promised rate, frames a second: what it was at the end, where a window's display changed its own.
    pub rate: f64,
    /// Whether the governor was on, and heat simulated.
    pub governed: bool,
    pub simulated_heat: bool,
    /// How long it was to last, and lasted, seconds.
    pub planned_seconds: f64,
    pub lasted_seconds: f64,
    /// The governor's ladder, from the whole quality down.
    pub ladder: Vec<Step>,
    pub frames: u64,
    /// Frames a second over all of it.
    pub fps: f64,
    /// Frames that came late, and refreshes that showed nothing new for it.
    pub late: u64,
    pub dropped: u64,
    /// The same as a share of all refreshes, from when it had [settled](super::verdict::SETTLED) on.
    pub dropped_share: f64,
    /// Times that the governor changed the quality, and the lowest rung it was on.
    pub changes: usize,
    pub lowest_rung: usize,
    /// Null of a run too short to say.
    pub growth: Option<Growth>,
    /// Pictures that were looked at, and pixels in them that were no numbers.
    pub pictures: u64,
    pub broken_pixels: u64,
    /// The most Gaussians of one frame that were left out since their place or shape is no number, or beyond what f32 can tell. None where
    /// nobody counted.
    #[serde(default)]
    pub broken_gaussians: Option<u64>,
    /// Pictures without anything in them.
    pub empty_pictures: u64,
    /// Null where it was not asked for, or the run ended before, and in windows.
    pub drift: Option<Drift>,
    /// In windows: null where the run ended before, or the window or its avatar is not what it was at first.
    #[serde(default)]
    pub still: Option<Still>,
    /// What is wrong with the run, a sentence each; empty where it held what was promised.
    pub faults: Vec<String>,
    pub each: Vec<Second>,
}

/// A rung of the ladder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Step {
    pub name: String,
    pub scale: f64,
    pub hold: u32,
    pub cutoff: f64,
    /// Of detail; 0 in reports from before there were any.
    #[serde(default)]
    pub level: u32,
    pub refreshes: u32,
}

impl From<&Rung> for Step {
    fn from(rung: &Rung) -> Self {
        let Quality { scale, hold, cutoff, level, refreshes } = rung.quality;
        Self { name: rung.name.clone(), scale, hold, cutoff, level, refreshes }
    }
}

/// What was gained from some time on, but for the first minute after each step of the governor that was new
/// ([`growth`](super::memory::growth)).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    pub from_seconds: f64,
    /// How long the parts of the run were together that were looked at.
    #[serde(default)]
    pub judged_seconds: f64,
    /// In use of the device's memory.
    pub device_bytes: i64,
    /// Of the process's memory in the machine's; null where the system does not tell.
    pub resident_bytes: Option<i64>,
}

/// The same frame against the reference before and after.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drift {
    pub before: ErrorReport,
    pub after: ErrorReport,
    /// Whether the two pictures are the same to the bit.
    pub same: bool,
}

/// The same frame before and after, against each other: in a window, where nobody waits for the reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Still {
    /// Width and height, px.
    pub size: [u32; 2],
    /// Whether the two pictures are the same to the bit.
    pub same: bool,
    /// How far the one after is from the one before.
    pub error: ErrorReport,
}

/// One second of it; a frame that takes longer makes it longer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Second {
    /// When it ended, from the start.
    pub seconds: f64,
    pub frames: u32,
    pub fps: f64,
    /// Time from one frame to the next, ms.
    pub frame_ms_p50: f64,
    pub frame_ms_p95: f64,
    pub frame_ms_p99: f64,
    /// Mean time that the device was busy with a frame, ms.
    pub busy_ms: Option<f64>,
    /// Frames that came late, and refreshes that showed nothing new for it.
    pub late: u32,
    pub dropped: u32,
    /// As in [`Reading`](crate::measure::thermals::Reading).
    pub headroom: Option<f64>,
    pub celsius: Option<f64>,
    pub clock: Option<f64>,
    pub battery: Option<f64>,
    pub watts: Option<f64>,
    /// The governor's rung at its end; 0 is the whole quality.
    pub rung: usize,
    /// In use of the device's memory, and of the process's in the machine's.
    pub device_bytes: u64,
    pub resident_bytes: Option<u64>,
}
