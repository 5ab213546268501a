//! FLIP: how visible the difference between two pictures is to someone who flips between them. In: two pictures. Out: 0 (none) to 1.
//!
//! LDR-FLIP as in Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020, whose sections and constants the
//! comments name: colours as far as the eye resolves them, compared in an opponent space, and edges and points compared apart. Seen
//! from 0.7 m on a monitor 0.7 m and 3840 pixels wide, over the same background as [`super::error`].

use super::error;
use crate::frame::{ALPHA_MIN, Picture};
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use serde::Serialize;
use std::f64::consts::PI;

/// Pixels a degree of the field of view.
const PIXELS_PER_DEGREE: f64 = 3840.0 * PI / 180.0;
/// Contrast sensitivity of the channels Y, Cx and Cz: two Gaussians each, (a, b) of table 1.
const SENSITIVITY: [[(f64, f64); 2]; 3] = [[(1.0, 0.0047), (0.0, 1e-5)], [(1.0, 0.0053), (0.0, 1e-5)], [(34.1, 0.04), (13.5, 0.025)]];
/// q_c, p_c and p_t of section 4.1.3.
const COLOR_EXPONENT: f64 = 0.7;
const KNEE_IN: f64 = 0.4;
const KNEE_OUT: f64 = 0.95;
/// Width of the feature detectors, degrees, and q_f: section 4.2.
const FEATURE_WIDTH: f64 = 0.082;
const FEATURE_EXPONENT: f64 = 0.5;
/// Linear sRGB to XYZ.
const TO_XYZ: DMat3 = DMat3::from_cols_array_2d(&[
    [10_135_552.0 / 24_577_794.0, 2_613_072.0 / 12_288_897.0, 1_425_312.0 / 73_733_382.0],
    [8_788_810.0 / 24_577_794.0, 8_788_810.0 / 12_288_897.0, 8_788_810.0 / 73_733_382.0],
    [4_435_075.0 / 24_577_794.0, 887_015.0 / 12_288_897.0, 70_074_185.0 / 73_733_382.0],
]);

/// Mean FLIP, 0 to 1; a pixel that a NaN reaches counts as 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Flip {
    /// Over the pixels where the oracle's alpha is at least 1/255; 0 where there are none.
    pub covered: f64,
    /// Over the whole picture.
    pub whole: f64,
}

/// Compares a picture with the oracle's.
///
/// # Panics
/// When the sizes differ.
pub fn between(picture: &Picture, oracle: &Picture) -> Flip {
    assert_eq!(picture.size, oracle.size, "pictures of different sizes can't be compared");
    let (a, b) = (Look::new(picture), Look::new(oracle));
    let [green, blue] = [DVec3::Y, DVec3::Z].map(lab);
    let largest = distance(green, blue).powf(COLOR_EXPONENT);
    let (mut covered, mut pixels, mut whole) = (0.0, 0usize, 0.0);
    for k in 0..oracle.pixels.len() {
        let color = spread(distance(a.color[k], b.color[k]).powf(COLOR_EXPONENT), largest);
        let feature = (0..2).map(|f| (a.feature[f][k] - b.feature[f][k]).abs()).fold(0.0, f64::max);
        let flip = color.powf(1.0 - (feature / 2f64.sqrt()).powf(FEATURE_EXPONENT));
        let flip = if flip.is_nan() { 1.0 } else { flip };
        whole += flip;
        if f64::from(oracle.pixels[k][3]) >= ALPHA_MIN {
            covered += flip;
            pixels += 1;
        }
    }
    Flip { covered: covered / pixels.max(1) as f64, whole: whole / oracle.pixels.len().max(1) as f64 }
}

/// HyAB distance of two colours in CIELAB (section 4.1.2).
fn distance(a: DVec3, b: DVec3) -> f64 {
    let d = a - b;
    d.x.abs() + d.y.hypot(d.z)
}

/// Colour error as 0 to 1: the lower p_c of its range gets the lower p_t of the result (section 4.1.3).
fn spread(error: f64, largest: f64) -> f64 {
    let knee = KNEE_IN * largest;
    if error < knee { KNEE_OUT / knee * error } else { KNEE_OUT + (error - knee) / (largest - knee) * (1.0 - KNEE_OUT) }
}

/// XYZ as shares of the white's.
fn to_white(linear: DVec3) -> DVec3 {
    TO_XYZ * linear / (TO_XYZ * DVec3::ONE)
}

/// YCxCz: opponent channels that are linear in light.
fn opponent(linear: DVec3) -> DVec3 {
    let xyz = to_white(linear);
    DVec3::new(116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z))
}

/// Linear RGB of YCxCz, within 0 to 1.
fn from_opponent(c: DVec3) -> DVec3 {
    let y = (c.x + 16.0) / 116.0;
    let xyz = DVec3::new(y + c.y / 500.0, y, y - c.z / 200.0) * (TO_XYZ * DVec3::ONE);
    (TO_XYZ.inverse() * xyz).map(|c| c.clamp(0.0, 1.0))
}

/// CIELAB, with colourfulness growing with lightness (Hunt effect).
fn lab(linear: DVec3) -> DVec3 {
    let delta: f64 = 6.0 / 29.0;
    let f = to_white(linear).map(|t| if t > delta.powi(3) { t.cbrt() } else { t / (3.0 * delta * delta) + 4.0 / 29.0 });
    let lightness = 116.0 * f.y - 16.0;
    DVec3::new(lightness, 0.01 * lightness * 500.0 * (f.x - f.y), 0.01 * lightness * 200.0 * (f.y - f.z))
}

fn from_srgb(v: f64) -> f64 {
    if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

/// What of a picture the eye compares, pixel by pixel.
struct Look {
    /// CIELAB after the contrast sensitivity filter.
    color: Vec<DVec3>,
    /// Strength of edges and of points.
    feature: [Vec<f64>; 2],
}

impl Look {
    fn new(picture: &Picture) -> Self {
        let width = picture.size[0] as usize;
        let linear = |&pixel: &[f32; 4]| opponent(DVec3::from(error::seen(pixel).map(from_srgb)));
        let opponent: Vec<DVec3> = picture.pixels.par_iter().map(linear).collect();
        let plane = |c: usize| opponent.iter().map(|p| p[c]).collect::<Vec<f64>>();
        let [y, cx, cz] = std::array::from_fn(|c| blur(&plane(c), width, SENSITIVITY[c]));
        let color = (0..y.len()).into_par_iter().map(|k| lab(from_opponent(DVec3::new(y[k], cx[k], cz[k])))).collect();
        let luminance: Vec<f64> = opponent.iter().map(|p| (p.x + 16.0) / 116.0).collect();
        let [gauss, edge, point] = detectors();
        let feature = [edge, point].map(|detector| {
            let (across, down) = (filter(&luminance, width, &detector, &gauss), filter(&luminance, width, &gauss, &detector));
            across.iter().zip(&down).map(|(a, b)| a.hypot(*b)).collect()
        });
        Self { color, feature }
    }
}

/// One channel as far as the eye resolves it: each Gaussian of its sensitivity is separable (section 4.1.1).
fn blur(plane: &[f64], width: usize, sensitivity: [(f64, f64); 2]) -> Vec<f64> {
    // All channels' kernels reach as far as the widest one's, three deviations.
    let radius = (3.0 * (0.04 / (2.0 * PI * PI)).sqrt() * PIXELS_PER_DEGREE).ceil() as i32;
    let kernel =
        |b: f64| -> Vec<f64> { (-radius..=radius).map(|x| (-(PI * f64::from(x) / PIXELS_PER_DEGREE).powi(2) / b).exp()).collect() };
    let terms = sensitivity.map(|(a, b)| (a * (PI / b).sqrt(), kernel(b)));
    let total: f64 = terms.iter().map(|(weight, kernel)| weight * kernel.iter().sum::<f64>().powi(2)).sum();
    let mut sum = vec![0.0; plane.len()];
    for (weight, kernel) in terms.iter().filter(|(weight, _)| *weight > 0.0) {
        let down: Vec<f64> = kernel.iter().map(|k| k * weight / total).collect();
        sum.iter_mut().zip(filter(plane, width, kernel, &down)).for_each(|(sum, v)| *sum += v);
    }
    sum
}

/// A Gaussian and its first and second derivative; the positive and the negative weights of each sum to 1 and −1 (section 4.2).
fn detectors() -> [Vec<f64>; 3] {
    let deviation = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
    let radius = (3.0 * deviation).ceil() as i32;
    let kernel = |shape: fn(f64) -> f64| -> Vec<f64> {
        let weights: Vec<f64> = (-radius..=radius).map(|x| f64::from(x) / deviation).map(|x| shape(x) * (-0.5 * x * x).exp()).collect();
        let sum = |sign: f64| weights.iter().map(|w| (sign * w).max(0.0)).sum::<f64>();
        let (positive, negative) = (sum(1.0), sum(-1.0));
        weights.iter().map(|w| if *w > 0.0 { w / positive } else { w / negative.max(f64::MIN_POSITIVE) }).collect()
    };
    [kernel(|_| 1.0), kernel(|x| -x), kernel(|x| x * x - 1.0)]
}

/// A separable filter, one kernel across and one down; beyond its border the picture repeats its last pixel.
fn filter(plane: &[f64], width: usize, across: &[f64], down: &[f64]) -> Vec<f64> {
    let (last, height) = (width - 1, plane.len() / width);
    let mut rows = vec![0.0; plane.len()];
    rows.par_chunks_mut(width).zip(plane.par_chunks(width)).for_each(|(out, row)| {
        let padded: Vec<f64> = (0..width + across.len() - 1).map(|x| row[x.saturating_sub(across.len() / 2).min(last)]).collect();
        for (out, window) in out.iter_mut().zip(padded.windows(across.len())) {
            *out = window.iter().zip(across).map(|(v, w)| v * w).sum();
        }
    });
    let mut result = vec![0.0; plane.len()];
    result.par_chunks_mut(width).enumerate().for_each(|(y, out)| {
        for (k, weight) in down.iter().enumerate() {
            let row = (y + k).saturating_sub(down.len() / 2).min(height - 1);
            out.iter_mut().zip(&rows[row * width..]).for_each(|(out, v)| *out += weight * v);
        }
    });
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(color: impl Fn(usize, usize) -> [f64; 3]) -> Picture {
        let pixel = |k: usize| {
            let [r, g, b] = color(k % 96, k / 96).map(|c| c as f32);
            [r, g, b, 1.0]
        };
        Picture { size: [96, 64], pixels: (0..96 * 64).map(pixel).collect() }
    }

    /// Stripes, a slow wave and a chequerboard.
    fn pattern(x: usize, y: usize) -> [f64; 3] {
        let at = |v: usize| v as f64;
        [0.5 + 0.5 * (0.3 * at(x)).sin(), 0.5 + 0.5 * (0.2 * at(y) + 0.05 * at(x)).cos(), 0.8 * at((x / 8 + y / 8) % 2)]
    }

    fn flat(color: [f64; 3]) -> Picture {
        picture(|_, _| color)
    }

    #[track_caller]
    fn near(got: f64, expected: f64, tolerance: f64) {
        assert!((got - expected).abs() <= tolerance, "got {got}, expected {expected}, tolerance {tolerance:e}");
    }

    #[test]
    fn it_agrees_with_its_authors_program() {
        // Means that flip-evaluator 1.7 gives for the same pictures.
        let oracle = picture(pattern);
        let shifted = picture(|x, y| pattern(x + 1, y));
        let dimmed = picture(|x, y| pattern(x, y).map(|c| 0.9 * c));
        let dotted = picture(|x, y| if x % 16 == 5 && y % 16 == 9 { [1.0; 3] } else { pattern(x, y) });
        for (picture, expected) in [(shifted, 0.291_481), (dimmed, 0.386_984), (dotted, 0.024_699)] {
            near(between(&picture, &oracle).whole, expected, 2e-6);
        }
    }

    #[test]
    fn equal_pictures_have_none_and_black_for_white_has_nearly_all() {
        assert_eq!(between(&picture(pattern), &picture(pattern)), Flip { covered: 0.0, whole: 0.0 });
        // Also theirs; in f32 a flat picture has some edges.
        near(between(&flat([0.0; 3]), &flat([1.0; 3])).whole, 0.967_388, 1e-5);
        near(between(&flat([0.0, 1.0, 0.0]), &flat([0.0, 0.0, 1.0])).whole, 1.0, 1e-9);
    }

    #[test]
    fn a_growing_difference_is_more_visible() {
        let at = |grey: f64| between(&flat([grey; 3]), &flat([0.5; 3])).whole;
        let steps = [0.5, 0.504, 0.52, 0.6, 0.8, 1.0].map(at);
        assert!(steps.is_sorted_by(|a, b| a < b), "{steps:?}");
    }

    #[test]
    fn covered_pixels_are_the_oracles_and_a_nan_counts_as_one() {
        let mut oracle = flat([0.5; 3]);
        oracle.pixels[..96 * 32].fill([0.0; 4]);
        let mut picture = oracle.clone();
        picture.pixels[96 * 60..].fill([1.0; 4]);
        let Flip { covered, whole } = between(&picture, &oracle);
        assert!(whole > 0.0);
        near(covered, 2.0 * whole, 1e-12);
        assert_eq!(between(&flat([f64::NAN; 3]), &oracle), Flip { covered: 1.0, whole: 1.0 });
    }
}
