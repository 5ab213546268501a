//! The report of a benchmark. [`BenchReport`] is the whole JSON file; the fields are its keys.

pub use crate::{
    flicker::FlickerReport,
    report::{DeviceReport, ErrorReport, OptionsReport, Program, Subject},
};
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeMap;

/// Version of the JSON. It changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-bench-2";

/// All measurements of a run, with what was measured and where.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BenchReport {
    /// [`SCHEMA`].
    pub schema: String,
    /// The program that measured.
    pub program: Program,
    /// The device that was measured.
    pub device: DeviceReport,
    /// The avatar that was drawn.
    pub avatar: Subject,
    /// Width and height of the image, px.
    pub size: [u32; 2],
    /// The options that it was drawn with.
    pub options: OptionsReport,
    /// Each case that was measured.
    pub cases: Vec<CaseReport>,
    /// The error over many poses and views. Null if it was not measured.
    #[serde(default)]
    pub spread: Option<SpreadReport>,
    /// The sweep, if there was one.
    pub sweep: Option<SweepReport>,
}

/// Mean and percentiles of times, ms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TimingSummary {
    /// Mean.
    pub mean: f64,
    /// Median.
    pub median: f64,
    /// 5th percentile.
    pub p5: f64,
    /// 95th percentile.
    pub p95: f64,
    /// 99th percentile.
    pub p99: f64,
}

impl TimingSummary {
    /// The summary of some times, ms. None of no times.
    pub fn from_samples(mut samples: Vec<f64>) -> Option<Self> {
        samples.sort_by(f64::total_cmp);
        let last = samples.len().checked_sub(1)?;
        let percentile = |share: f64| samples[(last as f64 * share).round() as usize];
        Some(Self {
            mean: samples.iter().sum::<f64>() / samples.len() as f64,
            median: percentile(0.5),
            p5: percentile(0.05),
            p95: percentile(0.95),
            p99: percentile(0.99),
        })
    }
}

/// One case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseReport {
    /// Name of the case.
    pub name: String,
    /// Number of frames timed.
    pub frames: usize,
    /// Time from one frame's submission to the next.
    pub frame_ms: TimingSummary,
    /// Frames a second: 1000 over the mean frame time.
    pub fps: f64,
    /// GPU time of all stages together. Null without timestamps.
    pub gpu_ms: Option<TimingSummary>,
    /// Each stage that ran.
    pub stages: Vec<StageReport>,
    /// Bytes that a mean frame moves. Null if they were not counted, as in a browser.
    pub bytes: Option<u64>,
    /// The fewest bytes that would do.
    pub bytes_floor: Option<u64>,
    /// Means over the frames, by the names of [`Counters`](effigy_core::frame::Counters). Unknown
    /// ones are missing.
    #[serde(deserialize_with = "counters")]
    pub counters: BTreeMap<String, f64>,
    /// Pixels with an alpha of at least 1/255, mean of the checked frames.
    pub covered_pixels: Option<f64>,
    /// Fragments shaded for each covered pixel.
    pub fragments_a_pixel: Option<f64>,
    /// Device memory that the program has allocated. Null if unknown.
    pub gpu_memory_bytes: Option<u64>,
    /// The part of it that is in use.
    pub gpu_memory_used_bytes: Option<u64>,
    /// Error against the f64 reference. Null if no frame was compared.
    pub error: Option<ErrorReport>,
    /// What changes from frame to frame that should not. Null in cases that don't measure it, and
    /// in reports from before 26 November 2026.
    #[serde(default)]
    pub flicker: Option<FlickerReport>,
}

/// One stage of a case. Bytes and operations are computed, not measured (see
/// [`bytes`](crate::bytes)), for a frame in which the stage runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StageReport {
    /// Name of the stage.
    #[serde(deserialize_with = "stage_name")]
    pub name: String,
    /// GPU time in the frames in which it ran. Null without timestamps, or if it never ran.
    pub ms: Option<TimingSummary>,
    /// Share of the frames in which it ran, 0 to 1.
    pub ran: f64,
    /// Bytes that it moves.
    pub bytes: Option<u64>,
    /// The fewest bytes that would do.
    pub bytes_floor: Option<u64>,
    /// Floating-point operations, if they are counted.
    pub operations: Option<u64>,
    /// The fewest operations that would do.
    pub operations_floor: Option<u64>,
}

/// The error over a spread of poses and views, against images of the same device with nothing
/// skipped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpreadReport {
    /// Views compared: those that the avatar is in.
    pub views: usize,
    /// Width and height of the images, px.
    pub size: [u32; 2],
    /// PSNR of the mean squared error over the views, dB; null if there is no error at all.
    pub mean_db: Option<f64>,
    /// PSNR of the median view, dB.
    pub median_db: Option<f64>,
    /// Largest error of a channel in any view, 0 to 1.
    pub max_error: f64,
    /// The view with the lowest PSNR.
    pub worst: ViewReport,
    /// The view with the most pixels whose error is plain to see.
    pub most_visible: ViewReport,
    /// The view with the least coverage inside the avatar's silhouette, with nothing skipped. Null
    /// in reports from before 25 November 2026.
    #[serde(default)]
    pub least_covered: Option<ViewReport>,
}

/// The error of one view, over covered pixels, and where it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ViewReport {
    /// Name of the clip.
    pub clip: String,
    /// Time in the clip, seconds.
    pub seconds: f64,
    /// Index of the view: of the sides of the avatar, or of the cameras given.
    pub view: usize,
    /// Where the camera is, metres, world.
    pub eye: [f64; 3],
    /// PSNR, dB; null if there is no error at all.
    pub psnr_db: Option<f64>,
    /// Largest error of a channel, 0 to 1.
    pub max_error: f64,
    /// Pixels with a channel off by more than [`VISIBLE`](crate::error::VISIBLE).
    pub visible: u64,
    /// Mean coverage inside the avatar's silhouette with nothing skipped, 0 to 1.
    #[serde(default)]
    pub coverage: f64,
    /// Pixels inside the silhouette whose coverage is under
    /// [`CLOSED`](crate::coverage::CLOSED).
    #[serde(default)]
    pub holes: u64,
}

/// One case drawn with many settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweepReport {
    /// Name of the case.
    pub case: String,
    /// Frames of a round.
    pub frames: usize,
    /// Times that every setting was measured.
    pub rounds: usize,
    /// The first is the base setting.
    pub points: Vec<SweepPoint>,
    /// Settings that the device can't draw with, and why.
    pub failed: Vec<String>,
}

/// One setting's time and error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweepPoint {
    /// Name of the parameter. Reports from before November 2026 call it `knob`.
    #[serde(alias = "knob")]
    pub parameter: String,
    /// Its value in words.
    pub value: String,
    /// Measured frame time, ms: the mean over the frames of each frame's median over the rounds.
    pub measured_ms: f64,
    /// `measured_ms` over that of the base setting, which was measured in turn with this one.
    /// Ratios are comparable even if other programs slow the machine down.
    pub time_ratio: f64,
    /// The smallest and the largest ratio of any round.
    pub time_ratio_range: [f64; 2],
    /// Frame time to plot and compare, ms: `time_ratio` times the base setting's median over all
    /// groups.
    pub frame_ms: f64,
    /// GPU time, ms, taken like `measured_ms`. Null without timestamps.
    pub gpu_ms: Option<f64>,
    /// Means over the frames, as in [`CaseReport::counters`].
    #[serde(deserialize_with = "counters")]
    pub counters: BTreeMap<String, f64>,
    /// Error against the f64 reference.
    pub error: ErrorReport,
    /// [`CaseReport::flicker`] of this point.
    #[serde(default)]
    pub flicker: Option<FlickerReport>,
    /// Whether no other point is both faster and closer to the reference.
    pub on_front: bool,
}

/// The name of a stage, also from reports from before November 2026.
fn stage_name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    let name = String::deserialize(deserializer)?;
    Ok(match name.as_str() {
        "features" => "mlp".into(),
        "harmonics" => "sh".into(),
        "splats" => "project".into(),
        "bins" => "binning".into(),
        _ => name,
    })
}

/// Counters, also from reports from before 25 November 2026.
fn counters<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<String, f64>, D::Error> {
    let read = BTreeMap::<String, f64>::deserialize(deserializer)?;
    let rename = |(name, mean): (String, f64)| {
        let name = match name.as_str() {
            "thinned" => "skipped_by_detail".into(),
            "kept" => "cached".into(),
            "area" => "damaged".into(),
            _ => name,
        };
        (name, mean)
    };
    Ok(read.into_iter().map(rename).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_of_0_to_100_are_those_numbers() {
        let spread = TimingSummary::from_samples((0..=100).rev().map(f64::from).collect());
        assert_eq!(
            spread,
            Some(TimingSummary {
                mean: 50.0,
                median: 50.0,
                p5: 5.0,
                p95: 95.0,
                p99: 99.0
            })
        );
        assert_eq!(
            TimingSummary::from_samples(vec![7.0]).map(|spread| [
                spread.mean,
                spread.p5,
                spread.p99
            ]),
            Some([7.0; 3])
        );
        assert_eq!(TimingSummary::from_samples(vec![]), None);
    }

    #[test]
    fn counters_of_old_reports_get_their_present_names() {
        let old = serde_json::json!({ "area": 3.0, "drawn": 4.0, "kept": 1.0, "thinned": 2.0 });
        let present = [
            ("cached", 1.0),
            ("damaged", 3.0),
            ("drawn", 4.0),
            ("skipped_by_detail", 2.0),
        ];
        assert_eq!(
            counters(old).unwrap(),
            present.map(|(name, mean)| (name.to_owned(), mean)).into()
        );
    }

    #[test]
    fn stages_of_old_reports_get_their_present_names() {
        let name = |text: &str| stage_name(serde_json::Value::from(text)).unwrap();
        assert_eq!(
            ["features", "splats", "bins", "raster"].map(name),
            ["mlp", "project", "binning", "raster"]
        );
    }
}
