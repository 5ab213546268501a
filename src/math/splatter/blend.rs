//! Blending of splats into small images, near to far, with its derivatives (docs/model.md, step
//! 10). One thread draws an image; images are drawn side by side.

use super::splats::{ImageSplat, ImageSplatGradient};
use effigy_core::constants::{ALPHA_MAX, ALPHA_MIN};
use effigy_core::scene::FrameImage;
use glam::{Vec2, Vec3, Vec4};
use std::ops::Range;

/// Pixels that let less than this through are complete.
const OPAQUE: f32 = 1e-4;

/// Each pixel as a square of `side` pixels a side.
pub fn enlarged(image: &FrameImage, side: u32) -> FrameImage {
    let size = image.size.map(|length| length * side);
    let [width, side] = [size[0] as usize, side as usize];
    let pixel = |at: usize| {
        let [x, y] = [at % width / side, at / width / side];
        image.pixels[y * (width / side) + x]
    };
    FrameImage {
        size,
        pixels: (0..width * size[1] as usize).map(pixel).collect(),
    }
}

/// Splats drawn into an image.
pub struct Blended {
    /// Splats, near to far, by their indices.
    order: Vec<u32>,
    /// The image.
    pub image: FrameImage,
    /// What each pixel lets through.
    through: Vec<f32>,
    /// How many splats of the order there are up to the last that each pixel shows.
    end: Vec<u32>,
}

/// A splat's pixels in a row, and α there.
struct RowSpan {
    /// 2 × the term of the exponent that is linear in x, and the constant one.
    linear: f32,
    constant: f32,
    columns: Range<usize>,
}

/// The rows that a splat may be visible in.
fn rows(splat: &ImageSplat, height: usize) -> Range<usize> {
    pixels(splat.center.y, splat.radius.y, height)
}

/// Pixels whose centres are within a radius, in a row or column of `length`.
fn pixels(center: f32, radius: f32, length: usize) -> Range<usize> {
    // Pixel i has its centre at i + 0.5. The casts saturate at 0.
    let first = (center - radius - 0.5).ceil() as usize;
    let end = ((center + radius + 0.5).floor()) as usize;
    first..end.min(length).max(first)
}

/// The part of a row in which a splat is visible.
fn span(splat: &ImageSplat, y: usize, width: usize) -> RowSpan {
    let [a, b, c] = splat.inverse;
    let dy = y as f32 + 0.5 - splat.center.y;
    // a dx² + 2 b dy dx + c dy² ≤ reach.
    let middle = -b * dy / a;
    let constant = c * dy * dy;
    let discriminant = splat.reach / a - constant / a + middle * middle;
    let columns = if discriminant > 0.0 {
        pixels(splat.center.x + middle, discriminant.sqrt(), width)
    } else {
        0..0
    };
    RowSpan {
        linear: b * dy,
        constant,
        columns,
    }
}

impl RowSpan {
    /// o exp(−½ dᵀΣ'⁻¹d) at a column, before it is cut at the largest α.
    fn alpha(&self, splat: &ImageSplat, x: usize) -> f32 {
        let dx = x as f32 + 0.5 - splat.center.x;
        let power = dx * (splat.inverse[0] * dx + 2.0 * self.linear) + self.constant;
        splat.opacity * (-0.5 * power).exp()
    }
}

const LEAST: f32 = ALPHA_MIN as f32;
const MOST: f32 = ALPHA_MAX as f32;

impl Blended {
    /// Draws splats into a transparent image. `seen` is called for each splat with the sum over all
    /// pixels of what it contributes, and the largest of it.
    pub fn new(
        splats: &[Option<ImageSplat>],
        size: [u32; 2],
        mut seen: impl FnMut(usize, f32, f32),
    ) -> Self {
        let mut order: Vec<u32> = (0..splats.len() as u32)
            .filter(|&k| splats[k as usize].is_some())
            .collect();
        // Depths are positive, whose bits have their order; equal depths keep that of indices.
        order.sort_by_key(|&k| splats[k as usize].as_ref().map_or(0, |s| s.depth.to_bits()));
        let [width, height] = size.map(|side| side as usize);
        let mut pixels = vec![Vec4::ZERO; width * height];
        let mut through = vec![1.0; pixels.len()];
        let mut end = vec![0; pixels.len()];
        for (at, &k) in order.iter().enumerate() {
            let Some(splat) = &splats[k as usize] else {
                continue;
            };
            let color = splat.color.extend(1.0);
            let mut sum = 0.0;
            let mut largest = 0f32;
            for y in rows(splat, height) {
                let span = span(splat, y, width);
                for x in span.columns.clone() {
                    let pixel = y * width + x;
                    let before = through[pixel];
                    if before < OPAQUE {
                        continue;
                    }
                    let alpha = span.alpha(splat, x).min(MOST);
                    if alpha < LEAST {
                        continue;
                    }
                    pixels[pixel] += before * alpha * color;
                    through[pixel] = before * (1.0 - alpha);
                    end[pixel] = at as u32 + 1;
                    sum += before * alpha;
                    largest = largest.max(before * alpha);
                }
            }
            seen(k as usize, sum, largest);
        }
        Self {
            order,
            image: FrameImage {
                size,
                pixels: pixels.iter().map(Vec4::to_array).collect(),
            },
            through,
            end,
        }
    }

    /// The derivative of a loss by the splats, from that by the image's pixels.
    pub fn gradient(
        mut self,
        splats: &[Option<ImageSplat>],
        by: &FrameImage,
    ) -> Vec<ImageSplatGradient> {
        let [width, height] = self.image.size.map(|side| side as usize);
        let mut gradients = vec![ImageSplatGradient::default(); splats.len()];
        // What lies behind each splat, premultiplied, as if nothing were before it.
        let mut behind = vec![Vec4::ZERO; self.image.pixels.len()];
        for (at, &k) in self.order.iter().enumerate().rev() {
            let Some(splat) = &splats[k as usize] else {
                continue;
            };
            let color = splat.color.extend(1.0);
            let mut gradient = ImageSplatGradient::default();
            for y in rows(splat, height) {
                let span = span(splat, y, width);
                let dy = y as f32 + 0.5 - splat.center.y;
                for x in span.columns.clone() {
                    let pixel = y * width + x;
                    if at as u32 >= self.end[pixel] {
                        continue;
                    }
                    let free = span.alpha(splat, x);
                    let alpha = free.min(MOST);
                    if alpha < LEAST {
                        continue;
                    }
                    let before = self.through[pixel] / (1.0 - alpha);
                    self.through[pixel] = before;
                    let by_pixel = Vec4::from(by.pixels[pixel]);
                    gradient.color += before * alpha * by_pixel.truncate();
                    let by_alpha = before * by_pixel.dot(color - behind[pixel]);
                    behind[pixel] = alpha * color + (1.0 - alpha) * behind[pixel];
                    if free >= MOST {
                        continue;
                    }
                    let by_power = -0.5 * by_alpha * alpha;
                    let dx = x as f32 + 0.5 - splat.center.x;
                    gradient.opacity += by_alpha * alpha;
                    gradient.inverse[0] += by_power * dx * dx;
                    gradient.inverse[1] += by_power * 2.0 * dx * dy;
                    gradient.inverse[2] += by_power * dy * dy;
                    gradient.center -= by_power
                        * 2.0
                        * Vec2::new(
                            splat.inverse[0] * dx + span.linear,
                            splat.inverse[1] * dx + splat.inverse[2] * dy,
                        );
                }
            }
            gradient.opacity /= splat.opacity;
            gradients[k as usize] = gradient;
        }
        gradients
    }
}

/// The derivative, by an image's pixels, of its squared error over a background of random grey. For
/// errors c of RGB and a of the coverage, the mean over all greys is |c − a/2|²/3 + a²/12.
pub fn loss_gradient(image: &FrameImage, truth: &FrameImage) -> FrameImage {
    let by = |(&a, &b): (&[f32; 4], &[f32; 4])| {
        let d = Vec4::from(a) - Vec4::from(b);
        let c: Vec3 = d.truncate() - 0.5 * d.w;
        let by = (c * (2.0 / 3.0)).extend(d.w / 6.0 - c.element_sum() / 3.0);
        by.to_array()
    };
    FrameImage {
        size: image.size,
        pixels: image.pixels.iter().zip(&truth.pixels).map(by).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splatter::splats::{FittedShape, PosedGaussian, Projection};
    use effigy_core::avatar::Filter;
    use effigy_core::random::Random;
    use effigy_core::scene::Camera;
    use glam::{DVec3, Mat3, Quat};

    const SIZE: [u32; 2] = [24, 20];

    fn vector(random: &mut Random, low: f64, high: f64) -> Vec3 {
        let mut one = || random.range(low, high) as f32;
        Vec3::new(one(), one(), one())
    }

    /// Gaussians of some pixels in front of each other, some of them edge-on.
    fn scene(random: &mut Random) -> (Vec<FittedShape>, Vec<PosedGaussian>) {
        let one = |random: &mut Random| {
            let shape = FittedShape {
                offset: vector(random, -0.01, 0.01),
                turn: vector(random, -0.3, 0.3),
                log_scale: vector(random, -3.6, -2.2),
                logit: random.range(-1.5, 1.5) as f32,
                color: vector(random, 0.2, 0.8),
            };
            let turn = Quat::from_scaled_axis(vector(random, -2.0, 2.0));
            let placed = PosedGaussian {
                mean: vector(random, -0.25, 0.25),
                axes: Mat3::from_quat(turn) * Mat3::from_diagonal(vector(random, 0.9, 1.1)),
                log_scale: vector(random, -0.1, 0.1),
                color: vector(random, -0.1, 0.1),
            };
            (shape, placed)
        };
        (0..12).map(|_| one(random)).unzip()
    }

    fn projection(compensated: bool) -> Projection {
        let eye = DVec3::new(0.1, 0.05, 3.0);
        let camera = Camera::look_at(eye, DVec3::ZERO, 0.25, SIZE);
        let filter = Filter {
            variance: 0.1,
            compensated,
        };
        Projection::new(&camera, filter)
    }

    fn draw(projection: &Projection, shapes: &[FittedShape], placed: &[PosedGaussian]) -> Blended {
        Blended::new(&splats(projection, shapes, placed), SIZE, |_, _, _| ())
    }

    fn splats(
        projection: &Projection,
        shapes: &[FittedShape],
        placed: &[PosedGaussian],
    ) -> Vec<Option<ImageSplat>> {
        let pairs = shapes.iter().zip(placed);
        pairs.map(|(s, p)| projection.splat(s, p)).collect()
    }

    /// The mean over all greys of what [`loss_gradient`] is the derivative of, by 64 of them.
    fn loss(image: &FrameImage, truth: &FrameImage) -> f64 {
        let over = |grey: f32| -> f64 {
            let pairs = image.pixels.iter().zip(&truth.pixels);
            let squares = pairs.map(|(&a, &b)| {
                let d = Vec4::from(a) - Vec4::from(b);
                f64::from((d.truncate() - grey * d.w).length_squared()) / 3.0
            });
            squares.sum()
        };
        (0..64).map(|k| over((k as f32 + 0.5) / 64.0)).sum::<f64>() / 64.0
    }

    #[test]
    fn derivatives_are_those_of_the_loss() {
        for compensated in [false, true] {
            let random = &mut Random::new(3, u64::from(compensated));
            let (shapes, placed) = scene(random);
            let (other, _) = scene(random);
            let projection = projection(compensated);
            let truth = draw(&projection, &other, &placed).image;
            let blended = draw(&projection, &shapes, &placed);
            let by = loss_gradient(&blended.image, &truth);
            let by_splat = blended.gradient(&splats(&projection, &shapes, &placed), &by);
            let mut squares = [0.0; FittedShape::NUMBERS];
            let mut errors = [0.0; FittedShape::NUMBERS];
            for k in 0..shapes.len() {
                let got = projection.gradient(&shapes[k], &placed[k], &by_splat[k]);
                for n in 0..FittedShape::NUMBERS {
                    const STEP: f32 = 4e-3;
                    let moved = |step: f32| {
                        let mut moved = shapes.clone();
                        let mut numbers = moved[k].to_array();
                        numbers[n] += step;
                        // A turn is measured from where the Gaussian is.
                        moved[k] = FittedShape::from_array(numbers);
                        if (3..6).contains(&n) {
                            let mut turn = Vec3::ZERO;
                            turn[n - 3] = step;
                            let whole = Quat::from_scaled_axis(shapes[k].turn)
                                * Quat::from_scaled_axis(turn);
                            moved[k].turn = whole.to_scaled_axis();
                        }
                        loss(&draw(&projection, &moved, &placed).image, &truth)
                    };
                    let expected = (moved(STEP) - moved(-STEP)) / f64::from(2.0 * STEP);
                    squares[n] += expected * expected;
                    errors[n] += (f64::from(got[n]) - expected).powi(2);
                }
            }
            for (n, (error, square)) in errors.iter().zip(squares).enumerate() {
                let share = (error / square).sqrt();
                // Pixels that appear at the opacity cutoff as a Gaussian moves or grows have no
                // derivative; colours bring none.
                let most = if n < 10 { 0.3 } else { 1e-4 };
                assert!(
                    square > 0.0 && share < most,
                    "{share} of number {n}, {compensated}"
                );
            }
        }
    }

    #[test]
    fn averages_of_enlarged_images_are_the_images() {
        let random = &mut Random::new(5, 0);
        let pixel = |_| vector(random, 0.0, 1.0).extend(0.5).to_array();
        let image = FrameImage {
            size: [6, 4],
            pixels: (0..24).map(pixel).collect(),
        };
        let large = enlarged(&image, 3);
        assert_eq!(large.size, [18, 12]);
        assert_eq!(large.pixels[18 * 5 + 10], image.pixels[6 + 3]);
        let back = large.averaged(3);
        let pairs = back
            .pixels
            .as_flattened()
            .iter()
            .zip(image.pixels.as_flattened());
        assert!(back.size == image.size && pairs.map(|(a, b)| (a - b).abs()).all(|d| d < 1e-6));
    }
}
