//! Poses of a skeleton.

use glam::{DQuat, DVec3};

/// One pose of a skeleton with J joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Axis-angle rotation of each joint relative to its parent, radians. Joint 0 turns the whole
    /// body. Joints past the end stay at rest.
    pub rotation: Vec<DVec3>,
    /// Added to the root's rest position, metres.
    pub translation: DVec3,
    /// θ_e. Shorter than an avatar's expression counts as zeros.
    pub expression: Vec<f64>,
}

impl Pose {
    /// The rest pose: every rotation is the identity.
    pub fn rest(joints: usize, expression: usize) -> Self {
        Self {
            rotation: vec![DVec3::ZERO; joints],
            translation: DVec3::ZERO,
            expression: vec![0.0; expression],
        }
    }

    /// Interpolates between this pose (`share` 0) and another of as many joints (`share` 1). Each
    /// joint rotates the shortest way.
    pub fn between(&self, other: &Self, share: f64) -> Self {
        let interpolate = |a: &DVec3, b: &DVec3| {
            DQuat::from_scaled_axis(*a)
                .slerp(DQuat::from_scaled_axis(*b), share)
                .to_scaled_axis()
        };
        Self {
            rotation: self
                .rotation
                .iter()
                .zip(&other.rotation)
                .map(|(a, b)| interpolate(a, b))
                .collect(),
            translation: self.translation.lerp(other.translation, share),
            expression: self
                .expression
                .iter()
                .zip(&other.expression)
                .map(|(a, b)| a + (b - a) * share)
                .collect(),
        }
    }
}
