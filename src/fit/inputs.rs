//! The training poses in; what the networks see of them, and the spaces that novel poses are projected onto, out.

use crate::avatar::{Avatar, Inputs, Pose, Subspace};
use crate::bake::pca::pca;
use glam::DVec3;

/// Principal components of the poses that the file keeps, as AnimatableGS does.
const POSE_COMPONENTS: usize = 20;
/// Numbers that vary by less are not blown up: radians, or shares of an expression.
const LEAST: f64 = 0.1;
/// How far a joint's turn is felt, metres, and how much of it everywhere: an arm throws its shadow on the hip.
const REACH: f64 = 0.4;
const FAR: f64 = 0.15;

/// What the networks see of every frame of a dataset.
pub struct Seen {
    /// θ_p ⊕ θ_e as the renderer gives it, projected; shape F, inputs.
    pub projected: Vec<f32>,
    /// The same without the projection.
    pub raw: Vec<f32>,
    pub width: usize,
    /// How many of them are of the pose; the others are of the expression.
    pub poses: usize,
    /// Mean over the training frames.
    pub mean: Vec<f32>,
    deviation: Vec<f64>,
}

/// The avatar's inputs with spaces fitted to the training poses.
///
/// Expressions are projected too, but their clamp never cuts what was trained: ±2σ of a blink, seldom as it is, would keep the eyes open.
/// So their σ is at least half of the furthest training expression.
pub fn spaces(inputs: &Inputs, poses: &[&Pose]) -> Inputs {
    let plain = Inputs { pose_space: None, expression_space: None, ..inputs.clone() };
    let rows: Vec<Vec<f64>> = poses.iter().map(|pose| plain.unprojected(pose)).collect();
    let split = 3 * plain.joint.len();
    let [theta, face]: [Vec<Vec<f64>>; 2] =
        [rows.iter().map(|row| row[..split].to_vec()).collect(), rows.iter().map(|row| row[split..].to_vec()).collect()];
    let mut expression = pca(&face, plain.expression, plain.expression);
    for k in 0..expression.sigma.len() {
        let furthest = face.iter().map(|row| along(&expression, k, row).abs()).fold(0.0, f64::max);
        expression.sigma[k] = expression.sigma[k].max((0.5 * furthest * 1.0001) as f32);
    }
    Inputs {
        pose_space: Some(pca(&theta, split, POSE_COMPONENTS)),
        expression_space: (plain.expression > 0).then_some(expression),
        ..plain
    }
}

fn along(space: &Subspace, k: usize, x: &[f64]) -> f64 {
    let component = &space.component[k * x.len()..][..x.len()];
    component.iter().zip(x).zip(&space.mean).map(|((&c, x), &m)| f64::from(c) * (x - f64::from(m))).sum()
}

impl Seen {
    /// `training`: the frames that mean and deviation are taken over.
    pub fn new(inputs: &Inputs, poses: &[Pose], training: &[usize]) -> Self {
        let projected = poses.iter().flat_map(|pose| inputs.of(pose)).map(|x| x as f32).collect();
        let raw: Vec<f32> = poses.iter().flat_map(|pose| inputs.unprojected(pose)).map(|x| x as f32).collect();
        let width = inputs.len();
        let count = training.len().max(1) as f64;
        let column = |k: usize| training.iter().map(move |f| f * width + k).map(|at| f64::from(raw[at]));
        let mean: Vec<f64> = (0..width).map(|k| column(k).sum::<f64>() / count).collect();
        let deviation = (0..width).map(|k| (column(k).map(|x| (x - mean[k]).powi(2)).sum::<f64>() / count).sqrt()).collect();
        Self { mean: mean.iter().map(|&m| m as f32).collect(), poses: 3 * inputs.joint.len(), deviation, projected, width, raw }
    }

    /// What a part's network multiplies each number by before it learns: each varies by about as much as it matters there. Nearer joints
    /// matter more; 0 for what the part doesn't see.
    pub fn gains(&self, avatar: &Avatar, part: usize) -> Vec<f32> {
        let range = avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize;
        let count = range.len().max(1) as f64;
        let center = range.map(|k| avatar.position(k)).sum::<DVec3>() / count;
        let skeleton = &avatar.skeleton;
        let mut canonical = Pose::rest(skeleton.len(), 0);
        canonical.rotation = skeleton.canonical.iter().map(|turn| DVec3::from(turn.map(f64::from))).collect();
        let joints = skeleton.joints(&canonical);
        let split = 3 * avatar.inputs.joint.len();
        let whole = avatar.parts.len() == 1;
        let gain = |k: usize| {
            let weight = if k >= split {
                f64::from(u8::from(part < avatar.parts.head))
            } else if whole {
                1.0
            } else {
                let joint = joints[usize::from(avatar.inputs.joint[k / 3])].translation;
                FAR + (-(joint.distance(center) / REACH).powi(2)).exp()
            };
            (weight / self.deviation[k].max(LEAST)) as f32
        };
        (0..self.width).map(gain).collect()
    }
}
