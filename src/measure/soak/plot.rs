//! The chart of a soak: the frame rate over the minutes with what was promised, and below it the governor's steps and the headroom used up.
//! In: a report. Out: an SVG's text or a PNG's bytes.

use super::report::Report;
use crate::measure::bench::plot::{FAINT, FONT, Fault, INK, drawing, png_of, register};
use plotters::{coord::Shift, prelude::*};

/// Width and height, px.
const SIZE: (u32, u32) = (1200, 800);
const RATE: RGBColor = RGBColor(31, 119, 180);
const PROMISE: RGBColor = RGBColor(120, 124, 130);
const DROPPED: RGBColor = RGBColor(208, 52, 44);
const STEPS: RGBColor = RGBColor(44, 160, 44);
const HEAT: RGBColor = RGBColor(235, 120, 20);

/// As SVG.
pub fn svg(report: &Report) -> Result<String, Fault> {
    let mut text = String::new();
    draw(SVGBackend::with_string(&mut text, SIZE).into_drawing_area(), report)?;
    Ok(text)
}

/// As PNG.
pub fn png(report: &Report) -> Result<Vec<u8>, Fault> {
    png_of(SIZE, |pixels| draw(BitMapBackend::with_buffer(pixels, SIZE).into_drawing_area(), report))
}

fn draw<B: DrawingBackend>(area: DrawingArea<B, Shift>, report: &Report) -> Result<(), Fault> {
    register()?;
    let end = report.each.last().ok_or(Fault::Nothing)?.seconds / 60.0;
    area.fill(&WHITE).map_err(drawing)?;
    let size = format!("{} × {}", report.size[0], report.size[1]);
    let title = format!("{}, {} Gaussians, {size}, on {}", report.avatar.name, report.avatar.gaussians, report.device.name);
    let below = area.margin(14, 6, 0, 0).titled(&title, TextStyle::from((FONT, 22)).color(&INK)).map_err(drawing)?;
    let (upper, lower) = below.split_vertically((SIZE.1 - 60) * 3 / 5);
    rates(&upper, report, end)?;
    steps(&lower, report, end)?;
    area.present().map_err(drawing)
}

fn rates<B: DrawingBackend>(area: &DrawingArea<B, Shift>, report: &Report, end: f64) -> Result<(), Fault> {
    let most = report.each.iter().map(|second| second.fps).fold(report.rate, f64::max);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .x_label_area_size(34)
        .y_label_area_size(70)
        .margin_right(82)
        .build_cartesian_2d(0.0..end, 0.0..1.4 * most)
        .map_err(drawing)?;
    let label = TextStyle::from((FONT, 16)).color(&INK);
    chart
        .configure_mesh()
        .y_desc("frames a second")
        .axis_desc_style(label.clone())
        .label_style(label.clone())
        .light_line_style(TRANSPARENT)
        .bold_line_style(FAINT)
        .draw()
        .map_err(drawing)?;
    chart
        .draw_series(LineSeries::new([(0.0, report.rate), (end, report.rate)], PROMISE.stroke_width(1)))
        .map_err(drawing)?
        .label(format!("promised: {}", report.rate))
        .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], PROMISE));
    let line: Vec<_> = report.each.iter().map(|second| (second.seconds / 60.0, second.fps)).collect();
    // Piece by piece: the joint of one line's sharp corner would reach far beyond it.
    chart
        .draw_series(line.windows(2).map(|piece| PathElement::new(piece.to_vec(), RATE.stroke_width(2))))
        .map_err(drawing)?
        .label(format!("drawn: {:.1} on average", report.fps))
        .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], RATE.stroke_width(2)));
    let dropped = report.each.iter().filter(|second| second.dropped > 0);
    chart
        .draw_series(dropped.map(|second| Circle::new((second.seconds / 60.0, second.fps), 3, DROPPED.filled())))
        .map_err(drawing)?
        .label(format!("seconds with dropped refreshes: {} in all", report.dropped))
        .legend(|(x, y)| Circle::new((x + 9, y), 3, DROPPED.filled()));
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(label)
        .background_style(WHITE.mix(0.85))
        .border_style(FAINT)
        .draw()
        .map_err(drawing)
}

fn steps<B: DrawingBackend>(area: &DrawingArea<B, Shift>, report: &Report, end: f64) -> Result<(), Fault> {
    let lowest = report.ladder.len().max(2) as f64 - 1.0;
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(70)
        .right_y_label_area_size(70)
        .build_cartesian_2d(0.0..end, -0.5..1.35 * lowest)
        .map_err(drawing)?
        .set_secondary_coord(0.0..end, 0.0..1.4);
    let label = TextStyle::from((FONT, 16)).color(&INK);
    chart
        .configure_mesh()
        .x_desc("minutes")
        .y_desc("governor's step")
        .y_labels(report.ladder.len().min(12))
        .y_label_formatter(&|step| format!("{step:.0}"))
        .axis_desc_style(label.clone())
        .label_style(label.clone())
        .light_line_style(TRANSPARENT)
        .bold_line_style(FAINT)
        .draw()
        .map_err(drawing)?;
    let hot = report.each.iter().any(|second| second.headroom.is_some());
    if hot {
        chart
            .configure_secondary_axes()
            .y_desc("headroom used")
            .axis_desc_style(label.clone())
            .label_style(label.clone())
            .draw()
            .map_err(drawing)?;
        let line = report.each.iter().filter_map(|second| Some((second.seconds / 60.0, second.headroom?.min(1.2))));
        chart
            .draw_secondary_series(LineSeries::new(line, HEAT.stroke_width(2)))
            .map_err(drawing)?
            .label("headroom used: 1 is where the clock is taken away")
            .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], HEAT.stroke_width(2)));
    }
    let name = if report.governed { "governor's step" } else { "the governor is off" };
    chart
        .draw_series(LineSeries::new(staircase(report), STEPS.stroke_width(2)))
        .map_err(drawing)?
        .label(name)
        .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], STEPS.stroke_width(2)));
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(label)
        .background_style(WHITE.mix(0.85))
        .border_style(FAINT)
        .draw()
        .map_err(drawing)
}

/// Rungs over minutes, with upright edges.
fn staircase(report: &Report) -> Vec<(f64, f64)> {
    let mut line: Vec<(f64, f64)> = Vec::with_capacity(2 * report.each.len());
    for second in &report.each {
        let at = second.seconds / 60.0;
        line.extend(line.last().map(|last| (at, last.1)));
        line.push((at, second.rung as f64));
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::soak::verdict::tests::report;

    #[test]
    fn the_chart_names_its_lines() -> Result<(), Fault> {
        let mut report = report();
        report.each[20].dropped = 3;
        let text = svg(&report)?;
        for name in ["frames a second", "promised: 60", "governor", "headroom used", "minutes", "640 × 480"] {
            assert!(text.contains(name), "{name} is missing");
        }
        let image = image::load_from_memory(&png(&report)?).map_err(drawing)?.to_rgb8();
        assert_eq!(image.dimensions(), SIZE);
        for color in [RATE, STEPS, HEAT, DROPPED] {
            let pixels = image.pixels().filter(|pixel| pixel.0 == [color.0, color.1, color.2]).count();
            assert!(pixels > 10, "{color:?}: {pixels} pixels");
        }
        report.each.clear();
        assert!(matches!(svg(&report), Err(Fault::Nothing)));
        Ok(())
    }
}
