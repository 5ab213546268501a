//! Draws and checks a range of cases: a seed and numbers go in, a report comes out.

use super::{
    case::{Rasterizer, StressCase},
    category::Category,
    check::DrawnCase,
    report::{CategoryReport, RasterizerReport, StressReport},
};
use effigy_core::random::hash;
use effigy_render::vulkan::Gpu;
use std::{
    ops::Range,
    sync::{Arc, mpsc},
    thread,
    time::Instant,
};

/// Cases that may wait with their images until they are checked: one of 8192 × 8192 px has 3 GB.
const WAITING: usize = 4;

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
    // Every case has a renderer of its own; only its pipelines are those of cases before it.
    gpu.keep_pipelines();
    let mut digest = 0;
    let waiting = if settings.large { 0 } else { WAITING };
    let (sender, receiver) = mpsc::sync_channel(waiting);
    thread::scope(|scope| {
        // The device draws the next cases while the images of one are checked.
        scope.spawn(move || {
            for number in settings.cases.clone() {
                let case = StressCase::new(settings.seed, number, settings.large);
                let case = case.for_device(&gpu.probe);
                let drawn = DrawnCase::draw(gpu, &case);
                let is_lost = drawn.is_lost();
                if sender.send((case, drawn)).is_err() || is_lost {
                    break;
                }
            }
        });
        for (case, drawn) in receiver {
            let outcome = drawn.check(gpu, &case);
            digest = hash(digest ^ outcome.digest);
            report.add(&case, &outcome);
            report.lost |= outcome.lost;
            progress(report.cases, total, report.failures.len());
        }
    });
    report.categories.retain(|category| category.cases > 0);
    report.rasterizers.retain(|rasterizer| rasterizer.cases > 0);
    report.digest = format!("{digest:016x}");
    report.seconds = start.elapsed().as_secs_f64();
    report
}
