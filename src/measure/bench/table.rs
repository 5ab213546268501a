//! A report as rows of named numbers: what the CSV holds, and what two reports are compared by.

use super::report::{CaseReport, ErrorReport, Point, Report};

/// The numbers of one case, or of one point of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub case: String,
    /// Of a sweep's point; empty otherwise.
    pub knob: String,
    pub value: String,
    /// Name and number. A number that is known to be infinite is so here too; unknown ones are left out.
    pub cells: Vec<(String, f64)>,
}

impl Row {
    /// What row it is, in words.
    pub fn title(&self) -> String {
        [&self.case, &self.knob, &self.value].into_iter().filter(|word| !word.is_empty()).cloned().collect::<Vec<_>>().join(" ")
    }

    pub fn get(&self, name: &str) -> Option<f64> {
        self.cells.iter().find(|cell| cell.0 == name).map(|cell| cell.1)
    }
}

/// Cases first, then the sweep's points.
pub fn rows(report: &Report) -> Vec<Row> {
    let cases = report.cases.iter().map(case);
    let points = report.sweep.iter().flat_map(|sweep| sweep.points.iter().map(|at| point(&sweep.case, at)));
    cases.chain(points).collect()
}

fn case(case: &CaseReport) -> Row {
    let mut cells = vec![("frames".to_owned(), case.frames as f64)];
    let mut add = |name: &str, value: f64| cells.push((name.to_owned(), value));
    let spread = case.frame_ms;
    let times = [("mean", spread.mean), ("median", spread.median), ("p5", spread.p5), ("p95", spread.p95), ("p99", spread.p99)];
    times.into_iter().for_each(|(name, ms)| add(&format!("frame_ms_{name}"), ms));
    add("fps", case.fps);
    if let Some(gpu) = case.gpu_ms {
        add("gpu_ms_median", gpu.median);
        add("gpu_ms_p95", gpu.p95);
    }
    for stage in &case.stages {
        let [bytes, floor] = [stage.bytes, stage.bytes_floor];
        let optional =
            [("bytes", bytes), ("bytes_floor", floor), ("operations", stage.operations), ("operations_floor", stage.operations_floor)];
        add(&format!("{}_ran", stage.name), stage.ran);
        stage.ms.into_iter().for_each(|ms| add(&format!("{}_ms_median", stage.name), ms.median));
        optional.into_iter().for_each(|(name, count)| count.into_iter().for_each(|n| add(&format!("{}_{name}", stage.name), n as f64)));
    }
    case.bytes.into_iter().for_each(|bytes| add("bytes", bytes as f64));
    case.bytes_floor.into_iter().for_each(|bytes| add("bytes_floor", bytes as f64));
    case.counters.iter().for_each(|(name, &count)| add(name, count));
    let optional = [("covered_pixels", case.covered_pixels), ("fragments_a_pixel", case.fragments_a_pixel)];
    optional.into_iter().for_each(|(name, value)| value.into_iter().for_each(|value| add(name, value)));
    case.gpu_memory_bytes.into_iter().for_each(|bytes| add("gpu_memory_bytes", bytes as f64));
    case.gpu_memory_used_bytes.into_iter().for_each(|bytes| add("gpu_memory_used_bytes", bytes as f64));
    case.error.iter().for_each(|error| self::error(error, &mut add));
    Row { case: case.name.clone(), knob: String::new(), value: String::new(), cells }
}

fn point(case: &str, point: &Point) -> Row {
    let mut cells = Vec::new();
    let mut add = |name: &str, value: f64| cells.push((name.to_owned(), value));
    add("frame_ms_measured", point.measured_ms);
    add("time_ratio", point.time_ratio);
    add("time_ratio_low", point.time_ratio_range[0]);
    add("time_ratio_high", point.time_ratio_range[1]);
    add("frame_ms", point.frame_ms);
    point.gpu_ms.into_iter().for_each(|ms| add("gpu_ms_mean", ms));
    point.counters.iter().for_each(|(name, &count)| add(name, count));
    error(&point.error, &mut add);
    add("on_front", f64::from(u8::from(point.on_front)));
    Row { case: case.to_owned(), knob: point.knob.clone(), value: point.value.clone(), cells }
}

fn error(error: &ErrorReport, add: &mut impl FnMut(&str, f64)) {
    if error.frames == 0 {
        return;
    }
    add("checked_frames", error.frames as f64);
    add("psnr_db", error.psnr_db.unwrap_or(f64::INFINITY));
    add("max_error", error.max_error);
    add("within_tolerance", error.within_tolerance);
    add("psnr_db_whole", error.psnr_db_whole.unwrap_or(f64::INFINITY));
    add("max_error_whole", error.max_error_whole);
    error.flip.into_iter().for_each(|flip| add("flip", flip));
}

/// The rows with a line of names above them; a cell that a row lacks is empty.
pub fn csv(rows: &[Row]) -> csv::Result<Vec<u8>> {
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in rows.iter().flat_map(|row| &row.cells) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["case", "knob", "value"].into_iter().chain(names.iter().copied()))?;
    for row in rows {
        let cells = names.iter().map(|name| row.get(name).map_or(String::new(), |value| value.to_string()));
        writer.write_record([&row.case, &row.knob, &row.value].into_iter().cloned().chain(cells))?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_reads_back_as_it_was_written() {
        let row = |case: &str, value: &str, cells: &[(&str, f64)]| Row {
            case: case.to_owned(),
            knob: "a, \"quoted\" knob".to_owned(),
            value: value.to_owned(),
            cells: cells.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect(),
        };
        let rows = [
            row("full", "1/255", &[("frame_ms", 0.1 + 0.2), ("psnr_db", f64::INFINITY)]),
            row("far", "", &[("drawn", 1e9), ("frame_ms", 3e-7)]),
        ];
        let bytes = csv(&rows).expect("plain numbers");
        let mut reader = csv::Reader::from_reader(bytes.as_slice());
        let names: Vec<String> = reader.headers().expect("there is a first line").iter().map(str::to_owned).collect();
        assert_eq!(names, ["case", "knob", "value", "frame_ms", "psnr_db", "drawn"]);
        for (record, row) in reader.records().zip(&rows) {
            let record = record.expect("as many cells as names");
            assert_eq!([&record[0], &record[1], &record[2]], [&row.case, &row.knob, &row.value]);
            for (name, cell) in names.iter().zip(&record).skip(3) {
                assert_eq!(row.get(name), cell.parse().ok(), "{name}");
            }
        }
    }
}
