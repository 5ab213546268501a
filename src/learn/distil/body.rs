//! The avatar before it learns: its Gaussians ordered by part, its nodes, skin and opacity, from the
//! teacher's means.

use crate::distil::teacher::{AnchorFeatures, Teacher, sigmoid};
use effigy_core::avatar::{
    Activation, Avatar, Bounds, Filter, Gaussians, Inputs, Matrix, Networks, Nodes, Parts, Rows,
};
use effigy_formats::mmlphuman::Checkpoint;
use effigy_math::{sampling::evenly_spaced, weights::weight_bytes};
use glam::DVec3;
use half::f16;
use rayon::prelude::*;

/// Rows over which opacity is averaged.
const OPACITY_ROWS: usize = 128;

/// The avatar before it learns, and how much it loses of the checkpoint.
pub struct UntrainedAvatar {
    /// Neutral attributes are not set yet, nor are networks.
    pub avatar: Avatar,
    /// The checkpoint's index of each Gaussian.
    pub order: Vec<u32>,
    /// The share of the joints' weights that the four largest of each Gaussian leave out, mean.
    pub skin_lost: f64,
    /// How far opacity is from its mean over the training rows, root mean square.
    pub opacity_lost: f64,
}

/// θ_p of the networks: the checkpoint's joints, without components.
pub fn plain_inputs(checkpoint: &Checkpoint) -> Inputs {
    Inputs {
        joint: checkpoint.input_joints().map(|joint| joint as u8).collect(),
        expression: 0,
        pose_space: None,
        expression_space: None,
    }
}

/// Four joints of a Gaussian.
struct GaussianSkin {
    joint: [u8; 4],
    weight: [u8; 4],
    lost: f64,
}

/// The four largest weights, scaled to a sum of 255.
fn skin(weights: &[f32]) -> GaussianSkin {
    let mut order: Vec<usize> = (0..weights.len()).collect();
    order.sort_by(|&a, &b| weights[b].total_cmp(&weights[a]));
    order.truncate(4);
    let own = |at: usize| {
        order
            .get(at)
            .map_or(0.0, |&joint| f64::from(weights[joint].max(0.0)))
    };
    let all: f64 = weights.iter().map(|&w| f64::from(w.max(0.0))).sum();
    let sum: f64 = (0..4).map(own).sum();
    // Without any weight the first joint has all.
    let share = |at: usize| {
        if sum > 0.0 {
            own(at) / sum
        } else {
            f64::from(u8::from(at == 0))
        }
    };
    GaussianSkin {
        joint: std::array::from_fn(|at| order.get(at).map_or(0, |&joint| joint as u8)),
        weight: weight_bytes(std::array::from_fn(share)),
        lost: 1.0 - sum / all.max(1e-12),
    }
}

/// A Gaussian's mean opacity, 0 to 1.
struct Opacity {
    mean: f64,
    variance: f64,
}

impl UntrainedAvatar {
    /// `means`: the mean features of every anchor over the `training` rows. `basis`: N_B.
    pub fn new(
        checkpoint: &Checkpoint,
        name: &str,
        features: &AnchorFeatures,
        means: &[Vec<f32>],
        training: &[usize],
        basis: usize,
    ) -> Self {
        let (order, parts) = parts(checkpoint);
        let positions = MeanPositions::new(checkpoint, means, &order);
        let bounds = Bounds::around(positions.gaussians.iter().chain(&positions.nodes));
        let joints = checkpoint.skeleton.len();
        let skins: Vec<GaussianSkin> = order
            .par_iter()
            .map(|&k| skin(&checkpoint.skin[k as usize * joints..][..joints]))
            .collect();
        let opacities = opacities(checkpoint, features, training);
        let count = order.len();
        let mean_of = |numbers: f64| numbers / count.max(1) as f64;
        let node = |&k: &u32| {
            let mut shares = checkpoint.gaussian_nodes.of(k as usize);
            std::array::from_fn(|_| shares.next().map_or(0, |share| share.index as u16))
        };
        let encode = |points: &[DVec3]| points.iter().map(|&p| bounds.encode(p)).collect();
        let gaussians = Gaussians {
            bounds,
            position: encode(&positions.gaussians),
            rotation: vec![[f16::ONE, f16::ZERO, f16::ZERO, f16::ZERO]; count],
            log_scale: vec![[f16::ZERO; 3]; count],
            color: vec![[f16::ZERO; 3]; count],
            opacity: order
                .iter()
                .map(|&k| (255.0 * opacities[k as usize].mean).round() as u8)
                .collect(),
            joint: skins.iter().map(|skin| skin.joint).collect(),
            joint_weight: skins.iter().map(|skin| skin.weight).collect(),
            node: order.iter().map(node).collect(),
            facing: vec![],
        };
        let node_count = positions.nodes.len();
        let nodes = Nodes {
            part: (0..node_count)
                .map(|node| checkpoint.nodes.anchors.nearest(node) as u16)
                .collect(),
            offset: vec![[f16::ZERO; 3]; node_count],
            basis: Matrix::from(vec![f16::ZERO; 3 * basis * node_count]),
            position: encode(&positions.nodes),
        };
        Self {
            skin_lost: mean_of(skins.iter().map(|skin| skin.lost).sum()),
            opacity_lost: mean_of(opacities.iter().map(|own| own.variance).sum()).sqrt(),
            avatar: Avatar {
                name: name.into(),
                credit: String::new(),
                skeleton: checkpoint.skeleton.clone(),
                gaussians,
                parts,
                networks: Networks {
                    activation: Activation::LeakyRelu,
                    layers: vec![],
                },
                rotation_rows: Rows::default(),
                scale_rows: Rows::default(),
                color_rows: Rows::default(),
                nodes,
                inputs: plain_inputs(checkpoint),
                sh: None,
                // gsplat's, which it is trained with.
                filter: Filter::DEFAULT,
                levels: vec![],
            },
            order,
        }
    }
}

/// The checkpoint's Gaussians in the order of their nearest anchors, and the parts that these are.
fn parts(checkpoint: &Checkpoint) -> (Vec<u32>, Parts) {
    let part: Vec<u32> = (0..checkpoint.len())
        .map(|k| checkpoint.gaussian_anchors.nearest(k) as u32)
        .collect();
    let mut order: Vec<u32> = (0..checkpoint.len() as u32).collect();
    order.sort_by_key(|&k| part[k as usize]);
    let mut start = vec![0u32; checkpoint.networks.count + 1];
    for &part in &part {
        start[part as usize + 1] += 1;
    }
    for at in 1..start.len() {
        start[at] += start[at - 1];
    }
    (order, Parts { start, head: 0 })
}

/// Positions with the mean features of every anchor, metres.
struct MeanPositions {
    /// In the avatar's order.
    gaussians: Vec<DVec3>,
    nodes: Vec<DVec3>,
}

impl MeanPositions {
    fn new(checkpoint: &Checkpoint, means: &[Vec<f32>], order: &[u32]) -> Self {
        let mean = AnchorFeatures::of_means(means);
        let moved = Teacher { checkpoint }.displacements(&mean, 0);
        let nodes = checkpoint.nodes.position.iter().zip(&moved);
        let gaussian = |&k: &u32| {
            let shares = checkpoint.gaussian_nodes.of(k as usize);
            let moves = shares.map(|share| f64::from(share.weight) * moved[share.index]);
            checkpoint.gaussians.position[k as usize] + moves.sum::<DVec3>()
        };
        Self {
            nodes: nodes.map(|(p, moved)| *p + *moved).collect(),
            gaussians: order.iter().map(gaussian).collect(),
        }
    }
}

/// Opacity of each Gaussian of the checkpoint over some of the training rows.
fn opacities(
    checkpoint: &Checkpoint,
    features: &AnchorFeatures,
    training: &[usize],
) -> Vec<Opacity> {
    let rows = evenly_spaced(training, OPACITY_ROWS);
    let opacity = |k: usize| {
        let neutral = f64::from(checkpoint.gaussians.opacity[k]);
        let Some(bases) = &checkpoint.bases else {
            return Opacity {
                mean: sigmoid(neutral),
                variance: 0.0,
            };
        };
        let basis = &bases.opacity[k * checkpoint.basis..][..checkpoint.basis];
        let at = |&row: &usize| {
            let shares = checkpoint.gaussian_anchors.of(k);
            let added = shares.map(|share| {
                let e = features.of(share.index, row).iter().zip(basis);
                share.weight * e.map(|(e, along)| e * along).sum::<f32>()
            });
            sigmoid(neutral + f64::from(added.sum::<f32>()))
        };
        let count = rows.len().max(1) as f64;
        let own: Vec<f64> = rows.iter().map(at).collect();
        let mean = own.iter().sum::<f64>() / count;
        Opacity {
            mean,
            variance: own.iter().map(|o| (o - mean).powi(2)).sum::<f64>() / count,
        }
    };
    (0..checkpoint.len()).into_par_iter().map(opacity).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_four_largest_weights_stay_and_sum_to_255() {
        let own = skin(&[0.1, 0.05, 0.4, 0.05, 0.4, 0.0]);
        assert_eq!(own.joint, [2, 4, 0, 1]);
        assert_eq!(own.weight.iter().map(|&w| u32::from(w)).sum::<u32>(), 255);
        assert!((own.lost - 0.05).abs() < 1e-6, "{}", own.lost);
        let single = skin(&[1.0]);
        assert_eq!((single.joint, single.weight), ([0; 4], [255, 0, 0, 0]));
    }
}
