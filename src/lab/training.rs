//! The report of training alone. [`TrainingReport`] is the whole JSON file; the fields are its keys.

use effigy_measure::report::{DeviceReport, Program};
use serde::{Deserialize, Serialize};

/// Version of the JSON. It changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-training-1";

/// Steps of a training, with the perceptual loss and without it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TrainingReport {
    /// [`SCHEMA`].
    pub schema: String,
    /// The program that measured.
    pub program: Program,
    /// The device that was measured.
    pub device: DeviceReport,
    /// Gaussians that are learned, all with every basis row.
    pub gaussians: usize,
    /// Width and height of each view, px.
    pub size: [u32; 2],
    /// Views of a step.
    pub views: usize,
    /// Side of the part of each view that the perceptual loss sees, px.
    pub window: u32,
    /// Device memory that was told before it was taken, the loss's included, bytes.
    pub memory_bytes: u64,
    /// Ways to take a step.
    pub rows: Vec<TrainingRow>,
}

/// Steps of one way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TrainingRow {
    /// What works out the perceptual loss; "none" for steps without it.
    pub loss: String,
    /// Whether `effigy train` takes this way here.
    pub is_chosen: bool,
    /// Steps that were measured.
    pub steps: usize,
    /// Time of the median step, ms.
    pub ms: f64,
    /// Steps a second of all that were measured.
    pub steps_a_second: f64,
    /// Most pairs of splats and tiles that a view had.
    pub pairs: u32,
}
