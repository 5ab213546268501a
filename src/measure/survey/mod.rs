//! A survey of a device in three minutes, for somebody who owns one that nobody here has: rates, the
//! sort's self-test, frames of each way to draw with their error, memory, and a short soak.
//!
//! [`measure`] does all of it but the soak, which is drawn in a window. [`SurveyReport`] is the whole
//! JSON file; the fields are its keys. Nothing in it tells who measured: no command line, no paths,
//! no names of avatars and clips, of the date only the day.

mod run;
mod words;

pub use run::{SurveyTask, measure};

use crate::{
    bench::BenchReport,
    rates::RatesReport,
    report::{DeviceReport, Program, ReadError, Subject, read_report},
    soak::SoakReport,
    steps::{Step, StepOutcome},
};
use effigy_core::frame::SortVariant;
use effigy_render::vulkan::trial::Tried;
use serde::{Deserialize, Serialize};

/// Version of the JSON. It changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-survey-1";

/// Length of a whole survey, minutes.
pub const MINUTES: f64 = 3.0;
/// Length of its soak, seconds.
const SOAK_SECONDS: f64 = 75.0;
/// The steps in order, with the most that each may take, seconds. The soak's is its length.
const STEPS: [(&str, f64); 4] = [
    ("rates", 60.0),
    ("sorts", 30.0),
    ("frames", 120.0),
    (SOAK, SOAK_SECONDS),
];
const SOAK: &str = "soak";
/// Note of a step of which nothing has been heard.
const UNEXPLAINED: &str = "the program ended before it was over";

/// Length of the soak of a survey that is to take `minutes`, seconds.
pub fn soak_seconds(minutes: f64) -> f64 {
    SOAK_SECONDS * minutes / MINUTES
}

/// Everything that a survey found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SurveyReport {
    /// [`SCHEMA`].
    pub schema: String,
    /// Whether nothing more will be added: the survey is complete, or was interrupted.
    pub over: bool,
    /// The program that measured.
    pub program: Program,
    /// The machine and its system in words.
    pub system: String,
    /// The device that was measured.
    pub device: DeviceReport,
    /// Every step that was planned.
    pub steps: Vec<Step>,
    /// What the self-test says of each sort.
    pub sorts: Vec<Tried<SortVariant>>,
    /// Copies and fill rates.
    pub rates: Option<RatesReport>,
    /// Frames, a report for each way to draw.
    pub frames: Vec<BenchReport>,
    /// The soak, as long as it lasted.
    pub soak: Option<SoakReport>,
}

impl SurveyReport {
    /// A report of which nothing is measured yet.
    pub fn new(system: String, device: DeviceReport) -> Self {
        let mut program = Program::current(Vec::new());
        program.date.truncate("2026-11-28".len());
        let steps = STEPS.map(|(name, limit_seconds)| Step {
            name: name.to_owned(),
            outcome: StepOutcome::NotRun,
            seconds: 0.0,
            limit_seconds,
            note: UNEXPLAINED.to_owned(),
        });
        Self {
            schema: SCHEMA.to_owned(),
            over: false,
            program,
            system,
            device,
            steps: steps.into(),
            sorts: Vec::new(),
            rates: None,
            frames: Vec::new(),
            soak: None,
        }
    }

    /// Reads a report's JSON.
    ///
    /// # Errors
    /// When the text is something else.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        read_report(text, SCHEMA)
    }

    /// The report as JSON on one line.
    pub fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    /// Whether every step passed.
    pub fn is_complete(&self) -> bool {
        let mut steps = self.steps.iter();
        steps.all(|step| step.outcome == StepOutcome::Passed)
    }

    /// Says what became of a step.
    fn end_step(&mut self, name: &str, outcome: StepOutcome, seconds: f64, note: String) {
        if let Some(step) = self.steps.iter_mut().find(|step| step.name == name) {
            step.outcome = outcome;
            step.seconds = seconds;
            step.note = note;
        }
    }

    /// Adds the soak. It passed if it lasted as long as it was to.
    pub fn add_soak(&mut self, mut soak: SoakReport) {
        soak.program = self.program.clone();
        unname(&mut soak.avatar);
        let seconds = soak.lasted_seconds;
        if let Some(step) = self.steps.iter_mut().find(|step| step.name == SOAK) {
            step.limit_seconds = soak.planned_seconds;
        }
        if seconds >= soak.planned_seconds {
            self.end_step(SOAK, StepOutcome::Passed, seconds, String::new());
        }
        self.soak = Some(soak);
    }

    /// Says why steps have not ended, where nobody has yet.
    pub fn explain(&mut self, why: &str) {
        let steps = self.steps.iter_mut();
        for step in steps.filter(|step| step.note == UNEXPLAINED) {
            step.note = why.to_owned();
        }
    }
}

/// An avatar and a clip without their names, which may be a person's.
fn unname(subject: &mut Subject) {
    subject.name.clear();
    subject.clip.clear();
}
