//! Draws and checks a range of cases: a seed and numbers go in, a report comes out.

use super::{
    case::{Rasterizer, StressCase},
    category::Category,
    check::check_case,
    report::{CategoryReport, RasterizerReport, StressReport},
};
use effigy::vulkan::Gpu;
use effigy_core::random::hash;
use std::{ops::Range, sync::Arc, time::Instant};

/// The cases to draw.
#[derive(Clone, Debug)]
pub struct StressSettings {
    /// Seed of the cases.
    pub seed: u64,
    /// Numbers of the cases.
    pub cases: Range<u64>,
    /// Whether to allow images of 8192 × 8192 px.
    pub large: bool,
}

/// Draws the cases. `progress` is called with the number of cases done, of all, and of those that
/// failed.
pub fn run(
    gpu: &Arc<Gpu>,
    settings: &StressSettings,
    progress: &mut dyn FnMut(usize, usize, usize),
) -> StressReport {
    let start = Instant::now();
    let mut report = StressReport {
        device: gpu.probe.name.clone(),
        driver: gpu.probe.driver.clone(),
        seed: settings.seed,
        cases: 0,
        categories: Category::ALL.map(CategoryReport::new).into(),
        rasterizers: Rasterizer::ALL.map(RasterizerReport::new).into(),
        failures: vec![],
        all: vec![],
        digest: String::new(),
        slowest: None,
        seconds: 0.0,
        lost: false,
    };
    let total = (settings.cases.end - settings.cases.start) as usize;
    let mut digest = 0;
    for number in settings.cases.clone() {
        let case = StressCase::new(settings.seed, number, settings.large).for_device(&gpu.probe);
        let outcome = check_case(gpu, &case);
        digest = hash(digest ^ outcome.digest);
        report.add(&case, &outcome);
        progress(report.cases, total, report.failures.len());
        if outcome.lost {
            report.lost = true;
            break;
        }
    }
    report.categories.retain(|category| category.cases > 0);
    report.rasterizers.retain(|rasterizer| rasterizer.cases > 0);
    report.digest = format!("{digest:016x}");
    report.seconds = start.elapsed().as_secs_f64();
    report
}
