//! Joints and forward kinematics, in f64 and shared by every backend.

use super::Pose;
use glam::{DAffine3, DMat3, DQuat, DVec3};

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
        against(&self.joints(pose), &self.canonical_joints())
    }

    /// Joint coordinates to canonical space, for each joint.
    fn canonical_joints(&self) -> Vec<DAffine3> {
        self.world(
            |j| DQuat::from_scaled_axis(DVec3::from(self.canonical[j].map(f64::from))),
            DVec3::ZERO,
        )
    }

    /// The derivative of [`Self::matrices`]. `gradient`: of a loss with respect to each number of
    /// each matrix, laid out like it.
    ///
    /// A joint that turns by ω about its own position p moves all that hangs on it: with L, T the
    /// linear part and the translation of such a matrix and M, f their derivatives, the loss
    /// changes by ω · (Σ_c L_c × M_c + (T − p) × f), summed over those matrices. A joint that moves
    /// by δ in its parent, in both poses, moves each of them by R δ − L R₀ δ, with the parent's
    /// rotations R in the pose and R₀ in the canonical one.
    ///
    /// # Panics
    /// When there is not one matrix a joint.
    pub fn matrices_backward(&self, pose: &Pose, gradient: &[DAffine3]) -> PoseGradient {
        assert_eq!(gradient.len(), self.len(), "a matrix a joint");
        let world = self.joints(pose);
        let canonical = self.canonical_joints();
        let matrices = against(&world, &canonical);
        // About the origin, and as forces are summed: of a joint and all that hangs on it.
        let mut torque: Vec<DVec3> = matrices
            .iter()
            .zip(gradient)
            .map(|(own, of)| {
                moment(&own.matrix3, &of.matrix3) + own.translation.cross(of.translation)
            })
            .collect();
        let mut force: Vec<DVec3> = gradient.iter().map(|of| of.translation).collect();
        // Against canonical points that move.
        let mut drag: Vec<DVec3> = matrices
            .iter()
            .zip(gradient)
            .map(|(own, of)| own.matrix3.transpose() * of.translation)
            .collect();
        for joint in (0..self.len()).rev() {
            if let Some(parent) = self.parent[joint] {
                let own = [torque[joint], force[joint], drag[joint]];
                torque[usize::from(parent)] += own[0];
                force[usize::from(parent)] += own[1];
                drag[usize::from(parent)] += own[2];
            }
        }
        let rotation = (0..self.len())
            .map(|joint| {
                let about = torque[joint] - world[joint].translation.cross(force[joint]);
                match self.parent[joint] {
                    Some(parent) => world[usize::from(parent)].matrix3.transpose() * about,
                    None => about,
                }
            })
            .collect();
        let bone = (0..self.len())
            .map(|joint| {
                self.parent[joint].map_or(DVec3::ZERO, |parent| {
                    let turned = |joints: &[DAffine3]| joints[usize::from(parent)].matrix3;
                    turned(&world).transpose() * force[joint]
                        - turned(&canonical).transpose() * drag[joint]
                })
            })
            .collect();
        PoseGradient {
            rotation,
            translation: force.first().copied().unwrap_or_default(),
            bone,
        }
    }

    /// This skeleton with joints that are elsewhere in their parents. `bone`: by how much, metres
    /// in the rest pose; the root stays.
    ///
    /// # Panics
    /// When there is not one a joint.
    pub fn with_bones(&self, bone: &[DVec3]) -> Self {
        let mut moved = vec![DVec3::ZERO; self.len()];
        let mut own = self.clone();
        for joint in 0..self.len() {
            if let Some(parent) = self.parent[joint] {
                moved[joint] = moved[usize::from(parent)] + bone[joint];
                let rest = DVec3::from(self.rest[joint].map(f64::from)) + moved[joint];
                own.rest[joint] = rest.as_vec3().to_array();
            }
        }
        own
    }
}

/// Joints to world, of each against where the canonical pose has it.
fn against(posed: &[DAffine3], canonical: &[DAffine3]) -> Vec<DAffine3> {
    let pairs = posed.iter().zip(canonical);
    pairs
        .map(|(posed, canonical)| *posed * canonical.inverse())
        .collect()
}

/// The derivative of a loss with respect to a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseGradient {
    /// Of a turn of each joint in its parent's coordinates, after its own rotation: of ω in
    /// exp(ω) R, radians, at ω = 0.
    pub rotation: Vec<DVec3>,
    /// Of the translation, metres.
    pub translation: DVec3,
    /// Of where each joint is in its parent in the rest pose, metres; 0 of the root.
    pub bone: Vec<DVec3>,
}

impl PoseGradient {
    /// Adds that of another loss, with respect to the same pose.
    pub fn add(&mut self, other: &Self) {
        let pairs = self.rotation.iter_mut().zip(&other.rotation);
        for (own, other) in pairs.chain(self.bone.iter_mut().zip(&other.bone)) {
            *own += *other;
        }
        self.translation += other.translation;
    }
}

/// Σ_c L_c × M_c over columns.
fn moment(l: &DMat3, m: &DMat3) -> DVec3 {
    (0..3).map(|c| l.col(c).cross(m.col(c))).sum()
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

    /// The sum of all entries of the joints' matrices, times weights.
    fn weighted(skeleton: &Skeleton, pose: &Pose, weights: &[DAffine3]) -> f64 {
        let pairs = skeleton.matrices(pose).into_iter().zip(weights);
        pairs
            .map(|(own, of)| {
                let linear: f64 = (0..3)
                    .map(|c| own.matrix3.col(c).dot(of.matrix3.col(c)))
                    .sum();
                linear + own.translation.dot(of.translation)
            })
            .sum()
    }

    #[test]
    fn its_derivative_is_the_slope_of_differences() {
        let skeleton = Skeleton {
            name: vec!["a".into(), "b".into(), "c".into(), "d".into()],
            parent: vec![None, Some(0), Some(1), Some(0)],
            rest: vec![
                [0.1, 1.0, 0.2],
                [0.9, 1.1, 0.0],
                [1.5, 0.8, 0.3],
                [-0.7, 1.2, 0.1],
            ],
            canonical: vec![[0.1, 0.2, 0.3], [0.0, 0.5, -0.2], [0.4, 0.0, 0.1], [0.0; 3]],
        };
        let number = |k: usize| (1.7 * k as f64 + 0.3).sin();
        let vector = |k: usize| DVec3::new(number(k), number(k + 1), number(k + 2));
        let mut pose = Pose::rest(4, 0);
        for (joint, rotation) in pose.rotation.iter_mut().enumerate() {
            *rotation = 0.8 * vector(5 * joint);
        }
        pose.translation = vector(40);
        let weights: Vec<DAffine3> = (0..4)
            .map(|joint| {
                DAffine3::from_cols(
                    vector(50 + 12 * joint),
                    vector(53 + 12 * joint),
                    vector(56 + 12 * joint),
                    vector(59 + 12 * joint),
                )
            })
            .collect();
        let loss_of = |skeleton: &Skeleton, pose: &Pose| weighted(skeleton, pose, &weights);
        let loss = |pose: &Pose| loss_of(&skeleton, pose);
        let found = skeleton.matrices_backward(&pose, &weights);
        let step = 1e-5;
        let slope =
            |moved: &dyn Fn(f64) -> Pose| (loss(&moved(step)) - loss(&moved(-step))) / (2.0 * step);
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            for joint in 0..4 {
                let expected = slope(&|h| {
                    let mut moved = pose.clone();
                    let turned = DQuat::from_scaled_axis(h * axis)
                        * DQuat::from_scaled_axis(pose.rotation[joint]);
                    moved.rotation[joint] = turned.to_scaled_axis();
                    moved
                });
                let own = found.rotation[joint].dot(axis);
                assert!(
                    (own - expected).abs() < 1e-8,
                    "joint {joint}: {own}, {expected}"
                );
            }
            let expected = slope(&|h| {
                let mut moved = pose.clone();
                moved.translation += h * axis;
                moved
            });
            assert!((found.translation.dot(axis) - expected).abs() < 1e-8);
            for joint in 1..4 {
                // Rest positions are f32: a step that they hold.
                let step = 1.0 / 64.0;
                let moved = |by: f64| {
                    let mut bone = vec![DVec3::ZERO; 4];
                    bone[joint] = by * axis;
                    loss_of(&skeleton.with_bones(&bone), &pose)
                };
                let expected = (moved(step) - moved(-step)) / (2.0 * step);
                let own = found.bone[joint].dot(axis);
                // The loss is linear in it.
                assert!(
                    (own - expected).abs() < 1e-4,
                    "bone {joint}: {own}, {expected}"
                );
            }
        }
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
