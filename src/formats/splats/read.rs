//! One reader for all formats.

use super::{Beside, Found, SplatFormat, antimatter, gltf, ksplat, sog, spz};
use effigy_core::io::{file::FormatError, ply, splats::Up};

/// Reads a file of a format, without the splats that can't be drawn; `beside` has the files that it
/// refers to.
///
/// # Errors
/// When the file is of another format, is cut off, breaks a rule of it, or has no splat that keeps
/// those of [`Splats::check`](effigy_core::io::splats::Splats::check).
pub fn read(
    bytes: &[u8],
    format: SplatFormat,
    beside: &mut dyn Beside,
) -> Result<Found, FormatError> {
    let mut found: Found = match format {
        SplatFormat::Ply => ply::read(bytes)?,
        SplatFormat::Splat => antimatter::read(bytes)?.into(),
        SplatFormat::Spz => spz::read(bytes)?,
        SplatFormat::Sog => sog::in_archive(bytes)?,
        SplatFormat::SogMeta => sog::in_folder(bytes, beside)?.into(),
        SplatFormat::SogLod => sog::streamed(bytes, beside)?,
        SplatFormat::Ksplat => ksplat::read(bytes)?.into(),
        SplatFormat::Glb | SplatFormat::Gltf => gltf::read(bytes, beside)?,
    };
    match format {
        // A .ply says whether it names its axis; that of the others is the format's.
        SplatFormat::Ply | SplatFormat::Spz | SplatFormat::Glb | SplatFormat::Gltf => {}
        SplatFormat::Splat
        | SplatFormat::Sog
        | SplatFormat::SogMeta
        | SplatFormat::SogLod
        | SplatFormat::Ksplat => found.assumptions.push(Up::assumed()),
    }
    found.sound()
}
