//! Images in memory, as every backend and the reference return them: premultiplied colour and
//! coverage, without a background.

#[cfg(feature = "image")]
use image::{ImageBuffer, Rgba, RgbaImage};

/// An image of premultiplied display-referred RGBA, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameImage {
    /// Width and height, px.
    pub size: [u32; 2],
    /// One entry a pixel; alpha is the coverage, 0 to 1.
    pub pixels: Vec<[f32; 4]>,
}

impl FrameImage {
    /// A transparent image of a width and height.
    pub fn empty(size: [u32; 2]) -> Self {
        Self {
            size,
            pixels: vec![[0.0; 4]; size[0] as usize * size[1] as usize],
        }
    }

    /// Each pixel the mean of `factor` by `factor`, at least 1. What does not fill a pixel at the
    /// right and lower edge is left out.
    pub fn averaged(&self, factor: u32) -> Self {
        let size = self.size.map(|side| side / factor);
        let share = 1.0 / (f64::from(factor) * f64::from(factor));
        let mean = |pixel: u64| {
            let column = pixel % u64::from(size[0]) * u64::from(factor);
            let row = pixel / u64::from(size[0]) * u64::from(factor);
            let mut sum = [0.0; 4];
            for y in row..row + u64::from(factor) {
                let start = (y * u64::from(self.size[0]) + column) as usize;
                for own in &self.pixels[start..start + factor as usize] {
                    for (sum, own) in sum.iter_mut().zip(own) {
                        *sum += f64::from(*own);
                    }
                }
            }
            sum.map(|sum| (share * sum) as f32)
        };
        Self {
            size,
            pixels: (0..u64::from(size[0]) * u64::from(size[1]))
                .map(mean)
                .collect(),
        }
    }

    /// An image of a size, px, which shows this one so many times less large, at least once: each
    /// pixel is the mean over its area. What lies beyond the right and lower edge is left out.
    pub fn resampled(&self, factor: f64, size: [u32; 2]) -> Self {
        // A share of what begins at `at` that is not worth a texel is what rounding leaves of none.
        let spans = |at: u32, side: u32| -> Vec<(usize, f64)> {
            let [begin, end] = [at, at + 1].map(|at| factor * f64::from(at));
            (begin as u32..(end.ceil() as u32).min(side))
                .map(|texel| {
                    let [from, to] = [texel, texel + 1].map(f64::from);
                    (texel as usize, end.min(to) - begin.max(from))
                })
                .filter(|(_, share)| *share > 1e-6)
                .collect()
        };
        let columns: Vec<_> = (0..size[0]).map(|at| spans(at, self.size[0])).collect();
        let mut pixels = Vec::with_capacity(size[0] as usize * size[1] as usize);
        for row in 0..size[1] {
            let rows = spans(row, self.size[1]);
            for columns in &columns {
                let mut sum = [0.0; 4];
                let mut area = 0.0;
                for &(y, tall) in &rows {
                    for &(x, wide) in columns {
                        let own = self.pixels[y * self.size[0] as usize + x];
                        for (sum, own) in sum.iter_mut().zip(own) {
                            *sum += tall * wide * f64::from(own);
                        }
                        area += tall * wide;
                    }
                }
                pixels.push(sum.map(|sum| (sum / area) as f32));
            }
        }
        Self { size, pixels }
    }

    /// Blends it over another of its size.
    ///
    /// # Panics
    /// Where that has another size.
    pub fn blended_over(&self, behind: &Self) -> Self {
        assert_eq!(self.size, behind.size, "images of one size are blended");
        let over = |(own, behind): (&[f32; 4], &[f32; 4])| {
            std::array::from_fn(|k| own[k] + (1.0 - own[3]) * behind[k])
        };
        Self {
            size: self.size,
            pixels: self.pixels.iter().zip(&behind.pixels).map(over).collect(),
        }
    }
}

#[cfg(feature = "image")]
impl FrameImage {
    /// Blends the image over a background colour, to 8 bits a channel.
    ///
    /// # Panics
    /// When it has fewer pixels than its size says.
    pub fn over(&self, background: [f32; 3]) -> RgbaImage {
        self.to_image(|p| {
            let [r, g, b] = std::array::from_fn(|k| p[k] + (1.0 - p[3]) * background[k]);
            [r, g, b, 1.0]
        })
    }

    /// Converts to straight (not premultiplied) alpha for PNG, 8 bits a channel.
    ///
    /// # Panics
    /// When it has fewer pixels than its size says.
    pub fn transparent(&self) -> RgbaImage {
        self.to_image(|p| {
            let scale = if p[3] > 0.0 { 1.0 / p[3] } else { 0.0 };
            [p[0] * scale, p[1] * scale, p[2] * scale, p[3]]
        })
    }

    fn to_image(&self, color: impl Fn([f32; 4]) -> [f32; 4]) -> RgbaImage {
        let [width, height] = self.size;
        ImageBuffer::from_fn(width, height, |x, y| {
            let pixel = self.pixels[y as usize * width as usize + x as usize];
            Rgba(color(pixel).map(|v| (v * 255.0).round().clamp(0.0, 255.0) as u8))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn image(size: [u32; 2]) -> FrameImage {
        let random = &mut Random::new(7, 3);
        let mut image = FrameImage::empty(size);
        for pixel in &mut image.pixels {
            *pixel = std::array::from_fn(|_| random.uniform() as f32);
        }
        image
    }

    fn largest_difference(a: &FrameImage, b: &FrameImage) -> f32 {
        assert_eq!(a.size, b.size);
        let pixels = a.pixels.iter().flatten().zip(b.pixels.iter().flatten());
        pixels.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
    }

    #[test]
    fn a_whole_number_of_times_is_an_average() {
        let large = image([24, 16]);
        for factor in [1, 2, 4] {
            let average = large.averaged(factor);
            let resampled = large.resampled(factor.into(), average.size);
            assert!(largest_difference(&resampled, &average) < 1e-6);
        }
    }

    /// Drawn larger by repeating pixels, an image is itself at factors between.
    #[test]
    fn areas_are_weighed_by_what_they_cover() {
        let small = image([6, 4]);
        let mut large = FrameImage::empty([15, 10]);
        // Pixels of 2.5 texels a side: a texel in the middle of two is half of each.
        for (at, pixel) in large.pixels.iter_mut().enumerate() {
            let own = |at: usize, side: u32| {
                let begin = at as f64 / 2.5;
                let end = (at + 1) as f64 / 2.5;
                let first = begin as u32;
                let next = (first + 1).min(side - 1);
                let share = ((first + 1) as f64).min(end) - begin;
                [
                    (first, share / (end - begin)),
                    (next, 1.0 - share / (end - begin)),
                ]
            };
            let mut sum = [0.0; 4];
            for (y, tall) in own(at / 15, 4) {
                for (x, wide) in own(at % 15, 6) {
                    let own = small.pixels[(y * 6 + x) as usize];
                    for (sum, own) in sum.iter_mut().zip(own) {
                        *sum += tall * wide * f64::from(own);
                    }
                }
            }
            *pixel = sum.map(|sum| sum as f32);
        }
        let back = large.resampled(2.5, [6, 4]);
        let mean = |image: &FrameImage| {
            let sum: f32 = image.pixels.iter().map(|pixel| pixel[0]).sum();
            sum / image.pixels.len() as f32
        };
        assert!((mean(&back) - mean(&small)).abs() < 1e-5);
        // The texel in the middle mixes a fifth of a pixel with half of its neighbour's.
        let expected = |k: usize| {
            let [a, b] = [0, 1].map(|x| small.pixels[x][k]);
            let rows = [small.pixels[6][k], small.pixels[7][k]];
            let top = 0.9 * a + 0.1 * b;
            let bottom = 0.9 * rows[0] + 0.1 * rows[1];
            0.9 * top + 0.1 * bottom
        };
        for k in 0..4 {
            assert!((back.pixels[0][k] - expected(k)).abs() < 1e-5);
        }
    }
}
