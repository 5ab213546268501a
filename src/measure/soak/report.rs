//! The report of a soak. [`SoakReport`] is the whole JSON file; the fields are its keys.

use crate::{
    report::{
        DeviceReport, ErrorReport, OptionsReport, Program, ReadError, Setup, Subject, difference,
        read_report,
    },
    table::{Comparison, TableRow},
};
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

impl SoakReport {
    /// The highest of a number that seconds have; None where none has it.
    pub fn highest(&self, get: fn(&Second) -> Option<f64>) -> Option<f64> {
        self.each.iter().filter_map(get).reduce(f64::max)
    }

    /// Reads a report's JSON.
    ///
    /// # Errors
    /// When the text is something else.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        read_report(text, SCHEMA)
    }

    /// Every number of this report and of another, and a sentence for each fact that differs.
    pub fn compared_with(&self, other: &Self) -> Comparison {
        let setup = |report: &Self| {
            let switch = |on: bool| if on { "on" } else { "off" }.to_owned();
            [
                ("promised rate", report.rate.to_string()),
                ("governor", switch(report.governed)),
                ("simulated heat", switch(report.simulated_heat)),
            ]
        };
        let mut warnings = self.setup().differences(&other.setup());
        for ((name, a), (_, b)) in setup(self).into_iter().zip(setup(other)) {
            warnings.extend(difference(name, a, b));
        }
        Comparison::new(warnings, &[self.row()], &[other.row()])
    }

    fn setup(&self) -> Setup<'_> {
        Setup {
            device: &self.device,
            avatar: &self.avatar,
            size: self.size,
            options: &self.options,
        }
    }

    /// The numbers of the whole run; those that were not measured are unknown.
    fn row(&self) -> TableRow {
        let seconds = &self.each;
        let known = |get: fn(&Second) -> Option<f64>| seconds.iter().filter_map(get);
        let mean = |get: fn(&Second) -> Option<f64>| {
            let count = known(get).count();
            (count > 0).then(|| known(get).sum::<f64>() / count as f64)
        };
        let largest = |get: fn(&Second) -> Option<f64>| known(get).reduce(f64::max);
        let smallest = |get: fn(&Second) -> Option<f64>| known(get).reduce(f64::min);
        let psnr_db = |get: fn(&Drift) -> Option<f64>| self.drift.as_ref().and_then(get);
        let gained = self.growth.and_then(|growth| growth.resident_bytes);
        let cells = [
            ("minutes", Some(self.lasted_seconds / 60.0)),
            ("fps", Some(self.fps)),
            ("fps_lowest_second", smallest(|s| Some(s.fps))),
            ("frame_ms_p50_mean", mean(|s| Some(s.frame_ms_p50))),
            ("frame_ms_p99_largest", largest(|s| Some(s.frame_ms_p99))),
            ("busy_ms_mean", mean(|s| s.busy_ms)),
            ("frames", Some(self.frames as f64)),
            ("late", Some(self.late as f64)),
            ("dropped", Some(self.dropped as f64)),
            ("dropped_share", Some(self.dropped_share)),
            ("governor_changes", Some(self.changes as f64)),
            ("governor_step_mean", mean(|s| Some(s.rung as f64))),
            ("headroom_largest", largest(|s| s.headroom)),
            ("celsius_largest", largest(|s| s.celsius)),
            ("watts_mean", mean(|s| s.watts)),
            (
                "device_bytes_largest",
                largest(|s| Some(s.device_bytes as f64)),
            ),
            (
                "resident_bytes_largest",
                largest(|s| s.resident_bytes.map(|bytes| bytes as f64)),
            ),
            ("resident_bytes_gained", gained.map(|bytes| bytes as f64)),
            ("psnr_db_before", psnr_db(|drift| drift.before.psnr_db)),
            ("psnr_db_after", psnr_db(|drift| drift.after.psnr_db)),
            ("faults", Some(self.faults.len() as f64)),
        ];
        let mut row = TableRow::new("", "", "");
        row.cells = cells.map(|(name, value)| (name.to_owned(), value)).into();
        row
    }
}

/// A rung of the ladder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LadderStep {
    /// Name of the rung, after what it gives up.
    pub name: String,
    /// This and the next four: see [`FrameQuality`].
    pub scale: f64,
    /// Frames that each pose is held for.
    pub hold: u32,
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
            coarser,
            level,
            refreshes,
        } = rung.quality;
        Self {
            name: rung.name.clone(),
            scale,
            hold,
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
    /// This and the next four: see [`ThermalReading`](effigy_runtime::thermals::ThermalReading).
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soak::faults::tests::report;

    #[test]
    fn numbers_are_paired_and_differences_named() {
        let a = report();
        let mut b = report();
        assert_eq!(a.compared_with(&b).warnings, Vec::<String>::new());
        b.rate = 30.0;
        b.fps = 30.0;
        b.governed = false;
        let compared = a.compared_with(&b);
        let fps = compared.lines.iter().find(|line| line.name == "fps");
        let values = fps.map(|line| line.values);
        assert_eq!(values, Some([Some(60.0), Some(30.0)]));
        assert_eq!(
            compared.warnings,
            [
                "the promised rate differs: 60 against 30",
                "the governor differs: on against off"
            ]
        );
    }

    #[test]
    fn a_report_reads_back_as_it_was_written_and_under_its_old_names() {
        let text = serde_json::to_string(&report()).expect("plain numbers");
        assert_eq!(SoakReport::read(&text).ok(), Some(report()));
        let old = text
            .replace("\"images\"", "\"pictures\"")
            .replace("\"empty_images\"", "\"empty_pictures\"");
        assert!(old != text);
        assert_eq!(SoakReport::read(&old).ok(), Some(report()));
        let error = SoakReport::read(r#"{"schema": "effigy-bench-2"}"#);
        let error = error.expect_err("it is not a soak's");
        assert!(error.to_string().contains("effigy-bench-2"));
    }
}
