//! One reader for all formats.

use super::{Beside, Found, SplatFormat, antimatter, gltf, ksplat, sog, spz};
use effigy_core::io::{file::FormatError, ply};

/// Reads a file of a format and checks its numbers; `beside` has the files that it refers to.
///
/// # Errors
/// When the file is of another format, is cut off, or breaks a rule of it or of
/// [`Splats::check`](effigy_core::io::splats::Splats::check).
pub fn read(
    bytes: &[u8],
    format: SplatFormat,
    beside: &mut dyn Beside,
) -> Result<Found, FormatError> {
    let found: Found = match format {
        SplatFormat::Ply => ply::read(bytes)?.into(),
        SplatFormat::Splat => antimatter::read(bytes)?.into(),
        SplatFormat::Spz => spz::read(bytes)?,
        SplatFormat::Sog => sog::in_archive(bytes)?.into(),
        SplatFormat::SogMeta => sog::in_folder(bytes, beside)?.into(),
        SplatFormat::Ksplat => ksplat::read(bytes)?.into(),
        SplatFormat::Glb | SplatFormat::Gltf => gltf::read(bytes, beside)?,
    };
    found.splats.check()?;
    Ok(found)
}
