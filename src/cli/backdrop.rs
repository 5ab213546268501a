//! What is behind an avatar: nothing, a colour, or a picture.

use crate::options;
use anyhow::Context;
use effigy_core::scene::FrameImage;
use image::{
    DynamicImage, ImageDecoder, ImageReader, ImageResult, Rgb, RgbImage, RgbaImage,
    imageops::FilterType,
};
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

/// Reads a PNG or JPEG, upright as its EXIF says, over black where it is transparent.
pub fn picture(path: &Path) -> anyhow::Result<DynamicImage> {
    let open = || -> ImageResult<DynamicImage> {
        let reader = ImageReader::open(path)?.with_guessed_format()?;
        let mut decoder = reader.into_decoder()?;
        let orientation = decoder.orientation()?;
        let mut picture = DynamicImage::from_decoder(decoder)?;
        picture.apply_orientation(orientation);
        Ok(over_black(picture))
    };
    open().with_context(|| {
        format!(
            "the background {} can't be read: give a PNG or JPEG",
            path.display()
        )
    })
}

fn over_black(picture: DynamicImage) -> DynamicImage {
    if !picture.color().has_alpha() {
        return picture;
    }
    let picture = picture.into_rgba8();
    let opaque = |x, y| {
        let [r, g, b, a] = picture.get_pixel(x, y).0.map(u32::from);
        Rgb([r, g, b].map(|c| ((c * a + 127) / 255) as u8))
    };
    RgbImage::from_fn(picture.width(), picture.height(), opaque).into()
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
    use image::{
        ExtendedColorType, ImageEncoder, Luma, LumaA, Rgba,
        codecs::{jpeg::JpegEncoder, png::PngEncoder},
    };

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

    /// EXIF with an orientation alone, in either order of bytes.
    fn exif(orientation: u8, is_little: bool) -> Vec<u8> {
        let o = orientation;
        if is_little {
            let start = b"II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0".to_vec();
            [start, vec![o, 0, 0, 0, 0, 0, 0, 0]].concat()
        } else {
            let start = b"MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01".to_vec();
            [start, vec![0, o, 0, 0, 0, 0, 0, 0]].concat()
        }
    }

    /// A phone's photo: white in one corner of what the sensor saw, and told how to turn it.
    #[test]
    fn photos_stand_upright() {
        let folder = tempfile::tempdir().unwrap();
        let white = |x: u32, y: u32| if x < 16 && y < 16 { 255 } else { 0 };
        let pixels: Vec<u8> = (0..48 * 32).map(|k| white(k % 48, k / 48)).collect();
        // Where the sensor's upper left is, of right and lower, and whether sides change places.
        for (orientation, right, lower, is_turned) in [
            (1, false, false, false),
            (2, true, false, false),
            (3, true, true, false),
            (4, false, true, false),
            (5, false, false, true),
            (6, true, false, true),
            (7, true, true, true),
            (8, false, true, true),
            (0, false, false, false),
        ] {
            for (ending, is_little) in [("jpg", true), ("jpg", false), ("png", true)] {
                let path = folder.path().join(format!("photo.{ending}"));
                let file = std::fs::File::create(&path).unwrap();
                let exif = exif(orientation, is_little);
                if ending == "jpg" {
                    let mut encoder = JpegEncoder::new(file);
                    encoder.set_exif_metadata(exif).unwrap();
                    encoder.write_image(&pixels, 48, 32, ExtendedColorType::L8)
                } else {
                    let mut encoder = PngEncoder::new(file);
                    encoder.set_exif_metadata(exif).unwrap();
                    encoder.write_image(&pixels, 48, 32, ExtendedColorType::L8)
                }
                .unwrap();
                let shown = picture(&path).unwrap().to_luma8();
                let [width, height] = if is_turned { [32, 48] } else { [48, 32] };
                assert_eq!(
                    shown.dimensions(),
                    (width, height),
                    "{orientation} {ending}"
                );
                for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    let at = shown.get_pixel(4 + x * (width - 9), 4 + y * (height - 9)).0[0];
                    let is_white = (x == 1, y == 1) == (right, lower);
                    assert_eq!(at > 128, is_white, "{orientation} {ending} at {x}, {y}");
                }
            }
        }
    }

    /// In every kind of file that has an alpha channel.
    #[test]
    fn what_is_transparent_shows_black() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        let alpha = |x: u32| [255, 128, 0][x as usize];
        let kinds: [DynamicImage; 3] = [
            RgbaImage::from_fn(3, 1, |x, _| Rgba([200, 100, 50, alpha(x)])).into(),
            image::ImageBuffer::from_fn(3, 1, |x, _| {
                Rgba([200, 100, 50, alpha(x)].map(|c| u16::from(c) * 257))
            })
            .into(),
            image::GrayAlphaImage::from_fn(3, 1, |x, _| LumaA([200, alpha(x)])).into(),
        ];
        for kind in kinds {
            kind.save(&path).unwrap();
            let shown = picture(&path).unwrap().to_rgb8();
            let red: Vec<u8> = shown.pixels().map(|pixel| pixel.0[0]).collect();
            assert_eq!(red, [200, 100, 0], "{:?}", kind.color());
            let opaque: DynamicImage = image::GrayImage::from_pixel(3, 1, Luma([9])).into();
            opaque.save(&path).unwrap();
            assert_eq!(picture(&path).unwrap().to_rgb8().get_pixel(2, 0).0, [9; 3]);
        }
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
