//! Weights of the losses.

use serde::{Deserialize, Serialize};

/// Weights of the losses. Pictures' are means over all channels of all pixels of a view's picture,
/// scales' and correctives' over all numbers of their kind; all are means over the views.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LossWeights {
    /// Of |image − picture|.
    pub l1: f64,
    /// Of standard deviations above `scale_above`, canonical, correctives included; a metre.
    pub scale: f64,
    /// Metres.
    pub scale_above: f64,
    /// Of |δr|, |δs| and |δc|, the correctives of the quaternion, the log scale and the colour.
    pub correctives: [f64; 3],
}

impl LossWeights {
    /// The paper's, and for scales its predecessor's.
    pub const PAPER: Self = Self {
        l1: 1.0,
        scale: 1.0,
        scale_above: 0.01,
        correctives: [0.02, 1.0, 0.002],
    };

    /// Without that of correctives: the second stage, after pruning.
    pub fn without_correctives(self) -> Self {
        Self {
            correctives: [0.0; 3],
            ..self
        }
    }
}
