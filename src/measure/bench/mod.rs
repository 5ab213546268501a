//! The benchmark: an avatar, a clip and a device go in; time, error, memory, counters and bytes
//! come out.
//!
//! [`case`] names what is drawn, [`scene`] builds the scenes, [`run`] times them, [`check`]
//! compares them with the reference, [`mod@flicker`] each with a later one, and [`measured`] puts a
//! case's report together. [`spread`] compares many poses and views with nothing skipped. [`sweep`]
//! varies the [`parameter`]s that trade time for error one at a time, [`pareto`] finds the settings
//! on the Pareto front, and [`plot`] draws them. [`sizes`] charts error and time against the avatar's
//! size, [`strip`] shows it at each. [`task`] says what to draw, and through which
//! [`backend`]. [`report`] is the JSON, [`table`] the CSV; [`compare`] compares two reports.

pub mod backend;
pub mod case;
pub mod check;
pub mod compare;
pub mod flicker;
pub mod flicker_pairs;
mod label;
pub mod measured;
pub mod parameter;
pub mod pareto;
pub mod plot;
pub mod report;
pub mod run;
pub mod scene;
pub mod sizes;
pub mod spread;
pub mod strip;
pub mod sweep;
pub mod table;
pub mod task;

pub use crate::setting::RenderSetting;
pub use case::BenchCase;
pub use parameter::Parameter;
pub use report::BenchReport;
pub use run::{Backend, open};
pub use scene::SceneInputs;
pub use task::BenchTask;
