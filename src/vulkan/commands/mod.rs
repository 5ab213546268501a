//! Frames in flight, and what the stages of a frame wait for.

pub(crate) mod control;
pub(crate) mod frame_in_flight;

pub use effigy_core::frame::report::{FrameReport, HostTimes, STAGES};
pub use frame_in_flight::{FRAMES_IN_FLIGHT, Semaphores};
