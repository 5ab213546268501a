//! The chart of error and time against an avatar's size in the image. In: measurements of the cases
//! in which it is some pixels tall. Out: an SVG's text or a PNG's bytes.

use super::{
    case::BenchCase,
    report::{BenchReport, CaseReport},
};
use crate::chart::{self, Area, Axes, Chart, ChartError, Title, drawing_error};
use plotters::{chart::SeriesLabelPosition, prelude::*};

/// Width and height, px.
const SIZE: (u32, u32) = (1000, 900);
/// Height of text, px.
const TEXT: u32 = 18;
/// A colour for each measurement.
const COLORS: [RGBColor; 4] = [
    RGBColor(31, 119, 180),
    RGBColor(208, 52, 44),
    RGBColor(44, 160, 44),
    RGBColor(148, 103, 189),
];

/// A measurement and its name in the chart.
pub struct NamedReport<'a> {
    /// What tells it apart from the others.
    pub name: &'a str,
    /// What was measured.
    pub report: &'a BenchReport,
}

/// The chart as an SVG.
///
/// # Errors
/// [`ChartError::Nothing`] if no case of any report has a size.
pub fn svg(reports: &[NamedReport], title: &str) -> Result<String, ChartError> {
    chart::svg(&SizeChart { reports, title })
}

/// The chart as a PNG.
///
/// # Errors
/// See [`svg`].
pub fn png(reports: &[NamedReport], title: &str) -> Result<Vec<u8>, ChartError> {
    chart::png(&SizeChart { reports, title })
}

struct SizeChart<'a> {
    reports: &'a [NamedReport<'a>],
    title: &'a str,
}

/// Height of an avatar in the image, px, as its logarithm to base 2, and a value there.
type Line = Vec<(f64, f64)>;

impl SizeChart<'_> {
    /// A line for each report: a value of its cases against the height.
    fn lines(&self, value: fn(&CaseReport) -> Option<f64>) -> Vec<Line> {
        let line = |named: &NamedReport| {
            let point = |own: &CaseReport| {
                let tall = own.name.parse::<BenchCase>().ok()?.tall()?;
                Some((tall.log2(), value(own).filter(|value| value.is_finite())?))
            };
            let sized = |own: &&CaseReport| own.name != BenchCase::Crowd.name();
            let mut line: Line = named
                .report
                .cases
                .iter()
                .filter(sized)
                .filter_map(point)
                .collect();
            line.sort_by(|a, b| a.0.total_cmp(&b.0));
            line
        };
        self.reports.iter().map(line).collect()
    }

    /// Draws lines, with their names if there is a place for them.
    fn panel<B: DrawingBackend>(
        &self,
        area: &Area<B>,
        lines: &[Line],
        y: &str,
        names: Option<SeriesLabelPosition>,
    ) -> Result<(), ChartError> {
        let all = || lines.iter().flatten();
        let range = |of: fn(&(f64, f64)) -> f64| {
            let min = all().map(of).reduce(f64::min).ok_or(ChartError::Nothing)?;
            let max = all().map(of).reduce(f64::max).ok_or(ChartError::Nothing)?;
            Ok((min, max))
        };
        let (left, right) = range(|point| point.0)?;
        let (_, top) = range(|point| point.1)?;
        let mut chart = ChartBuilder::on(area)
            .margin(16)
            .x_label_area_size(50)
            .y_label_area_size(64)
            .build_cartesian_2d(left - 0.2..right + 0.2, 0.0..1.08 * top)
            .map_err(drawing_error)?;
        let tall = |value: &f64| format!("{:.0}", value.exp2());
        let axes = Axes {
            x: Some("height of the avatar in the image, px"),
            y: Some(y),
            text_height: TEXT,
            x_label: Some(&tall),
            ..Axes::default()
        };
        axes.draw(&mut chart)?;
        for ((line, named), color) in lines.iter().zip(self.reports).zip(COLORS.iter().cycle()) {
            chart::draw_line(&mut chart, line, *color, named.name)?;
            let dots = line.iter().map(|&at| Circle::new(at, 4, color.filled()));
            chart.draw_series(dots).map_err(drawing_error)?;
        }
        match names {
            Some(position) => chart::draw_legend(&mut chart, position, TEXT),
            None => Ok(()),
        }
    }
}

impl Chart for SizeChart<'_> {
    fn size(&self) -> (u32, u32) {
        SIZE
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), ChartError> {
        let title = Title {
            text: self.title,
            text_height: 22,
            above: 12,
            below: 0,
        };
        let below = title.draw(area)?;
        let (_, height) = below.dim_in_pixel();
        let (upper, lower) = below.split_vertically(height / 2);
        let errors = self.lines(|own| own.error.as_ref()?.psnr_db);
        self.panel(
            &upper,
            &errors,
            "PSNR over covered pixels, dB",
            Some(SeriesLabelPosition::LowerRight),
        )?;
        let times = self.lines(|own| Some(own.frame_ms.mean));
        self.panel(&lower, &times, "frame, ms", None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_needs_a_case_with_a_height() {
        assert!(matches!(svg(&[], "nothing"), Err(ChartError::Nothing)));
        assert!(matches!(png(&[], "nothing"), Err(ChartError::Nothing)));
    }
}
