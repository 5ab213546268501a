//! A measurement of frames under a name.

use effigy_measure::bench::BenchReport;
use serde::{Deserialize, Serialize};

/// A measurement of frames.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NamedBench {
    /// From the file's name, `bench-NAME.json`.
    pub name: String,
    /// The measurement.
    pub report: BenchReport,
}
