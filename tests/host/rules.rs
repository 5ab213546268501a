//! Rules that the kernels share with the reference, which comparing the two can't question: each
//! against what doesn't use it.
//!
//! | rule | held against |
//! |---|---|
//! | culled by place: near plane, box around the ellipse | blending of all at every pixel, below |
//! | derivative of the perspective ends at 1.3 of the field of view | 3DGS' own formula, below |
//! | low-pass, α ≥ 1/255, α ≤ 0.99 | 3DGS' own formulas, below |
//! | centre, depth and order by the mean's z | 3DGS' own formula, below |
//! | what faces away fades out | its definition, below |
//! | deviations end at e⁹ m | what is larger, below |
//! | colours end at 1 before blending, which 3DGS doesn't do | how far that is off, below |
//! | spherical harmonics of the direction in canonical space | the definition, below |
//! | rotation of a cancelled quaternion | numbers by hand, `reference` |
//! | opacity of what stands for several | areas of random Gaussians, `levels` |

use crate::common::{self, Random, plain, wide};
use effigy_core::{
    avatar::{Facing, Filter, Pose},
    reference::{
        self, Gaussian,
        project::{self, Canonical},
    },
    scene::{Camera, FrameImage, Posed},
};
use glam::{DAffine3, DMat3, DQuat, DVec3};

/// The largest difference of a channel.
fn apart(a: &FrameImage, b: &FrameImage) -> f32 {
    let channels = a.pixels.iter().flatten().zip(b.pixels.iter().flatten());
    channels.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

fn gaussian(random: &mut Random) -> Gaussian {
    let deviation = DVec3::from_array(std::array::from_fn(|_| 10f64.powf(random.range(-3.0, 1.0))));
    let turn = DQuat::from_scaled_axis(random.vector(3.0));
    Gaussian {
        mean: random.vector(4.0),
        axes: DMat3::from_quat(turn) * DMat3::from_diagonal(deviation),
        color: 0.5 + random.vector(0.5),
        opacity: random.range(1.0, 255.0) as u8,
        facing: Facing::EVERYWHERE,
    }
}

fn nothing_that_shows_is_culled_by_where_it_is() {
    let random = &mut Random(5);
    for case in 0..60 {
        let gaussians: Vec<Gaussian> = (0..40).map(|_| gaussian(random)).collect();
        let size = [[48, 32], [17, 40], [1, 1]][case % 3];
        let fov = [0.002, 0.05, 0.6, 2.4][case % 4];
        let camera = Camera::look_at(random.vector(5.0), random.vector(1.0), fov, size);
        let expected = plain::render(&gaussians, &camera, Filter::DEFAULT.variance);
        let got = reference::render_gaussians(&gaussians, &camera, Filter::DEFAULT);
        let apart = apart(&got, &expected);
        assert!(apart < 1e-6, "case {case} is off by {apart}");
    }
}

fn a_backdrop_stays_at_every_focal_length() {
    let gaussians = wide::gaussians();
    for focal in wide::FOCAL {
        let camera = wide::camera(focal);
        let expected = plain::render(&gaussians, &camera, Filter::DEFAULT.variance);
        let got = reference::render_gaussians(&gaussians, &camera, Filter::DEFAULT);
        let apart = apart(&got, &expected);
        assert!(apart < 1e-6, "focal length {focal} is off by {apart}");
        let covered = expected.pixels.iter().filter(|pixel| pixel[3] > 0.5);
        assert!(
            covered.count() * 10 >= 9 * expected.pixels.len(),
            "no backdrop is left at focal length {focal}"
        );
    }
}

/// A Gaussian of a position, a deviation and a colour.
fn round(canonical: DVec3, deviation: f64, color: DVec3) -> Gaussian {
    project::pose(
        &Canonical {
            position: canonical,
            neutral_rotation: [1.0, 0.0, 0.0, 0.0],
            rotation_corrective: [0.0; 4],
            log_scale: DVec3::splat(deviation.ln()),
            color,
        },
        &DAffine3::IDENTITY,
        200,
    )
}

fn a_gaussian_of_more_than_eight_kilometres_shows_as_one_of_eight() {
    let place = DVec3::new(20.0, -30.0, 60.0);
    let true_deviation = 3.0 * 9f64.exp();
    let got = round(place, true_deviation, DVec3::splat(0.7));
    let expected = Gaussian {
        axes: DMat3::from_diagonal(DVec3::splat(true_deviation)),
        ..got
    };
    let camera = Camera::look_at(DVec3::ZERO, DVec3::Z, 1.2, [24, 24]);
    let apart = apart(
        &reference::render_gaussians(&[got], &camera, Filter::DEFAULT),
        &plain::render(&[expected], &camera, Filter::DEFAULT.variance),
    );
    assert!(apart < 0.5 / 255.0, "off by {apart}");
}

/// A cone of directions: nothing shows where the cosine is at its limit or below, all from an eighth
/// above it on, and in between as much as the cosine says, whichever way camera and Gaussian turn.
fn what_faces_away_fades_out() {
    let random = &mut Random(3);
    for share in [-1.0, -0.01, 0.25, 0.5, 1.0, 3.0] {
        let axis = random.vector(1.0).normalize();
        let across = axis.any_orthonormal_vector();
        let limit = random.range(-0.5, 0.5);
        let cosine: f64 = limit + 0.125 * share;
        let mean = random.vector(5.0);
        let eye = mean + 3.0 * (cosine * axis + (1.0 - cosine * cosine).sqrt() * across);
        let got = Gaussian {
            mean,
            facing: Facing {
                axis: 0.7 * axis,
                limit,
            },
            ..round(DVec3::ZERO, 0.1, DVec3::new(0.9, 0.5, 0.2))
        };
        let expected = Gaussian {
            opacity: (200.0 * share.clamp(0.0, 1.0)) as u8,
            facing: Facing::EVERYWHERE,
            ..got
        };
        let camera = Camera::look_at(eye, mean, 0.6, [24, 24]);
        let apart = apart(
            &reference::render_gaussians(&[got], &camera, Filter::DEFAULT),
            &plain::render(&[expected], &camera, Filter::DEFAULT.variance),
        );
        assert!(apart < 1e-6, "{share}: off by {apart}");
    }
}

/// 3DGS blends colours above 1 as they are. What that changes is at most what they exceed 1 by.
fn colours_above_one_are_drawn_as_one() {
    let color = DVec3::new(1.25, 0.5, -0.25);
    let got = round(DVec3::Z, 0.1, color);
    assert_eq!(got.color, DVec3::new(1.0, 0.5, 0.0));
    // 3DGS has no negative colours either.
    let expected = Gaussian {
        color: color.max(DVec3::ZERO),
        ..got
    };
    let camera = Camera::look_at(DVec3::ZERO, DVec3::Z, 0.6, [24, 24]);
    let apart = apart(
        &reference::render_gaussians(&[got], &camera, Filter::DEFAULT),
        &plain::render(&[expected], &camera, Filter::DEFAULT.variance),
    );
    let most = 0.25 * 200.0 / 255.0;
    assert!((0.95 * most..=most).contains(&apart), "{apart} of {most}");
}

/// Of degree 1: ½ + C₀ c₀ + C₁ (−y c₁ + z c₂ − x c₃), of the direction from the camera in the file's
/// space, wherever the scene stands.
fn harmonics_see_the_direction_from_the_camera() {
    let splats = common::splats(3, 50, 1);
    let avatar = splats.to_avatar("harmonics").unwrap();
    let turn = DQuat::from_rotation_y(0.7) * DQuat::from_rotation_x(0.3);
    let place = DAffine3::from_rotation_translation(turn, DVec3::new(0.4, -0.2, 0.1));
    let posed = Posed::new(&avatar, &Pose::rest(avatar.skeleton.len(), 0)).placed(place);
    let camera = Camera::look_at(DVec3::new(1.5, 0.5, 2.0), DVec3::ZERO, 0.6, [8, 8]);
    let got = reference::gaussians_of(&avatar, &[&posed], &camera);
    let eye = turn.inverse() * (camera.eye() - DVec3::new(0.4, -0.2, 0.1));
    let vector = |v: [f32; 3]| DVec3::from(v.map(f64::from));
    let expected = |k: usize| {
        let DVec3 { x, y, z } = (vector(splats.position[k]) - eye).normalize();
        let of = |function: usize| vector(splats.harmonics[3 * k + function]);
        let sum = 0.282_094_791_773_878_14 * vector(splats.color[k])
            + 0.488_602_511_902_919_9 * (-y * of(0) + z * of(1) - x * of(2));
        (sum + 0.5).clamp(DVec3::ZERO, DVec3::ONE)
    };
    // Gaussians come in another order: each is near one of those that the file has.
    for gaussian in &got {
        let at = turn.inverse() * (gaussian.mean - DVec3::new(0.4, -0.2, 0.1));
        let k = (0..splats.len())
            .min_by(|&a, &b| {
                let [a, b] = [a, b].map(|k| vector(splats.position[k]).distance(at));
                a.total_cmp(&b)
            })
            .unwrap();
        let apart = (gaussian.color - expected(k)).abs().max_element();
        assert!(apart < 2e-3, "splat {k} is off by {apart}");
    }
}

tests! {
    nothing_that_shows_is_culled_by_where_it_is,
    a_backdrop_stays_at_every_focal_length,
    a_gaussian_of_more_than_eight_kilometres_shows_as_one_of_eight,
    what_faces_away_fades_out,
    colours_above_one_are_drawn_as_one,
    harmonics_see_the_direction_from_the_camera,
}
