//! Reading of a `.ply`.

use super::{compressed, header, plain, table::ElementTable};
use crate::{
    avatar::Avatar,
    io::{
        file::{FileError, FormatError, read_with},
        splats::{Found, Up, check_count},
    },
};
use std::{fs::File, io::Read, path::Path};

/// Reads an avatar file or a 3DGS `.ply`, told apart by content. `up` is the axis of a `.ply` that
/// points up. None: the axis that a comment in the file names (written by
/// [`crate::io::ply_export`]), else [`Up::TRAINED`].
///
/// # Errors
/// When the file cannot be opened, is neither, or breaks a rule.
pub fn open(path: &Path, up: Option<Up>) -> Result<Avatar, FileError> {
    if !is_ply(path) {
        return Avatar::read(path);
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    read_with(path, |bytes| from_bytes(bytes, &name, up))
}

/// Whether a file is a `.ply` by its content or its name. False if it can't be read: opening it
/// then gives the error.
pub fn is_ply(path: &Path) -> bool {
    let mut start = [0; 4];
    let read = File::open(path).and_then(|mut file| file.read_exact(&mut start));
    let named = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("ply"));
    named || read.is_ok() && starts_ply(&start)
}

/// Whether bytes begin as a `.ply` does.
pub fn starts_ply(bytes: &[u8]) -> bool {
    matches!(bytes, [b'p', b'l', b'y', b'\r' | b'\n', ..])
}

/// Reads an avatar from the bytes of a `.ply`. `up`: see [`open`].
///
/// # Errors
/// When a property is missing, no vertex has finite numbers, or the file ends too soon.
pub fn from_bytes(bytes: &[u8], name: &str, up: Option<Up>) -> Result<Avatar, FormatError> {
    let mut splats = read(bytes)?.sound()?.splats;
    splats.up = up.unwrap_or(splats.up);
    splats.to_avatar(name)
}

/// Reads the splats of a `.ply`, plain or compressed as SuperSplat does. No number is checked.
///
/// # Errors
/// When a property is missing or the file ends too soon.
pub fn read(bytes: &[u8]) -> Result<Found, FormatError> {
    let header = header::parse(bytes)?;
    check_count(header.vertices.count)?;
    let up = header.up.unwrap_or(Up::TRAINED);
    let mut found = if compressed::is_compressed(&header) {
        compressed::read(bytes, &header, up)
    } else {
        plain::read(&ElementTable::new(bytes, &header, &header.vertices)?, up)
    }?;
    if header.up.is_none() {
        found.assumptions.push(Up::assumed());
    }
    Ok(found)
}
