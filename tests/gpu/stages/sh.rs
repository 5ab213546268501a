//! The `harmonics` stage and static avatars on the device, against the reference.

use crate::common::{self, Random, Sizes, f16s, gpu};
use effigy_core::{
    avatar::{Avatar, Parts, Pose, ShCoefficients},
    frame::report::STAGES,
    reference,
    scene::{Camera, Posed},
};
use effigy_measure::error;
use effigy_render::vulkan::{Renderer, RendererOptions};
use glam::DVec3;

/// Gives an avatar harmonics from a seed.
fn with_harmonics(mut avatar: Avatar, seed: u64, degree: usize) -> Avatar {
    let random = &mut Random(seed);
    let count = avatar.gaussians.len() * ((degree + 1).pow(2) - 1);
    avatar.sh = Some(ShCoefficients {
        degree,
        coefficients: (0..count)
            .map(|_| f16s(random.vector(0.2).to_array()))
            .collect(),
    });
    avatar
}

/// What a `.ply` becomes: one joint, one part, no networks.
fn still(seed: u64, gaussians: usize, degree: usize) -> Avatar {
    let mut avatar = common::avatar(
        seed,
        Sizes {
            gaussians,
            parts: 1,
            nodes: 1,
            rows: 0,
            joints: 1,
            ..Sizes::default()
        },
    );
    avatar.networks.layers.clear();
    avatar.nodes.basis.halves_mut().clear();
    avatar.parts = Parts {
        start: vec![0, gaussians as u32],
        head: 0,
    };
    avatar.inputs = effigy_core::avatar::Inputs {
        joint: vec![],
        expression: 0,
        pose_space: None,
        expression_space: None,
    };
    if degree > 0 {
        with_harmonics(avatar, seed, degree)
    } else {
        avatar
    }
}

/// Colours of the device against the reference's, element by element. A colour is stored in f16,
/// half a step of which is 2⁻¹² of what lies between 1/2 and 1 and 2⁻¹¹ of the number at most;
/// f32's sums and the direction's turns are far below that.
fn check(what: &str, frame: &gpu::Frame) {
    let gaussians = &frame.reference.gaussians;
    let mean = |k: usize| gaussians[k].mean;
    let colors = reference::sh::colors(&frame.avatar, &frame.posed, &frame.camera, mean);
    let expected = colors.unwrap();
    assert_eq!(frame.gpu.colors.len(), expected.len());
    for (at, (got, expected)) in frame.gpu.colors.iter().zip(&expected).enumerate() {
        let error = (DVec3::from(got.map(f64::from)) - expected).abs();
        let allowed = expected.abs() * 2f64.powi(-11) + 2e-5;
        assert!(
            error.cmple(allowed).all(),
            "{what}: Gaussian {at} is {got:?}, expected {expected}; {allowed} is allowed"
        );
    }
}

fn compare() {
    let device = gpu::gpu();
    let options = RendererOptions {
        ..gpu::options([120, 90])
    };
    for degree in 1..=3 {
        for gaussians in [1, 63, 3000] {
            let avatar = still(gaussians as u64, gaussians, degree);
            let mut pose = Pose::rest(1, 0);
            pose.rotation[0] = DVec3::new(0.4, -1.1, 2.0);
            let posed = Posed::new(&avatar, &pose);
            let camera = gpu::camera(&avatar, &posed, [120, 90]);
            check(
                &format!("degree {degree}"),
                &gpu::draw(&device, avatar, posed, camera, options),
            );
        }
    }
}

fn every_colour_is_the_references() {
    compare();
}

/// A scene whose nodes displace its Gaussians, from metres to half a kilometre: a body in one box.
fn spread(seed: u64, gaussians: usize, degree: usize) -> Avatar {
    let mut avatar = still(seed, gaussians, degree);
    let offsets = [0.0, 4.0, -32.0, 512.0].map(|x| f16s([x, 0.25 * x, -2.0 * x]));
    avatar.nodes = effigy_core::avatar::Nodes {
        position: vec![[0; 3]; 4],
        part: vec![0; 4],
        offset: offsets.to_vec(),
        basis: avatar.nodes.basis.clone(),
    };
    for (k, node) in avatar.gaussians.node.iter_mut().enumerate() {
        *node = [(k % 4) as u16; 3];
    }
    avatar
}

/// Directions lead to where nodes put a Gaussian, and images of such a scene are the reference's,
/// those after a turn of the camera too, which come from the pose cache where colours stand still.
fn what_nodes_displace_is_seen_where_it_is() {
    let device = gpu::gpu();
    for degree in [0, 1, 3] {
        let avatar = spread(4, 3000, degree);
        let posed = Posed::new(&avatar, &Pose::rest(1, 0));
        let camera = Camera::orbit(DVec3::Y, 0.3, 0.1, 3.0, 0.8, [200, 160]);
        let options = gpu::options([200, 160]);
        let frame = gpu::draw(&device, avatar.clone(), posed.clone(), camera, options);
        if degree > 0 {
            check(&format!("displaced, degree {degree}"), &frame);
        }
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        for yaw in [0.3, 0.31, 0.5] {
            let camera = Camera::orbit(DVec3::Y, yaw, 0.1, 3.0, 0.8, [200, 160]);
            renderer.draw(&posed, &camera, None).unwrap();
            let image = renderer.read_image().unwrap();
            let expected = reference::render(&avatar, &posed, &camera);
            let error = error::between(&image, &expected);
            assert!(
                error.covered.psnr_db >= 48.0 && error.covered.pixels > 1000,
                "degree {degree}, yaw {yaw}: {error:?}"
            );
        }
    }
}

fn avatars_that_move_inside_may_have_harmonics_too() {
    let device = gpu::gpu();
    let avatar = with_harmonics(
        common::avatar(
            3,
            Sizes {
                rows: 2000,
                ..Sizes::default()
            },
        ),
        4,
        3,
    );
    let posed = Posed::new(&avatar, &common::pose(5, &avatar));
    let camera = gpu::camera(&avatar, &posed, [300, 200]);
    let frame = gpu::draw(&device, avatar, posed, camera, gpu::options([300, 200]));
    check("a body in motion", &frame);
    let error = error::between(&frame.image, &frame.reference.canvas.to_image());
    assert!(error.covered.psnr_db >= 50.0, "{error:?}");
}

fn static_avatars_look_as_the_reference_draws_them() {
    let device = gpu::gpu();
    for degree in 0..=3 {
        let avatar = still(8, 5000, degree);
        let posed = Posed::new(&avatar, &Pose::rest(1, 0));
        let camera = gpu::camera(&avatar, &posed, [256, 256]);
        let frame = gpu::draw(&device, avatar, posed, camera, gpu::options([256, 256]));
        let error = error::between(&frame.image, &frame.reference.canvas.to_image());
        assert!(
            error.covered.psnr_db >= 50.0 && error.covered.pixels > 1000,
            "degree {degree}: {error:?}"
        );
    }
}

/// Turning the avatar and the camera alike leaves its colours as they are; turning the camera alone
/// does not.
fn colours_turn_with_the_avatar() {
    let avatar = still(2, 400, 3);
    let camera = Camera::orbit(DVec3::ZERO, 0.3, 0.1, 4.0, 0.7, [64, 64]);
    let mut pose = Pose::rest(1, 0);
    let colors = |pose: &Pose, camera: &Camera| {
        let posed = Posed::new(&avatar, pose);
        let mean = |k: usize| posed.joints[0].transform_point3(avatar.placed(k));
        reference::sh::colors(&avatar, &posed, camera, mean).unwrap()
    };
    let before = colors(&pose, &camera);
    let largest = |a: &[DVec3], b: &[DVec3]| {
        a.iter()
            .zip(b)
            .map(|(a, b)| (*a - *b).abs().max_element())
            .fold(0.0, f64::max)
    };
    pose.rotation[0] = DVec3::new(0.2, 1.3, -0.4);
    let turned = Posed::new(&avatar, &pose).joints[0]
        * Posed::new(&avatar, &Pose::rest(1, 0)).joints[0].inverse();
    let along = Camera {
        view: camera.view * turned.inverse(),
        ..camera
    };
    assert!(largest(&before, &colors(&pose, &along)) < 1e-9);
    assert!(largest(&before, &colors(&pose, &camera)) > 0.1);
}

fn the_stage_runs_when_the_view_changes_and_for_no_other_avatar() {
    let device = gpu::gpu();
    let (with, without) = (still(1, 200, 2), still(1, 200, 0));
    let posed = Posed::new(&with, &Pose::rest(1, 0));
    let camera = gpu::camera(&with, &posed, [64, 64]);
    let moved = Camera::orbit(DVec3::ZERO, 1.0, 0.0, 4.0, 0.7, [64, 64]);
    let ran = |avatar: &Avatar, cameras: &[Camera]| {
        let mut renderer = Renderer::new(&device, avatar, gpu::options([64, 64])).unwrap();
        let mut colors = vec![];
        for camera in cameras {
            renderer.draw(&posed, camera, None).unwrap();
            renderer.finish().unwrap();
            colors.push(renderer.stages().unwrap().colors);
        }
        let report = renderer.report();
        let skipped = report.skipped.contains(&"sh");
        (
            colors,
            report.stages.iter().any(|stage| stage.0 == "sh"),
            skipped,
        )
    };
    assert!(STAGES.contains(&"sh"));
    let (colors, last, _) = ran(&with, &[camera, moved]);
    assert!(
        colors[0] != colors[1] && (last || device.probe.timestamp_bits == 0),
        "the camera moved"
    );
    let (_, last, skipped) = ran(&with, &[camera, camera]);
    assert!(!last && skipped, "nothing changed");
    let (colors, last, skipped) = ran(&without, &[camera, moved]);
    assert!(
        colors[0] == colors[1] && !last && !skipped,
        "there are no harmonics"
    );
}

tests! {
    every_colour_is_the_references: smoke,
    what_nodes_displace_is_seen_where_it_is,
    avatars_that_move_inside_may_have_harmonics_too,
    static_avatars_look_as_the_reference_draws_them,
    colours_turn_with_the_avatar: no_device,
    the_stage_runs_when_the_view_changes_and_for_no_other_avatar,
}
