//! An avatar from a larger model: mmlphuman's checkpoint
//! ([`effigy_formats::mmlphuman`]), the *teacher*.
//!
//! ```text
//! checkpoint ── samples: poses ─→ teacher: features of every anchor in them
//!                                                 ↓
//!    body ── columns: a part's numbers, linear in its anchors' features
//!                                                 ↓
//!               students: networks and bases, learned in turn ── judge
//! ```
//!
//! The teacher's attributes are linear in features too, only in more of them: B of each of the
//! anchors that a part's Gaussians blend, some 150 together. So no Gaussian's attributes are ever
//! computed for the fit. The best N_B features of a part are the leading components of that linear
//! map over the sampled poses, from covariances of the anchors' features; a small network learns
//! them; and the bases for what it learned are a product of the teacher's bases and one matrix for
//! each anchor.

mod basis;
mod body;
mod columns;
mod inputs;
mod judge;
mod learner;
mod network;
mod samples;
mod solve;
mod students;
mod teacher;

pub use body::{UntrainedAvatar, plain_inputs};
pub use judge::{Difference, Likeness};
pub use samples::SampleOptions;
pub use students::{DistilOptions, DistilProgress, Distilled, MIN_POSES, distil};
pub use teacher::{AnchorFeatures, Teacher, TeacherAppearance};
