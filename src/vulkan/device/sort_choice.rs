//! Results of the sort's self-test on a device. `sort::choice` runs it; the device keeps them.

use effigy_core::frame::SortVariant;
use serde::{Deserialize, Serialize};
use std::{
    fmt,
    sync::{Mutex, OnceLock},
};

/// How often a variant is tested whose earlier tests never ended: a test may have crashed the
/// program, or the user may have ended it.
pub(crate) const ATTEMPTS: u32 = 2;

/// Outcome of a variant's test.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Outcome {
    /// Right everywhere; the best time for the test's keys, ms.
    Right(f64),
    /// The device can't run it, or has no use for it.
    Unsupported(String),
    /// It gave something else than the CPU, did not finish in time, or failed.
    Refused(String),
    /// The program ended in its test, more than once.
    Unfinished,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Right(ms) => write!(f, "{ms:.3} ms"),
            Self::Unsupported(why) => write!(f, "not used: {why}"),
            Self::Refused(why) => write!(f, "refused: {why}"),
            Self::Unfinished => write!(
                f,
                "refused: the program ended during its test, {ATTEMPTS} times"
            ),
        }
    }
}

/// A variant, and the outcome of its test. In JSON it is a pair.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "(SortVariant, Outcome)", into = "(SortVariant, Outcome)")]
pub struct TestedVariant {
    /// The variant.
    pub variant: SortVariant,
    /// The outcome.
    pub outcome: Outcome,
}

impl From<(SortVariant, Outcome)> for TestedVariant {
    fn from((variant, outcome): (SortVariant, Outcome)) -> Self {
        Self { variant, outcome }
    }
}

impl From<TestedVariant> for (SortVariant, Outcome) {
    fn from(tested: TestedVariant) -> Self {
        (tested.variant, tested.outcome)
    }
}

impl TestedVariant {
    /// The outcome of a variant among several. None where it was not tested.
    pub fn outcome_of(tested: &[Self], variant: SortVariant) -> Option<&Outcome> {
        let own = tested.iter().find(|tested| tested.variant == variant)?;
        Some(&own.outcome)
    }
}

/// How to sort on a device, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SortChoice {
    /// The fastest variant that sorts correctly.
    pub variant: SortVariant,
    /// The result of each variant's test.
    pub tried: Vec<TestedVariant>,
}

impl SortChoice {
    /// The choice of the fastest variant that sorts correctly. None where none does.
    pub fn fastest(tried: &[TestedVariant]) -> Option<Self> {
        let mut fastest: Option<(SortVariant, f64)> = None;
        for tested in tried {
            if let Outcome::Right(ms) = tested.outcome
                && fastest.is_none_or(|(_, best)| ms.total_cmp(&best).is_lt())
            {
                fastest = Some((tested.variant, ms));
            }
        }
        fastest.map(|(variant, _)| Self {
            variant,
            tried: tried.to_vec(),
        })
    }
}

/// Results of the self-test while the program runs.
#[derive(Default)]
pub(crate) struct Sorts {
    /// The choice, once it is made.
    pub chosen: OnceLock<SortChoice>,
    /// Outcomes of variants that were asked for by name.
    pub asked: Mutex<Vec<TestedVariant>>,
}
