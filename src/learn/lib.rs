//! Makes avatars, and what avatars are learned from.
//!
//! ```text
//! bake: the body, clips ── ground_truth: the posed mesh, settled and lit ── pictures: a capture
//!                                                                               ↓
//!     distil: from a larger model's checkpoint ─→ avatar ←───────────── effigy-train
//!                                                   ↓
//!       prune: fewer rows, levels: fewer Gaussians, score: of a capture
//! ```
//!
//! All of it runs on the CPU, parts in parallel. Results depend on the files, the options and the
//! seed alone, on one kind of machine, not on the number of threads.

pub mod bake;
pub mod distil;
pub mod ground_truth;
pub mod levels;
mod likeness;
pub mod pictures;
pub mod prune;
pub mod score;
