//! The report of a stress test. [`StressReport`] is the whole JSON file; the fields are its keys.

use super::{
    bound::BoundUse,
    case::{Rasterizer, StressCase},
    category::Category,
    check::CaseOutcome,
};
use effigy_measure::error::{ErrorMetrics, RegionError};
use serde::Serialize;

/// The results of a category's cases.
#[derive(Clone, Debug, Serialize)]
pub struct CategoryReport {
    /// The category.
    #[serde(rename = "family")]
    pub category: Category,
    /// Description of the category.
    pub what: &'static str,
    /// Cases drawn.
    pub cases: usize,
    /// Cases with a fault.
    pub failed: usize,
    /// Largest share of its bound that a pixel used, from the model or the pose cache.
    pub largest_use: f64,
    /// The case of `largest_use`.
    pub largest_use_case: Option<u64>,
    /// Mean over cases of the share of covered pixels that are bound to within 0.05.
    pub tight: f64,
    /// Cases that `tight` is the mean of.
    #[serde(skip)]
    bounded: usize,
    /// Lowest PSNR over covered pixels, dB. Null if no case drew anything.
    pub worst_psnr_db: Option<f64>,
    /// The case of `worst_psnr_db`.
    pub worst_case: Option<u64>,
    /// Lowest PSNR of the device's arithmetic, without the model's rounding, dB.
    pub arithmetic_worst_psnr_db: Option<f64>,
    /// The case of `arithmetic_worst_psnr_db`.
    pub arithmetic_worst_case: Option<u64>,
    /// Largest error of any channel by the arithmetic, 0 to 1.
    pub max_error: f64,
    /// The case of `max_error`.
    pub max_error_case: Option<u64>,
    /// Time on the device.
    pub seconds: f64,
}

impl CategoryReport {
    /// A report without cases.
    pub fn new(category: Category) -> Self {
        Self {
            category,
            what: category.what(),
            cases: 0,
            failed: 0,
            largest_use: 0.0,
            largest_use_case: None,
            tight: 0.0,
            bounded: 0,
            worst_psnr_db: None,
            worst_case: None,
            arithmetic_worst_psnr_db: None,
            arithmetic_worst_case: None,
            max_error: 0.0,
            max_error_case: None,
            seconds: 0.0,
        }
    }

    fn add(&mut self, number: u64, outcome: &CaseOutcome) {
        let failed = !outcome.faults.is_empty();
        self.cases += 1;
        self.failed += usize::from(failed);
        self.seconds += outcome.time.as_secs_f64();
        if let Some(largest) = outcome.largest_use()
            && largest > self.largest_use
        {
            self.largest_use = largest;
            self.largest_use_case = Some(number);
        }
        let error = outcome.error.and_then(covered);
        let arithmetic = outcome.arithmetic.and_then(covered);
        let (Some(error), Some(arithmetic)) = (error, arithmetic) else {
            return;
        };
        if let Some(used) = &outcome.used {
            self.bounded += 1;
            self.tight += (used.tight - self.tight) / self.bounded as f64;
        }
        let is_lower = |psnr_db: f64, worst: Option<f64>| worst.is_none_or(|worst| psnr_db < worst);
        if is_lower(error.psnr_db, self.worst_psnr_db) {
            self.worst_psnr_db = Some(error.psnr_db);
            self.worst_case = Some(number);
        }
        if is_lower(arithmetic.psnr_db, self.arithmetic_worst_psnr_db) {
            self.arithmetic_worst_psnr_db = Some(arithmetic.psnr_db);
            self.arithmetic_worst_case = Some(number);
        }
        if arithmetic.max_error > self.max_error {
            self.max_error = arithmetic.max_error;
            self.max_error_case = Some(number);
        }
    }
}

/// The error over covered pixels. None if there are none.
fn covered(error: ErrorMetrics) -> Option<RegionError> {
    (error.covered.pixels > 0).then_some(error.covered)
}

/// The result of a case that drew an image.
#[derive(Clone, Debug, Serialize)]
pub struct StressCaseReport {
    /// Number of the case.
    pub case: u64,
    /// Its category.
    #[serde(rename = "family")]
    pub category: Category,
    /// Rasterizer, colour format, key width and skipped work.
    pub options: String,
    /// Pixels that the reference covers.
    pub covered_pixels: usize,
    /// Over covered pixels, dB.
    pub psnr_db: f64,
    /// Largest error of any channel over covered pixels, 0 to 1.
    pub max_error: f64,
    /// This and the next are of the device's arithmetic alone: against the reference's image of the
    /// model as device memory holds it.
    pub arithmetic_psnr_db: f64,
    /// Largest error of any channel, 0 to 1.
    pub arithmetic_max_error: f64,
    /// How much of its bound it uses, computed from the model.
    pub used: Option<BoundUse>,
    /// How much of its bound the image from the pose cache uses, where the case skips skinning.
    pub used_cached: Option<BoundUse>,
}

/// The results of the cases of a rasterizer.
#[derive(Clone, Debug, Serialize)]
pub struct RasterizerReport {
    /// The rasterizer.
    pub rasterizer: Rasterizer,
    /// Cases drawn with it.
    pub cases: usize,
    /// Cases with a fault.
    pub failed: usize,
    /// Largest share of its bound that a pixel used.
    pub largest_use: f64,
}

impl RasterizerReport {
    /// A report without cases.
    pub fn new(rasterizer: Rasterizer) -> Self {
        Self {
            rasterizer,
            cases: 0,
            failed: 0,
            largest_use: 0.0,
        }
    }
}

/// A case that failed.
#[derive(Clone, Debug, Serialize)]
pub struct Failure {
    /// Number of the case.
    pub case: u64,
    /// Its category.
    #[serde(rename = "family")]
    pub category: Category,
    /// A sentence for everything that is wrong with it.
    pub faults: Vec<String>,
}

/// The results of a run.
#[derive(Clone, Debug, Serialize)]
pub struct StressReport {
    /// Name of the device.
    pub device: String,
    /// Name and version of the driver.
    pub driver: String,
    /// Seed of the cases.
    pub seed: u64,
    /// Cases drawn.
    pub cases: usize,
    /// Each category that had a case.
    #[serde(rename = "families")]
    pub categories: Vec<CategoryReport>,
    /// Each rasterizer.
    pub rasterizers: Vec<RasterizerReport>,
    /// Each case with a fault.
    pub failures: Vec<Failure>,
    /// Every case that drew an image.
    pub all: Vec<StressCaseReport>,
    /// Hash of the bits of all images, hexadecimal: equal in two runs on one device.
    pub digest: String,
    /// The case that took longest on the device, and its time, s.
    pub slowest: Option<(u64, f64)>,
    /// Time of the whole run.
    pub seconds: f64,
    /// Whether the device was lost or hung; no case was drawn after that.
    pub lost: bool,
}

impl StressReport {
    /// Adds the outcome of a case.
    pub fn add(&mut self, case: &StressCase, outcome: &CaseOutcome) {
        self.cases += 1;
        for report in &mut self.categories {
            if report.category == case.category {
                report.add(case.number, outcome);
            }
        }
        let rasterizer = Rasterizer::of(&case.options);
        for report in &mut self.rasterizers {
            if report.rasterizer == rasterizer {
                report.cases += 1;
                report.failed += usize::from(!outcome.faults.is_empty());
                let largest = outcome.largest_use().unwrap_or_default();
                report.largest_use = report.largest_use.max(largest);
            }
        }
        let seconds = outcome.time.as_secs_f64();
        if self.slowest.is_none_or(|(_, slowest)| seconds > slowest) {
            self.slowest = Some((case.number, seconds));
        }
        if let (Some(error), Some(arithmetic)) = (&outcome.error, &outcome.arithmetic) {
            self.all.push(StressCaseReport {
                case: case.number,
                category: case.category,
                options: format!(
                    "{}, {:?}, {}",
                    rasterizer.name(),
                    case.options.color(),
                    case.options.skip
                ),
                covered_pixels: error.covered.pixels,
                psnr_db: error.covered.psnr_db,
                max_error: error.covered.max_error,
                arithmetic_psnr_db: arithmetic.covered.psnr_db,
                arithmetic_max_error: arithmetic.covered.max_error,
                used: outcome.used,
                used_cached: outcome.used_cached,
            });
        }
        if !outcome.faults.is_empty() {
            self.failures.push(Failure {
                case: case.number,
                category: case.category,
                faults: outcome.faults.clone(),
            });
        }
    }
}
