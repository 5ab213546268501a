//! Frames in flight, and what the stages of a frame wait for.

pub(crate) mod control;
pub(crate) mod frame_in_flight;

pub(crate) use effigy_core::frame::report::FrameReport;
pub use frame_in_flight::{FRAMES_IN_FLIGHT, Semaphores};
