//! One verdict on a GPU, from the files that a run of `tools/gpu/run.sh` left in a folder, or from
//! the file of a survey, as the app makes it: the
//! steps and what became of them, tests, sorts, rates, frames and a soak. [`Verdict`] is the whole
//! JSON file; the fields are its keys. [`page`](Verdict::page) is the same as a page of Markdown.
//!
//! What is missing in the folder is missing in the verdict. Nothing that did not run counts as
//! passed.

mod named_bench;
mod page;
mod steps;
mod test_results;
mod traffic;

pub use named_bench::NamedBench;
pub use test_results::{NotRun, TestResults};
pub use traffic::StageTraffic;

use crate::{
    sorts::{self, SortsReport},
    training::{self, TrainingReport},
};
use effigy_core::frame::SortVariant;
use effigy_measure::{
    bench::{self, BenchReport},
    rates::{self, RatesReport},
    report::{DeviceReport, Program, read_report},
    soak::{self, SoakReport},
    steps::{Step, StepOutcome},
    survey::SurveyReport,
};
use effigy_render::vulkan::trial::Tried;
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::{fs, io, path::Path};

/// Version of the JSON. It changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-verdict-1";

/// Everything that a run found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// [`SCHEMA`].
    pub schema: String,
    /// The program that joined the files, or that of a survey.
    pub program: Program,
    /// The device. Null if nothing that names it was measured, and in verdicts from before
    /// 28 November 2026.
    #[serde(default)]
    pub device: Option<DeviceReport>,
    /// The machine in the words of its own commands.
    pub machine: String,
    /// Every step that was planned.
    pub steps: Vec<Step>,
    /// The tests on the device. Null if they were not begun.
    pub tests: Option<TestResults>,
    /// What `effigy devices --json` says, as it is: the device's features, and what the renderer
    /// chose for it by measuring.
    pub devices: Option<serde_json::Value>,
    /// Copies and fill rates.
    pub rates: Option<RatesReport>,
    /// What the self-test of a survey says of each sort.
    #[serde(default)]
    pub self_test: Vec<Tried<SortVariant>>,
    /// The sort's matrix.
    pub sorts: Option<SortsReport>,
    /// Steps of a training a second.
    #[serde(default)]
    pub training: Option<TrainingReport>,
    /// Cases and sweeps.
    pub benches: Vec<NamedBench>,
    /// The soak.
    pub soak: Option<SoakReport>,
    /// The stages' bytes against what the device copies.
    pub traffic: Vec<StageTraffic>,
    /// Files that are there and can't be read, and why.
    pub unread: Vec<String>,
}

impl Verdict {
    /// Joins the files of a folder, or reads a survey's file. `command`: the command line.
    ///
    /// # Errors
    /// When the folder can't be read, or has no plan of steps; when the file is no survey's.
    pub fn read(folder: &Path, command: Vec<String>) -> io::Result<Self> {
        if folder.is_file() {
            let survey = SurveyReport::read(&fs::read_to_string(folder)?);
            return survey.map(Self::from).map_err(io::Error::other);
        }
        let mut files = ResultFolder {
            folder,
            unread: Vec::new(),
        };
        let plan = fs::read_to_string(folder.join("plan.txt"))?;
        let table = files.text("steps.tsv").unwrap_or_default();
        let recorded = files.text("tests.txt");
        let listed = files.text("tests-list.txt");
        let tests = (recorded.is_some() || listed.is_some()).then(|| {
            TestResults::new(
                listed.as_deref().unwrap_or_default(),
                recorded.as_deref().unwrap_or_default(),
            )
        });
        let rates: Option<RatesReport> = files.report("rates.json", rates::SCHEMA);
        let mut benches = Vec::new();
        for file in bench_files(folder)? {
            if let Some(report) = files.report(&file, bench::report::SCHEMA) {
                let name = file.trim_start_matches(BENCH).trim_end_matches(JSON);
                benches.push(NamedBench {
                    name: name.to_owned(),
                    report,
                });
            }
        }
        let sorts: Option<SortsReport> = files.report("sorts.json", sorts::SCHEMA);
        let of_rates = rates.iter().map(|rates| &rates.device);
        let of_sorts = sorts.iter().map(|sorts| &sorts.device);
        let of_benches = benches
            .iter()
            .map(|bench: &NamedBench| &bench.report.device);
        let mut devices = of_rates.chain(of_sorts).chain(of_benches);
        Ok(Self {
            device: devices.next().cloned(),
            schema: SCHEMA.to_owned(),
            program: Program::current(command),
            machine: files.text("machine.txt").unwrap_or_default(),
            steps: steps::steps(&plan, &table),
            tests,
            devices: files.json("devices.json"),
            self_test: Vec::new(),
            sorts,
            training: files.report("training.json", training::SCHEMA),
            soak: files.report("soak.json", soak::report::SCHEMA),
            traffic: traffic::traffic(&benches, rates.as_ref()),
            rates,
            benches,
            unread: files.unread,
        })
    }

    /// A sentence for everything that is not right; empty if every step passed, with every test
    /// that the device can run.
    pub fn faults(&self) -> Vec<String> {
        let mut faults: Vec<String> = self
            .steps
            .iter()
            .filter(|step| step.outcome != StepOutcome::Passed)
            .map(|step| {
                let words = step.outcome.words().replace('*', "");
                format!("{} {words}", step.name)
            })
            .collect();
        if let Some(tests) = &self.tests {
            let count = |names: &[String], what: &str| {
                (!names.is_empty()).then(|| format!("{} tests {what}", names.len()))
            };
            faults.extend(count(&tests.failed, "failed"));
            faults.extend(count(&tests.unheard, "did not end"));
            if !tests.is_right() && tests.failed.is_empty() && tests.unheard.is_empty() {
                faults.push("no test passed".into());
            }
        }
        faults.extend(self.unread.iter().cloned());
        faults
    }
}

impl From<SurveyReport> for Verdict {
    fn from(survey: SurveyReport) -> Self {
        let named = |report: BenchReport| NamedBench {
            name: report.options.raster.clone(),
            report,
        };
        let benches: Vec<_> = survey.frames.into_iter().map(named).collect();
        Self {
            schema: SCHEMA.to_owned(),
            program: survey.program,
            device: Some(survey.device),
            machine: survey.system,
            steps: survey.steps,
            tests: None,
            devices: None,
            self_test: survey.sorts,
            sorts: None,
            training: None,
            soak: survey.soak,
            traffic: traffic::traffic(&benches, survey.rates.as_ref()),
            rates: survey.rates,
            benches,
            unread: Vec::new(),
        }
    }
}

const BENCH: &str = "bench-";
const JSON: &str = ".json";

/// Names of the files of measurements of frames, in order.
fn bench_files(folder: &Path) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        if let Ok(name) = entry?.file_name().into_string()
            && name.starts_with(BENCH)
            && name.ends_with(JSON)
        {
            names.push(name);
        }
    }
    names.sort_unstable();
    Ok(names)
}

/// A folder of results, whose files may be missing.
struct ResultFolder<'a> {
    folder: &'a Path,
    unread: Vec<String>,
}

impl ResultFolder<'_> {
    fn text(&mut self, name: &str) -> Option<String> {
        match fs::read_to_string(self.folder.join(name)) {
            Ok(text) => Some(text),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => {
                self.unread.push(format!("{name}: {error}"));
                None
            }
        }
    }

    fn json(&mut self, name: &str) -> Option<serde_json::Value> {
        let text = self.text(name)?;
        let read = serde_json::from_str(&text);
        self.understood(name, read)
    }

    fn report<T: DeserializeOwned>(&mut self, name: &str, schema: &'static str) -> Option<T> {
        let text = self.text(name)?;
        self.understood(name, read_report(&text, schema))
    }

    fn understood<T>(&mut self, name: &str, read: Result<T, impl std::fmt::Display>) -> Option<T> {
        match read {
            Ok(value) => Some(value),
            Err(error) => {
                self.unread.push(format!("{name}: {error}"));
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_run_has_no_step_that_passed() -> io::Result<()> {
        let folder = std::env::temp_dir().join(format!("effigy-verdict-{}", std::process::id()));
        fs::create_dir_all(&folder)?;
        fs::write(folder.join("plan.txt"), "devices\ntests\n")?;
        fs::write(folder.join("steps.tsv"), "devices\tpassed\t1\t30\t\n")?;
        fs::write(folder.join("tests-list.txt"), "a::b: test\n")?;
        fs::write(folder.join("rates.json"), "{\"schema\": \"other\"}")?;
        let verdict = Verdict::read(&folder, Vec::new())?;
        fs::remove_dir_all(&folder)?;
        let faults = verdict.faults();
        assert_eq!(
            faults[..2],
            ["tests did not run", "1 tests did not end"],
            "{faults:?}"
        );
        assert!(faults[2].starts_with("rates.json: its schema is `other`"));
        let page = verdict.page();
        assert!(page.contains("| tests | **did not run** |"), "{page}");
        Ok(())
    }
}
