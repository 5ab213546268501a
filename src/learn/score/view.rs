//! Compares one view of a capture with an avatar, or with a picture of another program.

use super::{
    ground::Ground,
    metrics::{FEWEST_PIXELS, Metrics, PicturePair},
    rasterise::nearest_vertices,
    regions::{Region, regions_of},
    views::PictureIndex,
};
use effigy_capture::{Capture, CaptureError, Picture};
use effigy_core::{
    avatar::{Avatar, Pose},
    io::file::{FileError, FormatError},
    reference,
    scene::{FrameImage, PixelRect, Posed},
};
use effigy_perceptual::{Perceptual, Planes};
use glam::UVec2;
use std::{collections::BTreeMap, io, path::Path, path::PathBuf};

/// Around the mask's box in images that are written, px.
const MARGIN: u32 = 8;
/// A region's box for perceptual distances is at least so large, px.
const REGION_BOX: u32 = 32;
/// Pictures of other programs may have sides of so many pixels.
const MAX_SIDE: u32 = 16384;

/// What is compared with a capture.
#[derive(Clone, Copy, Debug)]
pub enum ScoredImages<'a> {
    /// An avatar with the capture's skeleton, drawn by the f64 reference.
    Avatar(&'a Avatar),
    /// A folder of PNGs: `CAMERA/00000000.png`, of the size of the capture's, drawn by its cameras
    /// without distortion.
    Pictures(&'a Path),
}

/// Why a view can't be compared.
#[derive(Debug, thiserror::Error)]
pub enum ScoreError {
    /// The capture's picture can't be read.
    #[error(transparent)]
    Capture(#[from] CaptureError),
    /// The other program's picture can't be read.
    #[error(transparent)]
    File(#[from] FileError),
}

/// Compares views of a capture.
pub struct Scorer<'a> {
    /// The truth.
    pub capture: &'a Capture,
    /// What is compared with it.
    pub candidate: ScoredImages<'a>,
    /// What lies behind the person.
    pub ground: Ground,
    /// Gives ST-LPIPS or LPIPS.
    pub perceptual: Option<&'a Perceptual>,
    /// Region of each of the body model's vertices.
    regions: Vec<Region>,
    /// Where the capture's poses come from.
    pub(super) poses: String,
}

/// What came out for a view.
#[derive(Clone, Debug)]
pub struct ScoredView {
    /// Over the mask's box.
    pub whole: Metrics,
    /// Over the pixels of each region that is in view, inside the mask.
    pub regions: BTreeMap<Region, Metrics>,
    /// The part of the picture that the next two are of: the mask's box and some pixels around it.
    pub rect: PixelRect,
    /// The truth and the candidate over the ground.
    pub truth: Planes,
    /// As `truth`.
    pub image: Planes,
}

/// Poses that are the capture's.
pub const AS_GIVEN: &str = "as given";

impl<'a> Scorer<'a> {
    /// Prepares comparisons.
    pub fn new(
        capture: &'a Capture,
        candidate: ScoredImages<'a>,
        ground: Ground,
        perceptual: Option<&'a Perceptual>,
    ) -> Self {
        Self {
            poses: AS_GIVEN.into(),
            capture,
            candidate,
            ground,
            perceptual,
            regions: regions_of(&capture.template),
        }
    }

    /// With a word on where the capture's poses come from.
    pub fn with_poses(self, poses: String) -> Self {
        Self { poses, ..self }
    }

    /// The part of a view's picture that is compared, and some pixels around it. None: its mask is
    /// empty.
    ///
    /// # Errors
    /// When the truth can't be read.
    pub fn rect(&self, view: PictureIndex) -> Result<Option<PixelRect>, ScoreError> {
        let picture = self.capture.picture(view.camera, view.frame)?;
        Ok(mask_box(&picture).map(|own| grown(own, MARGIN, picture.size)))
    }

    /// Compares a view. None: its mask is empty.
    ///
    /// # Errors
    /// When one of the two pictures can't be read or has another size.
    pub fn compare(&self, view: PictureIndex) -> Result<Option<ScoredView>, ScoreError> {
        let picture = self.capture.picture(view.camera, view.frame)?;
        let Some(mask_box) = mask_box(&picture) else {
            return Ok(None);
        };
        let around = grown(mask_box, MARGIN, picture.size);
        let image = self.image(view, around)?;
        let truth = self.ground.truth(&picture, around);
        let image = self.ground.under(&image, &picture, around);
        let within = PixelRect {
            min: mask_box.min - around.min,
            max: mask_box.max - around.min,
        };
        let own = [crop(&image, within), crop(&truth, within)];
        let pair = PicturePair::new(&own[0], &own[1]);
        let Some(mut whole) = pair.over(0..own[0].size[0] * own[0].size[1]) else {
            return Ok(None);
        };
        if let Some(perceptual) = self.perceptual {
            whole.see(perceptual, &own[0], &own[1]);
        }
        let regions = self.regions(view, &picture, mask_box, &pair, &[&image, &truth], around);
        Ok(Some(ScoredView {
            whole,
            regions,
            rect: around,
            truth,
            image,
        }))
    }

    /// The candidate's picture of a view: a part of it.
    fn image(&self, view: PictureIndex, rect: PixelRect) -> Result<FrameImage, ScoreError> {
        let camera = &self.capture.cameras[view.camera];
        let frame = &self.capture.frames[view.frame];
        match self.candidate {
            ScoredImages::Avatar(avatar) => {
                let posed = Posed::new(avatar, &fitted(&frame.pose, avatar));
                Ok(reference::render(
                    avatar,
                    &posed,
                    &camera.camera.cropped(rect),
                ))
            }
            ScoredImages::Pictures(folder) => {
                let file = folder
                    .join(&camera.name)
                    .join(format!("{:08}.png", frame.number));
                let opaque_fits = matches!(self.ground, Ground::Color(_));
                Ok(read_picture(file, camera.camera.size, rect, opaque_fits)?)
            }
        }
    }

    /// Numbers of each region. `mask_box`: in the picture; `pair`: of that box; `pictures`: of the
    /// box `around`.
    fn regions(
        &self,
        view: PictureIndex,
        picture: &Picture,
        mask_box: PixelRect,
        pair: &PicturePair,
        pictures: &[&Planes; 2],
        around: PixelRect,
    ) -> BTreeMap<Region, Metrics> {
        let template = &self.capture.template;
        let camera = self.capture.cameras[view.camera].camera.cropped(mask_box);
        let posed = template.posed(&self.capture.frames[view.frame].pose);
        let nearest = nearest_vertices(&posed, &template.triangles, &camera);
        let width = camera.size[0];
        let mut pixels: BTreeMap<Region, Vec<usize>> = BTreeMap::new();
        for (at, vertex) in nearest.iter().enumerate() {
            let place = mask_box.min + UVec2::new(at as u32 % width, at as u32 / width);
            if picture.mask[(place.y * picture.size[0] + place.x) as usize] > 0 {
                let region = vertex.map_or(Region::Rest, |vertex| self.regions[vertex as usize]);
                pixels.entry(region).or_default().push(at);
            }
        }
        pixels.retain(|_, own| own.len() >= FEWEST_PIXELS);
        let mut found = BTreeMap::new();
        for (region, own) in pixels {
            let Some(mut metrics) = pair.over(own.iter().copied()) else {
                continue;
            };
            let places = own.iter().map(|&at| {
                mask_box.min + UVec2::new(at as u32 % width, at as u32 / width) - around.min
            });
            let mut rect = PixelRect::EMPTY;
            for place in places {
                rect.min = rect.min.min(place);
                rect.max = rect.max.max(place + 1);
            }
            let size = (around.max - around.min).to_array();
            let rect = at_least(rect, REGION_BOX, size);
            if let Some(perceptual) = self.perceptual {
                let [image, truth] = pictures.map(|planes| crop(planes, rect));
                metrics.see(perceptual, &image, &truth);
            }
            found.insert(region, metrics);
        }
        found
    }
}

/// A pose with an expression as long as the avatar's: cut, or with zeros behind.
fn fitted(pose: &Pose, avatar: &Avatar) -> Pose {
    let mut pose = pose.clone();
    pose.expression.resize(avatar.inputs.expression, 0.0);
    pose
}

/// The smallest box around a mask. None: it is empty.
fn mask_box(picture: &Picture) -> Option<PixelRect> {
    let mut rect = PixelRect::EMPTY;
    for (at, _) in picture
        .mask
        .iter()
        .enumerate()
        .filter(|(_, part)| **part > 0)
    {
        let place = UVec2::new(at as u32 % picture.size[0], at as u32 / picture.size[0]);
        rect.min = rect.min.min(place);
        rect.max = rect.max.max(place + 1);
    }
    rect.min.cmplt(rect.max).all().then_some(rect)
}

/// A rectangle with some pixels more to each side, inside a picture of a size.
fn grown(rect: PixelRect, by: u32, size: [u32; 2]) -> PixelRect {
    PixelRect {
        min: rect.min.saturating_sub(UVec2::splat(by)),
        max: (rect.max + by).min(size.into()),
    }
}

/// A rectangle of at least a side, as far as a picture of a size has room.
fn at_least(rect: PixelRect, side: u32, size: [u32; 2]) -> PixelRect {
    let size = UVec2::from(size);
    let lacks = UVec2::splat(side).saturating_sub(rect.max - rect.min);
    let min = rect.min.saturating_sub(lacks / 2);
    let max = (min + (rect.max - rect.min) + lacks).min(size);
    let min = min.min(max.saturating_sub(UVec2::splat(side)));
    PixelRect { min, max }
}

/// A part of a picture.
fn crop(planes: &Planes, rect: PixelRect) -> Planes {
    let [x, y] = rect.min.to_array().map(|place| place as usize);
    let [width, height] = (rect.max - rect.min).to_array().map(|side| side as usize);
    let plane = planes.size[0] * planes.size[1];
    let rows = (0..3).flat_map(|channel| {
        (y..y + height).flat_map(move |row| {
            let start = channel * plane + row * planes.size[0] + x;
            &planes.data[start..start + width]
        })
    });
    Planes {
        size: [width, height],
        data: rows.copied().collect(),
    }
}

/// Reads a part of a PNG of a known size, with premultiplied alpha. `opaque_fits`: it may lack
/// alpha.
fn read_picture(
    file: PathBuf,
    size: [u32; 2],
    rect: PixelRect,
    opaque_fits: bool,
) -> Result<FrameImage, FileError> {
    let unreadable = |cause: io::Error| FileError::Read {
        file: file.clone(),
        cause,
    };
    let content = |found: String, expected: String| FileError::Content {
        file: file.clone(),
        fault: FormatError::Container { found, expected },
    };
    let mut reader = image::ImageReader::open(&file)
        .and_then(image::ImageReader::with_guessed_format)
        .map_err(unreadable)?;
    let mut limits = image::Limits::default();
    limits.max_image_width = Some(MAX_SIDE);
    limits.max_image_height = Some(MAX_SIDE);
    reader.limits(limits);
    let decoded = reader
        .decode()
        .map_err(|error| content(error.to_string(), "a whole PNG".into()))?;
    let found = [decoded.width(), decoded.height()];
    if found != size {
        return Err(content(
            format!("{} x {} px", found[0], found[1]),
            format!("the capture's {} x {}", size[0], size[1]),
        ));
    }
    if !decoded.color().has_alpha() && !opaque_fits {
        return Err(content(
            "a picture without alpha".into(),
            "alpha, or the colour that the pictures were drawn over".into(),
        ));
    }
    let pixels = decoded.into_rgba8();
    let mut image = FrameImage::empty((rect.max - rect.min).into());
    let places =
        (rect.min.y..rect.max.y).flat_map(|y| (rect.min.x..rect.max.x).map(move |x| [x, y]));
    for (pixel, [x, y]) in image.pixels.iter_mut().zip(places) {
        let [r, g, b, alpha] = pixels.get_pixel(x, y).0.map(|c| f32::from(c) / 255.0);
        *pixel = [r * alpha, g * alpha, b * alpha, alpha];
    }
    Ok(image)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rect(min: [u32; 2], max: [u32; 2]) -> PixelRect {
        PixelRect {
            min: min.into(),
            max: max.into(),
        }
    }

    #[test]
    fn boxes_grow_inside_the_picture() {
        assert_eq!(
            grown(rect([2, 9], [5, 12]), 4, [20, 14]),
            rect([0, 5], [9, 14])
        );
        assert_eq!(
            at_least(rect([1, 30], [5, 39]), 20, [60, 40]),
            rect([0, 20], [20, 40])
        );
        assert_eq!(
            at_least(rect([0, 0], [30, 2]), 20, [60, 10]),
            rect([0, 0], [30, 10])
        );
    }

    #[test]
    fn a_part_of_a_picture_has_its_rows() {
        let planes = Planes {
            size: [3, 2],
            data: (0..18).map(|n| n as f32).collect(),
        };
        let part = crop(&planes, rect([1, 0], [3, 2]));
        assert_eq!(part.size, [2, 2]);
        assert_eq!(
            part.data,
            [1., 2., 4., 5., 7., 8., 10., 11., 13., 14., 16., 17.]
        );
    }
}
