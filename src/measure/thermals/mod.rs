//! How warm a device is and how fast it may run: the system's own readings, or a simulated phone's.

pub mod model;

pub use model::{Model, Phone};
