//! Stage `raster` (docs/model.md, step 10): premultiplied colour and coverage of every pixel.

use super::{
    project::{Culled, Splat, SplatGradient},
    ray::RayGaussian,
};
use crate::{
    constants::{ALPHA_MAX, ALPHA_MIN},
    each,
    scene::{Camera, FrameImage},
};
use glam::{DVec2, DVec4};
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
    raster_with(splats, order, camera, Cutoff::Sharp)
}

/// [`raster`] with a cutoff of one's choice.
pub fn raster_with(
    splats: &[Result<Splat, Culled>],
    order: &[u32],
    camera: &Camera,
    cutoff: Cutoff,
) -> Canvas {
    let drawn: Vec<DrawnSplat> = order
        .iter()
        .filter_map(|&k| splats[k as usize].as_ref().ok())
        .map(|splat| DrawnSplat::new(splat, camera))
        .collect();
    in_bands(camera.size, |band, pixels| {
        for ellipse in &drawn {
            ellipse.each_pixel(band, |at, _, alpha| {
                ellipse.blend(cutoff.of(alpha), &mut pixels[at]);
            });
        }
    })
}

/// How contributions under the opacity cutoff vanish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cutoff {
    /// α below [`ALPHA_MIN`] is skipped (docs/model.md, step 10): the image jumps there, and its
    /// derivative leaves the jump out.
    Sharp,
    /// α below [`ALPHA_MIN`] is 0 and rises from there without a jump or a kink, up to twice
    /// [`ALPHA_MIN`]: for holding derivatives against differences.
    Smooth,
}

impl Cutoff {
    /// What is blended for an α of at least [`ALPHA_MIN`].
    fn of(self, alpha: f64) -> f64 {
        match self {
            Self::Sharp => alpha,
            Self::Smooth => {
                let x = (alpha / ALPHA_MIN - 1.0).clamp(0.0, 1.0);
                alpha * x * x * (3.0 - 2.0 * x)
            }
        }
    }

    /// Derivative of [`Self::of`].
    fn slope(self, alpha: f64) -> f64 {
        match self {
            Self::Sharp => 1.0,
            Self::Smooth => {
                let x = (alpha / ALPHA_MIN - 1.0).clamp(0.0, 1.0);
                x * x * (3.0 - 2.0 * x) + alpha * 6.0 * x * (1.0 - x) / ALPHA_MIN
            }
        }
    }
}

/// The derivative of [`raster_with`]; one entry a splat. `canvas`: what it drew; `gradient`: of the
/// loss with respect to the canvas' pixels, premultiplied RGB and coverage.
///
/// Front to back: with T the transmittance before a splat, s its colour times the pixel's gradient
/// and `behind` the same of all that lies behind it, ∂α = T s − behind / (1 − α).
pub fn raster_backward(
    splats: &[Result<Splat, Culled>],
    order: &[u32],
    camera: &Camera,
    cutoff: Cutoff,
    canvas: &Canvas,
    gradient: &[[f64; 4]],
) -> Vec<SplatGradient> {
    /// The colour of a pixel so far, and the transmittance that is left.
    struct BlendedPixel {
        transmittance: f64,
        sum: f64,
    }
    let near_to_far: Vec<(usize, DrawnSplat)> = order
        .iter()
        .rev()
        .filter_map(|&k| {
            let splat = splats[k as usize].as_ref().ok()?;
            Some((k as usize, DrawnSplat::new(splat, camera)))
        })
        .collect();
    let of_band = |band: &Band| {
        let first = band.rows.start * band.width;
        let mut seen: Vec<BlendedPixel> = Vec::new();
        seen.resize_with(band.pixels(), || BlendedPixel {
            transmittance: 1.0,
            sum: 0.0,
        });
        let mut sums = vec![SplatGradient::default(); splats.len()];
        for (k, ellipse) in &near_to_far {
            let [a, b, c] = ellipse.inverse;
            let sum = &mut sums[*k];
            ellipse.each_pixel(band, |at, place, alpha| {
                let pixel = DVec4::from(gradient[first + at]);
                let total = pixel.dot(DVec4::from(canvas.pixels[first + at]));
                let seen = &mut seen[at];
                let blended = cutoff.of(alpha);
                let weight = blended * seen.transmittance;
                let light = ellipse.color.dot(pixel);
                let behind = total - seen.sum - weight * light;
                let of_blended = seen.transmittance * light - behind / (1.0 - blended);
                seen.sum += weight * light;
                seen.transmittance *= 1.0 - blended;
                sum.color += weight * pixel.truncate();
                if alpha < ALPHA_MAX {
                    let of_power = of_blended * cutoff.slope(alpha) * alpha;
                    let d = place - ellipse.center;
                    sum.opacity += of_power / ellipse.opacity;
                    sum.center += of_power * DVec2::new(a * d.x + b * d.y, b * d.x + c * d.y);
                    sum.inverse[0] -= 0.5 * of_power * d.x * d.x;
                    sum.inverse[1] -= of_power * d.x * d.y;
                    sum.inverse[2] -= 0.5 * of_power * d.y * d.y;
                }
            });
        }
        sums
    };
    // In the order of the bands, whatever the number of threads.
    let bands = Band::of(camera.size);
    let bands = each::map(bands.len(), |at| of_band(&bands[at]));
    let mut all = vec![SplatGradient::default(); splats.len()];
    for band in bands {
        for (all, one) in all.iter_mut().zip(band) {
            all.center += one.center;
            all.opacity += one.opacity;
            all.color += one.color;
            for (sum, part) in all.inverse.iter_mut().zip(one.inverse) {
                *sum += part;
            }
        }
    }
    all
}

/// Blends splats over each other, back to front by the depth at which each is densest along the ray
/// through the pixel, so that two that pass through each other change places where they meet. At
/// equal depth the lower index is drawn first. `rays`: one a splat, of its Gaussian.
pub fn raster_per_pixel(
    splats: &[Result<Splat, Culled>],
    rays: &[RayGaussian],
    camera: &Camera,
) -> Canvas {
    struct Fragment {
        depth: f64,
        alpha: f64,
        splat: usize,
    }
    let drawn: Vec<(DrawnSplat, RayGaussian)> = splats
        .iter()
        .zip(rays)
        .filter_map(|(splat, ray)| Some((DrawnSplat::new(splat.as_ref().ok()?, camera), *ray)))
        .collect();
    in_bands(camera.size, |band, pixels| {
        let mut fragments: Vec<Vec<Fragment>> = Vec::new();
        fragments.resize_with(band.pixels(), Vec::new);
        for (splat, (ellipse, ray)) in drawn.iter().enumerate() {
            ellipse.each_pixel(band, |at, place, alpha| {
                fragments[at].push(Fragment {
                    depth: ray.peak(camera.ray(place)),
                    alpha,
                    splat,
                });
            });
        }
        for (fragments, pixel) in fragments.iter_mut().zip(pixels) {
            // Stable: they come in the order of their indices.
            fragments.sort_by(|a, b| b.depth.total_cmp(&a.depth));
            for fragment in fragments {
                drawn[fragment.splat].0.blend(fragment.alpha, pixel);
            }
        }
    })
}

/// Some rows of an image.
pub(super) struct Band {
    /// The rows.
    pub(super) rows: Range<usize>,
    /// Columns of the image.
    width: usize,
}

impl Band {
    /// The bands of an image of a width and height, from the top.
    pub(super) fn of(size: [u32; 2]) -> Vec<Self> {
        let [width, height] = size.map(|side| side as usize);
        (0..height)
            .step_by(BAND)
            .map(|start| Self {
                rows: start..(start + BAND).min(height),
                width,
            })
            .collect()
    }

    /// How many pixels it has.
    pub(super) fn pixels(&self) -> usize {
        self.rows.len() * self.width
    }
}

/// Draws an image band by band, in parallel. `draw` gets the pixels of a band, still empty.
fn in_bands(size: [u32; 2], draw: impl Fn(&Band, &mut [[f64; 4]]) + Sync) -> Canvas {
    let [width, height] = size.map(|side| side as usize);
    let mut pixels = vec![[0.0; 4]; width * height];
    let bands = Band::of(size);
    each::chunk(&mut pixels, (width * BAND).max(1), |at, pixels| {
        draw(&bands[at], pixels);
    });
    Canvas { size, pixels }
}

/// How much each splat contributes to the image: the sum over all pixels of its colour's squared
/// weight; one number a splat. If the colours of splats have independent errors, each adds this
/// many times its own squared error to the image's.
pub fn contributions(splats: &[Result<Splat, Culled>], order: &[u32], camera: &Camera) -> Vec<f64> {
    let ellipse = |&k: &u32| {
        Some((
            k as usize,
            DrawnSplat::new(splats[k as usize].as_ref().ok()?, camera),
        ))
    };
    let near_to_far: Vec<(usize, DrawnSplat)> = order.iter().rev().filter_map(ellipse).collect();
    let sums = |band: &Band| {
        let mut sums = vec![0.0; splats.len()];
        let mut transmittance = vec![1.0; band.pixels()];
        for (k, ellipse) in &near_to_far {
            ellipse.each_pixel(band, |at, _, alpha| {
                sums[*k] += (alpha * transmittance[at]).powi(2);
                transmittance[at] *= 1.0 - alpha;
            });
        }
        sums
    };
    let bands = Band::of(camera.size);
    let bands = each::map(bands.len(), |at| sums(&bands[at]));
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

    /// Calls `draw` for each pixel of a band where α is at least [`ALPHA_MIN`], with the pixel's
    /// index in the band, its centre, px, and α.
    pub(super) fn each_pixel(&self, band: &Band, mut draw: impl FnMut(usize, DVec2, f64)) {
        let rows = self.rows.start.max(band.rows.start)..self.rows.end.min(band.rows.end);
        for y in rows {
            let first = (y - band.rows.start) * band.width;
            for x in self.columns.clone() {
                let center = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                if let Some(alpha) = self.visible_alpha_at(center) {
                    draw(first + x, center, alpha);
                }
            }
        }
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

    /// Blends over a pixel: C = α c + (1 − α) C.
    fn blend(&self, alpha: f64, pixel: &mut [f64; 4]) {
        *pixel = (alpha * self.color + (1.0 - alpha) * DVec4::from(*pixel)).to_array();
    }
}
