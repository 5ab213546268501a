//! The chart of a soak.

use super::report::{Second, SoakReport};
use crate::{
    chart::{Axis, BLUE, Chart, ChartError, Corner, GREEN, GREY, Line, LineStyle, Panel, RED, Rgb},
    report::chart_title,
};

/// Colour of the headroom.
const HEAT: Rgb = Rgb(235, 120, 20);

/// The frame rate over the minutes against the promised one; below it the governor's steps and the
/// headroom used.
///
/// # Errors
/// [`ChartError::Nothing`] for a run that ended in its first second.
pub fn chart(report: &SoakReport) -> Result<Chart, ChartError> {
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
    let mut lines = vec![Line::new(step, GREEN, LineStyle::Steps, rungs)];
    if is_hot {
        let name = "headroom used: 1 is where the clock is taken away";
        let line = Line {
            on_right: true,
            ..Line::new(name, HEAT, LineStyle::Solid, headroom)
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
                    Line::new(
                        promise,
                        GREY,
                        LineStyle::Thin,
                        vec![(0.0, rate), (end, rate)],
                    ),
                    Line::new(drawn, BLUE, LineStyle::Solid, rates),
                    Line::new(drops, RED, LineStyle::Dots, dropped),
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
