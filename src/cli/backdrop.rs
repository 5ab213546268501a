//! What is behind an avatar: nothing, a colour, or a picture.

use crate::options;
use anyhow::Context;
use effigy_core::scene::FrameImage;
use image::{DynamicImage, ImageReader, Rgb, RgbaImage, imageops::FilterType};
use std::path::{Path, PathBuf};

/// What a user asks for.
#[derive(Clone, Debug)]
pub enum BackdropArg {
    Transparent,
    /// Display-referred RGB, 0 to 1.
    Color([f32; 3]),
    /// A picture's file.
    Picture(PathBuf),
}

impl BackdropArg {
    /// The picture's file, if it is one.
    pub fn picture(&self) -> Option<&Path> {
        match self {
            Self::Picture(path) => Some(path),
            Self::Transparent | Self::Color(_) => None,
        }
    }
}

/// Reads `none`, RRGGBB or a picture's path.
pub fn argument(text: &str) -> Result<BackdropArg, String> {
    if text == "none" {
        return Ok(BackdropArg::Transparent);
    }
    let path = Path::new(text);
    match options::color(text) {
        Ok(color) => Ok(BackdropArg::Color(color)),
        Err(_) if path.is_file() || path.extension().is_some() => {
            Ok(BackdropArg::Picture(path.into()))
        }
        Err(error) => Err(format!("{error}, `none`, or a picture: FILE.png, FILE.jpg")),
    }
}

/// What is drawn behind images.
pub enum Backdrop {
    Transparent,
    /// Display-referred RGB, 0 to 1.
    Color([f32; 3]),
    /// Covers images of the last size.
    Picture {
        picture: DynamicImage,
        last: FrameImage,
    },
}

impl Backdrop {
    /// Reads the picture, if it is one.
    pub fn open(argument: &BackdropArg) -> anyhow::Result<Self> {
        Ok(match argument {
            BackdropArg::Transparent => Self::Transparent,
            BackdropArg::Color(color) => Self::Color(*color),
            BackdropArg::Picture(path) => Self::Picture {
                picture: picture(path)?,
                last: FrameImage::empty([0, 0]),
            },
        })
    }

    /// An image with this behind it.
    pub fn behind(&mut self, image: &FrameImage) -> RgbaImage {
        match self {
            Self::Transparent => image.transparent(),
            Self::Color(color) => image.over(*color),
            Self::Picture { picture, last } => {
                if last.size != image.size {
                    *last = covering(picture, image.size);
                }
                image.blended_over(last).over([0.0; 3])
            }
        }
    }
}

/// Reads a PNG or JPEG.
pub fn picture(path: &Path) -> anyhow::Result<DynamicImage> {
    let open = || ImageReader::open(path)?.with_guessed_format()?.decode();
    open().with_context(|| {
        format!(
            "the background {} can't be read: give a PNG or JPEG",
            path.display()
        )
    })
}

/// A picture as large as it must be to cover an image of a size, px, cut evenly at both sides.
fn covering(picture: &DynamicImage, [width, height]: [u32; 2]) -> FrameImage {
    let fitted = picture.resize_to_fill(width, height, FilterType::CatmullRom);
    let opaque = |pixel: &Rgb<f32>| {
        let [r, g, b] = pixel.0;
        [r, g, b, 1.0]
    };
    FrameImage {
        size: [width, height],
        pixels: fitted.to_rgb32f().pixels().map(opaque).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::RgbImage;

    #[test]
    fn colours_are_told_from_pictures() {
        assert!(matches!(argument("none"), Ok(BackdropArg::Transparent)));
        assert!(matches!(argument("00ff80"), Ok(BackdropArg::Color(_))));
        assert!(matches!(argument("beach.jpg"), Ok(BackdropArg::Picture(_))));
        assert!(argument("blue").is_err_and(|error| error.contains("FILE.png")));
    }

    /// Thirds of red, green and blue, twice as wide as high: a square image shows the middle half.
    #[test]
    fn a_picture_covers_the_image_and_is_cut_evenly() {
        let thirds = RgbImage::from_fn(120, 60, |x, _| {
            let mut color = [0; 3];
            color[(x / 40) as usize] = 255;
            Rgb(color)
        });
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("thirds.png");
        thirds.save(&path).unwrap();
        let mut backdrop = Backdrop::open(&BackdropArg::Picture(path)).unwrap();
        let mut image = FrameImage::empty([30, 30]);
        image.pixels[15 * 30 + 15] = [0.5, 0.5, 0.5, 0.5];
        let shown = backdrop.behind(&image);
        // 15 of 60 columns of the middle half are red on either side, less than half a pixel off.
        for (x, expected) in [
            (1, [255, 0, 0]),
            (7, [0, 255, 0]),
            (22, [0, 255, 0]),
            (28, [0, 0, 255]),
        ] {
            let [r, g, b, a] = shown.get_pixel(x, 5).0;
            let off = [r, g, b]
                .into_iter()
                .zip(expected)
                .map(|(a, b)| a.abs_diff(b))
                .max();
            assert!(off < Some(12) && a == 255, "{x}: {r} {g} {b} {a}");
        }
        assert_eq!(shown.get_pixel(15, 15).0, [128, 255, 128, 255]);
    }

    #[test]
    fn a_picture_that_is_none_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("text.png");
        std::fs::write(&path, "no picture").unwrap();
        for path in [path, folder.path().join("missing.jpg")] {
            let error = Backdrop::open(&BackdropArg::Picture(path)).err().unwrap();
            assert!(error.to_string().contains("can't be read"), "{error:#}");
        }
    }
}
