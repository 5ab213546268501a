//! The image that a frame should show, small avatars supersampled ([`crate::frame::atlas`]).

use super::frame::{Person, gaussians_of, render_scene};
use super::project::{Culled, Splat, project_within};
use super::{raster::raster, sort::order};
use crate::avatar::Filter;
use crate::each;
use crate::frame::atlas::{AtlasSlot, AvatarFootprint, LevelInput, arrange};
use crate::scene::{AvatarBounds, Camera, FrameImage, Supersampling, supersampling};
use glam::UVec2;

/// The image of people, with `supersampling` and, if given, another low-pass than their avatars':
/// as a renderer draws its first frame. Who is small is drawn from the avatar's levels, and averaged.
pub fn render_shown(
    people: &[Person],
    camera: &Camera,
    supersampling: Supersampling,
    filter: Option<Filter>,
) -> FrameImage {
    if !supersampling.is_on() {
        return render_scene(people, camera, filter);
    }
    let mut in_view = Vec::new();
    let mut footprints = Vec::new();
    for person in people {
        let bounds = AvatarBounds::new(person.avatar).filtered(filter);
        let visible = bounds.visible(&person.posed.joints, camera);
        if !visible.parts.is_empty() {
            let input = LevelInput {
                supersampling,
                before: 0,
                coarser: 0,
            };
            footprints.push(AvatarFootprint::new(&bounds, &visible, input));
            in_view.push(SmallPerson {
                person: *person,
                bounds,
            });
        }
    }
    let arrangement = arrange(&footprints, camera.size);
    let members = |slot: Option<usize>| {
        let own = arrangement.slot_of.iter().map(move |own| *own == slot);
        let members = in_view.iter().zip(&footprints).zip(own);
        members.filter_map(|(member, own)| own.then_some(member))
    };
    let large: Vec<Person> = members(None).map(|(small, _)| small.person).collect();
    let mut image = render_scene(&large, camera, filter);
    for (at, slot) in arrangement.slots.iter().enumerate() {
        let splats = members(Some(at))
            .flat_map(|(small, footprint)| small.splats(footprint, camera, slot, filter));
        let average = slot_image(&splats.collect::<Vec<_>>(), camera, slot);
        image = if slot.behind {
            image.blended_over(&average)
        } else {
            average.blended_over(&image)
        };
    }
    image
}

/// A person in view, who may be small.
struct SmallPerson<'a> {
    person: Person<'a>,
    bounds: AvatarBounds,
}

impl SmallPerson<'_> {
    /// What a slot of the atlas shows of it.
    fn splats(
        &self,
        footprint: &AvatarFootprint,
        camera: &Camera,
        slot: &AtlasSlot,
        filter: Option<Filter>,
    ) -> Vec<Result<Splat, Culled>> {
        let Person { avatar, posed } = self.person;
        let level = footprint.chosen_for(&self.bounds, slot.factor).level;
        let level = level
            .checked_sub(1)
            .map(|level| avatar.at_level(&avatar.levels[level]));
        let avatar = level.as_ref().unwrap_or(avatar);
        let gaussians = gaussians_of(avatar, &[posed], camera);
        let low_pass = supersampling::low_pass(avatar.filter, filter, slot.factor);
        let own = slot_camera(camera, slot);
        let limits = camera.derivative_limits();
        each::map(gaussians.len(), |k| {
            project_within(&gaussians[k], &own, limits, low_pass, 0)
        })
    }
}

/// The camera of a slot's own image.
fn slot_camera(camera: &Camera, slot: &AtlasSlot) -> Camera {
    let alone = AtlasSlot {
        at: UVec2::ZERO,
        ..*slot
    };
    alone.camera(camera, alone.rect().max.into())
}

/// What a slot adds to the image of a camera: splats, drawn as large as its factor says, and
/// averaged over each pixel's area.
fn slot_image(splats: &[Result<Splat, Culled>], camera: &Camera, slot: &AtlasSlot) -> FrameImage {
    let drawn = raster(splats, &order(splats), &slot_camera(camera, slot)).to_image();
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
