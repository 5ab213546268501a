//! Cameras of other programs, told apart by content: `cameras.json` of 3DGS and mmlphuman,
//! `transforms.json` of NeRF's programs, COLMAP's text files.

mod colmap;
mod opened;
mod transforms;

pub use opened::OpenedCameras;

use crate::{source::Source, splats::Folder};
use effigy_core::io::{
    cameras,
    file::{FileError, FormatError},
};
use glam::DAffine3;
use opened::{KNOWN, bytes, content, not_json};
use serde::de::IgnoredAny;
use std::{collections::BTreeMap, path::Path};

/// Reads cameras from a file, which may be packed, or from a folder with COLMAP's text files. `world`
/// leads from the file's axes to the world, see [`cameras::parse`].
///
/// # Errors
/// When a file can't be read, is of no known kind, or has a camera that is no pinhole.
pub fn read(path: &Path, world: DAffine3) -> Result<OpenedCameras, FileError> {
    let images;
    let file = if path.is_dir() {
        images = colmap::images_in(path)?;
        &images
    } else {
        path
    };
    let bytes = bytes(file)?;
    let mut beside = Folder::of(file);
    let source = Source::new(&bytes, file, &mut beside);
    let read = source.cameras(|source| unpacked(source, file, world));
    read.map_err(|fault| content(file, fault))
}

/// Reads what is packed in nothing. `path`: of the file that was opened.
fn unpacked(source: Source, path: &Path, world: DAffine3) -> Result<OpenedCameras, FormatError> {
    let text = source.bytes;
    match text.trim_ascii_start().first() {
        Some(b'{') => {
            let keys = keys(text)?;
            if keys.contains_key("frames") {
                return transforms::parse(text, path, world);
            }
            if !keys.contains_key("cameras") {
                let names: Vec<_> = keys.keys().map(|key| format!("`{key}`")).collect();
                let found = format!("a JSON object of {}", names.join(", "));
                return Err(FormatError::container(found, KNOWN));
            }
        }
        Some(b'[') => {}
        _ => return colmap::read(source, world),
    }
    Ok(OpenedCameras {
        cameras: cameras::parse(text, world)?,
        assumptions: vec![],
    })
}

/// The names of an object's fields.
fn keys(text: &[u8]) -> Result<BTreeMap<String, IgnoredAny>, FormatError> {
    serde_json::from_slice(text).map_err(|error| not_json(&error))
}

#[cfg(test)]
mod tests;
