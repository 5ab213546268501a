//! Several avatars in one scene: sorted together as the reference sorts them, each with its own
//! state from frame to frame, and culled as wholes.

use crate::common::{self, Random, Sizes, f16s, gpu};
use effigy_core::{
    avatar::{Avatar, ShCoefficients},
    frame::{Person, Skip},
    reference,
    scene::{AvatarBounds, Camera, FrameImage, Posed},
};
use effigy_measure::error;
use effigy_render::vulkan::{FrameReport, Gpu, Renderer, RendererOptions};
use glam::{DAffine3, DVec3};
use std::sync::Arc;

const SIZE: [u32; 2] = [240, 280];

fn camera(yaw: f64) -> Camera {
    Camera::orbit(DVec3::new(0.0, 1.0, 0.0), yaw, 0.05, 4.5, 0.7, SIZE)
}

/// Poses of an avatar around the origin, each from its seed and at its place.
fn poses(avatar: &Avatar, at: &[(u64, DVec3)]) -> Vec<Posed> {
    let pose = |&(seed, place): &(u64, DVec3)| {
        let mut pose = common::pose(seed, avatar);
        pose.translation = DVec3::ZERO;
        Posed::new(avatar, &pose).placed(DAffine3::from_translation(place))
    };
    at.iter().map(pose).collect()
}

fn renderer(device: &Arc<Gpu>, avatar: &Avatar, instances: usize, skip: Skip) -> Renderer {
    Renderer::new(
        device,
        avatar,
        RendererOptions {
            instances,
            skip,
            ..gpu::options(SIZE)
        },
    )
    .unwrap()
}

fn draw(renderer: &mut Renderer, poses: &[Posed], camera: &Camera) -> (FrameImage, FrameReport) {
    renderer
        .draw_scene(
            &Person::copies(&poses.iter().collect::<Vec<_>>()),
            camera,
            None,
        )
        .unwrap();
    let image = renderer.read_image().unwrap();
    (image, renderer.report().clone())
}

/// Three bodies that reach through each other: at most of their depths Gaussians of one lie between
/// those of another.
fn avatars_are_sorted_together_as_the_reference_sorts_them() {
    let device = gpu::gpu();
    let avatar = common::avatar(3, Sizes::default());
    let poses = poses(
        &avatar,
        &[
            (1, DVec3::ZERO),
            (2, DVec3::new(0.15, 0.0, 0.1)),
            (5, DVec3::new(-0.2, 0.05, -0.1)),
        ],
    );
    for yaw in [0.4, 2.0] {
        let mut renderer = renderer(&device, &avatar, 3, Skip::all() - Skip::DEPTH);
        let (image, report) = draw(&mut renderer, &poses, &camera(yaw));
        let reference = reference::render_scene(
            &reference::people(&avatar, &poses.iter().collect::<Vec<_>>()),
            &camera(yaw),
            None,
        );
        let error = error::between(&image, &reference).covered;
        assert!(error.pixels > 5000 && error.psnr_db >= 50.0, "{error:?}");
        let owner = |slot: &u32| *slot as usize / avatar.gaussians.len();
        let order = renderer.stages().unwrap().order;
        let changes = order
            .windows(2)
            .filter(|pair| owner(&pair[0]) != owner(&pair[1]))
            .count();
        assert!(
            changes > order.len() / 10,
            "{changes} of {} neighbours are of different avatars",
            order.len()
        );
        assert_eq!(
            (report.counters.avatars, report.counters.avatars_culled),
            (3, 0)
        );
        assert_eq!(report.counters.gaussians, 3 * avatar.gaussians.len() as u64);
    }
}

fn each_avatar_has_the_colours_that_the_camera_sees_on_it() {
    let device = gpu::gpu();
    let mut avatar = common::avatar(4, Sizes::default());
    let random = &mut Random(7);
    let coefficients = (0..15 * avatar.gaussians.len())
        .map(|_| f16s(random.vector(0.2).to_array()))
        .collect();
    avatar.sh = Some(ShCoefficients {
        degree: 3,
        coefficients,
    });
    let poses = poses(
        &avatar,
        &[
            (1, DVec3::new(-0.5, 0.0, 0.0)),
            (2, DVec3::new(0.5, 0.0, 0.3)),
        ],
    );
    let (image, _) = draw(
        &mut renderer(&device, &avatar, 2, Skip::all()),
        &poses,
        &camera(0.3),
    );
    let reference = reference::render_scene(
        &reference::people(&avatar, &poses.iter().collect::<Vec<_>>()),
        &camera(0.3),
        None,
    );
    let error = error::between(&image, &reference).covered;
    assert!(error.pixels > 5000 && error.psnr_db >= 50.0, "{error:?}");
}

/// The one outside has the depths of one inside, so that it changes no key.
fn an_avatar_outside_the_view_costs_nothing_and_changes_no_bit() {
    let device = gpu::gpu();
    let avatar = common::avatar(3, Sizes::default());
    let camera = camera(0.4);
    let right = camera.view.matrix3.transpose() * DVec3::X;
    let poses = poses(
        &avatar,
        &[
            (1, 30.0 * right),
            (1, DVec3::ZERO),
            (2, DVec3::new(0.2, 0.0, 0.1)),
        ],
    );
    let skip = Skip::all() - Skip::DEPTH;
    let mut culls = renderer(&device, &avatar, 3, skip);
    let (image, report) = draw(&mut culls, &poses, &camera);
    let mut draws = renderer(&device, &avatar, 3, skip - Skip::AVATARS - Skip::PARTS);
    let (all, full) = draw(&mut draws, &poses, &camera);
    assert!(
        image == all,
        "the image changes: {:?}",
        error::between(&image, &all).covered
    );
    assert!(
        image
            == draw(
                &mut renderer(&device, &avatar, 2, skip),
                &poses[1..],
                &camera
            )
            .0,
        "it is not that of the other two"
    );
    let each = avatar.gaussians.len() as u64;
    assert_eq!(
        (report.counters.avatars_culled, full.counters.avatars_culled),
        (1, 0)
    );
    assert_eq!(
        (report.counters.gaussians, report.counters.drawn),
        (3 * each, full.counters.drawn)
    );
    assert_eq!(report.counters.culled, 3 * each - report.counters.drawn);
    assert_eq!(
        full.counters.dispatches - report.counters.dispatches,
        2,
        "features and splats of one"
    );
    assert_eq!(
        u64::from(culls.stages().unwrap().control.key_count),
        2 * each,
        "keys that enter the sort"
    );
}

fn without_an_avatar_in_view_the_image_is_cleared_once() {
    let device = gpu::gpu();
    let avatar = common::avatar(3, Sizes::default());
    let here = poses(&avatar, &[(1, DVec3::ZERO), (2, DVec3::X)]);
    let away = poses(
        &avatar,
        &[
            (1, DVec3::new(0.0, 0.0, 60.0)),
            (2, DVec3::new(0.0, 0.0, 80.0)),
        ],
    );
    let mut renderer = renderer(&device, &avatar, 2, Skip::all());
    assert!(draw(&mut renderer, &here, &camera(0.0)).1.counters.drawn > 0);
    let (image, report) = draw(&mut renderer, &away, &camera(0.0));
    assert!(image.pixels.iter().all(|&pixel| pixel == [0.0; 4]));
    // Nothing but what clears the image.
    let clears = renderer.raster().dispatches();
    assert_eq!(
        (
            report.counters.avatars_culled,
            report.counters.drawn,
            report.counters.dispatches
        ),
        (2, 0, clears)
    );
    assert_eq!(
        draw(&mut renderer, &away, &camera(0.1))
            .1
            .counters
            .submitted,
        0,
        "another view of nothing"
    );
    let (none, report) = draw(&mut renderer, &[], &camera(0.0));
    assert!(none == image && report.counters.submitted == 0);
    assert!(draw(&mut renderer, &here, &camera(0.0)).1.counters.drawn > 0);
}

/// Avatars move, stand still, leave, change while they are away and come back: every frame is that
/// of a renderer that knows no other.
fn each_avatar_has_its_own_state_from_frame_to_frame() {
    let device = gpu::gpu();
    let avatar = common::avatar(3, Sizes::default());
    let far = DVec3::new(0.0, 0.0, 50.0);
    let (left, right) = (DVec3::new(-0.4, 0.0, 0.0), DVec3::new(0.4, 0.0, 0.2));
    let frames: [&[(u64, DVec3)]; 8] = [
        &[(1, left), (2, right)],
        &[(1, left), (3, right)],
        &[(1, far), (3, right)],
        &[(4, far), (3, right)],
        &[(4, left), (3, right)],
        &[(4, left)],
        &[(4, left), (3, right)],
        &[(4, right), (3, left)],
    ];
    let posed = [2, 1, 0, 0, 1, 0, 0, 0];
    // The pose cache is rounded.
    let skip = Skip::all() - Skip::DEPTH - Skip::SKINNING;
    let mut renderer_of_all = renderer(&device, &avatar, 2, skip);
    for (number, frame) in frames.iter().enumerate() {
        let poses = poses(&avatar, frame);
        // The camera moves a little, so that every frame is drawn.
        let camera = camera(0.4 + 0.01 * number as f64);
        let (image, report) = draw(&mut renderer_of_all, &poses, &camera);
        let (alone, fresh) = draw(&mut renderer(&device, &avatar, 2, skip), &poses, &camera);
        assert!(image == alone, "frame {number} differs");
        let in_view = fresh.counters.avatars - fresh.counters.avatars_culled;
        let saved = fresh.counters.dispatches - report.counters.dispatches;
        assert_eq!(
            in_view - saved,
            posed[number],
            "features that ran in frame {number}"
        );
    }
    let third = poses(&avatar, &[(1, left), (2, right), (3, far)]);
    let error = renderer_of_all
        .draw_scene(
            &Person::copies(&third.iter().collect::<Vec<_>>()),
            &camera(0.4),
            None,
        )
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("3") && error.contains("at most 2"),
        "{error}"
    );
    let none = RendererOptions {
        instances: 0,
        ..gpu::options(SIZE)
    };
    assert!(
        Renderer::new(&device, &avatar, none)
            .is_err_and(|error| error.to_string().contains("avatars in a scene"))
    );
}

/// One moves, the other does not: that one comes from the pose cache, whatever the first does.
fn each_avatar_has_its_own_pose_cache() {
    let device = gpu::gpu();
    let avatar = common::avatar(3, Sizes::default());
    let each = avatar.gaussians.len() as u64;
    let mut renderer = renderer(&device, &avatar, 2, Skip::all() - Skip::DEPTH);
    let (left, right) = (DVec3::new(-0.3, 0.0, 0.0), DVec3::new(0.3, 0.0, 0.2));
    let mut cached = vec![];
    for (number, seed) in [7, 8, 8, 8, 9].into_iter().enumerate() {
        let poses = poses(&avatar, &[(seed, left), (1, right)]);
        // The last two frames have one camera.
        let camera = camera(0.3 + 0.1 * number.min(3) as f64);
        let (image, report) = draw(&mut renderer, &poses, &camera);
        let reference = reference::render_scene(
            &reference::people(&avatar, &poses.iter().collect::<Vec<_>>()),
            &camera,
            None,
        );
        let error = error::between(&image, &reference).covered;
        assert!(error.psnr_db >= 47.0, "frame {number}: {error:?}");
        cached.push(report.counters.cached / each);
    }
    assert_eq!(cached, [0, 0, 1, 2, 1], "avatars drawn from the pose cache");
}

/// What is taken to be outside the view is: nothing of it is in the reference's image.
fn nothing_of_an_avatar_outside_the_view_would_be_drawn() {
    let random = &mut Random(11);
    let mut seen = [0, 0];
    for seed in 0..4 {
        let avatar = common::avatar(
            seed,
            Sizes {
                gaussians: 800,
                ..Sizes::default()
            },
        );
        let avatar_bounds = AvatarBounds::new(&avatar);
        for _ in 0..60 {
            let posed = &poses(&avatar, &[(random.next(), random.vector(1.0))])[0];
            let eye = random.vector(3.0);
            let camera =
                Camera::look_at(eye, eye + random.vector(1.0), random.range(0.1, 2.0), SIZE);
            let in_view = !avatar_bounds
                .visible(&posed.joints, &camera)
                .parts
                .is_empty();
            let splats = reference::ReferenceFrame::new(&avatar, posed, &camera).splats;
            let drawn = splats.iter().filter(|splat| splat.is_ok()).count();
            assert!(
                in_view || drawn == 0,
                "seed {seed}: {drawn} Gaussians of an avatar outside the view are in the image"
            );
            seen[usize::from(drawn > 0)] += usize::from(in_view == (drawn > 0));
        }
    }
    assert!(
        seen[0] > 20 && seen[1] > 20,
        "{seen:?} judged exactly: outside, inside"
    );
}

tests! {
    avatars_are_sorted_together_as_the_reference_sorts_them: smoke,
    each_avatar_has_the_colours_that_the_camera_sees_on_it,
    an_avatar_outside_the_view_costs_nothing_and_changes_no_bit,
    without_an_avatar_in_view_the_image_is_cleared_once,
    each_avatar_has_its_own_state_from_frame_to_frame,
    each_avatar_has_its_own_pose_cache,
    nothing_of_an_avatar_outside_the_view_would_be_drawn: no_device,
}
