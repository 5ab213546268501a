//! The files of a soak: a report goes in; JSON and CSV come out, and the chart as SVG and PNG where
//! charts are built in, under one name.

use super::report::SoakReport;
use anyhow::Context;
use effigy_core::io::file::write_whole;
use std::{
    io,
    path::{Path, PathBuf},
};

/// The endings of the files.
pub const ENDINGS: &[&str] = if cfg!(feature = "charts") {
    &["json", "csv", "svg", "png"]
} else {
    &["json", "csv"]
};

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
    let mut paths = Vec::new();
    for &ending in ENDINGS {
        let bytes = match ending {
            "json" => (serde_json::to_string_pretty(report)? + "\n").into_bytes(),
            #[cfg(feature = "charts")]
            "svg" | "png" if report.each.is_empty() => continue,
            #[cfg(feature = "charts")]
            "svg" | "png" => super::chart::chart(report)?.encoded(ending)?,
            _ => csv(report)?,
        };
        let path = path(out, ending);
        write_whole(&path, &bytes)
            .with_context(|| format!("{} can't be written", path.display()))?;
        paths.push(path);
    }
    Ok(paths)
}

/// A header and a line for each second. Unknown values are empty cells.
fn csv(report: &SoakReport) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for second in &report.each {
        writer.serialize(second)?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soak::faults::tests::report;
    use effigy_runtime::thermals::Recorded;

    #[test]
    fn every_second_is_a_line_that_can_be_replayed() -> io::Result<()> {
        let text = String::from_utf8(csv(&report())?).map_err(io::Error::other)?;
        let lines: Vec<&str> = text.lines().collect();
        let header = "seconds,frames,fps,frame_ms_p50,";
        assert!(lines.len() == 61 && lines[0].starts_with(header), "{text}");
        let commas = |line: &str| line.matches(',').count();
        assert!(lines.iter().all(|line| commas(line) == commas(lines[0])));
        let recorded = Recorded::read(&text).map(|recorded| recorded.at(30.5));
        assert_eq!(recorded, Ok(Some(0.5)));
        Ok(())
    }
}
