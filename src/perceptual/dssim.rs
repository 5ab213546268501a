//! D-SSIM: 1 less the mean structural similarity (Wang 2004) of two pictures, with its gradient.
//! What a trainer takes where there are no weights of a network.

use crate::planes::{Graded, Planes};
use rayon::prelude::*;

/// The usual window of SSIM: 11 pixels across, deviation 1.5. At edges it is cut, and the weights
/// inside count.
const WINDOW: usize = 11;
const RADIUS: usize = WINDOW / 2;
const DEVIATION: f64 = 1.5;
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// 1 less the mean SSIM of the channels: 0 for equal pictures, at most 2.
///
/// # Panics
/// When the sizes differ, or numbers are missing.
pub fn dssim(image: &Planes, target: &Planes) -> f64 {
    of_channels(image, target, false).value
}

/// [`dssim`] and its gradient with respect to the first picture.
///
/// # Panics
/// As [`dssim`].
pub fn dssim_and_gradient(image: &Planes, target: &Planes) -> Graded {
    of_channels(image, target, true)
}

fn of_channels(image: &Planes, target: &Planes, with_gradient: bool) -> Graded {
    assert_eq!(
        image.size, target.size,
        "pictures of different sizes can't be compared"
    );
    assert!(
        image.is_whole() && target.is_whole(),
        "a picture lacks numbers"
    );
    let window = GaussianWindow::new(image.size);
    let plane = image.size[0] * image.size[1];
    let channels: Vec<ChannelSsim> = image
        .data
        .par_chunks_exact(plane.max(1))
        .zip(target.data.par_chunks_exact(plane.max(1)))
        .map(|(a, b)| window.compare(a, b, with_gradient))
        .collect();
    let similarity: f64 = channels.iter().map(|channel| channel.similarity).sum();
    let data = channels.iter().flat_map(|channel| &channel.gradient);
    Graded {
        value: 1.0 - similarity / 3.0,
        gradient: Planes {
            size: image.size,
            data: data.map(|&slope| (-slope / 3.0) as f32).collect(),
        },
    }
}

/// The mean SSIM of a channel.
struct ChannelSsim {
    similarity: f64,
    /// Its derivative with respect to each pixel; empty where it was not requested.
    gradient: Vec<f64>,
}

/// Means under the window, for planes of a size.
struct GaussianWindow {
    size: [usize; 2],
    weights: [f64; WINDOW],
    /// One over the sum of the weights inside, for each column and each row.
    over_columns: Vec<f64>,
    over_rows: Vec<f64>,
}

impl GaussianWindow {
    fn new(size: [usize; 2]) -> Self {
        let weights: [f64; WINDOW] = std::array::from_fn(|k| {
            (-0.5 * ((k as f64 - RADIUS as f64) / DEVIATION).powi(2)).exp()
        });
        let over = |length: usize| -> Vec<f64> {
            let inside =
                |at: usize| (0..WINDOW).filter(move |k| (at + k).wrapping_sub(RADIUS) < length);
            let sum = |at: usize| inside(at).map(|k| weights[k]).sum::<f64>();
            (0..length).map(|at| 1.0 / sum(at)).collect()
        };
        Self {
            size,
            weights,
            over_columns: over(size[0]),
            over_rows: over(size[1]),
        }
    }

    /// The mean SSIM of two planes, and its derivative with respect to the first.
    fn compare(&self, a: &[f32], b: &[f32], with_gradient: bool) -> ChannelSsim {
        let a: Vec<f64> = a.iter().map(|&n| f64::from(n)).collect();
        let b: Vec<f64> = b.iter().map(|&n| f64::from(n)).collect();
        let product = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).collect();
        let mean_a = self.means(a.clone());
        let mean_b = self.means(b.clone());
        let mean_aa = self.means(product(&a, &a));
        let mean_bb = self.means(product(&b, &b));
        let mean_ab = self.means(product(&a, &b));
        let count = a.len().max(1) as f64;
        let mut similarity = 0.0;
        // The derivatives with respect to the means of a, a² and ab.
        let mut by_a = vec![0.0; a.len()];
        let mut by_aa = vec![0.0; a.len()];
        let mut by_ab = vec![0.0; a.len()];
        for i in 0..a.len() {
            let (of_a, of_b) = (mean_a[i], mean_b[i]);
            let means = 2.0 * of_a * of_b + C1;
            let covariance = 2.0 * (mean_ab[i] - of_a * of_b) + C2;
            let squares = of_a * of_a + of_b * of_b + C1;
            let variances = mean_aa[i] - of_a * of_a + mean_bb[i] - of_b * of_b + C2;
            let over = 1.0 / (squares * variances);
            let ssim = means * covariance * over;
            similarity += ssim / count;
            by_a[i] = 2.0
                * (of_b * (covariance - means) * over
                    + ssim * of_a * (1.0 / variances - 1.0 / squares))
                / count;
            by_aa[i] = -ssim / variances / count;
            by_ab[i] = 2.0 * means * over / count;
        }
        let mut gradient = Vec::new();
        if with_gradient {
            gradient = self.spread(by_a);
            let by_aa = self.spread(by_aa);
            let by_ab = self.spread(by_ab);
            for i in 0..gradient.len() {
                gradient[i] += 2.0 * a[i] * by_aa[i] + b[i] * by_ab[i];
            }
        }
        ChannelSsim {
            similarity,
            gradient,
        }
    }

    /// The weighted mean around each pixel.
    fn means(&self, plane: Vec<f64>) -> Vec<f64> {
        let mut sums = self.sums(&plane);
        self.divide(&mut sums);
        sums
    }

    /// The transpose of [`Self::means`].
    fn spread(&self, mut plane: Vec<f64>) -> Vec<f64> {
        self.divide(&mut plane);
        self.sums(&plane)
    }

    fn divide(&self, plane: &mut [f64]) {
        let rows = plane.chunks_exact_mut(self.size[0]).zip(&self.over_rows);
        for (row, over_row) in rows {
            for (number, over_column) in row.iter_mut().zip(&self.over_columns) {
                *number *= over_row * over_column;
            }
        }
    }

    /// The weighted sum around each pixel, first across, then down.
    fn sums(&self, plane: &[f64]) -> Vec<f64> {
        let [width, height] = self.size;
        let mut across = vec![0.0; plane.len()];
        let mut padded = vec![0.0; width + 2 * RADIUS];
        let rows = plane
            .chunks_exact(width)
            .zip(across.chunks_exact_mut(width));
        for (row, sums) in rows {
            padded[RADIUS..RADIUS + width].copy_from_slice(row);
            for (k, weight) in self.weights.iter().enumerate() {
                for (sum, number) in sums.iter_mut().zip(&padded[k..]) {
                    *sum += weight * number;
                }
            }
        }
        let mut down = vec![0.0; plane.len()];
        for (y, sums) in down.chunks_exact_mut(width).enumerate() {
            for (k, weight) in self.weights.iter().enumerate() {
                let row = (y + k).wrapping_sub(RADIUS);
                if row < height {
                    for (sum, number) in sums.iter_mut().zip(&across[row * width..][..width]) {
                        *sum += weight * number;
                    }
                }
            }
        }
        down
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthetic::{direction, picture};

    #[test]
    fn equal_pictures_are_at_no_distance() {
        let image = picture(0, [30, 17]);
        let graded = dssim_and_gradient(&image, &image);
        assert!(graded.value.abs() < 1e-12);
        assert!(graded.gradient.data.iter().all(|n| n.abs() < 1e-9));
    }

    #[test]
    fn the_gradient_is_what_central_differences_find() {
        for size in [[31, 24], [7, 9]] {
            let (image, target) = (picture(0, size), picture(1, size));
            let graded = dssim_and_gradient(&image, &target);
            assert_eq!(graded.value, dssim(&image, &target));
            for at in 0..3 {
                let mut along = direction(size);
                along.data.rotate_left(at);
                let step = 1.0 / 4096.0;
                let moved = |sign: f32| {
                    let pairs = image.data.iter().zip(&along.data);
                    let data = pairs.map(|(n, d)| n + sign * step * d).collect();
                    Planes { size, data }
                };
                let (ahead, behind) = (moved(1.0), moved(-1.0));
                let found = dssim(&ahead, &target) - dssim(&behind, &target);
                let steps = ahead.data.iter().zip(&behind.data);
                let expected: f64 = steps
                    .zip(&graded.gradient.data)
                    .map(|((a, b), g)| f64::from(a - b) * f64::from(*g))
                    .sum();
                assert!(
                    (found - expected).abs() < 1e-4 * expected.abs().max(1e-6),
                    "{found}, expected {expected}"
                );
            }
        }
    }
}
