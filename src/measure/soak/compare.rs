//! Two soaks against each other: reports go in, named numbers of both come out, and what was not the same about them.

use super::report::{Report, SCHEMA, Second};
use serde::Deserialize;

/// Why a file is no soak's.
#[derive(Debug, thiserror::Error)]
pub enum Fault {
    #[error("it is not JSON as `effigy soak` writes it: {0}")]
    Json(#[from] serde_json::Error),
    #[error("its layout is `{found}`, this program reads `{SCHEMA}`: soak again with this program")]
    Schema { found: String },
}

/// Reads a report.
pub fn read(text: &str) -> Result<Report, Fault> {
    #[derive(Deserialize)]
    struct Head {
        #[serde(default)]
        schema: String,
    }
    let head: Head = serde_json::from_str(text)?;
    if head.schema != SCHEMA {
        let found = if head.schema.is_empty() { "not given".to_owned() } else { head.schema };
        return Err(Fault::Schema { found });
    }
    Ok(serde_json::from_str(text)?)
}

/// A number of both. None where one of them does not have it.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    pub name: &'static str,
    pub values: [Option<f64>; 2],
}

/// Every number, and every fact that differs.
pub fn compare(a: &Report, b: &Report) -> (Vec<Line>, Vec<String>) {
    let lines = numbers(a).into_iter().zip(numbers(b)).map(|((name, a), (_, b))| Line { name, values: [a, b] });
    let size = |report: &Report| format!("{} × {}", report.size[0], report.size[1]);
    let options = |report: &Report| serde_json::to_string(&report.options).unwrap_or_default();
    let on = |on: bool| if on { "on" } else { "off" }.to_owned();
    let facts = [
        ("device", a.device.name.clone(), b.device.name.clone()),
        ("driver", a.device.driver.clone(), b.device.driver.clone()),
        ("avatar", a.avatar.name.clone(), b.avatar.name.clone()),
        ("clip", a.avatar.clip.clone(), b.avatar.clip.clone()),
        ("screen", size(a), size(b)),
        ("options", options(a), options(b)),
        ("promised rate", a.rate.to_string(), b.rate.to_string()),
        ("governor", on(a.governed), on(b.governed)),
        ("simulated heat", on(a.simulated_heat), on(b.simulated_heat)),
    ];
    let differ = facts.into_iter().filter(|(_, a, b)| a != b).map(|(what, a, b)| format!("the {what} differs: {a} against {b}"));
    (lines.collect(), differ.collect())
}

fn numbers(report: &Report) -> Vec<(&'static str, Option<f64>)> {
    let each = &report.each;
    let all = |of: fn(&Second) -> Option<f64>| each.iter().filter_map(of);
    let mean = |of: fn(&Second) -> Option<f64>| {
        let count = all(of).count();
        (count > 0).then(|| all(of).sum::<f64>() / count as f64)
    };
    let most = |of: fn(&Second) -> Option<f64>| all(of).reduce(f64::max);
    let db = |of: fn(&super::report::Drift) -> Option<f64>| report.drift.as_ref().and_then(of);
    vec![
        ("minutes", Some(report.lasted_seconds / 60.0)),
        ("fps", Some(report.fps)),
        ("fps_lowest_second", all(|second| Some(second.fps)).reduce(f64::min)),
        ("frame_ms_p50_mean", mean(|second| Some(second.frame_ms_p50))),
        ("frame_ms_p99_largest", most(|second| Some(second.frame_ms_p99))),
        ("busy_ms_mean", mean(|second| second.busy_ms)),
        ("frames", Some(report.frames as f64)),
        ("late", Some(report.late as f64)),
        ("dropped", Some(report.dropped as f64)),
        ("dropped_share", Some(report.dropped_share)),
        ("governor_changes", Some(report.changes as f64)),
        ("governor_step_mean", mean(|second| Some(second.rung as f64))),
        ("headroom_largest", most(|second| second.headroom)),
        ("celsius_largest", most(|second| second.celsius)),
        ("watts_mean", mean(|second| second.watts)),
        ("device_bytes_largest", most(|second| Some(second.device_bytes as f64))),
        ("resident_bytes_largest", most(|second| second.resident_bytes.map(|bytes| bytes as f64))),
        ("resident_bytes_gained", report.growth.and_then(|growth| growth.resident_bytes).map(|bytes| bytes as f64)),
        ("psnr_db_before", db(|drift| drift.before.psnr_db)),
        ("psnr_db_after", db(|drift| drift.after.psnr_db)),
        ("faults", Some(report.faults.len() as f64)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::soak::verdict::tests::report;

    #[test]
    fn numbers_stand_side_by_side_and_differences_are_said() {
        let (a, mut b) = (report(), report());
        assert_eq!(compare(&a, &b).1, Vec::<String>::new());
        (b.rate, b.fps, b.governed) = (30.0, 30.0, false);
        let (lines, differ) = compare(&a, &b);
        assert_eq!(lines.iter().find(|line| line.name == "fps").map(|line| line.values), Some([Some(60.0), Some(30.0)]));
        assert_eq!(differ, ["the promised rate differs: 60 against 30", "the governor differs: on against off"]);
    }

    #[test]
    fn a_report_reads_back_and_others_are_refused() {
        let text = serde_json::to_string(&report()).unwrap_or_default();
        assert_eq!(read(&text).ok(), Some(report()));
        assert!(read("{}").is_err_and(|fault| fault.to_string().contains("not given")));
        assert!(read(r#"{"schema": "effigy-bench-2"}"#).is_err_and(|fault| fault.to_string().contains("effigy-bench-2")));
    }
}
