//! Motion as files of other programs have it: any tree of joints, in the file's own units and axes.
//! Each reader gives a [`Capture`].

use crate::assumption::Assumption;
use glam::{DAffine3, DQuat, DVec3, Quat, Vec3};

/// Most joints that a capture may have: several people with hands, and what they carry.
pub const MAX_JOINTS: usize = 4096;
/// Most frames of a capture: more than two hours at 240 frames a second.
pub const MAX_FRAMES: usize = 2_000_000;
/// Most rotations, frames × joints, of a capture.
pub const MAX_ROTATIONS: usize = 200_000_000;

/// A joint of a capture.
#[derive(Clone, Debug, PartialEq)]
pub struct CaptureJoint {
    /// The name in the file; need not be the only one.
    pub name: String,
    /// An index into [`Capture::joints`] below the joint's own; None for a root.
    pub parent: Option<usize>,
    /// From the parent in the rest pose, in the parent's axes and the file's unit.
    pub offset: DVec3,
    /// Relative to the parent in the rest pose.
    pub rest: DQuat,
}

/// A joint's place relative to its parent. In 32 bits, since captures have millions of them: a
/// millionth of a radian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalPose {
    /// Relative to the parent.
    pub rotation: Quat,
    /// From the parent, in the parent's axes and the file's unit.
    pub offset: Vec3,
}

impl LocalPose {
    fn matrix(self) -> DAffine3 {
        let rotation = self.rotation.as_dquat().normalize();
        DAffine3::from_rotation_translation(rotation, self.offset.as_dvec3())
    }
}

/// Bytes that the frames of a capture may take, for a file of so many bytes.
pub fn memory_limit(bytes: usize) -> usize {
    3 * bytes + (32 << 20)
}

/// A skeleton and its motion as in their file.
#[derive(Clone, Debug, PartialEq)]
pub struct Capture {
    /// Parents come before their children.
    pub joints: Vec<CaptureJoint>,
    /// Frames a second, above 0.
    pub rate: f64,
    /// Shape F, J.
    pub local: Vec<LocalPose>,
    /// Metres a unit of the file, where it or its format says.
    pub unit: Option<f64>,
    /// The axis that points up, where the file or its format says.
    pub up: Option<DVec3>,
    /// Strengths of the face's expression, shape F, `expression_len`; as in the file.
    pub expression: Vec<f32>,
    /// Numbers of an expression.
    pub expression_len: usize,
}

/// What a reader gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Captured {
    /// The motion.
    pub capture: Capture,
    /// What the file left open.
    pub assumptions: Vec<Assumption>,
}

impl Capture {
    /// Number of frames, F.
    pub fn frames(&self) -> usize {
        self.local.len() / self.joints.len().max(1)
    }

    /// Seconds from the first frame to the last.
    pub fn duration(&self) -> f64 {
        self.frames().saturating_sub(1) as f64 / self.rate
    }

    /// Joints to world in a frame: the file's axes and unit.
    ///
    /// # Panics
    /// When there is no such frame.
    pub fn world(&self, frame: usize) -> Vec<DAffine3> {
        self.compose(self.frame(frame).iter().map(|pose| pose.matrix()))
    }

    /// Joints to world at a moment, seconds; between frames each joint rotates the shortest way,
    /// and before the first and after the last it stands still. The file's axes and unit.
    ///
    /// # Panics
    /// When there is no frame.
    pub fn world_at(&self, seconds: f64) -> Vec<DAffine3> {
        let last = self.frames().saturating_sub(1);
        let at = (seconds * self.rate).max(0.0).min(last as f64);
        let first = at.floor() as usize;
        let share = at.fract();
        let next = self.frame((first + 1).min(last));
        self.compose(self.frame(first).iter().zip(next).map(|(a, b)| {
            let [from, to] = [a, b].map(|pose| pose.rotation.as_dquat().normalize());
            DAffine3::from_rotation_translation(
                from.slerp(to, share),
                a.offset.as_dvec3().lerp(b.offset.as_dvec3(), share),
            )
        }))
    }

    /// Joints to world in the rest pose.
    pub fn rest(&self) -> Vec<DAffine3> {
        let joints = self.joints.iter();
        self.compose(
            joints.map(|joint| DAffine3::from_rotation_translation(joint.rest, joint.offset)),
        )
    }

    fn frame(&self, frame: usize) -> &[LocalPose] {
        let count = self.joints.len();
        &self.local[frame * count..][..count]
    }

    fn compose(&self, local: impl Iterator<Item = DAffine3>) -> Vec<DAffine3> {
        let mut world: Vec<DAffine3> = Vec::with_capacity(self.joints.len());
        for (joint, own) in self.joints.iter().zip(local) {
            world.push(joint.parent.map_or(own, |parent| world[parent] * own));
        }
        world
    }
}
