//! Two reports against each other: what differs between the machines and settings, and every number of both.

use super::{
    report::{Report, SCHEMA},
    table::{self, Row},
};

/// Why a file is no report.
#[derive(Debug, thiserror::Error)]
pub enum Fault {
    #[error("it is not JSON: {0}")]
    NotJson(serde_json::Error),
    #[error("its schema is {found}, this program reads `{SCHEMA}`: measure again with this version of the program")]
    Schema { found: String },
    #[error("it is a report with something missing: {0}")]
    Broken(serde_json::Error),
}

/// Reads the text of a report.
pub fn read(text: &str) -> Result<Report, Fault> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(Fault::NotJson)?;
    match value.get("schema").and_then(|schema| schema.as_str()) {
        Some(SCHEMA) => serde_json::from_value(value).map_err(Fault::Broken),
        Some(other) => Err(Fault::Schema { found: format!("`{other}`") }),
        None => Err(Fault::Schema { found: "not given".to_owned() }),
    }
}

/// One number of both reports.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Case, and a sweep's knob and value.
    pub title: String,
    pub name: String,
    pub a: f64,
    pub b: f64,
}

/// How far one number is from the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The second over the first.
    Ratio(f64),
    /// The second less the first: decibels are logarithms already.
    Decibel(f64),
    /// The first is zero, or one is infinite, and the other not.
    None,
}

impl Line {
    pub fn change(&self) -> Change {
        if self.a == self.b {
            return if self.is_decibel() { Change::Decibel(0.0) } else { Change::Ratio(1.0) };
        }
        match (self.is_decibel(), self.b - self.a, self.b / self.a) {
            (true, difference, _) if difference.is_finite() => Change::Decibel(difference),
            (false, _, ratio) if ratio.is_finite() => Change::Ratio(ratio),
            _ => Change::None,
        }
    }

    fn is_decibel(&self) -> bool {
        self.name.starts_with("psnr")
    }
}

/// What two reports have in common, and what not.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Sentences on what was not the same when the two were measured.
    pub warnings: Vec<String>,
    pub lines: Vec<Line>,
    /// Rows that only one of them has.
    pub alone: Vec<String>,
}

/// Compares row by row, in the order of the first.
pub fn compare(a: &Report, b: &Report) -> Comparison {
    let (rows_a, rows_b) = (table::rows(a), table::rows(b));
    let same = |a: &Row, b: &Row| (&a.case, &a.knob, &a.value) == (&b.case, &b.knob, &b.value);
    let mut comparison = Comparison { warnings: warnings(a, b), lines: Vec::new(), alone: Vec::new() };
    for row in &rows_a {
        match rows_b.iter().find(|other| same(row, other)) {
            Some(other) => comparison.lines.extend(lines(row, other)),
            None => comparison.alone.push(format!("{} (only the first has it)", row.title())),
        }
    }
    let only = rows_b.iter().filter(|row| !rows_a.iter().any(|other| same(row, other)));
    comparison.alone.extend(only.map(|row| format!("{} (only the second has it)", row.title())));
    comparison
}

fn lines(a: &Row, b: &Row) -> Vec<Line> {
    let line = |(name, value): &(String, f64)| Some(Line { title: a.title(), name: name.clone(), a: *value, b: b.get(name)? });
    a.cells.iter().filter_map(line).collect()
}

fn warnings(a: &Report, b: &Report) -> Vec<String> {
    let size = |report: &Report| format!("{} × {}", report.size[0], report.size[1]);
    let subject = |report: &Report| format!("{}, {} Gaussians, {:?} rows", report.avatar.name, report.avatar.gaussians, report.avatar.rows);
    let options = |report: &Report| serde_json::to_string(&report.options).unwrap_or_default();
    let facts = [
        ("device", a.device.name.clone(), b.device.name.clone()),
        ("driver", a.device.driver.clone(), b.device.driver.clone()),
        ("backend", a.device.backend.clone(), b.device.backend.clone()),
        ("16-bit storage", a.device.half_storage.to_string(), b.device.half_storage.to_string()),
        ("avatar", subject(a), subject(b)),
        ("clip", a.avatar.clip.clone(), b.avatar.clip.clone()),
        ("picture", size(a), size(b)),
        ("options", options(a), options(b)),
    ];
    facts.into_iter().filter(|(_, a, b)| a != b).map(|(what, a, b)| format!("the {what} differs: {a} against {b}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::bench::report::{
        CaseReport, Device, ErrorReport, Options, Point, Program, Spread, StageReport, Subject, SweepReport,
    };

    fn report(ms: f64, psnr_db: Option<f64>) -> Report {
        let text = |text: &str| text.to_owned();
        let error = ErrorReport { frames: 2, psnr_db, max_error: 0.1, flip: Some(0.01), ..ErrorReport::NONE };
        let spread = Spread { mean: ms, median: ms, p5: ms, p95: 0.1 + 0.2, p99: 3e-9 };
        let counters = std::collections::BTreeMap::from([(text("drawn"), 10.0), (text("hidden"), ms - 10.0)]);
        let stage = StageReport {
            name: text("splats"),
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
        };
        let point = Point {
            knob: text("keys"),
            value: text("16"),
            measured_ms: ms,
            time_ratio: 0.5,
            time_ratio_range: [0.4, 0.6],
            frame_ms: ms,
            gpu_ms: Some(ms),
            counters,
            error,
            on_front: true,
        };
        Report {
            schema: text(SCHEMA),
            program: Program { version: text("1"), commit: None, date: text("now"), command: vec![] },
            device: Device {
                name: text("A"),
                driver: text("B"),
                vulkan: text("1.3.0"),
                half_storage: true,
                subgroup_size: 8,
                backend: "vulkan".into(),
                timestamps: true,
            },
            avatar: Subject { name: text("body"), clip: text("walk"), gaussians: 10, parts: 1, nodes: 2, rows: [1, 2, 3] },
            size: [640, 480],
            options: Options {
                color: text("rgba16f"),
                raster: text("hulls"),
                key_bits: 16,
                skip: text("none"),
                cutoff: 1.0 / 255.0,
                margin: 0.005,
                detail: text("full"),
                storage: text("half"),
                rows: 1.0,
                hold: 1,
            },
            cases: vec![case],
            sweep: Some(SweepReport { case: text("orbit"), frames: 4, rounds: 3, points: vec![point], failed: vec![] }),
        }
    }

    fn line<'a>(comparison: &'a Comparison, title: &str, name: &str) -> &'a Line {
        comparison.lines.iter().find(|line| line.title == title && line.name == name).expect("the line is there")
    }

    #[test]
    fn a_report_reads_back_as_it_was_written() {
        let report = report(12.5, None);
        assert_eq!(read(&serde_json::to_string_pretty(&report).expect("plain numbers")).expect("it was just written"), report);
    }

    #[test]
    fn times_have_ratios_and_decibels_differences() {
        let comparison = compare(&report(10.0, Some(50.0)), &report(15.0, Some(53.5)));
        assert!(comparison.warnings.is_empty() && comparison.alone.is_empty(), "{comparison:?}");
        assert_eq!(line(&comparison, "full", "frame_ms_median").change(), Change::Ratio(1.5));
        assert_eq!(line(&comparison, "full", "psnr_db").change(), Change::Decibel(3.5));
        assert_eq!(line(&comparison, "full", "hidden").change(), Change::None);
        assert_eq!(line(&comparison, "full", "splats_bytes").change(), Change::Ratio(1.0));
        assert_eq!(line(&comparison, "orbit keys 16", "frame_ms").change(), Change::Ratio(1.5));
        let exact = compare(&report(10.0, None), &report(10.0, Some(50.0)));
        assert_eq!(line(&exact, "full", "psnr_db").change(), Change::None);
        let same = compare(&report(10.0, None), &report(10.0, None));
        assert!(same.lines.iter().all(|line| matches!(line.change(), Change::Ratio(1.0) | Change::Decibel(0.0))), "{same:?}");
    }

    #[test]
    fn what_was_not_the_same_is_said() {
        let (a, mut b) = (report(10.0, None), report(10.0, None));
        b.device.name = "another".to_owned();
        b.size = [64, 48];
        b.avatar.gaussians = 11;
        b.cases[0].name = "far".to_owned();
        let comparison = compare(&a, &b);
        let said = comparison.warnings.join("\n");
        assert!(
            comparison.warnings.len() == 3
                && ["A against another", "640 × 480 against 64 × 48", "11 Gaussians"].iter().all(|s| said.contains(s)),
            "{said}"
        );
        assert_eq!(comparison.alone, ["full (only the first has it)", "far (only the second has it)"]);
        assert!(comparison.lines.iter().all(|line| line.title == "orbit keys 16"));
    }

    #[test]
    fn files_of_another_layout_are_refused_with_what_to_do() {
        let told = |text: &str| read(text).map_err(|fault| fault.to_string()).expect_err("it is no report");
        assert!(told("{").contains("not JSON"));
        assert!(told(r#"{"device": "A"}"#).contains("not given"));
        let other = told(r#"{"schema": "effigy-bench-1"}"#);
        assert!(other.contains("effigy-bench-1") && other.contains(SCHEMA) && other.contains("measure again"), "{other}");
        assert!(told(&format!(r#"{{"schema": "{SCHEMA}"}}"#)).contains("missing field"));
    }
}
