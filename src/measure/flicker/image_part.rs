//! A rectangle of an image that holds all that the image shows.

use crate::error;
use effigy_core::scene::{FrameImage, PixelRect};

/// Pixels around a sample, along an axis, that it is interpolated from.
const TAPS: usize = 4;

/// A part of a frame's image outside which nothing is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct ImagePart {
    /// Where it lies in the image, px; not empty.
    pub rect: PixelRect,
    /// Its pixels.
    pub image: FrameImage,
}

impl ImagePart {
    /// Cuts a part out of an image.
    ///
    /// # Panics
    /// Where it does not lie in the image.
    pub fn of(image: &FrameImage, rect: PixelRect) -> Self {
        let width = image.size[0] as usize;
        let columns = rect.min.x as usize..rect.max.x as usize;
        let rows = rect.min.y as usize..rect.max.y as usize;
        let row = |y: usize| &image.pixels[y * width..][..width][columns.clone()];
        Self {
            rect,
            image: FrameImage {
                size: (rect.max - rect.min).into(),
                pixels: rows.flat_map(row).copied().collect(),
            },
        }
    }

    /// The whole image, of a width and height, px.
    ///
    /// # Panics
    /// Where the part does not lie in it.
    pub fn whole(&self, size: [u32; 2]) -> FrameImage {
        let mut image = FrameImage::empty(size);
        let [width, height] = self.image.size.map(|side| side as usize);
        for row in 0..height {
            let to = (self.rect.min.y as usize + row) * size[0] as usize + self.rect.min.x as usize;
            image.pixels[to..][..width].copy_from_slice(&self.image.pixels[row * width..][..width]);
        }
        image
    }

    /// RGB as a display shows it at a place of the whole image, px: a cubic through the pixels
    /// around it (Catmull and Rom's), which blurs far less than a linear one. Beside the part there
    /// is nothing but background.
    pub fn displayed_at(&self, at: [f32; 2]) -> [f64; 3] {
        // Pixel i has its centre at i + 0.5.
        let place = [0, 1].map(|axis| f64::from(at[axis]) - f64::from(self.rect.min[axis]) - 0.5);
        let first = place.map(|at| at.floor() - 1.0);
        let [across, down] = place.map(|at| weights(at - at.floor()));
        let mut color = [0.0; 3];
        for (row, down) in down.iter().enumerate() {
            for (column, across) in across.iter().enumerate() {
                let shown = self.pixel(first[0] + column as f64, first[1] + row as f64);
                for (color, shown) in color.iter_mut().zip(shown) {
                    *color += across * down * shown;
                }
            }
        }
        color.map(|channel| channel.clamp(0.0, 1.0))
    }

    /// RGB as a display shows each pixel, row by row from the top left.
    pub fn displayed(&self) -> Vec<[f64; 3]> {
        self.image.pixels.iter().copied().map(rounded).collect()
    }

    /// RGB as a display shows the part's pixel in a column and row.
    fn pixel(&self, column: f64, row: f64) -> [f64; 3] {
        let [width, height] = self.image.size;
        let inside =
            (0.0..f64::from(width)).contains(&column) && (0.0..f64::from(height)).contains(&row);
        let pixel = if inside {
            self.image.pixels[row as usize * width as usize + column as usize]
        } else {
            [0.0; 4]
        };
        rounded(pixel)
    }
}

/// RGB of a pixel as a display of 8 bits a channel shows it: whatever an image is stored in, it is
/// rounded once before it is seen, and what flickers by less than that is not.
fn rounded(pixel: [f32; 4]) -> [f64; 3] {
    error::displayed(pixel).map(|channel| (255.0 * channel).round() / 255.0)
}

/// Catmull and Rom's weights of the four pixels around a place that is a share of a pixel behind
/// the second of them, 0 to 1.
fn weights(t: f64) -> [f64; TAPS] {
    [
        0.5 * t * (-1.0 + t * (2.0 - t)),
        0.5 * (2.0 + t * t * (-5.0 + 3.0 * t)),
        0.5 * t * (1.0 + t * (4.0 - 3.0 * t)),
        0.5 * t * t * (t - 1.0),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec2;

    /// Opaque, red grows to the right and green downwards.
    fn ramp() -> FrameImage {
        let pixel = |k: usize| {
            let [x, y] = [k % 20, k / 20].map(|at| at as f32);
            [x / 20.0, y / 16.0, 0.25, 1.0]
        };
        FrameImage {
            size: [20, 16],
            pixels: (0..20 * 16).map(pixel).collect(),
        }
    }

    #[test]
    fn a_part_is_sampled_where_it_lies_in_the_image() {
        let rect = PixelRect {
            min: UVec2::new(4, 3),
            max: UVec2::new(15, 12),
        };
        let part = ImagePart::of(&ramp(), rect);
        assert_eq!(part.image.size, [11, 9]);
        for at in [[8.5, 6.5], [9.25, 7.9], [10.0, 8.0]] {
            let got = part.displayed_at(at);
            let expected = [(at[0] - 0.5) / 20.0, (at[1] - 0.5) / 16.0, 0.25].map(f64::from);
            for (got, expected) in got.into_iter().zip(expected) {
                assert!(
                    (got - expected).abs() < 0.004,
                    "{got}, not {expected}, at {at:?}"
                );
            }
        }
        let grey = (255.0 * f64::from(error::BACKGROUND)).round() / 255.0;
        assert_eq!(part.displayed_at([100.0, 2.0]), [grey; 3]);
        assert_eq!(part.displayed_at([-100.0, f32::NAN]).len(), 3);
    }

    #[test]
    fn what_is_cut_out_lies_where_it_was() {
        let mut image = FrameImage::empty([9, 7]);
        image.pixels[3 * 9 + 4] = [0.5, 0.25, 0.125, 0.5];
        let rect = PixelRect {
            min: UVec2::new(3, 1),
            max: UVec2::new(6, 5),
        };
        assert_eq!(ImagePart::of(&image, rect).whole([9, 7]), image);
    }
}
