//! The chart of a soak: the frame rate over the minutes against the promised one; below it the
//! governor's steps and the headroom used. In: a report. Out: an SVG's text or a PNG's bytes.

use super::report::SoakReport;
use crate::{
    chart::{
        self, Area, Axes, Chart, ChartError, Title, draw_legend, draw_line, drawing_error,
        legend_line, staircase, text_style,
    },
    report::chart_title,
};
use plotters::{chart::SeriesLabelPosition, prelude::*};

/// Width and height, px.
const SIZE: (u32, u32) = (1200, 800);
const TEXT_HEIGHT: u32 = 16;
const RATE: RGBColor = RGBColor(31, 119, 180);
const PROMISE: RGBColor = RGBColor(120, 124, 130);
const DROPPED: RGBColor = RGBColor(208, 52, 44);
const STEPS: RGBColor = RGBColor(44, 160, 44);
const HEAT: RGBColor = RGBColor(235, 120, 20);

/// The chart as an SVG.
///
/// # Errors
/// [`ChartError::Nothing`] if the run ended in its first second.
pub fn svg(report: &SoakReport) -> Result<String, ChartError> {
    chart::svg(&SoakChart { report })
}

/// The chart as a PNG.
///
/// # Errors
/// See [`svg`].
pub fn png(report: &SoakReport) -> Result<Vec<u8>, ChartError> {
    chart::png(&SoakChart { report })
}

struct SoakChart<'a> {
    report: &'a SoakReport,
}

impl Chart for SoakChart<'_> {
    fn size(&self) -> (u32, u32) {
        SIZE
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), ChartError> {
        let report = self.report;
        let end = report.each.last().ok_or(ChartError::Nothing)?.seconds / 60.0;
        let title = Title {
            text: &chart_title(&report.avatar, report.size, &report.device),
            text_height: 22,
            above: 14,
            below: 6,
        };
        let below = title.draw(area)?;
        let (upper, lower) = below.split_vertically((SIZE.1 - 60) * 3 / 5);
        draw_rates(&upper, report, end)?;
        draw_steps(&lower, report, end)
    }
}

/// Frame rates, up to minute `end`.
fn draw_rates<B: DrawingBackend>(
    area: &Area<B>,
    report: &SoakReport,
    end: f64,
) -> Result<(), ChartError> {
    let rates = report.each.iter().map(|second| second.fps);
    let highest = rates.fold(report.rate, f64::max);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .x_label_area_size(34)
        .y_label_area_size(70)
        .margin_right(82)
        .build_cartesian_2d(0.0..end, 0.0..1.4 * highest)
        .map_err(drawing_error)?;
    let axes = Axes {
        y: Some("frames a second"),
        text_height: TEXT_HEIGHT,
        ..Axes::default()
    };
    axes.draw(&mut chart)?;
    chart
        .draw_series(LineSeries::new(
            [(0.0, report.rate), (end, report.rate)],
            PROMISE.stroke_width(1),
        ))
        .map_err(drawing_error)?
        .label(format!("promised: {}", report.rate))
        .legend(legend_line(PROMISE, 1));
    let points: Vec<_> = report
        .each
        .iter()
        .map(|second| (second.seconds / 60.0, second.fps))
        .collect();
    let name = format!("drawn: {:.1} on average", report.fps);
    draw_line(&mut chart, &points, RATE, name)?;
    let with_drops = report.each.iter().filter(|second| second.dropped > 0);
    let circles = with_drops
        .map(|second| Circle::new((second.seconds / 60.0, second.fps), 3, DROPPED.filled()));
    chart
        .draw_series(circles)
        .map_err(drawing_error)?
        .label(format!(
            "seconds with dropped refreshes: {} in all",
            report.dropped
        ))
        .legend(|(x, y)| Circle::new((x + 9, y), 3, DROPPED.filled()));
    draw_legend(&mut chart, SeriesLabelPosition::UpperLeft, TEXT_HEIGHT)
}

/// The governor's steps and the headroom used, up to minute `end`.
fn draw_steps<B: DrawingBackend>(
    area: &Area<B>,
    report: &SoakReport,
    end: f64,
) -> Result<(), ChartError> {
    let last = report.ladder.len().max(2) as f64 - 1.0;
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(70)
        .right_y_label_area_size(70)
        .build_cartesian_2d(0.0..end, -0.5..1.35 * last)
        .map_err(drawing_error)?
        .set_secondary_coord(0.0..end, 0.0..1.4);
    let axes = Axes {
        x: Some("minutes"),
        y: Some("governor's step"),
        text_height: TEXT_HEIGHT,
        y_label_count: Some(report.ladder.len().min(12)),
        y_label: Some(&|step| format!("{step:.0}")),
        ..Axes::default()
    };
    axes.draw(&mut chart)?;
    if report.each.iter().any(|second| second.headroom.is_some()) {
        chart
            .configure_secondary_axes()
            .y_desc("headroom used")
            .axis_desc_style(text_style(TEXT_HEIGHT))
            .label_style(text_style(TEXT_HEIGHT))
            .draw()
            .map_err(drawing_error)?;
        let headroom = report
            .each
            .iter()
            .filter_map(|second| Some((second.seconds / 60.0, second.headroom?.min(1.2))));
        chart
            .draw_secondary_series(LineSeries::new(headroom, HEAT.stroke_width(2)))
            .map_err(drawing_error)?
            .label("headroom used: 1 is where the clock is taken away")
            .legend(legend_line(HEAT, 2));
    }
    let name = if report.governed {
        "governor's step"
    } else {
        "the governor is off"
    };
    let rungs = report
        .each
        .iter()
        .map(|second| (second.seconds / 60.0, second.rung as f64));
    chart
        .draw_series(LineSeries::new(staircase(rungs), STEPS.stroke_width(2)))
        .map_err(drawing_error)?
        .label(name)
        .legend(legend_line(STEPS, 2));
    draw_legend(&mut chart, SeriesLabelPosition::UpperLeft, TEXT_HEIGHT)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{chart::tests::pixels_of_color, soak::faults::tests::report};

    #[test]
    fn the_chart_names_its_lines() -> Result<(), ChartError> {
        let mut report = report();
        report.each[20].dropped = 3;
        let text = svg(&report)?;
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
        let png = png(&report)?;
        for color in [RATE, STEPS, HEAT, DROPPED] {
            let pixels = pixels_of_color(&png, color);
            assert!(pixels > 10, "{color:?}: {pixels} pixels");
        }
        report.each.clear();
        assert!(matches!(svg(&report), Err(ChartError::Nothing)));
        Ok(())
    }
}
