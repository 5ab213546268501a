//! What a finished frame says about itself.

use super::Counters;

/// Stages in the order a frame runs them; their names in labels, timestamps, tables and the overlay.
pub const STAGES: [&str; 8] = ["features", "harmonics", "surface", "splats", "sort", "bins", "raster", "present"];

/// What a finished frame took and drew.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameReport {
    /// GPU time of each stage that ran, ms. Empty where the device has no timestamps.
    pub stages: Vec<(&'static str, f64)>,
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
