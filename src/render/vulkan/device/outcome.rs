//! What trials of variants on a device found.

use effigy_core::frame::SortVariant;
use serde::{Deserialize, Serialize};
use std::fmt;

/// How often a variant is tried whose earlier trials never ended: one may have crashed the program,
/// or the user may have ended it.
pub(super) const ATTEMPTS: u32 = 2;

/// Outcome of a variant's trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum TrialOutcome {
    /// Right everywhere; the time that the trial took it, ms.
    Right(f64),
    /// The device can't run it.
    Unsupported(String),
    /// It gave something wrong, did not finish in time, or failed.
    Refused(String),
    /// The program ended in its trial, more than once.
    Unfinished,
}

impl fmt::Display for TrialOutcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Right(ms) => write!(f, "{ms:.3} ms"),
            Self::Unsupported(why) => write!(f, "not used: {why}"),
            Self::Refused(why) => write!(f, "refused: {why}"),
            Self::Unfinished => write!(
                f,
                "refused: the program ended during its trial, {ATTEMPTS} times"
            ),
        }
    }
}

/// A variant, and the outcome of its trial. In JSON it is a pair.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "(V, TrialOutcome)", into = "(V, TrialOutcome)")]
pub struct Tried<V: Clone> {
    /// The variant.
    pub variant: V,
    /// The outcome.
    pub outcome: TrialOutcome,
}

impl<V: Clone> From<(V, TrialOutcome)> for Tried<V> {
    fn from((variant, outcome): (V, TrialOutcome)) -> Self {
        Self { variant, outcome }
    }
}

impl<V: Clone> From<Tried<V>> for (V, TrialOutcome) {
    fn from(tried: Tried<V>) -> Self {
        (tried.variant, tried.outcome)
    }
}

impl<V: Copy + PartialEq> Tried<V> {
    /// The outcome of a variant among several. None where it was not tried.
    pub fn outcome_of(tried: &[Self], variant: V) -> Option<&TrialOutcome> {
        let own = tried.iter().find(|tried| tried.variant == variant)?;
        Some(&own.outcome)
    }

    /// The time of a variant that is right, ms.
    pub(crate) fn ms_of(tried: &[Self], variant: V) -> Option<f64> {
        tried.iter().find(|tried| tried.variant == variant)?.ms()
    }

    /// Its time, ms, if it is right.
    fn ms(&self) -> Option<f64> {
        match self.outcome {
            TrialOutcome::Right(ms) => Some(ms),
            _ => None,
        }
    }
}

/// How to sort on a device, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SortChoice {
    /// The variant.
    pub variant: SortVariant,
    /// What came of each that was tried.
    pub tried: Vec<Tried<SortVariant>>,
}

impl SortChoice {
    /// The fastest variant that is right. None where none is.
    pub fn fastest(tried: &[Tried<SortVariant>]) -> Option<Self> {
        let timed = tried
            .iter()
            .filter_map(|tried| Some((tried.variant, tried.ms()?)));
        let (variant, _) = timed.min_by(|(_, a), (_, b)| a.total_cmp(b))?;
        Some(Self {
            variant,
            tried: tried.to_vec(),
        })
    }
}
