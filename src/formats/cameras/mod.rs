//! Cameras of other programs, told apart by content: `cameras.json` of 3DGS and mmlphuman,
//! `transforms.json` of NeRF's programs, COLMAP's text files.

pub mod colmap;
pub mod transforms;

use crate::assumption::Assumption;
use effigy_core::{
    io::{
        cameras,
        file::{FileError, FormatError, excerpt},
    },
    scene::Camera,
};
use glam::DAffine3;
use serde::de::IgnoredAny;
use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

/// What can be read.
const KNOWN: &str = "cameras.json as 3DGS or mmlphuman writes it, transforms.json with `frames`, or COLMAP's \
     cameras.txt and images.txt";

/// The cameras of a file, at least one, and what was taken where it leaves something open.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenedCameras {
    /// In the world of [`read`].
    pub cameras: Vec<Camera>,
    /// One for each decision, however many cameras it concerns.
    pub assumptions: Vec<Assumption>,
}

/// Reads cameras from a file, or from a folder with COLMAP's text files. `world` leads from the
/// file's axes to the world, see [`cameras::parse`].
///
/// # Errors
/// When a file can't be read, is of no known kind, or has a camera that is no pinhole.
pub fn read(path: &Path, world: DAffine3) -> Result<OpenedCameras, FileError> {
    if path.is_dir() {
        return colmap::read(path, world);
    }
    let bytes = bytes(path)?;
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    match text.trim_ascii_start().first() {
        Some(b'{') => {
            let keys = keys(text).map_err(|fault| content(path, fault))?;
            if keys.contains_key("frames") {
                return transforms::parse(text, path, world).map_err(|fault| content(path, fault));
            }
            if !keys.contains_key("cameras") {
                let names: Vec<_> = keys.keys().map(|key| format!("`{key}`")).collect();
                let found = format!("a JSON object of {}", names.join(", "));
                return Err(content(path, FormatError::container(found, KNOWN)));
            }
        }
        Some(b'[') => {}
        _ => return colmap::read(path, world),
    }
    let cameras = cameras::parse(text, world).map_err(|fault| content(path, fault))?;
    Ok(OpenedCameras {
        cameras,
        assumptions: vec![],
    })
}

/// The names of an object's fields.
fn keys(text: &[u8]) -> Result<BTreeMap<String, IgnoredAny>, FormatError> {
    serde_json::from_slice(text).map_err(|error| not_json(&error))
}

/// JSON that can't be parsed, or has another shape.
fn not_json(error: &serde_json::Error) -> FormatError {
    FormatError::container(excerpt(&error.to_string()), KNOWN)
}

fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    std::fs::read(path).map_err(|cause| FileError::Read {
        file: path.into(),
        cause,
    })
}

fn content(path: impl Into<PathBuf>, fault: FormatError) -> FileError {
    FileError::Content {
        file: path.into(),
        fault,
    }
}

/// That lenses distort, which pictures that are drawn don't. None: none does.
fn distortion(distorts: bool) -> Option<Assumption> {
    distorts.then(|| Assumption {
        what: "distortion of the lens",
        taken: "left out".into(),
        because: "images are drawn as a pinhole sees them".into(),
    })
}

#[cfg(test)]
mod tests;
