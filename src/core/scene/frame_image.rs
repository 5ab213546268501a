//! Images in memory, as every backend and the reference return them: premultiplied colour and
//! coverage, without a background.

#[cfg(not(target_arch = "wasm32"))]
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

#[cfg(not(target_arch = "wasm32"))]
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
