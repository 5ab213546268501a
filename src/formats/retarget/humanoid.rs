//! The parts of a body among a tree's joints, by their names, else by the tree's shape.

use super::{
    names,
    part::{Bone, Part, Side},
    shape,
    tree::Tree,
};
use crate::capture::Capture;
use effigy_core::io::file::{FormatError, excerpt};
use glam::DVec3;

/// Which joints begin the bones of an arm.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// The collar bone.
    pub clavicle: Option<usize>,
    /// The shoulder.
    pub upper: usize,
    /// The elbow.
    pub forearm: usize,
    /// The wrist.
    pub hand: usize,
    /// Up to three joints each, from the palm on; the thumb first. Empty: the hand has not at least
    /// three fingers.
    pub fingers: [Vec<usize>; 5],
}

/// Which joints begin the bones of a leg.
#[derive(Clone, Debug, PartialEq)]
pub struct Leg {
    /// The hip joint.
    pub thigh: usize,
    /// The knee.
    pub shin: usize,
    /// The ankle.
    pub foot: usize,
    /// The ball.
    pub toe: Option<usize>,
}

impl Leg {
    /// The joint of the ball, else what hangs from the ankle first. `children`: of each joint.
    pub fn ball(&self, children: &[Vec<usize>]) -> Option<usize> {
        self.toe.or_else(|| children[self.foot].first().copied())
    }
}

/// A body's joints in a tree. The left limb comes first.
#[derive(Clone, Debug, PartialEq)]
pub struct Humanoid {
    /// Above everything else.
    pub hips: usize,
    /// Those above the hips, up to the one that carries the arms. May be empty.
    pub spine: Vec<usize>,
    /// Those between the spine and the head. May be empty.
    pub neck: Vec<usize>,
    /// The skull.
    pub head: usize,
    /// The lower jaw.
    pub jaw: Option<usize>,
    /// Both eyes.
    pub eyes: [Option<usize>; 2],
    /// Both arms.
    pub arms: [Arm; 2],
    /// Both legs; None: an upper body alone.
    pub legs: Option<[Leg; 2]>,
}

/// A joint's part, as its user says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Correction {
    /// The part: `LeftArm`, as Effigy's own rigs name their joints.
    pub part: String,
    /// The joint's name in the file.
    pub joint: String,
}

/// The joints of one part.
fn joints_of(parts: &[Option<Part>], part: Part) -> impl Iterator<Item = usize> {
    let indices = parts.iter().enumerate();
    indices.filter_map(move |(joint, own)| (*own == Some(part)).then_some(joint))
}

impl Humanoid {
    /// Finds a body. `corrections` go before names, names before the tree's shape; a body with legs
    /// goes before one without. `motion`: how the tree moves, where that is known.
    ///
    /// # Errors
    /// When no two arms and a head are found, or a correction names no part or joint.
    pub fn find(
        tree: &Tree,
        motion: Option<&Capture>,
        corrections: &[Correction],
    ) -> Result<Self, FormatError> {
        let mut parts = names::parts(&tree.names);
        let mut found = Self::of_parts(tree, &parts);
        if found.as_ref().is_none_or(|body| body.legs.is_none())
            && let Some(by_shape) = shape::parts(tree, motion)
            && let Some(body) = Self::of_parts(tree, &by_shape)
        {
            parts = by_shape;
            found = Some(body);
        }
        if !corrections.is_empty() {
            for correction in corrections {
                correct(tree, &mut parts, correction)?;
            }
            found = Self::of_parts(tree, &parts);
        }
        found.ok_or_else(|| {
            let missing: Vec<String> = essential()
                .filter(|part| joints_of(&parts, *part).next().is_none())
                .map(|part| part.to_string())
                .collect();
            let names: Vec<&str> = tree.names.iter().take(8).map(String::as_str).collect();
            FormatError::container(
                format!(
                    "no body among {} joints ({}, …)",
                    tree.len(),
                    excerpt(&names.join(", "))
                ),
                if missing.is_empty() {
                    "a head above two arms whose joints follow each other".into()
                } else {
                    format!(
                        "two arms and a head, of which {} were not found: say which joint each is",
                        missing.join(", ")
                    )
                },
            )
        })
    }

    fn of_parts(tree: &Tree, parts: &[Option<Part>]) -> Option<Self> {
        let [left_leg, right_leg] = Side::ALL.map(|side| leg(tree, parts, side));
        let legs = left_leg.zip(right_leg).map(|(left, right)| [left, right]);
        let [left_arm, right_arm] = Side::ALL.map(|side| arm(tree, parts, side));
        let arms = [left_arm?, right_arm?];
        let shoulders = [arms[0].upper, arms[1].upper];
        let mut chest = tree.fork(&shoulders)?;
        // Some rigs hang the arms from the neck.
        while parts[chest] == Some(Part::Neck) {
            chest = tree.parents[chest]?;
        }
        let hips = match &legs {
            Some([left, right]) => tree.fork(&[left.thigh, right.thigh, chest])?,
            None => lowest_of_trunk(tree, parts, chest),
        };
        // A head that is not above the arms belongs to somebody else.
        let head = joints_of(parts, Part::Head).find(|&head| tree.is_above(chest, head))?;
        // Jaw and eyes may be another person's too.
        let of_head = |part: Part| joints_of(parts, part).find(|&joint| tree.is_above(head, joint));
        let mut neck = tree.path(chest, head);
        neck.pop();
        Some(Self {
            hips,
            spine: tree.path(hips, chest),
            neck,
            head,
            jaw: of_head(Part::Jaw),
            eyes: Side::ALL.map(|side| of_head(Part::Eye(side))),
            arms,
            legs,
        })
    }

    /// Where the arms begin.
    pub fn chest(&self) -> usize {
        self.spine.last().copied().unwrap_or(self.hips)
    }

    /// What is next above the chest: the neck, else the head.
    pub fn above_chest(&self) -> usize {
        self.neck.first().copied().unwrap_or(self.head)
    }

    /// Both legs, or none.
    pub fn legs(&self) -> &[Leg] {
        self.legs.as_ref().map_or(&[], |legs| legs)
    }

    /// The joints at which both legs begin; without legs, both arms.
    pub fn lowest_limbs(&self) -> [usize; 2] {
        match &self.legs {
            Some(legs) => legs.each_ref().map(|leg| leg.thigh),
            None => self.arms.each_ref().map(|arm| arm.upper),
        }
    }

    /// Half way between the hip joints; the hips of a body without legs. `at`: where joints are.
    pub fn middle_of_hips(&self, at: &[DVec3]) -> DVec3 {
        match &self.legs {
            Some([left, right]) => (at[left.thigh] + at[right.thigh]) / 2.0,
            None => at[self.hips],
        }
    }

    /// Half way between the ankles. `at`: where joints are.
    pub fn middle_of_feet(&self, at: &[DVec3]) -> Option<DVec3> {
        let [left, right] = self.legs.as_ref()?;
        Some((at[left.foot] + at[right.foot]) / 2.0)
    }

    /// Lengths of thigh and shin together, the mean of both sides. `at`: where joints are.
    pub fn leg_length(&self, at: &[DVec3]) -> Option<f64> {
        let [left, right] = self.legs.as_ref()?.each_ref();
        let length = |leg: &Leg| way(at, [leg.thigh, leg.shin, leg.foot]);
        Some((length(left) + length(right)) / 2.0)
    }

    /// Lengths of upper arm and forearm together, the mean of both sides. `at`: where joints are.
    pub fn arm_length(&self, at: &[DVec3]) -> f64 {
        let [left, right] = self.arms.each_ref();
        let length = |arm: &Arm| way(at, [arm.upper, arm.forearm, arm.hand]);
        (length(left) + length(right)) / 2.0
    }

    /// Each part that was found and its joint, for people.
    pub fn named<'a>(&self, tree: &'a Tree) -> Vec<NamedPart<'a>> {
        let mut list = vec![];
        let mut add = |part: String, joint: usize| {
            let joint = tree.names[joint].as_str();
            list.push(NamedPart { part, joint });
        };
        add(Part::Hips.to_string(), self.hips);
        for (at, &joint) in self.spine.iter().enumerate() {
            add(format!("spine {}", at + 1), joint);
        }
        for (at, &joint) in self.neck.iter().enumerate() {
            add(format!("neck {}", at + 1), joint);
        }
        add(Part::Head.to_string(), self.head);
        let face = [Part::Jaw, Part::Eye(Side::Left), Part::Eye(Side::Right)];
        for (part, joint) in face.into_iter().zip([self.jaw, self.eyes[0], self.eyes[1]]) {
            if let Some(joint) = joint {
                add(part.to_string(), joint);
            }
        }
        for (at, (side, arm)) in Side::ALL.into_iter().zip(&self.arms).enumerate() {
            let leg = self.legs().get(at);
            let bones = [
                (Bone::Clavicle, arm.clavicle),
                (Bone::UpperArm, Some(arm.upper)),
                (Bone::Forearm, Some(arm.forearm)),
                (Bone::Hand, Some(arm.hand)),
                (Bone::Thigh, leg.map(|leg| leg.thigh)),
                (Bone::Shin, leg.map(|leg| leg.shin)),
                (Bone::Foot, leg.map(|leg| leg.foot)),
                (Bone::Toe, leg.and_then(|leg| leg.toe)),
            ];
            for (bone, joint) in bones {
                if let Some(joint) = joint {
                    add(Part::Bone { side, bone }.to_string(), joint);
                }
            }
            for (finger, joints) in arm.fingers.iter().enumerate() {
                for (at, &joint) in joints.iter().enumerate() {
                    add(
                        format!("{}{}", Part::Finger { side, finger }, at + 1),
                        joint,
                    );
                }
            }
        }
        list
    }
}

/// From a joint to a second one and on to a third.
fn way(at: &[DVec3], [a, b, c]: [usize; 3]) -> f64 {
    at[a].distance(at[b]) + at[b].distance(at[c])
}

/// A part and its joint's name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedPart<'a> {
    /// Its name in Effigy's own rigs.
    pub part: String,
    /// The joint's name in the file.
    pub joint: &'a str,
}

/// The parts without which no body is found.
fn essential() -> impl Iterator<Item = Part> {
    [Bone::UpperArm, Bone::Forearm, Bone::Hand]
        .into_iter()
        .flat_map(|bone| Side::ALL.map(|side| Part::Bone { side, bone }))
        .chain([Part::Head])
}

fn correct(
    tree: &Tree,
    parts: &mut [Option<Part>],
    correction: &Correction,
) -> Result<(), FormatError> {
    let Some(part) = Part::named(&correction.part) else {
        return Err(FormatError::metadata(
            &excerpt(&correction.part),
            "no part of that name",
            "Hips, Neck, Head, LeftArm, LeftForeArm, …; spines and fingers follow from the others",
        ));
    };
    let named = |name: &String| *name == correction.joint;
    let Some(joint) = tree.names.iter().position(named) else {
        let found = format!("`{}`", excerpt(&correction.joint));
        let expected = "a joint of the file";
        return Err(FormatError::metadata(&correction.part, found, expected));
    };
    for own in parts.iter_mut().filter(|own| **own == Some(part)) {
        *own = None;
    }
    parts[joint] = Some(part);
    Ok(())
}

/// The lowest joint of a bone that is above another joint: rigs put helpers of the same name above.
fn bone_above(
    tree: &Tree,
    parts: &[Option<Part>],
    side: Side,
    bone: Bone,
    below: usize,
) -> Option<usize> {
    let part = Some(Part::Bone { side, bone });
    let mut above = tree.chain_up(below).skip(1);
    above.find(|&joint| parts[joint] == part)
}

/// The lower end of a trunk without legs: what is named so, else the root.
fn lowest_of_trunk(tree: &Tree, parts: &[Option<Part>], chest: usize) -> usize {
    let named = |joint: &usize| parts[*joint] == Some(Part::Hips);
    let hips = tree.chain_up(chest).find(named);
    hips.or_else(|| tree.chain_up(chest).last())
        .unwrap_or(chest)
}

fn arm(tree: &Tree, parts: &[Option<Part>], side: Side) -> Option<Arm> {
    let hands = Part::Bone {
        side,
        bone: Bone::Hand,
    };
    let above = |bone, below| bone_above(tree, parts, side, bone, below);
    joints_of(parts, hands).find_map(|hand| {
        let forearm = above(Bone::Forearm, hand)?;
        let upper = above(Bone::UpperArm, forearm)?;
        Some(Arm {
            clavicle: above(Bone::Clavicle, upper),
            upper,
            forearm,
            hand,
            fingers: fingers(tree, parts, side, hand),
        })
    })
}

fn fingers(tree: &Tree, parts: &[Option<Part>], side: Side, hand: usize) -> [Vec<usize>; 5] {
    let fingers = [0, 1, 2, 3, 4].map(|finger| {
        let part = Part::Finger { side, finger };
        let below = joints_of(parts, part).filter(|&joint| tree.is_above(hand, joint));
        // A fourth one is the finger's tip.
        below.take(3).collect::<Vec<usize>>()
    });
    let found = fingers.iter().filter(|joints| !joints.is_empty()).count();
    if found < 3 {
        return std::array::from_fn(|_| vec![]);
    }
    fingers
}

fn leg(tree: &Tree, parts: &[Option<Part>], side: Side) -> Option<Leg> {
    let feet = Part::Bone {
        side,
        bone: Bone::Foot,
    };
    let toes = Part::Bone {
        side,
        bone: Bone::Toe,
    };
    let above = |bone, below| bone_above(tree, parts, side, bone, below);
    joints_of(parts, feet).find_map(|foot| {
        let shin = above(Bone::Shin, foot)?;
        Some(Leg {
            thigh: above(Bone::Thigh, shin)?,
            shin,
            foot,
            toe: joints_of(parts, toes).find(|&toe| tree.is_above(foot, toe)),
        })
    })
}
