//! What lies behind the person in the pictures that are compared.

use effigy_capture::Picture;
use effigy_core::scene::{FrameImage, PixelRect};
use effigy_perceptual::Planes;

/// Pixels so near to the mask may show something of the person.
const EDGE: u32 = 3;

/// What both pictures are composited over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ground {
    /// The truth's picture as it is; under the avatar what the truth shows outside its mask and not
    /// at its edge, and the nearest of that elsewhere.
    Truth,
    /// One colour of 0 to 1 under both; the truth is cut out by its mask.
    Color([f32; 3]),
}

impl Ground {
    /// The ground in words, for reports.
    pub fn describe(self) -> String {
        match self {
            Self::Truth => {
                format!(
                    "the truth's own, from {EDGE} px outside its mask on, the nearest of it inside"
                )
            }
            Self::Color(color) => {
                let [r, g, b] = color.map(|c| (255.0 * c).round());
                format!("the colour {r},{g},{b} under both, the truth cut out by its mask")
            }
        }
    }

    /// A part of the truth's picture. `rect`: inside the picture.
    pub fn truth(self, picture: &Picture, rect: PixelRect) -> Planes {
        planes(picture.size, rect, |at| match self {
            Self::Color(color) if picture.mask[at] == 0 => color,
            _ => color_of(picture, at),
        })
    }

    /// An image of that part, over what lies behind the person.
    pub fn under(self, image: &FrameImage, picture: &Picture, rect: PixelRect) -> Planes {
        let behind = match self {
            Self::Truth => background(picture),
            Self::Color(color) => vec![color; picture.mask.len()],
        };
        let mut pixels = image.pixels.iter();
        planes(picture.size, rect, |at| {
            let [r, g, b, alpha] = pixels.next().copied().unwrap_or_default();
            let own = [r, g, b];
            std::array::from_fn(|c| {
                let color = own[c] + (1.0 - alpha) * behind[at][c];
                if color.is_nan() {
                    // As wrong as a channel can be, whatever the truth has.
                    (color_of(picture, at)[c] < 0.5).into()
                } else {
                    color.clamp(0.0, 1.0)
                }
            })
        })
    }
}

fn color_of(picture: &Picture, at: usize) -> [f32; 3] {
    picture.color[at].map(|c| f32::from(c) / 255.0)
}

/// What lies behind the person at each pixel; mid grey where the mask leaves nothing. The avatar over
/// pixels that show something of the person would be there twice.
fn background(picture: &Picture) -> Vec<[f32; 3]> {
    match picture.behind(EDGE + 1) {
        Some(behind) => behind
            .into_iter()
            .map(|color| color.map(|c| f32::from(c) / 255.0))
            .collect(),
        None => vec![[0.5; 3]; picture.mask.len()],
    }
}

/// The pixels of a part of a picture of the size `size`, row by row. `color`: of a pixel's index.
fn planes(size: [u32; 2], rect: PixelRect, mut color: impl FnMut(usize) -> [f32; 3]) -> Planes {
    let [width, height] = (rect.max - rect.min).to_array().map(|side| side as usize);
    let mut planes = Planes::black([width, height]);
    let plane = width * height;
    let mut at = 0;
    for y in rect.min.y..rect.max.y {
        for x in rect.min.x..rect.max.x {
            let color = color(y as usize * size[0] as usize + x as usize);
            for (channel, number) in color.into_iter().enumerate() {
                planes.data[channel * plane + at] = number;
            }
            at += 1;
        }
    }
    planes
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec2;

    fn picture() -> Picture {
        Picture {
            size: [3, 1],
            color: vec![[255, 0, 0], [0, 255, 0], [51, 0, 0]],
            mask: vec![0, 255, 0],
        }
    }

    /// A row whose pixels get lighter, with the person in the middle.
    fn row() -> Picture {
        let shade = |at: usize| if at == 5 { 255 } else { 10 * at as u8 };
        Picture {
            size: [11, 1],
            color: (0..11).map(|at| [shade(at); 3]).collect(),
            mask: (0..11).map(|at| if at == 5 { 255 } else { 0 }).collect(),
        }
    }

    #[test]
    fn a_hole_shows_the_nearest_background_and_not_the_truth() {
        let rect = PixelRect::whole([11, 1]);
        let nothing = FrameImage::empty([11, 1]);
        let under = Ground::Truth.under(&nothing, &row(), rect);
        let shades: Vec<f32> = under.data[..11]
            .iter()
            .map(|c| (255.0 * c).round())
            .collect();
        assert_eq!(
            shades,
            [0., 10., 10., 10., 10., 10., 90., 90., 90., 90., 100.]
        );
        let truth = Ground::Truth.truth(&row(), rect);
        assert_eq!(
            (truth.data[5], (255.0 * truth.data[6]).round()),
            (1.0, 60.0)
        );
        // Nothing is known behind a person who fills the picture.
        let full = Ground::Truth.under(
            &FrameImage::empty([3, 1]),
            &picture(),
            PixelRect::whole([3, 1]),
        );
        assert_eq!(full.data, [0.5; 9]);
    }

    #[test]
    fn a_colour_lies_under_both() {
        let rect = PixelRect {
            min: UVec2::new(1, 0),
            max: UVec2::new(3, 1),
        };
        let grey = Ground::Color([0.5; 3]);
        assert_eq!(
            grey.truth(&picture(), rect).data,
            [0.0, 0.5, 1.0, 0.5, 0.0, 0.5]
        );
        let mut image = FrameImage::empty([2, 1]);
        image.pixels[0] = [0.25, 0.0, f32::NAN, 0.5];
        let under = grey.under(&image, &picture(), rect);
        assert_eq!(under.data, [0.5, 0.5, 0.25, 0.5, 1.0, 0.5]);
    }
}
