//! Poses evaluated for one avatar.

use crate::avatar::{Avatar, Pose};
use glam::{DAffine3, DVec3};

/// A pose evaluated for one avatar: everything that the stages need to know about it.
#[derive(Clone, Debug)]
pub struct Posed {
    /// G_j: canonical space to world, one a joint.
    pub joints: Vec<DAffine3>,
    /// The networks' input θ_p ⊕ θ_e, projected onto the training poses' subspace by default.
    pub input: Vec<f64>,
    /// Length of θ_e, the end of `input`, which parts outside the head see as zeros.
    pub expression: usize,
}

impl Posed {
    /// Evaluates a pose, with its projection for the networks.
    ///
    /// # Panics
    /// Where [`Avatar::check`] finds a fault.
    pub fn new(avatar: &Avatar, pose: &Pose) -> Self {
        Self::with_projection(avatar, pose, true)
    }

    /// Evaluates a pose. `project`: whether the networks see its projection onto the subspace of
    /// the training poses, or the pose itself, however far it is from those that they know.
    ///
    /// # Panics
    /// Where [`Avatar::check`] finds a fault.
    pub fn with_projection(avatar: &Avatar, pose: &Pose, project: bool) -> Self {
        let inputs = &avatar.inputs;
        let input = if project {
            inputs.from_pose(pose)
        } else {
            inputs.unprojected(pose)
        };
        Self {
            joints: avatar.skeleton.matrices(pose),
            input,
            expression: inputs.expression,
        }
    }

    /// Moves the posed avatar by a transform of the world.
    pub fn placed(mut self, transform: DAffine3) -> Self {
        for joint in &mut self.joints {
            *joint = transform * *joint;
        }
        self
    }

    /// The point that goes along with an avatar: its root joint, projected onto the ground. Without
    /// its height, a jump is visible to whoever follows.
    pub fn ground(&self, avatar: &Avatar) -> DVec3 {
        let (Some(joint), Some(rest)) = (self.joints.first(), avatar.skeleton.rest.first()) else {
            return DVec3::ZERO;
        };
        joint.transform_point3(DVec3::from(rest.map(f64::from))) * DVec3::new(1.0, 0.0, 1.0)
    }
}

/// Distance from its centre, in standard deviations, at which a Gaussian of this opacity, in 255ths,
/// fades to 1/255: √(2 ln opacity). None where it is nowhere that opaque.
pub fn radius_in_sigmas(opacity: f64) -> Option<f64> {
    (opacity > 1.0).then(|| (2.0 * opacity.ln()).sqrt())
}
