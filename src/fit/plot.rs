//! Charts of lines: what a fit and its analysis show. In: named lines. Out: an SVG's text or a PNG's bytes.

pub use crate::measure::bench::plot::Fault;
use crate::measure::bench::plot::{FAINT, FONT, INK, drawing, png_of, register};
use plotters::{coord::Shift, prelude::*};

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
pub struct Line {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

/// Lines over one pair of axes.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    pub title: &'a str,
    pub x: &'a str,
    pub y: &'a str,
    /// Heights by their logarithm.
    pub log: bool,
    pub lines: Vec<Line>,
}

/// As SVG.
pub fn svg(chart: &Chart) -> Result<String, Fault> {
    let mut text = String::new();
    draw(SVGBackend::with_string(&mut text, SIZE).into_drawing_area(), chart)?;
    Ok(text)
}

/// As PNG.
pub fn png(chart: &Chart) -> Result<Vec<u8>, Fault> {
    png_of(SIZE, |pixels| draw(BitMapBackend::with_buffer(pixels, SIZE).into_drawing_area(), chart))
}

fn draw<B: DrawingBackend>(area: DrawingArea<B, Shift>, chart: &Chart) -> Result<(), Fault> {
    register()?;
    let height = |y: f64| if chart.log { y.max(1e-12).log10() } else { y };
    let points = || chart.lines.iter().flat_map(|line| &line.points);
    let ends = |of: &dyn Fn(&(f64, f64)) -> f64| {
        let (low, high) = points().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        (low.is_finite() && high.is_finite()).then_some((low, if high > low { high } else { low + 1.0 }))
    };
    let ((left, right), (bottom, top)) = (ends(&|p| p.0).ok_or(Fault::Nothing)?, ends(&|p| height(p.1)).ok_or(Fault::Nothing)?);
    let room = 0.06 * (top - bottom);
    area.fill(&WHITE).map_err(drawing)?;
    let below = area.margin(12, 4, 0, 0).titled(chart.title, TextStyle::from((FONT, 22)).color(&INK)).map_err(drawing)?;
    let mut built = ChartBuilder::on(&below)
        .margin(14)
        .x_label_area_size(50)
        .y_label_area_size(76)
        .build_cartesian_2d(left..right, bottom - room..top + room)
        .map_err(drawing)?;
    let label = TextStyle::from((FONT, 16)).color(&INK);
    built
        .configure_mesh()
        .x_desc(chart.x)
        .y_desc(chart.y)
        .y_label_formatter(&|y| if chart.log { short(10f64.powf(*y)) } else { short(*y) })
        .axis_desc_style(label.clone())
        .label_style(label.clone())
        .light_line_style(TRANSPARENT)
        .bold_line_style(FAINT)
        .draw()
        .map_err(drawing)?;
    for (line, &color) in chart.lines.iter().zip(COLORS.iter().cycle()) {
        let at: Vec<_> = line.points.iter().map(|&(x, y)| (x, height(y))).collect();
        // Piece by piece: the joint of one line's sharp corner would reach far beyond it.
        built
            .draw_series(at.windows(2).map(|piece| PathElement::new(piece.to_vec(), color.stroke_width(2))))
            .map_err(drawing)?
            .label(&line.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(2)));
        built.draw_series(at.iter().map(|&point| Circle::new(point, 3, color.filled()))).map_err(drawing)?;
    }
    built
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .label_font(label)
        .background_style(WHITE.mix(0.85))
        .border_style(FAINT)
        .draw()
        .map_err(drawing)?;
    area.present().map_err(drawing)
}

/// Three digits that count.
fn short(value: f64) -> String {
    let digits = (2 - value.abs().max(1e-12).log10().floor() as i32).clamp(0, 6);
    format!("{value:.*}", digits.unsigned_abs() as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_names_its_lines_and_draws_them() -> Result<(), Fault> {
        let line = |name: &str, by: f64| Line { name: name.into(), points: (1..9).map(|k| (f64::from(k), by / f64::from(k))).collect() };
        let mut chart = Chart { title: "a title", x: "along", y: "up", log: true, lines: vec![line("first", 1.0), line("second", 30.0)] };
        let text = svg(&chart)?;
        ["a title", "along", "up", "first", "second"].into_iter().for_each(|name| assert!(text.contains(name), "{name} is missing"));
        let image = image::load_from_memory(&png(&chart)?).map_err(drawing)?.to_rgb8();
        for color in &COLORS[..2] {
            let pixels = image.pixels().filter(|pixel| pixel.0 == [color.0, color.1, color.2]).count();
            assert!(pixels > 100, "{color:?}: {pixels} pixels");
        }
        chart.lines.clear();
        assert!(matches!(svg(&chart), Err(Fault::Nothing)));
        Ok(())
    }
}
