//! What a benchmark found, as its JSON has it: [`Report`] is the whole file.
//!
//! JSON has no infinity: a PSNR that is null in an [`ErrorReport`] is one without any error.

use crate::frame::Detail;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Names the layout of [`Report`]; changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-bench-2";

/// Everything that one run of `effigy bench` measured, and on what.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// [`SCHEMA`].
    pub schema: String,
    pub program: Program,
    pub device: Device,
    pub avatar: Subject,
    /// Width and height of the picture, px.
    pub size: [u32; 2],
    pub options: Options,
    pub cases: Vec<CaseReport>,
    pub sweep: Option<SweepReport>,
}

/// What measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Program {
    pub version: String,
    /// The commit that the program was built from, with a `+` when its files differed. Null where the build could not know.
    pub commit: Option<String>,
    /// UTC, RFC 3339.
    pub date: String,
    /// The command line.
    pub command: Vec<String>,
}

/// What was measured on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Device {
    pub name: String,
    /// Name and version.
    pub driver: String,
    /// Vulkan version: 1.3.0. Empty behind WebGPU.
    pub vulkan: String,
    /// Whether shaders read f16 from storage buffers.
    pub half_storage: bool,
    pub subgroup_size: u32,
    /// Whether the device has timestamps; without them there are no GPU times.
    pub timestamps: bool,
    /// `vulkan` or `webgpu`. Empty in reports from before there was a choice.
    #[serde(default)]
    pub backend: String,
}

/// What was drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Subject {
    pub name: String,
    pub clip: String,
    pub gaussians: u64,
    pub parts: u64,
    pub nodes: u64,
    /// Basis rows kept: rotation, scale, colour.
    pub rows: [u64; 3],
}

/// How it was drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Options {
    pub color: String,
    /// How splats are drawn: `hulls` or `tiles`. Empty in reports from before there was a choice.
    #[serde(default)]
    pub raster: String,
    pub key_bits: u32,
    pub skip: String,
    /// Opacity under which nothing is drawn.
    pub cutoff: f64,
    /// Metres behind the depth surface from which on something is hidden.
    pub margin: f64,
    /// How many of an avatar's Gaussians are drawn: all in reports from before there was a choice.
    #[serde(default = "full")]
    pub detail: String,
    /// How f16 is read: `half` or, packed in 32-bit words, `words`.
    pub storage: String,
    /// Share of the basis rows kept, 0 to 1.
    pub rows: f64,
    /// Frames that a pose is held.
    pub hold: usize,
}

fn full() -> String {
    Detail::FULL.to_string()
}

/// What some samples, at least one, are like; times are in ms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    pub mean: f64,
    pub median: f64,
    pub p5: f64,
    pub p95: f64,
    pub p99: f64,
}

impl Spread {
    /// None of no samples.
    pub fn of(mut samples: Vec<f64>) -> Option<Self> {
        samples.sort_by(f64::total_cmp);
        let at = |share: f64| samples.get(((samples.len().max(1) - 1) as f64 * share).round() as usize).copied();
        let mean = samples.iter().sum::<f64>() / samples.len().max(1) as f64;
        Some(Self { mean, median: at(0.5)?, p5: at(0.05)?, p95: at(0.95)?, p99: at(0.99)? })
    }
}

/// One case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseReport {
    pub name: String,
    /// Frames timed.
    pub frames: usize,
    /// From one frame's hand-over to the next.
    pub frame_ms: Spread,
    /// Frames a second: 1000 over the mean frame time.
    pub fps: f64,
    /// GPU time of all stages together. Null without timestamps.
    pub gpu_ms: Option<Spread>,
    pub stages: Vec<StageReport>,
    /// Bytes of a mean frame, counted, and the fewest that would do. Null where nobody counted, as in a browser.
    pub bytes: Option<u64>,
    pub bytes_floor: Option<u64>,
    /// Mean of a frame, by the names in [`Counters`](crate::frame::Counters); those that nobody counted are left out.
    pub counters: BTreeMap<String, f64>,
    /// Pixels with an alpha of at least 1/255, in the mean of the checked frames.
    pub covered_pixels: Option<f64>,
    /// Fragments shaded for each of them.
    pub fragments_a_pixel: Option<f64>,
    /// Blocks that the program took from the driver. Null where nobody tells.
    pub gpu_memory_bytes: Option<u64>,
    /// What of them is in use.
    pub gpu_memory_used_bytes: Option<u64>,
    /// Against the f64 reference. Null when no frame was compared.
    pub error: Option<ErrorReport>,
}

/// One stage of a case. Bytes and operations are counted, not measured (see [`bytes`](crate::measure::bytes)), for a frame that the
/// stage runs in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StageReport {
    pub name: String,
    /// GPU time in the frames that it ran in. Null without timestamps, and where it never ran.
    pub ms: Option<Spread>,
    /// Share of the frames that it ran in, 0 to 1.
    pub ran: f64,
    pub bytes: Option<u64>,
    pub bytes_floor: Option<u64>,
    pub operations: Option<u64>,
    pub operations_floor: Option<u64>,
}

/// The worst of the frames that were compared.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorReport {
    /// Frames compared.
    pub frames: usize,
    /// Over covered pixels; null where there is no error at all.
    pub psnr_db: Option<f64>,
    pub max_error: f64,
    /// Share of the covered pixels with every channel within 4/255.
    pub within_tolerance: f64,
    /// Over whole pictures, empty background included.
    pub psnr_db_whole: Option<f64>,
    pub max_error_whole: f64,
    /// Mean FLIP over covered pixels, where asked for.
    pub flip: Option<f64>,
}

impl ErrorReport {
    /// Nothing was compared.
    pub const NONE: Self =
        Self { frames: 0, psnr_db: None, max_error: 0.0, within_tolerance: 1.0, psnr_db_whole: None, max_error_whole: 0.0, flip: None };
}

/// One case drawn with one setting after the other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweepReport {
    pub case: String,
    /// Frames of a round.
    pub frames: usize,
    /// Times that every setting had its turn.
    pub rounds: usize,
    /// The first is the setting that the others depart from.
    pub points: Vec<Point>,
    /// Settings that the device could not draw with, and why.
    pub failed: Vec<String>,
}

/// One setting's time and error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    pub knob: String,
    pub value: String,
    /// Mean over the frames of each frame's median over the rounds, ms, as measured.
    pub measured_ms: f64,
    /// The same over that of the first point, which had its turns between this one's: what a noisy machine leaves comparable.
    pub time_ratio: f64,
    /// The smallest and the largest that it was in any one round: how much to trust it.
    pub time_ratio_range: [f64; 2],
    /// `time_ratio` times the first point's median over all groups, ms: what is plotted and compared.
    pub frame_ms: f64,
    /// GPU time in the same way as `measured_ms`. Null without timestamps.
    pub gpu_ms: Option<f64>,
    pub counters: BTreeMap<String, f64>,
    pub error: ErrorReport,
    /// Whether no other point is both faster and nearer the reference.
    pub on_front: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_of_a_hundred_and_one_numbers_are_those_numbers() {
        let spread = Spread::of((0..=100).rev().map(f64::from).collect());
        assert_eq!(spread, Some(Spread { mean: 50.0, median: 50.0, p5: 5.0, p95: 95.0, p99: 99.0 }));
        assert_eq!(Spread::of(vec![7.0]).map(|spread| [spread.mean, spread.p5, spread.p99]), Some([7.0; 3]));
        assert_eq!(Spread::of(vec![]), None);
    }
}
