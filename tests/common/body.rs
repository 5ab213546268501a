//! The body that test avatars have the shape of: joints, points on its skin, and what of the
//! skeleton and the nodes is near them.

use super::Random;
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// Name, parent, rest position, and radius of the flesh around the bone from the parent; right-hand
/// joints mirror the left.
const BODY: [(&str, Option<u8>, [f64; 3], f64); 25] = [
    ("pelvis", None, [0.0, 0.95, 0.0], 0.0),
    ("left_hip", Some(0), [0.09, 0.87, 0.0], 0.11),
    ("right_hip", Some(0), [-0.09, 0.87, 0.0], 0.11),
    ("spine1", Some(0), [0.0, 1.07, -0.01], 0.13),
    ("left_knee", Some(1), [0.11, 0.49, 0.01], 0.075),
    ("right_knee", Some(2), [-0.11, 0.49, 0.01], 0.075),
    ("spine2", Some(3), [0.0, 1.2, 0.0], 0.13),
    ("left_ankle", Some(4), [0.12, 0.09, -0.02], 0.05),
    ("right_ankle", Some(5), [-0.12, 0.09, -0.02], 0.05),
    ("spine3", Some(6), [0.0, 1.28, 0.01], 0.14),
    ("left_foot", Some(7), [0.14, 0.04, 0.12], 0.04),
    ("right_foot", Some(8), [-0.14, 0.04, 0.12], 0.04),
    ("neck", Some(9), [0.0, 1.47, -0.01], 0.06),
    ("left_collar", Some(9), [0.07, 1.4, 0.0], 0.09),
    ("right_collar", Some(9), [-0.07, 1.4, 0.0], 0.09),
    ("head", Some(12), [0.0, 1.55, 0.01], 0.065),
    ("left_shoulder", Some(13), [0.18, 1.41, 0.0], 0.07),
    ("right_shoulder", Some(14), [-0.18, 1.41, 0.0], 0.07),
    ("left_elbow", Some(16), [0.44, 1.4, -0.02], 0.045),
    ("right_elbow", Some(17), [-0.44, 1.4, -0.02], 0.045),
    ("left_wrist", Some(18), [0.69, 1.4, -0.01], 0.035),
    ("right_wrist", Some(19), [-0.69, 1.4, -0.01], 0.035),
    ("head_top", Some(15), [0.0, 1.61, 0.02], 0.09),
    ("left_hand", Some(20), [0.8, 1.4, 0.0], 0.035),
    ("right_hand", Some(21), [-0.8, 1.4, 0.0], 0.035),
];

/// The first J joints of the body; what J exceeds it by is fingers of three joints at the hands and
/// the head.
pub fn skeleton(random: &mut Random, joints: usize) -> Skeleton {
    let mut skeleton = Skeleton {
        name: vec![],
        parent: vec![],
        rest: vec![],
        canonical: vec![],
    };
    for j in 0..joints {
        let (name, parent, rest) = match BODY.get(j) {
            Some(&(name, parent, rest, _)) => (name.to_owned(), parent, rest.map(|v| v as f32)),
            None => {
                let extra = j - BODY.len();
                let parent = if extra % 9 < 3 {
                    [22, 23, 24][extra % 3]
                } else {
                    j - 3
                };
                let rest = DVec3::from(skeleton.rest[parent].map(f64::from)) + random.vector(0.03);
                (
                    format!("finger{extra}"),
                    Some(parent as u8),
                    rest.as_vec3().to_array(),
                )
            }
        };
        let turn = match name.as_str() {
            "left_hip" => 0.43,
            "right_hip" => -0.43,
            _ => 0.0,
        };
        skeleton.canonical.push([0.0, 0.0, turn]);
        skeleton.name.push(name);
        skeleton.parent.push(parent);
        skeleton.rest.push(rest);
    }
    skeleton
}

/// Where the joints of a skeleton are in its canonical pose.
pub fn canonical_joints(skeleton: &Skeleton) -> Vec<DVec3> {
    let rotation = skeleton
        .canonical
        .iter()
        .map(|r| DVec3::from(r.map(f64::from)))
        .collect();
    skeleton
        .joints(&Pose {
            rotation,
            ..Pose::rest(0, 0)
        })
        .iter()
        .map(|joint| joint.translation)
        .collect()
}

/// Points on the body's skin, canonical pose, each with its normal.
pub fn skin(random: &mut Random, count: usize) -> Vec<(DVec3, DVec3)> {
    let joints = canonical_joints(&skeleton(random, BODY.len()));
    let bones: Vec<_> = BODY
        .iter()
        .zip(&joints)
        .filter_map(|(b, &end)| b.1.map(|p| (joints[p as usize], end, b.3)))
        .collect();
    let mut total = 0.0;
    let mut area_up_to = vec![];
    for (start, end, radius) in &bones {
        total += (start.distance(*end) + 2.0 * radius) * radius;
        area_up_to.push(total);
    }
    let mut point = || {
        let pick = random.unit() * total;
        let (start, end, radius) = bones[area_up_to.partition_point(|&sum| sum <= pick)];
        let axis = (end - start).normalize();
        let along = random.range(-radius, start.distance(end) + radius);
        let cap = along - along.clamp(0.0, start.distance(end));
        let normal =
            DQuat::from_axis_angle(axis, random.unit() * TAU) * axis.any_orthonormal_vector();
        let normal = normal * (1.0 - (cap / radius).powi(2)).sqrt() + axis * (cap / radius);
        (start + axis * (along - cap) + normal * radius, normal)
    };
    (0..count).map(|_| point()).collect()
}

/// The four joints nearest to a point, by inverse square distance, and weights that sum to 255.
pub fn skinning(joints: &[DVec3], at: DVec3) -> ([u8; 4], [u8; 4]) {
    let mut near: Vec<(f64, u8)> = joints
        .iter()
        .enumerate()
        .map(|(j, p)| (p.distance_squared(at), j as u8))
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let share: Vec<f64> = near
        .iter()
        .take(4)
        .map(|(d, _)| 1.0 / d.max(1e-6).powi(2))
        .collect();
    let total: f64 = share.iter().sum();
    let mut weight: [u8; 4] =
        std::array::from_fn(|k| share.get(k).map_or(0, |s| (s / total * 255.0) as u8));
    weight[0] += 255 - weight.iter().sum::<u8>();
    (
        std::array::from_fn(|k| near.get(k).map_or(0, |n| n.1)),
        weight,
    )
}

/// For each point the three nearest nodes, nearest first; the last repeats where there are fewer.
pub fn nearest_nodes(points: &[DVec3], nodes: &[DVec3]) -> Vec<[u16; 3]> {
    let mut by_height: Vec<usize> = (0..nodes.len()).collect();
    by_height.sort_by(|&a, &b| nodes[a].y.total_cmp(&nodes[b].y));
    let find = |&p: &DVec3| {
        let mut best = [(f64::INFINITY, 0); 3];
        let mut visit = |node: usize| {
            let distance = nodes[node].distance_squared(p);
            let at = best.iter().position(|b| distance < b.0);
            if let Some(at) = at {
                best[at..].rotate_right(1);
                best[at] = (distance, node);
            }
            (nodes[node].y - p.y).powi(2) <= best[2].0
        };
        let (below, above) =
            by_height.split_at(by_height.partition_point(|&node| nodes[node].y < p.y));
        above.iter().take_while(|node| visit(**node)).count();
        below.iter().rev().take_while(|node| visit(**node)).count();
        let last = nodes.len().min(3) - 1;
        std::array::from_fn(|k| best[k.min(last)].1 as u16)
    };
    points.iter().map(find).collect()
}
