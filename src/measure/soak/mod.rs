//! The soak: an avatar is drawn for minutes at a promised rate, and every second is recorded.
//!
//! [`session`] keeps the records and knows neither device nor clock: frames go in, the quality to
//! draw at and a [`report::Second`] each second come out. [`run`](mod@run) draws without a window;
//! the viewer uses the same session when it soaks. [`report`] is what a run found, [`faults`] what
//! is wrong with it; [`files`] writes its JSON, CSV and chart.

pub mod cadence;
#[cfg(feature = "charts")]
mod chart;
pub mod faults;
pub mod files;
pub mod memory;
mod renderer;
pub mod report;
pub mod run;
pub mod session;

pub use renderer::middle_frame;
pub use report::SoakReport;
pub use run::{SoakTask, run};
pub use session::{Session, SoakSettings};
