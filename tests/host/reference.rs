//! The f64 reference against cases worked out by hand: everything else is compared with the
//! reference, so it is compared with paper.

use effigy_core::avatar::*;
use effigy_core::reference::{Culled, Gaussian, ReferenceFrame, mlp, nodes, project, raster};
use effigy_core::{
    constants::{ALPHA_MAX, ALPHA_MIN, LOW_PASS},
    scene::{Camera, Posed},
};
use glam::{DAffine3, DMat2, DMat3, DQuat, DVec2, DVec3};
use half::f16;
use std::f64::consts::PI;

/// A Gaussian of an avatar made by hand.
#[derive(Clone, Copy)]
struct Dot {
    at: [f64; 3],
    rotation: [f64; 4],
    log_scale: [f64; 3],
    color: [f64; 3],
    opacity: u8,
}

const DOT: Dot = Dot {
    at: [0.0; 3],
    rotation: [1.0, 0.0, 0.0, 0.0],
    log_scale: [-2.5; 3],
    color: [1.0, 0.5, 0.25],
    opacity: 204,
};

fn half<const N: usize>(v: [f64; N]) -> [f16; N] {
    v.map(f16::from_f64)
}

fn halves(v: &[f64]) -> Vec<f16> {
    v.iter().copied().map(f16::from_f64).collect()
}

/// One joint, one part, one node at the origin that moves nothing, one feature that is always 1;
/// steps of 2⁻¹⁵ m in ±1 m.
fn avatar(dots: &[Dot]) -> Avatar {
    let bounds = Bounds {
        min: [-1.0; 3],
        max: [1.0 - 1.0 / 32768.0; 3],
    };
    Avatar {
        name: "by hand".into(),
        credit: String::new(),
        filter: Filter::DEFAULT,
        skeleton: Skeleton {
            name: vec!["root".into()],
            parent: vec![None],
            rest: vec![[0.0; 3]],
            canonical: vec![[0.0; 3]],
        },
        gaussians: Gaussians {
            bounds,
            position: dots
                .iter()
                .map(|dot| bounds.encode(DVec3::from(dot.at)))
                .collect(),
            rotation: dots.iter().map(|dot| half(dot.rotation)).collect(),
            log_scale: dots.iter().map(|dot| half(dot.log_scale)).collect(),
            color: dots.iter().map(|dot| half(dot.color)).collect(),
            opacity: dots.iter().map(|dot| dot.opacity).collect(),
            joint: vec![[0; 4]; dots.len()],
            joint_weight: vec![[255, 0, 0, 0]; dots.len()],
            node: vec![[0; 3]; dots.len()],
            facing: vec![],
        },
        parts: Parts {
            start: vec![0, dots.len() as u32],
            head: 0,
        },
        networks: Networks {
            activation: Activation::Relu,
            layers: vec![layer(1, 1, &[0.0], &[1.0])],
        },
        rotation_rows: Rows::default(),
        scale_rows: Rows::default(),
        color_rows: Rows::default(),
        nodes: Nodes {
            position: vec![bounds.encode(DVec3::ZERO)],
            part: vec![0],
            offset: vec![half([0.0; 3])],
            basis: halves(&[0.0; 3]).into(),
        },
        inputs: Inputs {
            joint: vec![],
            expression: 1,
            pose_space: None,
            expression_space: None,
        },
        sh: None,
        levels: vec![],
    }
}

fn layer(input: usize, output: usize, weight: &[f64], bias: &[f64]) -> NetworkLayer {
    NetworkLayer {
        input,
        output,
        weight: halves(weight).into(),
        bias: halves(bias),
    }
}

/// Two metres from the origin along +z, not turned: camera x, y and z are the world's. Pixel 32, 32
/// has the origin at its centre.
fn camera() -> Camera {
    let view = DAffine3::from_translation(DVec3::new(0.0, 0.0, 2.0));
    Camera {
        view,
        focal: DVec2::splat(100.0),
        center: DVec2::splat(32.5),
        size: [65, 65],
        near: Camera::NEAR,
    }
}

fn at_rest(avatar: &Avatar) -> Posed {
    Posed::new(
        avatar,
        &Pose::rest(avatar.skeleton.len(), avatar.inputs.expression),
    )
}

fn stages(dots: &[Dot]) -> ReferenceFrame {
    let avatar = avatar(dots);
    ReferenceFrame::new(&avatar, &at_rest(&avatar), &camera())
}

/// The Gaussians of an avatar in its rest pose.
fn gaussians(avatar: &Avatar) -> Vec<Gaussian> {
    let posed = at_rest(avatar);
    let features = mlp::features(avatar, &posed.input);
    project::gaussians(avatar, &posed, &features, &nodes::nodes(avatar, &features))
}

#[track_caller]
fn near(got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(got.len(), expected.len(), "lengths");
    for (k, (got, expected)) in got.iter().zip(expected).enumerate() {
        assert!(
            (got - expected).abs() <= tolerance,
            "at {k}: got {got}, expected {expected}, tolerance {tolerance:e}"
        );
    }
}

fn one_gaussian_is_its_closed_form_at_every_pixel() {
    let image = stages(&[DOT]).canvas;
    let variance = (100.0 * (-2.5f64).exp() / 2.0).powi(2) + 0.3;
    let mut drawn = 0;
    for (k, pixel) in image.pixels.iter().enumerate() {
        let (x, y) = ((k % 65) as f64 - 32.0, (k / 65) as f64 - 32.0);
        let alpha = 0.8 * (-0.5 * (x * x + y * y) / variance).exp();
        let alpha = if alpha < 1.0 / 255.0 { 0.0 } else { alpha };
        drawn += usize::from(alpha > 0.0);
        near(pixel, &[alpha, 0.5 * alpha, 0.25 * alpha, alpha], 1e-12);
    }
    assert!(drawn > 500 && drawn < 1000, "{drawn} pixels drawn");
}

fn alpha_stops_at_99_percent() {
    assert_eq!(
        stages(&[Dot {
            opacity: 255,
            ..DOT
        }])
        .canvas
        .pixels[32 * 65 + 32][3],
        ALPHA_MAX
    );
}

fn the_nearer_of_two_gaussians_is_over_the_further_whatever_their_order() {
    let front = Dot {
        at: [0.0, 0.0, -0.25],
        color: [1.0, 0.0, 0.0],
        opacity: 102,
        ..DOT
    };
    let back = Dot {
        at: [0.0, 0.0, 0.25],
        color: [0.0, 0.0, 1.0],
        opacity: 204,
        ..DOT
    };
    for (dots, order) in [([front, back], [1, 0]), ([back, front], [0, 1])] {
        let stages = stages(&dots);
        assert_eq!(stages.order, order);
        near(
            &stages.canvas.pixels[32 * 65 + 32],
            &[0.4, 0.0, 0.6 * 0.8, 1.0 - 0.6 * 0.2],
            1e-12,
        );
    }
}

fn a_contribution_is_the_squared_change_by_a_gaussians_colour() {
    let dots = [
        Dot {
            at: [0.02, 0.0, 0.1],
            ..DOT
        },
        Dot {
            opacity: 120,
            ..DOT
        },
    ];
    let ReferenceFrame {
        splats,
        order,
        canvas,
        ..
    } = stages(&dots);
    let shown = raster::contributions(&splats, &order, &camera());
    for (k, shown) in shown.iter().enumerate() {
        let mut other = splats.clone();
        other[k].as_mut().expect("it is drawn").color += DVec3::splat(0.01);
        let changed = raster::raster(&other, &order, &camera());
        let error: f64 = changed
            .pixels
            .iter()
            .zip(&canvas.pixels)
            .map(|(a, b)| (a[0] - b[0]).powi(2))
            .sum();
        near(&[error * 1e4], &[*shown], 1e-9 * shown);
        assert!(*shown > 1.0, "{shown}");
    }
}

fn gaussians_of_one_depth_are_drawn_in_index_order() {
    let far = Dot {
        at: [0.0, 0.0, 0.5],
        ..DOT
    };
    let hidden = Dot { opacity: 0, ..DOT };
    assert_eq!(stages(&[DOT, hidden, DOT, far, DOT]).order, [3, 0, 2, 4]);
}

/// The derivative of the image coordinates of a point in camera coordinates, by central
/// differences.
fn derivative(camera: &Camera, t: DVec3) -> [DVec3; 2] {
    let step = 1e-5;
    let columns = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| {
        (camera.project(t + step * axis) - camera.project(t - step * axis)) / (2.0 * step)
    });
    [
        DVec3::from(columns.map(|c| c.x)),
        DVec3::from(columns.map(|c| c.y)),
    ]
}

fn covariance_projects_by_the_derivative_of_the_projection() {
    let camera = Camera::orbit(DVec3::new(0.1, 0.2, 0.0), 0.7, 0.3, 2.0, 0.8, [640, 480]);
    let dot = Dot {
        at: [0.25, -0.125, 0.5],
        rotation: [0.5, -0.25, 0.75, 1.0],
        log_scale: [-2.0, -3.0, -5.0],
        ..DOT
    };
    let [gaussian] = gaussians(&avatar(&[dot]))[..] else {
        panic!("one Gaussian")
    };
    let q = DQuat::from_xyzw(-0.25, 0.75, 1.0, 0.5).normalize();
    let axes = DMat3::from_cols(
        q * DVec3::X * (-2f64).exp(),
        q * DVec3::Y * (-3f64).exp(),
        q * DVec3::Z * (-5f64).exp(),
    );
    let world = axes * axes.transpose();
    near(
        &gaussian.covariance().to_cols_array(),
        &world.to_cols_array(),
        1e-12,
    );

    let splat = project::project(&gaussian, &camera, Filter::DEFAULT, 0).expect("in view");
    let t = camera.view.transform_point3(DVec3::from(dot.at));
    near(
        &[splat.center.x, splat.center.y, splat.depth],
        &[camera.project(t).x, camera.project(t).y, t.z],
        1e-9,
    );
    let [x, y] = derivative(&camera, t).map(|row| camera.view.matrix3.transpose() * row);
    let expected = [
        x.dot(world * x) + LOW_PASS,
        x.dot(world * y),
        y.dot(world * y) + LOW_PASS,
    ];
    near(&splat.covariance, &expected, 1e-4);
    assert!(
        splat.covariance[1].abs() > 10.0,
        "the case is turned: {:?}",
        splat.covariance
    );

    // On the border of the box that the avatar_bounds spans, alpha peaks at 1/255.
    let [a, b, c] = splat.covariance;
    let touch = DVec2::new(splat.radius.x, b / a * splat.radius.x);
    let power = -0.5 * touch.dot(DMat2::from_cols_array(&[a, b, b, c]).inverse() * touch);
    near(
        &[splat.opacity * power.exp(), splat.radius.y / splat.radius.x],
        &[ALPHA_MIN, (c / a).sqrt()],
        1e-9,
    );
}

fn compensation_keeps_what_a_small_gaussian_covers() {
    // 0.337 px of deviation along one axis, 0.124 along the other.
    let dot = Dot {
        rotation: [0.9, 0.1, -0.2, 0.5],
        log_scale: [-5.0, -6.0, -6.0],
        ..DOT
    };
    let drawn = |variance: f64, compensated: bool| {
        let mut avatar = avatar(&[dot]);
        avatar.filter = Filter {
            variance,
            compensated,
        };
        ReferenceFrame::new(&avatar, &at_rest(&avatar), &camera())
    };
    let plain = drawn(0.3, false).splats[0].expect("in view");
    let [a, b, c] = plain.covariance;
    let area = ((a - 0.3) * (c - 0.3) - b * b).sqrt();
    assert!((0.02..0.2).contains(&area), "{area} px²");
    for variance in [0.1, 0.3, 1.0, 3.0] {
        let splat = drawn(variance, true).splats[0].expect("in view");
        let [x, y, z] = splat.covariance;
        near(
            &[x - variance, y, z - variance],
            &[a - 0.3, b, c - 0.3],
            1e-12,
        );
        // The integral of the Gaussian over the image is 2π o √det Σ.
        near(
            &[splat.opacity * splat.determinant.sqrt()],
            &[0.8 * area],
            1e-9,
        );
        // On the border of its box alpha is 1/255 still.
        let sigmas = splat.radius.x / x.sqrt();
        near(
            &[splat.opacity * (-0.5 * sigmas * sigmas).exp()],
            &[ALPHA_MIN],
            1e-9,
        );
        let uncompensated = drawn(variance, false).splats[0].expect("in view");
        assert_eq!(uncompensated.covariance, splat.covariance);
        assert_eq!(uncompensated.opacity, 0.8);
    }
    // In pixels: what lies above 1/255 is 1 − (1/255) / (its largest alpha) of the integral.
    let frame = drawn(0.5, true);
    let splat = frame.splats[0].expect("in view");
    let covered: f64 = frame.canvas.pixels.iter().map(|pixel| pixel[3]).sum();
    let expected = 2.0 * PI * 0.8 * area * (1.0 - ALPHA_MIN / splat.opacity);
    assert!(
        (covered / expected - 1.0).abs() < 0.03,
        "{covered} px are covered, {expected} were expected"
    );
}

fn what_compensation_leaves_of_a_gaussian_may_be_too_faint() {
    let culled = |log_scale: f64, opacity: u8| {
        let dot = Dot {
            log_scale: [log_scale; 3],
            opacity,
            ..DOT
        };
        let mut avatar = avatar(&[dot]);
        avatar.filter.compensated = true;
        ReferenceFrame::new(&avatar, &at_rest(&avatar), &camera()).splats[0].err()
    };
    // Of a deviation of s px, s² / (s² + 0.3) are left: with 0.0337 px 0.0038, with 0.05 px 0.0083.
    let pixels = |deviation: f64| (deviation / 50.0).ln();
    assert_eq!(culled(pixels(0.05), 255), None);
    assert_eq!(culled(pixels(0.05), 100), Some(Culled::Faint));
    assert_eq!(culled(pixels(0.03), 255), Some(Culled::Faint));
    assert_eq!(culled(f64::NEG_INFINITY, 255), Some(Culled::Faint));
    assert_eq!(culled(pixels(5.0), 2), None);
}

fn a_level_of_detail_is_compensated_alike() {
    let dot = Dot {
        log_scale: [-5.0; 3],
        ..DOT
    };
    let mut avatar = avatar(&[dot]);
    let opacity = |avatar: &Avatar, level| {
        let frame = ReferenceFrame::at_level(avatar, &at_rest(avatar), &camera(), level);
        frame.splats[0].expect("in view").opacity
    };
    let plain = [0, 3].map(|level| opacity(&avatar, level));
    avatar.filter.compensated = true;
    let compensated = [0, 3].map(|level| opacity(&avatar, level));
    near(
        &[compensated[0] / plain[0]],
        &[compensated[1] / plain[1]],
        1e-12,
    );
    assert!(compensated[0] < 0.5 * plain[0]);
}

fn beside_the_image_the_derivative_is_taken_at_its_limit() {
    // x/z = 0.5 here; the image ends at 0.325, and the limit is 0.3 of that further out.
    let dot = Dot {
        at: [0.75, 0.0, -0.5],
        log_scale: [-1.0; 3],
        ..DOT
    };
    let splat = stages(&[dot]).splats[0].expect("its box reaches the image");
    assert_eq!(splat.center.x, 32.5 + 50.0);
    let [x, y] = derivative(&camera(), DVec3::new(1.3 * 0.325 * 1.5, 0.0, 1.5));
    let variance = (-2f64).exp();
    near(
        &splat.covariance,
        &[variance * x.dot(x) + 0.3, 0.0, variance * y.dot(y) + 0.3],
        1e-4,
    );
}

fn every_reason_to_cull_is_reported() {
    let reason = |dot: Dot| stages(&[dot]).splats[0].err();
    let at = |x: f64, z: f64| Dot {
        at: [x, 0.0, z],
        log_scale: [-5.0; 3],
        ..DOT
    };
    assert_eq!(reason(at(0.0, 0.0)), None);
    assert_eq!(reason(Dot { opacity: 1, ..DOT }), Some(Culled::Faint));
    assert_eq!(reason(Dot { opacity: 2, ..DOT }), None);
    // 0.337 px of deviation reach 1 px beyond a centre that is 0.5 px outside, and not beyond one
    // that is 5 px outside.
    assert_eq!(reason(at(0.66, 0.0)), None);
    assert_eq!(reason(at(-0.75, 0.0)), Some(Culled::Outside));
    // However far outside the image its centre is, here more than its longer side: what shows is
    // not culled, and what doesn't is.
    let aside = |x, log_scale| {
        reason(Dot {
            log_scale: [log_scale; 3],
            ..at(x, -0.99)
        })
    };
    for x in [0.99, -0.99] {
        assert_eq!(aside(x, 1.0), None, "{x} m");
        assert_eq!(aside(x, -3.0), Some(Culled::Outside), "{x} m");
    }
    assert_eq!(
        reason(Dot {
            log_scale: [f64::INFINITY, 0.0, 0.0],
            ..DOT
        }),
        None,
        "scales end at 8 km"
    );
    assert_eq!(
        reason(Dot {
            color: [f64::NAN, 0.0, 0.0],
            ..DOT
        }),
        Some(Culled::Invalid)
    );
    assert_eq!(
        reason(Dot {
            rotation: [0.0; 4],
            ..DOT
        }),
        Some(Culled::Invalid)
    );

    let gaussian = gaussians(&avatar(&[DOT]))[0];
    let moved = |z| {
        project::project(
            &Gaussian {
                mean: DVec3::new(0.0, 0.0, z),
                ..gaussian
            },
            &camera(),
            Filter::DEFAULT,
            0,
        )
        .err()
    };
    assert_eq!(
        [moved(-1.91), moved(-1.89), moved(-3.0)],
        [Some(Culled::Behind), None, Some(Culled::Behind)]
    );
    assert_eq!(
        [moved(f64::NAN), moved(f64::INFINITY)],
        [Some(Culled::Invalid); 2]
    );
}

fn two_joints_blend_their_matrices() {
    let mut avatar = avatar(&[Dot {
        at: [0.75, 0.0, 0.0],
        ..DOT
    }]);
    avatar.skeleton = Skeleton {
        name: vec!["shoulder".into(), "elbow".into()],
        parent: vec![None, Some(0)],
        rest: vec![[0.0; 3], [0.5, 0.0, 0.0]],
        canonical: vec![[0.0; 3]; 2],
    };
    avatar.gaussians.joint[0] = [1, 0, 0, 1];
    avatar.gaussians.joint_weight[0] = [102, 102, 0, 51];
    let mut pose = Pose::rest(2, 1);
    pose.rotation[1] = DVec3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2);
    let gaussian =
        ReferenceFrame::new(&avatar, &Posed::new(&avatar, &pose), &camera()).gaussians[0];
    // The elbow, with weight 0.6, takes the point to (0.5, 0.25, 0); the shoulder leaves it.
    near(
        &gaussian.mean.to_array(),
        &[0.4 * 0.75 + 0.6 * 0.5, 0.6 * 0.25, 0.0],
        1e-9,
    );
    // G = 0.4 + 0.6 turn, so G Gᵀ = 0.52 across the axis: blending shrinks, and nothing undoes it.
    let variance = (-5f64).exp();
    near(
        &gaussian.covariance().to_cols_array(),
        &[0.52, 0.0, 0.0, 0.0, 0.52, 0.0, 0.0, 0.0, 1.0].map(|v| v * variance),
        1e-12,
    );
}

/// Two parts, the first a head part, that see one joint and one number of expression.
fn two_parts(layers: Vec<NetworkLayer>, activation: Activation) -> Avatar {
    let mut avatar = avatar(&[DOT, DOT]);
    avatar.parts = Parts {
        start: vec![0, 1, 2],
        head: 1,
    };
    avatar.networks = Networks { activation, layers };
    avatar.inputs.joint = vec![0];
    avatar
}

fn a_single_layer_is_linear_and_only_the_head_sees_the_expression() {
    let weight = [
        1.0, 2.0, 3.0, 4.0, 0.5, 0.0, -1.0, 8.0, -1.0, -2.0, -3.0, -4.0, 0.0, 0.0, 1.0, 8.0,
    ];
    let avatar = two_parts(
        vec![layer(4, 2, &weight, &[0.5, -0.5, 0.0, 1.0])],
        Activation::Relu,
    );
    let e = mlp::features(&avatar, &[1.0, -1.0, 2.0, 0.25]);
    near(
        &e,
        &[
            1.0 - 2.0 + 6.0 + 1.0 + 0.5,
            -0.5 + 0.5 - 2.0 + 2.0,
            -1.0 + 2.0 - 6.0,
            2.0 + 1.0,
        ],
        0.0,
    );
}

fn hidden_layers_are_followed_by_their_activation_and_the_last_is_not() {
    let hidden = layer(
        4,
        2,
        &[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0].repeat(2),
        &[0.0, 1.0, 0.0, 1.0],
    );
    let last = layer(2, 1, &[1.0, 10.0, -1.0, -10.0], &[0.5, 0.0]);
    // Before the activation the hidden layer is (−2, 3).
    for (activation, expected) in [
        (Activation::Relu, [30.5, -30.0]),
        (Activation::LeakyRelu, [30.48, -29.98]),
    ] {
        let avatar = two_parts(vec![hidden.clone(), last.clone()], activation);
        near(
            &mlp::features(&avatar, &[-2.0, 2.0, 0.0, 0.0]),
            &expected,
            1e-12,
        );
    }
}

fn a_gaussian_follows_its_three_nodes_by_inverse_distance() {
    let mut avatar = avatar(&[
        DOT,
        Dot {
            at: [0.125, 0.0, 0.0],
            ..DOT
        },
    ]);
    let place = |x: f64| avatar.gaussians.bounds.encode(DVec3::new(x, 0.0, 0.0));
    avatar.nodes = Nodes {
        position: vec![place(0.125), place(-0.25), place(0.5)],
        part: vec![0, 1, 0],
        offset: vec![
            half([0.25, 0.0, 0.0]),
            half([0.0; 3]),
            half([0.0, 0.0, 0.5]),
        ],
        // Nodes use the second half of the features, which is 2 in the second part.
        basis: halves(&[0.0, 0.0, 0.0, 0.0, 0.25, 0.0, 0.0, 0.0, 0.0]).into(),
    };
    avatar.parts.start = vec![0, 2, 2];
    avatar.networks.layers = vec![layer(1, 2, &[0.0; 4], &[1.0, 5.0, 1.0, 2.0])];
    avatar.gaussians.node = vec![[0, 1, 2]; 2];
    // Distances 1/8, 1/4, 1/2: weights 4/7, 2/7, 1/7. The node at the second Gaussian has a million
    // times the others' weight.
    let means = gaussians(&avatar);
    near(
        &means[0].mean.to_array(),
        &[4.0 / 7.0 * 0.25, 2.0 / 7.0 * 0.5, 1.0 / 7.0 * 0.5],
        1e-9,
    );
    near(&means[1].mean.to_array(), &[0.375, 0.0, 0.0], 1e-5);
}

fn correctives_follow_their_parts_features_before_colour_clamps() {
    let mut avatar = avatar(&[DOT; 3]);
    // The middle one of three parts is empty.
    avatar.parts.start = vec![0, 1, 1, 3];
    avatar.networks.layers = vec![layer(1, 1, &[0.0; 3], &[2.0, 7.0, -2.0])];
    avatar.rotation_rows = Rows {
        gaussian: vec![1],
        basis: halves(&[0.5, 0.0, 0.0, -4.0]).into(),
    };
    avatar.scale_rows = Rows {
        gaussian: vec![0, 2],
        basis: halves(&[0.5, 0.0, 0.0, 0.0, 0.0, -0.25]).into(),
    };
    avatar.color_rows = Rows {
        gaussian: vec![0, 1],
        basis: halves(&[0.5, 0.125, -0.25, 0.0, 0.0, -0.25]).into(),
    };
    let [first, second, third] = gaussians(&avatar)[..] else {
        panic!("three Gaussians")
    };
    let s = (-2.5f64).exp();
    near(
        &first.axes.to_cols_array(),
        DMat3::from_diagonal(DVec3::new((-1.5f64).exp(), s, s)).as_ref(),
        1e-12,
    );
    // The quaternion becomes (0, 0, 0, 8), normalised half a turn about z.
    near(
        &second.axes.to_cols_array(),
        DMat3::from_diagonal(DVec3::new(-s, -s, s)).as_ref(),
        1e-12,
    );
    near(
        &third.axes.to_cols_array(),
        DMat3::from_diagonal(DVec3::new(s, s, (-2f64).exp())).as_ref(),
        1e-12,
    );
    near(&first.color.to_array(), &[1.0, 0.75, 0.0], 0.0);
    near(&second.color.to_array(), &[1.0, 0.5, 0.75], 0.0);
    near(&third.color.to_array(), &DOT.color, 0.0);
}

tests! {
    one_gaussian_is_its_closed_form_at_every_pixel,
    alpha_stops_at_99_percent,
    the_nearer_of_two_gaussians_is_over_the_further_whatever_their_order,
    a_contribution_is_the_squared_change_by_a_gaussians_colour,
    gaussians_of_one_depth_are_drawn_in_index_order,
    covariance_projects_by_the_derivative_of_the_projection,
    compensation_keeps_what_a_small_gaussian_covers,
    what_compensation_leaves_of_a_gaussian_may_be_too_faint,
    a_level_of_detail_is_compensated_alike,
    beside_the_image_the_derivative_is_taken_at_its_limit,
    every_reason_to_cull_is_reported,
    two_joints_blend_their_matrices,
    a_single_layer_is_linear_and_only_the_head_sees_the_expression,
    hidden_layers_are_followed_by_their_activation_and_the_last_is_not,
    a_gaussian_follows_its_three_nodes_by_inverse_distance,
    correctives_follow_their_parts_features_before_colour_clamps,
}
