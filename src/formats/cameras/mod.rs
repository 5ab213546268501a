//! Cameras of other programs, told apart by content: `cameras.json` of 3DGS and mmlphuman,
//! `transforms.json` of NeRF's programs, COLMAP's text files.

mod colmap;
mod opened;
mod transforms;

pub use opened::OpenedCameras;

use effigy_core::io::{
    cameras,
    file::{FileError, FormatError},
    text,
};
use glam::DAffine3;
use opened::{KNOWN, bytes, content, not_json};
use serde::de::IgnoredAny;
use std::{collections::BTreeMap, path::Path};

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
    let text = text::utf8(&bytes);
    let text = &*text;
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

#[cfg(test)]
mod tests;
