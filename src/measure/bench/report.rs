//! The report of a benchmark. [`BenchReport`] is the whole JSON file; the fields are its keys. Its
//! CSV and its comparison with another report are of the same rows.

use super::case::BenchTask;
pub use crate::{
    flicker::FlickerReport,
    report::{DeviceReport, ErrorReport, OptionsReport, Program, Subject},
};
use crate::{
    report::{ReadError, Setup, present_skip_names, read_report},
    setting::RenderSetting,
    table::{Comparison, TableRow},
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

impl BenchReport {
    /// A report without cases. `command` is the command line.
    pub fn new(
        device: DeviceReport,
        task: &BenchTask,
        setting: &RenderSetting,
        command: Vec<String>,
    ) -> Self {
        Self {
            schema: SCHEMA.to_owned(),
            program: Program::current(command),
            device,
            avatar: Subject::new(task.avatar, &task.clips[0]),
            size: setting.options.size,
            options: OptionsReport::new(setting),
            cases: Vec::new(),
            spread: None,
            sweep: None,
        }
    }

    /// Reads a report's JSON.
    ///
    /// # Errors
    /// When the text is something else.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        let mut report: Self = read_report(text, SCHEMA)?;
        let points = report.sweep.iter_mut().flat_map(|sweep| &mut sweep.points);
        for point in points.filter(|point| point.parameter == "skip-but") {
            point.value = present_skip_names(&point.value);
        }
        Ok(report)
    }

    fn setup(&self) -> Setup<'_> {
        Setup {
            device: &self.device,
            avatar: &self.avatar,
            size: self.size,
            options: &self.options,
        }
    }

    /// A row for each case, then for each of the sweep's points.
    pub fn rows(&self) -> Vec<TableRow> {
        let mut rows: Vec<_> = self.cases.iter().map(CaseReport::row).collect();
        if let Some(sweep) = &self.sweep {
            rows.extend(sweep.points.iter().map(|point| point.row(&sweep.case)));
        }
        rows
    }

    /// Every number of this report and of another.
    pub fn compared_with(&self, other: &Self) -> Comparison {
        let warnings = self.setup().differences(&other.setup());
        Comparison::new(warnings, &self.rows(), &other.rows())
    }
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

impl CaseReport {
    fn row(&self) -> TableRow {
        let count = |count: Option<u64>| count.map(|count| count as f64);
        let mut row = TableRow::new(&self.name, "", "");
        row.add("frames", self.frames as f64);
        row.add("frame_ms_mean", self.frame_ms.mean);
        row.add("frame_ms_median", self.frame_ms.median);
        row.add("frame_ms_p5", self.frame_ms.p5);
        row.add("frame_ms_p95", self.frame_ms.p95);
        row.add("frame_ms_p99", self.frame_ms.p99);
        row.add("fps", self.fps);
        row.add_known("gpu_ms_median", self.gpu_ms.map(|ms| ms.median));
        row.add_known("gpu_ms_p95", self.gpu_ms.map(|ms| ms.p95));
        for stage in &self.stages {
            let name = |suffix: &str| format!("{}_{suffix}", stage.name);
            row.add(name("ran"), stage.ran);
            row.add_known(name("ms_median"), stage.ms.map(|ms| ms.median));
            row.add_known(name("bytes"), count(stage.bytes));
            row.add_known(name("bytes_floor"), count(stage.bytes_floor));
            row.add_known(name("operations"), count(stage.operations));
            row.add_known(name("operations_floor"), count(stage.operations_floor));
        }
        row.add_known("bytes", count(self.bytes));
        row.add_known("bytes_floor", count(self.bytes_floor));
        for (name, &value) in &self.counters {
            row.add(name, value);
        }
        row.add_known("covered_pixels", self.covered_pixels);
        row.add_known("fragments_a_pixel", self.fragments_a_pixel);
        row.add_known("gpu_memory_bytes", count(self.gpu_memory_bytes));
        row.add_known("gpu_memory_used_bytes", count(self.gpu_memory_used_bytes));
        add_errors(&mut row, self.error.as_ref(), self.flicker.as_ref());
        row
    }
}

impl SweepPoint {
    fn row(&self, case: &str) -> TableRow {
        let mut row = TableRow::new(case, &self.parameter, &self.value);
        row.add("frame_ms_measured", self.measured_ms);
        row.add("time_ratio", self.time_ratio);
        row.add("time_ratio_low", self.time_ratio_range[0]);
        row.add("time_ratio_high", self.time_ratio_range[1]);
        row.add("frame_ms", self.frame_ms);
        row.add_known("gpu_ms_mean", self.gpu_ms);
        for (name, &value) in &self.counters {
            row.add(name, value);
        }
        add_errors(&mut row, Some(&self.error), self.flicker.as_ref());
        row.add("on_front", f64::from(u8::from(self.on_front)));
        row
    }
}

fn add_errors(row: &mut TableRow, error: Option<&ErrorReport>, flicker: Option<&FlickerReport>) {
    if let Some(error) = error.filter(|error| error.frames > 0) {
        row.add("checked_frames", error.frames as f64);
        row.add("psnr_db", error.psnr_db.unwrap_or(f64::INFINITY));
        row.add("max_error", error.max_error);
        row.add("within_tolerance", error.within_tolerance);
        let psnr_db_whole = error.psnr_db_whole.unwrap_or(f64::INFINITY);
        row.add("psnr_db_whole", psnr_db_whole);
        row.add("max_error_whole", error.max_error_whole);
        row.add_known("flip", error.flip);
    }
    for step in flicker.iter().flat_map(|flicker| &flicker.steps) {
        for (name, residual) in [
            ("flicker", step.drawn),
            ("own_flicker", step.reference),
            ("added_flicker", step.added),
        ] {
            let name = |of: &str| format!("{name}_{}_{of}", step.step);
            row.add(name("mean"), residual.mean);
            row.add(name("p999"), residual.p999);
            row.add(name("max"), residual.max);
            row.add_known(name("flip"), residual.flip);
        }
    }
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
    use crate::table::Change;

    /// A measured body, with a sweep.
    fn report() -> BenchReport {
        let mut report = BenchReport::read(crate::report::tests::MEASURED).expect("a report");
        let case = &report.cases[0];
        let point = SweepPoint {
            parameter: "skip-but".into(),
            value: "damage".into(),
            measured_ms: 9.0,
            time_ratio: 0.5,
            time_ratio_range: [0.4, 0.6],
            frame_ms: 8.0,
            gpu_ms: None,
            counters: case.counters.clone(),
            error: case.error.expect("it was compared"),
            flicker: None,
            on_front: true,
        };
        report.sweep = Some(SweepReport {
            case: "orbit".into(),
            frames: 4,
            rounds: 3,
            points: vec![point],
            failed: vec![],
        });
        report
    }

    #[test]
    fn percentiles_of_0_to_100_are_those_numbers() {
        let summary = TimingSummary::from_samples((0..=100).rev().map(f64::from).collect());
        let expected = TimingSummary {
            mean: 50.0,
            median: 50.0,
            p5: 5.0,
            p95: 95.0,
            p99: 99.0,
        };
        assert_eq!(summary, Some(expected));
        assert_eq!(TimingSummary::from_samples(vec![]), None);
    }

    #[test]
    fn a_report_reads_back_as_it_was_written() {
        let text = serde_json::to_string_pretty(&report()).expect("plain numbers");
        assert_eq!(BenchReport::read(&text).ok(), Some(report()));
    }

    #[test]
    fn reports_with_old_names_read_as_the_new_ones() {
        let mut new = report();
        new.options.skip = "faint,saturated,damage".to_owned();
        let counters = ["cached", "damaged", "drawn", "skipped_by_detail"];
        new.cases[0].counters = counters.map(|name| (name.to_owned(), 3.0)).into();
        let stages = ["mlp", "project", "binning", "raster"];
        for (stage, name) in new.cases[0].stages.iter_mut().zip(stages) {
            stage.name = name.to_owned();
        }
        let mut old = serde_json::json!(new);
        old["options"]["skip"] = "faint,full,area".into();
        old["cases"][0]["counters"] =
            serde_json::json!({ "area": 3.0, "drawn": 3.0, "kept": 3.0, "thinned": 3.0 });
        for (at, name) in ["features", "splats", "bins", "raster"].iter().enumerate() {
            old["cases"][0]["stages"][at]["name"] = (*name).into();
        }
        let point = &mut old["sweep"]["points"][0];
        point["value"] = "area".into();
        point["knob"] = point["parameter"].take();
        point.as_object_mut().expect("a point").remove("parameter");
        assert_eq!(BenchReport::read(&old.to_string()).ok(), Some(new));
    }

    #[test]
    fn cases_points_and_setups_are_compared() {
        let a = report();
        let same = a.compared_with(&a);
        assert!(same.warnings.is_empty() && same.alone.is_empty());
        let is_same = |change| matches!(change, Change::Ratio(1.0) | Change::Decibel(0.0));
        assert!(same.lines.iter().all(|line| is_same(line.change())));
        let titles: Vec<&str> = same.lines.iter().map(|line| line.title.as_str()).collect();
        assert!(titles.contains(&"full") && titles.contains(&"orbit skip-but damage"));
        let mut b = report();
        b.device.name = "another".to_owned();
        b.size = [64, 48];
        b.avatar.gaussians = 11;
        b.cases[0].frame_ms.median *= 1.5;
        let compared = a.compared_with(&b);
        let frame = compared
            .lines
            .iter()
            .find(|own| own.name == "frame_ms_median");
        let change = frame.map(|own| own.change());
        assert!(matches!(change, Some(Change::Ratio(ratio)) if (ratio - 1.5).abs() < 1e-9));
        assert_eq!(compared.warnings.len(), 3, "{:?}", compared.warnings);
        let warnings = compared.warnings.join("\n");
        for part in [
            "against another",
            "2048 × 2048 against 64 × 48",
            "11 Gaussians",
        ] {
            assert!(warnings.contains(part), "{warnings}");
        }
    }
}
