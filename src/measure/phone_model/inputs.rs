//! The model's inputs: files of a folder, each made by something else.

use super::range::Range;
use crate::{
    bench::{
        self, BenchReport,
        report::{CaseReport, StageReport},
    },
    report::read_report,
};
use effigy_core::frame::passes::Stage;
use serde::Deserialize;
use std::{fs, io, path::Path};

/// Why the inputs can't be used.
#[derive(Debug, thiserror::Error)]
pub enum InputError {
    /// A file can't be read.
    #[error("{file}: {source}")]
    Io {
        /// Its path.
        file: String,
        /// Why.
        source: io::Error,
    },
    /// A file is not what it should be.
    #[error("{file}: {what}")]
    Content {
        /// Its path.
        file: String,
        /// What is wrong with it.
        what: String,
    },
    /// Something is in no file.
    #[error("there is no {0}")]
    Missing(String),
    /// A file has several lines where it must have one.
    #[error("there are {found} lines with the {what}, where one is expected")]
    Repeated {
        /// What they are about.
        what: String,
        /// How many there are.
        found: usize,
    },
    /// A device can't do something at all.
    #[error("the {what} is from {low} {unit}, where more than 0 is expected")]
    NoRate {
        /// The rate and its device.
        what: String,
        /// Its lower bound.
        low: f64,
        /// The unit.
        unit: String,
    },
}

/// A device, a line of `devices.csv`.
#[derive(Clone, Debug, Deserialize)]
pub struct Device {
    /// Its name.
    pub device: String,
    /// A chip that has it.
    pub chip: String,
    /// The device whose compiler counted the instructions.
    pub compiled_as: String,
    /// Why that is another device; empty if it is not.
    pub why: String,
}

/// A rate of a device with its source, a line of `rates.csv`.
#[derive(Clone, Debug, Deserialize)]
pub struct Rate {
    /// The device.
    pub device: String,
    /// Name of the rate.
    pub rate: String,
    /// Lower bound.
    pub low: f64,
    /// Upper bound.
    pub high: f64,
    /// Unit of both.
    pub unit: String,
    /// Where both are from.
    pub source: String,
}

/// Instructions of a shader, a line of the file that `tools/shader_stats.sh` writes.
#[derive(Clone, Debug, Deserialize)]
struct Program {
    device: String,
    shader: String,
    program: String,
    instructions: f64,
}

/// A way to draw, and what it was counted to do: a file of `effigy bench --json`.
#[derive(Clone, Debug)]
pub struct Counted {
    /// Its name.
    pub name: &'static str,
    /// The counts of the one case.
    pub case: CaseReport,
    /// The measurement that they are from.
    pub report: BenchReport,
}

/// The ways to draw, by file.
const COUNTED: [CountedFile; 3] = [
    CountedFile {
        file: "quads.json",
        name: "quads with the saturation depth",
    },
    CountedFile {
        file: "quads-untested.json",
        name: "quads without it",
    },
    CountedFile {
        file: "tiles-shared.json",
        name: "tiles in shared memory",
    },
];

struct CountedFile {
    file: &'static str,
    name: &'static str,
}

/// Everything that the model is made from.
#[derive(Clone, Debug)]
pub struct Inputs {
    /// The devices, in order.
    pub devices: Vec<Device>,
    /// Their rates.
    pub rates: Vec<Rate>,
    /// The ways to draw.
    pub counted: Vec<Counted>,
    programs: Vec<Program>,
}

impl Inputs {
    /// Reads the inputs. `folder`: with `devices.csv`, `rates.csv` and the counts; `shaders`: what
    /// `tools/shader_stats.sh` wrote.
    ///
    /// # Errors
    /// When a file is missing or is something else.
    pub fn read(folder: &Path, shaders: &Path) -> Result<Self, InputError> {
        let rates: Vec<Rate> = table(&folder.join("rates.csv"))?;
        for rate in &rates {
            let ordered = 0.0 <= rate.low && rate.low <= rate.high && rate.high.is_finite();
            if !ordered || rate.source.trim().is_empty() {
                return Err(InputError::Content {
                    file: "rates.csv".to_owned(),
                    what: format!(
                        "{} of {} has no source, or no bounds in order",
                        rate.rate, rate.device
                    ),
                });
            }
        }
        let counted = COUNTED
            .iter()
            .map(|counted| counted.read(folder))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            devices: table(&folder.join("devices.csv"))?,
            rates,
            counted,
            programs: table(shaders)?,
        })
    }

    /// A rate of a device, by which work is divided: more than 0.
    pub(super) fn rate(&self, device: &Device, name: &str) -> Result<Range, InputError> {
        let rate = self.line(device, name)?;
        if rate.low <= 0.0 {
            return Err(InputError::NoRate {
                what: format!("rate `{name}` of {}", device.device),
                low: rate.low,
                unit: rate.unit.clone(),
            });
        }
        Ok(Range {
            low: rate.low,
            high: rate.high,
        })
    }

    /// An amount that a device moves, which may be 0.
    pub(super) fn amount(&self, device: &Device, name: &str) -> Result<Range, InputError> {
        let amount = self.line(device, name)?;
        Ok(Range {
            low: amount.low,
            high: amount.high,
        })
    }

    fn line(&self, device: &Device, name: &str) -> Result<&Rate, InputError> {
        let is_it = |rate: &&Rate| rate.device == device.device && rate.rate == name;
        only(self.rates.iter().filter(is_it), || {
            format!("rate `{name}` of {}", device.device)
        })
    }

    /// Instructions of a shader on a device. `program`: the names that compilers give the one
    /// program that is meant.
    pub(super) fn instructions(
        &self,
        device: &Device,
        shader: &str,
        program: &[&str],
    ) -> Result<f64, InputError> {
        let is_it = |row: &&Program| {
            row.device == device.compiled_as
                && row.shader == shader
                && program.contains(&row.program.as_str())
        };
        let found = only(self.programs.iter().filter(is_it), || {
            let names = program.join("` or `");
            format!("count of {shader}, `{names}`, on {}", device.compiled_as)
        })?;
        Ok(found.instructions)
    }
}

/// The only one of some lines. `what`: what they are about.
fn only<'a, T>(
    mut lines: impl Iterator<Item = &'a T>,
    what: impl Fn() -> String,
) -> Result<&'a T, InputError> {
    let line = lines.next().ok_or_else(|| InputError::Missing(what()))?;
    match lines.count() {
        0 => Ok(line),
        more => Err(InputError::Repeated {
            what: what(),
            found: 1 + more,
        }),
    }
}

impl CountedFile {
    fn read(&self, folder: &Path) -> Result<Counted, InputError> {
        let path = folder.join(self.file);
        let wrong = |what: String| InputError::Content {
            file: path.display().to_string(),
            what,
        };
        let report: BenchReport = read_report(&text(&path)?, bench::report::SCHEMA)
            .map_err(|error| wrong(error.to_string()))?;
        let case = report.cases.first().cloned();
        Ok(Counted {
            name: self.name,
            case: case.ok_or_else(|| wrong("it has no case".to_owned()))?,
            report,
        })
    }
}

impl Counted {
    /// A counter's mean over the frames.
    pub(super) fn counter(&self, name: &str) -> Result<f64, InputError> {
        let counter = self.case.counters.get(name).copied();
        counter.ok_or_else(|| InputError::Missing(format!("count of {name} for {}", self.name)))
    }

    /// The stages that ran, in order. Counts may be older than the stages of today.
    pub(super) fn stages(&self) -> impl Iterator<Item = &StageReport> {
        let exists = |stage: &&StageReport| Stage::ALL.iter().any(|own| own.name() == stage.name);
        self.case
            .stages
            .iter()
            .filter(exists)
            .filter(|stage| stage.ran > 0.0)
    }
}

fn text(path: &Path) -> Result<String, InputError> {
    fs::read_to_string(path).map_err(|source| InputError::Io {
        file: path.display().to_string(),
        source,
    })
}

fn table<T: for<'de> Deserialize<'de>>(path: &Path) -> Result<Vec<T>, InputError> {
    let text = text(path)?;
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let rows = reader.deserialize().collect::<Result<_, _>>();
    rows.map_err(|error: csv::Error| InputError::Content {
        file: path.display().to_string(),
        what: error.to_string(),
    })
}
