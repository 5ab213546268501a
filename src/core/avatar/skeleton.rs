//! Joints and forward kinematics, in f64 and shared by every backend.

use super::Pose;
use glam::{DAffine3, DQuat, DVec3};

/// A tree of joints. A joint's parent has a smaller index.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    /// Name of each joint.
    pub name: Vec<String>,
    /// None for the root, which is joint 0 and the only one.
    pub parent: Vec<Option<u8>>,
    /// Position of each joint in the rest pose, where every rotation is the identity; metres.
    pub rest: Vec<[f32; 3]>,
    /// Axis-angle rotations of the pose that the Gaussians' positions are given in, radians.
    pub canonical: Vec<[f32; 3]>,
}

impl Skeleton {
    /// Number of joints, J.
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Whether there are no joints.
    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }

    /// A_j: joint coordinates to world, for each joint. `A_root = T(translation + rest) R`, `A_j =
    /// A_parent T(rest_j − rest_parent) R_j`.
    fn world(&self, rotation: impl Fn(usize) -> DQuat, translation: DVec3) -> Vec<DAffine3> {
        let mut world: Vec<DAffine3> = Vec::with_capacity(self.len());
        for j in 0..self.len() {
            let rest = DVec3::from(self.rest[j].map(f64::from));
            let joint = match self.parent[j] {
                None => DAffine3::from_rotation_translation(rotation(j), translation + rest),
                Some(parent) => {
                    let parent = parent as usize;
                    let offset = rest - DVec3::from(self.rest[parent].map(f64::from));
                    world[parent] * DAffine3::from_rotation_translation(rotation(j), offset)
                }
            };
            world.push(joint);
        }
        world
    }

    /// Joint coordinates to world under a pose, for each joint.
    pub fn joints(&self, pose: &Pose) -> Vec<DAffine3> {
        self.world(
            |j| DQuat::from_scaled_axis(pose.rotation.get(j).copied().unwrap_or_default()),
            pose.translation,
        )
    }

    /// G_j = A_j(pose) A_j(canonical)⁻¹: canonical space to world, for each joint (docs/model.md,
    /// step 6).
    pub fn matrices(&self, pose: &Pose) -> Vec<DAffine3> {
        let canonical = self.world(
            |j| DQuat::from_scaled_axis(DVec3::from(self.canonical[j].map(f64::from))),
            DVec3::ZERO,
        );
        self.joints(pose)
            .iter()
            .zip(&canonical)
            .map(|(posed, canonical)| *posed * canonical.inverse())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arm() -> Skeleton {
        Skeleton {
            name: vec!["root".into(), "elbow".into()],
            parent: vec![None, Some(0)],
            rest: vec![[0.0, 1.0, 0.0], [1.0, 1.0, 0.0]],
            canonical: vec![[0.0; 3]; 2],
        }
    }

    #[test]
    fn a_bent_elbow_moves_the_hand_around_it() {
        let mut pose = Pose::rest(2, 0);
        pose.rotation[1] = DVec3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2);
        let hand = arm().matrices(&pose)[1].transform_point3(DVec3::new(2.0, 1.0, 0.0));
        assert!(hand.distance(DVec3::new(1.0, 2.0, 0.0)) < 1e-12, "{hand}");
    }

    #[test]
    fn the_canonical_pose_leaves_every_point_where_it_is() {
        let mut skeleton = arm();
        skeleton.canonical[1] = [0.3, -0.2, 0.5];
        let mut pose = Pose::rest(2, 0);
        pose.rotation[1] = DVec3::from(skeleton.canonical[1].map(f64::from));
        for matrix in skeleton.matrices(&pose) {
            assert!(
                matrix
                    .transform_point3(DVec3::new(1.5, 0.2, -0.7))
                    .distance(DVec3::new(1.5, 0.2, -0.7))
                    < 1e-12
            );
        }
    }
}
