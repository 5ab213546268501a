//! How to draw, chosen by measuring: which raster method, with the saturation depth or without,
//! which colour format and sort is fastest on a device for a workload.
//!
//! A [`Candidate`] is a way to draw. The tournament times it against the best so far, frame by
//! frame in turn, along one [`Axis`] after the other, and takes it if it wins by more than the
//! noise and its image is right. It goes on over as many starts as it takes; the [`Record`] holds
//! how far it came. Until then the safest candidate is drawn with.

mod candidate;
mod outcome;
mod record;
mod tournament;

pub use candidate::{Axis, Candidate, Choices, Workload};
pub use outcome::{FramePair, Outcome, Timing, TriedCandidate, Tuning};
pub use record::Record;
pub use tournament::{Progress, Tournament, TrialImage, Trials};
pub(crate) use tournament::{device_lives, may_pass};
