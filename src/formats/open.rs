//! Opening of avatars and clips of any kind, told apart by content.

#[cfg(feature = "fbx")]
use crate::fbx;
use crate::{
    assumption::Assumption,
    bvh,
    capture::{Captured, Rest},
    gltf_motion, npz, pickle,
    retarget::{self, Girth, Report, RetargetOptions},
    smpl,
    webavatar::{self, Imported},
};
use effigy_core::{
    avatar::{Avatar, Clip, Skeleton},
    io::{
        file::{FileError, FormatError, read_with},
        ply::{self, Up},
    },
};
use glam::DVec3;
use std::{
    fs::File,
    io::{self, Read},
    path::{Path, PathBuf},
};

/// What files leave open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OpenOptions {
    /// The axis of a `.ply` that points up; None: as the file says.
    pub up: Option<Up>,
    /// Of the paper's model.
    pub webavatar: webavatar::Options,
}

/// What a file is by its first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Content {
    Ply,
    /// The paper's model.
    Model,
    /// The paper's poses.
    Poses,
    Capture(CaptureFormat),
    /// Effigy's own, or nothing that is known.
    Other,
}

/// Motion of other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CaptureFormat {
    Bvh,
    Gltf,
    Fbx,
    Smpl,
}

impl Content {
    fn of(path: &Path) -> Self {
        if ply::is_ply(path) {
            return Self::Ply;
        }
        // A file that can't be read gives its error when it is opened.
        Self::read(path).unwrap_or(Self::Other)
    }

    fn read(path: &Path) -> io::Result<Self> {
        let mut file = File::open(path)?;
        let mut start = [0; 64];
        let length = file.read(&mut start)?;
        let start = &start[..length];
        let text = start.trim_ascii_start();
        let capture = if npz::is_zip(start) {
            if npz::lists(file, webavatar::POSITIONS) {
                return Ok(Self::Model);
            }
            CaptureFormat::Smpl
        } else if bvh::is_bvh(start) {
            CaptureFormat::Bvh
        } else if gltf_motion::is_glb(start) || text.starts_with(b"{") {
            CaptureFormat::Gltf
        } else if is_fbx(start) {
            CaptureFormat::Fbx
        } else if start.starts_with(b"\x93NUMPY") || pickle::is_pickle(start) {
            CaptureFormat::Smpl
        } else if text.starts_with(b"[") {
            return Ok(Self::Poses);
        } else {
            return Ok(Self::Other);
        };
        Ok(Self::Capture(capture))
    }
}

/// Whether bytes begin as an FBX does.
fn is_fbx(start: &[u8]) -> bool {
    start.starts_with(b"Kaydara FBX Binary") || start.starts_with(b"; FBX")
}

/// Whether a file is an avatar of another program and not a `.ply`.
pub fn is_foreign(path: &Path) -> bool {
    Content::of(path) == Content::Model
}

/// Reads an avatar: Effigy's own, a 3DGS `.ply` or the paper's `.npz`.
///
/// # Errors
/// When the file cannot be opened, is none of them, or breaks a rule.
pub fn avatar(path: &Path, options: &OpenOptions) -> Result<Imported, FileError> {
    if !is_foreign(path) {
        return Ok(Imported {
            avatar: ply::open(path, options.up)?,
            assumptions: vec![],
        });
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    read_with(path, |bytes| {
        webavatar::from_bytes(bytes, &name, &options.webavatar)
    })
}

/// How a motion file becomes a clip.
#[derive(Clone, Debug, Default)]
pub struct ClipOptions {
    /// Which motion of a file.
    pub capture: CaptureOptions,
    /// For motion of other bodies.
    pub retarget: RetargetOptions,
}

/// Which motion of a file of another program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CaptureOptions {
    /// Frames a second of a file that does not say, or whose motion stands at any time; None: as
    /// its format says.
    pub rate: Option<f64>,
    /// The name of an animation, or its number from 0; None: the first.
    pub animation: Option<String>,
    /// Which person of several; those who are seen longer come first.
    pub person: usize,
}

/// A clip, and how it was made of its file.
#[derive(Clone, Debug)]
pub struct OpenedClip {
    /// Moves the avatar.
    pub clip: Clip,
    /// What the file left open.
    pub assumptions: Vec<Assumption>,
    /// How well the avatar follows; None: the file is made for such avatars.
    pub report: Option<Report>,
}

/// Whether a file is motion of another program, of a body that the avatar need not have.
pub fn is_capture(path: &Path) -> bool {
    matches!(Content::of(path), Content::Capture(_) | Content::Poses)
}

/// Reads motion of another program: BVH, glTF, VRM, FBX (in builds with the feature `fbx`), SMPL's
/// parameters, or the paper's poses.
///
/// # Errors
/// When the file cannot be opened, is of no known kind, or breaks a rule.
pub fn capture(path: &Path, options: &CaptureOptions) -> Result<Captured, FileError> {
    let content = Content::of(path);
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut beside = |name: &str| std::fs::read(folder.join(name)).ok();
    read_with(path, |bytes| match content {
        Content::Capture(CaptureFormat::Gltf) => {
            let options = gltf_motion::Options {
                rate: options.rate,
                animation: options.animation.clone(),
                rest: Rest::Bind,
            };
            gltf_motion::from_bytes(bytes, &options, &mut beside)
        }
        Content::Capture(CaptureFormat::Fbx) => read_fbx(bytes, options),
        Content::Capture(CaptureFormat::Smpl) => {
            let options = smpl::Options {
                rate: options.rate,
                person: options.person,
            };
            smpl::from_bytes(bytes, &options)
        }
        Content::Poses => webavatar::capture_poses(bytes, options.rate),
        // What is of no known kind is refused as the most common one.
        _ => bvh::from_bytes(bytes),
    })
}

#[cfg(feature = "fbx")]
fn read_fbx(bytes: &[u8], options: &CaptureOptions) -> Result<Captured, FormatError> {
    let options = fbx::Options {
        rate: options.rate,
        animation: options.animation.clone(),
        rest: Rest::Bind,
    };
    fbx::from_bytes(bytes, &options)
}

#[cfg(not(feature = "fbx"))]
fn read_fbx(_: &[u8], _: &CaptureOptions) -> Result<Captured, FormatError> {
    let expected = "another format, or a program that was built with the feature `fbx`";
    Err(FormatError::container("an FBX file", expected))
}

/// Whether a skeleton rests with its arms out, as the paper's and SMPL's do.
fn rests_in_t_pose(skeleton: &Skeleton) -> bool {
    let place = |name: &str| {
        let joint = skeleton.name.iter().position(|own| own == name)?;
        Some(DVec3::from(skeleton.rest[joint].map(f64::from)))
    };
    let arm = place("LeftArm").zip(place("LeftForeArm"));
    arm.is_some_and(|(from, to)| (to - from).angle_between(DVec3::X) < LEVEL)
}

/// How far an arm that is held out may point up or down, radians.
const LEVEL: f64 = 0.35;

/// Reads a clip for an avatar: Effigy's own, the poses beside the paper's model, or motion of
/// another body, which is retargeted.
///
/// # Errors
/// When the file cannot be opened, is none of them, or breaks a rule.
pub fn clip(path: &Path, avatar: &Avatar, options: &ClipOptions) -> Result<OpenedClip, FileError> {
    let made_for_it = |clip| OpenedClip {
        clip,
        assumptions: vec![],
        report: None,
    };
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let content = Content::of(path);
    if content == Content::Other || content == Content::Model {
        return Clip::read(path).map(made_for_it);
    }
    if content == Content::Poses && rests_in_t_pose(&avatar.skeleton) {
        let rate = options.capture.rate.unwrap_or(webavatar::POSES_RATE);
        let poses = read_with(path, |bytes| {
            webavatar::read_poses(bytes, &name, &avatar.skeleton, rate)
        });
        return poses.map(made_for_it);
    }
    let captured = capture(path, &options.capture)?;
    let mut retargeting = options.retarget.clone();
    if retargeting.girth.is_none() {
        retargeting.girth = Girth::of(avatar);
    }
    let made = retarget::retarget(&captured.capture, &avatar.skeleton, &name, &retargeting);
    let made = made.map_err(|fault| FileError::Content {
        file: path.to_owned(),
        fault,
    })?;
    Ok(OpenedClip {
        clip: made.clip,
        assumptions: captured.assumptions,
        report: Some(made.report),
    })
}

/// The poses that belong to `NAME.npz`: `NAME_poses.json` beside it, where there is one.
pub fn poses_beside(path: &Path) -> Option<PathBuf> {
    let mut name = path.file_stem()?.to_owned();
    name.push("_poses.json");
    let poses = path.with_file_name(name);
    poses.is_file().then_some(poses)
}
