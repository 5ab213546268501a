//! One writer for all formats.

use super::{SplatFormat, antimatter, gltf, spz};
use effigy_core::io::{
    file::FormatError,
    ply_export::to_ply,
    splats::{Splats, Up},
};

/// The endings of files that can be written.
pub const WRITTEN: [&str; 4] = ["ply", "spz", "splat", "glb"];

/// The bytes of a file. Each format has its own axes, and its own codes of numbers.
///
/// # Errors
/// When splats break a rule, or the format is only read.
pub fn write(splats: Splats, format: SplatFormat) -> Result<Vec<u8>, FormatError> {
    splats.check()?;
    match format {
        SplatFormat::Ply => Ok(to_ply(&splats.with_up(Up::TRAINED))),
        SplatFormat::Splat => Ok(antimatter::write(splats)),
        SplatFormat::Spz => spz::write(splats).map_err(|error| {
            FormatError::container(format!("an error of compression, {error}"), "none")
        }),
        SplatFormat::Glb => Ok(gltf::write(splats)),
        other => Err(FormatError::container(
            format!("{other:?} to write"),
            format!("one of {}", WRITTEN.join(", ")),
        )),
    }
}
