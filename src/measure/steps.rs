//! The steps of a run that goes on when one of them fails, and what became of each.

use serde::{Deserialize, Serialize};

/// How a step ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StepOutcome {
    /// It ended in time and without a fault.
    Passed,
    /// It found a fault, or could not do what it was for.
    Failed,
    /// It was stopped when its time was over.
    TimedOut,
    /// It did not run, or nothing says that it ended.
    NotRun,
}

impl StepOutcome {
    /// The outcome in words, in Markdown: what is wrong is bold.
    pub fn words(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "**failed**",
            Self::TimedOut => "**timed out**",
            Self::NotRun => "**did not run**",
        }
    }
}

/// A step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Step {
    /// Its name.
    pub name: String,
    /// How it ended.
    pub outcome: StepOutcome,
    /// How long it took, seconds.
    pub seconds: f64,
    /// How long it might have taken, seconds.
    pub limit_seconds: f64,
    /// Why it did not pass, as far as the run knows.
    pub note: String,
}
