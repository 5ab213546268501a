//! Pictures and masks: decoding, taking out the lens's distortion, writing.

use crate::{
    calibration::CaptureCamera,
    capture::Files,
    error::read_bytes,
    lens, limits,
    mask::{MaskFile, MaskRule, THRESHOLD},
};
use effigy_core::io::file::FormatError;
use image::{
    DynamicImage, ExtendedColorType, ImageEncoder, ImageFormat, ImageReader,
    codecs::png::{CompressionType, FilterType, PngEncoder},
};
use std::{
    collections::VecDeque,
    io::{self, Cursor},
    path::Path,
};

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

/// A decoded PNG or JPEG.
pub struct Decoded {
    pub image: DynamicImage,
    /// Whether its numbers have the noise of a JPEG.
    pub is_lossy: bool,
}

/// Decodes a file.
pub fn decode(path: &Path) -> Result<Decoded, FormatError> {
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
    Ok(Decoded { image, is_lossy })
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

impl Picture {
    /// Whether a pixel is the person's.
    pub fn is_person(&self, pixel: usize) -> bool {
        self.mask[pixel] > THRESHOLD
    }

    /// Which pixels have one of the other kind, person or not, within a distance, px.
    pub fn near_edge(&self, distance: u32) -> Vec<bool> {
        let person: Vec<bool> = (0..self.mask.len()).map(|at| self.is_person(at)).collect();
        let other: Vec<bool> = person.iter().map(|own| !own).collect();
        let near_person = near(self.size, &person, distance);
        let near_other = near(self.size, &other, distance);
        near_person
            .into_iter()
            .zip(near_other)
            .map(|(a, b)| a && b)
            .collect()
    }

    /// What is behind the person at each pixel: the picture itself from a distance of the mask on,
    /// px, and the nearest pixel of that kind elsewhere, in steps along rows and columns. At the
    /// mask's edge pixels show something of the person. None where the mask leaves nothing.
    pub fn behind(&self, distance: u32) -> Option<Vec<[u8; 3]>> {
        let [width, height] = self.size.map(|side| side as usize);
        let person: Vec<bool> = (0..self.mask.len()).map(|at| self.is_person(at)).collect();
        let mut known: Vec<bool> = near(self.size, &person, distance.saturating_sub(1))
            .into_iter()
            .map(|near| !near)
            .collect();
        let mut color = self.color.clone();
        let mut next: VecDeque<usize> = (0..known.len()).filter(|&at| known[at]).collect();
        if next.is_empty() {
            return None;
        }
        while let Some(at) = next.pop_front() {
            let [x, y] = [at % width, at / width];
            let around = [
                (y > 0).then(|| at - width),
                (x > 0).then(|| at - 1),
                (x + 1 < width).then(|| at + 1),
                (y + 1 < height).then(|| at + width),
            ];
            for other in around.into_iter().flatten() {
                if !known[other] {
                    known[other] = true;
                    color[other] = color[at];
                    next.push_back(other);
                }
            }
        }
        Some(color)
    }

    /// Decodes a picture and its mask, and takes out the lens's distortion.
    pub fn read(files: &Files, camera: &CaptureCamera, rule: MaskRule) -> Result<Self, Fault> {
        let colors = colors(&files.picture).and_then(|colors| colors.of(camera, [0; 3]));
        let mask = MaskFile::read(files).and_then(|file| file.mask(camera, rule));
        Ok(Self {
            size: camera.camera.size,
            color: colors.map_err(Fault::Picture)?,
            mask: mask.map_err(Fault::Mask)?.person,
        })
    }
}

/// Which pixels have one that is set in the square of so many pixels to each side.
fn near(size: [u32; 2], set: &[bool], distance: u32) -> Vec<bool> {
    let [width, height] = size.map(|side| side as usize);
    let distance = distance as usize;
    let around = |place: usize, count: usize| {
        place.saturating_sub(distance)..(place + distance + 1).min(count)
    };
    let mut rows = vec![false; set.len()];
    for at in (0..set.len()).filter(|&at| set[at]) {
        let first = at - at % width;
        let columns = around(at % width, width);
        rows[first + columns.start..first + columns.end].fill(true);
    }
    let mut all = vec![false; set.len()];
    for at in (0..set.len()).filter(|&at| rows[at]) {
        for row in around(at / width, height) {
            all[row * width + at % width] = true;
        }
    }
    all
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn behind_the_person_is_the_nearest_of_the_background() {
        let shade = |at: usize| if at == 5 { 255 } else { 10 * at as u8 };
        let row = Picture {
            size: [11, 1],
            color: (0..11).map(|at| [shade(at); 3]).collect(),
            mask: (0..11).map(|at| if at == 5 { 255 } else { 0 }).collect(),
        };
        let shades = |distance: u32| -> Vec<u8> {
            let behind = row.behind(distance).unwrap();
            behind.iter().map(|pixel| pixel[0]).collect()
        };
        assert_eq!(shades(1), [0, 10, 20, 30, 40, 40, 60, 70, 80, 90, 100]);
        assert_eq!(shades(3), [0, 10, 20, 20, 20, 20, 80, 80, 80, 90, 100]);
        assert_eq!(row.behind(6), None);
        assert_eq!(row.near_edge(0), [false; 11]);
        let near: Vec<usize> = (0..11).filter(|&at| row.near_edge(1)[at]).collect();
        assert_eq!(near, [4, 5, 6]);
    }
}
