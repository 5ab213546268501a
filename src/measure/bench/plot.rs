//! The picture of a sweep: time to the right, likeness to the reference upwards, so that the best is at the upper left. Every point has
//! its knob and value beside it; the line is the Pareto front. In: a sweep. Out: an SVG's text or a PNG's bytes.

use super::{
    knob::Knob,
    label::{self, Rectangle},
    report::{Point, SweepReport},
    sweep::BASE,
};
use plotters::{coord::Shift, prelude::*, style::register_font};
use std::io::Cursor;

/// Width and height, px.
const SIZE: (u32, u32) = (1400, 900);
/// What the letters are called; viewers of the SVG have some under that name.
pub(crate) const FONT: &str = "sans-serif";
/// What charts are written in, and their grids.
pub(crate) const INK: RGBColor = RGBColor(40, 44, 52);
pub(crate) const FAINT: RGBColor = RGBColor(226, 229, 233);
const FRONT: RGBColor = RGBColor(208, 52, 44);
/// A colour a knob, in the order of [`Knob::ALL`].
static COLORS: [RGBColor; Knob::ALL.len()] = [
    RGBColor(20, 20, 20),
    RGBColor(127, 127, 127),
    RGBColor(31, 119, 180),
    RGBColor(174, 199, 232),
    RGBColor(255, 127, 14),
    RGBColor(44, 160, 44),
    RGBColor(148, 103, 189),
    RGBColor(140, 86, 75),
    RGBColor(227, 119, 194),
    RGBColor(23, 163, 184),
    RGBColor(150, 150, 20),
    RGBColor(0, 120, 120),
];
/// Points further than this under the best finite PSNR stand at the lower edge, with their PSNR in their name, dB.
const DEEP: f64 = 20.0;
/// Added to the best finite PSNR for points that have no error at all, dB.
const PERFECT: f64 = 3.0;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum Fault {
    #[error("there is nothing to draw: nothing was measured to the end")]
    Nothing,
    #[error("it can't be drawn: {0}")]
    Drawing(String),
}

/// As SVG. `title` is what was measured, and on what.
pub fn svg(sweep: &SweepReport, title: &str) -> Result<String, Fault> {
    let mut text = String::new();
    draw(SVGBackend::with_string(&mut text, SIZE).into_drawing_area(), sweep, title)?;
    Ok(text)
}

/// As PNG.
pub fn png(sweep: &SweepReport, title: &str) -> Result<Vec<u8>, Fault> {
    png_of(SIZE, |pixels| draw(BitMapBackend::with_buffer(pixels, SIZE).into_drawing_area(), sweep, title))
}

/// The PNG of what is drawn into pixels of three bytes.
pub(crate) fn png_of((width, height): (u32, u32), draw: impl FnOnce(&mut [u8]) -> Result<(), Fault>) -> Result<Vec<u8>, Fault> {
    let mut pixels = vec![0; (3 * width * height) as usize];
    draw(&mut pixels)?;
    let image = image::RgbImage::from_raw(width, height, pixels).ok_or_else(|| Fault::Drawing("its size is wrong".to_owned()))?;
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, image::ImageFormat::Png).map_err(drawing)?;
    Ok(bytes.into_inner())
}

/// The letters of every chart.
pub(crate) fn register() -> Result<(), Fault> {
    register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT).map_err(|_| drawing("the letters can't be read"))
}

pub(crate) fn drawing(error: impl std::fmt::Display) -> Fault {
    Fault::Drawing(error.to_string())
}

type Area<B> = DrawingArea<B, Shift>;

fn draw<B: DrawingBackend>(area: Area<B>, sweep: &SweepReport, title: &str) -> Result<(), Fault> {
    register()?;
    // The most important names choose their place first.
    let mut points: Vec<&Point> = sweep.points.iter().filter(|point| point.error.frames > 0 && point.frame_ms.is_finite()).collect();
    points.sort_by_key(|point| (point.knob != BASE, point.knob != Knob::Preset.name(), !point.on_front));
    let psnr = points.iter().filter_map(|point| point.error.psnr_db);
    let best = psnr.reduce(f64::max).unwrap_or(0.0);
    let height = |point: &&Point| point.error.psnr_db.unwrap_or(best + PERFECT).max(best - DEEP);
    let heights: Vec<f64> = points.iter().map(height).collect();
    let (left, right) = range(points.iter().map(|point| point.frame_ms), 0.02).ok_or(Fault::Nothing)?;
    let (bottom, top) = range(heights.iter().copied(), 0.5).ok_or(Fault::Nothing)?;
    area.fill(&WHITE).map_err(drawing)?;
    let heading = TextStyle::from((FONT, 24)).color(&INK);
    let below = area.margin(14, 0, 0, 0).titled(title, heading).map_err(drawing)?;
    let mut chart = ChartBuilder::on(&below)
        .margin(16)
        .x_label_area_size(56)
        .y_label_area_size(72)
        .build_cartesian_2d(left..right, bottom..top)
        .map_err(drawing)?;
    let label = TextStyle::from((FONT, 18)).color(&INK);
    let description = format!("frame time, ms (case `{}`, {} frames, {} rounds in turn)", sweep.case, sweep.frames, sweep.rounds);
    chart
        .configure_mesh()
        .x_desc(description)
        .y_desc("PSNR of the worst frame over covered pixels, dB")
        .axis_desc_style(label.clone())
        .label_style(label)
        .light_line_style(TRANSPARENT)
        .bold_line_style(FAINT)
        .draw()
        .map_err(drawing)?;
    let front = staircase(points.iter().zip(&heights).filter(|(point, _)| point.on_front).map(|(point, &height)| (point.frame_ms, height)));
    chart.draw_series(LineSeries::new(front.iter().copied(), FRONT.stroke_width(2))).map_err(drawing)?;
    let (frame_x, frame_y) = chart.plotting_area().get_pixel_range();
    let at = |(point, &height): (&&Point, &f64)| chart.plotting_area().map_coordinate(&(point.frame_ms, height));
    let places: Vec<(i32, i32)> = points.iter().zip(&heights).map(at).collect();
    let line: Vec<(i32, i32)> = front.iter().map(|point| chart.plotting_area().map_coordinate(point)).collect();
    let points: Vec<Named> =
        points.iter().zip(places).map(|(point, place)| Named { name: name(point, best - DEEP), point, place }).collect();
    marks(&area, &points, &obstacles(&line), [frame_x.start, frame_y.start, frame_x.end, frame_y.end])?;
    area.present().map_err(drawing)
}

/// A point, where it is in the picture and what is written beside it.
struct Named<'a> {
    point: &'a Point,
    place: (i32, i32),
    name: String,
}

/// Knob and value, and the PSNR of a point that does not stand at its own height.
fn name(point: &Point, lowest: f64) -> String {
    let name = format!("{} {}", point.knob, point.value).trim().to_owned();
    match point.error.psnr_db {
        None => name + ": no error",
        Some(psnr) if psnr < lowest => format!("{name}: {psnr:.1} dB"),
        Some(_) => name,
    }
}

/// A line as narrow rectangles.
fn obstacles(line: &[(i32, i32)]) -> Vec<Rectangle> {
    let narrow = |pair: &[(i32, i32)]| {
        let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
        [ax.min(bx) - 2, ay.min(by) - 2, ax.max(bx) + 3, ay.max(by) + 3]
    };
    line.windows(2).map(narrow).collect()
}

/// The points and their names.
fn marks<B: DrawingBackend>(area: &Area<B>, points: &[Named], obstacles: &[Rectangle], frame: Rectangle) -> Result<(), Fault> {
    let special = |point: &Point| point.knob == BASE || point.knob == Knob::Preset.name();
    let style = |point: &Point| TextStyle::from((FONT, if special(point) { 22 } else { 17 })).color(color(point));
    let size =
        |named: &Named| area.estimate_text_size(&named.name, &style(named.point)).map(|(width, height)| (width as i32, height as i32));
    let sizes = points.iter().map(size).collect::<Result<Vec<_>, _>>().map_err(drawing)?;
    let places: Vec<_> = points.iter().map(|named| named.place).collect();
    let corners = label::place(&places, &sizes, obstacles, frame);
    for ((named, corner), (width, height)) in points.iter().zip(corners).zip(sizes) {
        let (point, (x, y), (left, top)) = (named.point, named.place, corner);
        let color = color(point);
        let nearest = (x.clamp(left, left + width), y.clamp(top, top + height));
        if (nearest.0 - x).abs().max((nearest.1 - y).abs()) > 14 {
            area.draw(&PathElement::new([(x, y), nearest], color.mix(0.4))).map_err(drawing)?;
        }
        if special(point) {
            let diamond = [(x, y - 9), (x + 9, y), (x, y + 9), (x - 9, y)];
            area.draw(&Polygon::new(diamond, color.filled())).map_err(drawing)?;
        } else {
            area.draw(&Circle::new((x, y), 5, color.filled())).map_err(drawing)?;
        }
        if point.on_front {
            area.draw(&Circle::new((x, y), if special(point) { 12 } else { 8 }, FRONT.stroke_width(2))).map_err(drawing)?;
        }
        area.draw_text(&named.name, &style(point), corner).map_err(drawing)?;
    }
    Ok(())
}

fn color(point: &Point) -> &'static RGBColor {
    let knob = Knob::ALL.into_iter().position(|knob| knob.name() == point.knob);
    knob.map_or(&INK, |knob| &COLORS[knob])
}

/// From below the smallest to above the largest value, a twelfth of the way between further out, and at least `least` wide.
fn range(values: impl Iterator<Item = f64> + Clone, least: f64) -> Option<(f64, f64)> {
    let (min, max) = (values.clone().reduce(f64::min)?, values.reduce(f64::max)?);
    let margin = ((max - min) / 12.0).max(least);
    Some((min - margin, max + margin))
}

/// What the front guarantees: at each time the best of the points that are no slower.
fn staircase(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut points: Vec<_> = points.collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut line: Vec<(f64, f64)> = Vec::new();
    for point in points {
        line.extend(line.last().map(|last| (point.0, last.1)));
        line.push(point);
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::bench::report::ErrorReport;

    fn sweep() -> SweepReport {
        let point = |knob: &str, value: &str, frame_ms: f64, psnr_db: Option<f64>, on_front| Point {
            knob: knob.to_owned(),
            value: value.to_owned(),
            measured_ms: frame_ms,
            time_ratio: 1.0,
            time_ratio_range: [1.0; 2],
            frame_ms,
            gpu_ms: None,
            counters: Default::default(),
            error: ErrorReport { frames: 4, psnr_db, ..ErrorReport::NONE },
            on_front,
        };
        let points = vec![
            point(BASE, "", 10.0, Some(55.0), true),
            point("preset", "low", 6.0, Some(48.0), true),
            point("preset", "exact", 20.0, None, true),
            point("cutoff", "8/255", 9.0, Some(45.0), false),
            point("pose-rate", "5 Hz", 7.0, Some(17.24), false),
        ];
        SweepReport { case: "orbit".to_owned(), frames: 8, rounds: 3, points, failed: vec![] }
    }

    #[test]
    fn the_svg_names_every_point() {
        let text = svg(&sweep(), "a body & a device").expect("some points can be drawn");
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
        for name in
            [BASE, "preset low", "preset exact: no error", "cutoff 8/255", "pose-rate 5 Hz: 17.2 dB", "a body &amp; a device", "polyline"]
        {
            assert!(text.contains(name), "{name} is missing");
        }
    }

    #[test]
    fn the_png_has_the_front_in_its_colour() {
        let image = image::load_from_memory(&png(&sweep(), "title").expect("some points can be drawn")).expect("a PNG").to_rgb8();
        assert_eq!(image.dimensions(), SIZE);
        let red = image.pixels().filter(|pixel| pixel.0 == [FRONT.0, FRONT.1, FRONT.2]).count();
        assert!(red > 500, "{red} pixels of the front's line");
    }

    #[test]
    fn nothing_compared_is_nothing_drawn() {
        let empty = SweepReport { points: vec![], ..sweep() };
        assert!(matches!(svg(&empty, ""), Err(Fault::Nothing)));
    }

    #[test]
    fn the_front_goes_right_and_up_in_steps() {
        let line = staircase([(3.0, 9.0), (1.0, 5.0)].into_iter());
        assert_eq!(line, [(1.0, 5.0), (3.0, 5.0), (3.0, 9.0)]);
    }
}
