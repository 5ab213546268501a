//! The files that a benchmark writes: JSON, CSV, and the chart of a sweep.

use crate::files::{self, ChartFile};
use effigy_measure::{
    bench::{BenchReport, plot, table},
    report::chart_title,
};
use image::{ImageFormat, RgbImage};
use std::{
    io::Cursor,
    path::{Path, PathBuf},
};

/// Where JSON goes.
#[derive(Clone, Debug)]
pub enum JsonOutput {
    Stdout,
    File(PathBuf),
}

impl JsonOutput {
    pub fn is_stdout(&self) -> bool {
        matches!(self, Self::Stdout)
    }
}

/// Reads `-` or the name of a .json: the value is optional, so that `bench --json body.avatar`
/// names an avatar, which must not be overwritten.
pub fn json(text: &str) -> Result<JsonOutput, String> {
    if text == "-" {
        return Ok(JsonOutput::Stdout);
    }
    files::json_path(text)
        .map(JsonOutput::File)
        .map_err(|error| format!("{error}; for the standard output write `--json -`"))
}

/// Reads the name of a .png.
pub fn png(text: &str) -> Result<PathBuf, String> {
    match files::chart(text)? {
        ChartFile::Png(path) => Ok(path),
        ChartFile::Svg(_) => Err(format!("`{text}` does not end in .png")),
    }
}

/// Writes an image as a .png.
pub fn save_png(path: &Path, image: &RgbImage) -> anyhow::Result<()> {
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, ImageFormat::Png)?;
    files::write(path, bytes.into_inner())
}

/// Writes what is measured so far, if JSON goes to a file: it is not lost if the program is stopped.
pub fn keep(report: &BenchReport, json: Option<&JsonOutput>) -> anyhow::Result<()> {
    match json {
        Some(JsonOutput::File(path)) => files::write_json(path, report),
        _ => Ok(()),
    }
}

/// Writes the files that were asked for, and prints their names unless the JSON goes to the
/// standard output.
pub fn write(
    report: &BenchReport,
    json: Option<&JsonOutput>,
    csv: Option<&Path>,
    charts: &[ChartFile],
) -> anyhow::Result<()> {
    let quiet = json.is_some_and(JsonOutput::is_stdout);
    let save = |path: &Path, bytes: &[u8]| -> anyhow::Result<()> {
        files::write(path, bytes)?;
        if !quiet {
            println!("wrote {}", path.display());
        }
        Ok(())
    };
    if let Some(sweep) = &report.sweep {
        let title = chart_title(&report.avatar, report.size, &report.device);
        for chart in charts {
            match chart {
                ChartFile::Svg(path) => save(path, plot::svg(sweep, &title)?.as_bytes())?,
                ChartFile::Png(path) => save(path, &plot::png(sweep, &title)?)?,
            }
        }
    }
    if let Some(path) = csv {
        save(path, &table::csv(&table::rows(report))?)?;
    }
    let Some(json) = json else {
        return Ok(());
    };
    let text = serde_json::to_string_pretty(report)? + "\n";
    match json {
        JsonOutput::File(path) => save(path, text.as_bytes()),
        JsonOutput::Stdout => {
            print!("{text}");
            Ok(())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_is_a_json_file_or_the_standard_output() {
        assert!(matches!(json("out/a.JSON"), Ok(JsonOutput::File(_))));
        assert!(matches!(json("-"), Ok(JsonOutput::Stdout)));
        assert!(json("body.avatar").is_err_and(|error| error.contains("body.avatar")));
    }

    #[test]
    fn charts_are_svg_or_png() {
        assert!(matches!(files::chart("a.svg"), Ok(ChartFile::Svg(_))));
        assert!(matches!(files::chart("a.PNG"), Ok(ChartFile::Png(_))));
        assert!(files::chart("front").is_err());
    }
}
