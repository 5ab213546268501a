//! The image that a frame should show, small avatars supersampled ([`crate::frame::atlas`]).

use super::frame::{average_of, gaussians_of, render_gaussians};
use crate::avatar::{Avatar, Filter};
use crate::frame::atlas::{Seen, arrange};
use crate::scene::{AvatarBounds, Camera, FrameImage, Posed, Supersampling};

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
    let mut in_view = Vec::new();
    let mut seen = Vec::new();
    for &posed in poses {
        let visible = bounds.visible(&posed.joints, camera);
        if !visible.parts.is_empty() {
            seen.push(Seen::new(
                &bounds,
                &posed.joints,
                camera,
                &visible,
                supersampling,
                1,
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
            let level = seen.level(&bounds, supersampling, slot.factor, 0);
            gaussians.extend(if level == 0 {
                gaussians_of(avatar, &[posed], camera)
            } else {
                let level = avatar.at_level(&avatar.levels[level - 1]);
                gaussians_of(&level, &[posed], camera)
            });
        }
        let filter = filter.unwrap_or(Filter::SUPERSAMPLED);
        let average = average_of(&gaussians, camera, slot.factor, filter);
        image = if slot.behind {
            image.blended_over(&average)
        } else {
            average.blended_over(&image)
        };
    }
    image
}
