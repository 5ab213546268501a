//! The files of a soak: a report goes in; JSON, CSV and the chart as SVG and PNG come out, under
//! one name.

use super::report::{Second, SoakReport};
use crate::{
    chart::{Axis, BLUE, Chart, ChartError, Corner, GREEN, GREY, Line, Panel, RED, Rgb, Style},
    report::chart_title,
};
use anyhow::Context;
use effigy_core::io::file::write_whole;
use std::{
    io,
    path::{Path, PathBuf},
};

/// Colour of the headroom.
const HEAT: Rgb = Rgb(235, 120, 20);

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
    let mut paths = Vec::new();
    for ending in ENDINGS {
        let bytes = match ending {
            "json" => (serde_json::to_string_pretty(report)? + "\n").into_bytes(),
            "csv" => csv(report)?,
            // A run that ended in its first second has nothing to draw.
            _ if report.each.is_empty() => continue,
            _ => chart(report)?.encoded(ending)?,
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

/// The frame rate over the minutes against the promised one; below it the governor's steps and the
/// headroom used.
fn chart(report: &SoakReport) -> Result<Chart, ChartError> {
    let end = report.each.last().ok_or(ChartError::Nothing)?.seconds / 60.0;
    let over_time = |value: fn(&Second) -> Option<f64>| {
        let point = |own: &Second| Some((own.seconds / 60.0, value(own)?));
        report.each.iter().filter_map(point).collect::<Vec<_>>()
    };
    let rate = report.rate;
    let rates = over_time(|own| Some(own.fps));
    let highest = rates.iter().map(|at| at.1).fold(rate, f64::max);
    let promise = format!("promised: {rate}");
    let drawn = format!("drawn: {:.1} on average", report.fps);
    let drops = format!("seconds with dropped refreshes: {} in all", report.dropped);
    let dropped = over_time(|own| (own.dropped > 0).then_some(own.fps));
    let headroom = over_time(|own| Some(own.headroom?.min(1.2)));
    let step = if report.governed {
        "governor's step"
    } else {
        "the governor is off"
    };
    let rungs = over_time(|own| Some(own.rung as f64));
    let last = report.ladder.len().max(2) as f64 - 1.0;
    let mut steps = Axis::new("governor's step", [-0.5, 1.35 * last]);
    steps.most = Some(report.ladder.len().min(12));
    let is_hot = !headroom.is_empty();
    let mut lines = vec![Line::new(step, GREEN, Style::Steps, rungs)];
    if is_hot {
        let name = "headroom used: 1 is where the clock is taken away";
        let line = Line {
            on_right: true,
            ..Line::new(name, HEAT, Style::Solid, headroom)
        };
        lines.insert(0, line);
    }
    Ok(Chart {
        title: chart_title(&report.avatar, report.size, &report.device),
        size: [1200, 800],
        panels: vec![
            Panel {
                share: 0.6,
                lines: vec![
                    Line::new(promise, GREY, Style::Thin, vec![(0.0, rate), (end, rate)]),
                    Line::new(drawn, BLUE, Style::Solid, rates),
                    Line::new(drops, RED, Style::Dots, dropped),
                ],
                legend: Some(Corner::UpperLeft),
                ..Panel::new(
                    Axis::new("", [0.0, end]),
                    Axis::new("frames a second", [0.0, 1.4 * highest]),
                )
            },
            Panel {
                share: 0.4,
                lines,
                right: is_hot.then(|| Axis::new("headroom used", [0.0, 1.4])),
                legend: Some(Corner::UpperLeft),
                ..Panel::new(
                    Axis::new("minutes", [0.0, end]),
                    steps.written(|step| format!("{step:.0}")),
                )
            },
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{chart::tests::pixels_of_color, soak::faults::tests::report};
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

    #[test]
    fn the_chart_names_its_lines() -> Result<(), ChartError> {
        let mut report = report();
        report.each[20].dropped = 3;
        let drawn = chart(&report)?;
        let text = String::from_utf8_lossy(&drawn.encoded("svg")?).into_owned();
        for name in [
            "frames a second",
            "promised: 60",
            "governor",
            "headroom used",
            "minutes",
            "640 × 480",
        ] {
            assert!(text.contains(name), "{name} is missing");
        }
        let png = drawn.encoded("png")?;
        for color in [BLUE, GREEN, HEAT, RED] {
            let pixels = pixels_of_color(&png, color);
            assert!(pixels > 10, "{color:?}: {pixels} pixels");
        }
        report.each.clear();
        assert!(matches!(chart(&report), Err(ChartError::Nothing)));
        Ok(())
    }
}
