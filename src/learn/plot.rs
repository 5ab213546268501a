//! Line charts of a fit and its analysis, as an SVG's text or a PNG's bytes.

use effigy_measure::chart::{Area, FAINT, FONT, INK, drawing_error};
pub use effigy_measure::chart::{Chart, ChartError, png, svg};
use plotters::prelude::*;
use std::ops::Range;

/// Width and height, px.
const SIZE: (u32, u32) = (1000, 640);
const COLORS: [RGBColor; 6] = [
    RGBColor(31, 119, 180),
    RGBColor(255, 127, 14),
    RGBColor(44, 160, 44),
    RGBColor(208, 52, 44),
    RGBColor(148, 103, 189),
    RGBColor(127, 127, 127),
];

/// A named line.
#[derive(Clone, Debug)]
pub struct PlotLine {
    /// The name in the legend.
    pub name: String,
    /// x and y of each point.
    pub points: Vec<(f64, f64)>,
}

/// Lines over one pair of axes.
#[derive(Clone, Debug)]
pub struct Plot<'a> {
    /// Above the chart.
    pub title: &'a str,
    /// The label of the x axis.
    pub x: &'a str,
    /// The label of the y axis.
    pub y: &'a str,
    /// Whether the y axis is logarithmic.
    pub log: bool,
    /// Each in a colour of its own.
    pub lines: Vec<PlotLine>,
}

impl Chart for Plot<'_> {
    fn size(&self) -> (u32, u32) {
        SIZE
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), ChartError> {
        let height = |y: f64| if self.log { y.max(1e-12).log10() } else { y };
        let points = || self.lines.iter().flat_map(|line| &line.points);
        let xs = range(points().map(|p| p.0)).ok_or(ChartError::Nothing)?;
        let ys = range(points().map(|p| height(p.1))).ok_or(ChartError::Nothing)?;
        let margin = 0.06 * (ys.end - ys.start);
        let below = area
            .margin(12, 4, 0, 0)
            .titled(self.title, TextStyle::from((FONT, 22)).color(&INK))
            .map_err(drawing_error)?;
        let mut built = ChartBuilder::on(&below)
            .margin(14)
            .x_label_area_size(50)
            .y_label_area_size(76)
            .build_cartesian_2d(xs, ys.start - margin..ys.end + margin)
            .map_err(drawing_error)?;
        let label = TextStyle::from((FONT, 16)).color(&INK);
        built
            .configure_mesh()
            .x_desc(self.x)
            .y_desc(self.y)
            .y_label_formatter(&|y| {
                if self.log {
                    short(10f64.powf(*y))
                } else {
                    short(*y)
                }
            })
            .axis_desc_style(label.clone())
            .label_style(label.clone())
            .light_line_style(TRANSPARENT)
            .bold_line_style(FAINT)
            .draw()
            .map_err(drawing_error)?;
        for (line, &color) in self.lines.iter().zip(COLORS.iter().cycle()) {
            let points: Vec<_> = line.points.iter().map(|&(x, y)| (x, height(y))).collect();
            // Segment by segment: a sharp corner of a single path would be drawn as a long spike.
            built
                .draw_series(
                    points
                        .windows(2)
                        .map(|piece| PathElement::new(piece.to_vec(), color.stroke_width(2))),
                )
                .map_err(drawing_error)?
                .label(&line.name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 18, y)], color.stroke_width(2))
                });
            built
                .draw_series(
                    points
                        .iter()
                        .map(|&point| Circle::new(point, 3, color.filled())),
                )
                .map_err(drawing_error)?;
        }
        built
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .label_font(label)
            .background_style(WHITE.mix(0.85))
            .border_style(FAINT)
            .draw()
            .map_err(drawing_error)
    }
}

/// From the smallest to the largest number, at least 1 wide where they are equal; `None` without
/// finite ends.
fn range(numbers: impl Iterator<Item = f64>) -> Option<Range<f64>> {
    let mut low = f64::INFINITY;
    let mut high = f64::NEG_INFINITY;
    for number in numbers {
        low = low.min(number);
        high = high.max(number);
    }
    let end = if high > low { high } else { low + 1.0 };
    (low.is_finite() && high.is_finite()).then_some(low..end)
}

/// A number with three significant digits.
fn short(value: f64) -> String {
    let digits = (2 - value.abs().max(1e-12).log10().floor() as i32).clamp(0, 6);
    format!("{value:.*}", digits.unsigned_abs() as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_draw_and_name_their_lines() -> Result<(), ChartError> {
        let line = |name: &str, by: f64| PlotLine {
            name: name.into(),
            points: (1..9).map(|k| (f64::from(k), by / f64::from(k))).collect(),
        };
        let mut chart = Plot {
            title: "a title",
            x: "along",
            y: "up",
            log: true,
            lines: vec![line("first", 1.0), line("second", 30.0)],
        };
        let text = svg(&chart)?;
        for name in ["a title", "along", "up", "first", "second"] {
            assert!(text.contains(name), "{name} is missing");
        }
        let image = image::load_from_memory(&png(&chart)?)
            .map_err(drawing_error)?
            .to_rgb8();
        for color in &COLORS[..2] {
            let pixels = image
                .pixels()
                .filter(|pixel| pixel.0 == [color.0, color.1, color.2])
                .count();
            assert!(pixels > 100, "{color:?}: {pixels} pixels");
        }
        chart.lines.clear();
        assert!(matches!(svg(&chart), Err(ChartError::Nothing)));
        Ok(())
    }
}
