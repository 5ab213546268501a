//! The files of a soak: a report goes in; JSON, CSV and the chart as SVG and PNG come out, under one name.

use super::{Report, plot, table};
use anyhow::Context;
use std::path::{Path, PathBuf};

/// Writes all of them, and says where they are. `out`: their name without the endings.
pub fn write(report: &Report, out: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let mut files = vec![("json", (serde_json::to_string_pretty(report)? + "\n").into_bytes()), ("csv", table::csv(report)?)];
    // Of a run that ended in its first second there is nothing to draw.
    if !report.each.is_empty() {
        files.push(("svg", plot::svg(report)?.into_bytes()));
        files.push(("png", plot::png(report)?));
    }
    let write = |(ending, bytes): (&str, Vec<u8>)| {
        let mut path = out.as_os_str().to_owned();
        path.push(format!(".{ending}"));
        let path = PathBuf::from(path);
        std::fs::write(&path, bytes).with_context(|| format!("{} can't be written", path.display()))?;
        Ok(path)
    };
    files.into_iter().map(write).collect()
}
