//! Opening of avatars and clips of any kind, told apart by content.

use crate::{
    npz,
    webavatar::{self, Imported},
};
use effigy_core::{
    avatar::{Clip, Skeleton},
    io::{
        file::{FileError, read_with},
        ply,
        splats::Up,
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

/// Reads a clip for an avatar: Effigy's own, or the poses beside the paper's model. `rate`: frames
/// a second of a file that does not say.
///
/// # Errors
/// When the file cannot be opened, is neither, or breaks a rule.
pub fn clip(path: &Path, skeleton: &Skeleton, rate: f64) -> Result<Clip, FileError> {
    if Content::of(path) != Content::Json {
        return Clip::read(path);
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    read_with(path, |bytes| {
        webavatar::read_poses(bytes, &name, skeleton, rate)
    })
}

/// The poses that belong to `NAME.npz`: `NAME_poses.json` beside it, where there is one.
pub fn poses_beside(path: &Path) -> Option<PathBuf> {
    let mut name = path.file_stem()?.to_owned();
    name.push("_poses.json");
    let poses = path.with_file_name(name);
    poses.is_file().then_some(poses)
}
