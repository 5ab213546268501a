//! Opening of avatars and clips of any kind, told apart by content.

use crate::{
    assumption::Assumption,
    bvh,
    capture::Captured,
    npz,
    retarget::{self, Girth, Report, RetargetOptions},
    webavatar::{self, Imported},
};
use effigy_core::{
    avatar::{Avatar, Clip},
    io::{
        file::{FileError, read_with},
        ply::{self, Up},
    },
};
use std::{
    fs::File,
    io::Read,
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
    Zip,
    Json,
    Bvh,
    /// Effigy's own, or nothing that is known.
    Other,
}

impl Content {
    fn of(path: &Path) -> Self {
        if ply::is_ply(path) {
            return Self::Ply;
        }
        let mut start = [0; 64];
        // A file that can't be read gives its error when it is opened.
        let read = File::open(path).and_then(|mut file| file.read(&mut start));
        let start = &start[..read.unwrap_or_default()];
        let first = start.iter().find(|byte| !byte.is_ascii_whitespace());
        if npz::is_zip(start) {
            Self::Zip
        } else if bvh::is_bvh(start) {
            Self::Bvh
        } else if first == Some(&b'[') {
            Self::Json
        } else {
            Self::Other
        }
    }
}

/// Whether a file is an avatar of another program and not a `.ply`.
pub fn is_foreign(path: &Path) -> bool {
    Content::of(path) == Content::Zip
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
#[derive(Clone, Debug)]
pub struct ClipOptions {
    /// Frames a second of a file that does not say.
    pub rate_unsaid: f64,
    /// For motion of other bodies.
    pub retarget: RetargetOptions,
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
    Content::of(path) == Content::Bvh
}

/// Reads motion of another program.
///
/// # Errors
/// When the file cannot be opened, is of no known kind, or breaks a rule.
pub fn capture(path: &Path) -> Result<Captured, FileError> {
    read_with(path, bvh::from_bytes)
}

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
    if is_capture(path) {
        let captured = capture(path)?;
        let mut retargeting = options.retarget.clone();
        if retargeting.girth.is_none() {
            retargeting.girth = Girth::of(avatar);
        }
        let made = retarget::retarget(&captured.capture, &avatar.skeleton, &name, &retargeting);
        let made = made.map_err(|fault| FileError::Content {
            file: path.to_owned(),
            fault,
        })?;
        return Ok(OpenedClip {
            clip: made.clip,
            assumptions: captured.assumptions,
            report: Some(made.report),
        });
    }
    if Content::of(path) != Content::Json {
        return Clip::read(path).map(made_for_it);
    }
    let poses = read_with(path, |bytes| {
        webavatar::read_poses(bytes, &name, &avatar.skeleton, options.rate_unsaid)
    });
    poses.map(made_for_it)
}

/// The poses that belong to `NAME.npz`: `NAME_poses.json` beside it, where there is one.
pub fn poses_beside(path: &Path) -> Option<PathBuf> {
    let mut name = path.file_stem()?.to_owned();
    name.push("_poses.json");
    let poses = path.with_file_name(name);
    poses.is_file().then_some(poses)
}
