//! How far an image is from the reference's. In: two images. Out: PSNR, the largest error and the
//! share of pixels that are right.
//!
//! Images are compared as a display shows them: over mid grey, so that wrong coverage counts even
//! where the colour is black or white, and clamped to 0 to 1.

use effigy_core::{constants::ALPHA_MIN, scene::FrameImage};
use serde::Serialize;

/// The grey that images are compared over.
pub const BACKGROUND: f32 = 0.5;
/// Largest error of a channel in a pixel that counts as right.
pub const TOLERANCE: f64 = 4.0 / 255.0;

/// Error of a channel from which on a pixel counts as visibly wrong, 0 to 1.
pub const VISIBLE: f64 = 0.05;

/// An image's error against a reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ErrorMetrics {
    /// Over the pixels that the avatar covers: those where the reference's alpha is at least 1/255.
    pub covered: RegionError,
    /// Over the whole image. Empty background makes its PSNR look better.
    pub whole: RegionError,
}

/// The error over some pixels. Over no pixels it is 0: check `pixels`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RegionError {
    /// Number of pixels compared.
    pub pixels: usize,
    /// −10 log₁₀ of the mean squared error over pixels and RGB, dB. Infinite, and null in JSON, if
    /// there is no error.
    pub psnr_db: f64,
    /// Largest error of any channel, 0 to 1.
    pub max_error: f64,
    /// Share of pixels whose every channel is within [`TOLERANCE`], 0 to 1.
    pub within_tolerance: f64,
    /// Pixels with a channel off by more than [`VISIBLE`].
    pub visible: usize,
}

/// RGB of a premultiplied pixel over [`BACKGROUND`], as a display shows it.
pub fn displayed(pixel: [f32; 4]) -> [f64; 3] {
    let [r, g, b, alpha] = pixel;
    [r, g, b].map(|c| f64::from(c + (1.0 - alpha) * BACKGROUND).clamp(0.0, 1.0))
}

/// Compares an image with a reference.
///
/// # Panics
/// If the sizes differ.
pub fn between(image: &FrameImage, reference: &FrameImage) -> ErrorMetrics {
    assert_eq!(
        image.size, reference.size,
        "images of different sizes can't be compared"
    );
    let mut covered = ErrorSum::default();
    let mut whole = ErrorSum::default();
    for (&got, &expected) in image.pixels.iter().zip(&reference.pixels) {
        let got_rgb = displayed(got);
        let expected_rgb = displayed(expected);
        let error = std::array::from_fn(|k| {
            let error = (got_rgb[k] - expected_rgb[k]).abs();
            // A NaN, from the colour or the alpha, is as wrong as a channel can be.
            if error.is_nan() { 1.0 } else { error }
        });
        whole.add(error);
        if f64::from(expected[3]) >= ALPHA_MIN {
            covered.add(error);
        }
    }
    ErrorMetrics {
        covered: covered.region(),
        whole: whole.region(),
    }
}

/// The sums that a [`RegionError`] is computed from.
#[derive(Default)]
struct ErrorSum {
    pixels: usize,
    squares: f64,
    max: f64,
    right: usize,
    visible: usize,
}

impl ErrorSum {
    fn add(&mut self, error: [f64; 3]) {
        let max = error.into_iter().fold(0.0, f64::max);
        self.pixels += 1;
        self.squares += error.iter().map(|e| e * e).sum::<f64>();
        self.max = self.max.max(max);
        self.right += usize::from(max <= TOLERANCE);
        self.visible += usize::from(max > VISIBLE);
    }

    fn region(&self) -> RegionError {
        let count = self.pixels.max(1) as f64;
        RegionError {
            pixels: self.pixels,
            psnr_db: -10.0 * (self.squares / (3.0 * count)).log10(),
            max_error: self.max,
            within_tolerance: if self.pixels == 0 {
                1.0
            } else {
                self.right as f64 / count
            },
            visible: self.visible,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 by 10, the upper half covered with a grey.
    fn half_covered() -> FrameImage {
        let mut image = FrameImage::empty([10, 10]);
        image.pixels[..50].fill([0.25, 0.25, 0.25, 1.0]);
        image
    }

    fn near(got: f64, expected: f64) {
        assert!(
            (got - expected).abs() < 1e-5,
            "got {got}, expected {expected}, tolerance 1e-5"
        );
    }

    #[test]
    fn equal_images_have_no_error_and_json_says_null() {
        let error = between(&half_covered(), &half_covered());
        let none = RegionError {
            pixels: 50,
            psnr_db: f64::INFINITY,
            max_error: 0.0,
            within_tolerance: 1.0,
            visible: 0,
        };
        assert_eq!(
            error,
            ErrorMetrics {
                covered: none,
                whole: RegionError {
                    pixels: 100,
                    ..none
                }
            }
        );
        assert!(
            serde_json::to_string(&error)
                .expect("plain numbers")
                .contains(r#""psnr_db":null"#)
        );
    }

    #[test]
    fn a_tenth_in_every_covered_pixel_is_20_db() {
        let mut image = half_covered();
        image.pixels[..50].fill([0.35, 0.15, 0.35, 1.0]);
        let ErrorMetrics { covered, whole } = between(&image, &half_covered());
        near(covered.psnr_db, 20.0);
        near(whole.psnr_db, 20.0 + 10.0 * 2f64.log10());
        near(covered.max_error, 0.1);
        assert_eq!(
            [covered.within_tolerance, whole.within_tolerance],
            [0.0, 0.5]
        );
        assert_eq!([covered.visible, whole.visible], [50, 50]);
    }

    #[test]
    fn one_wrong_channel_counts_a_third() {
        let mut image = half_covered();
        image.pixels[7] = [0.25 + 5.0 / 255.0, 0.25, 0.25, 1.0];
        image.pixels[8] = [0.25 + 3.0 / 255.0, 0.25, 0.25, 1.0];
        let covered = between(&image, &half_covered()).covered;
        near(
            covered.psnr_db,
            -10.0 * ((25.0 + 9.0) / 255f64.powi(2) / 150.0).log10(),
        );
        near(covered.within_tolerance, 0.98);
        assert_eq!(covered.visible, 0, "5/255 is less than VISIBLE");
    }

    #[test]
    fn wrong_coverage_is_an_error_even_in_black() {
        let mut image = half_covered();
        image.pixels[99] = [0.0, 0.0, 0.0, 1.0];
        let ErrorMetrics { covered, whole } = between(&image, &half_covered());
        assert_eq!(covered.max_error, 0.0);
        near(whole.max_error, 0.5);
    }

    #[test]
    fn nan_and_infinity_are_the_largest_error() {
        let mut white = half_covered();
        white.pixels.fill([1.0; 4]);
        let first = |pixel| {
            let mut image = white.clone();
            image.pixels[0] = pixel;
            between(&image, &white).whole.max_error
        };
        assert_eq!(
            [
                first([f32::NAN, 1.0, 1.0, 1.0]),
                first([1.0, 1.0, 1.0, f32::NAN]),
                first([f32::NEG_INFINITY; 4])
            ],
            [1.0; 3]
        );
        assert_eq!(first([1.5, 1.0, 1.0, 1.0]), 0.0);
    }
}
