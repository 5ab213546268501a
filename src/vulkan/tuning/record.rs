//! The file that remembers what measurements found: one a device and driver, in the program's cache
//! folder.

use super::{
    candidate::{Axis, Candidate, Workload},
    outcome::Tuning,
};
use crate::vulkan::{
    device::{cache, gpu::Gpu, identity::Identity, sort_choice::ATTEMPTS},
    pipeline::shaders,
};
use serde::{Deserialize, Serialize};
use std::{
    fs,
    path::{Path, PathBuf},
};

/// A candidate that must not be drawn with on this device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Refusal {
    /// In what it differed from a candidate that worked.
    axis: Axis,
    candidate: Candidate,
    why: String,
}

impl Refusal {
    fn is_of(&self, axis: Axis, candidate: &Candidate) -> bool {
        self.axis == axis && axis.is_same(&self.candidate, candidate)
    }
}

/// A candidate that is being tried.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Attempt {
    axis: Axis,
    candidate: Candidate,
    /// How many times it was begun.
    number: u32,
}

#[derive(Serialize, Deserialize)]
struct Content {
    identity: Identity,
    /// Written before the candidate's kernels are compiled, and taken back after its frames.
    trying: Option<Attempt>,
    refusals: Vec<Refusal>,
    tunings: Vec<Tuning>,
}

/// The file. Every failure to read or write it only costs the time of measuring again: a file that
/// is cut, or of another device, driver or program, is as none.
pub struct Record {
    path: Option<PathBuf>,
    identity: Identity,
}

impl Record {
    /// `folder`: None remembers nothing.
    pub fn new(gpu: &Gpu, folder: Option<&Path>) -> Self {
        let key = gpu.probe.cache_key();
        Self {
            path: folder.map(|folder| folder.join(format!("tuning-{key}.json"))),
            identity: Identity::new(gpu, shaders::hash("")),
        }
    }

    /// The record in the program's cache folder.
    pub fn of_device(gpu: &Gpu) -> Self {
        Self::new(gpu, cache::folder().as_deref())
    }

    /// What was measured of every workload.
    pub fn tunings(&self) -> Vec<Tuning> {
        self.content().tunings
    }

    /// What was measured of a workload. None where nothing was, or its best is refused since.
    pub fn tuning(&self, workload: &Workload) -> Option<Tuning> {
        let mut tunings = self.tunings().into_iter();
        let tuning = tunings.find(|tuning| tuning.workload == *workload)?;
        let is_refused = Axis::ALL.into_iter().any(|axis| {
            !axis.is_same(&tuning.best, &tuning.safest)
                && self.refusal(axis, &tuning.best).is_some()
        });
        (!is_refused).then_some(tuning)
    }

    /// Why a candidate must not be drawn with, if it must not.
    pub fn refusal(&self, axis: Axis, candidate: &Candidate) -> Option<String> {
        let refusals = self.content().refusals;
        refusals
            .into_iter()
            .find(|refusal| refusal.is_of(axis, candidate))
            .map(|refusal| refusal.why)
    }

    /// Notes that a candidate is tried from now on. If nothing follows, the program has ended:
    /// [`Self::settle`] reads that.
    pub(super) fn begin(&self, axis: Axis, candidate: Candidate) {
        let mut content = self.content();
        let before = content
            .trying
            .filter(|attempt| attempt.axis == axis && attempt.candidate == candidate);
        content.trying = Some(Attempt {
            axis,
            candidate,
            number: 1 + before.map_or(0, |attempt| attempt.number),
        });
        self.save(&content);
    }

    /// Notes how far a workload's measurements have come. No candidate is being tried then.
    pub(super) fn write(&self, tuning: &Tuning) {
        let mut content = self.content();
        content.trying = None;
        put(&mut content, tuning.clone());
        self.save(&content);
    }

    /// Notes that a candidate must not be drawn with on this device: for no workload.
    pub(super) fn refuse(&self, axis: Axis, candidate: Candidate, why: &str) {
        let mut content = self.content();
        content.trying = None;
        content.refusals.push(Refusal {
            axis,
            candidate,
            why: why.to_owned(),
        });
        self.save(&content);
    }

    /// Notes that the best of a workload failed: from now on it is drawn with the safest, and the
    /// first axis on which the best differs is refused. If that was not it, the next failure refuses
    /// the next.
    pub fn strike_off(&self, tuning: &Tuning, why: &str) {
        let mut content = self.content();
        content.trying = None;
        for axis in Axis::ALL {
            if !axis.is_same(&tuning.best, &tuning.safest)
                && !is_refused(&content, axis, &tuning.best)
            {
                content.refusals.push(Refusal {
                    axis,
                    candidate: tuning.best,
                    why: why.to_owned(),
                });
                break;
            }
        }
        put(
            &mut content,
            Tuning::new(tuning.workload.clone(), tuning.safest),
        );
        self.save(&content);
    }

    /// Refuses a candidate during whose trials the program ended, twice: the user may have ended it
    /// the first time. Call it before anything is tried.
    pub(super) fn settle(&self) {
        let mut content = self.content();
        let Some(attempt) = content.trying.filter(|attempt| attempt.number >= ATTEMPTS) else {
            return;
        };
        content.trying = None;
        content.refusals.push(Refusal {
            axis: attempt.axis,
            candidate: attempt.candidate,
            why: format!("the program ended while it was tried, {ATTEMPTS} times"),
        });
        self.save(&content);
    }

    fn content(&self) -> Content {
        let text = self.path.as_ref().and_then(|path| fs::read(path).ok());
        let read: Option<Content> = text.and_then(|text| serde_json::from_slice(&text).ok());
        read.filter(|content| content.identity == self.identity)
            .unwrap_or_else(|| Content {
                identity: self.identity.clone(),
                trying: None,
                refusals: Vec::new(),
                tunings: Vec::new(),
            })
    }

    fn save(&self, content: &Content) {
        let Some(path) = &self.path else { return };
        let written = serde_json::to_vec_pretty(content)
            .map_err(std::io::Error::other)
            .and_then(|text| cache::write(path, &text));
        if let Err(error) = written {
            tracing::debug!("what was measured is not in {}: {error}", path.display());
        }
    }
}

fn is_refused(content: &Content, axis: Axis, candidate: &Candidate) -> bool {
    let mut refusals = content.refusals.iter();
    refusals.any(|refusal| refusal.is_of(axis, candidate))
}

/// Puts a tuning in place of the one of its workload.
fn put(content: &mut Content, tuning: Tuning) {
    content
        .tunings
        .retain(|other| other.workload != tuning.workload);
    content.tunings.push(tuning);
}
