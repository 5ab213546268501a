//! The networks' input: pose and expression, projected onto the principal components of the
//! training poses.

use super::Pose;
use crate::constants::FEATURE_MAX;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// How a pose becomes the networks' input, θ_p ⊕ θ_e.
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs {
    /// θ_p is the axis-angle rotations of these joints, in this order (SMPL-X: 1 to 21).
    pub joint: Vec<u8>,
    /// Length of θ_e.
    pub expression: usize,
    /// The training poses' principal components; θ_p is projected onto them where present.
    pub pose_space: Option<Subspace>,
    /// The training expressions' principal components; θ_e is projected onto them where present.
    pub expression_space: Option<Subspace>,
}

/// Principal components of a set of vectors of length D.
#[derive(Clone, Debug, PartialEq)]
pub struct Subspace {
    /// Length D.
    pub mean: Vec<f32>,
    /// Shape K, D; rows are orthonormal.
    pub component: Vec<f32>,
    /// Standard deviation along each component, length K.
    pub sigma: Vec<f32>,
}

impl Subspace {
    /// The nearest point within ±2σ of the mean along each component (docs/model.md, step 0).
    pub fn project(&self, x: &[f64]) -> Vec<f64> {
        let mut projected: Vec<f64> = self.mean.iter().map(|&m| f64::from(m)).collect();
        for (component, sigma) in self.axes() {
            let along: f64 = component
                .iter()
                .zip(x)
                .zip(&self.mean)
                .map(|((&c, x), &m)| f64::from(c) * (x - f64::from(m)))
                .sum();
            let clamped = along.clamp(-2.0 * sigma, 2.0 * sigma);
            for (p, &c) in projected.iter_mut().zip(component) {
                *p += clamped * f64::from(c);
            }
        }
        projected
    }

    /// Each component and the standard deviation along it.
    fn axes(&self) -> impl Iterator<Item = (&[f32], f64)> {
        self.component
            .chunks_exact(self.mean.len().max(1))
            .zip(&self.sigma)
            .map(|(component, &sigma)| (component, f64::from(sigma)))
    }
}

/// The equivalent axis-angle rotation by at most π. Networks were trained on those, and one
/// rotation must give one input however it is written.
fn shortest(rotation: DVec3) -> DVec3 {
    let angle = rotation.length();
    if angle <= PI {
        rotation
    } else {
        rotation * ((angle - TAU * (angle / TAU).round()) / angle)
    }
}

/// Clamps to ±[`FEATURE_MAX`]; NaN stays NaN.
fn clamped(mut input: Vec<f64>) -> Vec<f64> {
    for x in &mut input {
        *x = x.clamp(-FEATURE_MAX, FEATURE_MAX);
    }
    input
}

impl Inputs {
    /// Of networks that there are none of.
    pub fn none() -> Self {
        Self {
            joint: vec![],
            expression: 0,
            pose_space: None,
            expression_space: None,
        }
    }

    /// Length of θ_p ⊕ θ_e.
    pub fn len(&self) -> usize {
        3 * self.joint.len() + self.expression
    }

    /// Whether the networks have no input.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// θ_p ⊕ θ_e of a pose, each projected where the avatar has a subspace for it. Parts outside
    /// the head see θ_e as zeros.
    pub fn from_pose(&self, pose: &Pose) -> Vec<f64> {
        let raw = self.unprojected(pose);
        let (theta, expression) = raw.split_at(3 * self.joint.len());
        let project = |space: &Option<Subspace>, x: &[f64]| match space {
            Some(space) => space.project(x),
            None => x.to_vec(),
        };
        let mut input = project(&self.pose_space, theta);
        input.extend(project(&self.expression_space, expression));
        clamped(input)
    }

    /// θ_p ⊕ θ_e of poses that represent the training poses: their mean, and one σ to both sides of
    /// it along each component. Only the rest pose if there is no subspace.
    pub fn typical(&self) -> Vec<Vec<f64>> {
        let mut mean: Vec<f64> = self.pose_space.as_ref().map_or(vec![], |space| {
            space.mean.iter().map(|&m| f64::from(m)).collect()
        });
        mean.resize(self.len(), 0.0);
        let mut all = vec![mean.clone()];
        let Some(space) = &self.pose_space else {
            return all;
        };
        for (component, sigma) in space.axes() {
            for offset in [sigma, -sigma] {
                let mut input = mean.clone();
                for (x, &c) in input.iter_mut().zip(component) {
                    *x += offset * f64::from(c);
                }
                all.push(input);
            }
        }
        all
    }

    /// θ_p ⊕ θ_e of a pose without projection.
    pub fn unprojected(&self, pose: &Pose) -> Vec<f64> {
        let rotation = |&joint: &u8| {
            let rotation = pose.rotation.get(usize::from(joint)).copied();
            shortest(rotation.unwrap_or_default()).to_array()
        };
        let mut input: Vec<f64> = self.joint.iter().flat_map(rotation).collect();
        input.extend(&pose.expression[..self.expression.min(pose.expression.len())]);
        input.resize(self.len(), 0.0);
        clamped(input)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_do_not_depend_on_how_a_rotation_is_written() {
        let inputs = Inputs {
            joint: vec![1, 7],
            expression: 1,
            pose_space: None,
            expression_space: None,
        };
        let input_of = |rotation: DVec3| {
            inputs.from_pose(&Pose {
                rotation: vec![DVec3::ZERO, rotation],
                expression: vec![1e30],
                ..Pose::rest(0, 0)
            })
        };
        let axis = DVec3::new(2.0, -1.0, 2.0) / 3.0;
        for turns in [-3.0, -1.0, 0.0, 1.0, 1000.0] {
            let input = input_of(axis * (0.8 + TAU * turns));
            assert!(
                input[..3]
                    .iter()
                    .zip((axis * 0.8).to_array())
                    .all(|(a, b)| (a - b).abs() < 1e-9),
                "{turns} turns: {input:?}"
            );
            assert_eq!(input[3..], [0.0, 0.0, 0.0, FEATURE_MAX]);
        }
        assert!(input_of(DVec3::NAN)[0].is_nan());
    }

    #[test]
    fn projection_keeps_the_subspace_and_clamps_at_two_sigma() {
        let space = Subspace {
            mean: vec![1.0, 0.0, 0.0],
            component: vec![0.0, 1.0, 0.0],
            sigma: vec![0.5],
        };
        assert_eq!(space.project(&[7.0, 0.75, 3.0]), [1.0, 0.75, 0.0]);
        assert_eq!(space.project(&[1.0, -9.0, 0.0]), [1.0, -1.0, 0.0]);
    }
}
