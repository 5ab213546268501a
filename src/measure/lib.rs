//! Effigy in numbers.
//!
//! - [`mod@bench`] measures time, error, memory and bytes, case by case, and compares reports.
//! - [`soak`] draws for minutes at a promised rate and records every second.
//! - [`mod@rates`] measures what a device manages in a second, whatever is drawn.
//! - [`survey`] measures a device in three minutes by these; [`steps`] is what became of each part of
//!   a run.
//! - [`packing`] measures what each step of packing an avatar saves and costs.
//! - [`bytes`] computes the bytes and operations of each stage, and their minimum.
//! - [`error`] is the error of an image: PSNR and largest error.
//! - [`flip`] is how visible that error is.
//! - [`flicker`] is what changes from frame to frame that should not.
//! - [`coverage`] is whether an avatar is closed.
//! - [`similarity`] is how similar an image is to a photo's: L1, PSNR and SSIM.
//! - [`viewpoint`] is where avatars are seen from.
//! - [`setting`] is how an avatar is drawn to be measured.
//! - [`report`] holds the parts that all reports share, [`table`] their rows as a CSV and two
//!   against each other.
//! - [`chart`] draws the charts of all of them, and of trainings.

pub mod bench;
pub mod bytes;
#[cfg(feature = "charts")]
pub mod chart;
pub mod coverage;
pub mod error;
pub mod flicker;
pub mod flip;
pub mod packing;
pub mod rates;
pub mod report;
pub mod setting;
pub mod similarity;
pub mod soak;
pub mod steps;
pub mod survey;
pub mod table;
pub mod viewpoint;

use glam::{DAffine3, DVec3};
use std::{sync::OnceLock, time::Duration};

/// For how long work runs at least before some of it is timed: a GPU that had nothing to do, while
/// results were compared say, takes so long to raise its clocks. They were a fifth of what they are
/// under load on an H200.
pub const WARM_UP: Duration = Duration::from_millis(500);

static COMMIT: OnceLock<&'static str> = OnceLock::new();

/// Sets the commit that the program was built from. A program calls this once, before it measures:
/// a library that knew the commit itself would be compiled again with every commit.
pub fn set_commit(commit: &'static str) {
    // Only the first call counts.
    let _ = COMMIT.set(commit);
}

/// The commit that reports name, if the program has set it.
pub fn commit() -> Option<&'static str> {
    COMMIT.get().copied()
}

/// Most avatars of a row.
const ROW: usize = 16;
/// Between rows, and between the avatars of one of several rows, metres.
const SPACING: f64 = 1.5;

/// The place of avatar `index` of `count` that stand around the origin: up to 16 in a row along x, a
/// metre apart; more in rows of about four times as many as there are rows.
pub fn in_rows(index: usize, count: usize) -> DAffine3 {
    let middle = |places: usize| 0.5 * places.saturating_sub(1) as f64;
    let place = if count <= ROW {
        DVec3::X * (index as f64 - middle(count))
    } else {
        let columns = (2.0 * (count as f64).sqrt()).ceil() as usize;
        let x = (index % columns) as f64 - middle(columns);
        let z = (index / columns) as f64 - middle(count.div_ceil(columns));
        SPACING * DVec3::new(x, 0.0, z)
    };
    DAffine3::from_translation(place)
}
