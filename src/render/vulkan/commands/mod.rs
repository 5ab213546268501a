//! Frames in flight, and what the stages of a frame wait for; a stopwatch for work outside of
//! frames.

pub(crate) mod control;
pub(crate) mod frame_in_flight;
mod stopwatch;

pub(crate) use effigy_core::frame::report::FrameReport;
pub use frame_in_flight::{FRAMES_IN_FLIGHT, Semaphores};
pub use stopwatch::RunTimes;
pub(crate) use stopwatch::Stopwatch;
