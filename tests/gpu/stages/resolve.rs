//! The `resolve` stage: avatars that are drawn larger than they are shown, with Vulkan.

use crate::{
    common::{
        self,
        gpu::{
            self,
            Raster::{self, CooperativeTiles, Quads, SharedTiles, TestedQuads},
        },
    },
    small::{LARGE, Renders, assert_near, posed, scene, supersampled},
};
use effigy_core::{
    avatar::Avatar,
    frame::{FrameReport, Person, RendererOptions},
    reference,
    scene::{Camera, Detail, FrameImage, Posed, Supersampling},
};
use effigy_render::vulkan::Renderer;
use glam::DVec3;

impl Renders for Renderer {
    fn device() -> String {
        gpu::drawing().probe.name.clone()
    }

    fn make(avatar: &Avatar, options: RendererOptions) -> Self {
        Self::new(&gpu::gpu(), avatar, options).unwrap()
    }

    fn draw_all(&mut self, poses: &[&Posed], camera: &Camera) {
        self.draw_scene(&Person::copies(poses), camera, None)
            .unwrap();
    }

    fn image(&mut self) -> FrameImage {
        let image = self.read_image().unwrap();
        self.finish().unwrap();
        image
    }

    fn report(&self) -> FrameReport {
        Self::report(self).clone()
    }
}

check_with!(Renderer);

/// A governor asks for one level coarser than is near enough, and takes that back.
fn coarser_levels_are_drawn_where_asked_for(raster: Raster) {
    let (avatar, camera) = scene(8.0, LARGE);
    let avatar = common::with_near_levels(avatar);
    let [first, second] = [0, 1].map(|level: usize| avatar.at_level(&avatar.levels[level]));
    let whole = Avatar {
        levels: vec![],
        ..avatar.clone()
    };
    let options = supersampled::<Renderer>(raster, &camera, Supersampling::BySize);
    let mut renderer = Renderer::new(&gpu::gpu(), &avatar, options).unwrap();
    let posed = posed(&avatar, &camera, 6, DVec3::new(0.2, 0.1, 2.0));
    for (coarser, drawn) in [
        (0, &whole),
        (1, &first),
        (2, &second),
        (9, &second),
        (0, &whole),
    ] {
        let detail = Detail {
            coarser,
            ..options.detail
        };
        renderer.adjust(options.size, detail).unwrap();
        renderer.draw(&posed, &camera, None).unwrap();
        let image = renderer.read_image().unwrap();
        let expected = reference::render_shown(
            &reference::people(drawn, &[&posed]),
            &camera,
            Supersampling::BySize,
            None,
        );
        assert_near(
            &format!("{coarser} levels coarser"),
            &image,
            &expected,
            44.0,
        );
    }
}

tests! {
    coarser_levels_are_drawn_where_asked_for[Quads],
    coarser_levels_are_drawn_where_asked_for[CooperativeTiles],
    any_factor_is_averaged_by_area[Quads],
    any_factor_is_averaged_by_area[CooperativeTiles],
    any_factor_is_averaged_by_area[SharedTiles],
    no_switch_is_seen[Quads],
    no_switch_is_seen[CooperativeTiles],
    no_switch_is_seen[SharedTiles],
    levels_have_their_own_harmonics[Quads],
    levels_have_their_own_harmonics[CooperativeTiles],
    levels_have_their_own_harmonics[SharedTiles],
    levels_have_samples_of_their_own[Quads],
    levels_have_samples_of_their_own[CooperativeTiles],
    levels_are_drawn_as_avatars[Quads],
    levels_are_drawn_as_avatars[CooperativeTiles],
    levels_are_drawn_as_avatars[SharedTiles],
    a_small_avatar_is_its_own_average[Quads],
    a_small_avatar_is_its_own_average[TestedQuads],
    a_small_avatar_is_its_own_average[CooperativeTiles],
    a_small_avatar_is_its_own_average[SharedTiles],
    small_avatars_go_before_and_behind_large_ones[Quads],
    small_avatars_go_before_and_behind_large_ones[TestedQuads],
    small_avatars_go_before_and_behind_large_ones[CooperativeTiles],
    small_avatars_go_before_and_behind_large_ones[SharedTiles],
    small_avatars_that_touch_are_sorted_together[CooperativeTiles],
    small_avatars_that_touch_are_sorted_together[Quads],
    what_faint_saves_cuts_nothing_off[Quads],
    what_faint_saves_cuts_nothing_off[CooperativeTiles],
    what_faint_saves_cuts_nothing_off[SharedTiles],
    frames_show_the_same_whatever_came_before[Quads],
    frames_show_the_same_whatever_came_before[TestedQuads],
    frames_show_the_same_whatever_came_before[CooperativeTiles],
    frames_show_the_same_whatever_came_before[SharedTiles],
    frames_leave_nothing_behind[TestedQuads],
    frames_leave_nothing_behind[CooperativeTiles],
    frames_leave_nothing_behind[SharedTiles],
}
