//! Numbers of how near two pictures are: over a box, or over some of its pixels.

use effigy_measure::similarity::ssim_map;
use effigy_perceptual::{Perceptual, Planes};
use serde::Serialize;

/// Identical pictures count as this in means, dB.
const MAX_PSNR: f64 = 100.0;
/// Fewer pixels of a region say nothing.
pub const FEWEST_PIXELS: usize = 64;

/// How near a picture is to the truth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Metrics {
    /// dB, at most 100.
    pub psnr_db: f64,
    /// Mean structural similarity (Wang 2004) of the channels, at most 1.
    pub ssim: f64,
    /// Mean absolute difference, 0 to 1.
    pub l1: f64,
    /// ST-LPIPS; None where it was not asked for, or the box is too small for it.
    pub st_lpips: Option<f64>,
    /// LPIPS; None as for ST-LPIPS.
    pub lpips: Option<f64>,
}

/// The mean of some pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Means {
    /// How many.
    pub pictures: usize,
    /// Mean of the pictures' PSNR, dB.
    pub psnr_db: f64,
    /// Mean SSIM.
    pub ssim: f64,
    /// Mean absolute difference.
    pub l1: f64,
    /// Mean ST-LPIPS of the pictures that have one.
    pub st_lpips: Option<f64>,
    /// Mean LPIPS of the pictures that have one.
    pub lpips: Option<f64>,
}

impl Means {
    /// The mean of some pictures; None without any.
    pub fn of<'a>(all: impl Iterator<Item = &'a Metrics>) -> Option<Self> {
        let mut sum = Self::default();
        let (mut st_lpips, mut lpips) = (Vec::new(), Vec::new());
        for metrics in all {
            sum.pictures += 1;
            sum.psnr_db += metrics.psnr_db;
            sum.ssim += metrics.ssim;
            sum.l1 += metrics.l1;
            st_lpips.extend(metrics.st_lpips);
            lpips.extend(metrics.lpips);
        }
        let count = sum.pictures as f64;
        let mean = |distances: &[f64]| {
            let count = distances.len() as f64;
            (count > 0.0).then(|| distances.iter().sum::<f64>() / count)
        };
        (sum.pictures > 0).then(|| Self {
            pictures: sum.pictures,
            psnr_db: sum.psnr_db / count,
            ssim: sum.ssim / count,
            l1: sum.l1 / count,
            st_lpips: mean(&st_lpips),
            lpips: mean(&lpips),
        })
    }
}

/// Two pictures of one size, and SSIM around each pixel.
pub struct PicturePair<'a> {
    image: &'a Planes,
    truth: &'a Planes,
    /// Mean of the channels.
    ssim: Vec<f64>,
}

impl<'a> PicturePair<'a> {
    pub fn new(image: &'a Planes, truth: &'a Planes) -> Self {
        let width = image.size[0];
        let plane = width * image.size[1];
        let mut ssim = vec![0.0; plane];
        let channels = image
            .data
            .chunks_exact(plane)
            .zip(truth.data.chunks_exact(plane));
        for (a, b) in channels {
            let wide = |numbers: &[f32]| numbers.iter().map(|&n| f64::from(n)).collect::<Vec<_>>();
            for (sum, own) in ssim.iter_mut().zip(ssim_map(&wide(a), &wide(b), width)) {
                *sum += own / 3.0;
            }
        }
        Self { image, truth, ssim }
    }

    /// The numbers over some pixels, by index, without a perceptual distance. None: there are none.
    pub fn over(&self, pixels: impl Iterator<Item = usize>) -> Option<Metrics> {
        let plane = self.ssim.len();
        let mut count = 0;
        let (mut sum, mut squares, mut ssim) = (0.0, 0.0, 0.0);
        for at in pixels {
            count += 1;
            ssim += self.ssim[at];
            for channel in 0..3 {
                let at = channel * plane + at;
                let error = f64::from(self.image.data[at]) - f64::from(self.truth.data[at]);
                sum += error.abs();
                squares += error * error;
            }
        }
        let numbers = 3.0 * f64::from(count);
        (count > 0).then(|| Metrics {
            psnr_db: (-10.0 * (squares / numbers).log10()).min(MAX_PSNR),
            ssim: ssim / f64::from(count),
            l1: sum / numbers,
            st_lpips: None,
            lpips: None,
        })
    }
}

impl Metrics {
    /// Adds the network's distance of two pictures; none where a side is too small for it.
    pub fn see(&mut self, perceptual: &Perceptual, image: &Planes, truth: &Planes) {
        let smallest = perceptual.network().smallest_side() as usize;
        let fits = image.size.iter().all(|&side| side >= smallest);
        let distance = fits.then(|| perceptual.value(image, &perceptual.features(truth)));
        if perceptual.network().is_lpips() {
            self.lpips = distance;
        } else {
            self.st_lpips = distance;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_pixels_asked_for() {
        let mut truth = Planes::black([20, 10]);
        truth.data.fill(0.5);
        let mut image = truth.clone();
        for channel in 0..3 {
            for at in 0..100 {
                image.data[channel * 200 + at] = 0.6;
            }
        }
        let pair = PicturePair::new(&image, &truth);
        let wrong = pair.over(0..100).expect("pixels");
        let right = pair.over(160..200).expect("pixels");
        assert!((wrong.psnr_db - 20.0).abs() < 1e-4 && (wrong.l1 - 0.1).abs() < 1e-6);
        assert!(right.psnr_db == MAX_PSNR && right.l1 == 0.0 && right.ssim > wrong.ssim);
        assert_eq!(pair.over(0..0), None);
        let means = Means::of([wrong, right].iter()).expect("two");
        assert!((means.psnr_db - 60.0).abs() < 1e-3 && means.st_lpips.is_none());
    }
}
