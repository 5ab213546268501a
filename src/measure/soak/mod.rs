//! The soak: an avatar is drawn for minutes at a promised rate, and every second is recorded.
//!
//! [`session`] keeps the records and knows neither device nor clock: frames go in, the quality to
//! draw at and a [`report::Second`] each second come out. [`run`](mod@run) draws without a window;
//! the viewer uses the same session when it soaks. [`faults`] says what is wrong with a run,
//! [`files`] writes its JSON, CSV ([`table`]) and chart ([`plot`]), [`compare`] compares two.

pub mod cadence;
pub mod compare;
pub mod faults;
pub mod files;
pub mod memory;
pub mod plot;
mod renderer;
pub mod report;
pub mod run;
pub mod session;
pub mod table;

pub use renderer::middle_frame;
pub use report::SoakReport;
pub use run::{SoakTask, run};
pub use session::{Session, SoakSettings};
