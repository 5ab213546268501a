//! The report of a finished frame: times on device and host, and counts.

use super::{Counters, Stage, schedule::Equipment};
use std::time::Instant;

/// Names of the stages, in the order that a frame runs them.
pub const STAGES: [&str; 9] = {
    let mut names = [""; 9];
    let mut at = 0;
    while at < names.len() {
        names[at] = Stage::ALL[at].name();
        at += 1;
    }
    names
};

/// When the host did what for a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostTimes {
    /// The frame was requested.
    pub began: Instant,
    /// The frame in flight before it that used the same buffers was done.
    pub waited: Instant,
    /// Its commands were recorded.
    pub recorded: Instant,
    /// They were submitted.
    pub submitted: Instant,
    /// The host saw that the device was done.
    pub finished: Instant,
}

/// The report of a finished frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameReport {
    /// GPU time of each stage that ran, ms, in order. A stage that ran for two layers is there
    /// twice. Empty where the device has no timestamps.
    pub stages: Vec<(&'static str, f64)>,
    /// When each of them began and ended, in ticks of the device, whose low
    /// `vulkan::Probe::timestamp_bits` bits are valid. Empty where ticks of different frames can't
    /// be compared.
    pub ticks: Vec<[u64; 2]>,
    /// None for a frame that was not submitted, or whose backend does not record them.
    pub host: Option<HostTimes>,
    /// What was drawn, culled and skipped.
    pub counters: Counters,
    /// Stages that the frame did not need to run.
    pub skipped: Vec<&'static str>,
}

impl FrameReport {
    /// The report of a frame that changes nothing, and was not submitted.
    pub fn idle(equipment: &Equipment) -> Self {
        Self {
            skipped: equipment.stages().map(Stage::name).collect(),
            ..Self::default()
        }
    }

    /// Sum over the stages, ms.
    pub fn gpu_ms(&self) -> f64 {
        self.stages.iter().map(|(_, ms)| ms).sum()
    }
}

/// Time of a stage among [`FrameReport::stages`], of all layers, ms. None if it is not among them.
pub fn stage_ms(stages: &[(&'static str, f64)], name: &str) -> Option<f64> {
    stages
        .iter()
        .filter(|stage| stage.0 == name)
        .map(|stage| stage.1)
        .reduce(|sum, ms| sum + ms)
}
