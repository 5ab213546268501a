//! Wild poses: what the projection onto the training poses is worth (model.md, step 0). Networks
//! that extrapolate are shown joints bent far beyond any pose that they know; with the projection
//! on, what comes of it stays within what poses that they know make of it.

use crate::common::{self, Random, Sizes};
use effigy_core::{
    avatar::{Avatar, Pose, Subspace, motion::Player},
    reference::{self, mlp, nodes},
    scene::{AvatarBounds, Camera, Posed},
};
use effigy_measure::error;
use glam::DVec3;
use std::f64::consts::PI;

/// A pose with all joints but the root turned by up to half a turn around any axis.
fn wild(seed: u64, avatar: &Avatar) -> Pose {
    let random = &mut Random(seed);
    let mut turn = |joint: usize| {
        if joint == 0 {
            DVec3::ZERO
        } else {
            random.vector(1.0).normalize() * random.range(0.6 * PI, PI)
        }
    };
    let rotation = (0..avatar.skeleton.len()).map(&mut turn).collect();
    Pose {
        rotation,
        ..Pose::rest(0, avatar.inputs.expression)
    }
}

/// Where in a space a point is, in σ along each component.
fn coordinates(space: &Subspace, x: &[f64]) -> Vec<f64> {
    let length = space.mean.len();
    let along = |(component, &sigma): (&[f32], &f32)| {
        let dot: f64 = component
            .iter()
            .zip(x)
            .zip(&space.mean)
            .map(|((&c, x), &m)| f64::from(c) * (x - f64::from(m)))
            .sum();
        dot / f64::from(sigma)
    };
    space
        .component
        .chunks_exact(length)
        .zip(&space.sigma)
        .map(along)
        .collect()
}

/// The inputs of a grid over the box of ±2σ that training poses fill, `steps` along each of three
/// components; the expression is at rest.
fn training(avatar: &Avatar, steps: usize) -> Vec<Vec<f64>> {
    let space = avatar.inputs.pose_space.as_ref().unwrap();
    let rest = avatar
        .inputs
        .from_pose(&Pose::rest(avatar.skeleton.len(), 0));
    let (length, expression) = (space.mean.len(), &rest[space.mean.len()..]);
    let point = |at: [usize; 3]| {
        let mut x: Vec<f64> = space.mean.iter().map(|&m| f64::from(m)).collect();
        for (k, component) in space.component.chunks_exact(length).enumerate() {
            let along = f64::from(space.sigma[k]) * (4.0 * at[k] as f64 / (steps - 1) as f64 - 2.0);
            x.iter_mut()
                .zip(component)
                .for_each(|(x, &c)| *x += along * f64::from(c));
        }
        [&x, expression].concat()
    };
    (0..steps.pow(3))
        .map(|at| point([at % steps, at / steps % steps, at / steps / steps]))
        .collect()
}

/// Smallest and largest of each number of some vectors.
fn range(all: impl Iterator<Item = Vec<f64>>) -> Vec<[f64; 2]> {
    let mut range: Vec<[f64; 2]> = vec![];
    for vector in all {
        range.resize(vector.len(), [f64::INFINITY, f64::NEG_INFINITY]);
        range
            .iter_mut()
            .zip(&vector)
            .for_each(|([low, high], v)| (*low, *high) = (low.min(*v), high.max(*v)));
    }
    range
}

/// How far a vector is outside of a range, in widths of the range: the most of its numbers.
fn outside(range: &[[f64; 2]], vector: &[f64]) -> f64 {
    let beyond =
        |([low, high], v): (&[f64; 2], &f64)| (low - v).max(v - high) / (high - low).max(1e-3);
    range.iter().zip(vector).map(beyond).fold(0.0, f64::max)
}

fn displacements(avatar: &Avatar, input: &[f64]) -> Vec<f64> {
    nodes::nodes(avatar, &mlp::features(avatar, input))
        .iter()
        .map(|node| node.length())
        .collect()
}

fn the_networks_see_wild_poses_within_two_sigma() {
    let avatar = effigy_demo::avatar().unwrap();
    let space = avatar.inputs.pose_space.as_ref().unwrap();
    for seed in 0..20 {
        let pose = wild(seed, &avatar);
        let [on, off] =
            [true, false].map(|project| Posed::with_projection(&avatar, &pose, project).input);
        let [inside, raw] = [&on, &off].map(|input| coordinates(space, &input[..space.mean.len()]));
        assert!(inside.iter().all(|c| c.abs() <= 2.0 + 1e-4), "{inside:?}");
        assert!(
            raw.iter().any(|c| c.abs() > 6.0),
            "the pose is not wild: {raw:?}"
        );
        // The skeleton follows the pose as it is.
        assert_eq!(
            Posed::with_projection(&avatar, &pose, true).joints,
            Posed::with_projection(&avatar, &pose, false).joints
        );
        // What is known is seen as it is.
        assert!(
            avatar
                .inputs
                .pose_space
                .as_ref()
                .unwrap()
                .project(&on[..space.mean.len()])
                .iter()
                .zip(&on)
                .all(|(a, b)| (a - b).abs() < 1e-4)
        );
    }
}

fn correctives_stay_within_those_of_known_poses() {
    let avatar = common::avatar(
        3,
        Sizes {
            gaussians: 600,
            parts: 12,
            nodes: 80,
            subspace: 3,
            expression: 0,
            ..Sizes::default()
        },
    );
    let known = training(&avatar, 9);
    let e = |input: &[f64]| mlp::features(&avatar, input);
    let (feature_range, node_range) = (
        range(known.iter().map(|input| e(input))),
        range(known.iter().map(|input| displacements(&avatar, input))),
    );
    let mut escaped = 0;
    for seed in 0..40 {
        let [on, off] = [true, false]
            .map(|project| Posed::with_projection(&avatar, &wild(seed, &avatar), project).input);
        // Between the points of the grid a network may reach a little further than at them.
        assert!(
            outside(&feature_range, &e(&on)) < 0.1,
            "features are {} of their range outside",
            outside(&feature_range, &e(&on))
        );
        assert!(
            outside(&node_range, &displacements(&avatar, &on)) < 0.1,
            "nodes are outside of their range"
        );
        escaped += usize::from(
            outside(&feature_range, &e(&off)) > 1.0
                && outside(&node_range, &displacements(&avatar, &off)) > 0.5,
        );
    }
    assert!(
        escaped >= 36,
        "without the projection the correctives of {escaped} of 40 wild poses leave the range"
    );
}

/// What correctives change of the demo's image in a pose, dB: the less, the less they change.
fn change(avatar: &Avatar, still: &Avatar, pose: &Pose, project: bool) -> f64 {
    let posed = Posed::with_projection(avatar, pose, project);
    let [min, max] = AvatarBounds::new(avatar).bounds(&posed.joints);
    let camera = Camera::orbit(
        (min + max) / 2.0,
        0.4,
        0.1,
        1.2 * (max - min).length(),
        0.7,
        [150, 150],
    );
    let draw = |avatar: &Avatar| reference::render(avatar, &posed, &camera);
    error::between(&draw(avatar), &draw(still)).covered.psnr_db
}

fn projection_bounds_the_correctives_of_a_wild_pose() {
    let avatar = effigy_demo::avatar().unwrap();
    let mut still = avatar.clone();
    if let Some(last) = still.networks.layers.last_mut() {
        last.weight.halves_mut().fill(half::f16::ZERO);
        last.bias.fill(half::f16::ZERO);
    }
    let player = Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton);
    let most = (0..4)
        .map(|k| change(&avatar, &still, &player.pose(0.5 + k as f64), true))
        .fold(f64::INFINITY, f64::min);
    for seed in 0..3 {
        let [on, off] =
            [true, false].map(|project| change(&avatar, &still, &wild(seed, &avatar), project));
        println!(
            "known poses: {most:.1} dB or more; a wild one: {on:.1} with, {off:.1} without projection"
        );
        // A corner of what the poses of a clip span is further off than any of them, and makes a
        // face that the clip does not.
        assert!(
            on > most - 5.0,
            "with the projection the image of a wild pose changes by {on} dB, known ones by {most}"
        );
        assert!(
            off < on - 3.0,
            "without the projection it changes by {off} dB, with by {on}"
        );
    }
}

tests! {
    the_networks_see_wild_poses_within_two_sigma,
    correctives_stay_within_those_of_known_poses,
    projection_bounds_the_correctives_of_a_wild_pose,
}
