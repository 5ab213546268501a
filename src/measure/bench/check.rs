//! Compares a device's images with the f64 reference. In: scenes, and which of them to compare.
//! Out: the worst error and how many pixels the avatar covers.

use super::{
    backend::Result,
    case::BenchCase,
    run::{CaseRenderer, Progress},
    scene::BenchScene,
};
use crate::{error, flip, report::ErrorReport};
use effigy_core::{
    avatar::Avatar,
    constants::ALPHA_MIN,
    frame::RendererOptions,
    reference,
    scene::{AvatarBounds, FrameImage, Supersampling},
};
use std::collections::HashMap;

/// The reference's images of a case's scenes, each computed once for all settings.
pub struct ReferenceImages<'a> {
    avatar: &'a Avatar,
    /// By scene, and by how what is small is drawn.
    images: HashMap<ImageKey, FrameImage>,
}

/// What the reference's images of a case are told apart by.
#[derive(PartialEq, Eq, Hash)]
struct ImageKey {
    /// Index of the scene.
    scene: usize,
    supersampling: Supersampling,
}

impl<'a> ReferenceImages<'a> {
    /// Images of an avatar with all its rows.
    pub fn new(avatar: &'a Avatar) -> Self {
        Self {
            avatar,
            images: HashMap::new(),
        }
    }

    /// The image of a scene, with the clip's pose even while another is held: what the area of each
    /// pixel shows where the case says so ([`BenchCase::truth_factor`]), else what a renderer with
    /// these options should draw.
    pub(super) fn image(
        &mut self,
        index: usize,
        scene: &BenchScene,
        case: BenchCase,
        options: &RendererOptions,
    ) -> &FrameImage {
        let factor = case.truth_factor();
        let supersampling = if factor > 1 {
            Supersampling::OFF
        } else {
            options.supersampling
        };
        let key = ImageKey {
            scene: index,
            supersampling,
        };
        self.images.entry(key).or_insert_with(|| {
            let instances = scene.instances.iter();
            let poses: Vec<_> = instances.map(|instance| &instance.reference).collect();
            let (avatar, camera) = (self.avatar, &scene.camera);
            if factor > 1 {
                reference::render_supersampled(avatar, &poses, camera, factor, avatar.filter)
            } else {
                reference::render_shown(avatar, &poses, camera, supersampling, options.filter)
            }
        })
    }
}

/// The result of comparing some frames.
#[derive(Clone, Copy, Debug, Default)]
pub struct CheckResult {
    /// The worst of the frames. None if none was compared.
    pub error: Option<ErrorReport>,
    /// Mean number of pixels that the device drew with an alpha of at least 1/255.
    pub covered: Option<f64>,
}

/// Draws the scenes of a case with these indices again and compares each. `flip`: whether to
/// compute FLIP too, which takes seconds an image.
///
/// # Errors
/// When the device fails.
pub fn check(
    renderer: &mut CaseRenderer,
    case: BenchCase,
    scenes: &[BenchScene],
    indices: &[usize],
    reference_images: &mut ReferenceImages,
    flip: bool,
    progress: Progress,
) -> Result<CheckResult> {
    let mut worst: Option<ErrorReport> = None;
    let mut covered = 0;
    let options = *renderer.options();
    let bounds = AvatarBounds::new(reference_images.avatar);
    for (done, &index) in indices.iter().enumerate() {
        progress("comparing with the reference", done, indices.len());
        let index = last_in_view(scenes, &bounds, index);
        // The frame before is drawn too: what a frame reuses from it is part of the comparison.
        renderer.draw(&scenes[(index + scenes.len() - 1) % scenes.len()])?;
        renderer.draw(&scenes[index])?;
        let image = renderer.image()?;
        covered += covered_pixels(&image);
        let reference = reference_images.image(index, &scenes[index], case, &options);
        let flip = flip.then(|| flip::between(&image, reference).covered);
        let error = ErrorReport::new(&error::between(&image, reference), flip);
        worst = Some(match worst {
            Some(worst) => worst.worse(error),
            None => error,
        });
    }
    Ok(CheckResult {
        error: worst,
        covered: (!indices.is_empty()).then(|| covered as f64 / indices.len() as f64),
    })
}

/// The frame, or the last before it that may show an avatar: to compare empty images says nothing.
/// The frame itself where none does.
fn last_in_view(scenes: &[BenchScene], bounds: &AvatarBounds, frame: usize) -> usize {
    let count = scenes.len();
    let is_shown = |&at: &usize| {
        let BenchScene {
            instances, camera, ..
        } = &scenes[at];
        let mut joints = instances.iter().map(|instance| &instance.reference.joints);
        joints.any(|joints| !bounds.is_outside(joints, camera))
    };
    let mut backwards = (0..count).map(|back| (frame + count - back) % count);
    backwards.find(is_shown).unwrap_or(frame)
}

/// Pixels with an alpha of at least 1/255.
pub(super) fn covered_pixels(image: &FrameImage) -> usize {
    let is_covered = |pixel: &&[f32; 4]| f64::from(pixel[3]) >= ALPHA_MIN;
    image.pixels.iter().filter(is_covered).count()
}
