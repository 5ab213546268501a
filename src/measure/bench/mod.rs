//! The benchmark: an avatar, clips and a device go in; time, error, memory, counters and bytes come
//! out.
//!
//! The way is straight. A [`case::BenchTask`] says what to draw, [`case`] makes scenes of it, and
//! [`frames`] draws them. [`measure`] times and counts a case's frames and compares some with the
//! reference, [`flicker`] each with a later one; [`sweep`] does so for every value of the parameters
//! that trade time for error; [`spread`] compares many poses and views with nothing skipped. What
//! they find is one [`report::BenchReport`], which is the JSON, the rows of the CSV and of a
//! comparison, and the charts.

pub mod case;
pub mod flicker;
pub mod frames;
pub mod measure;
pub mod report;
#[cfg(feature = "charts")]
mod size_chart;
pub mod spread;
#[cfg(feature = "charts")]
pub mod sweep;

pub use case::{BenchCase, BenchTask};
pub use frames::{Backend, BackendError, BenchDevice};
pub use measure::measure_case;
pub use report::BenchReport;
#[cfg(feature = "charts")]
pub use size_chart::size_chart;
pub use spread::measure_spread;
#[cfg(feature = "charts")]
pub use sweep::{Parameter, Sweep, run_sweep};
