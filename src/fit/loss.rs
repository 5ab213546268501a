//! The loss curves of a fit. In: its points. Out: an SVG's text, a PNG's bytes, or the same as CSV.

use super::checkpoint::Point;
use crate::fit::plot::{self, Chart, Fault, Line};

/// The curves as a chart.
pub fn chart(curve: &[Point]) -> Chart<'_> {
    let line = |name: &str, of: &dyn Fn(&Point) -> f64| Line {
        name: name.to_owned(),
        points: curve.iter().map(|point| (point.epoch as f64, of(point).max(1e-6))).collect(),
    };
    Chart {
        title: "what the networks leave unexplained",
        x: "epochs",
        y: "share of the spread, of each stage's own target",
        log: true,
        lines: vec![line("training frames", &|point| point.training), line("held-out frames", &|point| point.held)],
    }
}

/// As SVG.
pub fn svg(curve: &[Point]) -> Result<String, Fault> {
    plot::svg(&chart(curve))
}

/// A line a point.
pub fn csv(curve: &[Point]) -> String {
    let line = |p: &Point| format!("{},{},{:.6},{:.6}\n", p.stage, p.epoch, p.training, p.held);
    std::iter::once("stage,epoch,training,held\n".to_owned()).chain(curve.iter().map(line)).collect()
}
