//! How many splats a file of some size may hold, so that a few bytes cannot take gigabytes.

use effigy_core::io::{file::FormatError, splats::check_count};

/// Splats that any file may hold.
pub const SMALL: u64 = 100_000;
/// Bytes a splat that a file with more than [`SMALL`] splats has at least: the tightest formats
/// need twice as many for real scenes.
pub const BYTES_PER_SPLAT: u64 = 4;

/// Checks a number of splats against the bytes that hold them.
///
/// # Errors
/// When there are none, too many for any avatar, or too many for the bytes.
pub fn check(count: u64, bytes: u64) -> Result<(), FormatError> {
    check_count(count)?;
    let most = SMALL.max(bytes / BYTES_PER_SPLAT);
    if count > most {
        return Err(FormatError::container(
            format!("{count} Gaussians in {bytes} bytes"),
            format!("at most {most}"),
        ));
    }
    Ok(())
}
