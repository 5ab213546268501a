//! Learns an avatar's correctives from the look of its Gaussians in many poses.
//!
//! ```text
//! bake: the body, clips ── ground_truth: the posed mesh, settled and lit ──→ dataset
//!                                                 └── pictures: a capture    ↓
//!                   fit: stage by stage, train: networks and bases, prune: rows
//!                                                                             ↓
//!                                 analyse ── evaluate, score ←───────── avatar ──→ levels
//! ```
//!
//! [`distil`] makes an avatar of a checkpoint of another program instead. All of it runs on the CPU,
//! parts in parallel; [`analyse`] alone times frames on a device. Results depend on the dataset, the
//! options and the seed alone, on one kind of machine: not on the number of threads, and not on
//! interruptions.

pub mod analyse;
pub mod bake;
pub mod dataset;
pub mod distil;
pub mod evaluate;
pub mod fit;
pub mod ground_truth;
pub mod levels;
pub mod math;
pub mod pictures;
pub mod plot;
pub mod prune;
pub mod score;
pub mod train;

pub use dataset::{Dataset, LearnError};
pub use fit::{Budget, CheckpointOptions, FitOptions, Fitted, fit, prune};
