//! A tree of joints, whichever file or avatar it comes from.

use crate::capture::Capture;
use effigy_core::avatar::Skeleton;
use glam::{DAffine3, DQuat, DVec3};

/// Frames that are looked at, spread over the capture.
pub const LOOKED_AT: usize = 400;

/// Indices of at most [`LOOKED_AT`] frames.
pub fn spread(frames: usize) -> impl Iterator<Item = usize> + Clone {
    let count = frames.min(LOOKED_AT);
    (0..count).map(move |at| at * frames / count)
}

/// Names, parents and places of joints. Parents come before their children.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The name of each joint.
    pub names: Vec<String>,
    /// An index below the joint's own; None for a root.
    pub parents: Vec<Option<usize>>,
    /// In the rest pose, from the parent and in the parent's axes; the file's unit.
    pub offsets: Vec<DVec3>,
    /// In the rest pose, in the file's axes and unit.
    pub rest: Vec<DVec3>,
}

impl Tree {
    /// The tree of a capture.
    pub fn of_capture(capture: &Capture) -> Self {
        let joints = &capture.joints;
        Self {
            names: joints.iter().map(|joint| joint.name.clone()).collect(),
            parents: joints.iter().map(|joint| joint.parent).collect(),
            offsets: joints.iter().map(|joint| joint.offset).collect(),
            rest: positions(&capture.rest()),
        }
    }

    /// The tree of an avatar.
    pub fn of_skeleton(skeleton: &Skeleton) -> Self {
        let parents: Vec<Option<usize>> = skeleton
            .parent
            .iter()
            .map(|parent| parent.map(usize::from))
            .collect();
        let rest = |joint: usize| DVec3::from(skeleton.rest[joint].map(f64::from));
        let offset = |joint: usize| rest(joint) - parents[joint].map_or(DVec3::ZERO, rest);
        Self {
            names: skeleton.name.clone(),
            offsets: (0..skeleton.len()).map(offset).collect(),
            rest: (0..skeleton.len()).map(rest).collect(),
            parents,
        }
    }

    /// Number of joints.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// The children of each joint.
    pub fn children(&self) -> Vec<Vec<usize>> {
        let mut children = vec![vec![]; self.len()];
        for (joint, parent) in self.parents.iter().enumerate() {
            if let Some(parent) = *parent {
                children[parent].push(joint);
            }
        }
        children
    }

    /// A joint and all above it, upwards.
    pub fn chain_up(&self, joint: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(joint), |&joint| self.parents[joint])
    }

    /// Whether a joint is another one or above it.
    pub fn is_above(&self, joint: usize, other: usize) -> bool {
        self.chain_up(other).any(|above| above == joint)
    }

    /// The lowest joint that is above all of these, or one of them.
    pub fn fork(&self, joints: &[usize]) -> Option<usize> {
        let (first, rest) = joints.split_first()?;
        self.chain_up(*first)
            .find(|&above| rest.iter().all(|&joint| self.is_above(above, joint)))
    }

    /// The joints from one to another below it, downwards, without the first and with the last.
    pub fn path(&self, from: usize, to: usize) -> Vec<usize> {
        let mut path: Vec<usize> = self
            .chain_up(to)
            .take_while(|&joint| joint != from)
            .collect();
        path.reverse();
        path
    }
}

/// Positions of joints.
pub fn positions(world: &[DAffine3]) -> Vec<DVec3> {
    world.iter().map(|joint| joint.translation).collect()
}

/// A joint's rotation.
pub fn rotation(joint: &DAffine3) -> DQuat {
    DQuat::from_mat3(&joint.matrix3).normalize()
}

/// Rotations of joints.
pub fn rotations(world: &[DAffine3]) -> Vec<DQuat> {
    world.iter().map(rotation).collect()
}
