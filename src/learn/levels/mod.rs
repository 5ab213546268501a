//! Levels of detail: Gaussians merged, then fitted to supersampled images of the whole avatar.
//!
//! ```text
//! poses ──→ views: images of the whole avatar ──────────────────────┐
//!             ↓ what they show                                      ↓
//! avatar ──→ merge: which Gaussians ──→ assemble: their numbers ──→ fit ──→ measure
//!    └─→ still: without networks ──────────┘
//! ```
//!
//! `splats` and `blend` draw small images in f32, with derivatives; `pose` takes all else from the
//! f64 reference.

mod assemble;
mod blend;
mod fit;
mod make;
mod measure;
mod merge;
mod pose;
mod splats;
mod still;
mod views;

pub(crate) use blend::Blended;
pub(crate) use pose::{placed, shapes};
pub(crate) use splats::Projection;

pub use make::{LevelOptions, LevelPoses, LevelProgress, levels_of};
