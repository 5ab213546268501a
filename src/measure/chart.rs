//! Charts: panels of lines and named points, one below the other under a title, as the text of an
//! SVG or the bytes of a PNG. Who measures says what is in them; this says how it looks.

use plotters::{
    chart::DualCoordChartContext,
    coord::{Shift, types::RangedCoordf64},
    prelude::*,
    style::register_font,
};
pub use plotters::{chart::SeriesLabelPosition as Corner, style::RGBColor as Rgb};
use std::{fmt::Display, io::Cursor, ops::Range};

/// Name of the font; viewers of an SVG have one under this name.
const FONT: &str = "sans-serif";
/// Heights of text, px.
const TITLE: u32 = 22;
const TEXT: u32 = 17;
/// Colour of text.
pub const INK: Rgb = Rgb(40, 44, 52);
/// Colour of grids and borders.
const FAINT: Rgb = Rgb(226, 229, 233);
/// Colours of lines.
pub const BLUE: Rgb = Rgb(31, 119, 180);
/// See [`BLUE`].
pub const RED: Rgb = Rgb(208, 52, 44);
/// See [`BLUE`].
pub const GREEN: Rgb = Rgb(44, 160, 44);
/// See [`BLUE`].
pub const ORANGE: Rgb = Rgb(255, 127, 14);
/// See [`BLUE`].
pub const GREY: Rgb = Rgb(120, 124, 130);

type Area<B> = DrawingArea<B, Shift>;
type Plane = Cartesian2d<RangedCoordf64, RangedCoordf64>;

/// Why a chart can't be drawn.
#[derive(Debug, thiserror::Error)]
pub enum ChartError {
    /// There is no data.
    #[error("there is nothing to draw: nothing was measured to the end")]
    Nothing,
    /// The drawing library or an encoder failed.
    #[error("it can't be drawn: {0}")]
    Drawing(String),
}

fn drawing_error(error: impl Display) -> ChartError {
    ChartError::Drawing(error.to_string())
}

/// A chart.
#[derive(Debug)]
pub struct Chart {
    /// The line above it.
    pub title: String,
    /// Width and height, px.
    pub size: [u32; 2],
    /// From the top down.
    pub panels: Vec<Panel>,
}

/// Lines and points over one pair of axes.
#[derive(Debug)]
pub struct Panel {
    /// Share of the chart's height.
    pub share: f64,
    /// The axis below.
    pub x: Axis,
    /// The axis on the left.
    pub y: Axis,
    /// The axis on the right, if some lines have one of their own.
    pub right: Option<Axis>,
    /// What is drawn below the points.
    pub lines: Vec<Line>,
    /// Points with names beside them, which choose their places in this order.
    pub points: Vec<NamedPoint>,
    /// Where the lines' names stand, if they do.
    pub legend: Option<Corner>,
}

/// An axis.
#[derive(Debug)]
pub struct Axis {
    /// What it measures, with the unit.
    pub label: String,
    /// Its ends.
    pub range: [f64; 2],
    /// How a number is written, if not as the drawing library does.
    pub number: Option<fn(&f64) -> String>,
    /// Numbers along it, at most, if not as many as have room.
    pub most: Option<usize>,
}

impl Axis {
    /// An axis from one end to the other.
    pub fn new(label: impl Into<String>, range: [f64; 2]) -> Self {
        Self {
            label: label.into(),
            range,
            number: None,
            most: None,
        }
    }

    /// An axis around some values, with a share of their distance beyond them, but at least
    /// `margin`.
    ///
    /// # Errors
    /// [`ChartError::Nothing`] without values.
    pub fn around(
        label: impl Into<String>,
        values: impl Iterator<Item = f64> + Clone,
        share: f64,
        margin: f64,
    ) -> Result<Self, ChartError> {
        let min = values.clone().reduce(f64::min).ok_or(ChartError::Nothing)?;
        let max = values.reduce(f64::max).ok_or(ChartError::Nothing)?;
        let mut margin = (share * (max - min)).max(margin);
        if min == max && margin == 0.0 {
            margin = 0.5;
        }
        Ok(Self::new(label, [min - margin, max + margin]))
    }

    /// An axis whose numbers are written by `number`.
    pub fn written(self, number: fn(&f64) -> String) -> Self {
        let number = Some(number);
        Self { number, ..self }
    }

    fn range(&self) -> Range<f64> {
        self.range[0]..self.range[1]
    }
}

impl Panel {
    /// An empty panel, which takes the whole chart.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self {
            share: 1.0,
            x,
            y,
            right: None,
            lines: Vec::new(),
            points: Vec::new(),
            legend: None,
        }
    }
}

/// A line, or dots.
#[derive(Debug)]
pub struct Line {
    /// Its name in the legend; empty for none.
    pub name: String,
    /// Its colour.
    pub color: Rgb,
    /// How it is drawn.
    pub style: LineStyle,
    /// x and y of each point, by rising x.
    pub points: Vec<(f64, f64)>,
    /// Whether y is along the axis on the right.
    pub on_right: bool,
}

impl Line {
    /// A line along the axis on the left.
    pub fn new(
        name: impl Into<String>,
        color: Rgb,
        style: LineStyle,
        points: Vec<(f64, f64)>,
    ) -> Self {
        Self {
            name: name.into(),
            color,
            style,
            points,
            on_right: false,
        }
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineStyle {
    /// A line.
    Solid,
    /// A thin line.
    Thin,
    /// A line with a dot at each point.
    Dotted,
    /// A flat line from each point to the next one's x, then upright to its y.
    Steps,
    /// Dots alone.
    Dots,
}

/// A point with a name.
#[derive(Debug)]
pub struct NamedPoint {
    /// x and y.
    pub at: (f64, f64),
    /// What stands beside it.
    pub name: String,
    /// The colour of both.
    pub color: Rgb,
    /// Whether it is a large diamond in place of a dot.
    pub is_large: bool,
    /// Whether a red ring is around it.
    pub is_ringed: bool,
}

impl Chart {
    /// The bytes of an SVG if the ending says so, else those of a PNG.
    ///
    /// # Errors
    /// [`ChartError::Nothing`] if it has neither lines nor points.
    pub fn encoded(&self, ending: &str) -> Result<Vec<u8>, ChartError> {
        let [width, height] = self.size;
        if ending == "svg" {
            let mut text = String::new();
            self.draw(SVGBackend::with_string(&mut text, (width, height)))?;
            return Ok(text.into_bytes());
        }
        let mut image = image::RgbImage::new(width, height);
        self.draw(BitMapBackend::with_buffer(&mut image, (width, height)))?;
        let mut bytes = Cursor::new(Vec::new());
        image
            .write_to(&mut bytes, image::ImageFormat::Png)
            .map_err(drawing_error)?;
        Ok(bytes.into_inner())
    }

    fn draw<B: DrawingBackend>(&self, backend: B) -> Result<(), ChartError> {
        let is_empty = |panel: &Panel| panel.lines.is_empty() && panel.points.is_empty();
        if self.panels.iter().all(is_empty) {
            return Err(ChartError::Nothing);
        }
        register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
            .map_err(|_| drawing_error("the font can't be read"))?;
        let whole = backend.into_drawing_area();
        whole.fill(&WHITE).map_err(drawing_error)?;
        let mut rest = whole
            .margin(14, 0, 0, 0)
            .titled(&self.title, text_style(TITLE))
            .map_err(drawing_error)?;
        let (_, height) = rest.dim_in_pixel();
        // Panels stand under each other, so their planes are as wide.
        let right_label = if self.panels.iter().any(|panel| panel.right.is_some()) {
            70
        } else {
            0
        };
        for panel in &self.panels {
            let (own, below) = rest.split_vertically((panel.share * f64::from(height)) as i32);
            panel.draw(&whole, &own, right_label)?;
            rest = below;
        }
        whole.present().map_err(drawing_error)
    }
}

fn text_style(height: u32) -> TextStyle<'static> {
    TextStyle::from((FONT, height)).color(&INK)
}

impl Panel {
    /// `own`: the panel's part of the chart.
    fn draw<B: DrawingBackend>(
        &self,
        whole: &Area<B>,
        own: &Area<B>,
        right_label: u32,
    ) -> Result<(), ChartError> {
        let right = self.right.as_ref().unwrap_or(&self.y);
        let mut chart = ChartBuilder::on(own)
            .margin(14)
            .x_label_area_size(50)
            .y_label_area_size(72)
            .right_y_label_area_size(right_label)
            .build_cartesian_2d(self.x.range(), self.y.range())
            .map_err(drawing_error)?
            .set_secondary_coord(self.x.range(), right.range());
        let mut mesh = chart.configure_mesh();
        mesh.x_desc(&self.x.label).y_desc(&self.y.label);
        if let Some(number) = &self.x.number {
            mesh.x_label_formatter(number);
        }
        if let Some(number) = &self.y.number {
            mesh.y_label_formatter(number);
        }
        if let Some(most) = self.y.most {
            mesh.y_labels(most);
        }
        mesh.axis_desc_style(text_style(TEXT))
            .label_style(text_style(TEXT))
            .light_line_style(TRANSPARENT)
            .bold_line_style(FAINT)
            .draw()
            .map_err(drawing_error)?;
        if let Some(right) = &self.right {
            chart
                .configure_secondary_axes()
                .y_desc(&right.label)
                .axis_desc_style(text_style(TEXT))
                .label_style(text_style(TEXT))
                .draw()
                .map_err(drawing_error)?;
        }
        self.draw_lines(&mut chart)?;
        if !self.points.is_empty() {
            self.draw_points(whole, chart.plotting_area())?;
        }
        if let Some(position) = &self.legend {
            chart
                .configure_series_labels()
                .position(position.clone())
                .label_font(text_style(TEXT))
                .background_style(WHITE.mix(0.85))
                .border_style(FAINT)
                .draw()
                .map_err(drawing_error)?;
        }
        Ok(())
    }

    fn draw_lines<'a, B: DrawingBackend + 'a>(
        &self,
        chart: &mut DualCoordChartContext<'a, B, Plane, Plane>,
    ) -> Result<(), ChartError> {
        for line in &self.lines {
            let color = line.color;
            let stroke = color.stroke_width(if line.style == LineStyle::Thin { 1 } else { 2 });
            // Piece by piece: the mitre of one line's sharp corner would stick out far beyond it.
            let paths = match line.style {
                LineStyle::Dots => Vec::new(),
                LineStyle::Steps => vec![PathElement::new(staircase(&line.points), stroke)],
                LineStyle::Solid | LineStyle::Thin | LineStyle::Dotted => {
                    let pieces = line.points.windows(2);
                    pieces.map(|p| PathElement::new(p, stroke)).collect()
                }
            };
            let drawn = if line.on_right {
                chart.draw_secondary_series(paths)
            } else {
                chart.draw_series(paths)
            };
            let series = drawn.map_err(drawing_error)?;
            if !line.name.is_empty() {
                series.label(&line.name);
                if line.style == LineStyle::Dots {
                    series.legend(move |(x, y)| Circle::new((x + 9, y), 3, color.filled()));
                } else {
                    series.legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], stroke));
                }
            }
            if matches!(line.style, LineStyle::Dotted | LineStyle::Dots) {
                let dot = |&at| Circle::new(at, 3, color.filled());
                let dots = line.points.iter().map(dot);
                chart.draw_series(dots).map_err(drawing_error)?;
            }
        }
        Ok(())
    }

    fn draw_points<B: DrawingBackend>(
        &self,
        whole: &Area<B>,
        plane: &DrawingArea<B, Plane>,
    ) -> Result<(), ChartError> {
        let to_pixel = |at: &(f64, f64)| plane.map_coordinate(at);
        let (columns, rows) = plane.get_pixel_range();
        let frame = Rectangle {
            min: (columns.start, rows.start),
            max: (columns.end, rows.end),
        };
        // Names keep clear of lines too.
        let mut obstacles = Vec::new();
        for line in &self.lines {
            let path: Vec<_> = staircase(&line.points).iter().map(to_pixel).collect();
            obstacles.extend(path.windows(2).map(|p| Rectangle {
                min: (p[0].0.min(p[1].0) - 2, p[0].1.min(p[1].1) - 2),
                max: (p[0].0.max(p[1].0) + 3, p[0].1.max(p[1].1) + 3),
            }));
        }
        let mut labels = Vec::with_capacity(self.points.len());
        for point in &self.points {
            let (width, height) = whole
                .estimate_text_size(&point.name, &point.text_style())
                .map_err(drawing_error)?;
            labels.push(Label {
                point: to_pixel(&point.at),
                size: (width as i32, height as i32),
            });
        }
        for (point, name) in self.points.iter().zip(place(&labels, &obstacles, frame)) {
            point.draw(whole, to_pixel(&point.at), name)?;
        }
        Ok(())
    }
}

impl NamedPoint {
    fn text_style(&self) -> TextStyle<'_> {
        let height = if self.is_large { 22 } else { TEXT };
        TextStyle::from((FONT, height)).color(&self.color)
    }

    /// Draws it at a pixel, and its name in a rectangle.
    fn draw<B: DrawingBackend>(
        &self,
        whole: &Area<B>,
        (x, y): (i32, i32),
        name: Rectangle,
    ) -> Result<(), ChartError> {
        let near_x = x.clamp(name.min.0, name.max.0);
        let near_y = y.clamp(name.min.1, name.max.1);
        if (near_x - x).abs().max((near_y - y).abs()) > 14 {
            let leader = PathElement::new([(x, y), (near_x, near_y)], self.color.mix(0.4));
            whole.draw(&leader).map_err(drawing_error)?;
        }
        let fill = self.color.filled();
        if self.is_large {
            let diamond = [(x, y - 9), (x + 9, y), (x, y + 9), (x - 9, y)];
            whole.draw(&Polygon::new(diamond, fill))
        } else {
            whole.draw(&Circle::new((x, y), 5, fill))
        }
        .map_err(drawing_error)?;
        if self.is_ringed {
            let radius = if self.is_large { 12 } else { 8 };
            let ring = Circle::new((x, y), radius, RED.stroke_width(2));
            whole.draw(&ring).map_err(drawing_error)?;
        }
        whole
            .draw_text(&self.name, &self.text_style(), name.min)
            .map_err(drawing_error)
    }
}

/// Points as [`LineStyle::Steps`] draws them.
fn staircase(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut line: Vec<(f64, f64)> = Vec::new();
    for &point in points {
        if let Some(last) = line.last() {
            line.push((point.0, last.1));
        }
        line.push(point);
    }
    line
}

/// Gap between a point and its name, px.
const GAP: i32 = 12;
/// Distances tried for a name, each a step further out, px.
const DISTANCES: i32 = 10;
const DISTANCE_STEP: i32 = 12;
/// Cost of a covered pixel, and of a step further out.
const COVERED_COST: i64 = 20;
const DISTANCE_COST: i64 = 30;

/// A rectangle in an image, px. `max` is outside of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Rectangle {
    min: (i32, i32),
    max: (i32, i32),
}

impl Rectangle {
    fn at(min: (i32, i32), size: (i32, i32)) -> Self {
        let max = (min.0 + size.0, min.1 + size.1);
        Self { min, max }
    }

    /// The pixels that two rectangles share.
    fn overlap(self, other: Self) -> i64 {
        let width = self.max.0.min(other.max.0) - self.min.0.max(other.min.0);
        let height = self.max.1.min(other.max.1) - self.min.1.max(other.min.1);
        i64::from(width.max(0)) * i64::from(height.max(0))
    }
}

/// A point and the size of its name, px.
#[derive(Clone, Copy, Debug)]
struct Label {
    point: (i32, i32),
    size: (i32, i32),
}

impl Label {
    /// Places of the name in eight directions from the point, the right one first.
    fn places(&self, gap: i32) -> [Rectangle; 8] {
        let (x, y) = self.point;
        let (width, height) = self.size;
        let (left, middle, right) = (x - gap - width, x - width / 2, x + gap);
        let (above, beside, below) = (y - gap - height, y - height / 2, y + gap);
        [
            (right, beside),
            (middle, above),
            (middle, below),
            (left, beside),
            (right, above),
            (right, below),
            (left, above),
            (left, below),
        ]
        .map(|corner| Rectangle::at(corner, self.size))
    }
}

/// Places names in the order given. Each takes the place around its point that covers the least of
/// other names, points, obstacles and the outside of the frame, and is near.
fn place(labels: &[Label], obstacles: &[Rectangle], frame: Rectangle) -> Vec<Rectangle> {
    let mark = |label: &Label| Rectangle::at((label.point.0 - 5, label.point.1 - 5), (11, 11));
    let mut taken: Vec<Rectangle> = labels.iter().map(mark).chain(obstacles.to_vec()).collect();
    let mut names = Vec::with_capacity(labels.len());
    for label in labels {
        let near_first = (0..DISTANCES).flat_map(|step| {
            let places = label.places(GAP + step * DISTANCE_STEP);
            places.map(|place| (step, place))
        });
        let cost = |&(step, place): &(i32, Rectangle)| {
            let covered: i64 = taken.iter().map(|&other| place.overlap(other)).sum();
            let outside = place.overlap(place) - place.overlap(frame);
            COVERED_COST * (covered + outside) + DISTANCE_COST * i64::from(step)
        };
        // The first of the best.
        let best = near_first.min_by_key(cost);
        let (_, name) = best.expect("there are distances");
        taken.push(name);
        names.push(name);
    }
    names
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use proptest::{collection::vec, prelude::*};

    /// How many pixels of a PNG have exactly this colour.
    pub(crate) fn pixels_of_color(png: &[u8], color: Rgb) -> usize {
        let image = image::load_from_memory(png)
            .expect("it was just encoded")
            .to_rgb8();
        let wanted = [color.0, color.1, color.2];
        image.pixels().filter(|pixel| pixel.0 == wanted).count()
    }

    #[test]
    fn charts_name_and_draw_their_lines() -> Result<(), ChartError> {
        let line = |name: &str, color, style, by: f64| Line {
            on_right: style == LineStyle::Steps,
            ..Line::new(
                name,
                color,
                style,
                (1..9).map(|k| (f64::from(k), by / f64::from(k))).collect(),
            )
        };
        let x = Axis::around("along", (1..9).map(f64::from), 0.0, 0.0)?;
        let mut panel = Panel::new(x, Axis::new("up", [0.0, 30.0]));
        panel.right = Some(Axis::new("beside", [0.0, 9.0]));
        panel.lines = vec![
            line("first", BLUE, LineStyle::Dotted, 3.0),
            line("second", GREEN, LineStyle::Steps, 8.0),
            line("third", ORANGE, LineStyle::Dots, 20.0),
        ];
        panel.legend = Some(Corner::UpperRight);
        let chart = |panels| Chart {
            title: "a & b".into(),
            size: [600, 400],
            panels,
        };
        let colors = [BLUE, GREEN, ORANGE];
        let full = chart(vec![panel]);
        let text = String::from_utf8(full.encoded("svg")?).map_err(drawing_error)?;
        for name in [
            "a &amp; b",
            "along",
            "up",
            "beside",
            "first",
            "second",
            "third",
        ] {
            assert!(text.contains(name), "{name} is missing");
        }
        let png = full.encoded("png")?;
        for color in colors {
            let pixels = pixels_of_color(&png, color);
            assert!(pixels > 50, "{color:?}: {pixels} pixels");
        }
        panel = full.panels.into_iter().next().expect("its panel");
        panel.lines.clear();
        let empty = chart(vec![panel]).encoded("svg");
        assert!(matches!(empty, Err(ChartError::Nothing)));
        Ok(())
    }

    #[test]
    fn an_axis_is_around_its_values_and_never_empty() {
        let range = |values: &[f64], share, margin| {
            Axis::around("", values.iter().copied(), share, margin).map(|axis| axis.range)
        };
        assert_eq!(range(&[1.0, 3.0], 0.5, 0.25).ok(), Some([0.0, 4.0]));
        assert_eq!(range(&[1.0, 3.0], 0.0, 0.25).ok(), Some([0.75, 3.25]));
        assert_eq!(range(&[2.0], 0.5, 0.0).ok(), Some([1.5, 2.5]));
        assert!(matches!(range(&[], 1.0, 1.0), Err(ChartError::Nothing)));
    }

    #[test]
    fn a_staircase_goes_right_then_up() {
        let line = staircase(&[(1.0, 5.0), (3.0, 9.0)]);
        assert_eq!(line, [(1.0, 5.0), (3.0, 5.0), (3.0, 9.0)]);
    }

    fn label(x: i32, y: i32) -> Label {
        Label {
            point: (x, y),
            size: (40, 10),
        }
    }

    #[test]
    fn a_name_stands_right_of_its_point_unless_something_is_there() {
        let frame = Rectangle::at((0, 0), (200, 100));
        let lone = |x| place(&[label(x, 50)], &[], frame)[0];
        assert_eq!((lone(50).min, lone(190).max.0), ((62, 45), 190 - GAP));
        let line = Rectangle::at((0, 49), (200, 3));
        let name = place(&[label(50, 50)], &[line], frame)[0];
        assert_eq!(name.overlap(line), 0);
    }

    proptest! {
        #[test]
        fn names_of_spaced_points_overlap_nothing(places in vec((0i32..6, 0i32..6), 1..12)) {
            let mut labels: Vec<Label> = places
                .into_iter()
                .map(|(x, y)| label(120 + 110 * x, 60 + 60 * y))
                .collect();
            labels.sort_unstable_by_key(|label| label.point);
            labels.dedup_by_key(|label| label.point);
            let frame = Rectangle::at((0, 0), (900, 460));
            let names = place(&labels, &[], frame);
            for (index, &name) in names.iter().enumerate() {
                for &other in &names[index + 1..] {
                    prop_assert_eq!(name.overlap(other), 0, "{:?}", names);
                }
                for label in &labels {
                    prop_assert_eq!(name.overlap(Rectangle::at(label.point, (1, 1))), 0);
                }
                prop_assert_eq!(name.overlap(frame), name.overlap(name));
            }
        }
    }
}
