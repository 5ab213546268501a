//! Opening of avatars and clips of any kind, told apart by content.

#[cfg(feature = "fbx")]
use crate::fbx;
use crate::{
    assumption::Assumption,
    bvh,
    capture::{Captured, Rest},
    gltf_motion, guess, npz, pickle,
    retarget::{self, Girth, Report, RetargetOptions},
    smpl,
    splats::{self, Beside, Folder, Found, SplatFormat},
    webavatar::{self, Imported},
};
use effigy_core::{
    avatar::{Avatar, Clip, Skeleton},
    io::{
        file::{FileError, FormatError, read_with},
        splats::Up,
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
    /// The axis of a splat file that points up; None: as the file or its format says.
    pub up: Option<Up>,
    /// Of the paper's model.
    pub webavatar: webavatar::Options,
}

/// What a file is by its content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Content {
    Splats(SplatFormat),
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
        // A file that can't be read gives its error when it is opened.
        let known = Start::read(path).ok().and_then(Start::content);
        let named = || SplatFormat::of_name(path).map(Self::Splats);
        known.or_else(named).unwrap_or(Self::Other)
    }
}

/// The first bytes of a file.
struct Start {
    file: File,
    bytes: Vec<u8>,
    /// Of the whole file.
    length: u64,
}

impl Start {
    fn read(path: &Path) -> io::Result<Self> {
        let file = File::open(path)?;
        let length = file.metadata()?.len();
        let mut bytes = Vec::new();
        (&file)
            .take(SplatFormat::START as u64)
            .read_to_end(&mut bytes)?;
        Ok(Self {
            file,
            bytes,
            length,
        })
    }

    fn content(self) -> Option<Content> {
        let start = &self.bytes[..];
        if npz::is_zip(start) {
            return Some(self.content_of_zip());
        }
        if bvh::is_bvh(start) {
            return Some(Content::Capture(CaptureFormat::Bvh));
        }
        if is_fbx(start) {
            return Some(Content::Capture(CaptureFormat::Fbx));
        }
        if start.starts_with(b"\x93NUMPY") || pickle::is_pickle(start) {
            return Some(Content::Capture(CaptureFormat::Smpl));
        }
        if start.trim_ascii_start().starts_with(b"[") {
            return Some(Content::Poses);
        }
        match SplatFormat::of(start, self.length)? {
            SplatFormat::Glb | SplatFormat::Gltf if !self.names_splats() => {
                Some(Content::Capture(CaptureFormat::Gltf))
            }
            format => Some(Content::Splats(format)),
        }
    }

    fn content_of_zip(&self) -> Content {
        if splats::is_sog(&self.file) {
            Content::Splats(SplatFormat::Sog)
        } else if npz::lists(&self.file, webavatar::POSITIONS) {
            Content::Model
        } else {
            Content::Capture(CaptureFormat::Smpl)
        }
    }

    /// Whether a glTF's document names the extension of splats.
    fn names_splats(&self) -> bool {
        let name = SPLATS_EXTENSION.as_bytes();
        let mut document = self.bytes.clone();
        // What can't be read is found out when it is opened.
        let _ = (&self.file)
            .take(LONGEST_DOCUMENT)
            .read_to_end(&mut document);
        document.windows(name.len()).any(|word| word == name)
    }
}

/// The extension of glTF without which it has no splats.
const SPLATS_EXTENSION: &str = "KHR_gaussian_splatting";
/// Bytes of a file beside a glTF of motion.
const LONGEST_BESIDE: u64 = 256 << 20;
/// Bytes of a glTF that are searched for it.
const LONGEST_DOCUMENT: u64 = 4 << 20;

/// Whether bytes begin as an FBX does.
fn is_fbx(start: &[u8]) -> bool {
    start.starts_with(b"Kaydara FBX Binary") || start.starts_with(b"; FBX")
}

/// Whether a file is the paper's model.
pub fn is_foreign(path: &Path) -> bool {
    Content::of(path) == Content::Model
}

/// Whether a file consists of splats: by its content, or by its name where that tells nothing.
pub fn is_splats(path: &Path) -> bool {
    matches!(Content::of(path), Content::Splats(_))
}

/// Reads the splats of a file. `up`: the axis that points up; None: as the file or its format says.
///
/// # Errors
/// When the file cannot be opened, has no splats, or breaks a rule.
pub fn splats(path: &Path, up: Option<Up>) -> Result<Found, FileError> {
    // What is of no known format is refused as the most common one.
    let format = match Content::of(path) {
        Content::Splats(format) => format,
        _ => SplatFormat::Ply,
    };
    let mut found = read_with(path, |bytes| {
        splats::read(bytes, format, &mut Folder::of(path))
    })?;
    found.splats.up = up.unwrap_or(found.splats.up);
    Ok(found)
}

/// Reads an avatar: Effigy's own, the paper's `.npz` or splats.
///
/// # Errors
/// When the file cannot be opened, is none of them, or breaks a rule.
pub fn avatar(path: &Path, options: &OpenOptions) -> Result<Imported, FileError> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    match Content::of(path) {
        Content::Splats(_) => {
            let Found {
                splats,
                assumptions,
            } = splats(path, options.up)?;
            let avatar = splats.to_avatar(&name);
            Ok(Imported {
                avatar: avatar.map_err(|fault| FileError::Content {
                    file: path.into(),
                    fault,
                })?,
                assumptions,
            })
        }
        Content::Model => read_with(path, |bytes| {
            webavatar::from_bytes(bytes, &name, &options.webavatar)
        }),
        Content::Poses | Content::Capture(_) => Err(FileError::Content {
            file: path.into(),
            fault: FormatError::container("motion", "an avatar, or `--motion` before it"),
        }),
        Content::Other => Ok(Imported {
            avatar: Avatar::read(path).map_err(|error| unknown(path, error))?,
            assumptions: vec![],
        }),
    }
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
    let mut folder = Folder::of(path);
    let mut beside = |name: &str| folder.file(name, LONGEST_BESIDE).ok();
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
        let clip = Clip::read(path).map_err(|error| unknown(path, error))?;
        return Ok(made_for_it(clip));
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

/// What is read of other programs, for errors.
const KNOWN: &str = "an avatar (.avatar, the paper's .npz), splats (.ply, .splat, .spz, .sog, .ksplat, .glb) or motion \
                     (.motion, .bvh, .fbx, .glb, .vrma, .npz, .pkl)";

/// The error of a file that is no avatar or motion of Effigy's: what it seems to be, where that is
/// known.
pub fn unknown(path: &Path, error: FileError) -> FileError {
    let is_content = matches!(error, FileError::Content { .. });
    let start = Start::read(path).ok().filter(|_| is_content);
    match start.and_then(|start| guess::seems(&start.bytes)) {
        Some(what) => FileError::Content {
            file: path.into(),
            fault: FormatError::container(what, KNOWN),
        },
        None => error,
    }
}

/// What a file is, in a word or two; None: of no known kind, or Effigy's own.
pub fn kind(path: &Path) -> Option<&'static str> {
    Some(match Content::of(path) {
        Content::Splats(format) => match format {
            SplatFormat::Ply => "splats, .ply",
            SplatFormat::Splat => "splats, .splat",
            SplatFormat::Spz => "splats, .spz",
            SplatFormat::Sog | SplatFormat::SogMeta => "splats, SOG",
            SplatFormat::Ksplat => "splats, .ksplat",
            SplatFormat::Glb | SplatFormat::Gltf => "splats, glTF",
        },
        Content::Model => "the paper's model",
        Content::Poses => "the paper's poses",
        Content::Capture(CaptureFormat::Bvh) => "motion, BVH",
        Content::Capture(CaptureFormat::Gltf) => "glTF",
        Content::Capture(CaptureFormat::Fbx) => "motion, FBX",
        Content::Capture(CaptureFormat::Smpl) => "motion, SMPL",
        Content::Other => return None,
    })
}

/// The poses that belong to `NAME.npz`: `NAME_poses.json` beside it, where there is one.
pub fn poses_beside(path: &Path) -> Option<PathBuf> {
    let mut name = path.file_stem()?.to_owned();
    name.push("_poses.json");
    let poses = path.with_file_name(name);
    poses.is_file().then_some(poses)
}
