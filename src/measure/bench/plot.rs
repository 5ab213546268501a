//! The chart of a sweep: frame time to the right, PSNR upwards, so that the best settings are at
//! the upper left. Each point is named by its parameter and value; the line is the Pareto front.
//! In: a sweep. Out: an SVG's text or a PNG's bytes.

use super::{
    label::{self, Label, Rectangle},
    parameter::Parameter,
    report::{SweepPoint, SweepReport},
    sweep::BASE,
};
use crate::chart::{
    self, Area, Axes, Chart, ChartError, FONT, INK, Title, drawing_error, staircase,
};
use plotters::prelude::*;

/// Width and height, px.
const SIZE: (u32, u32) = (1400, 900);
const FRONT: RGBColor = RGBColor(208, 52, 44);
/// A colour for each parameter, in the order of [`Parameter::ALL`].
static COLORS: [RGBColor; Parameter::ALL.len()] = [
    RGBColor(20, 20, 20),
    RGBColor(31, 119, 180),
    RGBColor(255, 127, 14),
    RGBColor(44, 160, 44),
    RGBColor(148, 103, 189),
    RGBColor(227, 119, 194),
    RGBColor(23, 163, 184),
    RGBColor(150, 150, 20),
    RGBColor(0, 120, 120),
];
/// Range of the PSNR below the best finite one, dB. Points further down are drawn at the lower
/// edge, with their PSNR in their name.
const DEPTH: f64 = 20.0;
/// Height of points without any error above the best finite PSNR, dB.
const PERFECT: f64 = 3.0;

/// The chart as an SVG. `title` says what was measured, and on what.
///
/// # Errors
/// [`ChartError::Nothing`] if no setting was measured to the end.
pub fn svg(sweep: &SweepReport, title: &str) -> Result<String, ChartError> {
    chart::svg(&SweepChart { sweep, title })
}

/// The chart as a PNG.
///
/// # Errors
/// See [`svg`].
pub fn png(sweep: &SweepReport, title: &str) -> Result<Vec<u8>, ChartError> {
    chart::png(&SweepChart { sweep, title })
}

struct SweepChart<'a> {
    sweep: &'a SweepReport,
    title: &'a str,
}

impl Chart for SweepChart<'_> {
    fn size(&self) -> (u32, u32) {
        SIZE
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), ChartError> {
        let points = plotted_points(self.sweep);
        let times = || points.iter().map(|plotted| plotted.point.frame_ms);
        let heights = || points.iter().map(|plotted| plotted.height);
        let (left, right) = range(times(), 0.02).ok_or(ChartError::Nothing)?;
        let (bottom, top) = range(heights(), 0.5).ok_or(ChartError::Nothing)?;
        let title = Title {
            text: self.title,
            text_height: 24,
            above: 14,
            below: 0,
        };
        let below = title.draw(area)?;
        let mut chart = ChartBuilder::on(&below)
            .margin(16)
            .x_label_area_size(56)
            .y_label_area_size(72)
            .build_cartesian_2d(left..right, bottom..top)
            .map_err(drawing_error)?;
        let SweepReport {
            case,
            frames,
            rounds,
            ..
        } = self.sweep;
        let description =
            format!("frame time, ms (case `{case}`, {frames} frames, {rounds} rounds in turn)");
        let axes = Axes {
            x: Some(&description),
            y: Some("PSNR of the worst frame over covered pixels, dB"),
            text_height: 18,
            ..Axes::default()
        };
        axes.draw(&mut chart)?;
        let front = front_line(&points);
        chart
            .draw_series(LineSeries::new(front.clone(), FRONT.stroke_width(2)))
            .map_err(drawing_error)?;
        let plane = chart.plotting_area();
        let places = points
            .iter()
            .map(|plotted| plane.map_coordinate(&(plotted.point.frame_ms, plotted.height)))
            .collect::<Vec<_>>();
        let line = front
            .iter()
            .map(|point| plane.map_coordinate(point))
            .collect::<Vec<_>>();
        let (columns, rows) = plane.get_pixel_range();
        let frame = Rectangle {
            left: columns.start,
            top: rows.start,
            right: columns.end,
            bottom: rows.end,
        };
        draw_points(area, &points, &places, &obstacles(&line), frame)
    }
}

/// A point and how it is drawn.
struct PlottedPoint<'a> {
    point: &'a SweepPoint,
    /// On the axis, dB.
    height: f64,
    name: String,
}

impl PlottedPoint<'_> {
    /// Whether it is the base setting or exact, which are drawn larger.
    fn is_special(&self) -> bool {
        self.point.parameter == BASE || self.point.parameter == Parameter::Exact.name()
    }

    fn color(&self) -> &'static RGBColor {
        let names = Parameter::ALL.map(Parameter::name);
        let index = names.iter().position(|name| *name == self.point.parameter);
        index.map_or(&INK, |index| &COLORS[index])
    }

    fn text_style(&self) -> TextStyle<'static> {
        let height = if self.is_special() { 22 } else { 17 };
        TextStyle::from((FONT, height)).color(self.color())
    }
}

/// The points with a time and an error, in the order in which their names choose their places.
fn plotted_points(sweep: &SweepReport) -> Vec<PlottedPoint<'_>> {
    let mut points: Vec<&SweepPoint> = sweep
        .points
        .iter()
        .filter(|point| point.error.frames > 0 && point.frame_ms.is_finite())
        .collect();
    points.sort_by_key(|point| {
        (
            point.parameter != BASE,
            point.parameter != Parameter::Exact.name(),
            !point.on_front,
        )
    });
    let psnr = points.iter().filter_map(|point| point.error.psnr_db);
    let best = psnr.reduce(f64::max).unwrap_or(0.0);
    let lowest = best - DEPTH;
    points
        .into_iter()
        .map(|point| PlottedPoint {
            point,
            height: point.error.psnr_db.unwrap_or(best + PERFECT).max(lowest),
            name: point_name(point, lowest),
        })
        .collect()
}

/// Parameter and value, and the PSNR of a point that is not drawn at its own height.
fn point_name(point: &SweepPoint, lowest: f64) -> String {
    let title = format!("{} {}", point.parameter, point.value);
    let title = title.trim();
    match point.error.psnr_db {
        None => format!("{title}: no error"),
        Some(psnr) if psnr < lowest => format!("{title}: {psnr:.1} dB"),
        Some(_) => title.to_owned(),
    }
}

/// The Pareto front as a line: for each time, the best of the points that are no slower.
fn front_line(points: &[PlottedPoint]) -> Vec<(f64, f64)> {
    let mut front: Vec<(f64, f64)> = points
        .iter()
        .filter(|plotted| plotted.point.on_front)
        .map(|plotted| (plotted.point.frame_ms, plotted.height))
        .collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    staircase(front.into_iter())
}

/// A line as narrow rectangles.
fn obstacles(line: &[(i32, i32)]) -> Vec<Rectangle> {
    let narrow = |pair: &[(i32, i32)]| Rectangle {
        left: pair[0].0.min(pair[1].0) - 2,
        top: pair[0].1.min(pair[1].1) - 2,
        right: pair[0].0.max(pair[1].0) + 3,
        bottom: pair[0].1.max(pair[1].1) + 3,
    };
    line.windows(2).map(narrow).collect()
}

/// Draws the points at `places` and writes their names where there is space.
fn draw_points<B: DrawingBackend>(
    area: &Area<B>,
    points: &[PlottedPoint],
    places: &[(i32, i32)],
    obstacles: &[Rectangle],
    frame: Rectangle,
) -> Result<(), ChartError> {
    let mut labels = Vec::with_capacity(points.len());
    for (plotted, &point) in points.iter().zip(places) {
        let (width, height) = area
            .estimate_text_size(&plotted.name, &plotted.text_style())
            .map_err(drawing_error)?;
        labels.push(Label {
            point,
            width: width as i32,
            height: height as i32,
        });
    }
    let corners = label::place(&labels, obstacles, frame);
    for ((plotted, label), corner) in points.iter().zip(&labels).zip(corners) {
        draw_leader(area, plotted, label, corner)?;
        draw_mark(area, plotted, label.point)?;
        area.draw_text(&plotted.name, &plotted.text_style(), corner)
            .map_err(drawing_error)?;
    }
    Ok(())
}

/// Connects a point with its name if that is not right beside it.
fn draw_leader<B: DrawingBackend>(
    area: &Area<B>,
    plotted: &PlottedPoint,
    label: &Label,
    corner: (i32, i32),
) -> Result<(), ChartError> {
    let (x, y) = label.point;
    let nearest_x = x.clamp(corner.0, corner.0 + label.width);
    let nearest_y = y.clamp(corner.1, corner.1 + label.height);
    if (nearest_x - x).abs().max((nearest_y - y).abs()) <= 14 {
        return Ok(());
    }
    let line = PathElement::new([(x, y), (nearest_x, nearest_y)], plotted.color().mix(0.4));
    area.draw(&line).map_err(drawing_error)
}

/// Draws a diamond or a dot, and a ring around a point of the front.
fn draw_mark<B: DrawingBackend>(
    area: &Area<B>,
    plotted: &PlottedPoint,
    point: (i32, i32),
) -> Result<(), ChartError> {
    let (x, y) = point;
    let fill = plotted.color().filled();
    if plotted.is_special() {
        let diamond = [(x, y - 9), (x + 9, y), (x, y + 9), (x - 9, y)];
        area.draw(&Polygon::new(diamond, fill))
            .map_err(drawing_error)?;
    } else {
        area.draw(&Circle::new((x, y), 5, fill))
            .map_err(drawing_error)?;
    }
    if plotted.point.on_front {
        let radius = if plotted.is_special() { 12 } else { 8 };
        area.draw(&Circle::new((x, y), radius, FRONT.stroke_width(2)))
            .map_err(drawing_error)?;
    }
    Ok(())
}

/// From below the smallest to above the largest value, a twelfth of their distance further out, and
/// at least `min_margin`.
fn range(values: impl Iterator<Item = f64> + Clone, min_margin: f64) -> Option<(f64, f64)> {
    let min = values.clone().reduce(f64::min)?;
    let max = values.reduce(f64::max)?;
    let margin = ((max - min) / 12.0).max(min_margin);
    Some((min - margin, max + margin))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{chart::tests::pixels_of_color, report::ErrorReport};

    fn sweep() -> SweepReport {
        let point =
            |parameter: &str, value: &str, frame_ms: f64, psnr_db: Option<f64>, on_front| {
                SweepPoint {
                    parameter: parameter.to_owned(),
                    value: value.to_owned(),
                    measured_ms: frame_ms,
                    time_ratio: 1.0,
                    time_ratio_range: [1.0; 2],
                    frame_ms,
                    gpu_ms: None,
                    counters: Default::default(),
                    error: ErrorReport {
                        frames: 4,
                        psnr_db,
                        ..ErrorReport::NONE
                    },
                    flicker: None,
                    on_front,
                }
            };
        let points = vec![
            point(BASE, "", 10.0, Some(55.0), true),
            point("raster", "quads", 6.0, Some(48.0), true),
            point("exact", "yes", 20.0, None, true),
            point("cutoff", "8/255", 9.0, Some(45.0), false),
            point("pose-rate", "5 Hz", 7.0, Some(17.24), false),
        ];
        SweepReport {
            case: "orbit".to_owned(),
            frames: 8,
            rounds: 3,
            points,
            failed: vec![],
        }
    }

    #[test]
    fn the_svg_names_every_point() {
        let text = svg(&sweep(), "a body & a device").expect("some points can be drawn");
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
        for name in [
            BASE,
            "raster quads",
            "exact yes: no error",
            "cutoff 8/255",
            "pose-rate 5 Hz: 17.2 dB",
            "a body &amp; a device",
            "polyline",
        ] {
            assert!(text.contains(name), "{name} is missing");
        }
    }

    #[test]
    fn the_png_has_the_front_in_its_colour() {
        let png = png(&sweep(), "title").expect("some points can be drawn");
        let red = pixels_of_color(&png, FRONT);
        assert!(red > 500, "{red} pixels of the front's line");
    }

    #[test]
    fn a_sweep_without_errors_can_not_be_drawn() {
        let empty = SweepReport {
            points: vec![],
            ..sweep()
        };
        assert!(matches!(svg(&empty, ""), Err(ChartError::Nothing)));
    }
}
