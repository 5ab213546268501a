//! An avatar with fewer rows, by what it is in some poses.

use crate::prune::{RowBudget, RowSubject, select_rows};
use effigy_core::avatar::{Avatar, Pose, ROW_COMPONENTS, Rows, motion::Player};
use effigy_core::reference::basis::corrective;
use effigy_core::reference::mlp;
use effigy_math::{covariance::RunningCovariance, poses};
use half::f16;

/// Poses in which rows are weighed.
const POSES: usize = 200;
/// Decides random poses.
const SEED: u64 = 1;

/// Keeps the rows of an avatar that are worth most in the poses of clips; without clips in random
/// poses of those that it was trained for. A Gaussian that loses a row gets its mean over the poses
/// instead. Nothing else changes: neither networks, nor nodes, nor levels.
///
/// # Panics
/// Where [`Avatar::check`] finds a fault.
pub fn prune(avatar: &Avatar, players: &[Player], budget: RowBudget) -> Avatar {
    let poses = if players.is_empty() {
        poses::random(avatar, POSES, SEED)
    } else {
        poses::from_clips(players, POSES, 0.5)
    };
    let features = AttributeFeatures::new(avatar, &poses);
    let mean = means(avatar, &features);
    let subject = RowSubject {
        poses: poses.iter().collect(),
        mean: &mean,
        covariances: features.covariances,
    };
    let [rotations, scales, colors] = select_rows(&subject, avatar, budget);
    let [rotation, scale, color] = &mean;
    let mut pruned = avatar.clone();
    pruned.rotation_rows = keep(&avatar.rotation_rows, rotations, |k| {
        pruned.gaussians.rotation[k] = halves(rotation, k);
    });
    pruned.scale_rows = keep(&avatar.scale_rows, scales, |k| {
        pruned.gaussians.log_scale[k] = halves(scale, k);
    });
    pruned.color_rows = keep(&avatar.color_rows, colors, |k| {
        pruned.gaussians.color[k] = halves(color, k);
    });
    pruned
}

/// What the attributes of each part see of its features, over the poses.
struct AttributeFeatures {
    /// Shape N_G, N_B.
    mean: Vec<Vec<f64>>,
    /// Shape N_G, N_B, N_B.
    covariances: Vec<Vec<f64>>,
}

impl AttributeFeatures {
    fn new(avatar: &Avatar, poses: &[Pose]) -> Self {
        let parts = avatar.parts.len();
        let basis = avatar.basis_len();
        let width = avatar.networks.output();
        let mut running: Vec<_> = (0..parts).map(|_| RunningCovariance::new(basis)).collect();
        for pose in poses {
            let features = mlp::features(avatar, &avatar.inputs.from_pose(pose));
            for (running, features) in running.iter_mut().zip(features.chunks_exact(width)) {
                running.add(&features[..basis]);
            }
        }
        Self {
            mean: running.iter().map(|of| of.mean().to_vec()).collect(),
            covariances: running.iter().map(RunningCovariance::covariance).collect(),
        }
    }
}

/// Rotation, log scale and colour of every Gaussian, their means over the poses: correctives are
/// linear in the features.
fn means(avatar: &Avatar, features: &AttributeFeatures) -> [Vec<f32>; 3] {
    fn add<const C: usize>(out: &mut Vec<f32>, neutral: [f16; C], moved: [f64; C]) {
        let sums = neutral.iter().zip(moved);
        out.extend(sums.map(|(neutral, moved)| (neutral.to_f64() + moved) as f32));
    }
    let gaussians = &avatar.gaussians;
    let mut means = ROW_COMPONENTS.map(|width| Vec::with_capacity(width * gaussians.len()));
    for (part, e) in features.mean.iter().enumerate() {
        for k in avatar.parts.gaussians(part) {
            let [rotation, scale, color] = &mut means;
            add(
                rotation,
                gaussians.rotation[k],
                corrective(&avatar.rotation_rows, k, e),
            );
            add(
                scale,
                gaussians.log_scale[k],
                corrective(&avatar.scale_rows, k, e),
            );
            add(
                color,
                gaussians.color[k],
                corrective(&avatar.color_rows, k, e),
            );
        }
    }
    means
}

/// A Gaussian's numbers, rounded as in the file.
fn halves<const C: usize>(means: &[f32], gaussian: usize) -> [f16; C] {
    std::array::from_fn(|c| f16::from_f32(means[gaussian * C + c]))
}

/// The rows of the retained Gaussians. `drop`: called with the Gaussian of each other row.
fn keep<const C: usize>(
    rows: &Rows<C>,
    retained: Vec<u32>,
    mut drop: impl FnMut(usize),
) -> Rows<C> {
    let length = rows.basis.len() / rows.gaussian.len().max(1);
    let mut kept = Vec::with_capacity(retained.len());
    for (row, &gaussian) in rows.gaussian.iter().enumerate() {
        if retained.binary_search(&gaussian).is_ok() {
            kept.push(row);
        } else {
            drop(gaussian as usize);
        }
    }
    Rows {
        gaussian: retained,
        basis: rows.basis.pick(&kept, length),
    }
}
