//! What a frame leaves out: every switch on and off, the images compared.

use crate::common::{
    self, Sizes,
    gpu::{
        self,
        Raster::{self, CooperativeTiles, Quads, SharedTiles, TestedQuads},
    },
    harness::not_run,
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::{Counters, Skip},
    scene::{Camera, Detail, FrameImage, Posed},
};
use effigy_measure::error;
use effigy_render::vulkan::{Gpu, Renderer, RendererOptions, raster::RasterMethod};
use glam::DVec3;
use std::sync::Arc;

fn camera(size: [u32; 2], yaw: f64) -> Camera {
    Camera::orbit(DVec3::new(0.0, 1.0, 0.0), yaw, 0.0, 4.0, 0.7, size)
}

/// A frame of some poses, one after the other, with what is given left out.
fn frames(
    device: &Arc<Gpu>,
    avatar: &Avatar,
    poses: &[Posed],
    skip: Skip,
) -> Vec<(FrameImage, Counters)> {
    let size = [160, 200];
    let options = RendererOptions {
        skip,
        ..gpu::options(size)
    };
    let mut renderer = Renderer::new(device, avatar, options).unwrap();
    let draw = |posed| {
        renderer.draw(posed, &camera(size, 0.4), None).unwrap();
        let image = renderer.read_image().unwrap();
        (image, renderer.report().counters)
    };
    poses.iter().map(draw).collect()
}

/// Work whose result is known is left out without changing a bit: zero inputs, networks that do not
/// see what changed, frames that show nothing new.
fn exact_skips_change_no_bit() {
    let device = gpu::gpu();
    let avatar = common::avatar(3, Sizes::default());
    let first = Posed::new(&avatar, &common::pose(1, &avatar));
    let mut smile = first.clone();
    let body = smile.input.len() - smile.expression;
    smile.input[body..]
        .iter_mut()
        .for_each(|weight| *weight += 0.3);
    let poses = [first.clone(), smile, first.clone(), first];
    let all = frames(&device, &avatar, &poses, Skip::empty());
    assert!(all[0].0 != all[1].0, "the expression shows nowhere");
    for skip in [
        Skip::INPUTS,
        Skip::EXPRESSION,
        Skip::POSE,
        Skip::FRAME | Skip::POSE,
        Skip::PARTS,
        Skip::PARTS | Skip::POSE,
    ] {
        let some = frames(&device, &avatar, &poses, skip);
        for (number, (with, without)) in some.iter().zip(&all).enumerate() {
            assert!(
                with.0 == without.0,
                "image {number} changes when {skip} is left out"
            );
        }
        if skip == Skip::EXPRESSION {
            let ran = |at: usize| some[at].1.networks as usize;
            assert!(
                ran(1) == avatar.parts.head && ran(1) < ran(0),
                "{} networks see a smile, {} a new pose",
                ran(1),
                ran(0)
            );
        }
    }
    // A fragment's place in a quad is rounded a little differently in a quad of another size.
    for (number, (with, without)) in frames(&device, &avatar, &poses, Skip::FAINT)
        .iter()
        .zip(&all)
        .enumerate()
    {
        let difference = error::between(&with.0, &without.0).covered;
        assert!(difference.psnr_db > 50.0, "image {number}: {difference:?}");
    }
}

/// Frames without changes are not submitted, and say so; a change is drawn again.
fn a_frame_that_needs_nothing_is_not_submitted() {
    let device = gpu::gpu();
    let avatar = common::avatar(3, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(1, &avatar));
    let size = [64, 64];
    let mut renderer = Renderer::new(&device, &avatar, gpu::options(size)).unwrap();
    let mut submitted = |yaw| {
        renderer.draw(&posed, &camera(size, yaw), None).unwrap();
        renderer.finish().unwrap();
        (
            renderer.report().counters.submitted,
            renderer.report().stages.len(),
        )
    };
    assert_eq!(submitted(0.0).0, 1);
    assert_eq!(submitted(0.0), (0, 0));
    assert_eq!(submitted(0.0), (0, 0));
    assert_eq!(submitted(0.1).0, 1);
}

/// Images with quads of a size and the fragments shaded, where the device counts them: with
/// everything drawn, and with fragments behind the saturation depth left to the depth test.
fn with_and_without_depth(
    device: &Arc<Gpu>,
    size: [u32; 2],
) -> [(FrameImage, Option<u64>, Option<u64>); 2] {
    let avatar = effigy_demo::avatar().unwrap();
    let posed = &demo_poses(&[1.0])[0];
    let camera = gpu::around(&avatar, posed, 0.3, size);
    [Skip::empty(), Skip::DEPTH].map(|skip| {
        let options = RendererOptions {
            skip,
            method: Some(RasterMethod::Quads),
            count: true,
            ..gpu::options(size)
        };
        let mut renderer = Renderer::new(device, &avatar, options).unwrap();
        renderer.draw(posed, &camera, None).unwrap();
        let image = renderer.read_image().unwrap();
        let counters = renderer.report().counters;
        (image, counters.fragments, counters.samples)
    })
}

/// With quads, leaving fragments behind the saturation depth to the depth test stays within the
/// budget of the defaults, which have it switched on, however small the splats are in the image.
fn fragments_behind_the_saturation_depth_are_left_out_within_the_budget() {
    let device = gpu::drawing();
    for size in [[1440, 2280], [960, 1520], [61, 97]] {
        let [(exact, ..), (image, _, samples)] = with_and_without_depth(&device, size);
        let difference = error::between(&image, &exact);
        println!("{size:?}: {:?}", difference.covered);
        // Where Gaussians are small in the image, they would fall between the samples, and no depth
        // is tested.
        let small = size[0] < 100;
        assert!(
            difference.covered.psnr_db > 56.0
                && difference.whole.max_error < 0.05
                && (image == exact) == small,
            "{size:?}: {:?}",
            difference.covered
        );
        assert_eq!(samples.is_none_or(|samples| samples == 0), small);
    }
}

fn fewer_fragments_are_shaded_where_depth_is_tested() {
    let device = gpu::drawing();
    if device.probe.driver.contains("Mesa 22.") {
        not_run(
            "Mesa 22.3's lavapipe counts whole blocks of fragments, 3.8 times Mesa 25's number, \
             before the depth test",
        );
    }
    let [(_, Some(all), _), (_, Some(shaded), _)] = with_and_without_depth(&device, [960, 1520])
    else {
        not_run(format!("{} does not count fragments", device.probe.name))
    };
    assert!(shaded * 3 < all * 2, "{shaded} of {all} shaded");
}

/// Splats behind saturated pixels are skipped where tiles are drawn, within the image's budget.
fn full_pixels_take_no_more_within_the_budget(raster: Raster) {
    let device = gpu::gpu();
    let avatar = effigy_demo::avatar().unwrap();
    let posed = Posed::new(
        &avatar,
        &Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton).pose(1.0),
    );
    let size = [480, 760];
    let camera = gpu::around(&avatar, &posed, 0.3, size);
    let draw = |skip| {
        let options = RendererOptions {
            skip,
            count: true,
            ..raster.options(&device.probe.name, size)
        };
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer.draw(&posed, &camera, None).unwrap();
        let image = renderer.read_image().unwrap();
        (image, renderer.report().counters.fragments.unwrap())
    };
    let ((exact, all), (image, shaded)) = (draw(Skip::empty()), draw(Skip::SATURATED));
    assert!(shaded * 10 < all * 9, "{shaded} of {all} shaded");
    let difference = error::between(&image, &exact);
    assert!(
        difference.covered.psnr_db > 56.0 && difference.whole.max_error < 2.0 / 255.0,
        "{:?}",
        difference.covered
    );
}

/// A frame of every camera, one after the other, of the demo in one pose or in those given.
fn turn(
    device: &Arc<Gpu>,
    poses: &[Posed],
    cameras: &[Camera],
    skip: Skip,
) -> Vec<(FrameImage, Counters)> {
    let avatar = effigy_demo::avatar().unwrap();
    let options = RendererOptions {
        skip,
        ..gpu::options(cameras[0].size)
    };
    let mut renderer = Renderer::new(device, &avatar, options).unwrap();
    let draw = |(posed, camera)| {
        renderer.draw(posed, camera, None).unwrap();
        let image = renderer.read_image().unwrap();
        (image, renderer.report().counters)
    };
    poses.iter().cycle().zip(cameras).map(draw).collect()
}

fn demo_poses(seconds: &[f64]) -> Vec<Posed> {
    let avatar = effigy_demo::avatar().unwrap();
    let player = Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton);
    seconds
        .iter()
        .map(|&seconds| Posed::new(&avatar, &player.pose(seconds)))
        .collect()
}

/// Without the switch all is drawn, to the bit as if no Gaussian had a cone.
fn what_faces_away_is_drawn_where_it_is_not_skipped() {
    let device = gpu::gpu();
    let avatar = common::avatar(4, Sizes::default());
    let faced = common::faced(avatar.clone());
    let posed = Posed::new(&avatar, &common::pose(5, &avatar));
    let own = gpu::options([200, 240]);
    let camera = gpu::camera(&avatar, &posed, own.size);
    let draw = |avatar: &Avatar, skip: Skip| {
        let options = RendererOptions { skip, ..own };
        let frame = gpu::draw(&device, avatar.clone(), posed.clone(), camera, options);
        (frame.image, frame.report.counters.drawn)
    };
    let whole = draw(&avatar, own.skip);
    assert!(draw(&faced, own.skip - Skip::FACING) == whole);
    let (image, drawn) = draw(&faced, own.skip);
    assert!(
        image != whole.0 && 10 * drawn < 8 * whole.1,
        "{drawn} of {}",
        whole.1
    );
}

/// Images drawn from the pose cache are the same but for its rounding, and a new pose fills it
/// anew.
fn a_still_body_comes_from_the_pose_cache_and_does_not_jump() {
    let device = gpu::gpu();
    let size = [480, 760];
    let orbit = |yaw| Camera::orbit(DVec3::new(0.0, 0.9, 0.0), yaw, 0.1, 2.6, 0.7, size);
    let cameras = [0.0, 0.4, 0.4001, 2.5, 0.4, 2.5].map(orbit);
    let poses = demo_poses(&[0.5, 0.5, 0.5, 0.5, 0.5, 2.0]);
    let computed = turn(&device, &poses, &cameras, Skip::empty());
    let cached = turn(&device, &poses, &cameras, Skip::SKINNING | Skip::POSE);
    let counts: Vec<bool> = cached
        .iter()
        .map(|(_, counters)| counters.cached == counters.gaussians)
        .collect();
    assert_eq!(counts, [false, false, true, true, true, false]);
    assert!(computed.iter().all(|(_, counters)| counters.cached == 0));
    for (number, (a, b)) in cached.iter().zip(&computed).enumerate() {
        if counts[number] {
            let difference = error::between(&a.0, &b.0);
            println!("image {number}: {:?}", difference.covered);
            assert!(
                difference.covered.psnr_db > 55.0,
                "image {number}: {:?}",
                difference.covered
            );
        } else {
            assert!(a.0 == b.0, "image {number} draws what it has just computed");
        }
    }
    // The same frame both ways: as computed, and from the pose cache.
    let jump = error::between(&cached[4].0, &cached[1].0).covered;
    assert!(
        jump.psnr_db > 55.0 && cached[4].0 != cached[1].0,
        "{jump:?}"
    );
}

/// Parts outside the view are left out without changing a bit, and their networks run when they
/// come into it.
fn parts_outside_the_view_wait_for_it() {
    let device = gpu::gpu();
    let size = [300, 200];
    let at = |height, yaw| Camera::orbit(DVec3::new(0.0, height, 0.0), yaw, 0.0, 0.7, 0.5, size);
    // The head; the pose changes; the camera turns, and moves on to the feet, then back far enough
    // to see all.
    let cameras = [
        at(1.6, 0.0),
        at(1.6, 0.0),
        at(1.6, 0.1),
        at(0.1, 0.1),
        Camera::orbit(DVec3::Y, 0.3, 0.0, 5.0, 0.7, size),
    ];
    let poses = demo_poses(&[0.5, 2.0, 2.0, 2.0, 2.0]);
    for skip in [Skip::POSE, Skip::POSE | Skip::SKINNING] {
        let (all, some) = (
            turn(&device, &poses, &cameras, skip),
            turn(&device, &poses, &cameras, skip | Skip::PARTS),
        );
        for (number, (a, b)) in some.iter().zip(&all).enumerate() {
            assert!(
                a.0 == b.0,
                "image {number} with {skip}: {:?} {:?} {:?}",
                error::between(&a.0, &b.0).covered,
                a.1,
                b.1
            );
        }
        let networks = |frames: &[(FrameImage, Counters)]| {
            frames
                .iter()
                .map(|(_, counters)| counters.networks)
                .collect::<Vec<_>>()
        };
        let parts = effigy_demo::avatar().unwrap().parts.len() as u64;
        assert_eq!(networks(&all), [parts, parts, 0, 0, 0]);
        let ran = networks(&some);
        assert!(
            ran[0] > 0
                && ran[0] < parts
                && ran[1] < parts
                && ran[2..].iter().sum::<u64>() + ran[1] == parts,
            "{ran:?}"
        );
        assert!(
            some[0].1.parts_outside > parts / 4
                && some[4].1.parts_outside == 0
                && all[0].1.parts_outside == 0
        );
    }
}

/// Where nothing is and nothing was, the image is not damage, and is the same: while the avatar
/// crosses it, comes near, leaves it, and when the image's drawn part changes.
fn only_a_box_around_the_avatar_is_drawn(raster: Raster) {
    let device = gpu::gpu();
    let own = raster.options(&device.probe.name, [1, 1]);
    let avatar = common::avatar(3, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(1, &avatar));
    let (whole, part) = ([300, 200], [230, 150]);
    let bounds = effigy_core::scene::AvatarBounds::new(&avatar).bounds(&posed.joints);
    // Metres to the left, and of the framing distance how much.
    let views = [
        (0.0, 3.0),
        (0.9, 3.0),
        (-0.9, 3.0),
        (0.0, 0.8),
        (0.1, 6.0),
        (90.0, 3.0),
        (0.2, 4.0),
    ];
    let draw = |skip: Skip| {
        let options = RendererOptions {
            skip: skip | own.skip & Skip::DEPTH,
            size: whole,
            ..own
        };
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        let mut images = Vec::new();
        for size in [whole, part, whole] {
            renderer.adjust(size, Detail::FULL).unwrap();
            for (left, far) in views {
                let target = (bounds[0] + bounds[1]) / 2.0 + DVec3::new(left, 0.0, 0.0);
                let camera = Camera::orbit(
                    target,
                    0.0,
                    0.0,
                    far * Camera::framing_distance(bounds, 0.6, size),
                    0.6,
                    size,
                );
                renderer.draw(&posed, &camera, None).unwrap();
                images.push((
                    renderer.read_image().unwrap(),
                    renderer.report().counters.damaged,
                ));
            }
        }
        images
    };
    let (all, some) = (draw(Skip::empty()), draw(Skip::DAMAGE));
    for (k, ((exact, every), (image, area))) in all.iter().zip(&some).enumerate() {
        let pixels = exact.pixels.len() as u64;
        assert!(image == exact, "{raster:?}, image {k}");
        let covered = exact.pixels.iter().filter(|pixel| pixel[3] > 0.0).count() as u64;
        assert!(
            *every == pixels && *area >= covered,
            "{raster:?}, image {k}: {area} of {every}, {covered} covered"
        );
    }
    // All at first; then what it leaves and where it comes to.
    assert!(
        some[0].1 == all[0].1 && some[6].1 < all[6].1,
        "{raster:?}: {} and {}",
        some[0].1,
        some[6].1
    );
}

tests! {
    exact_skips_change_no_bit,
    a_frame_that_needs_nothing_is_not_submitted,
    fragments_behind_the_saturation_depth_are_left_out_within_the_budget,
    fewer_fragments_are_shaded_where_depth_is_tested,
    full_pixels_take_no_more_within_the_budget[CooperativeTiles],
    full_pixels_take_no_more_within_the_budget[SharedTiles],
    a_still_body_comes_from_the_pose_cache_and_does_not_jump,
    what_faces_away_is_drawn_where_it_is_not_skipped,
    parts_outside_the_view_wait_for_it,
    only_a_box_around_the_avatar_is_drawn[Quads],
    only_a_box_around_the_avatar_is_drawn[CooperativeTiles],
    only_a_box_around_the_avatar_is_drawn[TestedQuads],
    only_a_box_around_the_avatar_is_drawn[SharedTiles],
}
