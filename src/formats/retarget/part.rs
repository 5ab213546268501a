//! Parts of a body, as both skeletons have them.

use std::fmt;

/// A side of the body, the person's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The person's left.
    Left,
    /// The person's right.
    Right,
}

impl Side {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Left, Self::Right];
}

/// A bone of a limb. It begins at the joint that turns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bone {
    /// From the breastbone to the shoulder.
    Clavicle,
    /// From the shoulder to the elbow.
    UpperArm,
    /// From the elbow to the wrist.
    Forearm,
    /// From the wrist.
    Hand,
    /// From the hip to the knee.
    Thigh,
    /// From the knee to the ankle.
    Shin,
    /// From the ankle to the ball.
    Foot,
    /// From the ball.
    Toe,
}

impl Bone {
    /// From the trunk outwards.
    pub const ALL: [Self; 8] = [
        Self::Clavicle,
        Self::UpperArm,
        Self::Forearm,
        Self::Hand,
        Self::Thigh,
        Self::Shin,
        Self::Foot,
        Self::Toe,
    ];

    /// The name of the joint that it begins at, in Effigy's own rigs and without its side.
    fn name(self) -> &'static str {
        match self {
            Self::Clavicle => "Shoulder",
            Self::UpperArm => "Arm",
            Self::Forearm => "ForeArm",
            Self::Hand => "Hand",
            Self::Thigh => "UpLeg",
            Self::Shin => "Leg",
            Self::Foot => "Foot",
            Self::Toe => "ToeBase",
        }
    }
}

/// A part of a body. The spine and the neck are what lies between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The pelvis.
    Hips,
    /// Where the neck begins.
    Neck,
    /// The skull.
    Head,
    /// The lower jaw.
    Jaw,
    /// An eye.
    Eye(Side),
    /// A bone of a limb.
    Bone {
        /// Whose.
        side: Side,
        /// Which.
        bone: Bone,
    },
    /// A joint of a finger.
    Finger {
        /// Whose.
        side: Side,
        /// 0 is the thumb, 4 the little finger.
        finger: usize,
    },
}

/// The name that Effigy's own rigs have for the part, without the number of a finger's joint.
impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Hips => write!(f, "Hips"),
            Self::Neck => write!(f, "Neck"),
            Self::Head => write!(f, "Head"),
            Self::Jaw => write!(f, "Jaw"),
            Self::Eye(side) => write!(f, "{side:?}Eye"),
            Self::Bone { side, bone } => write!(f, "{side:?}{}", bone.name()),
            Self::Finger { side, finger } => {
                let name = ["Thumb", "Index", "Middle", "Ring", "Pinky"][*finger];
                write!(f, "{side:?}Hand{name}")
            }
        }
    }
}

impl Part {
    /// The part of a name that [`Part`]'s `Display` gives, except fingers.
    pub fn named(name: &str) -> Option<Self> {
        let bones = Side::ALL.into_iter().flat_map(|side| {
            let bone = move |bone| Self::Bone { side, bone };
            Bone::ALL.into_iter().map(bone)
        });
        let single = [Self::Hips, Self::Neck, Self::Head, Self::Jaw];
        let eyes = Side::ALL.map(Self::Eye);
        let mut all = bones.chain(single).chain(eyes);
        all.find(|part| part.to_string() == name)
    }
}
