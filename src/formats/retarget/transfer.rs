//! A frame of a capture as a pose of an avatar, before feet are put on the ground.

use super::{
    align::Alignment,
    curl::curl,
    humanoid::Humanoid,
    tree::{positions, rotations},
    turn::shorter,
};
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DAffine3, DQuat, DVec3};

/// Neck and head turn at most this far each, degrees: captures throw heads back by 90 where a marker
/// was lost.
const NECK_LIMIT: f64 = 40.0;

/// What turns a joint of the avatar.
#[derive(Clone, Copy, Debug)]
enum Drive {
    /// Two joints of the capture, whose rotations are blended.
    Between {
        from: usize,
        to: usize,
        /// 0: `from`, 1: `to`.
        share: f64,
    },
    /// Nothing: it stays as it is relative to its parent.
    Rest,
    /// Nothing, but fingers are not stiff.
    Curl(DQuat),
}

impl Drive {
    fn by(joint: usize) -> Self {
        Self::Between {
            from: joint,
            to: joint,
            share: 0.0,
        }
    }

    /// Joint `at` of `count` that make the way from the first of a sequence to its last.
    fn along(sequence: &[usize], at: usize, count: usize) -> Self {
        let place = (at + 1) as f64 / count as f64 * (sequence.len() - 1) as f64;
        let first = (place.floor() as usize).min(sequence.len() - 1);
        Self::Between {
            from: sequence[first],
            to: sequence[(first + 1).min(sequence.len() - 1)],
            share: place.fract(),
        }
    }
}

/// How a capture moves an avatar.
pub struct Transfer<'a> {
    skeleton: &'a Skeleton,
    source: &'a Humanoid,
    target: &'a Humanoid,
    alignment: &'a Alignment,
    drives: Vec<Drive>,
    /// Metres of the avatar a unit of the capture.
    pub scale: f64,
}

impl<'a> Transfer<'a> {
    /// `source`, `target`: the bodies of capture and avatar. `scale`: metres a unit.
    pub fn new(
        skeleton: &'a Skeleton,
        source: &'a Humanoid,
        target: &'a Humanoid,
        alignment: &'a Alignment,
        scale: f64,
    ) -> Self {
        Self {
            skeleton,
            source,
            target,
            alignment,
            drives: drives(skeleton, source, target),
            scale,
        }
    }

    /// The avatar's joints that the capture moves.
    pub fn driven(&self) -> usize {
        let driven = |drive: &&Drive| matches!(drive, Drive::Between { .. });
        self.drives.iter().filter(driven).count()
    }

    /// The pose of a frame of the capture. `world`: its joints, y up.
    pub fn pose(&self, world: &[DAffine3]) -> Pose {
        let aligned: Vec<DQuat> = rotations(world)
            .into_iter()
            .zip(&self.alignment.inverse)
            .map(|(world, inverse)| world * *inverse)
            .collect();
        let mut global: Vec<DQuat> = Vec::with_capacity(self.skeleton.len());
        let mut rotation = Vec::with_capacity(self.skeleton.len());
        for (joint, drive) in self.drives.iter().enumerate() {
            let parent = self.skeleton.parent[joint]
                .map_or(DQuat::IDENTITY, |parent| global[usize::from(parent)]);
            let local = match *drive {
                Drive::Between { from, to, share } => {
                    parent.inverse() * aligned[from].slerp(aligned[to], share)
                }
                Drive::Rest => DQuat::IDENTITY,
                Drive::Curl(curl) => curl,
            };
            let mut turn = shorter(local).to_scaled_axis();
            if joint == self.target.head || self.target.neck.contains(&joint) {
                turn = turn.clamp_length_max(NECK_LIMIT.to_radians());
            }
            rotation.push(turn);
            global.push(parent * DQuat::from_scaled_axis(turn));
        }
        let mut pose = Pose {
            rotation,
            translation: DVec3::ZERO,
            expression: vec![],
        };
        let goal = self.scale * self.source.middle_of_hips(&positions(world));
        let joints = self.skeleton.joints(&pose);
        pose.translation = goal - self.target.middle_of_hips(&positions(&joints));
        pose
    }
}

fn drives(skeleton: &Skeleton, source: &Humanoid, target: &Humanoid) -> Vec<Drive> {
    let mut drives = vec![Drive::Rest; skeleton.len()];
    drives[target.hips] = Drive::by(source.hips);
    let trunk: Vec<usize> = [&[source.hips], source.spine.as_slice()].concat();
    for (at, &joint) in target.spine.iter().enumerate() {
        drives[joint] = Drive::along(&trunk, at, target.spine.len());
    }
    if source.neck.is_empty() {
        let ends = [source.chest(), source.head];
        for (at, &joint) in target.neck.iter().enumerate() {
            drives[joint] = Drive::along(&ends, at, target.neck.len() + 1);
        }
    } else {
        let neck = [&[source.chest()], source.neck.as_slice()].concat();
        for (at, &joint) in target.neck.iter().enumerate() {
            drives[joint] = Drive::along(&neck, at, target.neck.len());
        }
    }
    drives[target.head] = Drive::by(source.head);
    let mut pair = |target: Option<usize>, source: Option<usize>| {
        if let (Some(target), Some(source)) = (target, source) {
            drives[target] = Drive::by(source);
        }
    };
    pair(target.jaw, source.jaw);
    for (own, theirs) in target.eyes.iter().zip(&source.eyes) {
        pair(*own, *theirs);
    }
    for (own, theirs) in target.arms.iter().zip(&source.arms) {
        pair(own.clavicle, theirs.clavicle);
        pair(Some(own.upper), Some(theirs.upper));
        pair(Some(own.forearm), Some(theirs.forearm));
        pair(Some(own.hand), Some(theirs.hand));
        for (own, theirs) in own.fingers.iter().zip(&theirs.fingers) {
            for (own, theirs) in own.iter().zip(theirs) {
                pair(Some(*own), Some(*theirs));
            }
        }
    }
    for (own, theirs) in target.legs().iter().zip(source.legs()) {
        pair(Some(own.thigh), Some(theirs.thigh));
        pair(Some(own.shin), Some(theirs.shin));
        pair(Some(own.foot), Some(theirs.foot));
        pair(own.toe, theirs.toe);
    }
    for (own, theirs) in target.arms.iter().zip(&source.arms) {
        if theirs.fingers.iter().all(Vec::is_empty) {
            for (joint, turn) in curl(skeleton, own) {
                drives[joint] = Drive::Curl(turn);
            }
        }
    }
    drives
}
