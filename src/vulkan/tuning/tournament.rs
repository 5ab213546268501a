//! The tournament: candidates go in one after the other, each against the best so far; the fastest
//! comes out.

use super::{
    candidate::{Axis, Candidate, Choices, Workload},
    outcome::{FramePair, Outcome, Timing, Tuning},
    record::Record,
};
use crate::vulkan::device::error::{Error, Result};
use effigy_core::scene::FrameImage;

/// Pairs of frames after which a candidate is decided.
const PAIRS: usize = 7;
/// Pairs after which one that is slower by this much in half of them is dropped.
const FEW_PAIRS: usize = 3;
const SLOWER: f64 = 1.1;
/// A candidate that takes this many times as long in its first pair is dropped at once.
const FAR_SLOWER: f64 = 3.0;
/// The least PSNR of a right image against the best's, dB over covered pixels. Ways to rasterize end
/// at saturated pixels, each by its own rule, and have what the default promises against nothing
/// skipped. All else must not lower what the default has.
const RIGHT_DB: f64 = 55.0;
const RIGHT_RASTER_DB: f64 = 50.0;
/// The most by which a channel of a right image may be off: two ways to rasterize differ by up to
/// 0.26 in single pixels, where Gaussians of nearly one depth change places, and a lost or garbled
/// block differs by more.
const RIGHT_MOST: f64 = 0.5;

/// A frame with its image.
pub struct TrialImage {
    /// The image.
    pub image: FrameImage,
    /// Time of the frame, ms.
    pub ms: f64,
}

/// Draws frames with candidates. Tests put drivers in its place that fail.
pub trait Trials {
    /// What draws with one candidate.
    type Renderer;

    /// Compiles all that a candidate needs.
    fn open(&mut self, candidate: &Candidate) -> Result<Self::Renderer>;

    /// Draws a frame that is the same for every candidate.
    fn image(&mut self, renderer: &mut Self::Renderer) -> Result<TrialImage>;

    /// Draws one frame with each, one after the other without a pause, so that clocks are the same.
    /// `number`: of the pair.
    fn pair(
        &mut self,
        best: &mut Self::Renderer,
        candidate: &mut Self::Renderer,
        number: usize,
    ) -> Result<FramePair>;

    /// Whether a frame that takes too long may be a busy machine's.
    fn is_cpu(&self) -> bool;
}

/// Called before a candidate is tried.
pub type Progress<'a> = &'a mut dyn FnMut(&Candidate);

/// What is measured, and for how long.
pub struct Tournament<'a> {
    /// What is drawn.
    pub workload: Workload,
    /// What to begin with.
    pub safest: Candidate,
    /// What there is to choose from.
    pub choices: Choices,
    /// Time of frames after which it ends, ms. At least one candidate's first frames are drawn.
    pub budget_ms: f64,
    /// Where results are kept.
    pub record: &'a Record,
}

/// What draws with a candidate, and its image.
struct Opened<R> {
    renderer: R,
    image: FrameImage,
}

/// How far a candidate's trial came.
enum Step<R> {
    /// It was timed.
    Timed(Outcome, Opened<R>),
    /// Its image is wrong.
    Wrong(String),
    /// The budget is spent.
    Spent,
}

impl Tournament<'_> {
    /// Goes on where an earlier start ended. Fails where a candidate brought the device down, which
    /// later starts do not try again, or the safest can't be drawn with.
    pub fn run<T: Trials>(&self, trials: &mut T, progress: Progress) -> Result<Tuning> {
        self.record.settle();
        let known = self.record.tuning(&self.workload);
        let mut tuning = match &known {
            // A driver may have lost an ability that its version does not tell.
            Some(tuning) if tuning.safest == self.safest => tuning.clone(),
            _ => Tuning::new(self.workload.clone(), self.safest),
        };
        let mut spent_ms = 0.0;
        let mut best: Option<Opened<T::Renderer>> = None;
        while let Some((axis, candidate)) = tuning.next(&self.choices) {
            if let Some(why) = self.record.refusal(axis, &candidate) {
                tuning.note(Outcome::Refused(why));
                continue;
            }
            if spent_ms >= self.budget_ms {
                break;
            }
            let Some(current) = &mut best else {
                // Where the best fails, another candidate is the next.
                best = Some(self.open_best(trials, &mut tuning, &mut spent_ms)?);
                continue;
            };
            progress(&candidate);
            // Before anything is compiled: a driver may end the program there.
            if !self.record.begin(axis, candidate) {
                break;
            }
            let step = self.try_candidate(
                trials,
                current,
                axis,
                &candidate,
                &mut tuning.pairs,
                &mut spent_ms,
            );
            let mut winner = None;
            let outcome = match step {
                Ok(Step::Timed(outcome, opened)) => {
                    winner = Some(opened);
                    outcome
                }
                Ok(Step::Wrong(why)) => Outcome::Refused(why),
                Ok(Step::Spent) => break,
                Err(error) => {
                    let outcome = self.failed(axis, candidate, &error, trials.is_cpu());
                    if !device_lives(&error) {
                        tuning.note(outcome);
                        self.record.write(&tuning);
                        return Err(error);
                    }
                    outcome
                }
            };
            tuning.note(outcome);
            self.record.write(&tuning);
            if tuning.best == candidate
                && let Some(winner) = winner
            {
                *current = winner;
            }
        }
        if known.as_ref() != Some(&tuning) {
            self.record.write(&tuning);
        }
        Ok(tuning)
    }

    /// Opens the best so far. One that fails gives way to the safest.
    fn open_best<T: Trials>(
        &self,
        trials: &mut T,
        tuning: &mut Tuning,
        spent_ms: &mut f64,
    ) -> Result<Opened<T::Renderer>> {
        let is_cpu = trials.is_cpu();
        let mut open = |candidate: &Candidate| {
            let mut renderer = trials.open(candidate)?;
            let TrialImage { image, ms } = trials.image(&mut renderer)?;
            *spent_ms += ms;
            Ok(Opened { renderer, image })
        };
        match open(&tuning.best) {
            Err(error) if tuning.best != self.safest && !may_pass(&error, is_cpu) => {
                self.record.strike_off(tuning, &error.to_string());
                if !device_lives(&error) {
                    return Err(error);
                }
                *tuning = Tuning::new(self.workload.clone(), self.safest);
                open(&self.safest)
            }
            opened => opened,
        }
    }

    fn try_candidate<T: Trials>(
        &self,
        trials: &mut T,
        best: &mut Opened<T::Renderer>,
        axis: Axis,
        candidate: &Candidate,
        pairs: &mut Vec<FramePair>,
        spent_ms: &mut f64,
    ) -> Result<Step<T::Renderer>> {
        let mut renderer = trials.open(candidate)?;
        let TrialImage { image, ms } = trials.image(&mut renderer)?;
        *spent_ms += ms;
        if let Some(fault) = difference(&best.image, &image, axis) {
            return Ok(Step::Wrong(fault));
        }
        loop {
            let pair = trials.pair(&mut best.renderer, &mut renderer, pairs.len())?;
            *spent_ms += pair.best + pair.candidate;
            pairs.push(pair);
            if let Some(outcome) = decided(pairs) {
                return Ok(Step::Timed(outcome, Opened { renderer, image }));
            }
            if *spent_ms >= self.budget_ms {
                return Ok(Step::Spent);
            }
        }
    }

    /// What an error makes of the candidate that was tried.
    fn failed(&self, axis: Axis, candidate: Candidate, error: &Error, is_cpu: bool) -> Outcome {
        let why = error.to_string();
        if may_pass(error, is_cpu) {
            return Outcome::Untried(why);
        }
        self.record.refuse(axis, candidate, &why);
        Outcome::Refused(why)
    }
}

/// The outcome of a candidate with these pairs of frames. None while more are needed.
fn decided(pairs: &[FramePair]) -> Option<Outcome> {
    let timing = Timing::new(pairs);
    let is_slower = timing.is_some_and(|timing| {
        let bound = if pairs.len() < FEW_PAIRS {
            FAR_SLOWER
        } else {
            SLOWER
        };
        timing.ratio > bound
    });
    if pairs.len() < PAIRS && !is_slower {
        return None;
    }
    Some(match timing {
        Some(timing) => Outcome::Timed(timing),
        None => Outcome::Untried("its frames took no time that the device could tell".into()),
    })
}

/// What is wrong with an image, if anything: it must show what the best's shows.
fn difference(best: &FrameImage, image: &FrameImage, axis: Axis) -> Option<String> {
    if best.size != image.size {
        return Some("its image has another size".into());
    }
    let mut squares = 0.0;
    let mut most = 0.0_f64;
    let mut covered = 0_usize;
    for (a, b) in best.pixels.iter().zip(&image.pixels) {
        // Colours without coverage show, since images are premultiplied; NaN is not 0 either.
        if a.iter().chain(b).any(|&channel| channel != 0.0) {
            covered += 1;
            for k in 0..4 {
                let off = f64::from(a[k] - b[k]).abs();
                squares += off * off;
                most = if off <= most { most } else { off };
            }
        }
    }
    let mean = squares / (4 * covered.max(1)) as f64;
    let db = -10.0 * mean.log10();
    let least = if axis == Axis::Raster {
        RIGHT_RASTER_DB
    } else {
        RIGHT_DB
    };
    // Written so that NaN is wrong.
    let is_right = db >= least && most <= RIGHT_MOST;
    (!is_right).then(|| {
        format!(
            "its image is wrong: {db:.1} dB and {most:.2} at most, \
             where {least} and {RIGHT_MOST} are right"
        )
    })
}

/// Whether an error says nothing of a candidate: it may not happen next time or with another
/// avatar, the options or the avatar are at fault, or a CPU was busy.
pub(crate) fn may_pass(error: &Error, is_cpu: bool) -> bool {
    match error {
        Error::OutOfMemory { .. }
        | Error::Allocation { .. }
        | Error::TooLarge { .. }
        | Error::ImageSize { .. }
        | Error::Unusable(_)
        | Error::Avatar(_) => true,
        Error::Timeout { .. } => is_cpu,
        _ => false,
    }
}

/// Whether the device can be drawn with after an error.
pub(crate) fn device_lives(error: &Error) -> bool {
    !matches!(error, Error::DeviceLost(_) | Error::Timeout { .. })
}
