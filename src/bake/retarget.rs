//! CMU motion capture and a skeleton in; a clip of that skeleton out.
//!
//! Joints correspond by name. Each limb bone is turned, once, by the smallest rotation from its direction in the skeleton's rest pose
//! (arms lowered) to its direction in the capture's (arms out); the trunk takes the capture's rotations as they are. Leg lengths give the scale.

use super::bvh::Bvh;
use super::math::{hash, step};
use super::text::Error;
use crate::avatar::{Clip, Pose, Skeleton};
use glam::{DQuat, DVec3};
use std::path::Path;

/// Joints whose names differ in the capture, trunk only; Neck and the hip joints fold into their neighbours.
const RENAMED: [(&str, &str); 4] = [("Spine", "LowerBack"), ("Spine1", "Spine"), ("Spine2", "Spine1"), ("Neck", "Neck1")];
/// Bones that are aligned: joint and the joint at its other end, in the skeleton and in the capture.
const LIMBS: [(&str, &str, &str); 5] = [
    ("UpLeg", "Leg", "Leg"),
    ("Leg", "Foot", "Foot"),
    ("Arm", "ForeArm", "ForeArm"),
    ("ForeArm", "Hand", "Hand"),
    ("Hand", "HandMiddle1", "Fingers"),
];

/// Neck and head turn at most this far each, degrees: 01_01 throws the head back by almost 90 for a moment, its markers' fault.
const NECK: f64 = 36.0;

/// What part of a capture to take, and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// Frames a second of the clip.
    pub rate: f64,
    /// Seconds into the capture.
    pub from: f64,
    /// The end of the capture where None.
    pub to: Option<f64>,
    /// Takes the way walked out: the hips stay near the origin, and the first frame faces +z.
    pub in_place: bool,
    /// Where a clip that repeats begins, seconds into the capture; `from` where None.
    pub start: Option<f64>,
    /// Seconds at the end that fade into what comes before the start, so that the clip repeats.
    pub fade: f64,
}

/// A capture, ready to be read for one skeleton.
struct Source<'a> {
    bvh: &'a Bvh,
    skeleton: &'a Skeleton,
    /// The capture's joint and the alignment of each of the skeleton's; None for fingers.
    map: Vec<Option<(usize, DQuat)>>,
    /// Metres a unit of the capture.
    scale: f64,
    curl: Vec<DQuat>,
}

/// A clip of `skeleton` from a capture; `file` is named in errors.
pub fn retarget(bvh: &Bvh, skeleton: &Skeleton, options: &Options, file: &Path) -> Result<Clip, Error> {
    let source = Source::new(bvh, skeleton, file)?;
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
    let at = |i: f64| source.pose(options.from + i / options.rate);
    let mut poses: Vec<Pose> = (0..frames).map(|i| at(i as f64)).collect();
    let fade = ((options.fade * options.rate) as usize).min(frames - 1);
    let mut lead: Vec<Pose> = (0..fade).map(|i| at(i as f64 - fade as f64)).collect();
    source.to_ground(&mut poses, &mut lead);
    if options.in_place {
        stay(&mut poses, options.rate);
        stay(&mut lead, options.rate);
    }
    for (i, before) in lead.iter().enumerate() {
        let share = step(0.0, 1.0, (i + 1) as f64 / (fade + 1) as f64);
        let pose = &mut poses[frames - fade + i];
        pose.translation = pose.translation.lerp(before.translation, share);
        let turn = |a: &DVec3, b: &DVec3| DQuat::from_scaled_axis(*a).slerp(DQuat::from_scaled_axis(*b), share).to_scaled_axis();
        pose.rotation = pose.rotation.iter().zip(&before.rotation).map(|(a, b)| turn(a, b)).collect();
    }
    let start = ((options.start.unwrap_or(options.from) - options.from) * options.rate).round();
    if !(0.0..frames as f64).contains(&start) {
        return Err(content(file, format!("a start at {:?} s", options.start), "one between from and to"));
    }
    poses.rotate_left(start as usize);
    if options.in_place {
        source.face_forward(&mut poses);
    }
    let duration = frames as f64 / options.rate;
    Ok(Clip {
        name: file.file_stem().map_or_else(|| "clip".into(), |stem| stem.to_string_lossy().into_owned()),
        credit: super::MOTION_CREDIT.into(),
        rate: options.rate,
        joint: skeleton.name.clone(),
        rotation: poses.iter().flat_map(|pose| pose.rotation.iter().map(|r| r.as_vec3().to_array())).collect(),
        translation: poses.iter().map(|pose| pose.translation.as_vec3().to_array()).collect(),
        expression: (0..frames).flat_map(|i| expression(i as f64 / options.rate, duration)).map(|e| e as f32).collect(),
        expression_len: 10,
    })
}

fn content(file: &Path, found: String, expected: &str) -> Error {
    Error::Content { file: file.to_path_buf(), found, expected: expected.into() }
}

fn rest(skeleton: &Skeleton, name: &str) -> Option<DVec3> {
    let index = skeleton.name.iter().position(|joint| joint == name)?;
    Some(DVec3::from(skeleton.rest[index].map(f64::from)))
}

impl<'a> Source<'a> {
    fn new(bvh: &'a Bvh, skeleton: &'a Skeleton, file: &Path) -> Result<Self, Error> {
        let find = |name: &str| bvh.joints.iter().position(|joint| joint.name == name);
        let mut map = Vec::with_capacity(skeleton.len());
        for name in &skeleton.name {
            let finger = ["Thumb", "Index", "Middle", "Ring", "Pinky"].iter().any(|finger| name.contains(finger));
            if finger {
                map.push(None);
                continue;
            }
            let theirs = RENAMED.iter().find(|(ours, _)| ours == name).map_or(name.as_str(), |(_, theirs)| theirs);
            let joint = find(theirs).ok_or_else(|| content(file, format!("no joint {theirs}"), "a capture with CMU's joint names"))?;
            map.push(Some((joint, alignment(bvh, skeleton, name))));
        }
        let ours: f64 = [("LeftUpLeg", "LeftLeg"), ("LeftLeg", "LeftFoot")]
            .iter()
            .filter_map(|(a, b)| Some(rest(skeleton, a)?.distance(rest(skeleton, b)?)))
            .sum();
        let theirs: f64 = ["LeftLeg", "LeftFoot"].iter().filter_map(|name| find(name)).map(|joint| bvh.joints[joint].offset.length()).sum();
        if !(ours > 0.0 && theirs > 0.0) {
            return Err(content(file, format!("legs {theirs} units long, the skeleton's {ours} m"), "both above 0"));
        }
        Ok(Self { bvh, skeleton, map, scale: ours / theirs, curl: curls(skeleton) })
    }

    /// The capture's pose at a time, nearest frame.
    fn pose(&self, seconds: f64) -> Pose {
        // A capture's first frame is often its rest pose, no part of the motion.
        let frame = (seconds / self.bvh.frame_time)
            .round()
            .clamp(1.0_f64.min(self.bvh.frames() as f64 - 1.0), self.bvh.frames() as f64 - 1.0) as usize;
        let mut global: Vec<DQuat> = Vec::with_capacity(self.bvh.joints.len());
        for (j, joint) in self.bvh.joints.iter().enumerate() {
            let local = self.bvh.rotation(frame, j);
            global.push(joint.parent.map_or(local, |parent| global[parent] * local));
        }
        let mut ours: Vec<DQuat> = Vec::with_capacity(self.skeleton.len());
        let mut rotation = Vec::with_capacity(self.skeleton.len());
        for (j, mapped) in self.map.iter().enumerate() {
            let parent = self.skeleton.parent[j].map_or(DQuat::IDENTITY, |parent| ours[parent as usize]);
            let world = mapped.map_or_else(|| parent * self.curl[j], |(joint, align)| global[joint] * align);
            let mut local = upright(parent.inverse() * world).to_scaled_axis();
            if matches!(self.skeleton.name[j].as_str(), "Neck" | "Head") {
                local = local.clamp_length_max(NECK.to_radians());
            }
            rotation.push(local);
            ours.push(parent * DQuat::from_scaled_axis(local));
        }
        let root = DVec3::from(self.skeleton.rest[0].map(f64::from));
        Pose { rotation, translation: self.bvh.position(frame, 0) * self.scale - root, expression: Vec::new() }
    }

    /// Turns the whole clip about the vertical so that the first frame's hips face +z.
    fn face_forward(&self, poses: &mut [Pose]) {
        let root = DVec3::from(self.skeleton.rest[0].map(f64::from));
        let Some(first) = poses.first() else { return };
        let forward = DQuat::from_scaled_axis(first.rotation[0]) * DVec3::Z;
        let turn = DQuat::from_rotation_y(-forward.x.atan2(forward.z));
        for pose in poses {
            pose.rotation[0] = upright(turn * DQuat::from_scaled_axis(pose.rotation[0])).to_scaled_axis();
            pose.translation = turn * (pose.translation + root) - root;
        }
    }

    /// Moves all poses by the same height, so that the soles rest on y = 0 in all but the deepest twentieth of the frames.
    fn to_ground(&self, poses: &mut [Pose], lead: &mut [Pose]) {
        let mut soles = Vec::new();
        for side in ["Left", "Right"] {
            for (name, forward) in [("Foot", -0.05), ("ToeBase", 0.0), ("ToeBase", 0.07)] {
                let joint = self.skeleton.name.iter().position(|joint| *joint == format!("{side}{name}"));
                soles.extend(joint.map(|j| (j, DVec3::from(self.skeleton.rest[j].map(f64::from)).with_y(0.0) + DVec3::Z * forward)));
            }
        }
        let mut rest = self.skeleton.clone();
        rest.canonical.iter_mut().for_each(|turn| *turn = [0.0; 3]);
        let lowest = |pose: &Pose| {
            let matrices = rest.matrices(pose);
            soles.iter().map(|(joint, p)| matrices[*joint].transform_point3(*p).y).fold(f64::INFINITY, f64::min)
        };
        let mut heights: Vec<f64> = poses.iter().map(lowest).collect();
        heights.sort_by(f64::total_cmp);
        let ground = heights.get(heights.len() / 20).copied().filter(|h| h.is_finite()).unwrap_or(0.0);
        poses.iter_mut().chain(lead).for_each(|pose| pose.translation.y -= ground);
    }
}

/// The same rotation with a turn of at most half a circle.
fn upright(q: DQuat) -> DQuat {
    let q = q.normalize();
    if q.w < 0.0 { -q } else { q }
}

/// How a joint's rest in the skeleton turns into the capture's.
fn alignment(bvh: &Bvh, skeleton: &Skeleton, name: &str) -> DQuat {
    let Some(side) = ["Left", "Right"].into_iter().find(|side| name.starts_with(side)) else { return DQuat::IDENTITY };
    let bone = name.trim_start_matches(side);
    let offset = |name: &str| bvh.joints.iter().find(|joint| joint.name == name).map(|joint| joint.offset);
    let between = |end: &str| (rest(skeleton, &format!("{side}{end}"))? - rest(skeleton, name)?).try_normalize();
    if matches!(bone, "Foot" | "ToeBase") {
        // The soles are flat in both rest poses: only the direction over the ground is aligned.
        let ends = [format!("{side}Foot"), format!("{side}ToeBase")].map(|name| rest(skeleton, &name).unwrap_or_default());
        let ours = (ends[1] - ends[0]).with_y(0.0).try_normalize();
        let theirs = offset(&format!("{side}ToeBase")).and_then(|o| o.with_y(0.0).try_normalize());
        return ours.zip(theirs).map_or(DQuat::IDENTITY, |(a, b)| DQuat::from_rotation_arc(a, b));
    }
    let Some((_, ours, theirs)) = LIMBS.iter().find(|(limb, ..)| *limb == bone) else { return DQuat::IDENTITY };
    let theirs = if *theirs == "Fingers" { format!("{}Fingers", &side[..1]) } else { format!("{side}{theirs}") };
    let theirs = offset(&theirs).and_then(DVec3::try_normalize);
    between(ours).zip(theirs).map_or(DQuat::IDENTITY, |(a, b)| DQuat::from_rotation_arc(a, b))
}

/// A relaxed curl of each finger joint towards the palm; the capture has none.
fn curls(skeleton: &Skeleton) -> Vec<DQuat> {
    let curl = |name: &str| -> Option<DQuat> {
        let side = if name.starts_with("Left") { "Left" } else { "Right" };
        let hand = rest(skeleton, &format!("{side}Hand"))?;
        let at = |joint: &str| Some(rest(skeleton, &format!("{side}Hand{joint}"))? - hand);
        let palm = at("Index1")?.cross(at("Pinky1")?).try_normalize()?;
        let palm = palm * at("Thumb3")?.dot(palm).signum();
        let finger = ["Index", "Middle", "Ring", "Pinky"].iter().position(|finger| name.contains(finger))?;
        let joint = name.chars().last()?.to_digit(10)?;
        let along = at("Middle1")?.reject_from_normalized(palm).try_normalize()?;
        let degrees = [14.0, 22.0, 16.0][(joint as usize).clamp(1, 3) - 1] + 3.0 * finger as f64;
        Some(DQuat::from_axis_angle(along.cross(palm).try_normalize()?, degrees.to_radians()))
    };
    skeleton.name.iter().map(|name| curl(name).unwrap_or(DQuat::IDENTITY)).collect()
}

/// Takes out the way over the ground: what remains is the sway about the mean over a second and a half.
fn stay(poses: &mut [Pose], rate: f64) {
    let reach = (0.75 * rate) as usize;
    let path: Vec<DVec3> = poses.iter().map(|pose| pose.translation).collect();
    for (i, pose) in poses.iter_mut().enumerate() {
        let window = &path[i.saturating_sub(reach)..(i + reach + 1).min(path.len())];
        let mean = window.iter().sum::<DVec3>() / window.len() as f64;
        pose.translation.x -= mean.x;
        pose.translation.z -= mean.z;
    }
}

/// A face at rest: blinks every few seconds, a smile that comes and goes, brows and jaw that hardly move. Ends as it begins.
fn expression(seconds: f64, duration: f64) -> [f64; 10] {
    let wave = |turns: f64, phase: f64| 0.5 - 0.5 * (std::f64::consts::TAU * (turns * seconds / duration + phase)).cos();
    let turns = (duration / 6.0).round().max(1.0);
    let blinks = (duration / 3.3).floor().max(1.0);
    let slot = duration / blinks;
    let own = hash((seconds / slot) as u64) as f64 / u64::MAX as f64;
    let since = seconds % slot - slot * (0.3 + 0.4 * own);
    let blink = step(-0.10, 0.0, since) * step(0.16, 0.04, since);
    let smile = 0.15 + 0.5 * wave(turns, 0.0);
    [0.05 * wave(2.0 * turns, 0.2), smile, blink, 0.35 * wave(turns, 0.6).powi(2), 0.0, 0.0, 0.0, 0.1 * wave(turns, 0.6), 0.0, 0.0]
}
