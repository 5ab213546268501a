//! The chart of error and time against an avatar's height in the image.

use super::{
    case::BenchCase,
    report::{BenchReport, CaseReport},
};
use crate::chart::{Axis, BLUE, Chart, ChartError, Corner, Line, LineStyle, Panel, RED};

/// The chart of error and time against an avatar's height in the image, of the cases in which it has
/// one: a line for each report by its name.
///
/// # Errors
/// [`ChartError::Nothing`] if no case of any report has a height.
pub fn size_chart(reports: &[(&str, &BenchReport)], title: String) -> Result<Chart, ChartError> {
    let panel = |label: &str, value: fn(&CaseReport) -> Option<f64>| {
        let line = |(at, (name, report)): (usize, &(&str, &BenchReport))| {
            let point = |own: &CaseReport| {
                let case: BenchCase = own.name.parse().ok()?;
                let tall = case.tall().filter(|_| case.instances() == 1)?;
                Some((tall.log2(), value(own).filter(|value| value.is_finite())?))
            };
            let mut points: Vec<_> = report.cases.iter().filter_map(point).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            Line::new(*name, [BLUE, RED][at % 2], LineStyle::Dotted, points)
        };
        let lines: Vec<Line> = reports.iter().enumerate().map(line).collect();
        let points = lines.iter().flat_map(|line| &line.points);
        let x = "height of the avatar in the image, px";
        let x = Axis::around(x, points.clone().map(|point| point.0), 0.0, 0.2)?;
        let top = points.map(|point| point.1).fold(0.0, f64::max);
        Ok(Panel {
            share: 0.5,
            lines,
            ..Panel::new(
                x.written(|height| format!("{:.0}", height.exp2())),
                Axis::new(label, [0.0, 1.08 * top]),
            )
        })
    };
    let errors = panel("PSNR over covered pixels, dB", |own| {
        own.error.as_ref()?.psnr_db
    })?;
    Ok(Chart {
        title,
        size: [1000, 900],
        panels: vec![
            Panel {
                legend: Some(Corner::LowerRight),
                ..errors
            },
            panel("frame, ms", |own| Some(own.frame_ms.mean))?,
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::MEASURED;

    #[test]
    fn a_chart_of_sizes_needs_a_case_with_a_height() {
        let mut report = BenchReport::read(MEASURED).expect("a report");
        let empty = size_chart(&[("a", &report)], String::new());
        assert!(matches!(empty, Err(ChartError::Nothing)));
        report.cases[0].name = "far".into();
        report.cases[1].name = "far240".into();
        let chart = size_chart(&[("first", &report), ("second", &report)], String::new());
        let svg = chart
            .and_then(|chart| chart.encoded("svg"))
            .expect("it is drawn");
        let svg = String::from_utf8_lossy(&svg);
        assert!(svg.contains("first") && svg.contains("second") && svg.contains("frame, ms"));
    }
}
