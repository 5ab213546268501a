//! Fingers where a capture has none.

use super::humanoid::Arm;
use effigy_core::avatar::Skeleton;
use glam::{DQuat, DVec3};

/// Degrees that the joints of a finger curl, from the palm on.
const CURL: [f64; 3] = [14.0, 22.0, 16.0];
/// Degrees that each finger curls more than the one before it, from the index finger on.
const STEP: f64 = 3.0;

/// A relaxed curl of the fingers towards the palm, the thumb left out: joints and their rotations.
pub fn curl(skeleton: &Skeleton, arm: &Arm) -> Vec<(usize, DQuat)> {
    turns(skeleton, arm).unwrap_or_default()
}

fn turns(skeleton: &Skeleton, arm: &Arm) -> Option<Vec<(usize, DQuat)>> {
    let from_hand = |joint: usize| {
        let place = |joint: usize| DVec3::from(skeleton.rest[joint].map(f64::from));
        place(joint) - place(arm.hand)
    };
    let knuckle = |finger: usize| Some(from_hand(*arm.fingers[finger].first()?));
    let palm = knuckle(1)?.cross(knuckle(4)?).try_normalize()?;
    // The palm's normal points to the thumb's side.
    let thumb = from_hand(*arm.fingers[0].last()?);
    let palm = palm * thumb.dot(palm).signum();
    let along = knuckle(2)?.reject_from_normalized(palm).try_normalize()?;
    let axis = along.cross(palm).try_normalize()?;
    let mut turns = vec![];
    for (finger, joints) in arm.fingers[1..].iter().enumerate() {
        for (joint, degrees) in joints.iter().zip(CURL) {
            let degrees = degrees + STEP * finger as f64;
            turns.push((*joint, DQuat::from_axis_angle(axis, degrees.to_radians())));
        }
    }
    Some(turns)
}
