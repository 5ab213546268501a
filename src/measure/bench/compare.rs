//! Two benchmark reports against each other: every number of both, and how the machines and
//! settings differ.

use super::{
    report::{BenchReport, SCHEMA},
    table::{self, Cell, TableRow},
};
use crate::report::{ReadError, Setup, is_better, present_skip_names, read_report};

/// Reads a benchmark's report.
///
/// # Errors
/// When the text is something else.
pub fn read(text: &str) -> Result<BenchReport, ReadError> {
    let mut report: BenchReport = read_report(text, SCHEMA)?;
    let points = report.sweep.iter_mut().flat_map(|sweep| &mut sweep.points);
    for point in points.filter(|point| point.parameter == "skip-but") {
        point.value = present_skip_names(&point.value);
    }
    Ok(report)
}

/// One number of both reports.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchNumber {
    /// Case, and a sweep's parameter and value.
    pub title: String,
    /// Name of the number.
    pub name: String,
    /// In the first report.
    pub a: f64,
    /// In the second report.
    pub b: f64,
}

/// How far one number is from the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The second over the first.
    Ratio(f64),
    /// The second minus the first, for decibels, which are logarithms already.
    Decibel(f64),
    /// The numbers have no finite ratio or difference.
    None,
}

impl BenchNumber {
    /// The change from `a` to `b`.
    pub fn change(&self) -> Change {
        if self.name.starts_with("psnr") {
            let difference = if self.a == self.b {
                0.0
            } else {
                self.b - self.a
            };
            finite(difference).map_or(Change::None, Change::Decibel)
        } else {
            let ratio = if self.a == self.b {
                1.0
            } else {
                self.b / self.a
            };
            finite(ratio).map_or(Change::None, Change::Ratio)
        }
    }

    /// Whether the second is better than the first; None where they are as good.
    pub fn is_better(&self) -> Option<bool> {
        is_better(&self.name, [self.a, self.b])
    }
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Two reports side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// A sentence for each fact that differs between the two measurements.
    pub warnings: Vec<String>,
    /// Every number that both have.
    pub lines: Vec<BenchNumber>,
    /// Rows that only one of them has.
    pub alone: Vec<String>,
}

/// Compares row by row, in the order of the first.
pub fn compare(a: &BenchReport, b: &BenchReport) -> Comparison {
    let rows_a = table::rows(a);
    let rows_b = table::rows(b);
    let mut lines = Vec::new();
    let mut alone = Vec::new();
    for row in &rows_a {
        match rows_b.iter().find(|other| is_same_row(row, other)) {
            Some(other) => lines.extend(common_numbers(row, other)),
            None => alone.push(format!("{} (only the first has it)", row.title())),
        }
    }
    for row in &rows_b {
        if !rows_a.iter().any(|other| is_same_row(row, other)) {
            alone.push(format!("{} (only the second has it)", row.title()));
        }
    }
    Comparison {
        warnings: setup(a).differences(&setup(b)),
        lines,
        alone,
    }
}

fn setup(report: &BenchReport) -> Setup<'_> {
    Setup {
        device: &report.device,
        avatar: &report.avatar,
        size: report.size,
        options: &report.options,
    }
}

fn is_same_row(a: &TableRow, b: &TableRow) -> bool {
    a.case == b.case && a.parameter == b.parameter && a.value == b.value
}

/// The numbers that both rows have.
fn common_numbers(a: &TableRow, b: &TableRow) -> Vec<BenchNumber> {
    let number = |cell: &Cell| {
        Some(BenchNumber {
            title: a.title(),
            name: cell.name.clone(),
            a: cell.value,
            b: b.get(&cell.name)?,
        })
    };
    a.cells.iter().filter_map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        bench::report::{CaseReport, StageReport, SweepPoint, SweepReport, TimingSummary},
        report::{ErrorReport, tests as fixtures},
    };
    use std::collections::BTreeMap;

    fn report(ms: f64, psnr_db: Option<f64>) -> BenchReport {
        let text = |text: &str| text.to_owned();
        let error = ErrorReport {
            frames: 2,
            psnr_db,
            max_error: 0.1,
            flip: Some(0.01),
            ..ErrorReport::NONE
        };
        let spread = TimingSummary {
            mean: ms,
            median: ms,
            p5: ms,
            p95: 0.1 + 0.2,
            p99: 3e-9,
        };
        let counters = BTreeMap::from([(text("drawn"), 10.0), (text("faint"), ms - 10.0)]);
        let stage = StageReport {
            name: text("project"),
            ms: Some(spread),
            ran: 1.0,
            bytes: Some(100),
            bytes_floor: Some(50),
            operations: Some(7),
            operations_floor: None,
        };
        let case = CaseReport {
            name: text("full"),
            frames: 4,
            frame_ms: spread,
            fps: 1e3 / ms,
            gpu_ms: None,
            stages: vec![stage],
            bytes: Some(100),
            bytes_floor: Some(50),
            counters: counters.clone(),
            covered_pixels: Some(9.5),
            fragments_a_pixel: None,
            gpu_memory_bytes: Some(1 << 40),
            gpu_memory_used_bytes: Some(3),
            error: Some(error),
            flicker: None,
        };
        let point = SweepPoint {
            parameter: text("keys"),
            value: text("16"),
            measured_ms: ms,
            time_ratio: 0.5,
            time_ratio_range: [0.4, 0.6],
            frame_ms: ms,
            gpu_ms: Some(ms),
            counters,
            error,
            flicker: None,
            on_front: true,
        };
        BenchReport {
            schema: text(SCHEMA),
            program: fixtures::program(),
            device: fixtures::device(),
            avatar: fixtures::subject(),
            size: [640, 480],
            options: fixtures::options(),
            cases: vec![case],
            spread: None,
            sweep: Some(SweepReport {
                case: text("orbit"),
                frames: 4,
                rounds: 3,
                points: vec![point],
                failed: vec![],
            }),
        }
    }

    fn line<'a>(comparison: &'a Comparison, title: &str, name: &str) -> &'a BenchNumber {
        comparison
            .lines
            .iter()
            .find(|line| line.title == title && line.name == name)
            .expect("the line is there")
    }

    #[test]
    fn a_report_reads_back_as_it_was_written() {
        let report = report(12.5, None);
        assert_eq!(
            read(&serde_json::to_string_pretty(&report).expect("plain numbers"))
                .expect("it was just written"),
            report
        );
    }

    #[test]
    fn reports_with_old_names_read_as_the_new_ones() {
        let mut new = report(12.5, None);
        new.options.skip = "faint,saturated,damage".to_owned();
        let case = &mut new.cases[0];
        case.counters = BTreeMap::from([("cached".to_owned(), 3.0)]);
        if let Some(sweep) = &mut new.sweep {
            sweep.points[0].parameter = "skip-but".to_owned();
            sweep.points[0].value = "damage".to_owned();
        }
        let mut old = serde_json::json!(new);
        old["options"]["skip"] = "faint,full,area".into();
        old["cases"][0]["counters"] = serde_json::json!({ "kept": 3.0 });
        old["cases"][0]["stages"][0]["name"] = "splats".into();
        old["sweep"]["points"][0]["value"] = "area".into();
        assert_eq!(read(&old.to_string()).expect("an old report"), new);
    }

    #[test]
    fn times_have_ratios_and_decibels_differences() {
        let comparison = compare(&report(10.0, Some(50.0)), &report(15.0, Some(53.5)));
        assert!(
            comparison.warnings.is_empty() && comparison.alone.is_empty(),
            "{comparison:?}"
        );
        assert_eq!(
            line(&comparison, "full", "frame_ms_median").change(),
            Change::Ratio(1.5)
        );
        assert_eq!(
            line(&comparison, "full", "psnr_db").change(),
            Change::Decibel(3.5)
        );
        assert_eq!(line(&comparison, "full", "faint").change(), Change::None);
        assert_eq!(
            line(&comparison, "full", "project_bytes").change(),
            Change::Ratio(1.0)
        );
        assert_eq!(
            line(&comparison, "orbit keys 16", "frame_ms").change(),
            Change::Ratio(1.5)
        );
        let exact = compare(&report(10.0, None), &report(10.0, Some(50.0)));
        assert_eq!(line(&exact, "full", "psnr_db").change(), Change::None);
        let same = compare(&report(10.0, None), &report(10.0, None));
        assert!(
            same.lines
                .iter()
                .all(|line| matches!(line.change(), Change::Ratio(1.0) | Change::Decibel(0.0))),
            "{same:?}"
        );
    }

    #[test]
    fn differences_between_setups_are_warnings() {
        let a = report(10.0, None);
        let mut b = report(10.0, None);
        b.device.name = "another".to_owned();
        b.size = [64, 48];
        b.avatar.gaussians = 11;
        b.cases[0].name = "far".to_owned();
        let comparison = compare(&a, &b);
        assert_eq!(comparison.warnings.len(), 3, "{:?}", comparison.warnings);
        let warnings = comparison.warnings.join("\n");
        for part in [
            "A against another",
            "640 × 480 against 64 × 48",
            "11 Gaussians",
        ] {
            assert!(warnings.contains(part), "{warnings}");
        }
        assert_eq!(
            comparison.alone,
            [
                "full (only the first has it)",
                "far (only the second has it)"
            ]
        );
        assert!(
            comparison
                .lines
                .iter()
                .all(|line| line.title == "orbit keys 16")
        );
    }
}
