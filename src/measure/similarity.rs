//! How alike two pictures are inside the mask's box, as papers on avatars measure it. In: a picture and the truth. Out: L1, PSNR, SSIM.

use super::error::seen;
use crate::frame::{ALPHA_MIN, Picture};
use serde::Serialize;
use std::ops::Range;

/// The usual window of SSIM: 11 pixels across, deviation 1.5.
const WINDOW: usize = 11;
const DEVIATION: f64 = 1.5;
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// Over the smallest box around the truth's covered pixels, RGB over mid grey.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Similarity {
    /// Mean absolute difference, 0 to 1.
    pub l1: f64,
    /// dB; infinite where nothing differs.
    pub psnr_db: f64,
    /// Mean structural similarity (Wang 2004) of the channels, at most 1.
    pub ssim: f64,
}

/// Columns and rows of the smallest box around what a picture covers; None where that is nothing.
pub fn mask_box(picture: &Picture) -> Option<[Range<usize>; 2]> {
    let width = picture.size[0] as usize;
    let covered = picture.pixels.iter().enumerate().filter(|(_, p)| f64::from(p[3]) >= ALPHA_MIN).map(|(i, _)| [i % width, i / width]);
    let [min, max] = covered.fold([[usize::MAX; 2], [0; 2]], |[min, max], at| {
        [std::array::from_fn(|k| min[k].min(at[k])), std::array::from_fn(|k| max[k].max(at[k] + 1))]
    });
    (min[0] < max[0]).then(|| [min[0]..max[0], min[1]..max[1]])
}

/// None where the truth covers nothing.
///
/// # Panics
/// When the sizes differ.
pub fn similarity(picture: &Picture, truth: &Picture) -> Option<Similarity> {
    assert_eq!(picture.size, truth.size, "pictures of different sizes can't be compared");
    let [columns, rows] = mask_box(truth)?;
    let width = truth.size[0] as usize;
    let (mut sum, mut squares, mut ssim) = (0.0, 0.0, 0.0);
    for channel in 0..3 {
        let plane = |picture: &Picture| -> Vec<f64> {
            let row = |y: usize| columns.clone().map(move |x| seen(picture.pixels[y * width + x])[channel]);
            rows.clone().flat_map(row).collect()
        };
        let (a, b) = (plane(picture), plane(truth));
        for (a, b) in a.iter().zip(&b) {
            // A NaN is as wrong as a channel can be.
            let error = if a.is_nan() { 1.0 } else { a - b };
            sum += error.abs();
            squares += error * error;
        }
        ssim += structure(&a, &b, [columns.len(), rows.len()]);
    }
    let count = (3 * columns.len() * rows.len()) as f64;
    Some(Similarity { l1: sum / count, psnr_db: -10.0 * (squares / count).log10(), ssim: ssim / 3.0 })
}

/// Mean SSIM of two planes; at the edges the window is cut and weighs what is left.
fn structure(a: &[f64], b: &[f64], size: [usize; 2]) -> f64 {
    let product = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).collect::<Vec<_>>();
    let [ma, mb, aa, bb, ab] =
        [blur(a, size), blur(b, size), blur(&product(a, a), size), blur(&product(b, b), size), blur(&product(a, b), size)];
    let at = |i: usize| {
        let (va, vb, cov) = (aa[i] - ma[i] * ma[i], bb[i] - mb[i] * mb[i], ab[i] - ma[i] * mb[i]);
        (2.0 * ma[i] * mb[i] + C1) * (2.0 * cov + C2) / ((ma[i] * ma[i] + mb[i] * mb[i] + C1) * (va + vb + C2))
    };
    (0..a.len()).map(at).sum::<f64>() / a.len().max(1) as f64
}

fn blur(plane: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let reach = WINDOW / 2;
    let weight: Vec<f64> = (0..WINDOW).map(|k| (-0.5 * ((k as f64 - reach as f64) / DEVIATION).powi(2)).exp()).collect();
    let line = |length: usize, at: usize, get: &dyn Fn(usize) -> f64| {
        let range = at.saturating_sub(reach)..(at + reach + 1).min(length);
        let (sum, whole) =
            range.fold((0.0, 0.0), |(sum, whole), i| (sum + get(i) * weight[i + reach - at], whole + weight[i + reach - at]));
        sum / whole
    };
    let across: Vec<f64> = (0..plane.len()).map(|i| line(width, i % width, &|x| plane[i / width * width + x])).collect();
    (0..plane.len()).map(|i| line(height, i / width, &|y| across[y * width + i % width])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(of: impl Fn(usize, usize) -> f32) -> Picture {
        let mut picture = Picture::empty([40, 30]);
        for (y, x) in (5..25).flat_map(|y| (10..35).map(move |x| (y, x))) {
            let v = of(x, y);
            picture.pixels[y * 40 + x] = [v, v, v, 1.0];
        }
        picture
    }

    #[test]
    fn the_box_is_the_masks_and_equal_pictures_are_alike() {
        let truth = picture(|x, y| ((x * 7 + y * 3) % 11) as f32 / 11.0);
        assert_eq!(mask_box(&truth), Some([10..35, 5..25]));
        let same = similarity(&truth, &truth).expect("something is covered");
        assert!(same.l1 == 0.0 && same.psnr_db == f64::INFINITY && (same.ssim - 1.0).abs() < 1e-12, "{same:?}");
        assert_eq!(similarity(&truth, &Picture::empty([40, 30])), None);
    }

    #[test]
    fn a_shift_of_a_tenth_is_20_db_and_hardly_a_change_of_structure_while_noise_is() {
        let texture = |x: usize, y: usize| 0.2 + 0.5 * ((x * 7 + y * 3) % 11) as f32 / 11.0;
        let truth = picture(texture);
        let shifted = similarity(&picture(|x, y| texture(x, y) + 0.1), &truth).expect("something is covered");
        assert!((shifted.l1 - 0.1).abs() < 1e-6 && (shifted.psnr_db - 20.0).abs() < 1e-4 && shifted.ssim > 0.9, "{shifted:?}");
        let noise =
            similarity(&picture(|x, y| texture(x, y) + if (x + y) % 2 == 0 { 0.1 } else { -0.1 }), &truth).expect("something is covered");
        assert!((noise.psnr_db - 20.0).abs() < 1e-4 && noise.ssim < shifted.ssim - 0.05, "{noise:?}, {shifted:?}");
    }

    #[test]
    fn flat_planes_have_the_formulas_value() {
        let (a, b) = (0.4, 0.6f64);
        let got = similarity(&picture(|_, _| a as f32), &picture(|_, _| b as f32)).expect("something is covered").ssim;
        let expected = (2.0 * a * b + C1) / (a * a + b * b + C1);
        assert!((got - expected).abs() < 1e-6, "{got}, expected {expected}");
    }
}
