//! The steps of a run, as its script recorded them: a line each of `steps.tsv`, and their plan.

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

/// A step of the script that was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerdictStep {
    /// Its name, also that of its log.
    pub name: String,
    /// How it ended.
    pub outcome: StepOutcome,
    /// How long it took, seconds.
    pub seconds: f64,
    /// How long it might have taken, seconds.
    pub limit_seconds: f64,
    /// Why it did not pass, as far as the script knows.
    pub note: String,
}

/// The steps of a plan, a name a line, with what became of each. A step without a line in `table`
/// did not run, nor did one whose line can't be read.
pub fn steps(plan: &str, table: &str) -> Vec<VerdictStep> {
    let recorded: Vec<VerdictStep> = table.lines().filter_map(step).collect();
    let names = plan.lines().map(str::trim).filter(|name| !name.is_empty());
    let planned = names.map(|name| {
        let own = recorded.iter().find(|step| step.name == name);
        own.cloned().unwrap_or_else(|| VerdictStep {
            name: name.to_owned(),
            outcome: StepOutcome::NotRun,
            seconds: 0.0,
            limit_seconds: 0.0,
            note: "the run ended before it".to_owned(),
        })
    });
    planned.collect()
}

/// A line: name, outcome, seconds, limit, note; tabs between them.
fn step(line: &str) -> Option<VerdictStep> {
    let mut cells = line.split('\t');
    let mut cell = || cells.next().map(str::trim);
    Some(VerdictStep {
        name: cell()?.to_owned(),
        outcome: match cell()? {
            "passed" => StepOutcome::Passed,
            "failed" => StepOutcome::Failed,
            "timed-out" => StepOutcome::TimedOut,
            "not-run" => StepOutcome::NotRun,
            _ => return None,
        },
        seconds: cell()?.parse().ok()?,
        limit_seconds: cell()?.parse().ok()?,
        note: cell().unwrap_or_default().to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_without_a_readable_line_did_not_run() {
        let table = "sort\tpassed\t3.5\t60\t\nsoak\tpassed\tsoon\t9\nother\tfailed\t1\t2\tcode 1\n";
        let found = steps("sort\nsoak\n\nbench\nother\n", table);
        let outcomes: Vec<_> = found.iter().map(|step| step.outcome).collect();
        use StepOutcome::{Failed, NotRun, Passed};
        assert_eq!(outcomes, [Passed, NotRun, NotRun, Failed]);
        assert_eq!(found[0].seconds, 3.5);
        assert_eq!(found[3].note, "code 1");
    }
}
