//! Charts: the font, colours, axes, lines and legend that all of them share, and the formats that
//! they are written in. In: a [`Chart`]. Out: an SVG's text or a PNG's bytes.

use plotters::{
    chart::SeriesLabelPosition,
    coord::{Shift, types::RangedCoordf64},
    prelude::*,
    style::register_font,
};
use std::{fmt::Display, io::Cursor};

/// Name of the font; viewers of an SVG have one under this name.
pub const FONT: &str = "sans-serif";
/// Colour of text.
pub const INK: RGBColor = RGBColor(40, 44, 52);
/// Colour of grids and borders.
pub const FAINT: RGBColor = RGBColor(226, 229, 233);

/// The area that a chart is drawn on.
pub type Area<B> = DrawingArea<B, Shift>;
/// Two axes of f64.
pub type Plane = Cartesian2d<RangedCoordf64, RangedCoordf64>;

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

/// An error of the drawing library, in this module's terms.
pub fn drawing_error(error: impl Display) -> ChartError {
    ChartError::Drawing(error.to_string())
}

/// Something that can be drawn on any area of its size.
pub trait Chart {
    /// Width and height, px.
    fn size(&self) -> (u32, u32);

    /// Draws on a white area of that size.
    ///
    /// # Errors
    /// [`ChartError::Nothing`] where there is nothing to draw.
    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), ChartError>;
}

/// The chart as the text of an SVG.
///
/// # Errors
/// See [`Chart::draw`].
pub fn svg(chart: &impl Chart) -> Result<String, ChartError> {
    let mut text = String::new();
    draw(chart, SVGBackend::with_string(&mut text, chart.size()))?;
    Ok(text)
}

/// The chart as the bytes of a PNG.
///
/// # Errors
/// See [`Chart::draw`].
pub fn png(chart: &impl Chart) -> Result<Vec<u8>, ChartError> {
    let size = chart.size();
    png_from_pixels(size, |pixels| {
        draw(chart, BitMapBackend::with_buffer(pixels, size))
    })
}

fn draw<B: DrawingBackend>(chart: &impl Chart, backend: B) -> Result<(), ChartError> {
    register_fonts()?;
    let area = backend.into_drawing_area();
    area.fill(&WHITE).map_err(drawing_error)?;
    chart.draw(&area)?;
    area.present().map_err(drawing_error)
}

/// The PNG of an image of `size` px. `draw` fills its pixels, three bytes each, row by row.
///
/// # Errors
/// Those of `draw`, and of the encoder.
fn png_from_pixels(
    size: (u32, u32),
    draw: impl FnOnce(&mut [u8]) -> Result<(), ChartError>,
) -> Result<Vec<u8>, ChartError> {
    let mut pixels = vec![0; 3 * size.0 as usize * size.1 as usize];
    draw(&mut pixels)?;
    let image = image::RgbImage::from_raw(size.0, size.1, pixels)
        .ok_or_else(|| drawing_error("its size is wrong"))?;
    let mut bytes = Cursor::new(Vec::new());
    image
        .write_to(&mut bytes, image::ImageFormat::Png)
        .map_err(drawing_error)?;
    Ok(bytes.into_inner())
}

/// Makes [`FONT`] known to the drawing library. Fails when the font that is built in can't be read.
fn register_fonts() -> Result<(), ChartError> {
    register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
        .map_err(|_| drawing_error("the font can't be read"))
}

/// Text of a height in px.
pub fn text_style(height: u32) -> TextStyle<'static> {
    TextStyle::from((FONT, height)).color(&INK)
}

/// A line of text above a chart; lengths in px.
#[derive(Clone, Copy, Debug)]
pub struct Title<'a> {
    /// The words.
    pub text: &'a str,
    /// Height of the text.
    pub text_height: u32,
    /// Margin above it.
    pub above: u32,
    /// Margin below it.
    pub below: u32,
}

impl Title<'_> {
    /// Writes the title and gives the area under it.
    ///
    /// # Errors
    /// When the backend fails.
    pub fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<Area<B>, ChartError> {
        area.margin(self.above, self.below, 0, 0)
            .titled(self.text, text_style(self.text_height))
            .map_err(drawing_error)
    }
}

/// How the axes of a chart are labelled.
#[derive(Clone, Copy, Default)]
pub struct Axes<'a> {
    /// Description of each axis, with its unit. None leaves an axis without a description.
    pub x: Option<&'a str>,
    /// See `x`.
    pub y: Option<&'a str>,
    /// Height of all text, px.
    pub text_height: u32,
    /// Numbers along y, at most. None leaves it to the drawing library, as for the next.
    pub y_label_count: Option<usize>,
    /// How a number along x is written.
    pub x_label: Option<&'a dyn Fn(&f64) -> String>,
    /// How a number along y is written.
    pub y_label: Option<&'a dyn Fn(&f64) -> String>,
}

impl Axes<'_> {
    /// Draws the grid, the numbers and the descriptions.
    ///
    /// # Errors
    /// When the backend fails.
    pub fn draw<B: DrawingBackend>(
        &self,
        chart: &mut ChartContext<B, Plane>,
    ) -> Result<(), ChartError> {
        let style = text_style(self.text_height);
        let mut mesh = chart.configure_mesh();
        if let Some(description) = self.x {
            mesh.x_desc(description);
        }
        if let Some(description) = self.y {
            mesh.y_desc(description);
        }
        if let Some(count) = self.y_label_count {
            mesh.y_labels(count);
        }
        if let Some(label) = self.x_label {
            mesh.x_label_formatter(label);
        }
        if let Some(label) = self.y_label {
            mesh.y_label_formatter(label);
        }
        mesh.axis_desc_style(style.clone())
            .label_style(style)
            .light_line_style(TRANSPARENT)
            .bold_line_style(FAINT)
            .draw()
            .map_err(drawing_error)
    }
}

/// A line's mark in the legend.
pub fn legend_line(
    color: RGBColor,
    width: u32,
) -> impl Fn((i32, i32)) -> PathElement<(i32, i32)> + 'static {
    move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(width))
}

/// Draws a line 2 px wide and names it in the legend.
///
/// It is drawn piece by piece: the mitre of one line's sharp corner would stick out far beyond it.
///
/// # Errors
/// When the backend fails.
pub fn draw_line<'a, B: DrawingBackend + 'a>(
    chart: &mut ChartContext<'a, B, Plane>,
    points: &[(f64, f64)],
    color: RGBColor,
    name: impl Into<String>,
) -> Result<(), ChartError> {
    let pieces = points
        .windows(2)
        .map(|piece| PathElement::new(piece.to_vec(), color.stroke_width(2)));
    chart
        .draw_series(pieces)
        .map_err(drawing_error)?
        .label(name)
        .legend(legend_line(color, 2));
    Ok(())
}

/// Draws the legend of all series that have a name.
///
/// # Errors
/// When the backend fails.
pub fn draw_legend<'a, B: DrawingBackend + 'a>(
    chart: &mut ChartContext<'a, B, Plane>,
    position: SeriesLabelPosition,
    text_height: u32,
) -> Result<(), ChartError> {
    chart
        .configure_series_labels()
        .position(position)
        .label_font(text_style(text_height))
        .background_style(WHITE.mix(0.85))
        .border_style(FAINT)
        .draw()
        .map_err(drawing_error)
}

/// Points as steps: a flat line from each point to the next one's x, then upright to its y.
/// `points` are in the order of x.
pub fn staircase(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut line: Vec<(f64, f64)> = Vec::new();
    for point in points {
        if let Some(last) = line.last() {
            line.push((point.0, last.1));
        }
        line.push(point);
    }
    line
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// How many pixels of a PNG have exactly this colour.
    pub(crate) fn pixels_of_color(png: &[u8], color: RGBColor) -> usize {
        let image = image::load_from_memory(png)
            .expect("it was just encoded")
            .to_rgb8();
        let wanted = [color.0, color.1, color.2];
        image.pixels().filter(|pixel| pixel.0 == wanted).count()
    }

    #[test]
    fn a_staircase_goes_right_then_up() {
        let line = staircase([(1.0, 5.0), (3.0, 9.0)].into_iter());
        assert_eq!(line, [(1.0, 5.0), (3.0, 5.0), (3.0, 9.0)]);
    }
}
