//! The soak: an avatar is drawn for minutes on end at a promised rate, and every second it is written down how that goes.
//!
//! [`session`] is the book-keeping, whatever draws: frames go in, the quality to draw at and a [`report::Second`] each second come out.
//! [`run`] draws without a window; the viewer keeps the same books where it is told to soak. [`verdict`] says what is wrong with a run,
//! [`files`] writes its JSON, CSV ([`table`]) and chart ([`plot`]), [`compare`] sets two against each other.

pub mod cadence;
pub mod compare;
pub mod files;
pub mod memory;
pub mod plot;
pub mod report;
pub mod run;
pub mod session;
mod stage;
pub mod table;
pub mod verdict;

pub use report::Report;
pub use run::{Task, run};
pub use session::{Session, Settings};
pub use stage::middle;
