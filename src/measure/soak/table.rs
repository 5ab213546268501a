//! A soak's seconds as comma-separated values.

use super::report::Report;
use std::io;

/// A line a second; what is not known is an empty cell.
pub fn csv(report: &Report) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for second in &report.each {
        writer.serialize(second).map_err(io::Error::other)?;
    }
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{soak::verdict::tests::report, thermals::Recorded};

    #[test]
    fn a_line_a_second_that_can_be_played_back() -> io::Result<()> {
        let text = String::from_utf8(csv(&report())?).map_err(io::Error::other)?;
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.len() == 61 && lines[0].starts_with("seconds,frames,fps,frame_ms_p50,"), "{}", lines[0]);
        assert!(lines.iter().all(|line| line.matches(',').count() == lines[0].matches(',').count()));
        assert_eq!(Recorded::read(&text).map(|recorded| recorded.at(30.5)), Ok(Some(0.5)));
        Ok(())
    }
}
