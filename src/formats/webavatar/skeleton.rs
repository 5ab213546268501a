//! SMPL-X's skeleton in the pose that the exporter calls canonical.

use crate::smpl_joints::{SMPL_X, SmplJoint};
use effigy_core::avatar::Skeleton;

/// How far outwards both hips turn in the canonical pose of the exporter, degrees.
const CANONICAL_HIPS: f64 = 25.0;

/// The axis-angle rotation of a joint in the canonical pose, radians.
pub fn canonical(joint: usize) -> [f32; 3] {
    let turn = CANONICAL_HIPS.to_radians() as f32;
    match joint {
        1 => [0.0, 0.0, turn],
        2 => [0.0, 0.0, -turn],
        _ => [0.0; 3],
    }
}

/// SMPL-X's skeleton with these joints in the rest pose, metres.
pub fn smpl_x(rest: Vec<[f32; 3]>) -> Skeleton {
    Skeleton {
        name: SMPL_X.iter().map(|joint| joint.name.into()).collect(),
        parent: SMPL_X.iter().map(|joint| joint.parent).collect(),
        rest,
        canonical: (0..SMPL_X.len()).map(canonical).collect(),
    }
}

/// Whether a skeleton is the model's own: SMPL-X's joints by number, names and parents, so that poses
/// of one body are poses of another as they are.
pub fn is_own_skeleton(skeleton: &Skeleton) -> bool {
    let names = skeleton.name.iter().map(String::as_str);
    names.eq(SMPL_X.iter().map(|joint| joint.name))
        && skeleton
            .parent
            .iter()
            .copied()
            .eq(SMPL_X.iter().map(|joint| joint.parent))
}

/// For each joint of SMPL-X, which of a skeleton's joints it is, by name.
pub fn places(skeleton: &Skeleton) -> Vec<Option<usize>> {
    let place = |joint: &SmplJoint| skeleton.name.iter().position(|name| name == joint.name);
    SMPL_X.iter().map(place).collect()
}
