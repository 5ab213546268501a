//! The report of a soak. [`SoakReport`] is the whole JSON file; the fields are its keys.

use crate::report::{DeviceReport, ErrorReport, OptionsReport, Program, Subject};
use effigy_runtime::governor::{FrameQuality, Rung};
use serde::{Deserialize, Serialize};

/// Version of the JSON. It changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-soak-1";

/// Everything about one soak.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SoakReport {
    /// [`SCHEMA`].
    pub schema: String,
    /// The program that measured.
    pub program: Program,
    /// The device that was measured.
    pub device: DeviceReport,
    /// The avatar that was drawn.
    pub avatar: Subject,
    /// Width and height of the frame, px.
    pub size: [u32; 2],
    /// The options at full quality.
    pub options: OptionsReport,
    /// The promised rate, frames a second. In a window whose display changed its rate, the last
    /// one.
    pub rate: f64,
    /// Whether the governor was on.
    pub governed: bool,
    /// Whether heat was simulated.
    pub simulated_heat: bool,
    /// How long the run was to last, seconds.
    pub planned_seconds: f64,
    /// How long it lasted, seconds.
    pub lasted_seconds: f64,
    /// The governor's ladder, from full quality down.
    pub ladder: Vec<LadderStep>,
    /// Frames drawn.
    pub frames: u64,
    /// Frames a second over the whole run.
    pub fps: f64,
    /// Frames that were late.
    pub late: u64,
    /// Refreshes without a new frame.
    pub dropped: u64,
    /// `dropped` as a share of all refreshes, without the [first
    /// seconds](super::faults::SETTLING_SECONDS).
    pub dropped_share: f64,
    /// Times that the governor changed the quality.
    pub changes: usize,
    /// The lowest rung that the governor was on.
    pub lowest_rung: usize,
    /// Null if the run was too short.
    pub growth: Option<Growth>,
    /// Images that were checked.
    #[serde(alias = "pictures")]
    pub images: u64,
    /// Pixels in them that are NaN or infinite.
    pub broken_pixels: u64,
    /// Most Gaussians of one frame that were skipped because their place or shape is NaN or out of
    /// range of f32. Null if they were not counted.
    #[serde(default)]
    pub broken_gaussians: Option<u64>,
    /// Checked images in which nothing is covered.
    #[serde(alias = "empty_pictures")]
    pub empty_images: u64,
    /// One frame against the reference, before and after. Null if that was not asked for or the
    /// run was interrupted, and in windows.
    pub drift: Option<Drift>,
    /// The frame of the start against the same at the end. Only in windows; null if the run was
    /// interrupted, or the window's size or avatar changed.
    #[serde(default, rename = "still")]
    pub redrawn: Option<RedrawnFrame>,
    /// A sentence for each fault; empty if the run kept its limits.
    pub faults: Vec<String>,
    /// Every second of the run.
    pub each: Vec<Second>,
}

/// A rung of the ladder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LadderStep {
    /// Name of the rung, after what it gives up.
    pub name: String,
    /// This and the next five: see [`FrameQuality`].
    pub scale: f64,
    /// Frames that each pose is held for.
    pub hold: u32,
    /// Factor of the opacity cutoff.
    pub cutoff: f64,
    /// By how many levels small avatars are drawn coarser; 0 in reports from before there was that.
    #[serde(default)]
    pub coarser: usize,
    /// Level of detail; 0 in reports from before there were any.
    #[serde(default)]
    pub level: u32,
    /// Refreshes that each frame is shown for.
    pub refreshes: u32,
}

impl From<&Rung> for LadderStep {
    fn from(rung: &Rung) -> Self {
        let FrameQuality {
            scale,
            hold,
            cutoff,
            coarser,
            level,
            refreshes,
        } = rung.quality;
        Self {
            name: rung.name.clone(),
            scale,
            hold,
            cutoff,
            coarser,
            level,
            refreshes,
        }
    }
}

/// The memory gained over the steady intervals of a run ([`growth`](super::memory::growth)).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    /// When the first interval began, seconds.
    pub from_seconds: f64,
    /// Total length of the intervals, seconds.
    #[serde(default)]
    pub judged_seconds: f64,
    /// Gain of the device memory in use.
    pub device_bytes: i64,
    /// Gain of the process's resident memory; null if the system does not tell.
    pub resident_bytes: Option<i64>,
}

/// One frame against the reference, before and after the run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drift {
    /// At the start.
    pub before: ErrorReport,
    /// At the end.
    pub after: ErrorReport,
    /// Whether the two images are equal to the bit.
    pub same: bool,
}

/// One frame before and after the run, against each other. Used in windows, where computing the
/// reference would take too long.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RedrawnFrame {
    /// Width and height, px.
    pub size: [u32; 2],
    /// Whether the two images are equal to the bit.
    pub same: bool,
    /// Error of the image after against the one before.
    pub error: ErrorReport,
}

/// One second of a run; longer if a frame takes longer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Second {
    /// When it ended, seconds from the start.
    pub seconds: f64,
    /// Frames drawn in it.
    pub frames: u32,
    /// Frames a second.
    pub fps: f64,
    /// Time from one frame to the next, ms.
    pub frame_ms_p50: f64,
    /// 95th percentile.
    pub frame_ms_p95: f64,
    /// 99th percentile.
    pub frame_ms_p99: f64,
    /// Mean GPU time of a frame, ms.
    pub busy_ms: Option<f64>,
    /// Frames that were late.
    pub late: u32,
    /// Refreshes without a new frame.
    pub dropped: u32,
    /// This and the next four: see [`Reading`](effigy_runtime::thermals::Reading).
    pub headroom: Option<f64>,
    /// Temperature of the warmest sensor, °C.
    pub celsius: Option<f64>,
    /// Share of the highest clock.
    pub clock: Option<f64>,
    /// Charge of the battery, 0 to 1.
    pub battery: Option<f64>,
    /// Power drawn from the battery.
    pub watts: Option<f64>,
    /// The governor's rung at its end; 0 is full quality.
    pub rung: usize,
    /// Device memory in use.
    pub device_bytes: u64,
    /// Resident memory of the process.
    pub resident_bytes: Option<u64>,
}
