//! What came of candidates, and how far the measurements of a workload have come.

use super::candidate::{Axis, Candidate, Choices, Workload};
use serde::{Deserialize, Serialize};
use std::fmt;

/// What came of a candidate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Outcome {
    /// It was timed, and its image is right.
    Timed(Timing),
    /// Its image is wrong, or it brought the device down.
    Refused(String),
    /// It could not be tried: too little memory, for instance.
    Untried(String),
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Timed(timing) => write!(f, "{timing}"),
            Self::Refused(why) => write!(f, "refused: {why}"),
            Self::Untried(why) => write!(f, "not tried: {why}"),
        }
    }
}

/// Times of a candidate's frames by those of the candidate that was best then, in turn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// The median ratio.
    pub ratio: f64,
    /// The median distance of the ratios from their median, at least `NOISE`.
    pub noise: f64,
    /// The median time of a frame, ms.
    pub ms: f64,
    /// Frames that were timed.
    pub frames: usize,
}

/// A difference under this share of a frame's time is noise, whatever the ratios say.
const NOISE: f64 = 0.02;

/// A pair of frames, one after the other, ms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FramePair {
    /// By the best so far.
    pub best: f64,
    /// By the candidate.
    pub candidate: f64,
}

impl FramePair {
    /// The candidate's time by the best's. None where either is no time.
    pub fn ratio(&self) -> Option<f64> {
        let ratio = self.candidate / self.best;
        (ratio.is_finite() && ratio > 0.0).then_some(ratio)
    }
}

impl Timing {
    /// None without a pair that has a ratio.
    pub(super) fn new(pairs: &[FramePair]) -> Option<Self> {
        let ratio = median(pairs.iter().filter_map(FramePair::ratio))?;
        let distances = pairs
            .iter()
            .filter_map(FramePair::ratio)
            .map(|other| (other - ratio).abs());
        Some(Self {
            ratio,
            noise: median(distances)?.max(NOISE),
            ms: median(pairs.iter().map(|pair| pair.candidate))?,
            frames: pairs.len(),
        })
    }

    /// Whether the candidate is faster by more than the noise.
    pub fn wins(&self) -> bool {
        self.ratio + self.noise < 1.0
    }
}

impl fmt::Display for Timing {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self {
            ratio,
            noise,
            ms,
            frames,
        } = self;
        write!(
            f,
            "{ratio:.2} ± {noise:.2} of the best so far, {ms:.2} ms, {frames} frames"
        )
    }
}

fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// A candidate, what it was timed against, and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TriedCandidate {
    /// The candidate.
    pub candidate: Candidate,
    /// The best so far.
    pub against: Candidate,
    /// What came of it.
    pub outcome: Outcome,
}

/// How far the measurements of a workload have come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tuning {
    /// What is drawn.
    pub workload: Workload,
    /// What measurements began with.
    pub safest: Candidate,
    /// The fastest so far.
    pub best: Candidate,
    /// What was tried, in order.
    pub tried: Vec<TriedCandidate>,
    /// Candidates of the axis that is measured, that are yet to be tried.
    pub(super) pending: Vec<Candidate>,
    /// Frames of the first of them.
    pub(super) pairs: Vec<FramePair>,
    /// Axes whose candidates were listed.
    pub(super) axes: usize,
}

impl Tuning {
    pub(super) fn new(workload: Workload, safest: Candidate) -> Self {
        Self {
            workload,
            safest,
            best: safest,
            tried: Vec::new(),
            pending: Vec::new(),
            pairs: Vec::new(),
            axes: 0,
        }
    }

    /// The next candidate, and its axis. None once all were tried.
    pub(super) fn next(&mut self, choices: &Choices) -> Option<(Axis, Candidate)> {
        while self.pending.is_empty() {
            let axis = *Axis::ALL.get(self.axes)?;
            self.axes += 1;
            self.pending = choices.candidates(axis, &self.best);
        }
        let axis = *Axis::ALL.get(self.axes.checked_sub(1)?)?;
        Some((axis, self.pending[0]))
    }

    /// Notes what came of the first pending candidate.
    pub(super) fn note(&mut self, outcome: Outcome) {
        let candidate = self.pending.remove(0);
        self.pairs.clear();
        let against = self.best;
        if let Outcome::Timed(timing) = &outcome
            && timing.wins()
        {
            self.best = candidate;
        }
        self.tried.push(TriedCandidate {
            candidate,
            against,
            outcome,
        });
    }

    /// The axes on which the best differs from the safest.
    pub(super) fn axes_of_best(&self) -> impl Iterator<Item = Axis> {
        Axis::ALL
            .into_iter()
            .filter(|axis| !axis.is_same(&self.best, &self.safest))
    }

    /// Why the best is drawn with, in a few words.
    pub fn reason(&self) -> String {
        let timed = |tried: &TriedCandidate| match &tried.outcome {
            Outcome::Timed(timing) => Some(*timing),
            _ => None,
        };
        let winner = self.tried.iter().rev().find(|tried| {
            tried.candidate == self.best && timed(tried).is_some_and(|timing| timing.wins())
        });
        let left = if self.is_done() { "" } else { " so far" };
        let number = self.tried.iter().filter_map(timed).count();
        match winner.and_then(|tried| Some((tried, timed(tried)?))) {
            Some((tried, timing)) => format!(
                "the fastest of {}{left}: {:.2} ms, {:.2} of {}",
                number + 1,
                timing.ms,
                timing.ratio,
                tried.against
            ),
            None => format!("the safest; none of {number} others{left} is faster"),
        }
    }

    /// Whether every candidate was tried.
    pub fn is_done(&self) -> bool {
        self.pending.is_empty() && self.axes == Axis::ALL.len()
    }
}
