//! The bytes of each stage against what the device copies in that time: how close a stage is to its
//! memory.

use super::named_bench::NamedBench;
use effigy_measure::rates::RatesReport;
use serde::{Deserialize, Serialize};

/// A stage of a case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StageTraffic {
    /// Name of the measurement.
    pub measurement: String,
    /// Name of the case.
    pub case: String,
    /// Name of the stage.
    pub stage: String,
    /// Median time, ms.
    pub ms: f64,
    /// Bytes that it moves, computed and not measured.
    pub bytes: u64,
    /// Those a second.
    pub bytes_a_second: f64,
    /// Bytes a second as a share of those of a copy of much memory, 1 = as fast. Null without a
    /// copy.
    pub of_memory: Option<f64>,
    /// Bytes a second as a share of those of a copy of as many bytes, which may lie in caches.
    pub of_same_size: Option<f64>,
}

/// Every stage that ran, has a time and moves something, of all cases.
pub fn traffic(benches: &[NamedBench], rates: Option<&RatesReport>) -> Vec<StageTraffic> {
    let mut rows = Vec::new();
    for NamedBench { name, report } in benches {
        for case in &report.cases {
            for stage in &case.stages {
                let (Some(ms), Some(bytes)) = (stage.ms, stage.bytes) else {
                    continue;
                };
                if ms.median <= 0.0 || bytes == 0 {
                    continue;
                }
                let bytes_a_second = bytes as f64 / ms.median * 1e3;
                let share = |rate: f64| bytes_a_second / rate;
                rows.push(StageTraffic {
                    measurement: name.clone(),
                    case: case.name.clone(),
                    stage: stage.name.clone(),
                    ms: ms.median,
                    bytes,
                    bytes_a_second,
                    of_memory: rates.and_then(RatesReport::memory_bandwidth).map(share),
                    of_same_size: rates.and_then(|rates| rates.bandwidth_at(bytes)).map(share),
                });
            }
        }
    }
    rows
}
