//! The log of a training: a line for every so many steps.

use crate::gpu::StepLosses;
use effigy_core::io::file::{FileError, replace};
use std::fs;
use std::io;
use std::path::Path;

/// Steps' losses.
pub const LOG: &str = "log.csv";

/// The progress of a training.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrainingProgress {
    /// Steps so far.
    pub steps: u64,
    /// How much of the training is over, 0 to 1.
    pub share: f64,
    /// Seconds that it has taken, those before an interruption included.
    pub seconds: f64,
    /// Whether rows were pruned.
    pub pruned: bool,
    /// Mean of |image − picture| of the steps since the last of these.
    pub l1: f64,
    /// PSNR of views against pictures of these steps, dB: of training views, while they learn.
    pub psnr_db: f64,
    /// The perceptual loss of the last step that had it.
    pub perceptual: Option<f64>,
    /// Most pairs of splats and tiles of a view.
    pub pairs: u32,
}

/// Sums over the steps since the last report.
#[derive(Default)]
pub struct ProgressSums {
    steps: u64,
    l1: f64,
    squared: f64,
    pairs: u32,
    /// The perceptual loss of the last step that had it.
    pub perceptual: Option<f64>,
}

impl ProgressSums {
    /// Adds a step.
    pub fn add(&mut self, found: &StepLosses) {
        self.steps += 1;
        self.l1 += found.l1;
        self.squared += found.squared;
        self.pairs = self.pairs.max(found.pairs);
    }

    /// The progress over the steps so far; resets the sums.
    pub fn take(&mut self, now: TrainingTime) -> TrainingProgress {
        let own = std::mem::take(self);
        let count = own.steps.max(1) as f64;
        TrainingProgress {
            steps: now.steps,
            share: now.share,
            seconds: now.seconds,
            pruned: now.pruned,
            l1: own.l1 / count,
            psnr_db: -10.0 * (own.squared / count).max(1e-12).log10(),
            perceptual: own.perceptual,
            pairs: own.pairs,
        }
    }
}

/// How far a training is.
#[derive(Clone, Copy, Debug)]
pub struct TrainingTime {
    /// Steps so far.
    pub steps: u64,
    /// How much of it is over, 0 to 1.
    pub share: f64,
    /// Seconds that it has taken.
    pub seconds: f64,
    /// Whether rows were pruned.
    pub pruned: bool,
}

/// Adds a line to a folder's log, under a header where it is new.
///
/// # Errors
/// When it can't be written.
pub fn add(folder: &Path, progress: &TrainingProgress) -> Result<(), FileError> {
    let file = folder.join(LOG);
    append(&file, progress).map_err(|cause| FileError::Write { file, cause })
}

fn append(file: &Path, progress: &TrainingProgress) -> io::Result<()> {
    let mut text = String::new();
    if !file.exists() {
        text += "step,seconds,share,pruned,l1,psnr_db,perceptual,pairs\n";
    }
    let perceptual = progress
        .perceptual
        .map_or(String::new(), |v| format!("{v:.6}"));
    text += &format!(
        "{},{:.2},{:.6},{},{:.7},{:.3},{perceptual},{}\n",
        progress.steps,
        progress.seconds,
        progress.share,
        u8::from(progress.pruned),
        progress.l1,
        progress.psnr_db,
        progress.pairs,
    );
    let mut open = fs::OpenOptions::new();
    let mut log = open.create(true).append(true).open(file)?;
    let length = log.metadata()?.len();
    let written = io::Write::write_all(&mut log, text.as_bytes());
    if written.is_err() {
        // Half a line would spoil the next. The user must see the first failure.
        log.set_len(length).ok();
    }
    written
}

/// Cuts a log to the first so many steps: what came after the checkpoint comes again.
///
/// # Errors
/// When it can't be written.
pub fn cut(folder: &Path, name: &str, steps: u64) -> Result<(), FileError> {
    let file = folder.join(name);
    let Ok(text) = fs::read_to_string(&file) else {
        return Ok(());
    };
    let stays = |line: &&str| {
        let step = line
            .split(',')
            .next()
            .and_then(|step| step.parse::<u64>().ok());
        step.is_none_or(|step| step <= steps)
    };
    let kept: String = text
        .lines()
        .filter(stays)
        .map(|line| format!("{line}\n"))
        .collect();
    replace(&file, kept.as_bytes())
}
