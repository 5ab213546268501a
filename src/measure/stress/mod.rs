//! Numerical stability: a seed and some numbers of cases go in, what came of drawing every one comes out.
//!
//! Each case is an avatar, a pose, a camera and options made to be hard ([`Family`] says how), drawn on the device and by the f64
//! reference. No pixel may be NaN or out of range, the same frame must give the same bits again, nothing may hang or be complained
//! about, and the picture stays within its family's [`Bound`], with the model's rounding and without. A case is made from the seed and its number alone.

mod body;
mod case;
mod family;
mod hostile;
mod refusal;
mod trial;

use crate::{measure::error::Error, vulkan::Gpu};
pub use case::Case;
pub use family::{Bound, Family};
use serde::Serialize;
use std::{ops::Range, sync::Arc, time::Instant};
pub use trial::{Outcome, run as try_case};

/// Which cases to draw.
#[derive(Clone, Debug)]
pub struct Settings {
    pub seed: u64,
    pub cases: Range<u64>,
    /// Pictures of 8192 × 8192 px too.
    pub large: bool,
}

/// What came of a family's cases.
#[derive(Clone, Debug, Serialize)]
pub struct FamilyReport {
    pub family: Family,
    pub what: &'static str,
    pub cases: usize,
    pub failed: usize,
    /// How many pictures hang on less than f32 can tell, and were held to no more than that.
    pub ill_posed: usize,
    /// Lowest PSNR over covered pixels, dB, and the case that had it. Null where no case drew anything.
    pub worst_psnr_db: Option<f64>,
    pub worst_case: Option<u64>,
    /// The same of the device's arithmetic alone, without the model's rounding.
    pub arithmetic_worst_psnr_db: Option<f64>,
    pub arithmetic_worst_case: Option<u64>,
    /// Largest error of any channel by the arithmetic, and the case that had it.
    pub max_error: f64,
    pub max_error_case: Option<u64>,
    pub seconds: f64,
}

/// What came of a case.
#[derive(Clone, Debug, Serialize)]
pub struct CaseReport {
    pub case: u64,
    pub family: Family,
    pub options: String,
    pub covered_pixels: usize,
    pub psnr_db: f64,
    pub max_error: f64,
    /// The same two of the device's arithmetic alone: against the reference's picture of the model as device memory holds it.
    pub arithmetic_psnr_db: f64,
    pub arithmetic_max_error: f64,
    pub bound: Bound,
    /// How well the reference itself determines the picture, dB, where that had to be asked.
    pub conditioned_db: Option<f64>,
}

/// A case that failed.
#[derive(Clone, Debug, Serialize)]
pub struct Failure {
    pub case: u64,
    pub family: Family,
    pub faults: Vec<String>,
}

/// What a run found; its fields are the JSON's.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    pub device: String,
    pub driver: String,
    pub seed: u64,
    pub cases: usize,
    pub families: Vec<FamilyReport>,
    pub failures: Vec<Failure>,
    /// Every case that drew a picture.
    pub all: Vec<CaseReport>,
    /// Of the bits of all pictures, hexadecimal: two runs on one device give the same.
    pub digest: String,
    /// The case that took longest on the device, and how long, s.
    pub slowest: Option<(u64, f64)>,
    pub seconds: f64,
    /// The device was lost or hung; what came after was not drawn.
    pub lost: bool,
}

/// Draws the cases. `progress` is told how many of how many are done, and how many failed.
pub fn run(gpu: &Arc<Gpu>, settings: &Settings, progress: &mut dyn FnMut(usize, usize, usize)) -> Report {
    let start = Instant::now();
    let mut report = Report {
        device: gpu.probe.name.clone(),
        driver: gpu.probe.driver.clone(),
        seed: settings.seed,
        cases: 0,
        families: Family::ALL.iter().copied().map(FamilyReport::new).collect(),
        failures: vec![],
        all: vec![],
        digest: String::new(),
        slowest: None,
        seconds: 0.0,
        lost: false,
    };
    let (total, mut digest) = ((settings.cases.end - settings.cases.start) as usize, 0);
    for number in settings.cases.clone() {
        let case = Case::new(settings.seed, number, settings.large).on(&gpu.probe);
        let outcome = try_case(gpu, &case);
        digest = crate::bake::math::hash(digest ^ outcome.digest);
        report.add(&case, &outcome);
        progress(report.cases, total, report.failures.len());
        if outcome.lost {
            report.lost = true;
            break;
        }
    }
    report.families.retain(|family| family.cases > 0);
    report.digest = format!("{digest:016x}");
    report.seconds = start.elapsed().as_secs_f64();
    report
}

impl FamilyReport {
    fn new(family: Family) -> Self {
        let what = family.what();
        Self {
            family,
            what,
            cases: 0,
            failed: 0,
            ill_posed: 0,
            worst_psnr_db: None,
            worst_case: None,
            arithmetic_worst_psnr_db: None,
            arithmetic_worst_case: None,
            max_error: 0.0,
            max_error_case: None,
            seconds: 0.0,
        }
    }

    fn add(&mut self, number: u64, outcome: &Outcome) {
        self.cases += 1;
        self.failed += usize::from(!outcome.faults.is_empty());
        self.seconds += outcome.time.as_secs_f64();
        self.ill_posed += usize::from(outcome.conditioned_db.is_some() && outcome.faults.is_empty());
        let drew = |error: Option<Error>| error.map(|error| error.covered).filter(|covered| covered.pixels > 0);
        let (Some(all), Some(arithmetic)) = (drew(outcome.error), drew(outcome.arithmetic)) else { return };
        if self.worst_psnr_db.is_none_or(|worst| all.psnr_db < worst) {
            (self.worst_psnr_db, self.worst_case) = (Some(all.psnr_db), Some(number));
        }
        if self.arithmetic_worst_psnr_db.is_none_or(|worst| arithmetic.psnr_db < worst) {
            (self.arithmetic_worst_psnr_db, self.arithmetic_worst_case) = (Some(arithmetic.psnr_db), Some(number));
        }
        if arithmetic.max_error > self.max_error {
            (self.max_error, self.max_error_case) = (arithmetic.max_error, Some(number));
        }
    }
}

impl Report {
    fn add(&mut self, case: &Case, outcome: &Outcome) {
        self.cases += 1;
        if let Some(family) = self.families.iter_mut().find(|family| family.family == case.family) {
            family.add(case.number, outcome);
        }
        let seconds = outcome.time.as_secs_f64();
        if self.slowest.is_none_or(|(_, slowest)| seconds > slowest) {
            self.slowest = Some((case.number, seconds));
        }
        self.all.extend(outcome.error.zip(outcome.arithmetic).map(|(error, arithmetic)| CaseReport {
            case: case.number,
            family: case.family,
            options: format!("{:?}, {:?}, {}", case.options.color.unwrap_or_default(), case.options.key_bits, case.options.skip),
            covered_pixels: error.covered.pixels,
            psnr_db: error.covered.psnr_db,
            max_error: error.covered.max_error,
            arithmetic_psnr_db: arithmetic.covered.psnr_db,
            arithmetic_max_error: arithmetic.covered.max_error,
            bound: outcome.bound,
            conditioned_db: outcome.conditioned_db,
        }));
        if !outcome.faults.is_empty() {
            self.failures.push(Failure { case: case.number, family: case.family, faults: outcome.faults.clone() });
        }
    }
}
