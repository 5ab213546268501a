//! The image that a frame should show, small avatars supersampled ([`crate::frame::atlas`]).

use super::frame::{gaussians_of, render_gaussians};
use super::project::{Gaussian, project_within};
use super::{raster::raster, sort::order};
use crate::avatar::{Avatar, Filter, LowPass};
use crate::each;
use crate::frame::atlas::{AtlasSlot, AvatarFootprint, LevelInput, arrange};
use crate::scene::{AvatarBounds, Camera, FrameImage, Posed, Supersampling, supersampling};
use glam::UVec2;

/// The image of one avatar in several poses, with `supersampling` and, if given, another low-pass
/// than its own: as a renderer draws its first frame. What is small is drawn from the avatar's
/// levels, and averaged.
pub fn render_shown(
    avatar: &Avatar,
    poses: &[&Posed],
    camera: &Camera,
    supersampling: Supersampling,
    filter: Option<Filter>,
) -> FrameImage {
    let whole = |poses: &[&Posed]| {
        let gaussians = gaussians_of(avatar, poses, camera);
        render_gaussians(&gaussians, camera, filter.unwrap_or(avatar.filter))
    };
    if !supersampling.is_on() {
        return whole(poses);
    }
    let bounds = AvatarBounds::new(avatar).filtered(filter);
    let low_pass = |factor| supersampling::low_pass(avatar.filter, filter, factor);
    let mut in_view = Vec::new();
    let mut seen = Vec::new();
    for &posed in poses {
        let visible = bounds.visible(&posed.joints, camera);
        if !visible.parts.is_empty() {
            seen.push(AvatarFootprint::new(
                &bounds,
                &visible,
                LevelInput {
                    supersampling,
                    before: 0,
                    coarser: 0,
                },
            ));
            in_view.push(posed);
        }
    }
    let arrangement = arrange(&seen, camera.size);
    let members = |slot: Option<usize>| {
        let own = arrangement.slot_of.iter().map(move |own| *own == slot);
        let members = in_view.iter().zip(&seen).zip(own);
        members.filter_map(|((&posed, seen), own)| own.then_some((posed, seen)))
    };
    let large: Vec<&Posed> = members(None).map(|(posed, _)| posed).collect();
    let mut image = whole(&large);
    for (at, slot) in arrangement.slots.iter().enumerate() {
        let mut gaussians = Vec::new();
        for (posed, seen) in members(Some(at)) {
            let level = seen.chosen_for(&bounds, slot.factor).level;
            gaussians.extend(if level == 0 {
                gaussians_of(avatar, &[posed], camera)
            } else {
                let level = avatar.at_level(&avatar.levels[level - 1]);
                gaussians_of(&level, &[posed], camera)
            });
        }
        let average = slot_image(&gaussians, camera, slot, low_pass(slot.factor));
        image = if slot.behind {
            image.blended_over(&average)
        } else {
            average.blended_over(&image)
        };
    }
    image
}

/// What a slot adds to the image of a camera: Gaussians of the posed world, drawn as large as its
/// factor says, and averaged over each pixel's area.
pub fn slot_image(
    gaussians: &[Gaussian],
    camera: &Camera,
    slot: &AtlasSlot,
    low_pass: LowPass,
) -> FrameImage {
    let alone = AtlasSlot {
        at: UVec2::ZERO,
        ..*slot
    };
    let own = alone.camera(camera, alone.rect().max.into());
    let limits = camera.derivative_limits();
    let splats = each::map(gaussians.len(), |k| {
        project_within(&gaussians[k], &own, limits, low_pass, 0)
    });
    let drawn = raster(&splats, &order(&splats), &own).to_image();
    let average = drawn.resampled(slot.factor, slot.around.sides().into());
    let mut image = FrameImage::empty(camera.size);
    let shown = slot.shown(camera.size);
    let width = (shown.max.x - shown.min.x) as usize;
    for row in shown.min.y..shown.max.y {
        // Where in the slot's own image the row begins.
        let from = UVec2::new(shown.min.x, row).as_ivec2() - slot.around.min;
        let from = from.y as usize * average.size[0] as usize + from.x as usize;
        let to = row as usize * camera.size[0] as usize + shown.min.x as usize;
        image.pixels[to..to + width].copy_from_slice(&average.pixels[from..from + width]);
    }
    image
}
