//! The steps of a run, as its script recorded them: a line each of `steps.tsv`, and their plan.

use effigy_measure::steps::{Step, StepOutcome};

/// The steps of a plan, a name a line, with what became of each. A step without a line in `table`
/// did not run, nor did one whose line can't be read.
pub fn steps(plan: &str, table: &str) -> Vec<Step> {
    let recorded: Vec<Step> = table.lines().filter_map(step).collect();
    let names = plan.lines().map(str::trim).filter(|name| !name.is_empty());
    let planned = names.map(|name| {
        let own = recorded.iter().find(|step| step.name == name);
        own.cloned().unwrap_or_else(|| Step {
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
fn step(line: &str) -> Option<Step> {
    let mut cells = line.split('\t');
    let mut cell = || cells.next().map(str::trim);
    Some(Step {
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
