//! The files of a soak: a report goes in; JSON, CSV and the chart as SVG and PNG come out, under
//! one name.

use super::{plot, report::SoakReport, table};
use anyhow::Context;
use effigy_core::io::file::write_whole;
use std::path::{Path, PathBuf};

/// The endings of the files.
pub const ENDINGS: [&str; 4] = ["json", "csv", "svg", "png"];

/// The path of one of the files. `out` is its path without the ending.
pub fn path(out: &Path, ending: &str) -> PathBuf {
    let mut path = out.as_os_str().to_owned();
    path.push(format!(".{ending}"));
    path.into()
}

/// Writes all files and returns their paths. `out` is their path without an ending.
///
/// # Errors
/// When a file can't be written or the chart can't be drawn.
pub fn write_report(report: &SoakReport, out: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let json = serde_json::to_string_pretty(report)? + "\n";
    let mut paths = vec![
        write_file(out, "json", json.as_bytes())?,
        write_file(out, "csv", &table::csv(report)?)?,
    ];
    // A run that ended in its first second has nothing to draw.
    if !report.each.is_empty() {
        paths.push(write_file(out, "svg", plot::svg(report)?.as_bytes())?);
        paths.push(write_file(out, "png", &plot::png(report)?)?);
    }
    Ok(paths)
}

fn write_file(out: &Path, ending: &str, bytes: &[u8]) -> anyhow::Result<PathBuf> {
    let path = path(out, ending);
    write_whole(&path, bytes).with_context(|| format!("{} can't be written", path.display()))?;
    Ok(path)
}
