//! A pose, and what of it the networks see: θ_p and θ_e, projected onto the training poses' principal components.

use super::Inputs;
use glam::{DQuat, DVec3};
use std::f64::consts::{PI, TAU};

/// Inputs of the networks stay within ±this, the largest number that f16 holds; NaN stays NaN.
const INPUT_MAX: f64 = 65504.0;

/// One pose of a skeleton with J joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Axis-angle rotation of each joint relative to its parent, radians. Joint 0 turns the whole body. Joints past the end stay at rest.
    pub rotation: Vec<DVec3>,
    /// Added to the root's rest position, metres.
    pub translation: DVec3,
    /// θ_e. Shorter than an avatar's expression counts as zeros.
    pub expression: Vec<f64>,
}

impl Pose {
    /// No rotation anywhere.
    pub fn rest(joints: usize, expression: usize) -> Self {
        Self { rotation: vec![DVec3::ZERO; joints], translation: DVec3::ZERO, expression: vec![0.0; expression] }
    }
}

impl Pose {
    /// A pose of as many joints on the way to another, each joint's turn the shortest: `share` 0 is this one, 1 the other.
    pub fn between(&self, other: &Self, share: f64) -> Self {
        let turn = |(a, b): (&DVec3, &DVec3)| DQuat::from_scaled_axis(*a).slerp(DQuat::from_scaled_axis(*b), share).to_scaled_axis();
        Self {
            rotation: self.rotation.iter().zip(&other.rotation).map(turn).collect(),
            translation: self.translation.lerp(other.translation, share),
            expression: self.expression.iter().zip(&other.expression).map(|(a, b)| a + (b - a) * share).collect(),
        }
    }
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
    /// The nearest point within ±2σ of the mean along each component (model.md, step 0).
    pub fn project(&self, x: &[f64]) -> Vec<f64> {
        let mut projected: Vec<f64> = self.mean.iter().map(|&m| f64::from(m)).collect();
        for (component, &sigma) in self.component.chunks_exact(self.mean.len().max(1)).zip(&self.sigma) {
            let along: f64 = component.iter().zip(x).zip(&self.mean).map(|((&c, x), &m)| f64::from(c) * (x - f64::from(m))).sum();
            let kept = along.clamp(-2.0 * f64::from(sigma), 2.0 * f64::from(sigma));
            projected.iter_mut().zip(component).for_each(|(p, &c)| *p += kept * f64::from(c));
        }
        projected
    }
}

/// The same rotation by at most π: networks were trained on those, and two ways to write one rotation must look alike.
fn shortest(rotation: DVec3) -> DVec3 {
    let angle = rotation.length();
    if angle <= PI { rotation } else { rotation * ((angle - TAU * (angle / TAU).round()) / angle) }
}

fn within(mut input: Vec<f64>) -> Vec<f64> {
    input.iter_mut().for_each(|x| *x = x.clamp(-INPUT_MAX, INPUT_MAX));
    input
}

impl Inputs {
    /// θ_p ⊕ θ_e of a pose, each projected where the avatar has a subspace for it. Parts outside the head see θ_e as zeros.
    pub fn of(&self, pose: &Pose) -> Vec<f64> {
        let raw = self.unprojected(pose);
        let (theta, expression) = raw.split_at(3 * self.joint.len());
        let project = |space: &Option<Subspace>, x: &[f64]| space.as_ref().map_or_else(|| x.to_vec(), |space| space.project(x));
        let mut input = project(&self.pose_space, theta);
        input.extend(project(&self.expression_space, expression));
        within(input)
    }

    /// θ_p ⊕ θ_e of the poses that stand for those of the training: their mean, and one σ to both sides of it along each component; no
    /// rotation anywhere where none are known.
    pub fn typical(&self) -> Vec<Vec<f64>> {
        let mut mean: Vec<f64> = self.pose_space.as_ref().map_or(vec![], |space| space.mean.iter().map(|&m| f64::from(m)).collect());
        mean.resize(self.len(), 0.0);
        let mut all = vec![mean.clone()];
        for (component, &sigma) in
            self.pose_space.iter().flat_map(|space| space.component.chunks_exact(space.mean.len().max(1)).zip(&space.sigma))
        {
            for side in [f64::from(sigma), -f64::from(sigma)] {
                let mut x = mean.clone();
                x.iter_mut().zip(component).for_each(|(x, &c)| *x += side * f64::from(c));
                all.push(x);
            }
        }
        all
    }

    /// θ_p ⊕ θ_e of a pose as it is.
    pub fn unprojected(&self, pose: &Pose) -> Vec<f64> {
        let rotation = |&j: &u8| shortest(pose.rotation.get(usize::from(j)).copied().unwrap_or_default()).to_array();
        let mut input: Vec<f64> = self.joint.iter().flat_map(rotation).collect();
        input.extend(&pose.expression[..self.expression.min(pose.expression.len())]);
        input.resize(self.len(), 0.0);
        within(input)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_networks_see_a_rotation_and_not_how_it_is_written() {
        let inputs = Inputs { joint: vec![1, 7], expression: 1, pose_space: None, expression_space: None };
        let see = |rotation: DVec3| inputs.of(&Pose { rotation: vec![DVec3::ZERO, rotation], expression: vec![1e30], ..Pose::rest(0, 0) });
        let axis = DVec3::new(2.0, -1.0, 2.0) / 3.0;
        for turns in [-3.0, -1.0, 0.0, 1.0, 1000.0] {
            let seen = see(axis * (0.8 + TAU * turns));
            assert!(seen[..3].iter().zip((axis * 0.8).to_array()).all(|(a, b)| (a - b).abs() < 1e-9), "{turns} turns: {seen:?}");
            assert_eq!(seen[3..], [0.0, 0.0, 0.0, INPUT_MAX]);
        }
        assert!(see(DVec3::NAN)[0].is_nan());
    }

    #[test]
    fn projection_keeps_the_subspace_and_clamps_at_two_sigma() {
        let space = Subspace { mean: vec![1.0, 0.0, 0.0], component: vec![0.0, 1.0, 0.0], sigma: vec![0.5] };
        assert_eq!(space.project(&[7.0, 0.75, 3.0]), [1.0, 0.75, 0.0]);
        assert_eq!(space.project(&[1.0, -9.0, 0.0]), [1.0, -1.0, 0.0]);
    }
}
