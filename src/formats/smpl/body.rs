//! Joints of an average body at rest: a T-pose, x to the person's left, y up, z forward.
//!
//! SMPL's files have no skeleton: it follows from the model, whose licence keeps it from being
//! here, and from numbers of a shape. These places are our own, in whole centimetres. They serve
//! directions and scale, which retargeting takes from a rest pose; nothing else.

use crate::{
    capture::CaptureJoint,
    smpl_joints::{BODY, SMPL_X},
};
use glam::{DQuat, DVec3};

/// Which model a file's numbers are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// SMPL and SMPL-H.
    Smpl,
    SmplX,
}

/// Offsets from the parent of joints 1 to 24, metres.
const OFFSETS: [[f64; 3]; 25] = [
    [0.0, 0.0, 0.0],
    [0.06, -0.09, -0.01],
    [-0.06, -0.09, -0.01],
    [0.0, 0.11, -0.03],
    [0.04, -0.38, 0.0],
    [-0.04, -0.38, 0.0],
    [0.0, 0.14, 0.0],
    [-0.01, -0.41, -0.04],
    [0.01, -0.41, -0.04],
    [0.0, 0.06, 0.03],
    [0.03, -0.06, 0.12],
    [-0.03, -0.06, 0.12],
    [0.0, 0.21, -0.03],
    [0.08, 0.12, -0.02],
    [-0.08, 0.12, -0.02],
    [0.0, 0.09, 0.05],
    [0.1, 0.04, -0.02],
    [-0.1, 0.04, -0.02],
    [0.26, -0.01, -0.02],
    [-0.26, -0.01, -0.02],
    [0.25, 0.01, 0.0],
    [-0.25, 0.01, 0.0],
    [0.0, -0.01, 0.0],
    [0.03, 0.05, 0.07],
    [-0.03, 0.05, 0.07],
];
/// Of the left hand's fingers, from the wrist outwards; the right hand mirrors them.
const FINGERS: [[f64; 3]; 15] = [
    [0.1, 0.0, 0.02],
    [0.03, 0.0, 0.0],
    [0.02, 0.0, 0.0],
    [0.11, 0.0, 0.0],
    [0.03, 0.0, 0.0],
    [0.03, 0.0, 0.0],
    [0.08, -0.01, -0.04],
    [0.02, 0.0, -0.01],
    [0.02, 0.0, -0.01],
    [0.09, 0.0, -0.02],
    [0.03, 0.0, 0.0],
    [0.03, 0.0, 0.0],
    [0.04, -0.02, 0.03],
    [0.03, 0.0, 0.02],
    [0.02, 0.0, 0.02],
];
/// First finger joint of the left hand, and of the right.
const LEFT_FINGERS: usize = 25;
const RIGHT_FINGERS: usize = 40;

/// Where a joint of SMPL-X is at rest relative to its parent, metres; of the root: where the pelvis
/// is in the model's own axes, to which a file's translation is added.
pub fn offset(joint: usize, family: Family) -> DVec3 {
    let mirrored = |[x, y, z]: [f64; 3]| [-x, y, z];
    let offset = match joint {
        0 => match family {
            Family::Smpl => [0.0, -0.22, 0.03],
            Family::SmplX => [0.0, -0.35, 0.01],
        },
        RIGHT_FINGERS.. => mirrored(FINGERS[joint - RIGHT_FINGERS]),
        LEFT_FINGERS.. => FINGERS[joint - LEFT_FINGERS],
        _ => OFFSETS[joint],
    };
    DVec3::from(offset)
}

/// Joints of SMPL-X at rest, as its files that say no rest pose have them.
pub fn joints(family: Family, kept: impl Fn(usize) -> bool) -> Vec<CaptureJoint> {
    let mut places = [None; SMPL_X.len()];
    let mut joints = vec![];
    for (at, joint) in SMPL_X.iter().enumerate().filter(|&(at, _)| kept(at)) {
        places[at] = Some(joints.len());
        joints.push(CaptureJoint {
            name: joint.name.into(),
            parent: joint.parent.and_then(|parent| places[usize::from(parent)]),
            offset: offset(at, family),
            rest: DQuat::IDENTITY,
        });
    }
    joints
}

/// From the pelvis to the middle between the hip joints, metres.
pub fn between_hips() -> DVec3 {
    (DVec3::from(OFFSETS[1]) + DVec3::from(OFFSETS[2])) / 2.0
}

const _: () = assert!(SMPL_X.len() == RIGHT_FINGERS + FINGERS.len());
const _: () = assert!(OFFSETS.len() == LEFT_FINGERS && BODY < LEFT_FINGERS);
