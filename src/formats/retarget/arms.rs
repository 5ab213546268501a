//! Arms outside the body: where the avatar's arm is deeper inside its trunk than the capture's arm
//! is inside its own, the shoulder turns it out.
//!
//! A capture has no flesh. Its trunk is taken to be the avatar's, as much wider as its shoulders are.

use super::{
    girth::{Depth, Girth},
    humanoid::{Arm, Humanoid},
    tree::{positions, rotation},
    turn,
    window::smooth,
};
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DAffine3, DQuat, DVec3};

/// Places along an arm that are looked at: shares of the way from the elbow to the wrist, and beyond
/// it along the hand.
const PLACES: [f64; 5] = [0.0, 0.35, 0.7, 1.0, 1.25];
/// An arm may be this much deeper than the capture's, metres: skin gives way.
const LEEWAY: f64 = 0.005;
/// A shoulder's turn is smoothed over so many seconds before and after.
const SMOOTH: f64 = 0.12;
/// Times that what is left is corrected.
const ROUNDS: usize = 4;
/// A shoulder turns at most this far, radians.
const MOST: f64 = 0.6;

/// How deep arms are inside the trunk, frame by frame and arm by arm; below 0 outside, metres.
pub type Depths = Vec<[f64; 2]>;

/// An avatar and its thickness.
pub struct Body<'a> {
    /// The avatar's joints.
    pub skeleton: &'a Skeleton,
    /// Its parts.
    pub target: &'a Humanoid,
    /// Its thickness.
    pub girth: &'a Girth,
}

/// Places of elbow and wrist, and what lies between.
fn places(elbow: DVec3, wrist: DVec3) -> [DVec3; 5] {
    PLACES.map(|share| elbow + share * (wrist - elbow))
}

/// Width of the shoulders.
fn shoulders(humanoid: &Humanoid, at: &[DVec3]) -> f64 {
    at[humanoid.arms[0].upper].distance(at[humanoid.arms[1].upper])
}

impl Body<'_> {
    /// The deepest place of an arm. `wide`: see [`Girth::depth`].
    fn deepest(&self, joints: &[DAffine3], places: [DVec3; 5], wide: f64) -> Deepest {
        let depths = places.map(|place| Deepest {
            place,
            depth: self.girth.depth(joints, place, wide),
        });
        let metres = |own: &Deepest| own.depth.metres;
        let mut deepest = depths[0];
        for own in depths {
            if metres(&own) > metres(&deepest) {
                deepest = own;
            }
        }
        deepest.depth.metres += self.girth.arm;
        deepest
    }

    /// How deep the capture's arms are inside a trunk like the avatar's. `joints`: the avatar's in a
    /// frame; `source`, `at`: the capture's body and where its joints are, metres of the avatar.
    fn of_capture(&self, joints: &[DAffine3], source: &Humanoid, at: &[DVec3]) -> [f64; 2] {
        let own = positions(joints);
        let wide = shoulders(source, at) / shoulders(self.target, &own).max(1e-6);
        let chest = |humanoid: &Humanoid, at: &[DVec3]| {
            (at[humanoid.arms[0].upper] + at[humanoid.arms[1].upper]) / 2.0
        };
        // Both trunks hang from the shoulders.
        let moved = chest(self.target, &own) - chest(source, at);
        source.arms.each_ref().map(|arm| {
            let places = places(at[arm.forearm] + moved, at[arm.hand] + moved);
            self.deepest(joints, places, wide).depth.metres
        })
    }

    fn of_avatar(&self, joints: &[DAffine3], arm: &Arm) -> Deepest {
        let [elbow, wrist] = [arm.forearm, arm.hand].map(|joint| joints[joint].translation);
        self.deepest(joints, places(elbow, wrist), 1.0)
    }

    /// How deep the capture's arms are in each frame. It does not change with the avatar's arms.
    pub fn of_captures(&self, poses: &[Pose], source: &Humanoid, world: &[Vec<DVec3>]) -> Depths {
        let frames = poses.iter().zip(world);
        frames
            .map(|(pose, at)| self.of_capture(&self.skeleton.joints(pose), source, at))
            .collect()
    }

    /// How much deeper than the capture's, `theirs`, the avatar's arms are; below 0 where they are
    /// not.
    pub fn excess(&self, poses: &[Pose], theirs: &Depths) -> Depths {
        let frames = poses.iter().zip(theirs);
        frames
            .map(|(pose, theirs)| {
                let joints = self.skeleton.joints(pose);
                [0, 1].map(|side| {
                    let own = self.of_avatar(&joints, &self.target.arms[side]);
                    own.depth.metres.max(0.0) - theirs[side].max(0.0)
                })
            })
            .collect()
    }

    /// Turns shoulders so that arms are no deeper than the capture's, `theirs`. `rate`: frames a
    /// second.
    pub fn move_out(&self, poses: &mut [Pose], theirs: &Depths, rate: f64) {
        let half = (SMOOTH * rate).ceil() as usize;
        for side in [0, 1] {
            let arm = &self.target.arms[side];
            let first: Vec<DVec3> = poses.iter().map(|pose| pose.rotation[arm.upper]).collect();
            // The turn of the upper arm, in world axes.
            let mut turns = vec![DVec3::ZERO; poses.len()];
            for _ in 0..ROUNDS {
                let mut any = false;
                for ((pose, theirs), turn) in poses.iter().zip(theirs).zip(&mut turns) {
                    let joints = self.skeleton.joints(pose);
                    let own = self.of_avatar(&joints, arm);
                    let excess = own.depth.metres - theirs[side].max(0.0) - LEEWAY;
                    if excess > 0.0 {
                        let lever = own.place - joints[arm.upper].translation;
                        let axis = lever.cross(own.depth.out) / lever.length_squared().max(1e-6);
                        *turn = (*turn + excess * axis).clamp_length_max(MOST);
                        any = true;
                    }
                }
                if !any {
                    break;
                }
                let smooth = smooth(&turns, half, DVec3::length_squared);
                for (frame, pose) in poses.iter_mut().enumerate() {
                    pose.rotation[arm.upper] = first[frame];
                    turn_by(self.skeleton, pose, arm.upper, smooth[frame]);
                }
            }
        }
    }
}

/// A place of an arm and how deep it is.
#[derive(Clone, Copy)]
struct Deepest {
    place: DVec3,
    depth: Depth,
}

/// Turns a joint by an axis times an angle, in world axes.
fn turn_by(skeleton: &Skeleton, pose: &mut Pose, joint: usize, axis: DVec3) {
    if axis == DVec3::ZERO {
        return;
    }
    let world = rotation(&skeleton.joints(pose)[joint]);
    let parent = turn::parent(pose, joint, world);
    turn::set(
        pose,
        joint,
        parent.inverse() * DQuat::from_scaled_axis(axis) * world,
    );
}
