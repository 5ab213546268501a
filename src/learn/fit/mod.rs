//! From a dataset to a learned avatar, stage by stage, and from an avatar to a pruned one; with
//! checkpoints and loss curves.

mod checkpoint;
pub mod loss_curve;
pub mod options;
pub mod stages;

pub use loss_curve::LossPoint;
pub use options::{Budget, CheckpointOptions, FitOptions};
pub use stages::{FitProgress, Fitted, fit, prune};
