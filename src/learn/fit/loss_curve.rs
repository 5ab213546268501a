//! The loss curves of a fit, as a chart and as CSV.

use crate::plot::{self, ChartError, Plot, PlotLine};
use serde::{Deserialize, Serialize};

/// A point of the loss curves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LossPoint {
    /// The stage of the fit, from 0.
    pub stage: usize,
    /// Epochs from the start of the fit.
    pub epoch: usize,
    /// The share of the training frames' energy, about the stage's neutral values, that the
    /// networks leave unexplained.
    pub training: f64,
    /// That share of the held-out frames' energy.
    pub held: f64,
}

fn chart(curve: &[LossPoint]) -> Plot<'_> {
    let line = |name: &str, share: &dyn Fn(&LossPoint) -> f64| PlotLine {
        name: name.to_owned(),
        points: curve
            .iter()
            .map(|point| (point.epoch as f64, share(point).max(1e-6)))
            .collect(),
    };
    Plot {
        title: "what the networks leave unexplained",
        x: "epochs",
        y: "share of the spread, of each stage's own target",
        log: true,
        lines: vec![
            line("training frames", &|point| point.training),
            line("held-out frames", &|point| point.held),
        ],
    }
}

/// The curves as an SVG's text.
///
/// # Errors
/// When the curve has no points, or drawing fails.
pub fn svg(curve: &[LossPoint]) -> Result<String, ChartError> {
    plot::svg(&chart(curve))
}

/// One line a point, under a header.
pub fn csv(curve: &[LossPoint]) -> String {
    let mut text = String::from("stage,epoch,training,held\n");
    for point in curve {
        text += &format!(
            "{},{},{:.6},{:.6}\n",
            point.stage, point.epoch, point.training, point.held
        );
    }
    text
}
