//! The file that remembers what measurements found: one for each device and way to open it, in the
//! program's cache folder.

use super::{
    candidate::{Axis, Candidate, Workload},
    outcome::Tuning,
};
use crate::vulkan::{
    device::{cache, gpu::Gpu, record_file::RecordFile, sort_choice::ATTEMPTS},
    pipeline::shaders,
    sort::record::Record as SortRecord,
};
use serde::{Deserialize, Serialize};
use std::{
    path::Path,
    sync::{Mutex, MutexGuard, PoisonError},
};

/// A candidate that must not be drawn with on this device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Refusal {
    /// In what it differed from a candidate that worked.
    axis: Axis,
    candidate: Candidate,
    why: String,
}

/// A candidate that is being tried.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Attempt {
    axis: Axis,
    candidate: Candidate,
    /// How many times it was begun.
    number: u32,
}

#[derive(Default, Serialize, Deserialize)]
struct Content {
    /// Written before the candidate's kernels are compiled, and taken back after its frames.
    trying: Option<Attempt>,
    refusals: Vec<Refusal>,
    tunings: Vec<Tuning>,
}

impl Content {
    fn refusal(&self, axis: Axis, candidate: &Candidate) -> Option<&Refusal> {
        let mut refusals = self.refusals.iter();
        refusals.find(|refusal| refusal.axis == axis && axis.is_same(&refusal.candidate, candidate))
    }

    /// Puts a tuning in place of the one of its workload.
    fn put(&mut self, tuning: Tuning) {
        self.tunings
            .retain(|other| other.workload != tuning.workload);
        self.tunings.push(tuning);
    }
}

/// Held while the file is read and written: a window strikes its way to draw off while trials go on
/// behind it.
static CHANGING: Mutex<()> = Mutex::new(());

/// What a record has under way.
#[derive(Clone, Copy, PartialEq)]
enum Trial {
    None,
    /// The attempt that the file names.
    Begun,
    /// The program ends: no trial begins any more.
    Withdrawn,
}

/// What the file says.
pub struct Record {
    file: RecordFile,
    trial: Mutex<Trial>,
    /// That of the sorts, which are tested before anything is tried.
    sorts: SortRecord,
}

impl Record {
    /// `folder`: None remembers nothing.
    pub fn new(gpu: &Gpu, folder: Option<&Path>) -> Self {
        Self {
            file: RecordFile::new(gpu, folder, "tuning", shaders::all_hash()),
            trial: Mutex::new(Trial::None),
            sorts: SortRecord::new(gpu, folder),
        }
    }

    /// The record in the program's cache folder.
    pub fn of_device(gpu: &Gpu) -> Self {
        Self::new(gpu, cache::folder().as_deref())
    }

    /// Whether it is about this device, as it was opened.
    pub fn is_of(&self, gpu: &Gpu) -> bool {
        self.file.is_of(gpu)
    }

    /// What was measured of every workload.
    pub fn tunings(&self) -> Vec<Tuning> {
        self.content().tunings
    }

    /// What was measured of a workload. None where nothing was, or its best is refused since.
    pub fn tuning(&self, workload: &Workload) -> Option<Tuning> {
        let content = self.content();
        let mut tunings = content.tunings.iter();
        let tuning = tunings.find(|tuning| tuning.workload == *workload)?;
        let is_refused = tuning
            .axes_of_best()
            .any(|axis| content.refusal(axis, &tuning.best).is_some());
        (!is_refused).then(|| tuning.clone())
    }

    /// Why a candidate must not be drawn with, if it must not.
    pub fn refusal(&self, axis: Axis, candidate: &Candidate) -> Option<String> {
        let content = self.content();
        content
            .refusal(axis, candidate)
            .map(|refusal| refusal.why.clone())
    }

    /// Notes that a candidate is tried from now on. If nothing follows, the program has ended:
    /// [`Self::settle`] reads that. Returns false after [`Self::withdraw`]: it must not be tried.
    #[must_use]
    pub(super) fn begin(&self, axis: Axis, candidate: Candidate) -> bool {
        let mut trial = self.trial();
        if *trial == Trial::Withdrawn {
            return false;
        }
        *trial = Trial::Begun;
        self.change(|content| {
            let before = content
                .trying
                .filter(|attempt| attempt.axis == axis && attempt.candidate == candidate);
            content.trying = Some(Attempt {
                axis,
                candidate,
                number: 1 + before.map_or(0, |attempt| attempt.number),
            });
        });
        true
    }

    /// The program ends in good order: that a candidate's trial, or a sort's test before it, has no
    /// end says nothing about it.
    /// Whatever the trials' thread still does, no other candidate is begun.
    pub fn withdraw(&self) {
        self.sorts.withdraw();
        let mut trial = self.trial();
        if *trial == Trial::Begun {
            self.change(|content| {
                content.trying = content.trying.and_then(|attempt| {
                    let number = attempt.number.checked_sub(1)?;
                    (number > 0).then_some(Attempt { number, ..attempt })
                });
            });
        }
        *trial = Trial::Withdrawn;
    }

    /// Notes how far a workload's measurements have come. No candidate is being tried then.
    pub(super) fn write(&self, tuning: &Tuning) {
        self.end_trial(|content| content.put(tuning.clone()));
    }

    /// Notes that a candidate must not be drawn with on this device: for no workload.
    pub(super) fn refuse(&self, axis: Axis, candidate: Candidate, why: &str) {
        self.end_trial(|content| {
            content.refusals.push(Refusal {
                axis,
                candidate,
                why: why.to_owned(),
            });
        });
    }

    /// Changes the content, in which nothing is tried any more.
    fn end_trial(&self, change: impl FnOnce(&mut Content)) {
        let mut trial = self.trial();
        if *trial == Trial::Begun {
            *trial = Trial::None;
        }
        self.change(|content| {
            content.trying = None;
            change(content);
        });
    }

    /// Notes that the best of a workload failed: from now on it is drawn with the safest, and the
    /// first axis on which the best differs is refused. If that was not it, the next failure refuses
    /// the next.
    pub fn strike_off(&self, tuning: &Tuning, why: &str) {
        tracing::warn!("{} failed, and is not used any more: {why}", tuning.best);
        self.change(|content| {
            let axis = tuning
                .axes_of_best()
                .find(|axis| content.refusal(*axis, &tuning.best).is_none());
            content.refusals.extend(axis.map(|axis| Refusal {
                axis,
                candidate: tuning.best,
                why: why.to_owned(),
            }));
            content.put(Tuning::new(tuning.workload.clone(), tuning.safest));
        });
    }

    /// Refuses a candidate during whose trials the program ended, twice: the user may have ended it
    /// the first time. Call it before anything is tried.
    pub(super) fn settle(&self) {
        if self.content().trying.is_none() {
            return;
        }
        self.change(|content| {
            let Some(attempt) = content.trying.filter(|attempt| attempt.number >= ATTEMPTS) else {
                return;
            };
            content.trying = None;
            content.refusals.push(Refusal {
                axis: attempt.axis,
                candidate: attempt.candidate,
                why: format!("the program ended while it was tried, {ATTEMPTS} times"),
            });
        });
    }

    fn trial(&self) -> MutexGuard<'_, Trial> {
        self.trial.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Replaces the content, as one step for all threads.
    fn change(&self, change: impl FnOnce(&mut Content)) {
        let _changing = CHANGING.lock().unwrap_or_else(PoisonError::into_inner);
        let mut content = self.content();
        change(&mut content);
        self.file.write(&content);
    }

    fn content(&self) -> Content {
        self.file.read()
    }
}
