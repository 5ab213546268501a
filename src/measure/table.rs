//! Rows of named numbers: what reports are written to a CSV as, and what two of them are compared
//! by.

use std::io;

/// The numbers of one case, of one point of a sweep, or of a soak.
#[derive(Clone, Debug, PartialEq)]
pub struct TableRow {
    /// Names of the case, a sweep's parameter and its value; empty where there is none.
    pub names: [String; 3],
    /// All numbers by name; none where it is unknown. The PSNR of an image without error is
    /// infinite.
    pub cells: Vec<(String, Option<f64>)>,
}

impl TableRow {
    /// A row without numbers.
    pub fn new(case: &str, parameter: &str, value: &str) -> Self {
        Self {
            names: [case, parameter, value].map(str::to_owned),
            cells: Vec::new(),
        }
    }

    /// Case, parameter and value in words.
    pub fn title(&self) -> String {
        let words = self.names.iter().map(String::as_str);
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        words.join(" ")
    }

    /// Adds a number.
    pub fn add(&mut self, name: impl Into<String>, value: f64) {
        self.cells.push((name.into(), Some(value)));
    }

    /// Adds a number if it is known.
    pub fn add_known(&mut self, name: impl Into<String>, value: Option<f64>) {
        if let Some(value) = value {
            self.add(name, value);
        }
    }

    /// The number of a name, if the row has the name.
    fn get(&self, name: &str) -> Option<Option<f64>> {
        let cell = self.cells.iter().find(|cell| cell.0 == name)?;
        Some(cell.1)
    }
}

/// The rows under a header with all names. The cell of a number that a row lacks is empty.
///
/// # Errors
/// When a row can't be encoded.
pub fn csv(rows: &[TableRow]) -> io::Result<Vec<u8>> {
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in rows.iter().flat_map(|row| &row.cells) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    let header = ["case", "parameter", "value"];
    writer.write_record(header.iter().chain(&names))?;
    for row in rows {
        let mut record = row.names.to_vec();
        for name in &names {
            let value = row.get(name).flatten();
            record.push(value.map(|value| value.to_string()).unwrap_or_default());
        }
        writer.write_record(record)?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

/// One number of two reports.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedNumber {
    /// [`TableRow::title`].
    pub title: String,
    /// Name of the number.
    pub name: String,
    /// In the first and in the second report, where it is known.
    pub values: [Option<f64>; 2],
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

impl ComparedNumber {
    /// The change from the first to the second.
    pub fn change(&self) -> Change {
        let [Some(a), Some(b)] = self.values else {
            return Change::None;
        };
        let is_psnr = self.name.starts_with("psnr");
        let change = match (is_psnr, a == b) {
            (true, true) => 0.0,
            (true, false) => b - a,
            (false, true) => 1.0,
            (false, false) => b / a,
        };
        if !change.is_finite() {
            Change::None
        } else if is_psnr {
            Change::Decibel(change)
        } else {
            Change::Ratio(change)
        }
    }

    /// Whether the second is better than the first, by the name. None where neither is: they differ
    /// by less than one per cent, or more of it is neither good nor bad.
    pub fn is_better(&self) -> Option<bool> {
        /// What can't be told from how measurements vary anyway.
        const EQUAL: f64 = 0.01;
        const MORE: [&str; 3] = ["psnr_db", "fps", "within_tolerance"];
        const LESS: [&str; 17] = [
            "frame_ms",
            "gpu_ms",
            "busy_ms",
            "time_ratio",
            "max_error",
            "flip",
            "added_flicker",
            "gpu_memory",
            "device_bytes",
            "resident_bytes",
            "late",
            "dropped",
            "governor",
            "headroom",
            "celsius",
            "watts",
            "faults",
        ];
        let [Some(a), Some(b)] = self.values else {
            return None;
        };
        let begins = |list: &[&str]| list.iter().any(|start| self.name.starts_with(start));
        let more = begins(&MORE);
        let is_judged = more || begins(&LESS) || self.name.ends_with("_ms_median");
        let is_equal = if self.name.starts_with("psnr") {
            a == b || (b - a).abs() < 20.0 * (1.0 + EQUAL).log10()
        } else {
            (b - a).abs() <= EQUAL * a.abs()
        };
        (is_judged && !is_equal && !a.is_nan() && !b.is_nan()).then_some((b > a) == more)
    }
}

/// Two reports side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// A sentence for each fact that differs between the two measurements.
    pub warnings: Vec<String>,
    /// Every number that both have.
    pub lines: Vec<ComparedNumber>,
    /// Rows that only one of them has.
    pub alone: Vec<String>,
}

impl Comparison {
    /// Compares row by row, in the order of the first.
    pub fn new(warnings: Vec<String>, a: &[TableRow], b: &[TableRow]) -> Self {
        let mut lines = Vec::new();
        let mut alone = Vec::new();
        for row in a {
            let Some(other) = b.iter().find(|other| other.names == row.names) else {
                alone.push(format!("{} (only the first has it)", row.title()));
                continue;
            };
            lines.extend(row.cells.iter().filter_map(|(name, value)| {
                Some(ComparedNumber {
                    title: row.title(),
                    name: name.clone(),
                    values: [*value, other.get(name)?],
                })
            }));
        }
        for row in b {
            if !a.iter().any(|other| other.names == row.names) {
                alone.push(format!("{} (only the second has it)", row.title()));
            }
        }
        Self {
            warnings,
            lines,
            alone,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(case: &str, value: &str, cells: &[(&str, f64)]) -> TableRow {
        let mut row = TableRow::new(case, "a, \"quoted\" parameter", value);
        for &(name, value) in cells {
            row.add(name, value);
        }
        row
    }

    #[test]
    fn csv_reads_back_as_it_was_written() {
        let rows = [
            row(
                "full",
                "1/255",
                &[("frame_ms", 0.1 + 0.2), ("psnr_db", f64::INFINITY)],
            ),
            row("far", "", &[("drawn", 1e9), ("frame_ms", 3e-7)]),
        ];
        let bytes = csv(&rows).expect("plain numbers");
        let mut reader = csv::Reader::from_reader(bytes.as_slice());
        let names = reader.headers().expect("there is a first line").clone();
        let expected = ["case", "parameter", "value", "frame_ms", "psnr_db", "drawn"];
        assert_eq!(names, expected.to_vec());
        for (record, row) in reader.records().zip(&rows) {
            let record = record.expect("as many cells as names");
            assert_eq!([&record[0], &record[1], &record[2]], row.names.each_ref());
            for (name, cell) in names.iter().zip(&record).skip(3) {
                assert_eq!(row.get(name).flatten(), cell.parse().ok(), "{name}");
            }
        }
    }

    #[test]
    fn rows_are_compared_with_those_of_their_name() {
        let a = [
            row("full", "1", &[("drawn", 4.0), ("frame_ms", 10.0)]),
            row("far", "", &[]),
        ];
        let b = [
            row("four", "", &[]),
            row("full", "1", &[("frame_ms", 15.0)]),
        ];
        let compared = Comparison::new(vec![], &a, &b);
        let number = ComparedNumber {
            title: a[0].title(),
            name: "frame_ms".into(),
            values: [Some(10.0), Some(15.0)],
        };
        assert_eq!(number.change(), Change::Ratio(1.5));
        assert_eq!(compared.lines, [number]);
        let alone = [("far", "first"), ("four", "second")]
            .map(|(name, has)| format!("{name} a, \"quoted\" parameter (only the {has} has it)"));
        assert_eq!(compared.alone, alone);
    }

    #[test]
    fn times_have_ratios_decibels_differences_and_more_decibels_are_better() {
        const INF: f64 = f64::INFINITY;
        for (name, values, change, is_better) in [
            ("psnr_db", [50.0, 51.0], Change::Decibel(1.0), Some(true)),
            ("psnr_db_whole", [INF, 51.0], Change::None, Some(false)),
            ("psnr_db", [INF; 2], Change::Decibel(0.0), None),
            ("psnr_db", [50.0, 50.0625], Change::Decibel(0.0625), None),
            (
                "frame_ms_median",
                [10.0, 8.0],
                Change::Ratio(0.8),
                Some(true),
            ),
            (
                "frame_ms_p99",
                [16.0, 16.125],
                Change::Ratio(1.0078125),
                None,
            ),
            (
                "raster_ms_median",
                [1.0, 2.0],
                Change::Ratio(2.0),
                Some(false),
            ),
            ("fps", [60.0, 30.0], Change::Ratio(0.5), Some(false)),
            ("max_error", [0.0, 0.1], Change::None, Some(false)),
            ("faults", [1.0, 0.0], Change::Ratio(0.0), Some(true)),
            ("fps", [60.0, f64::NAN], Change::None, None),
            ("covered_pixels", [1.0, 2.0], Change::Ratio(2.0), None),
            ("raster_ran", [0.0; 2], Change::Ratio(1.0), None),
        ] {
            let number = ComparedNumber {
                title: String::new(),
                name: name.into(),
                values: values.map(Some),
            };
            assert_eq!(number.change(), change, "{name} {values:?}");
            assert_eq!(number.is_better(), is_better, "{name} {values:?}");
        }
    }
}
