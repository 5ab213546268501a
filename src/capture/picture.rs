//! Pictures and masks: decoding, taking out the lens's distortion, writing.

use crate::{calibration::CaptureCamera, error::read_bytes, lens, limits};
use effigy_core::io::file::FormatError;
use image::{
    DynamicImage, ExtendedColorType, ImageEncoder, ImageReader,
    codecs::png::{CompressionType, FilterType, PngEncoder},
};
use std::{
    io::{self, Cursor},
    path::Path,
};

/// Above this a mask's pixel is the person.
pub const MASK_THRESHOLD: u8 = 128;

/// A picture and its mask, in rows from the upper left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width and height, px.
    pub size: [u32; 2],
    /// 8-bit sRGB, background included.
    pub color: Vec<[u8; 3]>,
    /// 255 where the person is, 0 elsewhere. To a [`crate::CaptureWriter`]: how much of a pixel is
    /// the person.
    pub mask: Vec<u8>,
}

/// An image of numbers from 0 to 255, C a pixel.
pub struct Pixels<const C: usize> {
    pub size: [u32; 2],
    pub pixels: Vec<[u8; C]>,
}

fn decode(path: &Path) -> Result<DynamicImage, FormatError> {
    let fault = |found: String| FormatError::container(found, "a whole PNG or JPEG");
    let bytes = read_bytes(path, limits::IMAGE).map_err(|error| fault(error.to_string()))?;
    if is_cut(&bytes) {
        return Err(fault("a JPEG without its end".into()));
    }
    let mut reader = ImageReader::new(Cursor::new(&bytes))
        .with_guessed_format()
        .map_err(|error| fault(error.to_string()))?;
    let mut most = image::Limits::default();
    most.max_image_width = Some(limits::SIDE);
    most.max_image_height = Some(limits::SIDE);
    most.max_alloc = Some(16 * limits::PIXELS);
    reader.limits(most);
    reader.decode().map_err(|error| fault(error.to_string()))
}

/// Whether a JPEG ends before it says so; its decoder would fill in grey.
fn is_cut(bytes: &[u8]) -> bool {
    let last = |marker: u8| bytes.windows(2).rposition(|pair| pair == [0xFF, marker]);
    // Neither mark is found in compressed numbers.
    let [begins, ends] = [last(0xDA), last(0xD9)];
    bytes.starts_with(&[0xFF, 0xD8]) && (begins.is_none() || ends < begins)
}

/// Decodes a picture's colours. Alpha is ignored.
pub fn colors(path: &Path) -> Result<Pixels<3>, FormatError> {
    let image = decode(path)?.into_rgb8();
    Ok(Pixels {
        size: image.dimensions().into(),
        pixels: image.into_raw().as_chunks().0.to_vec(),
    })
}

/// Decodes a mask as its file has it.
pub fn coverage(path: &Path) -> Result<Pixels<1>, FormatError> {
    let image = decode(path)?.into_luma8();
    Ok(Pixels {
        size: image.dimensions().into(),
        pixels: image.into_raw().as_chunks().0.to_vec(),
    })
}

impl<const C: usize> Pixels<C> {
    /// The pixels without the lens's distortion; `outside` where the picture has none.
    fn undistorted(self, camera: &CaptureCamera, outside: [u8; C]) -> Vec<[u8; C]> {
        let mix = |place: Option<lens::Bilinear>| match place {
            None => outside,
            Some(place) => std::array::from_fn(|channel| {
                let of =
                    |k: usize| place.shares[k] * f64::from(self.pixels[place.pixels[k]][channel]);
                (0..4).map(of).sum::<f64>().round() as u8
            }),
        };
        lens::undistortion(&camera.camera, &camera.distortion)
            .map(mix)
            .collect()
    }
}

impl Picture {
    /// Decodes a picture and its mask, and takes out the lens's distortion.
    pub fn read(picture: &Path, mask: &Path, camera: &CaptureCamera) -> Result<Self, Fault> {
        let size = camera.camera.size;
        let colors = colors(picture).map_err(Fault::Picture)?;
        let coverage = coverage(mask).map_err(Fault::Mask)?;
        let fits = |found: [u32; 2]| {
            let size_fault = || {
                let [w, h] = size;
                let found = format!("{} x {} px", found[0], found[1]);
                FormatError::container(found, format!("{w} x {h}"))
            };
            if found == size {
                Ok(())
            } else {
                Err(size_fault())
            }
        };
        fits(colors.size).map_err(Fault::Picture)?;
        fits(coverage.size).map_err(Fault::Mask)?;
        let (color, coverage) = if lens::distorts(&camera.distortion) {
            (
                colors.undistorted(camera, [0; 3]),
                coverage.undistorted(camera, [0]),
            )
        } else {
            (colors.pixels, coverage.pixels)
        };
        let is_person = |&[part]: &[u8; 1]| if part > MASK_THRESHOLD { 255 } else { 0 };
        Ok(Self {
            size,
            color,
            mask: coverage.iter().map(is_person).collect(),
        })
    }
}

/// Which of a picture's two files is at fault.
#[derive(Debug)]
pub enum Fault {
    Picture(FormatError),
    Mask(FormatError),
}

/// A PNG. `bytes`: 1 or 3 a pixel.
pub fn png(size: [u32; 2], bytes: &[u8], color: ExtendedColorType) -> io::Result<Vec<u8>> {
    let mut file = Vec::new();
    let encoder =
        PngEncoder::new_with_quality(&mut file, CompressionType::Fast, FilterType::Adaptive);
    encoder
        .write_image(bytes, size[0], size[1], color)
        .map_err(io::Error::other)?;
    Ok(file)
}
