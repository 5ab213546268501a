//! A soak's seconds as comma-separated values.

use super::report::SoakReport;
use std::io;

/// A header and a line for each second. Unknown values are empty cells.
///
/// # Errors
/// When a line can't be encoded.
pub fn csv(report: &SoakReport) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for second in &report.each {
        writer.serialize(second).map_err(io::Error::other)?;
    }
    writer
        .into_inner()
        .map_err(|error| io::Error::other(error.to_string()))
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
        assert_eq!(lines.len(), 61);
        let header = lines[0];
        assert!(
            header.starts_with("seconds,frames,fps,frame_ms_p50,"),
            "{header}"
        );
        let commas = |line: &str| line.matches(',').count();
        assert!(lines.iter().all(|line| commas(line) == commas(header)));
        let recorded = Recorded::read(&text).map(|recorded| recorded.at(30.5));
        assert_eq!(recorded, Ok(Some(0.5)));
        Ok(())
    }
}
