//! Rotations of a pose's joints.

use effigy_core::avatar::Pose;
use glam::DQuat;

/// The quaternion of the same rotation that turns by at most half a circle.
pub fn shorter(q: DQuat) -> DQuat {
    let q = q.normalize();
    if q.w < 0.0 { -q } else { q }
}

/// Gives a joint a rotation relative to its parent.
pub fn set(pose: &mut Pose, joint: usize, local: DQuat) {
    pose.rotation[joint] = shorter(local).to_scaled_axis();
}

/// The rotation of a joint's parent. `world`: the joint's own in the pose.
pub fn parent(pose: &Pose, joint: usize, world: DQuat) -> DQuat {
    world * DQuat::from_scaled_axis(pose.rotation[joint]).inverse()
}
