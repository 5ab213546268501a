//! A clip of a skeleton from CMU motion capture.
//!
//! Joints correspond by name. Each limb bone is turned, once, by the smallest rotation from its
//! direction in the skeleton's rest pose (arms lowered) to its direction in the capture's (arms
//! out). The trunk takes the capture's rotations as they are. Leg lengths give the scale.

use crate::bake::body::EXPRESSIONS;
use crate::bake::credits::MOTION_CREDIT;
use crate::bake::source::bvh::Bvh;
use crate::bake::source::text::SourceError;
use crate::math::noise::smoothstep;
use effigy_core::avatar::{Clip, Pose, Skeleton};
use effigy_core::random::hash;
use glam::{DQuat, DVec3};
use std::path::Path;

/// Joints whose names differ in the capture (skeleton, capture), trunk only. Neck and the hip
/// joints of the capture fold into their neighbours.
const RENAMED: [(&str, &str); 4] = [
    ("Spine", "LowerBack"),
    ("Spine1", "Spine"),
    ("Spine2", "Spine1"),
    ("Neck", "Neck1"),
];
const FINGERS: [&str; 5] = ["Thumb", "Index", "Middle", "Ring", "Pinky"];
/// Neck and head turn at most this far each, degrees: 01_01 throws the head back by almost 90 for a
/// moment, which is its markers' fault.
const NECK_LIMIT: f64 = 36.0;

/// A bone that is aligned. Names are without their side.
struct LimbBone {
    /// The joint that it begins at.
    joint: &'static str,
    /// The joint at its other end.
    end: &'static str,
    /// That joint in the capture.
    capture_end: &'static str,
}

const LIMBS: [LimbBone; 5] = [
    LimbBone {
        joint: "UpLeg",
        end: "Leg",
        capture_end: "Leg",
    },
    LimbBone {
        joint: "Leg",
        end: "Foot",
        capture_end: "Foot",
    },
    LimbBone {
        joint: "Arm",
        end: "ForeArm",
        capture_end: "ForeArm",
    },
    LimbBone {
        joint: "ForeArm",
        end: "Hand",
        capture_end: "Hand",
    },
    LimbBone {
        joint: "Hand",
        end: "HandMiddle1",
        capture_end: "Fingers",
    },
];

/// Which part of a capture becomes a clip, and how.
#[derive(Clone, Debug)]
pub struct RetargetOptions {
    /// Frames a second of the clip.
    pub rate: f64,
    /// Seconds into the capture.
    pub from: f64,
    /// Seconds into the capture; its end if `None`.
    pub to: Option<f64>,
    /// Removes the way walked: the hips stay near the origin, and the first frame faces +z.
    pub in_place: bool,
    /// Where a clip that repeats begins, seconds into the capture; `from` if `None`.
    pub start: Option<f64>,
    /// Seconds at the end that fade into the motion before `from`, so that the clip repeats.
    pub fade: f64,
}

/// How a joint of the skeleton is driven.
#[derive(Clone, Copy)]
enum Drive {
    /// By a joint of the capture, whose rotation is multiplied by an alignment.
    Captured { joint: usize, alignment: DQuat },
    /// Not at all: fingers keep a relaxed curl.
    Curl(DQuat),
}

/// A capture, ready to be read for one skeleton.
struct CaptureSource<'a> {
    bvh: &'a Bvh,
    skeleton: &'a Skeleton,
    /// One a joint of the skeleton.
    drives: Vec<Drive>,
    /// Metres a unit of the capture.
    scale: f64,
}

/// A clip of `skeleton` from a capture; `file` is named in errors.
///
/// # Errors
/// When the capture lacks a joint, or the options ask for seconds that it doesn't have.
pub fn retarget(
    bvh: &Bvh,
    skeleton: &Skeleton,
    options: &RetargetOptions,
    file: &Path,
) -> Result<Clip, SourceError> {
    let source = CaptureSource::new(bvh, skeleton, file)?;
    let length = bvh.frames() as f64 * bvh.frame_time;
    let to = options.to.unwrap_or(length).min(length);
    let frames = ((to - options.from) * options.rate).floor();
    if !(frames >= 1.0 && options.from >= 0.0) {
        return Err(content(
            file,
            format!("seconds {} to {to} of {length:.2}", options.from),
            "at least one frame of the clip between them",
        ));
    }
    let frames = frames as usize;
    let pose = |frame: f64| source.pose(options.from + frame / options.rate);
    let mut poses: Vec<Pose> = (0..frames).map(|i| pose(i as f64)).collect();
    // What comes before the first frame, for the end to fade into.
    let fade = ((options.fade * options.rate) as usize).min(frames - 1);
    let mut lead_in: Vec<Pose> = (0..fade).map(|i| pose(i as f64 - fade as f64)).collect();
    source.move_to_ground(&mut poses, &mut lead_in);
    if options.in_place {
        remove_travel(&mut poses, options.rate);
        remove_travel(&mut lead_in, options.rate);
    }
    for (i, before) in lead_in.iter().enumerate() {
        let share = smoothstep(0.0, 1.0, (i + 1) as f64 / (fade + 1) as f64);
        fade_into(&mut poses[frames - fade + i], before, share);
    }
    let start = ((options.start.unwrap_or(options.from) - options.from) * options.rate).round();
    if !(0.0..frames as f64).contains(&start) {
        return Err(content(
            file,
            format!("a start at {:?} s", options.start),
            "one between from and to",
        ));
    }
    poses.rotate_left(start as usize);
    if options.in_place {
        source.face_forward(&mut poses);
    }
    let duration = frames as f64 / options.rate;
    Ok(Clip {
        name: file
            .file_stem()
            .map_or_else(|| "clip".into(), |stem| stem.to_string_lossy().into_owned()),
        credit: MOTION_CREDIT.into(),
        rate: options.rate,
        joint: skeleton.name.clone(),
        rotation: poses
            .iter()
            .flat_map(|pose| pose.rotation.iter().map(|r| r.as_vec3().to_array()))
            .collect(),
        translation: poses
            .iter()
            .map(|pose| pose.translation.as_vec3().to_array())
            .collect(),
        expression: (0..frames)
            .flat_map(|i| expression(i as f64 / options.rate, duration))
            .map(|e| e as f32)
            .collect(),
        expression_len: EXPRESSIONS.len(),
    })
}

fn content(file: &Path, found: String, expected: &str) -> SourceError {
    SourceError::Content {
        file: file.to_path_buf(),
        found,
        expected: expected.into(),
    }
}

/// A joint's position in the rest pose.
fn rest_position(skeleton: &Skeleton, name: &str) -> Option<DVec3> {
    let index = skeleton.name.iter().position(|joint| joint == name)?;
    Some(DVec3::from(skeleton.rest[index].map(f64::from)))
}

/// Moves a pose towards another one; `share` from 0 to 1.
fn fade_into(pose: &mut Pose, other: &Pose, share: f64) {
    pose.translation = pose.translation.lerp(other.translation, share);
    for (own, other) in pose.rotation.iter_mut().zip(&other.rotation) {
        let from = DQuat::from_scaled_axis(*own);
        let to = DQuat::from_scaled_axis(*other);
        *own = from.slerp(to, share).to_scaled_axis();
    }
}

impl<'a> CaptureSource<'a> {
    fn new(bvh: &'a Bvh, skeleton: &'a Skeleton, file: &Path) -> Result<Self, SourceError> {
        let find = |name: &str| bvh.joints.iter().position(|joint| joint.name == name);
        let mut drives = Vec::with_capacity(skeleton.len());
        for name in &skeleton.name {
            if FINGERS.iter().any(|finger| name.contains(finger)) {
                let curl = finger_curl(skeleton, name).unwrap_or(DQuat::IDENTITY);
                drives.push(Drive::Curl(curl));
                continue;
            }
            let theirs = RENAMED
                .iter()
                .find(|(ours, _)| ours == name)
                .map_or(name.as_str(), |(_, theirs)| theirs);
            let joint = find(theirs).ok_or_else(|| {
                content(
                    file,
                    format!("no joint {theirs}"),
                    "a capture with CMU's joint names",
                )
            })?;
            drives.push(Drive::Captured {
                joint,
                alignment: alignment(bvh, skeleton, name).unwrap_or(DQuat::IDENTITY),
            });
        }
        let bone_length = |from: &str, to: &str| {
            let from = rest_position(skeleton, from)?;
            let to = rest_position(skeleton, to)?;
            Some(from.distance(to))
        };
        let ours: f64 = [("LeftUpLeg", "LeftLeg"), ("LeftLeg", "LeftFoot")]
            .iter()
            .filter_map(|(from, to)| bone_length(from, to))
            .sum();
        let theirs: f64 = ["LeftLeg", "LeftFoot"]
            .iter()
            .filter_map(|name| find(name))
            .map(|joint| bvh.joints[joint].offset.length())
            .sum();
        if !(ours > 0.0 && theirs > 0.0) {
            return Err(content(
                file,
                format!("legs {theirs} units long, the skeleton's {ours} m"),
                "both above 0",
            ));
        }
        Ok(Self {
            bvh,
            skeleton,
            drives,
            scale: ours / theirs,
        })
    }

    /// The skeleton's pose in the capture's nearest frame.
    fn pose(&self, seconds: f64) -> Pose {
        // A capture's first frame is often its rest pose, not part of the motion.
        let last = self.bvh.frames() as f64 - 1.0;
        let first = 1.0_f64.min(last);
        let frame = (seconds / self.bvh.frame_time).round().clamp(first, last) as usize;
        let mut captured: Vec<DQuat> = Vec::with_capacity(self.bvh.joints.len());
        for (j, joint) in self.bvh.joints.iter().enumerate() {
            let local = self.bvh.rotation(frame, j);
            captured.push(match joint.parent {
                Some(parent) => captured[parent] * local,
                None => local,
            });
        }
        let mut global: Vec<DQuat> = Vec::with_capacity(self.skeleton.len());
        let mut rotation = Vec::with_capacity(self.skeleton.len());
        for (j, drive) in self.drives.iter().enumerate() {
            let parent = match self.skeleton.parent[j] {
                Some(parent) => global[parent as usize],
                None => DQuat::IDENTITY,
            };
            let world = match drive {
                Drive::Captured { joint, alignment } => captured[*joint] * *alignment,
                Drive::Curl(curl) => parent * *curl,
            };
            let mut local = shorter_turn(parent.inverse() * world).to_scaled_axis();
            if matches!(self.skeleton.name[j].as_str(), "Neck" | "Head") {
                local = local.clamp_length_max(NECK_LIMIT.to_radians());
            }
            rotation.push(local);
            global.push(parent * DQuat::from_scaled_axis(local));
        }
        Pose {
            rotation,
            translation: self.bvh.position(frame, 0) * self.scale - self.root(),
            expression: Vec::new(),
        }
    }

    /// The hips in the rest pose.
    fn root(&self) -> DVec3 {
        DVec3::from(self.skeleton.rest[0].map(f64::from))
    }

    /// Turns the whole clip about the vertical so that the first frame's hips face +z.
    fn face_forward(&self, poses: &mut [Pose]) {
        let root = self.root();
        let Some(first) = poses.first() else { return };
        let forward = DQuat::from_scaled_axis(first.rotation[0]) * DVec3::Z;
        let turn = DQuat::from_rotation_y(-forward.x.atan2(forward.z));
        for pose in poses {
            let hips = DQuat::from_scaled_axis(pose.rotation[0]);
            pose.rotation[0] = shorter_turn(turn * hips).to_scaled_axis();
            pose.translation = turn * (pose.translation + root) - root;
        }
    }

    /// Moves all poses by the same height, so that the soles rest on y = 0 in all but the deepest
    /// twentieth of the frames of `poses`.
    fn move_to_ground(&self, poses: &mut [Pose], lead_in: &mut [Pose]) {
        let mut skeleton = self.skeleton.clone();
        skeleton.canonical.fill([0.0; 3]);
        let soles = self.sole_points();
        let lowest = |pose: &Pose| {
            let matrices = skeleton.matrices(pose);
            soles
                .iter()
                .map(|sole| matrices[sole.joint].transform_point3(sole.position).y)
                .fold(f64::INFINITY, f64::min)
        };
        let mut heights: Vec<f64> = poses.iter().map(lowest).collect();
        heights.sort_by(f64::total_cmp);
        let ground = heights
            .get(heights.len() / 20)
            .copied()
            .filter(|height| height.is_finite())
            .unwrap_or(0.0);
        for pose in poses.iter_mut().chain(lead_in) {
            pose.translation.y -= ground;
        }
    }

    /// Heels, balls and toes of both feet.
    fn sole_points(&self) -> Vec<SolePoint> {
        let mut soles = Vec::new();
        for side in ["Left", "Right"] {
            for (name, forward) in [("Foot", -0.05), ("ToeBase", 0.0), ("ToeBase", 0.07)] {
                let name = format!("{side}{name}");
                if let Some(joint) = self.skeleton.name.iter().position(|own| *own == name) {
                    let position = DVec3::from(self.skeleton.rest[joint].map(f64::from));
                    soles.push(SolePoint {
                        joint,
                        position: position.with_y(0.0) + DVec3::Z * forward,
                    });
                }
            }
        }
        soles
    }
}

/// A point under a foot.
struct SolePoint {
    /// The joint that moves it.
    joint: usize,
    /// In the rest pose.
    position: DVec3,
}

/// The quaternion of the same rotation that turns by at most half a circle.
fn shorter_turn(q: DQuat) -> DQuat {
    let q = q.normalize();
    if q.w < 0.0 { -q } else { q }
}

/// How a limb joint's rest pose in the skeleton turns into the capture's; `None` for the trunk.
fn alignment(bvh: &Bvh, skeleton: &Skeleton, name: &str) -> Option<DQuat> {
    let side = ["Left", "Right"]
        .into_iter()
        .find(|side| name.starts_with(side))?;
    let bone = name.trim_start_matches(side);
    let capture_offset = |name: &str| {
        let joint = bvh.joints.iter().find(|joint| joint.name == name)?;
        Some(joint.offset)
    };
    if matches!(bone, "Foot" | "ToeBase") {
        // The soles are flat in both rest poses: only the direction over the ground is aligned.
        let toe_base = format!("{side}ToeBase");
        let heel = rest_position(skeleton, &format!("{side}Foot")).unwrap_or_default();
        let ball = rest_position(skeleton, &toe_base).unwrap_or_default();
        let ours = (ball - heel).with_y(0.0).try_normalize()?;
        let theirs = capture_offset(&toe_base)?.with_y(0.0).try_normalize()?;
        return Some(DQuat::from_rotation_arc(ours, theirs));
    }
    let limb = LIMBS.iter().find(|limb| limb.joint == bone)?;
    let theirs = if limb.capture_end == "Fingers" {
        format!("{}Fingers", &side[..1])
    } else {
        format!("{side}{}", limb.capture_end)
    };
    let theirs = capture_offset(&theirs)?.try_normalize()?;
    let end = rest_position(skeleton, &format!("{side}{}", limb.end))?;
    let ours = (end - rest_position(skeleton, name)?).try_normalize()?;
    Some(DQuat::from_rotation_arc(ours, theirs))
}

/// A relaxed curl of a finger joint towards the palm, since the capture has no fingers; `None` for
/// the thumb.
fn finger_curl(skeleton: &Skeleton, name: &str) -> Option<DQuat> {
    /// Degrees for the joints of a finger, from the palm on.
    const CURL: [f64; 3] = [14.0, 22.0, 16.0];
    /// Degrees that each finger curls more than the one before it, from the index finger on.
    const CURL_STEP: f64 = 3.0;
    let side = if name.starts_with("Left") {
        "Left"
    } else {
        "Right"
    };
    let hand = rest_position(skeleton, &format!("{side}Hand"))?;
    let from_hand =
        |joint: &str| Some(rest_position(skeleton, &format!("{side}Hand{joint}"))? - hand);
    let palm = from_hand("Index1")?
        .cross(from_hand("Pinky1")?)
        .try_normalize()?;
    // The palm's normal points to the thumb's side.
    let palm = palm * from_hand("Thumb3")?.dot(palm).signum();
    let finger = FINGERS[1..]
        .iter()
        .position(|finger| name.contains(finger))?;
    let joint = name.chars().last()?.to_digit(10)?;
    let along = from_hand("Middle1")?
        .reject_from_normalized(palm)
        .try_normalize()?;
    let degrees = CURL[(joint as usize).clamp(1, 3) - 1] + CURL_STEP * finger as f64;
    let axis = along.cross(palm).try_normalize()?;
    Some(DQuat::from_axis_angle(axis, degrees.to_radians()))
}

/// Removes the way over the ground. The sway about the mean over a second and a half stays.
fn remove_travel(poses: &mut [Pose], rate: f64) {
    let half_window = (0.75 * rate) as usize;
    let path: Vec<DVec3> = poses.iter().map(|pose| pose.translation).collect();
    for (i, pose) in poses.iter_mut().enumerate() {
        let end = (i + half_window + 1).min(path.len());
        let window = &path[i.saturating_sub(half_window)..end];
        let mean = window.iter().sum::<DVec3>() / window.len() as f64;
        pose.translation.x -= mean.x;
        pose.translation.z -= mean.z;
    }
}

/// A face at rest, as strengths of [`EXPRESSIONS`]: blinks every few seconds, a smile that comes
/// and goes, brows and jaw that hardly move. Ends as it begins.
fn expression(seconds: f64, duration: f64) -> [f64; EXPRESSIONS.len()] {
    use std::f64::consts::TAU;
    let wave =
        |turns: f64, phase: f64| 0.5 - 0.5 * (TAU * (turns * seconds / duration + phase)).cos();
    let turns = (duration / 6.0).round().max(1.0);
    // One blink in each interval, at a random moment of its middle.
    let blinks = (duration / 3.3).floor().max(1.0);
    let interval = duration / blinks;
    let random = hash((seconds / interval) as u64) as f64 / u64::MAX as f64;
    let since_blink = seconds % interval - interval * (0.3 + 0.4 * random);
    let blink = smoothstep(-0.10, 0.0, since_blink) * smoothstep(0.16, 0.04, since_blink);
    let jaw_open = 0.05 * wave(2.0 * turns, 0.2);
    let smile = 0.15 + 0.5 * wave(turns, 0.0);
    let brows_up = 0.35 * wave(turns, 0.6).powi(2);
    let eyes_wide = 0.1 * wave(turns, 0.6);
    [
        jaw_open, smile, blink, brows_up, 0.0, 0.0, 0.0, eyes_wide, 0.0, 0.0,
    ]
}
