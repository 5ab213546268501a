//! How the joints of a capture stand when the avatar is in its rest pose.
//!
//! A joint's world rotation W in a frame turns the avatar's joint by W Q⁻¹, where Q is W in a
//! *reference*: the pose of the capture in which its bones point where the avatar's do at rest.
//!
//! - If the capture's rest pose stands as a body does (T, A, arms lowered), the reference is the
//!   rest pose with each limb bone turned by the smallest rotation that aligns it. The trunk, collar
//!   bones and toes are taken as they are.
//! - Else (LaFAN1, Bandai-Namco: every bone lies along one axis at rest) it follows from where bones
//!   are in their joints' axes: two limbs leave hips and chest, whose third direction is that of the
//!   trunk while it stands; knuckles are across a hand; elbows and knees bend about one axis alone;
//!   all others are on average turned as the joint above them is.

use super::{
    humanoid::{Arm, Humanoid},
    tree::{Tree, positions, rotations, spread},
    upright::{self, Upright},
};
use glam::{DAffine3, DMat3, DQuat, DVec3};

/// What the references rest on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// The capture's rest pose.
    Rest,
    /// Its bones' axes and its motion.
    Motion,
}

/// The references of a capture's joints.
#[derive(Clone, Debug)]
pub struct Alignment {
    /// Q⁻¹ of each joint of the capture; the identity for those that nothing uses.
    pub inverse: Vec<DQuat>,
    /// What they rest on.
    pub basis: Basis,
}

/// Both bodies.
pub struct Bodies<'a> {
    /// The capture's joints.
    pub tree: &'a Tree,
    /// Its body.
    pub source: &'a Humanoid,
    /// The avatar's joints.
    pub target_tree: &'a Tree,
    /// Its body.
    pub target: &'a Humanoid,
}

/// A bone of both bodies: from a joint to another one.
#[derive(Clone, Copy)]
struct BonePair {
    joint: usize,
    end: usize,
    target: usize,
    target_end: usize,
}

impl Bodies<'_> {
    /// Where a bone of the avatar points at rest.
    fn target_along(&self, bone: BonePair) -> Option<DVec3> {
        let rest = &self.target_tree.rest;
        (rest[bone.target_end] - rest[bone.target]).try_normalize()
    }

    /// Bones of arms and legs and fingers, from the trunk outwards; without collar bones and feet.
    fn limb_bones(&self) -> Vec<BonePair> {
        let mut bones = vec![];
        let children = self.tree.children();
        for (own, theirs) in self.source.arms.iter().zip(&self.target.arms) {
            bones.push(BonePair {
                joint: own.upper,
                end: own.forearm,
                target: theirs.upper,
                target_end: theirs.forearm,
            });
            bones.push(BonePair {
                joint: own.forearm,
                end: own.hand,
                target: theirs.forearm,
                target_end: theirs.hand,
            });
            if let Some(bone) = hand_bone(self.tree, own, theirs) {
                bones.push(bone);
            }
            bones.extend(finger_bones(&children, own, theirs));
        }
        for (own, theirs) in self.source.legs().iter().zip(self.target.legs()) {
            bones.push(BonePair {
                joint: own.thigh,
                end: own.shin,
                target: theirs.thigh,
                target_end: theirs.shin,
            });
            bones.push(BonePair {
                joint: own.shin,
                end: own.foot,
                target: theirs.shin,
                target_end: theirs.foot,
            });
        }
        bones
    }
}

/// From the wrist to the knuckle of the middle finger, else to what is furthest from the wrist.
fn hand_bone(tree: &Tree, own: &Arm, theirs: &Arm) -> Option<BonePair> {
    let far = |joint: usize| tree.rest[joint].distance(tree.rest[own.hand]);
    let furthest = (0..tree.len())
        .filter(|&joint| tree.is_above(own.hand, joint) && far(joint) > 0.0)
        .max_by(|&a, &b| far(a).total_cmp(&far(b)));
    Some(BonePair {
        joint: own.hand,
        end: own.fingers[2].first().copied().or(furthest)?,
        target: theirs.hand,
        target_end: *theirs.fingers[2].first()?,
    })
}

fn finger_bones(children: &[Vec<usize>], own: &Arm, theirs: &Arm) -> Vec<BonePair> {
    let mut bones = vec![];
    for (own, theirs) in own.fingers.iter().zip(&theirs.fingers) {
        for (at, (&joint, &target)) in own.iter().zip(theirs).enumerate() {
            let end = own.get(at + 1).or_else(|| children[joint].first());
            if let (Some(&end), Some(&target_end)) = (end, theirs.get(at + 1)) {
                bones.push(BonePair {
                    joint,
                    end,
                    target,
                    target_end,
                });
            }
        }
    }
    bones
}

impl Alignment {
    /// The references of a capture.
    pub fn new(bodies: &Bodies, upright: &Upright) -> Self {
        let capture = upright.capture();
        match upright::rest_up(capture, bodies.source, upright.up()) {
            Some(up) => Self {
                inverse: from_rest(bodies, &Upright::new(capture, up).rest()),
                basis: Basis::Rest,
            },
            None => Self {
                inverse: BoneMotion::new(bodies, upright).references(),
                basis: Basis::Motion,
            },
        }
    }
}

/// The rotation about the vertical that makes this body face +z: its left is at +x.
fn heading(source: &Humanoid, at: &[DVec3]) -> DQuat {
    let [left, right] = source.lowest_limbs().map(|joint| at[joint]);
    let across = left - right;
    DQuat::from_rotation_y(across.z.atan2(across.x))
}

/// `world`: the capture's rest pose, y up.
fn from_rest(bodies: &Bodies, world: &[DAffine3]) -> Vec<DQuat> {
    let at = positions(world);
    let turn = heading(bodies.source, &at);
    // What turns each limb bone from where it is at rest to where the avatar's is. A bone is turned
    // as the one above it first, so that what is left is small, and does not twist it.
    let mut turns: Vec<Option<DQuat>> = vec![None; bodies.tree.len()];
    let mut align = |joint: usize, from: DVec3, to: DVec3| {
        let mut above = bodies.tree.chain_up(joint).skip(1);
        let above = above
            .find_map(|above| turns[above])
            .unwrap_or(DQuat::IDENTITY);
        if let (Some(from), Some(to)) = ((above * from).try_normalize(), to.try_normalize()) {
            turns[joint] = Some(DQuat::from_rotation_arc(from, to) * above);
        }
    };
    for bone in bodies.limb_bones() {
        if let Some(to) = bodies.target_along(bone) {
            align(bone.joint, turn * (at[bone.end] - at[bone.joint]), to);
        }
    }
    // Hands and fingers without a bone are turned as what they hang from.
    for arm in &bodies.source.arms {
        for &joint in [arm.hand].iter().chain(arm.fingers.iter().flatten()) {
            let mut above = bodies.tree.chain_up(joint);
            turns[joint] = above.find_map(|above| turns[above]);
        }
    }
    let children = bodies.tree.children();
    let target_rest = &bodies.target_tree.rest;
    for (own, theirs) in bodies.source.legs().iter().zip(bodies.target.legs()) {
        // Soles are flat in both rest poses: only the direction over the ground is aligned.
        let ball = own.ball(&children);
        if let (Some(ball), Some(their_ball)) = (ball, theirs.toe) {
            let from = (turn * (at[ball] - at[own.foot])).with_y(0.0);
            let to = (target_rest[their_ball] - target_rest[theirs.foot]).with_y(0.0);
            if let (Some(from), Some(to)) = (from.try_normalize(), to.try_normalize()) {
                let flat = Some(DQuat::from_rotation_arc(from, to));
                turns[own.foot] = flat;
                if let Some(toe) = own.toe {
                    turns[toe] = flat;
                }
            }
        }
    }
    let own = rotations(world).into_iter().zip(turns);
    own.map(|(own, limb)| (limb.unwrap_or(DQuat::IDENTITY) * turn * own).inverse())
        .collect()
}

/// A rotation that takes a first direction to another, and a second one as near as it can.
fn from_two(from: [DVec3; 2], to: [DVec3; 2]) -> Option<DQuat> {
    let frame = |[first, second]: [DVec3; 2]| {
        let first = first.try_normalize()?;
        let second = second.reject_from_normalized(first).try_normalize()?;
        Some(DMat3::from_cols(first, second, first.cross(second)))
    };
    Some(DQuat::from_mat3(&(frame(to)? * frame(from)?.transpose())).normalize())
}

/// The mean of rotations that are not far from each other.
fn mean(rotations: impl Iterator<Item = DQuat>) -> Option<DQuat> {
    let mut sum = DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0);
    for rotation in rotations {
        let same = if sum.dot(rotation) < 0.0 {
            -rotation
        } else {
            rotation
        };
        sum += same;
    }
    let length = sum.length();
    (length > 1e-9).then(|| sum / length)
}

/// References from bones' axes and the capture's motion.
struct BoneMotion<'a> {
    bodies: &'a Bodies<'a>,
    children: Vec<Vec<usize>>,
    /// Rotations and positions of all joints, in frames spread over the capture.
    frames: Vec<JointFrame>,
    inverse: Vec<DQuat>,
}

struct JointFrame {
    rotation: Vec<DQuat>,
    position: Vec<DVec3>,
}

/// How far a trunk that stands leans at most, radians.
const STANDING: f64 = 0.6;

/// From between the hips to where the neck begins.
fn trunk(humanoid: &Humanoid, at: &[DVec3]) -> DVec3 {
    at[humanoid.above_chest()] - humanoid.middle_of_hips(at)
}

/// Sum of sines of an elbow's or knee's bends, a frame each, above which its axis is known.
const BENT: f64 = 0.3;

impl<'a> BoneMotion<'a> {
    fn new(bodies: &'a Bodies<'a>, upright: &Upright) -> Self {
        let frames = spread(upright.capture().frames())
            .map(|frame| {
                let world = upright.world(frame);
                JointFrame {
                    rotation: rotations(&world),
                    position: positions(&world),
                }
            })
            .collect();
        Self {
            bodies,
            children: bodies.tree.children(),
            frames,
            inverse: vec![DQuat::IDENTITY; bodies.tree.len()],
        }
    }

    fn references(mut self) -> Vec<DQuat> {
        let source = self.bodies.source;
        let target = self.bodies.target;
        let target_rest = &self.bodies.target_tree.rest;
        self.inverse[source.hips] = self.hips().unwrap_or(DQuat::IDENTITY);
        let chest = source.chest();
        let own_chest = self.chest();
        if let Some(chest_inverse) = own_chest {
            self.inverse[chest] = chest_inverse;
        }
        let mut above = source.hips;
        for &joint in &source.spine {
            if joint != chest || own_chest.is_none() {
                self.follow(joint, above, None);
            }
            above = joint;
        }
        for &joint in source.neck.iter().chain([&source.head]) {
            self.follow(joint, above, None);
            above = joint;
        }
        if let Some(joint) = source.jaw {
            self.follow(joint, above, None);
        }
        for side in [0, 1] {
            let (own, theirs) = (&source.arms[side], &target.arms[side]);
            let mut above = chest;
            if let Some(clavicle) = own.clavicle {
                self.follow(clavicle, above, None);
                above = clavicle;
            }
            let along = target_rest[theirs.forearm] - target_rest[theirs.upper];
            // Elbows bend forwards: upper arm × forearm points along upper arm × forward.
            let hinge = along.cross(DVec3::Z);
            let limb = [own.upper, own.forearm, own.hand];
            let target_limb = [theirs.upper, theirs.forearm, theirs.hand];
            self.hinge(limb, target_limb, hinge, above);
            self.hand(own, theirs);
        }
        for (own, theirs) in source.legs().iter().zip(target.legs()) {
            let limb = [own.thigh, own.shin, own.foot];
            let target_limb = [theirs.thigh, theirs.shin, theirs.foot];
            self.hinge(limb, target_limb, DVec3::X, source.hips);
            let ball = own.ball(&self.children);
            let foot = ball.zip(theirs.toe).map(|(ball, their_ball)| BonePair {
                joint: own.foot,
                end: ball,
                target: theirs.foot,
                target_end: their_ball,
            });
            self.follow(own.foot, own.shin, foot);
            if let Some(toe) = own.toe {
                self.follow(toe, own.foot, None);
            }
        }
        self.inverse
    }

    /// Hips, from the thighs that leave them and the trunk; without legs, from the arms.
    fn hips(&self) -> Option<DQuat> {
        let Bodies { source, target, .. } = self.bodies;
        let across = match source.legs {
            Some(_) => [source.lowest_limbs(), target.lowest_limbs()],
            None => [source, target].map(|body| body.arms.each_ref().map(|arm| arm.upper)),
        };
        let next = source.spine.first().unwrap_or(&source.head);
        let target_next = target.spine.first().unwrap_or(&target.head);
        self.of_trunk([source.hips, target.hips], across, [*next, *target_next])
    }

    /// The chest, from the arms that leave it and the trunk.
    fn chest(&self) -> Option<DQuat> {
        let Bodies { source, target, .. } = self.bodies;
        if source.chest() == source.hips {
            return None;
        }
        let first = |arm: &Arm| arm.clavicle.unwrap_or(arm.upper);
        let arms = |humanoid: &Humanoid| humanoid.arms.each_ref().map(first);
        self.of_trunk(
            [source.chest(), target.chest()],
            [arms(source), arms(target)],
            [source.above_chest(), target.above_chest()],
        )
    }

    /// A joint of the trunk from the two limbs that leave it and the way of the whole trunk. Each
    /// pair: the capture's, the avatar's. `next`: the joint above, for a capture that never stands.
    fn of_trunk(
        &self,
        joint: [usize; 2],
        limbs: [[usize; 2]; 2],
        next: [usize; 2],
    ) -> Option<DQuat> {
        let target_rest = &self.bodies.target_tree.rest;
        let across = self.local(joint[0], limbs[0][0]) - self.local(joint[0], limbs[0][1]);
        let target_across = target_rest[limbs[1][0]] - target_rest[limbs[1][1]];
        let (up, target_up) = match self.trunk(joint[0]) {
            Some(up) => (up, trunk(self.bodies.target, target_rest)),
            None => (
                self.local(joint[0], next[0]),
                target_rest[next[1]] - target_rest[joint[1]],
            ),
        };
        from_two([across, up], [target_across, target_up]).map(|reference| reference.inverse())
    }

    /// The mean way of the trunk in a joint's axes, over frames in which it stands; None: it hardly
    /// ever does. Where bones of the spine begin differs from rig to rig more than how people stand.
    fn trunk(&self, joint: usize) -> Option<DVec3> {
        let mut sum = DVec3::ZERO;
        let mut count = 0;
        for frame in &self.frames {
            let way = trunk(self.bodies.source, &frame.position);
            if way.angle_between(DVec3::Y) < STANDING {
                sum += frame.rotation[joint].inverse() * way;
                count += 1;
            }
        }
        (10 * count > self.frames.len()).then_some(sum)
    }

    /// From a joint to one below it, in the upper one's axes, in the first frame: joints between
    /// them turn little.
    fn local(&self, joint: usize, below: usize) -> DVec3 {
        self.frames.first().map_or(DVec3::ZERO, |frame| {
            frame.rotation[joint].inverse() * (frame.position[below] - frame.position[joint])
        })
    }

    /// A joint that is on average turned as the one above it, and whose bone points along the
    /// avatar's.
    fn follow(&mut self, joint: usize, above: usize, bone: Option<BonePair>) {
        let inverse = mean(self.frames.iter().map(|frame| {
            frame.rotation[joint].inverse() * frame.rotation[above] * self.inverse[above]
        }));
        let mut inverse = inverse.unwrap_or(DQuat::IDENTITY);
        if let Some(bone) = bone
            && let Some(to) = self.bodies.target_along(bone)
            && let Some(along) = self.local(joint, bone.end).try_normalize()
        {
            let reference = inverse.inverse();
            let turned = DQuat::from_rotation_arc(reference * along, to) * reference;
            inverse = turned.inverse();
        }
        self.inverse[joint] = inverse;
    }

    /// Two bones that bend about one axis. `hinge`: that axis in the avatar's rest pose, so that
    /// first × second bone points along it.
    fn hinge(&mut self, limb: [usize; 3], target: [usize; 3], hinge: DVec3, above: usize) {
        let mut axes = [DVec3::ZERO; 2];
        for frame in &self.frames {
            let at = limb.map(|joint| frame.position[joint]);
            let [first, second] = [at[1] - at[0], at[2] - at[1]].map(DVec3::normalize_or_zero);
            for (axis, joint) in axes.iter_mut().zip(limb) {
                *axis += frame.rotation[joint].inverse() * first.cross(second);
            }
        }
        for at in [0, 1] {
            let bone = BonePair {
                joint: limb[at],
                end: limb[at + 1],
                target: target[at],
                target_end: target[at + 1],
            };
            let along = self.local(bone.joint, bone.end);
            let bent = axes[at].length() > BENT;
            let reference = self
                .bodies
                .target_along(bone)
                .and_then(|to| bent.then(|| from_two([along, axes[at]], [to, hinge]))?);
            match reference {
                Some(reference) => self.inverse[bone.joint] = reference.inverse(),
                None => {
                    let above = if at == 0 { above } else { limb[0] };
                    self.follow(bone.joint, above, Some(bone));
                }
            }
        }
    }

    /// A hand and its fingers.
    fn hand(&mut self, own: &Arm, theirs: &Arm) {
        let target_rest = &self.bodies.target_tree.rest;
        let bone = hand_bone(self.bodies.tree, own, theirs);
        let knuckles = |arm: &Arm| Some([*arm.fingers[1].first()?, *arm.fingers[4].first()?]);
        let reference = knuckles(own).zip(knuckles(theirs)).zip(bone);
        let reference = reference.and_then(|(([index, little], [to_index, to_little]), bone)| {
            let along = self.local(own.hand, bone.end);
            let across = self.local(own.hand, index) - self.local(own.hand, little);
            let to = self.bodies.target_along(bone)?;
            from_two(
                [along, across],
                [to, target_rest[to_index] - target_rest[to_little]],
            )
        });
        match reference {
            Some(reference) => self.inverse[own.hand] = reference.inverse(),
            None => self.follow(own.hand, own.forearm, bone),
        }
        let bones = finger_bones(&self.children, own, theirs);
        for joint in own.fingers.iter().flatten() {
            let bone = bones.iter().copied().find(|bone| bone.joint == *joint);
            let above = self.bodies.tree.parents[*joint].unwrap_or(own.hand);
            let above = if own.fingers.iter().flatten().any(|own| *own == above) {
                above
            } else {
                own.hand
            };
            self.follow(*joint, above, bone);
        }
    }
}
