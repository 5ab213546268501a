//! What a training has learned so far.

use crate::parameters::{ParameterLayout, Parameters};

/// What a training has learned so far, and in how many steps: all that a checkpoint needs of it.
#[derive(Clone, Debug, PartialEq)]
pub struct TrainerState {
    /// What is learned.
    pub parameters: Parameters<f32>,
    /// Adam's first moments.
    pub first_moments: Parameters<f32>,
    /// Adam's second moments.
    pub second_moments: Parameters<f32>,
    /// Steps since the start.
    pub steps: u64,
    /// Steps in which correctives learned.
    pub corrective_steps: u64,
}

impl TrainerState {
    /// The start of a training.
    pub fn new(layout: &ParameterLayout, parameters: Parameters<f32>) -> Self {
        Self {
            parameters,
            first_moments: Parameters::zeros(layout),
            second_moments: Parameters::zeros(layout),
            steps: 0,
            corrective_steps: 0,
        }
    }
}
