//! Decoding of pictures' and masks' files, and taking out the lens's distortion.

use crate::{calibration::CaptureCamera, error::read_bytes, lens, limits};
use effigy_core::io::file::FormatError;
use image::{DynamicImage, ImageFormat, ImageReader};
use std::{
    io::Cursor,
    path::{Path, PathBuf},
};

/// A picture's and its mask's file, which is the picture's own where its alpha channel is the mask.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PictureFiles {
    pub picture: PathBuf,
    pub mask: PathBuf,
}

/// An image of numbers from 0 to 255, C a pixel.
pub struct Pixels<const C: usize> {
    pub size: [u32; 2],
    pub pixels: Vec<[u8; C]>,
}

/// A decoded PNG or JPEG.
pub struct DecodedImage {
    pub image: DynamicImage,
    /// Whether its numbers have the noise of a JPEG.
    pub is_lossy: bool,
}

/// Decodes a file.
pub fn decode(path: &Path) -> Result<DecodedImage, FormatError> {
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
    let is_lossy = reader.format() == Some(ImageFormat::Jpeg);
    let image = reader.decode().map_err(|error| fault(error.to_string()))?;
    Ok(DecodedImage { image, is_lossy })
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
    let image = decode(path)?.image.into_rgb8();
    Ok(Pixels {
        size: image.dimensions().into(),
        pixels: image.into_raw().as_chunks().0.to_vec(),
    })
}

impl<const C: usize> Pixels<C> {
    /// The pixels of a camera's picture without the lens's distortion; `outside` where the picture
    /// has none.
    ///
    /// # Errors
    /// When they are of another size.
    pub fn of(self, camera: &CaptureCamera, outside: [u8; C]) -> Result<Vec<[u8; C]>, FormatError> {
        let [w, h] = camera.camera.size;
        if self.size != [w, h] {
            let found = format!("{} x {} px", self.size[0], self.size[1]);
            return Err(FormatError::container(found, format!("{w} x {h}")));
        }
        if !lens::distorts(&camera.distortion) {
            return Ok(self.pixels);
        }
        let mix = |place: Option<lens::Bilinear>| match place {
            None => outside,
            Some(place) => std::array::from_fn(|channel| {
                let of =
                    |k: usize| place.shares[k] * f64::from(self.pixels[place.pixels[k]][channel]);
                (0..4).map(of).sum::<f64>().round() as u8
            }),
        };
        Ok(lens::undistortion(&camera.camera, &camera.distortion)
            .map(mix)
            .collect())
    }
}
