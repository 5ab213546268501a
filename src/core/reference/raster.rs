//! Stage `raster` (docs/model.md, step 10): premultiplied colour and coverage of every pixel.

use super::project::{Culled, Splat};
use crate::{
    constants::{ALPHA_MAX, ALPHA_MIN},
    scene::{Camera, FrameImage},
};
use glam::{DVec2, DVec4};
use rayon::prelude::*;
use std::ops::Range;

/// Rows of pixels that one task draws: few enough to share the work evenly, many enough that most
/// splats touch only one band.
const BAND: usize = 32;

/// An image in f64: premultiplied display-referred RGBA, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    /// Width and height, px.
    pub size: [u32; 2],
    /// One entry a pixel; alpha is the coverage, 0 to 1.
    pub pixels: Vec<[f64; 4]>,
}

impl Canvas {
    /// The image rounded to f32.
    pub fn to_image(&self) -> FrameImage {
        FrameImage {
            size: self.size,
            pixels: self.pixels.iter().map(|p| p.map(|v| v as f32)).collect(),
        }
    }
}

/// Blends the splats of `order` over each other, back to front.
pub fn raster(splats: &[Result<Splat, Culled>], order: &[u32], camera: &Camera) -> Canvas {
    let [width, height] = camera.size.map(|side| side as usize);
    let drawn: Vec<DrawnSplat> = order
        .iter()
        .filter_map(|&k| splats[k as usize].as_ref().ok())
        .map(|s| DrawnSplat::new(s, camera))
        .collect();
    let mut pixels = vec![[0.0; 4]; width * height];
    pixels
        .par_chunks_mut(width * BAND)
        .enumerate()
        .for_each(|(band, pixels)| {
            let rows = band * BAND..(band * BAND + pixels.len() / width);
            for ellipse in &drawn {
                for y in ellipse.rows_within(&rows) {
                    ellipse.draw_row(y, &mut pixels[(y - rows.start) * width..][..width]);
                }
            }
        });
    Canvas {
        size: camera.size,
        pixels,
    }
}

/// How much each splat contributes to the image: the sum over all pixels of its colour's squared
/// weight; one number a splat. If the colours of splats have independent errors, each adds this
/// many times its own squared error to the image's.
pub fn contributions(splats: &[Result<Splat, Culled>], order: &[u32], camera: &Camera) -> Vec<f64> {
    let [width, height] = camera.size.map(|side| side as usize);
    let ellipse = |&k: &u32| {
        Some((
            k as usize,
            DrawnSplat::new(splats[k as usize].as_ref().ok()?, camera),
        ))
    };
    let near_to_far: Vec<(usize, DrawnSplat)> = order.iter().rev().filter_map(ellipse).collect();
    let band = |start: usize| {
        let rows = start..(start + BAND).min(height);
        let mut sums = vec![0.0; splats.len()];
        let mut transmittance = vec![1.0; rows.len() * width];
        for (k, ellipse) in &near_to_far {
            for y in ellipse.rows_within(&rows) {
                let row = &mut transmittance[(y - rows.start) * width..][..width];
                for x in ellipse.columns.clone() {
                    let alpha = ellipse.alpha(x, y);
                    if alpha >= ALPHA_MIN {
                        sums[*k] += (alpha * row[x]).powi(2);
                        row[x] *= 1.0 - alpha;
                    }
                }
            }
        }
        sums
    };
    let bands: Vec<Vec<f64>> = (0..height)
        .into_par_iter()
        .step_by(BAND)
        .map(band)
        .collect();
    (0..splats.len())
        .map(|k| bands.iter().map(|band| band[k]).sum())
        .collect()
}

/// A splat ready to be drawn.
pub(super) struct DrawnSplat {
    center: DVec2,
    /// Σ'⁻¹ as [a, b, c], 1/px².
    inverse: [f64; 3],
    opacity: f64,
    /// RGB and 1.
    color: DVec4,
    /// Pixels whose centres lie in the splat's box.
    columns: Range<usize>,
    rows: Range<usize>,
}

impl DrawnSplat {
    pub(super) fn new(splat: &Splat, camera: &Camera) -> Self {
        let [a, b, c] = splat.covariance;
        let det = splat.determinant;
        let [columns, rows] = std::array::from_fn(|axis| {
            let center = splat.center[axis];
            let radius = splat.radius[axis];
            // Pixel i has its centre at i + 0.5. The casts saturate at 0.
            let first = (center - radius - 0.5).ceil() as usize;
            let end = ((center + radius - 0.5).floor() + 1.0) as usize;
            first..end.min(camera.size[axis] as usize)
        });
        let color = splat.color.extend(1.0);
        Self {
            center: splat.center,
            inverse: [c / det, -b / det, a / det],
            opacity: splat.opacity,
            color,
            columns,
            rows,
        }
    }

    /// The rows of pixels that both the ellipse and a band have.
    fn rows_within(&self, band: &Range<usize>) -> Range<usize> {
        self.rows.start.max(band.start)..self.rows.end.min(band.end)
    }

    /// α at a pixel's centre.
    fn alpha(&self, x: usize, y: usize) -> f64 {
        self.alpha_at(DVec2::new(x as f64 + 0.5, y as f64 + 0.5))
    }

    /// α at a place, px, where it is at least [`ALPHA_MIN`].
    pub(super) fn visible_alpha_at(&self, at: DVec2) -> Option<f64> {
        Some(self.alpha_at(at)).filter(|&alpha| alpha >= ALPHA_MIN)
    }

    /// α = min([`ALPHA_MAX`], o exp(−½ dᵀ Σ'⁻¹ d)) at a place, px.
    fn alpha_at(&self, at: DVec2) -> f64 {
        let [a, b, c] = self.inverse;
        let d = at - self.center;
        let power = -0.5 * (a * d.x * d.x + 2.0 * b * d.x * d.y + c * d.y * d.y);
        (self.opacity * power.exp()).min(ALPHA_MAX)
    }

    /// Blends over one row of the image: C = α c + (1 − α) C where α is at least 1/255.
    fn draw_row(&self, y: usize, row: &mut [[f64; 4]]) {
        for x in self.columns.clone() {
            let alpha = self.alpha(x, y);
            if alpha >= ALPHA_MIN {
                row[x] = (alpha * self.color + (1.0 - alpha) * DVec4::from(row[x])).to_array();
            }
        }
    }
}
