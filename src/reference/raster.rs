//! Stage 5, model.md step 10. In: splats and the order to draw them in. Out: premultiplied colour and coverage of every pixel.

use super::splats::{Culled, Splat};
use crate::frame::{ALPHA_MAX, ALPHA_MIN, Camera, Picture};
use glam::{DVec2, DVec4};
use rayon::prelude::*;
use std::ops::Range;

/// Rows that one task draws: few enough to share the work evenly, many enough that most splats touch one band only.
const BAND: usize = 32;

/// A picture in f64: premultiplied display-referred RGBA, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    pub size: [u32; 2],
    pub pixels: Vec<[f64; 4]>,
}

impl Canvas {
    /// Rounded to f32.
    pub fn to_picture(&self) -> Picture {
        Picture { size: self.size, pixels: self.pixels.iter().map(|p| p.map(|v| v as f32)).collect() }
    }
}

/// Draws the splats named in `order`, back to front, each over what is there.
pub fn raster(splats: &[Result<Splat, Culled>], order: &[u32], camera: &Camera) -> Canvas {
    let [width, height] = camera.size.map(|side| side as usize);
    let drawn: Vec<Ellipse> = order.iter().filter_map(|&k| splats[k as usize].as_ref().ok()).map(|s| Ellipse::new(s, camera)).collect();
    let mut pixels = vec![[0.0; 4]; width * height];
    pixels.par_chunks_mut(width * BAND).enumerate().for_each(|(band, pixels)| {
        let rows = band * BAND..(band * BAND + pixels.len() / width);
        for ellipse in drawn.iter().filter(|ellipse| ellipse.rows.start < rows.end && rows.start < ellipse.rows.end) {
            for y in ellipse.rows.start.max(rows.start)..ellipse.rows.end.min(rows.end) {
                ellipse.draw_row(y, &mut pixels[(y - rows.start) * width..][..width]);
            }
        }
    });
    Canvas { size: camera.size, pixels }
}

/// How much the picture shows of each splat: over all pixels, the sum of its colour's squared weights there; length of `splats`. Where the
/// colours of splats are off independently of each other, each adds so many times its own squared error to the picture's.
pub fn shown(splats: &[Result<Splat, Culled>], order: &[u32], camera: &Camera) -> Vec<f64> {
    let [width, height] = camera.size.map(|side| side as usize);
    let ready = |&k: &u32| Some((k as usize, Ellipse::new(splats[k as usize].as_ref().ok()?, camera)));
    let near_to_far: Vec<(usize, Ellipse)> = order.iter().rev().filter_map(ready).collect();
    let band = |start: usize| {
        let rows = start..(start + BAND).min(height);
        let (mut shown, mut left) = (vec![0.0; splats.len()], vec![1.0; rows.len() * width]);
        for (k, ellipse) in near_to_far.iter().filter(|(_, ellipse)| ellipse.rows.start < rows.end && rows.start < ellipse.rows.end) {
            for y in ellipse.rows.start.max(rows.start)..ellipse.rows.end.min(rows.end) {
                let left = &mut left[(y - rows.start) * width..][..width];
                for x in ellipse.columns.clone() {
                    let alpha = ellipse.alpha(x, y);
                    if alpha >= ALPHA_MIN {
                        shown[*k] += (alpha * left[x]).powi(2);
                        left[x] *= 1.0 - alpha;
                    }
                }
            }
        }
        shown
    };
    let bands: Vec<Vec<f64>> = (0..height).into_par_iter().step_by(BAND).map(band).collect();
    (0..splats.len()).map(|k| bands.iter().map(|band| band[k]).sum()).collect()
}

/// A splat ready to be drawn.
struct Ellipse {
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

impl Ellipse {
    fn new(splat: &Splat, camera: &Camera) -> Self {
        let [a, b, c] = splat.covariance;
        let det = splat.determinant;
        let [columns, rows] = std::array::from_fn(|axis| {
            let (center, extent) = (splat.center[axis], splat.extent[axis]);
            // Pixel i has its centre at i + 0.5. The casts take what is below 0 to 0.
            let first = (center - extent - 0.5).ceil() as usize;
            let end = ((center + extent - 0.5).floor() + 1.0) as usize;
            first..end.min(camera.size[axis] as usize)
        });
        let color = splat.color.extend(1.0);
        Self { center: splat.center, inverse: [c / det, -b / det, a / det], opacity: splat.opacity, color, columns, rows }
    }

    /// α = min(0.99, o exp(−½ dᵀ Σ'⁻¹ d)) at a pixel's centre.
    fn alpha(&self, x: usize, y: usize) -> f64 {
        let [a, b, c] = self.inverse;
        let d = DVec2::new(x as f64 + 0.5, y as f64 + 0.5) - self.center;
        let power = -0.5 * (a * d.x * d.x + 2.0 * b * d.x * d.y + c * d.y * d.y);
        (self.opacity * power.exp()).min(ALPHA_MAX)
    }

    /// `over` for the pixels of one row of the picture: C = α c + (1 − α) C where α is not below 1/255.
    fn draw_row(&self, y: usize, row: &mut [[f64; 4]]) {
        for x in self.columns.clone() {
            let alpha = self.alpha(x, y);
            if alpha >= ALPHA_MIN {
                row[x] = (alpha * self.color + (1.0 - alpha) * DVec4::from(row[x])).to_array();
            }
        }
    }
}
