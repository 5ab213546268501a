//! Two soaks against each other: reports go in; named numbers of both, and the facts that differ,
//! come out.

use super::report::{Drift, SCHEMA, Second, SoakReport};
use crate::report::{ReadError, Setup, difference, is_better, read_report};

/// Reads a soak's report.
///
/// # Errors
/// When the text is something else.
pub fn read(text: &str) -> Result<SoakReport, ReadError> {
    read_report(text, SCHEMA)
}

/// A number of both reports.
#[derive(Clone, Debug, PartialEq)]
pub struct SoakNumber {
    /// Name of the number.
    pub name: &'static str,
    /// Of the first and of the second; None where a report does not have it.
    pub values: [Option<f64>; 2],
}

impl SoakNumber {
    /// Whether the second is better than the first; None where they are as good.
    pub fn is_better(&self) -> Option<bool> {
        let [a, b] = self.values;
        is_better(self.name, [a?, b?])
    }
}

/// Every number, and a sentence for each fact that differs.
pub fn compare(a: &SoakReport, b: &SoakReport) -> (Vec<SoakNumber>, Vec<String>) {
    let pairs = numbers(a).into_iter().zip(numbers(b));
    let numbers = pairs.map(|((name, a), (_, b))| SoakNumber {
        name,
        values: [a, b],
    });
    (numbers.collect(), differences(a, b))
}

fn differences(a: &SoakReport, b: &SoakReport) -> Vec<String> {
    let switch = |on: bool| if on { "on" } else { "off" }.to_owned();
    let conditions = [
        ("promised rate", a.rate.to_string(), b.rate.to_string()),
        ("governor", switch(a.governed), switch(b.governed)),
        (
            "simulated heat",
            switch(a.simulated_heat),
            switch(b.simulated_heat),
        ),
    ];
    let mut differences = setup(a).differences(&setup(b));
    for (name, a, b) in conditions {
        differences.extend(difference(name, a, b));
    }
    differences
}

fn setup(report: &SoakReport) -> Setup<'_> {
    Setup {
        device: &report.device,
        avatar: &report.avatar,
        size: report.size,
        options: &report.options,
    }
}

fn numbers(report: &SoakReport) -> Vec<(&'static str, Option<f64>)> {
    let seconds = &report.each;
    let known = |get: fn(&Second) -> Option<f64>| seconds.iter().filter_map(get);
    let mean = |get: fn(&Second) -> Option<f64>| {
        let count = known(get).count();
        (count > 0).then(|| known(get).sum::<f64>() / count as f64)
    };
    let largest = |get: fn(&Second) -> Option<f64>| known(get).reduce(f64::max);
    let smallest = |get: fn(&Second) -> Option<f64>| known(get).reduce(f64::min);
    let psnr_db = |get: fn(&Drift) -> Option<f64>| report.drift.as_ref().and_then(get);
    let gained = report.growth.and_then(|growth| growth.resident_bytes);
    vec![
        ("minutes", Some(report.lasted_seconds / 60.0)),
        ("fps", Some(report.fps)),
        ("fps_lowest_second", smallest(|s| Some(s.fps))),
        ("frame_ms_p50_mean", mean(|s| Some(s.frame_ms_p50))),
        ("frame_ms_p99_largest", largest(|s| Some(s.frame_ms_p99))),
        ("busy_ms_mean", mean(|s| s.busy_ms)),
        ("frames", Some(report.frames as f64)),
        ("late", Some(report.late as f64)),
        ("dropped", Some(report.dropped as f64)),
        ("dropped_share", Some(report.dropped_share)),
        ("governor_changes", Some(report.changes as f64)),
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
        ("faults", Some(report.faults.len() as f64)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soak::faults::tests::report;

    #[test]
    fn numbers_are_paired_and_differences_named() {
        let a = report();
        let mut b = report();
        assert_eq!(compare(&a, &b).1, Vec::<String>::new());
        b.rate = 30.0;
        b.fps = 30.0;
        b.governed = false;
        let (numbers, differences) = compare(&a, &b);
        let fps = numbers.iter().find(|number| number.name == "fps");
        assert_eq!(
            fps.map(|number| number.values),
            Some([Some(60.0), Some(30.0)])
        );
        assert_eq!(
            differences,
            [
                "the promised rate differs: 60 against 30",
                "the governor differs: on against off"
            ]
        );
    }

    #[test]
    fn a_report_reads_back_as_it_was_written() {
        let text = serde_json::to_string(&report()).unwrap_or_default();
        assert_eq!(read(&text).ok(), Some(report()));
        let error = read(r#"{"schema": "effigy-bench-2"}"#).expect_err("it is not a soak's");
        assert!(error.to_string().contains("effigy-bench-2"));
    }

    #[test]
    fn reports_with_old_names_read_as_the_new_ones() {
        let text = serde_json::to_string(&report()).unwrap_or_default();
        let old = text
            .replace("\"images\"", "\"pictures\"")
            .replace("\"empty_images\"", "\"empty_pictures\"");
        assert!(old != text);
        assert_eq!(read(&old).ok(), Some(report()));
    }
}
