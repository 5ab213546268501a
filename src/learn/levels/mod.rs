//! Levels of detail: Gaussians merged, then fitted to supersampled images of the whole avatar.
//!
//! ```text
//! poses ──→ views: images of the whole avatar ──────────────────────┐
//!             ↓ what they show                                      ↓
//! avatar ──→ merge: which Gaussians ──→ assemble: their numbers ──→ fit ──→ measure
//!    └─→ still: without networks ──────────┘
//! ```
//!
//! [`effigy_math::splatter`] draws the images, with derivatives.

mod assemble;
mod fit;
mod make;
mod measure;
mod merge;
mod still;
mod views;

pub use make::{LevelOptions, LevelPoses, LevelProgress, levels_of};
