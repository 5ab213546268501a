//! What a frame leaves out: every switch on and off, the pictures compared.

mod common;

use common::{Sizes, gpu};
use effigy::{
    avatar::{Avatar, motion::Player},
    demo,
    frame::{Camera, Picture, Posed, Skip},
    measure::error,
    vulkan::{Renderer, RendererOptions, raster::Method},
};
use glam::DVec3;

fn camera(size: [u32; 2], yaw: f64) -> Camera {
    Camera::orbit(DVec3::new(0.0, 1.0, 0.0), yaw, 0.0, 4.0, 0.7, size)
}

/// A frame of some poses, one after the other, with what is given left out.
fn frames(device: &std::sync::Arc<effigy::vulkan::Gpu>, avatar: &Avatar, poses: &[Posed], skip: Skip) -> Vec<(Picture, u64)> {
    let size = [160, 200];
    let options = RendererOptions { skip, ..RendererOptions::new(size) };
    let mut renderer = Renderer::new(device, avatar, options).unwrap();
    let draw = |posed| {
        renderer.draw(posed, &camera(size, 0.4), None).unwrap();
        let picture = renderer.picture().unwrap();
        (picture, renderer.report().counters.drawn)
    };
    poses.iter().map(draw).collect()
}

/// Work whose result is known is left out without changing a bit: zero inputs, networks that do not see what changed, frames that show nothing new.
#[test]
fn exact_skips_change_no_bit() {
    let Some(device) = gpu::gpu() else { return };
    let avatar = common::avatar(3, Sizes::default());
    let first = Posed::new(&avatar, &common::pose(1, &avatar));
    let mut smile = first.clone();
    let body = smile.input.len() - smile.expression;
    smile.input[body..].iter_mut().for_each(|weight| *weight += 0.3);
    let poses = [first.clone(), smile, first.clone(), first];
    let all = frames(&device, &avatar, &poses, Skip::empty());
    assert!(all[0].0 != all[1].0, "the expression shows nowhere");
    for skip in [Skip::INPUTS, Skip::EXPRESSION, Skip::POSE, Skip::FRAME | Skip::POSE] {
        for (number, (with, without)) in frames(&device, &avatar, &poses, skip).iter().zip(&all).enumerate() {
            assert!(with.0 == without.0, "picture {number} changes when {skip} is left out");
        }
    }
    // Where in a hull a fragment is comes out a little different for another hull.
    for (number, (with, without)) in frames(&device, &avatar, &poses, Skip::FAINT).iter().zip(&all).enumerate() {
        let difference = error::between(&with.0, &without.0).covered;
        assert!(difference.psnr_db > 50.0, "picture {number}: {difference:?}");
    }
    gpu::assert_valid();
}

/// Frames without changes are not submitted, and say so; a change is drawn again.
#[test]
fn a_frame_that_needs_nothing_is_not_submitted() {
    let Some(device) = gpu::gpu() else { return };
    let avatar = common::avatar(3, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(1, &avatar));
    let size = [64, 64];
    let mut renderer = Renderer::new(&device, &avatar, RendererOptions::new(size)).unwrap();
    let mut submitted = |yaw| {
        renderer.draw(&posed, &camera(size, yaw), None).unwrap();
        renderer.finish().unwrap();
        (renderer.report().counters.submitted, renderer.report().stages.len())
    };
    assert_eq!(submitted(0.0).0, 1);
    assert_eq!(submitted(0.0), (0, 0));
    assert_eq!(submitted(0.0), (0, 0));
    assert_eq!(submitted(0.1).0, 1);
    gpu::assert_valid();
}

/// Gaussians behind the solid body are left out before the sort, within the picture's budget.
#[test]
fn hidden_gaussians_are_left_out_within_the_budget() {
    let Some(device) = gpu::gpu() else { return };
    let avatar = demo::avatar().unwrap();
    let player = Player::new(demo::clip().unwrap(), &avatar.skeleton);
    let size = [480, 760];
    for (seconds, yaw) in [(0.5, 0.3), (2.0, 3.4)] {
        let posed = Posed::new(&avatar, &player.pose(seconds));
        let bounds = effigy::frame::Extent::new(&avatar).bounds(&posed.joints);
        let camera = Camera::orbit((bounds[0] + bounds[1]) / 2.0, yaw, 0.1, Camera::framing_distance(bounds, 0.6, size), 0.6, size);
        let draw = |skip| {
            let mut renderer = Renderer::new(&device, &avatar, RendererOptions { skip, ..RendererOptions::new(size) }).unwrap();
            renderer.draw(&posed, &camera, None).unwrap();
            let picture = renderer.picture().unwrap();
            (picture, renderer.report().counters.drawn)
        };
        let ((exact, all), (picture, drawn)) = (draw(Skip::empty()), draw(Skip::HIDDEN));
        assert!(drawn * 20 < all * 19, "{drawn} of {all} drawn");
        let difference = error::between(&picture, &exact);
        assert!(difference.covered.psnr_db > 50.0, "{:?} at {seconds} s", difference.covered);
    }
    gpu::assert_valid();
}

/// What lies behind full pixels is left out where tiles are drawn, within the picture's budget.
#[test]
fn full_pixels_take_no_more_within_the_budget() {
    let Some(device) = gpu::gpu() else { return };
    let avatar = demo::avatar().unwrap();
    let posed = Posed::new(&avatar, &Player::new(demo::clip().unwrap(), &avatar.skeleton).pose(1.0));
    let bounds = effigy::frame::Extent::new(&avatar).bounds(&posed.joints);
    let size = [480, 760];
    let camera = Camera::orbit((bounds[0] + bounds[1]) / 2.0, 0.3, 0.1, Camera::framing_distance(bounds, 0.6, size), 0.6, size);
    let draw = |skip| {
        let options = RendererOptions { skip, method: Some(Method::Tiles), count: true, ..RendererOptions::new(size) };
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer.draw(&posed, &camera, None).unwrap();
        let picture = renderer.picture().unwrap();
        (picture, renderer.report().counters.fragments.unwrap())
    };
    let ((exact, all), (picture, shaded)) = (draw(Skip::empty()), draw(Skip::FULL));
    assert!(shaded * 10 < all * 9, "{shaded} of {all} shaded");
    let difference = error::between(&picture, &exact);
    assert!(difference.covered.psnr_db > 56.0 && difference.whole.max_error < 2.0 / 255.0, "{:?}", difference.covered);
    gpu::assert_valid();
}
