//! The tree of joints of SMPL, SMPL-H and SMPL-X, which their files leave out.

/// Joints of the body: SMPL-X's 0 to 21.
pub const BODY: usize = 22;

/// A joint of SMPL-X.
pub struct SmplJoint {
    /// The name that Effigy's own avatars and clips have for it.
    pub name: &'static str,
    pub parent: Option<u8>,
}

const fn joint(name: &'static str, parent: u8) -> SmplJoint {
    SmplJoint {
        name,
        parent: Some(parent),
    }
}

/// The tree of SMPL-X, in its order. SMPL-H has the same without 22 to 24.
pub const SMPL_X: [SmplJoint; 55] = [
    SmplJoint {
        name: "Hips",
        parent: None,
    },
    joint("LeftUpLeg", 0),
    joint("RightUpLeg", 0),
    joint("Spine", 0),
    joint("LeftLeg", 1),
    joint("RightLeg", 2),
    joint("Spine1", 3),
    joint("LeftFoot", 4),
    joint("RightFoot", 5),
    joint("Spine2", 6),
    joint("LeftToeBase", 7),
    joint("RightToeBase", 8),
    joint("Neck", 9),
    joint("LeftShoulder", 9),
    joint("RightShoulder", 9),
    joint("Head", 12),
    joint("LeftArm", 13),
    joint("RightArm", 14),
    joint("LeftForeArm", 16),
    joint("RightForeArm", 17),
    joint("LeftHand", 18),
    joint("RightHand", 19),
    joint("Jaw", 15),
    joint("LeftEye", 15),
    joint("RightEye", 15),
    joint("LeftHandIndex1", 20),
    joint("LeftHandIndex2", 25),
    joint("LeftHandIndex3", 26),
    joint("LeftHandMiddle1", 20),
    joint("LeftHandMiddle2", 28),
    joint("LeftHandMiddle3", 29),
    joint("LeftHandPinky1", 20),
    joint("LeftHandPinky2", 31),
    joint("LeftHandPinky3", 32),
    joint("LeftHandRing1", 20),
    joint("LeftHandRing2", 34),
    joint("LeftHandRing3", 35),
    joint("LeftHandThumb1", 20),
    joint("LeftHandThumb2", 37),
    joint("LeftHandThumb3", 38),
    joint("RightHandIndex1", 21),
    joint("RightHandIndex2", 40),
    joint("RightHandIndex3", 41),
    joint("RightHandMiddle1", 21),
    joint("RightHandMiddle2", 43),
    joint("RightHandMiddle3", 44),
    joint("RightHandPinky1", 21),
    joint("RightHandPinky2", 46),
    joint("RightHandPinky3", 47),
    joint("RightHandRing1", 21),
    joint("RightHandRing2", 49),
    joint("RightHandRing3", 50),
    joint("RightHandThumb1", 21),
    joint("RightHandThumb2", 52),
    joint("RightHandThumb3", 53),
];
