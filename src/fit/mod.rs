//! Learns an avatar's correctives from what its Gaussians should look like in each of many poses.
//!
//! ```text
//! body, clips ── truth: the posed mesh, settled and lit ──→ dataset: a folder, a file a frame
//!                                                              ↓
//! inputs: poses ─→ learner: a network a part ⇄ basis, solve: the bases, given the networks
//!                                                              ↓
//!                      shown, prune: rows worth least go ──→ avatar ── evaluate, analyse
//! ```
//!
//! All of it runs on processors, parts side by side. What comes out depends on the dataset, the options and the seed alone, on one kind of
//! machine: neither on the number of threads nor on interruptions.

pub mod analyse;
pub mod basis;
pub mod block;
pub mod checkpoint;
pub mod dataset;
pub mod evaluate;
pub mod inputs;
pub mod learner;
pub mod loss;
pub mod matrix;
pub mod network;
pub mod nodes;
pub mod plot;
pub mod prune;
pub mod run;
pub mod shown;
pub mod solve;
pub mod truth;

pub use dataset::{Dataset, Error};
pub use prune::Budget;
pub use run::{Fitted, Options, fit, prune};
