//! A report as rows of named numbers: the contents of the CSV, and what two reports are compared
//! by.

use super::report::{BenchReport, CaseReport, ErrorReport, FlickerReport, StageReport, SweepPoint};

/// A named number.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Name of the column.
    pub name: String,
    /// The number.
    pub value: f64,
}

/// The numbers of one case, or of one point of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct TableRow {
    /// Name of the case.
    pub case: String,
    /// Of a sweep's point; else empty, like `value`.
    pub parameter: String,
    /// Value of the parameter, in words.
    pub value: String,
    /// All numbers that are known. The PSNR of an image without error is infinite.
    pub cells: Vec<Cell>,
}

impl TableRow {
    fn new(case: &str, parameter: &str, value: &str) -> Self {
        Self {
            case: case.to_owned(),
            parameter: parameter.to_owned(),
            value: value.to_owned(),
            cells: Vec::new(),
        }
    }

    /// Case, parameter and value in words.
    pub fn title(&self) -> String {
        let mut words = vec![self.case.as_str(), &self.parameter, &self.value];
        words.retain(|word| !word.is_empty());
        words.join(" ")
    }

    /// The number of a name.
    pub fn get(&self, name: &str) -> Option<f64> {
        let cell = self.cells.iter().find(|cell| cell.name == name)?;
        Some(cell.value)
    }

    fn add(&mut self, name: impl Into<String>, value: f64) {
        self.cells.push(Cell {
            name: name.into(),
            value,
        });
    }

    /// Adds a number that may be unknown.
    fn add_known(&mut self, name: impl Into<String>, value: Option<f64>) {
        if let Some(value) = value {
            self.add(name, value);
        }
    }

    fn add_error(&mut self, error: &ErrorReport) {
        if error.frames == 0 {
            return;
        }
        self.add("checked_frames", error.frames as f64);
        self.add("psnr_db", error.psnr_db.unwrap_or(f64::INFINITY));
        self.add("max_error", error.max_error);
        self.add("within_tolerance", error.within_tolerance);
        let psnr_db_whole = error.psnr_db_whole.unwrap_or(f64::INFINITY);
        self.add("psnr_db_whole", psnr_db_whole);
        self.add("max_error_whole", error.max_error_whole);
        self.add_known("flip", error.flip);
    }

    fn add_flicker(&mut self, flicker: &FlickerReport) {
        for step in &flicker.steps {
            let series = [
                ("flicker", step.drawn),
                ("own_flicker", step.reference),
                ("added_flicker", step.added),
            ];
            for (name, residual) in series {
                let name = |of: &str| format!("{name}_{}_{of}", step.step);
                self.add(name("mean"), residual.mean);
                self.add(name("p999"), residual.p999);
                self.add(name("max"), residual.max);
                self.add_known(name("flip"), residual.flip);
            }
        }
    }
}

/// Cases first, then the sweep's points.
pub fn rows(report: &BenchReport) -> Vec<TableRow> {
    let mut rows: Vec<_> = report.cases.iter().map(case_row).collect();
    if let Some(sweep) = &report.sweep {
        let points = sweep.points.iter();
        rows.extend(points.map(|point| point_row(&sweep.case, point)));
    }
    rows
}

fn case_row(case: &CaseReport) -> TableRow {
    let count = |count: Option<u64>| count.map(|count| count as f64);
    let mut row = TableRow::new(&case.name, "", "");
    row.add("frames", case.frames as f64);
    row.add("frame_ms_mean", case.frame_ms.mean);
    row.add("frame_ms_median", case.frame_ms.median);
    row.add("frame_ms_p5", case.frame_ms.p5);
    row.add("frame_ms_p95", case.frame_ms.p95);
    row.add("frame_ms_p99", case.frame_ms.p99);
    row.add("fps", case.fps);
    if let Some(gpu_ms) = case.gpu_ms {
        row.add("gpu_ms_median", gpu_ms.median);
        row.add("gpu_ms_p95", gpu_ms.p95);
    }
    for stage in &case.stages {
        add_stage(&mut row, stage);
    }
    row.add_known("bytes", count(case.bytes));
    row.add_known("bytes_floor", count(case.bytes_floor));
    for (name, &value) in &case.counters {
        row.add(name, value);
    }
    row.add_known("covered_pixels", case.covered_pixels);
    row.add_known("fragments_a_pixel", case.fragments_a_pixel);
    row.add_known("gpu_memory_bytes", count(case.gpu_memory_bytes));
    row.add_known("gpu_memory_used_bytes", count(case.gpu_memory_used_bytes));
    if let Some(error) = &case.error {
        row.add_error(error);
    }
    if let Some(flicker) = &case.flicker {
        row.add_flicker(flicker);
    }
    row
}

fn add_stage(row: &mut TableRow, stage: &StageReport) {
    let name = |suffix: &str| format!("{}_{suffix}", stage.name);
    let count = |count: Option<u64>| count.map(|count| count as f64);
    row.add(name("ran"), stage.ran);
    row.add_known(name("ms_median"), stage.ms.map(|ms| ms.median));
    row.add_known(name("bytes"), count(stage.bytes));
    row.add_known(name("bytes_floor"), count(stage.bytes_floor));
    row.add_known(name("operations"), count(stage.operations));
    row.add_known(name("operations_floor"), count(stage.operations_floor));
}

fn point_row(case: &str, point: &SweepPoint) -> TableRow {
    let mut row = TableRow::new(case, &point.parameter, &point.value);
    row.add("frame_ms_measured", point.measured_ms);
    row.add("time_ratio", point.time_ratio);
    row.add("time_ratio_low", point.time_ratio_range[0]);
    row.add("time_ratio_high", point.time_ratio_range[1]);
    row.add("frame_ms", point.frame_ms);
    row.add_known("gpu_ms_mean", point.gpu_ms);
    for (name, &value) in &point.counters {
        row.add(name, value);
    }
    row.add_error(&point.error);
    if let Some(flicker) = &point.flicker {
        row.add_flicker(flicker);
    }
    row.add("on_front", f64::from(u8::from(point.on_front)));
    row
}

/// The rows under a header with all names. The cell of a number that a row lacks is empty.
///
/// # Errors
/// When a row can't be encoded.
pub fn csv(rows: &[TableRow]) -> csv::Result<Vec<u8>> {
    let mut names: Vec<&str> = Vec::new();
    for cell in rows.iter().flat_map(|row| &row.cells) {
        if !names.contains(&cell.name.as_str()) {
            names.push(&cell.name);
        }
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = vec!["case", "parameter", "value"];
    header.extend(&names);
    writer.write_record(header)?;
    for row in rows {
        let mut record = vec![row.case.clone(), row.parameter.clone(), row.value.clone()];
        for name in &names {
            let value = row.get(name).map(|value| value.to_string());
            record.push(value.unwrap_or_default());
        }
        writer.write_record(record)?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_reads_back_as_it_was_written() {
        let row = |case: &str, value: &str, cells: &[(&str, f64)]| {
            let mut row = TableRow::new(case, "a, \"quoted\" parameter", value);
            for &(name, value) in cells {
                row.add(name, value);
            }
            row
        };
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
        let names: Vec<String> = reader
            .headers()
            .expect("there is a first line")
            .iter()
            .map(str::to_owned)
            .collect();
        assert_eq!(
            names,
            ["case", "parameter", "value", "frame_ms", "psnr_db", "drawn"]
        );
        for (record, row) in reader.records().zip(&rows) {
            let record = record.expect("as many cells as names");
            assert_eq!(
                [&record[0], &record[1], &record[2]],
                [&row.case, &row.parameter, &row.value]
            );
            for (name, cell) in names.iter().zip(&record).skip(3) {
                assert_eq!(row.get(name), cell.parse().ok(), "{name}");
            }
        }
    }
}
