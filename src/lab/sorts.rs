//! The report of the sort alone, by count, key bits and variant. [`SortsReport`] is the whole JSON
//! file; the fields are its keys.

use effigy_measure::report::{DeviceReport, Program};
use serde::{Deserialize, Serialize};

/// Version of the JSON. It changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-sorts-1";

/// All sorts that were measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SortsReport {
    /// [`SCHEMA`].
    pub schema: String,
    /// The program that measured.
    pub program: Program,
    /// The device that was measured.
    pub device: DeviceReport,
    /// Times that each sort was run; the median counts.
    pub runs: u16,
    /// The variant that the self-test chooses.
    pub auto: String,
    /// Each count, key size and sort.
    pub rows: Vec<SortRow>,
}

/// One sort of one count of keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SortRow {
    /// Number of keys.
    pub keys: usize,
    /// Bits of a key.
    pub bits: u32,
    /// Name of the variant.
    pub variant: String,
    /// Lanes of a subgroup, where a size was asked for. Null: as many as the device reports.
    pub subgroup: Option<u32>,
    /// Null where it failed.
    pub speed: Option<SortSpeed>,
    /// How it failed, or how its order differs from the CPU's. Null where it is right.
    pub failed: Option<String>,
}

impl SortRow {
    /// The variant, and the size of subgroups that was asked for.
    pub fn name(&self) -> String {
        sort_name(&self.variant, self.subgroup)
    }
}

/// A variant in words, with the lanes of a subgroup where they were asked for.
pub fn sort_name(variant: &str, subgroup: Option<u32>) -> String {
    match subgroup {
        Some(lanes) => format!("{variant} {lanes}"),
        None => variant.to_owned(),
    }
}

/// How fast a sort is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SortSpeed {
    /// Time of the median run by the device's clock, ms.
    pub ms: f64,
    /// Time of the median run by the host's clock, ms.
    pub wall_ms: f64,
    /// Millions of keys a second.
    pub mkeys_per_s: f64,
    /// Device memory of the sort.
    pub memory_bytes: u64,
}
