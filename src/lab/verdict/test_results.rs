//! What the harness of the tests recorded: a line a test with outcome, seconds, label, name, and the
//! reason why a test did not run.

use serde::{Deserialize, Serialize};

/// The outcomes of some tests.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TestResults {
    /// Number that passed.
    pub passed: usize,
    /// Names of those that failed.
    pub failed: Vec<String>,
    /// Those that this device can't run.
    pub not_run: Vec<NotRun>,
    /// Names of those that were listed, and of which nothing was heard.
    pub unheard: Vec<String>,
    /// Seconds of all of them, added up over what ran at once.
    pub seconds: f64,
}

/// A test that did not run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotRun {
    /// Its name.
    pub name: String,
    /// Why.
    pub reason: String,
}

impl TestResults {
    /// `listed`: what the test program lists, `NAME: test` a line. `recorded`: its results, in
    /// which names begin with the group's.
    pub fn new(listed: &str, recorded: &str) -> Self {
        let mut results = Self::default();
        let mut heard = Vec::new();
        for line in recorded.lines() {
            let mut words = line.splitn(5, ' ');
            let mut word = || words.next().unwrap_or_default();
            let (outcome, seconds) = (word(), word());
            let (_label, name, reason) = (word(), word(), word());
            let name = name.split_once("::").map_or(name, |(_, name)| name);
            heard.push(name.to_owned());
            results.seconds += seconds.parse::<f64>().unwrap_or_default();
            match outcome {
                "ok" => results.passed += 1,
                "ignored" => results.not_run.push(NotRun {
                    name: name.to_owned(),
                    reason: reason.trim().to_owned(),
                }),
                _ => results.failed.push(name.to_owned()),
            }
        }
        let listed = listed
            .lines()
            .filter_map(|line| line.strip_suffix(": test"));
        results.unheard = listed
            .filter(|name| heard.iter().all(|known| known != name))
            .map(str::to_owned)
            .collect();
        results
    }

    /// Whether every test that the device can run passed, and some did.
    pub fn is_right(&self) -> bool {
        self.passed > 0 && self.failed.is_empty() && self.unheard.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_test_of_which_nothing_was_heard_has_not_passed() {
        let listed = "a::one: test\na::two: test\nb::three: test\nb::four: test\n";
        let recorded = "ok 0.50 gpu gpu::a::one \nignored 0.00 gpu gpu::a::two no f16 storage\n\
                        FAILED 2.00 gpu gpu::b::three \n";
        let results = TestResults::new(listed, recorded);
        assert_eq!(results.passed, 1);
        assert_eq!(results.failed, ["b::three"]);
        assert_eq!(results.not_run[0].reason, "no f16 storage");
        assert_eq!(results.unheard, ["b::four"]);
        assert_eq!(results.seconds, 2.5);
        assert!(!results.is_right());
        assert!(TestResults::new("a: test\n", "ok 1 gpu gpu::a \n").is_right());
        assert!(!TestResults::new("", "").is_right());
    }
}
