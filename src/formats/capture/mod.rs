//! Motion as files of other programs have it: any tree of joints, in the file's own units and axes.
//! Each reader gives a [`Capture`].

mod usual;

use crate::assumption::Assumption;
use effigy_core::io::file::FormatError;
use glam::{DAffine3, DQuat, DVec3, Quat, Vec3};
pub(crate) use usual::Usual;

/// Most joints that a capture may have: several people with hands, and what they carry.
pub const MAX_JOINTS: usize = 4096;
/// Most frames of a capture: more than two hours at 240 frames a second.
pub const MAX_FRAMES: usize = 2_000_000;
/// Most rotations, frames × joints, of a capture.
pub const MAX_ROTATIONS: usize = 200_000_000;

/// Bytes of memory that the poses of any capture may take.
const SMALL: usize = 48 << 20;
/// How many more they may take for a byte of the file: a rotation of three f32 takes 28 bytes here.
const GROWTH: usize = 3;
/// Longest offset along an axis: what is longer is no body's.
const LONGEST: f64 = 1e9;

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
    /// Rounds to 32 bits. `offset` is cut to a billion units.
    pub fn new(rotation: DQuat, offset: DVec3) -> Self {
        let longest = DVec3::splat(LONGEST);
        Self {
            rotation: rotation.as_quat(),
            offset: offset.clamp(-longest, longest).as_vec3(),
        }
    }

    fn matrix(self) -> DAffine3 {
        let rotation = self.rotation.as_dquat().normalize();
        DAffine3::from_rotation_translation(rotation, self.offset.as_dvec3())
    }
}

/// What a file and its format say of the axis that points up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UpAxis {
    /// The file says it, or the format's definition.
    Said(DVec3),
    /// Most files of a kind have this one, and others use the same names.
    Usual {
        /// The axis.
        axis: DVec3,
        /// Whose files, for messages.
        whose: &'static str,
    },
    /// Nothing.
    Open,
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
    /// The axis that points up.
    pub up: UpAxis,
    /// Whether the rest pose is a model's: it says nothing of which way is up in the motion.
    pub model_rest: bool,
    /// Strengths of the face's expression, shape F, `expression_len`; as in the file.
    pub expression: Vec<f32>,
    /// Numbers of an expression.
    pub expression_len: usize,
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

/// Where joints are at rest, in files of models that are posed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rest {
    /// Where they were when skins were made, as far as the file says; nodes for the others. VRM:
    /// nodes, which it asks to stand in a T-pose.
    #[default]
    Bind,
    /// Where nodes are without an animation.
    Nodes,
}

/// A capture, and what its reader took where the file left a question open.
#[derive(Clone, Debug, PartialEq)]
pub struct Captured {
    /// The skeleton and its motion.
    pub capture: Capture,
    /// What the file left open.
    pub assumptions: Vec<Assumption>,
}

/// Poses of single joints that a capture may have whose file has so many bytes.
pub(crate) fn most_poses(size: usize) -> usize {
    let bytes = GROWTH.saturating_mul(size).saturating_add(SMALL);
    (bytes / size_of::<LocalPose>()).min(MAX_ROTATIONS)
}

/// A rate that makes sense, frames a second.
pub(crate) fn checked_rate(rate: f64) -> Result<f64, FormatError> {
    if rate.is_finite() && rate > 0.0 {
        return Ok(rate);
    }
    Err(FormatError::container(
        format!("{rate} frames a second"),
        "a number above 0",
    ))
}

/// Refuses a capture of more than [`MAX_JOINTS`], [`MAX_FRAMES`] or [`MAX_ROTATIONS`], or of none,
/// or of more than a file of `size` bytes can mean: readers ask before they take memory.
pub(crate) fn check_size(frames: usize, joints: usize, size: usize) -> Result<(), FormatError> {
    let within = (1..=MAX_JOINTS).contains(&joints)
        && (1..=MAX_FRAMES).contains(&frames)
        && frames.saturating_mul(joints) <= MAX_ROTATIONS;
    let most = most_poses(size);
    if within && frames * joints > most {
        return Err(FormatError::container(
            format!("{frames} frames of {joints} joints"),
            format!("at most {most} rotations in a file of {size} bytes; fewer frames a second"),
        ));
    }
    if within {
        return Ok(());
    }
    Err(FormatError::container(
        format!("{frames} frames of {joints} joints"),
        format!(
            "1 to {MAX_FRAMES} frames of 1 to {MAX_JOINTS} joints, {MAX_ROTATIONS} rotations in all"
        ),
    ))
}
