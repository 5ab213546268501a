//! FLIP: how visible the difference between two images is to someone who flips between them. In:
//! two images. Out: 0 (not visible) to 1.
//!
//! LDR-FLIP of Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020,
//! whose sections and constants the comments name: colours, filtered as the eye resolves them, are
//! compared in an opponent space; edges and points are compared separately. Viewed from 0.7 m on a
//! monitor 0.7 m and 3840 pixels wide, over the background of [`crate::error`].

use crate::error;
use effigy_core::{constants::ALPHA_MIN, scene::FrameImage};
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use serde::Serialize;
use std::f64::consts::PI;

/// Pixels a degree of the field of view.
const PIXELS_PER_DEGREE: f64 = 3840.0 * PI / 180.0;
/// A Gaussian of a channel's contrast sensitivity: a and b of table 1.
#[derive(Clone, Copy)]
struct SensitivityTerm {
    a: f64,
    b: f64,
}
/// Contrast sensitivity of the channels Y, Cx and Cz.
const SENSITIVITY: [&[SensitivityTerm]; 3] = [
    &[SensitivityTerm { a: 1.0, b: 0.0047 }],
    &[SensitivityTerm { a: 1.0, b: 0.0053 }],
    &[
        SensitivityTerm { a: 34.1, b: 0.04 },
        SensitivityTerm { a: 13.5, b: 0.025 },
    ],
];
/// q_c, p_c and p_t of section 4.1.3.
const COLOR_EXPONENT: f64 = 0.7;
const KNEE_IN: f64 = 0.4;
const KNEE_OUT: f64 = 0.95;
/// Width of the feature detectors, degrees, and q_f: section 4.2.
const FEATURE_WIDTH: f64 = 0.082;
const FEATURE_EXPONENT: f64 = 0.5;
/// Linear sRGB to XYZ.
const TO_XYZ: DMat3 = DMat3::from_cols_array_2d(&[
    [
        10_135_552.0 / 24_577_794.0,
        2_613_072.0 / 12_288_897.0,
        1_425_312.0 / 73_733_382.0,
    ],
    [
        8_788_810.0 / 24_577_794.0,
        8_788_810.0 / 12_288_897.0,
        8_788_810.0 / 73_733_382.0,
    ],
    [
        4_435_075.0 / 24_577_794.0,
        887_015.0 / 12_288_897.0,
        70_074_185.0 / 73_733_382.0,
    ],
]);

/// Mean FLIP, 0 to 1. A pixel that depends on a NaN counts as 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Flip {
    /// Over the pixels where the reference's alpha is at least 1/255; 0 without any.
    pub covered: f64,
    /// Over the whole image.
    pub whole: f64,
}

/// Compares an image with a reference.
///
/// # Panics
/// If the sizes differ.
pub fn between(image: &FrameImage, reference: &FrameImage) -> Flip {
    let map = map(image, reference);
    let mut covered = 0.0;
    let mut pixels = 0usize;
    for (flip, pixel) in map.iter().zip(&reference.pixels) {
        if f64::from(pixel[3]) >= ALPHA_MIN {
            covered += flip;
            pixels += 1;
        }
    }
    Flip {
        covered: covered / pixels.max(1) as f64,
        whole: map.iter().sum::<f64>() / map.len().max(1) as f64,
    }
}

/// FLIP of every pixel of an image against a reference's, 0 to 1; row by row from the top left.
///
/// # Panics
/// If the sizes differ.
pub fn map(image: &FrameImage, reference: &FrameImage) -> Vec<f64> {
    assert_eq!(
        image.size, reference.size,
        "images of different sizes can't be compared"
    );
    let a = PerceivedImage::new(image);
    let b = PerceivedImage::new(reference);
    let green = lab(DVec3::Y);
    let blue = lab(DVec3::Z);
    let largest = distance(green, blue).powf(COLOR_EXPONENT);
    let pixel = |k: usize| {
        let color = compress(
            distance(a.color[k], b.color[k]).powf(COLOR_EXPONENT),
            largest,
        );
        let feature = (0..2)
            .map(|f| (a.feature[f][k] - b.feature[f][k]).abs())
            .fold(0.0, f64::max);
        let flip = color.powf(1.0 - (feature / 2f64.sqrt()).powf(FEATURE_EXPONENT));
        if flip.is_nan() { 1.0 } else { flip }
    };
    (0..reference.pixels.len())
        .into_par_iter()
        .map(pixel)
        .collect()
}

/// HyAB distance of two colours in CIELAB (section 4.1.2).
fn distance(a: DVec3, b: DVec3) -> f64 {
    let d = a - b;
    d.x.abs() + d.y.hypot(d.z)
}

/// Colour error mapped to 0 to 1: the lower p_c of its range takes the lower p_t of the result
/// (section 4.1.3).
fn compress(error: f64, largest: f64) -> f64 {
    let knee = KNEE_IN * largest;
    if error < knee {
        KNEE_OUT / knee * error
    } else {
        KNEE_OUT + (error - knee) / (largest - knee) * (1.0 - KNEE_OUT)
    }
}

/// XYZ of linear RGB, relative to white.
fn relative_xyz(linear: DVec3) -> DVec3 {
    TO_XYZ * linear / (TO_XYZ * DVec3::ONE)
}

/// YCxCz of linear RGB: opponent channels that are linear in light.
fn opponent(linear: DVec3) -> DVec3 {
    let xyz = relative_xyz(linear);
    DVec3::new(
        116.0 * xyz.y - 16.0,
        500.0 * (xyz.x - xyz.y),
        200.0 * (xyz.y - xyz.z),
    )
}

/// Linear RGB of YCxCz, clamped to 0 to 1.
fn from_opponent(c: DVec3) -> DVec3 {
    let y = (c.x + 16.0) / 116.0;
    let xyz = DVec3::new(y + c.y / 500.0, y, y - c.z / 200.0) * (TO_XYZ * DVec3::ONE);
    (TO_XYZ.inverse() * xyz).map(|c| c.clamp(0.0, 1.0))
}

/// CIELAB of linear RGB, with chroma scaled by lightness (Hunt effect).
fn lab(linear: DVec3) -> DVec3 {
    let delta: f64 = 6.0 / 29.0;
    let f = relative_xyz(linear).map(|t| {
        if t > delta.powi(3) {
            t.cbrt()
        } else {
            t / (3.0 * delta * delta) + 4.0 / 29.0
        }
    });
    let lightness = 116.0 * f.y - 16.0;
    DVec3::new(
        lightness,
        0.01 * lightness * 500.0 * (f.x - f.y),
        0.01 * lightness * 200.0 * (f.y - f.z),
    )
}

fn from_srgb(v: f64) -> f64 {
    if v <= 0.04045 {
        v / 12.92
    } else {
        ((v + 0.055) / 1.055).powf(2.4)
    }
}

/// An image as the eye perceives it, pixel by pixel.
struct PerceivedImage {
    /// CIELAB after the contrast sensitivity filter.
    color: Vec<DVec3>,
    /// Strength of edges and of points.
    feature: [Vec<f64>; 2],
}

impl PerceivedImage {
    fn new(image: &FrameImage) -> Self {
        let width = image.size[0] as usize;
        let linear =
            |&pixel: &[f32; 4]| opponent(DVec3::from(error::displayed(pixel).map(from_srgb)));
        let opponent: Vec<DVec3> = image.pixels.par_iter().map(linear).collect();
        let plane = |c: usize| opponent.iter().map(|p| p[c]).collect::<Vec<f64>>();
        let [y, cx, cz] = std::array::from_fn(|c| blur(&plane(c), width, SENSITIVITY[c]));
        let color = (0..y.len())
            .into_par_iter()
            .map(|k| lab(from_opponent(DVec3::new(y[k], cx[k], cz[k]))))
            .collect();
        let luminance: Vec<f64> = opponent.iter().map(|p| (p.x + 16.0) / 116.0).collect();
        let [gauss, edge, point] = detectors();
        let feature = [edge, point].map(|detector| {
            let across = filter(&luminance, width, &detector, &gauss);
            let down = filter(&luminance, width, &gauss, &detector);
            across.iter().zip(&down).map(|(a, b)| a.hypot(*b)).collect()
        });
        Self { color, feature }
    }
}

/// One channel filtered by the eye's contrast sensitivity, each Gaussian of which is separable
/// (section 4.1.1).
fn blur(plane: &[f64], width: usize, sensitivity: &[SensitivityTerm]) -> Vec<f64> {
    // The kernels of all channels have the radius of the widest one: three deviations.
    let radius = (3.0 * (0.04 / (2.0 * PI * PI)).sqrt() * PIXELS_PER_DEGREE).ceil() as i32;
    let kernel = |b: f64| -> Vec<f64> {
        (-radius..=radius)
            .map(|x| (-(PI * f64::from(x) / PIXELS_PER_DEGREE).powi(2) / b).exp())
            .collect()
    };
    let weight = |term: &SensitivityTerm| term.a * (PI / term.b).sqrt();
    let volume = |term: &SensitivityTerm| weight(term) * kernel(term.b).iter().sum::<f64>().powi(2);
    let total: f64 = sensitivity.iter().map(volume).sum();
    let mut sum = vec![0.0; plane.len()];
    for term in sensitivity {
        let across = kernel(term.b);
        let down: Vec<f64> = across.iter().map(|k| k * weight(term) / total).collect();
        for (sum, value) in sum.iter_mut().zip(filter(plane, width, &across, &down)) {
            *sum += value;
        }
    }
    sum
}

/// A Gaussian and its first and second derivative. The positive weights of each sum to 1, the
/// negative ones to −1 (section 4.2).
fn detectors() -> [Vec<f64>; 3] {
    let deviation = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
    let radius = (3.0 * deviation).ceil() as i32;
    let kernel = |shape: fn(f64) -> f64| -> Vec<f64> {
        let weights: Vec<f64> = (-radius..=radius)
            .map(|x| f64::from(x) / deviation)
            .map(|x| shape(x) * (-0.5 * x * x).exp())
            .collect();
        let sum = |sign: f64| weights.iter().map(|w| (sign * w).max(0.0)).sum::<f64>();
        let positive = sum(1.0);
        let negative = sum(-1.0);
        weights
            .iter()
            .map(|w| {
                if *w > 0.0 {
                    w / positive
                } else {
                    w / negative.max(f64::MIN_POSITIVE)
                }
            })
            .collect()
    };
    [kernel(|_| 1.0), kernel(|x| -x), kernel(|x| x * x - 1.0)]
}

/// A separable filter with one kernel across and one down. Beyond the border the last pixel is
/// repeated.
fn filter(plane: &[f64], width: usize, across: &[f64], down: &[f64]) -> Vec<f64> {
    let last = width - 1;
    let height = plane.len() / width;
    let mut rows = vec![0.0; plane.len()];
    rows.par_chunks_mut(width)
        .zip(plane.par_chunks(width))
        .for_each(|(out, row)| {
            let padded: Vec<f64> = (0..width + across.len() - 1)
                .map(|x| row[x.saturating_sub(across.len() / 2).min(last)])
                .collect();
            for (out, window) in out.iter_mut().zip(padded.windows(across.len())) {
                *out = window.iter().zip(across).map(|(v, w)| v * w).sum();
            }
        });
    let mut result = vec![0.0; plane.len()];
    result
        .par_chunks_mut(width)
        .enumerate()
        .for_each(|(y, out)| {
            for (k, weight) in down.iter().enumerate() {
                let row = (y + k).saturating_sub(down.len() / 2).min(height - 1);
                for (out, value) in out.iter_mut().zip(&rows[row * width..]) {
                    *out += weight * value;
                }
            }
        });
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(color: impl Fn(usize, usize) -> [f64; 3]) -> FrameImage {
        let pixel = |k: usize| {
            let [r, g, b] = color(k % 96, k / 96).map(|c| c as f32);
            [r, g, b, 1.0]
        };
        FrameImage {
            size: [96, 64],
            pixels: (0..96 * 64).map(pixel).collect(),
        }
    }

    /// Stripes, a slow wave and a chequerboard.
    fn pattern(x: usize, y: usize) -> [f64; 3] {
        let at = |v: usize| v as f64;
        [
            0.5 + 0.5 * (0.3 * at(x)).sin(),
            0.5 + 0.5 * (0.2 * at(y) + 0.05 * at(x)).cos(),
            0.8 * at((x / 8 + y / 8) % 2),
        ]
    }

    fn flat(color: [f64; 3]) -> FrameImage {
        image(|_, _| color)
    }

    #[track_caller]
    fn near(got: f64, expected: f64, tolerance: f64) {
        assert!(
            (got - expected).abs() <= tolerance,
            "got {got}, expected {expected}, tolerance {tolerance:e}"
        );
    }

    #[test]
    fn it_agrees_with_the_authors_program() {
        // Means of flip-evaluator 1.7 for these images.
        let reference = image(pattern);
        let shifted = image(|x, y| pattern(x + 1, y));
        let dimmed = image(|x, y| pattern(x, y).map(|c| 0.9 * c));
        let dotted = image(|x, y| {
            if x % 16 == 5 && y % 16 == 9 {
                [1.0; 3]
            } else {
                pattern(x, y)
            }
        });
        for (image, expected) in [
            (shifted, 0.291_481),
            (dimmed, 0.386_984),
            (dotted, 0.024_699),
        ] {
            near(between(&image, &reference).whole, expected, 2e-6);
        }
    }

    #[test]
    fn equal_images_have_0_and_black_for_white_nearly_1() {
        assert_eq!(
            between(&image(pattern), &image(pattern)),
            Flip {
                covered: 0.0,
                whole: 0.0
            }
        );
        // Also by flip-evaluator; in f32 a flat image has some edges.
        near(
            between(&flat([0.0; 3]), &flat([1.0; 3])).whole,
            0.967_388,
            1e-5,
        );
        near(
            between(&flat([0.0, 1.0, 0.0]), &flat([0.0, 0.0, 1.0])).whole,
            1.0,
            1e-9,
        );
    }

    #[test]
    fn a_growing_difference_is_more_visible() {
        let at = |grey: f64| between(&flat([grey; 3]), &flat([0.5; 3])).whole;
        let steps = [0.5, 0.504, 0.52, 0.6, 0.8, 1.0].map(at);
        assert!(steps.is_sorted_by(|a, b| a < b), "{steps:?}");
    }

    #[test]
    fn covered_pixels_are_the_references_and_nan_is_1() {
        let mut reference = flat([0.5; 3]);
        reference.pixels[..96 * 32].fill([0.0; 4]);
        let mut image = reference.clone();
        image.pixels[96 * 60..].fill([1.0; 4]);
        let Flip { covered, whole } = between(&image, &reference);
        assert!(whole > 0.0);
        near(covered, 2.0 * whole, 1e-12);
        assert_eq!(
            between(&flat([f64::NAN; 3]), &reference),
            Flip {
                covered: 1.0,
                whole: 1.0
            }
        );
    }
}
