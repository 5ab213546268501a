//! How to fit.

pub use crate::prune::Budget;
use std::path::PathBuf;
use std::time::Duration;

/// Where a fit writes its state, and how often.
#[derive(Clone, Debug)]
pub struct CheckpointOptions {
    /// The file. A fit that finds its own state here resumes from it.
    pub path: PathBuf,
    /// The least time between two writes.
    pub interval: Duration,
}

/// How to fit, see [`fit`](super::fit) and [`prune`](super::prune).
#[derive(Clone, Debug)]
pub struct FitOptions {
    /// N_B.
    pub basis: usize,
    /// Epochs of all stages together.
    pub epochs: usize,
    /// Decides the first weights, the order of frames and the noise.
    pub seed: u64,
    /// The clips to fit to, by name; all if empty.
    pub clips: Vec<String>,
    /// How much the constraint on correctives counts; 1 is usual, 0 turns it off.
    pub constraint: f32,
    /// How many rows to retain; all if `None`.
    pub budget: Option<Budget>,
    /// No checkpoints if `None`.
    pub checkpoint: Option<CheckpointOptions>,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            basis: 16,
            epochs: 400,
            seed: 1,
            clips: Vec::new(),
            constraint: 1.0,
            budget: Some(Budget::Contribution(60_000)),
            checkpoint: None,
        }
    }
}

impl FitOptions {
    /// Epochs of each stage: half of all for the first where it is followed by two.
    pub(super) fn stage_epochs(&self) -> Vec<usize> {
        let quarter = self.epochs / 4;
        let first = self.epochs - 2 * quarter;
        if self.budget.is_some() {
            vec![first, quarter, quarter]
        } else {
            vec![first, quarter]
        }
    }
}
