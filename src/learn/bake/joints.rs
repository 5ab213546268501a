//! Sets of the rig's joints, by their indices in SMPL-X's order
//! ([`rig::BODY`](super::source::rig::BODY)).

/// Joints of an arm beyond the collar bone, hands and fingers included.
pub fn is_arm(joint: u8) -> bool {
    joint >= 16
}

/// Joints of a hand and its fingers.
pub fn is_hand(joint: u8) -> bool {
    joint >= 20
}

/// Knee, ankle and toes: the joints that move the leg below the hip.
pub fn is_lower_leg(joint: u8) -> bool {
    matches!(joint, 4 | 5) || is_foot(joint)
}

/// Ankle and toes.
pub fn is_foot(joint: u8) -> bool {
    matches!(joint, 7 | 8 | 10 | 11)
}

/// The head.
pub fn is_head(joint: u8) -> bool {
    joint == 15
}

/// The head, the neck and the uppermost joint of the spine.
pub fn is_head_or_chest(joint: u8) -> bool {
    matches!(joint, 9 | 12) || is_head(joint)
}
