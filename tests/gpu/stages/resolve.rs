//! The `resolve` stage: avatars that are drawn larger than they are shown, with Vulkan.

use crate::{
    common::gpu::{
        self,
        Raster::{self, Quads, SharedTiles, TestedQuads, Tiles},
    },
    small::Renders,
};
use effigy::vulkan::Renderer;
use effigy_core::{
    avatar::Avatar,
    frame::{FrameReport, RendererOptions},
    scene::{Camera, FrameImage, Posed},
};

impl Renders for Renderer {
    fn device() -> String {
        gpu::drawing().probe.name.clone()
    }

    fn make(avatar: &Avatar, options: RendererOptions) -> Self {
        Self::new(&gpu::gpu(), avatar, options).unwrap()
    }

    fn draw_all(&mut self, poses: &[&Posed], camera: &Camera) {
        self.draw_scene(poses, camera, None).unwrap();
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

check_with! {
    Renderer:
    a_small_avatar_is_its_own_average,
    small_avatars_go_before_and_behind_large_ones,
    small_avatars_that_touch_are_sorted_together,
    any_factor_is_averaged_by_area,
    no_switch_is_seen,
    frames_leave_nothing_behind,
    levels_are_drawn_as_avatars,
    levels_have_their_own_harmonics,
}

tests! {
    any_factor_is_averaged_by_area[Quads],
    any_factor_is_averaged_by_area[Tiles],
    any_factor_is_averaged_by_area[SharedTiles],
    no_switch_is_seen[Quads],
    no_switch_is_seen[Tiles],
    no_switch_is_seen[SharedTiles],
    levels_have_their_own_harmonics[Quads],
    levels_have_their_own_harmonics[Tiles],
    levels_have_their_own_harmonics[SharedTiles],
    levels_are_drawn_as_avatars[Quads],
    levels_are_drawn_as_avatars[Tiles],
    levels_are_drawn_as_avatars[SharedTiles],
    a_small_avatar_is_its_own_average[Quads],
    a_small_avatar_is_its_own_average[TestedQuads],
    a_small_avatar_is_its_own_average[Tiles],
    a_small_avatar_is_its_own_average[SharedTiles],
    small_avatars_go_before_and_behind_large_ones[Quads],
    small_avatars_go_before_and_behind_large_ones[TestedQuads],
    small_avatars_go_before_and_behind_large_ones[Tiles],
    small_avatars_go_before_and_behind_large_ones[SharedTiles],
    small_avatars_that_touch_are_sorted_together[Tiles],
    small_avatars_that_touch_are_sorted_together[Quads],
    frames_leave_nothing_behind[TestedQuads],
    frames_leave_nothing_behind[Tiles],
    frames_leave_nothing_behind[SharedTiles],
}
