//! Small avatars for the stress cases: random numbers go in, a valid avatar comes out. It is a
//! cloud of Gaussians around a tree of joints, with everything that a trained avatar has.

use effigy_core::{
    avatar::{
        Activation, Avatar, Bounds, Filter, Gaussians, Inputs, NetworkLayer, Networks, Nodes,
        Parts, Pose, Rows, Skeleton, Subspace,
    },
    random::Random,
};
use glam::DVec3;
use half::f16;

/// The sizes of an avatar; for the terms see [`effigy_core::avatar`].
#[derive(Clone, Copy, Debug)]
pub struct BodySizes {
    pub gaussians: usize,
    pub parts: usize,
    pub nodes: usize,
    pub basis: usize,
    pub joints: usize,
    /// Basis rows of each attribute, about; at most one a Gaussian.
    pub rows: usize,
    pub expression: usize,
    pub hidden_layers: usize,
    pub hidden_width: usize,
}

impl BodySizes {
    /// Random small sizes.
    pub fn random(random: &mut Random) -> Self {
        let gaussians = 50 + below(random, 1500);
        Self {
            gaussians,
            parts: 1 + below(random, 12),
            nodes: 1 + below(random, 60),
            basis: 4 * (1 + below(random, 4)),
            joints: 1 + below(random, 24),
            rows: below(random, gaussians / 2),
            expression: below(random, 6),
            hidden_layers: 1 + below(random, 3),
            hidden_width: 4 * (1 + below(random, 16)),
        }
    }
}

/// A random number from 0 to below `limit`.
pub fn below(random: &mut Random, limit: usize) -> usize {
    (random.uniform() * limit as f64) as usize
}

/// A random vector, uniform within ±`max` along each axis.
pub fn vector(random: &mut Random, max: f64) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| random.range(-max, max)))
}

fn halves<const N: usize>(values: [f64; N]) -> [f16; N] {
    values.map(f16::from_f64)
}

fn skeleton(random: &mut Random, joints: usize) -> Skeleton {
    let mut skeleton = Skeleton {
        name: vec![],
        parent: vec![],
        rest: vec![],
        canonical: vec![],
    };
    for joint in 0..joints {
        let parent = (joint > 0).then(|| joint - 1 - below(random, joint.min(3)));
        let from = parent.map_or(DVec3::Y, |parent: usize| {
            DVec3::from(skeleton.rest[parent].map(f64::from))
        });
        let rest = (from + random.direction() * random.range(0.1, 0.3))
            .clamp(DVec3::new(-0.8, 0.1, -0.4), DVec3::new(0.8, 1.7, 0.4));
        skeleton.name.push(format!("joint{joint}"));
        skeleton.parent.push(parent.map(|parent| parent as u8));
        skeleton.rest.push(rest.as_vec3().to_array());
        skeleton
            .canonical
            .push(vector(random, 0.2).as_vec3().to_array());
    }
    skeleton
}

/// Four joints and their weights, which sum to 255.
struct JointBinding {
    joint: [u8; 4],
    weight: [u8; 4],
}

/// The joints nearest to a point, with weights by their distance.
fn skinning(joints: &[DVec3], point: DVec3) -> JointBinding {
    let mut near: Vec<(f64, u8)> = joints
        .iter()
        .enumerate()
        .map(|(joint, position)| (position.distance_squared(point), joint as u8))
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let share: Vec<f64> = near
        .iter()
        .take(4)
        .map(|(distance, _)| 1.0 / distance.max(1e-4))
        .collect();
    let total: f64 = share.iter().sum();
    let mut weight: [u8; 4] = std::array::from_fn(|k| {
        share
            .get(k)
            .map_or(0, |share| (share / total * 255.0) as u8)
    });
    weight[0] += 255 - weight.iter().sum::<u8>();
    JointBinding {
        joint: std::array::from_fn(|k| near.get(k).map_or(0, |near| near.1)),
        weight,
    }
}

/// The three points nearest to `target`; of fewer points the last is repeated.
fn nearest(points: &[DVec3], target: DVec3) -> [u16; 3] {
    let mut near: Vec<(f64, usize)> = points
        .iter()
        .map(|point| point.distance_squared(target))
        .zip(0..)
        .collect();
    // The place decides between equal distances, as in a stable sort.
    near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    std::array::from_fn(|k| near[k.min(points.len() - 1)].1 as u16)
}

fn gaussians(
    random: &mut Random,
    points: &[DVec3],
    joints: &[DVec3],
    nodes: &[DVec3],
    bounds: Bounds,
) -> Gaussians {
    let bound: Vec<JointBinding> = points.iter().map(|&p| skinning(joints, p)).collect();
    Gaussians {
        bounds,
        position: points.iter().map(|&p| bounds.encode(p)).collect(),
        rotation: points
            .iter()
            .map(|_| halves(std::array::from_fn(|_| random.normal() + 1e-2)))
            .collect(),
        log_scale: points
            .iter()
            .map(|_| halves(std::array::from_fn(|_| random.range(0.004, 0.03).ln())))
            .collect(),
        color: points
            .iter()
            .map(|_| halves(std::array::from_fn(|_| random.uniform())))
            .collect(),
        opacity: points
            .iter()
            .map(|_| random.range(20.0, 256.0) as u8)
            .collect(),
        joint: bound.iter().map(|bound| bound.joint).collect(),
        joint_weight: bound.iter().map(|bound| bound.weight).collect(),
        node: points.iter().map(|&p| nearest(nodes, p)).collect(),
        facing: vec![],
    }
}

/// Basis rows of some of the Gaussians. Features are near 1, so that correctives are near `size`.
fn rows<const C: usize>(random: &mut Random, sizes: &BodySizes, size: f64) -> Rows<C> {
    let deviation = size / (sizes.basis as f64).sqrt();
    let share = sizes.rows as f64 / sizes.gaussians as f64;
    let gaussian: Vec<u32> = (0..sizes.gaussians as u32)
        .filter(|_| random.uniform() < share)
        .collect();
    let basis = (0..gaussian.len() * C * sizes.basis)
        .map(|_| f16::from_f64(deviation * random.normal()))
        .collect();
    Rows { gaussian, basis }
}

fn networks(random: &mut Random, sizes: &BodySizes, input: usize, output: usize) -> Networks {
    let widths = [
        vec![input],
        vec![sizes.hidden_width; sizes.hidden_layers],
        vec![output],
    ]
    .concat();
    let layer = |pair: &[usize]| {
        let deviation = (2.0 / pair[0] as f64).sqrt();
        NetworkLayer {
            input: pair[0],
            output: pair[1],
            weight: (0..sizes.parts * pair[0] * pair[1])
                .map(|_| f16::from_f64(deviation * random.normal()))
                .collect(),
            bias: (0..sizes.parts * pair[1])
                .map(|_| f16::from_f64(0.2 * random.normal()))
                .collect(),
        }
    };
    let layers = widths.windows(2).map(layer).collect();
    Networks {
        activation: if random.uniform() < 0.5 {
            Activation::Relu
        } else {
            Activation::LeakyRelu
        },
        layers,
    }
}

/// A subspace of one principal component, or none.
fn subspace(random: &mut Random, dimensions: usize) -> Option<Subspace> {
    let axis: Vec<f64> = (0..dimensions).map(|_| random.normal()).collect();
    let length = axis.iter().map(|v| v * v).sum::<f64>().sqrt();
    (dimensions > 0 && random.uniform() < 0.3).then(|| Subspace {
        mean: vec![0.05; dimensions],
        component: axis.iter().map(|v| (v / length) as f32).collect(),
        sigma: vec![0.8],
    })
}

/// A valid avatar of the given sizes, about as large as a person.
pub fn avatar(random: &mut Random, sizes: &BodySizes) -> Avatar {
    let around = |random: &mut Random, joints: &[DVec3]| {
        joints[below(random, joints.len())] + random.direction() * random.range(0.02, 0.12)
    };
    from_points(random, sizes, around)
}

/// A valid avatar with a closed surface: an opaque ellipsoid, inside and behind which nothing is
/// visible.
pub fn solid(random: &mut Random, sizes: &BodySizes) -> Avatar {
    let half = DVec3::new(
        random.range(0.2, 0.35),
        random.range(0.4, 0.7),
        random.range(0.2, 0.35),
    );
    let mut avatar = from_points(random, sizes, |random, _| {
        DVec3::Y + half * random.direction()
    });
    // The surface of the ellipsoid, about. The deviation of each Gaussian is the side of its share
    // of it, so that neighbours overlap enough.
    let area =
        4.0 * std::f64::consts::PI * ((half.x * half.y + half.x * half.z + half.y * half.z) / 3.0);
    let log_scale = f16::from_f64((area / sizes.gaussians as f64).sqrt().ln());
    avatar.gaussians.log_scale.fill([log_scale; 3]);
    avatar.gaussians.opacity.fill(250);
    avatar
}

/// An avatar whose Gaussians are where `point` puts them, given the joints.
fn from_points(
    random: &mut Random,
    sizes: &BodySizes,
    point: impl Fn(&mut Random, &[DVec3]) -> DVec3,
) -> Avatar {
    let skeleton = skeleton(random, sizes.joints);
    let rotation = skeleton
        .canonical
        .iter()
        .map(|r| DVec3::from(r.map(f64::from)))
        .collect();
    let joints: Vec<DVec3> = skeleton
        .joints(&Pose {
            rotation,
            ..Pose::rest(0, 0)
        })
        .iter()
        .map(|joint| joint.translation)
        .collect();
    let bounds = Bounds {
        min: [-1.5, -0.5, -1.0],
        max: [1.5, 2.5, 1.0],
    };
    let mut points: Vec<DVec3> = (0..sizes.gaussians)
        .map(|_| point(random, &joints))
        .collect();
    points.sort_by(|a, b| a.y.total_cmp(&b.y));
    let nodes: Vec<DVec3> = (0..sizes.nodes)
        .map(|_| points[below(random, points.len())] + vector(random, 0.01))
        .collect();
    let mut start: Vec<u32> = (1..sizes.parts)
        .map(|_| below(random, sizes.gaussians + 1) as u32)
        .collect();
    start.extend([0, sizes.gaussians as u32]);
    start.sort_unstable();
    let joint: Vec<u8> = (0..sizes.joints.min(8) as u8).collect();
    let inputs = Inputs {
        pose_space: subspace(random, 3 * joint.len()),
        expression_space: subspace(random, sizes.expression),
        joint,
        expression: sizes.expression,
    };
    let output = sizes.basis * (1 + below(random, 2));
    Avatar {
        sh: None,
        filter: Filter::DEFAULT,
        levels: vec![],
        name: "a stress case".into(),
        credit: String::new(),
        gaussians: gaussians(random, &points, &joints, &nodes, bounds),
        networks: networks(random, sizes, inputs.len(), output),
        rotation_rows: rows(random, sizes, 0.1),
        scale_rows: rows(random, sizes, 0.2),
        color_rows: rows(random, sizes, 0.1),
        nodes: Nodes {
            part: nodes
                .iter()
                .map(|_| below(random, sizes.parts) as u16)
                .collect(),
            offset: nodes
                .iter()
                .map(|_| halves(vector(random, 0.002).to_array()))
                .collect(),
            basis: (0..3 * sizes.basis * nodes.len())
                .map(|_| f16::from_f64(0.002 * random.normal()))
                .collect(),
            position: nodes.iter().map(|&p| bounds.encode(p)).collect(),
        },
        skeleton,
        parts: Parts {
            start,
            head: below(random, sizes.parts + 1),
        },
        inputs,
    }
}
