//! The f64 reference on whole bodies from a seed: what holds for every image, and a second,
//! slower way to the same one.

use crate::common::{self, Sizes};
use effigy_core::avatar::{Activation, Avatar, Pose};
use effigy_core::reference::{self, Culled, ReferenceFrame, Splat};
use effigy_core::scene::{Camera, FrameImage, Posed};
use glam::{DVec2, DVec3};

/// A view in which part of the body lies outside the image.
fn camera(seed: u64, size: [u32; 2]) -> Camera {
    Camera::orbit(
        DVec3::new(0.2, 1.2, 0.0),
        seed as f64,
        0.2,
        1.2 + 0.3 * seed as f64,
        0.7,
        size,
    )
}

fn body(seed: u64, sizes: Sizes) -> (Avatar, Pose) {
    let avatar = common::avatar(seed, sizes);
    let pose = common::pose(seed, &avatar);
    (avatar, pose)
}

fn small() -> Sizes {
    Sizes {
        gaussians: 400,
        rows: 60,
        nodes: 50,
        parts: 9,
        ..Sizes::default()
    }
}

fn images_are_finite_and_premultiplied_and_orders_far_to_near() {
    let other = Sizes {
        split_features: true,
        activation: Activation::LeakyRelu,
        subspace: 5,
        basis: 8,
        joints: 25,
        ..Sizes::default()
    };
    let one = Sizes {
        gaussians: 1,
        parts: 1,
        nodes: 1,
        basis: 4,
        joints: 1,
        rows: 1,
        expression: 0,
        hidden: 4,
        ..Sizes::default()
    };
    for (seed, sizes) in (0..).zip([Sizes::default(), other, small(), one]) {
        let (avatar, pose) = body(seed, sizes);
        let posed = Posed::new(&avatar, &pose);
        let stages = ReferenceFrame::new(&avatar, &posed, &camera(seed, [97, 131]));

        assert_eq!(
            stages.features.len(),
            sizes.parts * avatar.networks.output()
        );
        assert_eq!(
            (stages.nodes.len(), stages.splats.len()),
            (sizes.nodes, sizes.gaussians)
        );
        assert!(
            stages.features.iter().all(|e| e.is_finite())
                && stages.nodes.iter().all(|dx| dx.is_finite()),
            "seed {seed}"
        );

        let depth = |k: u32| {
            stages.splats[k as usize]
                .expect("only drawn splats are in the order")
                .depth
        };
        assert!(
            stages
                .order
                .windows(2)
                .all(|w| (depth(w[0]), w[1]) > (depth(w[1]), w[0])),
            "seed {seed}: not far to near"
        );
        let mut drawn = stages.order.clone();
        drawn.sort();
        let expected: Vec<u32> = (0..)
            .zip(&stages.splats)
            .filter(|(_, splat)| splat.is_ok())
            .map(|(k, _)| k)
            .collect();
        assert_eq!(drawn, expected, "seed {seed}");

        for (k, &[r, g, b, a]) in stages.canvas.pixels.iter().enumerate() {
            let valid = [r, g, b].iter().all(|c| (0.0..=a).contains(c)) && (0.0..=1.0).contains(&a);
            assert!(valid, "seed {seed}, pixel {k}: {:?}", [r, g, b, a]);
        }
        assert_eq!(
            reference::render(&avatar, &posed, &camera(seed, [97, 131])),
            stages.canvas.to_image()
        );
    }
}

/// One pixel from all splats, nearest first: what each adds is what those before it let through.
fn pixel(splats: &[Result<Splat, Culled>], at: DVec2) -> [f64; 4] {
    let mut near: Vec<&Splat> = splats.iter().flatten().collect();
    near.reverse();
    near.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    let (mut color, mut through) = (DVec3::ZERO, 1.0);
    for splat in near {
        let (d, [a, b, c]) = (at - splat.center, splat.covariance);
        let distance = (c * d.x * d.x - 2.0 * b * d.x * d.y + a * d.y * d.y) / (a * c - b * b);
        let alpha = (splat.opacity * (-0.5 * distance).exp()).min(0.99);
        if alpha >= 1.0 / 255.0 {
            color += through * alpha * splat.color;
            through *= 1.0 - alpha;
        }
    }
    [color.x, color.y, color.z, 1.0 - through]
}

fn front_to_back_blending_agrees_with_back_to_front() {
    for seed in 0..3 {
        let (avatar, pose) = body(seed, small());
        let stages = ReferenceFrame::new(
            &avatar,
            &Posed::new(&avatar, &pose),
            &camera(seed, [50, 75]),
        );
        let mut covered = 0;
        for (k, got) in stages.canvas.pixels.iter().enumerate() {
            let expected = pixel(
                &stages.splats,
                DVec2::new((k % 50) as f64 + 0.5, (k / 50) as f64 + 0.5),
            );
            let error = (0..4)
                .map(|c| (got[c] - expected[c]).abs())
                .fold(0.0, f64::max);
            assert!(
                error < 1e-10,
                "seed {seed}, pixel {k}: got {got:?}, expected {expected:?}, tolerance 1e-10"
            );
            covered += usize::from(expected[3] > 0.0);
        }
        assert!(covered > 300, "seed {seed}: only {covered} pixels covered");
    }
}

fn moving_body_and_camera_together_leaves_the_image_the_same() {
    let (avatar, mut pose) = body(5, small());
    let camera = camera(1, [60, 60]);
    let still = reference::render(&avatar, &Posed::new(&avatar, &pose), &camera);
    let step = DVec3::new(3.0, -2.0, 7.0);
    pose.translation += step;
    let mut followed = camera;
    followed.view.translation -= camera.view.matrix3 * step;
    let moved = reference::render(&avatar, &Posed::new(&avatar, &pose), &followed);
    assert_ne!(still, FrameImage::empty([60, 60]));
    for (k, (a, b)) in still.pixels.iter().zip(&moved.pixels).enumerate() {
        let error = (0..4).map(|c| (a[c] - b[c]).abs()).fold(0.0, f32::max);
        assert!(
            error < 1e-6,
            "pixel {k}: got {b:?}, expected {a:?}, tolerance 1e-6"
        );
    }
}

fn the_expression_moves_the_head_parts_features_alone() {
    let (avatar, mut pose) = body(2, Sizes::default());
    let before = reference::mlp::features(&avatar, &Posed::new(&avatar, &pose).input);
    pose.expression.iter_mut().for_each(|e| *e += 1.0);
    let after = reference::mlp::features(&avatar, &Posed::new(&avatar, &pose).input);
    let head = avatar.parts.head * avatar.networks.output();
    assert!(
        head > 0 && head < before.len(),
        "the case has a head and a body"
    );
    assert_ne!(before[..head], after[..head]);
    assert_eq!(before[head..], after[head..]);
}

fn the_extent_holds_every_gaussian_and_little_else() {
    for seed in 0..4 {
        let avatar = common::avatar(seed, common::Sizes::default());
        let posed = Posed::new(&avatar, &common::pose(seed, &avatar));
        let camera = Camera::orbit(glam::DVec3::Y, 1.0, 0.3, 3.0, 0.7, [100, 100]);
        let stages = effigy_core::reference::ReferenceFrame::new(&avatar, &posed, &camera);
        let avatar_bounds = effigy_core::scene::AvatarBounds::new(&avatar);
        let [min, max] = avatar_bounds.bounds(&posed.joints);
        let [near, far] = avatar_bounds.depth(&posed.joints, &camera);
        let (mut low, mut high) = (max, min);
        for (k, gaussian) in stages.gaussians.iter().enumerate() {
            let mean = gaussian.mean;
            assert!(
                mean.cmpge(min).all() && mean.cmple(max).all(),
                "seed {seed}: Gaussian {k} at {mean} is outside {min} to {max}"
            );
            let depth = camera.view.transform_point3(mean).z;
            assert!(
                depth >= near && depth <= far,
                "seed {seed}: Gaussian {k} at depth {depth} is outside {near} to {far}"
            );
            low = low.min(mean);
            high = high.max(mean);
        }
        let slack = (max - min) - (high - low);
        assert!(
            slack.max_element() < 0.9,
            "seed {seed}: the box is {slack} larger than what it holds"
        );
    }
}

tests! {
    images_are_finite_and_premultiplied_and_orders_far_to_near,
    front_to_back_blending_agrees_with_back_to_front,
    moving_body_and_camera_together_leaves_the_image_the_same,
    the_expression_moves_the_head_parts_features_alone,
    the_extent_holds_every_gaussian_and_little_else,
}
