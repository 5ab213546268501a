//! A clip of a capture for the baked bodies: cut, made to repeat, and with a face that moves.

use crate::bake::body::EXPRESSIONS;
use crate::bake::source::text::SourceError;
use effigy_core::avatar::{Clip, Pose, Skeleton};
use effigy_core::io::file::FileError;
use effigy_core::random::hash;
use effigy_formats::{open, retarget};
use effigy_math::noise::smoothstep;
use glam::{DQuat, DVec3};
use std::path::Path;

/// Which part of a capture becomes a clip, and how.
#[derive(Clone, Debug)]
pub struct CutOptions {
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
    /// Where the capture comes from and on what terms it may be used.
    pub credit: String,
}

/// A clip of a skeleton from motion capture of any body.
///
/// # Errors
/// When the file can't be read, no body is found in it, or it does not have the seconds that the
/// options ask for.
pub fn motion(file: &Path, skeleton: &Skeleton, options: &CutOptions) -> Result<Clip, SourceError> {
    let capture = open::capture(file, &open::CaptureOptions::default())?.capture;
    let retargeting = retarget::RetargetOptions {
        rate: Some(options.rate),
        ..retarget::RetargetOptions::default()
    };
    let name = file
        .file_stem()
        .map_or_else(|| "clip".into(), |stem| stem.to_string_lossy());
    let whole = retarget::retarget(&capture, skeleton, &name, &retargeting);
    let whole = whole.map_err(|fault| FileError::Content {
        file: file.to_path_buf(),
        fault,
    })?;
    cut(&whole.clip, skeleton, options, file)
}

/// Cuts a clip. `file` is named in errors.
fn cut(
    whole: &Clip,
    skeleton: &Skeleton,
    options: &CutOptions,
    file: &Path,
) -> Result<Clip, SourceError> {
    let length = whole.frames() as f64 / whole.rate;
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
    let pose = |frame: f64| whole.sample(options.from + frame / options.rate);
    let mut poses: Vec<Pose> = (0..frames).map(|i| pose(i as f64)).collect();
    // What comes before the first frame, for the end to fade into.
    let fade = ((options.fade * options.rate) as usize).min(frames - 1);
    let mut lead_in: Vec<Pose> = (0..fade).map(|i| pose(i as f64 - fade as f64)).collect();
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
        face_forward(&mut poses, skeleton);
    }
    let duration = frames as f64 / options.rate;
    Ok(Clip {
        name: whole.name.clone(),
        credit: options.credit.clone(),
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

/// Moves a pose towards another one; `share` from 0 to 1.
fn fade_into(pose: &mut Pose, other: &Pose, share: f64) {
    pose.translation = pose.translation.lerp(other.translation, share);
    for (own, other) in pose.rotation.iter_mut().zip(&other.rotation) {
        let from = DQuat::from_scaled_axis(*own);
        let to = DQuat::from_scaled_axis(*other);
        *own = from.slerp(to, share).to_scaled_axis();
    }
}

/// Turns the whole clip about the vertical so that the first frame's hips face +z.
fn face_forward(poses: &mut [Pose], skeleton: &Skeleton) {
    let root = DVec3::from(skeleton.rest[0].map(f64::from));
    let Some(first) = poses.first() else { return };
    let forward = DQuat::from_scaled_axis(first.rotation[0]) * DVec3::Z;
    let turn = DQuat::from_rotation_y(-forward.x.atan2(forward.z));
    for pose in poses {
        let hips = DQuat::from_scaled_axis(pose.rotation[0]);
        pose.rotation[0] = retarget::shorter(turn * hips).to_scaled_axis();
        pose.translation = turn * (pose.translation + root) - root;
    }
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
