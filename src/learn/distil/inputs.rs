//! The networks' inputs: numbers for every frame, and the subspaces that novel poses are projected
//! onto.

use effigy_core::avatar::{Avatar, Inputs, Pose, Subspace};
use effigy_math::pca::pca;
use glam::DVec3;

/// Principal components of the poses that the file keeps, as in AnimatableGS.
const POSE_COMPONENTS: usize = 20;
/// Numbers that vary by less are not scaled up: radians, or shares of an expression.
const MIN_DEVIATION: f64 = 0.1;
/// The distance over which a joint's rotation matters, metres.
const INFLUENCE_RADIUS: f64 = 0.4;
/// How much a joint matters everywhere: an arm casts its shadow on the hip.
const FAR_INFLUENCE: f64 = 0.15;

/// The networks' inputs in every sampled pose.
pub struct NetworkInputs {
    /// θ_p ⊕ θ_e as the renderer computes it, projected onto the subspaces; shape F, inputs.
    pub projected: Vec<f32>,
    /// θ_p ⊕ θ_e without the projection; shape F, inputs.
    pub raw: Vec<f32>,
    /// Numbers a frame.
    pub width: usize,
    /// How many of these are of the pose, the first ones; the others are of the expression.
    pub pose_width: usize,
    /// Mean over the training frames; length `width`.
    pub mean: Vec<f32>,
    deviation: Vec<f64>,
}

/// The avatar's inputs with subspaces fitted to the training poses.
///
/// Expressions are projected too, but the clamp at ±2σ must not cut training expressions: a blink
/// is so rare that its σ is small, and the clamp would keep the eyes open. So the σ of an
/// expression is at min_sigma half of the furthest training expression.
pub fn fit_subspaces(inputs: &Inputs, poses: &[&Pose]) -> Inputs {
    let plain = Inputs {
        pose_space: None,
        expression_space: None,
        ..inputs.clone()
    };
    let rows: Vec<Vec<f64>> = poses.iter().map(|pose| plain.unprojected(pose)).collect();
    let split = 3 * plain.joint.len();
    let rotations: Vec<Vec<f64>> = rows.iter().map(|row| row[..split].to_vec()).collect();
    let expressions: Vec<Vec<f64>> = rows.iter().map(|row| row[split..].to_vec()).collect();
    let mut expression_space = pca(&expressions, plain.expression, plain.expression);
    for k in 0..expression_space.sigma.len() {
        let furthest = expressions
            .iter()
            .map(|row| coordinate(&expression_space, k, row).abs())
            .fold(0.0, f64::max);
        let min_sigma = (0.5 * furthest * 1.0001) as f32;
        expression_space.sigma[k] = expression_space.sigma[k].max(min_sigma);
    }
    Inputs {
        pose_space: Some(pca(&rotations, split, POSE_COMPONENTS)),
        expression_space: (plain.expression > 0).then_some(expression_space),
        ..plain
    }
}

/// How far a point lies along a subspace's component `k`, from the mean.
fn coordinate(space: &Subspace, k: usize, x: &[f64]) -> f64 {
    let component = &space.component[k * x.len()..][..x.len()];
    component
        .iter()
        .zip(x)
        .zip(&space.mean)
        .map(|((&c, x), &m)| f64::from(c) * (x - f64::from(m)))
        .sum()
}

impl NetworkInputs {
    /// Of rows as they are, of which the learner takes either where it learns a frame. Both of
    /// shape F, inputs. `training`: the frames that mean and deviation of `raw` are taken over.
    pub fn new(inputs: &Inputs, raw: Vec<f32>, projected: Vec<f32>, training: &[usize]) -> Self {
        let width = inputs.len();
        let count = training.len().max(1) as f64;
        let column = |k: usize| {
            training
                .iter()
                .map(move |f| f * width + k)
                .map(|at| f64::from(raw[at]))
        };
        let mean: Vec<f64> = (0..width).map(|k| column(k).sum::<f64>() / count).collect();
        let deviation = (0..width)
            .map(|k| (column(k).map(|x| (x - mean[k]).powi(2)).sum::<f64>() / count).sqrt())
            .collect();
        Self {
            mean: mean.iter().map(|&m| m as f32).collect(),
            pose_width: 3 * inputs.joint.len(),
            deviation,
            projected,
            width,
            raw,
        }
    }

    /// The factor of each number while a part learns, chosen so that each varies by about as much
    /// as it matters there: joints near the part matter more. 0 for numbers that the part doesn't
    /// see.
    pub fn gains(&self, avatar: &Avatar, part: usize) -> Vec<f32> {
        let range = avatar.parts.gaussians(part);
        let count = range.len().max(1) as f64;
        let center = range.map(|k| avatar.position(k)).sum::<DVec3>() / count;
        let skeleton = &avatar.skeleton;
        let mut canonical = Pose::rest(skeleton.len(), 0);
        canonical.rotation = skeleton
            .canonical
            .iter()
            .map(|turn| DVec3::from(turn.map(f64::from)))
            .collect();
        let joints = skeleton.joints(&canonical);
        let is_head = part < avatar.parts.head;
        let is_whole_body = avatar.parts.len() == 1;
        let gain = |k: usize| {
            let weight = if k >= self.pose_width {
                f64::from(u8::from(is_head))
            } else if is_whole_body {
                1.0
            } else {
                let joint = joints[usize::from(avatar.inputs.joint[k / 3])].translation;
                FAR_INFLUENCE + (-(joint.distance(center) / INFLUENCE_RADIUS).powi(2)).exp()
            };
            (weight / self.deviation[k].max(MIN_DEVIATION)) as f32
        };
        (0..self.width).map(gain).collect()
    }
}
