//! How similar two images are inside the mask's box, as papers on avatars measure it. In: an image
//! and the ground truth. Out: L1, PSNR, SSIM.

use crate::error::displayed;
use effigy_core::{constants::ALPHA_MIN, scene::FrameImage};
use serde::Serialize;
use std::ops::Range;

/// The usual window of SSIM: 11 pixels across, deviation 1.5.
const WINDOW: usize = 11;
const DEVIATION: f64 = 1.5;
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// Similarity over the smallest box around the ground truth's covered pixels, RGB over mid grey.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Similarity {
    /// Mean absolute difference, 0 to 1.
    pub l1: f64,
    /// dB; infinite if nothing differs.
    pub psnr_db: f64,
    /// Mean structural similarity (Wang 2004) of the channels, at most 1.
    pub ssim: f64,
}

/// Columns and rows of the smallest box around an image's covered pixels. None without any.
pub fn mask_box(image: &FrameImage) -> Option<[Range<usize>; 2]> {
    let width = image.size[0] as usize;
    let covered = image
        .pixels
        .iter()
        .enumerate()
        .filter(|(_, p)| f64::from(p[3]) >= ALPHA_MIN)
        .map(|(i, _)| [i % width, i / width]);
    let [min, max] = covered.fold([[usize::MAX; 2], [0; 2]], |[min, max], at| {
        [
            std::array::from_fn(|k| min[k].min(at[k])),
            std::array::from_fn(|k| max[k].max(at[k] + 1)),
        ]
    });
    (min[0] < max[0]).then(|| [min[0]..max[0], min[1]..max[1]])
}

/// Compares an image with the ground truth. None if that covers nothing.
///
/// # Panics
/// If the sizes differ.
pub fn similarity(image: &FrameImage, ground_truth: &FrameImage) -> Option<Similarity> {
    assert_eq!(
        image.size, ground_truth.size,
        "images of different sizes can't be compared"
    );
    let [columns, rows] = mask_box(ground_truth)?;
    let width = ground_truth.size[0] as usize;
    let mut sum = 0.0;
    let mut squares = 0.0;
    let mut ssim = 0.0;
    for channel in 0..3 {
        let plane = |image: &FrameImage| -> Vec<f64> {
            let row = |y: usize| {
                columns
                    .clone()
                    .map(move |x| displayed(image.pixels[y * width + x])[channel])
            };
            rows.clone().flat_map(row).collect()
        };
        let a = plane(image);
        let b = plane(ground_truth);
        for (a, b) in a.iter().zip(&b) {
            // A NaN is as wrong as a channel can be.
            let error = if a.is_nan() { 1.0 } else { a - b };
            sum += error.abs();
            squares += error * error;
        }
        let map = ssim_map(&a, &b, columns.len());
        ssim += map.iter().sum::<f64>() / map.len().max(1) as f64;
    }
    let count = (3 * columns.len() * rows.len()) as f64;
    Some(Similarity {
        l1: sum / count,
        psnr_db: -10.0 * (squares / count).log10(),
        ssim: ssim / 3.0,
    })
}

/// SSIM around each pixel of two planes of a width. At the edges the window is cut, and the weights
/// inside count.
pub fn ssim_map(a: &[f64], b: &[f64], width: usize) -> Vec<f64> {
    let product = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).collect::<Vec<_>>();
    let mean_a = blur(a, width);
    let mean_b = blur(b, width);
    let mean_aa = blur(&product(a, a), width);
    let mean_bb = blur(&product(b, b), width);
    let mean_ab = blur(&product(a, b), width);
    let ssim = |i: usize| {
        let variance_a = mean_aa[i] - mean_a[i] * mean_a[i];
        let variance_b = mean_bb[i] - mean_b[i] * mean_b[i];
        let covariance = mean_ab[i] - mean_a[i] * mean_b[i];
        (2.0 * mean_a[i] * mean_b[i] + C1) * (2.0 * covariance + C2)
            / ((mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i] + C1)
                * (variance_a + variance_b + C2))
    };
    (0..a.len()).map(ssim).collect()
}

/// A plane of a width under the window of SSIM, first across, then down.
fn blur(plane: &[f64], width: usize) -> Vec<f64> {
    let radius = WINDOW / 2;
    let weight: Vec<f64> = (0..WINDOW)
        .map(|k| (-0.5 * ((k as f64 - radius as f64) / DEVIATION).powi(2)).exp())
        .collect();
    // The weighted mean around `center` of a line of `length` values.
    let weighted_mean = |length: usize, center: usize, value: &dyn Fn(usize) -> f64| {
        let mut sum = 0.0;
        let mut total_weight = 0.0;
        for i in center.saturating_sub(radius)..(center + radius + 1).min(length) {
            let weight = weight[i + radius - center];
            sum += value(i) * weight;
            total_weight += weight;
        }
        sum / total_weight
    };
    let height = plane.len() / width;
    let across: Vec<f64> = (0..plane.len())
        .map(|i| weighted_mean(width, i % width, &|x| plane[i / width * width + x]))
        .collect();
    (0..plane.len())
        .map(|i| weighted_mean(height, i / width, &|y| across[y * width + i % width]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(value: impl Fn(usize, usize) -> f32) -> FrameImage {
        let mut image = FrameImage::empty([40, 30]);
        for (y, x) in (5..25).flat_map(|y| (10..35).map(move |x| (y, x))) {
            let v = value(x, y);
            image.pixels[y * 40 + x] = [v, v, v, 1.0];
        }
        image
    }

    #[test]
    fn the_box_is_the_masks_and_equal_images_are_alike() {
        let ground_truth = image(|x, y| ((x * 7 + y * 3) % 11) as f32 / 11.0);
        assert_eq!(mask_box(&ground_truth), Some([10..35, 5..25]));
        let same = similarity(&ground_truth, &ground_truth).expect("something is covered");
        assert!(
            same.l1 == 0.0 && same.psnr_db == f64::INFINITY && (same.ssim - 1.0).abs() < 1e-12,
            "{same:?}"
        );
        assert_eq!(
            similarity(&ground_truth, &FrameImage::empty([40, 30])),
            None
        );
    }

    #[test]
    fn noise_lowers_ssim_more_than_a_shift_of_brightness() {
        let texture = |x: usize, y: usize| 0.2 + 0.5 * ((x * 7 + y * 3) % 11) as f32 / 11.0;
        let ground_truth = image(texture);
        let shifted = similarity(&image(|x, y| texture(x, y) + 0.1), &ground_truth)
            .expect("something is covered");
        assert!(
            (shifted.l1 - 0.1).abs() < 1e-6
                && (shifted.psnr_db - 20.0).abs() < 1e-4
                && shifted.ssim > 0.9,
            "{shifted:?}"
        );
        let noise = similarity(
            &image(|x, y| texture(x, y) + if (x + y) % 2 == 0 { 0.1 } else { -0.1 }),
            &ground_truth,
        )
        .expect("something is covered");
        assert!(
            (noise.psnr_db - 20.0).abs() < 1e-4 && noise.ssim < shifted.ssim - 0.05,
            "{noise:?}, {shifted:?}"
        );
    }

    #[test]
    fn flat_planes_have_the_formulas_value() {
        let a: f64 = 0.4;
        let b: f64 = 0.6;
        let got = similarity(&image(|_, _| a as f32), &image(|_, _| b as f32))
            .expect("something is covered")
            .ssim;
        let expected = (2.0 * a * b + C1) / (a * a + b * b + C1);
        assert!((got - expected).abs() < 1e-6, "{got}, expected {expected}");
    }
}
