//! What a finished frame says about itself: times on device and host, and counts.

use super::Counters;
use std::time::Instant;

/// Stages in the order a frame runs them; their names in labels, timestamps, tables and the overlay.
pub const STAGES: [&str; 8] = ["features", "harmonics", "surface", "splats", "sort", "bins", "raster", "present"];

/// What the host did for a frame, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostTimes {
    /// It was asked for.
    pub began: Instant,
    /// An older frame has made room for it.
    pub waited: Instant,
    /// Its commands are written.
    pub recorded: Instant,
    /// The device has them.
    pub submitted: Instant,
    /// The host knows that it is done.
    pub finished: Instant,
}

/// What a finished frame took and drew.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameReport {
    /// GPU time of each stage that ran, ms. Empty where the device has no timestamps.
    pub stages: Vec<(&'static str, f64)>,
    /// When each of them began and ended, in the device's ticks, of which `vulkan::Probe::timestamp_bits` count. Empty where ticks of
    /// different frames can't be compared.
    pub ticks: Vec<[u64; 2]>,
    /// None of a frame that was not submitted, or whose backend keeps none.
    pub host: Option<HostTimes>,
    /// What went in, what was left out and what was drawn.
    pub counters: Counters,
    /// Stages that the frame did not need.
    pub skipped: Vec<&'static str>,
}

impl FrameReport {
    /// Of a frame that needed nothing, and was not submitted.
    pub fn idle(harmonics: bool) -> Self {
        let stages =
            STAGES.into_iter().filter(|&stage| !["present", "surface", "bins"].contains(&stage) && (harmonics || stage != "harmonics"));
        Self { skipped: stages.collect(), ..Self::default() }
    }

    /// Sum over the stages, ms.
    pub fn gpu_ms(&self) -> f64 {
        self.stages.iter().map(|(_, ms)| ms).sum()
    }
}
