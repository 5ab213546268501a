//! Pictures and masks: decoding, taking out the lens's distortion, writing.

use crate::{
    calibration::CaptureCamera,
    decode::{PictureFiles, colors},
    limits::THRESHOLD,
    mask::{MaskFile, MaskRule},
};
use effigy_core::io::file::FormatError;
use image::{
    ExtendedColorType, ImageEncoder,
    codecs::png::{CompressionType, FilterType, PngEncoder},
};
use std::{collections::VecDeque, io};

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
    pub fn read(
        files: &PictureFiles,
        camera: &CaptureCamera,
        rule: MaskRule,
    ) -> Result<Self, FaultyFile> {
        let colors = colors(&files.picture).and_then(|colors| colors.of(camera, [0; 3]));
        let mask = MaskFile::read(files).and_then(|file| file.mask(camera, rule));
        Ok(Self {
            size: camera.camera.size,
            color: colors.map_err(FaultyFile::Picture)?,
            mask: mask.map_err(FaultyFile::Mask)?.person,
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
pub enum FaultyFile {
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
