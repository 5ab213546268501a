//! Bends a leg so that its ankle is where it should be.

use super::{
    humanoid::Leg,
    tree::{positions, rotation},
    turn,
};
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DMat3, DQuat, DVec3};

/// Bones that are shorter, metres, are none.
const SHORTEST: f64 = 1e-4;

/// Turns thigh and shin so that the ankle comes to a place, or as near as the leg is long. The knee
/// stays in the plane that it was in, and the foot keeps its direction.
pub fn bend(skeleton: &Skeleton, pose: &mut Pose, leg: &Leg, goal: DVec3) {
    let joints = skeleton.joints(pose);
    let at = positions(&joints);
    let [hip, knee, ankle] = [leg.thigh, leg.shin, leg.foot].map(|joint| at[joint]);
    if ankle.distance(goal) < 1e-6 {
        return;
    }
    let [thigh, shin, foot] = [leg.thigh, leg.shin, leg.foot].map(|joint| rotation(&joints[joint]));
    let lengths = [hip.distance(knee), knee.distance(ankle)];
    if !(lengths[0].min(lengths[1]) > SHORTEST && goal.is_finite()) {
        return;
    }
    let Some(way) = (goal - hip).try_normalize() else {
        return;
    };
    let shortest = (lengths[0] - lengths[1]).abs() + 1e-6;
    let longest = lengths[0] + lengths[1] - 1e-9;
    let reach = hip.distance(goal).max(shortest).min(longest);
    let old_way = (ankle - hip).normalize_or(way);
    // Knees point forward where the leg is straight: across is the thigh's own x.
    let bent = (knee - hip).reject_from(old_way);
    let old_front = if bent.length() > 1e-4 * lengths[0] {
        bent.normalize()
    } else {
        (thigh * DVec3::Z)
            .reject_from(old_way)
            .normalize_or(DVec3::Z)
    };
    let front = DQuat::from_rotation_arc(old_way, way) * old_front;
    let cosine =
        (lengths[0].powi(2) + reach * reach - lengths[1].powi(2)) / (2.0 * lengths[0] * reach);
    let cosine = cosine.clamp(-1.0, 1.0);
    let sine = (1.0 - cosine * cosine).sqrt();
    let new_knee = hip + lengths[0] * (cosine * way + sine * front);
    let new_ankle = hip + reach * way;
    let moved = |from: DVec3, to: DVec3| {
        let frame = |along: DVec3, front: DVec3, way: DVec3| {
            let along = along.normalize_or(way);
            let across = way.cross(front);
            DMat3::from_cols(along, across, along.cross(across))
        };
        let turn = frame(to, front, way) * frame(from, old_front, old_way).transpose();
        DQuat::from_mat3(&turn).normalize()
    };
    let new_thigh = moved(knee - hip, new_knee - hip) * thigh;
    let new_shin = moved(ankle - knee, new_ankle - new_knee) * shin;
    // What is above a bone turns as the bone above it does.
    let local = |joint: usize, old: DQuat, new: DQuat, above: DQuat| {
        (above * turn::parent(pose, joint, old)).inverse() * new
    };
    let own_thigh = local(leg.thigh, thigh, new_thigh, DQuat::IDENTITY);
    let own_shin = local(leg.shin, shin, new_shin, new_thigh * thigh.inverse());
    let own_foot = local(leg.foot, foot, foot, new_shin * shin.inverse());
    turn::set(pose, leg.thigh, own_thigh);
    turn::set(pose, leg.shin, own_shin);
    turn::set(pose, leg.foot, own_foot);
}
