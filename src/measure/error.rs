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

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 by 10, the upper half covered with a grey.
    fn half_covered() -> Picture {
        let mut picture = Picture::empty([10, 10]);
        picture.pixels[..50].fill([0.25, 0.25, 0.25, 1.0]);
        picture
    }

    fn near(got: f64, expected: f64) {
        assert!((got - expected).abs() < 1e-5, "got {got}, expected {expected}, tolerance 1e-5");
    }

    #[test]
    fn equal_pictures_have_no_error_and_json_says_null() {
        let error = between(&half_covered(), &half_covered());
        let none = Region { pixels: 50, psnr_db: f64::INFINITY, max_error: 0.0, within_tolerance: 1.0 };
        assert_eq!(error, Error { covered: none, whole: Region { pixels: 100, ..none } });
        assert!(serde_json::to_string(&error).expect("plain numbers").contains(r#""psnr_db":null"#));
    }

    #[test]
    fn an_error_of_a_tenth_in_every_covered_pixel_is_20_db_there_and_23_over_the_whole_picture() {
        let mut picture = half_covered();
        picture.pixels[..50].fill([0.35, 0.15, 0.35, 1.0]);
        let Error { covered, whole } = between(&picture, &half_covered());
        near(covered.psnr_db, 20.0);
        near(whole.psnr_db, 20.0 + 10.0 * 2f64.log10());
        near(covered.max_error, 0.1);
        assert_eq!([covered.within_tolerance, whole.within_tolerance], [0.0, 0.5]);
    }

    #[test]
    fn one_channel_out_of_three_counts_a_third_and_spoils_its_pixel() {
        let mut picture = half_covered();
        picture.pixels[7] = [0.25 + 5.0 / 255.0, 0.25, 0.25, 1.0];
        picture.pixels[8] = [0.25 + 3.0 / 255.0, 0.25, 0.25, 1.0];
        let covered = between(&picture, &half_covered()).covered;
        near(covered.psnr_db, -10.0 * ((25.0 + 9.0) / 255f64.powi(2) / 150.0).log10());
        near(covered.within_tolerance, 0.98);
    }

    #[test]
    fn coverage_without_colour_is_an_error() {
        let mut picture = half_covered();
        picture.pixels[99] = [0.0, 0.0, 0.0, 1.0];
        let Error { covered, whole } = between(&picture, &half_covered());
        assert_eq!(covered.max_error, 0.0);
        near(whole.max_error, 0.5);
    }

    #[test]
    fn nan_and_infinity_are_as_wrong_as_can_be_and_what_a_display_clips_is_not_wrong() {
        let mut white = half_covered();
        white.pixels.fill([1.0; 4]);
        let first = |pixel| {
            let mut picture = white.clone();
            picture.pixels[0] = pixel;
            between(&picture, &white).whole.max_error
        };
        assert_eq!([first([f32::NAN, 1.0, 1.0, 1.0]), first([1.0, 1.0, 1.0, f32::NAN]), first([f32::NEG_INFINITY; 4])], [1.0; 3]);
        assert_eq!(first([1.5, 1.0, 1.0, 1.0]), 0.0);
    }
}
