//! How far a picture is from the oracle's. In: two pictures. Out: PSNR, the largest error and the share of pixels that are right.
//!
//! Pictures are compared as a viewer sees them: over mid grey, so that wrong coverage counts even where the colour is black or white,
//! and within 0 to 1, as a display clips them.

use crate::frame::{ALPHA_MIN, Picture};
use serde::Serialize;

/// The background that pictures are compared over.
pub const BACKGROUND: f32 = 0.5;
/// A pixel is right when no channel is further off than this.
pub const TOLERANCE: f64 = 4.0 / 255.0;

/// A picture's error against the oracle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Error {
    /// Over the pixels that the avatar covers: those where the oracle's alpha is at least 1/255.
    pub covered: Region,
    /// Over the whole picture. Empty background flatters its PSNR.
    pub whole: Region,
}

/// The error over some pixels. Over none it reads as no error at all: `pixels` says so.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Region {
    /// How many pixels were compared.
    pub pixels: usize,
    /// −10 log₁₀ of the mean squared error over pixels and RGB, dB. Infinite when there is none, which JSON has as null.
    pub psnr_db: f64,
    /// The largest error of any channel, 0 to 1.
    pub max_error: f64,
    /// Share of pixels whose every channel is within [`TOLERANCE`], 0 to 1.
    pub within_tolerance: f64,
}

/// RGB of a pixel over the background, as a display shows it.
pub(crate) fn seen([r, g, b, a]: [f32; 4]) -> [f64; 3] {
    [r, g, b].map(|c| f64::from(c + (1.0 - a) * BACKGROUND).clamp(0.0, 1.0))
}

/// Compares a picture with the oracle's.
///
/// # Panics
/// When the sizes differ.
pub fn between(picture: &Picture, oracle: &Picture) -> Error {
    assert_eq!(picture.size, oracle.size, "pictures of different sizes can't be compared");
    let (mut covered, mut whole) = (Sum::default(), Sum::default());
    for (&got, &expected) in picture.pixels.iter().zip(&oracle.pixels) {
        let (got_seen, expected_seen) = (seen(got), seen(expected));
        let error = std::array::from_fn(|k| {
            let error = (got_seen[k] - expected_seen[k]).abs();
            // A NaN, from the colour or the alpha, is as wrong as a channel can be.
            if error.is_nan() { 1.0 } else { error }
        });
        whole.add(error);
        if f64::from(expected[3]) >= ALPHA_MIN {
            covered.add(error);
        }
    }
    Error { covered: covered.region(), whole: whole.region() }
}

/// What a [`Region`] is made from.
#[derive(Default)]
struct Sum {
    pixels: usize,
    squares: f64,
    max: f64,
    right: usize,
}

impl Sum {
    fn add(&mut self, error: [f64; 3]) {
        let max = error.into_iter().fold(0.0, f64::max);
        self.pixels += 1;
        self.squares += error.iter().map(|e| e * e).sum::<f64>();
        self.max = self.max.max(max);
        self.right += usize::from(max <= TOLERANCE);
    }

    fn region(&self) -> Region {
        let count = self.pixels.max(1) as f64;
        Region {
            pixels: self.pixels,
            psnr_db: -10.0 * (self.squares / (3.0 * count)).log10(),
            max_error: self.max,
            within_tolerance: if self.pixels == 0 { 1.0 } else { self.right as f64 / count },
        }
    }
}
