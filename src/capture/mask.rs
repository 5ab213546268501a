//! Masks: which pixels of a file are the person's, for everything that reads masks.
//!
//! A file may hold how much of each pixel is the person, an alpha channel, 0 and 1, the classes of a
//! segmentation as numbers or colours. An alpha channel that is not the same everywhere is the mask,
//! whatever else the file has. What the numbers mean in all other files of a camera is a [`MaskRule`].

use crate::{
    calibration::CaptureCamera,
    decode::{DecodedImage, PictureFiles, Pixels, decode},
    left_out::OmissionReason,
    limits::THRESHOLD,
};
use effigy_core::io::file::FormatError;
use glam::DVec2;
use image::DynamicImage;
use std::collections::{BTreeSet, HashSet};

/// Fewer joints in view say nothing about a mask.
const FEWEST_JOINTS: usize = 5;
/// A smaller share of the joints inside the mask is a fault.
const LEAST_INSIDE: f64 = 0.3;
/// A mask that covers more of the picture's edge is not of a person.
const MOST_OF_EDGE: f64 = 0.5;
/// Different numbers or colours of a segmentation, at most.
const CLASSES: usize = 64;
/// Channels of a colour differ by more: those of grey do by a JPEG's noise.
const COLORED: u8 = 32;
/// Pixels of which one may be coloured in a mask that is grey.
const GREY: usize = 1000;

/// What the numbers in a camera's masks mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MaskRule {
    /// Whatever is not 0 is the person. Else numbers say how much of a pixel is.
    pub nonzero: bool,
    /// The person is what other captures' masks leave out.
    pub inverted: bool,
}

/// Where a file has its mask.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MaskSource {
    /// In an alpha channel.
    Alpha,
    /// In colours, few and without noise.
    Colors,
    /// In grey. `values`: all there are where they are few and without noise, up to `full`.
    Grey {
        values: Option<BTreeSet<u16>>,
        full: u16,
    },
}

/// A mask's file, decoded.
pub struct MaskFile {
    pub place: MaskSource,
    /// How much is said of each pixel, up to 255; 0 only where the file has 0.
    levels: Pixels<1>,
}

/// A mask as it is used.
pub struct Mask {
    /// Width and height, px.
    pub size: [u32; 2],
    /// 255 where the person is, 0 elsewhere, in rows from the upper left.
    pub person: Vec<u8>,
    /// The most that the file says of any pixel, of 255.
    pub highest: u8,
}

impl MaskFile {
    /// Decodes the mask of a picture, which may be the picture's own alpha channel.
    pub fn read(files: &PictureFiles) -> Result<Self, FormatError> {
        let decoded = decode(&files.mask)?;
        let size = [decoded.image.width(), decoded.image.height()];
        let file = |place, levels: Vec<u8>| Self {
            place,
            levels: Pixels {
                size,
                pixels: levels.into_iter().map(|level| [level]).collect(),
            },
        };
        if decoded.image.color().has_alpha() {
            let alpha: Vec<u8> = decoded.image.to_rgba8().pixels().map(|p| p.0[3]).collect();
            if alpha.iter().any(|&level| level != alpha[0]) {
                return Ok(file(MaskSource::Alpha, alpha));
            }
        }
        if files.mask == files.picture {
            return Err(FormatError::container(
                "an alpha channel that is the same everywhere",
                "the person's, or a mask beside the picture",
            ));
        }
        let (place, levels) = visible(decoded)?;
        Ok(file(place, levels))
    }

    /// How much of each pixel is the person, of 255.
    fn coverage(mut self, rule: MaskRule) -> Pixels<1> {
        let is_numbers = self.place != MaskSource::Alpha && rule.nonzero;
        for [level] in &mut self.levels.pixels {
            if is_numbers && *level > 0 {
                *level = 255;
            }
            if rule.inverted {
                *level = 255 - *level;
            }
        }
        self.levels
    }

    /// The mask of a camera's picture, without the lens's distortion.
    pub fn mask(self, camera: &CaptureCamera, rule: MaskRule) -> Result<Mask, FormatError> {
        let coverage = self.coverage(rule).of(camera, [0])?;
        let is_person = |&[part]: &[u8; 1]| if part > THRESHOLD { 255 } else { 0 };
        Ok(Mask {
            size: camera.camera.size,
            person: coverage.iter().map(is_person).collect(),
            highest: coverage.iter().map(|&[part]| part).max().unwrap_or(0),
        })
    }
}

/// What a file without a telling alpha channel shows, and its levels.
fn visible(decoded: DecodedImage) -> Result<(MaskSource, Vec<u8>), FormatError> {
    let DecodedImage { image, is_lossy } = decoded;
    let colored = match &image {
        DynamicImage::ImageLuma8(_) | DynamicImage::ImageLuma16(_) => None,
        image => Some(image.to_rgb8()),
    };
    if let Some(image) = &colored {
        let spread = |p: &[u8; 3]| p.iter().max().zip(p.iter().min()).map_or(0, |(a, b)| a - b);
        let pixels = image.as_raw().as_chunks::<3>().0;
        let count = pixels.iter().filter(|p| spread(p) > COLORED).count();
        if count > pixels.len() / GREY {
            let mut colors = HashSet::new();
            let many = |p: &[u8; 3]| colors.insert(*p) && colors.len() > CLASSES;
            if is_lossy || pixels.iter().any(many) {
                return Err(FormatError::container(
                    "a picture in colour without an alpha channel",
                    "a mask: white where the person is, black elsewhere",
                ));
            }
            let largest = pixels.iter().map(|p| p[0].max(p[1]).max(p[2]));
            return Ok((MaskSource::Colors, largest.collect()));
        }
    }
    let is_deep = image.color().bytes_per_pixel() / image.color().channel_count() > 1;
    let numbers: Vec<u16> = if is_deep {
        image.into_luma16().into_raw()
    } else {
        image
            .into_luma8()
            .into_raw()
            .into_iter()
            .map(u16::from)
            .collect()
    };
    let full = if is_deep { u16::MAX } else { 255 };
    let levels = numbers.iter().map(|&number| match number {
        0 => 0,
        _ if is_deep => ((u32::from(number) + 128) / 257).max(1) as u8,
        _ => number as u8,
    });
    let levels = levels.collect();
    let mut values = BTreeSet::new();
    let many = |&number: &u16| values.insert(number) && values.len() > CLASSES;
    let is_many = is_lossy || numbers.iter().any(many);
    let values = (!is_many).then_some(values);
    Ok((MaskSource::Grey { values, full }, levels))
}

impl MaskSource {
    /// Whether numbers are there that could mean one thing or another.
    pub fn tells(&self) -> bool {
        match self {
            Self::Alpha => false,
            Self::Colors => true,
            Self::Grey { values, .. } => {
                let values = values.as_ref();
                values.is_none_or(|values| values.iter().any(|value| *value > 0))
            }
        }
    }
}

/// The values of masks in which whatever is not 0 is the person, in words: 0 and 1, or classes.
/// None: numbers say how much of a pixel is the person.
pub fn nonzero<'a>(places: impl Iterator<Item = &'a MaskSource>) -> Option<String> {
    let mut all: BTreeSet<u16> = BTreeSet::new();
    for place in places {
        match place {
            MaskSource::Alpha => {}
            MaskSource::Colors => return Some(format!("at most {CLASSES} colours")),
            MaskSource::Grey { values, full } => {
                let values = values.as_ref()?;
                if values.contains(full) {
                    return None;
                }
                all.extend(values);
            }
        }
    }
    let are_classes = all.len() == 2 || all.last().is_some_and(|&most| usize::from(most) < CLASSES);
    if !all.contains(&0) || all.len() < 2 || !are_classes {
        return None;
    }
    let words: Vec<String> = all.iter().take(8).map(u16::to_string).collect();
    let rest = if all.len() > words.len() {
        " and more"
    } else {
        ""
    };
    Some(format!("the values {}{rest}", words.join(", ")))
}

/// What is wrong with a mask. `places`: of the joints, px.
pub fn fault_of(mask: &Mask, places: &[DVec2]) -> Option<OmissionReason> {
    let [width, height] = mask.size.map(|side| side as usize);
    let at = |x: usize, y: usize| mask.person[y * width + x] > 0;
    if places.is_empty() {
        return Some(OmissionReason::NoBody);
    }
    if mask.person.iter().all(|&part| part == 0) {
        let highest = mask.highest;
        return Some(OmissionReason::EmptyMask { highest });
    }
    if mask.person.iter().all(|&part| part > 0) {
        return Some(OmissionReason::FullMask);
    }
    let inside = places
        .iter()
        .filter(|p| at(p.x as usize, p.y as usize))
        .count();
    let sides = (0..width).flat_map(|x| [at(x, 0), at(x, height - 1)]);
    let edge: Vec<bool> = sides
        .chain((0..height).flat_map(|y| [at(0, y), at(width - 1, y)]))
        .collect();
    let covered = edge.iter().filter(|&&part| part).count() as f64;
    let few = (inside as f64) < LEAST_INSIDE * places.len() as f64;
    if covered > MOST_OF_EDGE * edge.len() as f64 && few {
        return Some(OmissionReason::InvertedMask);
    }
    (few && places.len() >= FEWEST_JOINTS).then_some(OmissionReason::Astray {
        inside,
        of: places.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(values: &[u16], full: u16) -> MaskSource {
        let values = Some(values.iter().copied().collect());
        MaskSource::Grey { values, full }
    }

    #[test]
    fn what_is_not_0_is_the_person_where_numbers_are_classes() {
        let reads = |places: &[MaskSource]| nonzero(places.iter()).is_some();
        let noise = MaskSource::Grey {
            values: None,
            full: 255,
        };
        for places in [
            vec![grey(&[0, 1], 255)],
            vec![grey(&[0, 14], 255)],
            vec![grey(&[0, 128], 255)],
            vec![grey(&[0, 1], u16::MAX)],
            vec![grey(&[0, 255], u16::MAX)],
            // A picture without the person among others.
            vec![grey(&[0], 255), grey(&[0, 2, 5, 13], 255)],
            vec![MaskSource::Alpha, grey(&[0, 1], 255)],
            vec![MaskSource::Colors],
        ] {
            assert!(reads(&places), "{places:?}");
        }
        for places in [
            vec![],
            vec![MaskSource::Alpha],
            vec![grey(&[0], 255)],
            vec![grey(&[1], 255)],
            vec![grey(&[255], 255)],
            vec![grey(&[0, 255], 255)],
            vec![grey(&[0, u16::MAX], u16::MAX)],
            vec![grey(&[0, 127, 255], 255)],
            // Some of each kind: nothing is decided for all.
            vec![grey(&[0, 1], 255), grey(&[0, 255], 255)],
            vec![grey(&[0, 1], 255), noise],
            vec![grey(&[1, 2, 3], 255)],
            vec![grey(&[0, 40, 90, 120], 255)],
        ] {
            assert!(!reads(&places), "{places:?}");
        }
    }
}
