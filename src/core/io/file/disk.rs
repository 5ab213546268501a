//! Reading and writing whole files.

use super::error::{FileError, FormatError};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

/// Maps a file and decodes it.
pub fn read_with<T>(
    path: &Path,
    decode: impl FnOnce(&[u8]) -> Result<T, FormatError>,
) -> Result<T, FileError> {
    let failed = |cause| FileError::Read {
        file: path.into(),
        cause,
    };
    let file = File::open(path).map_err(failed)?;
    if !file.metadata().map_err(failed)?.is_file() {
        return Err(failed(io::Error::other(
            "found a folder or device, expected a file",
        )));
    }
    #[cfg(not(target_arch = "wasm32"))]
    let bytes = map(&file).map_err(failed)?;
    #[cfg(target_arch = "wasm32")]
    let bytes = fs::read(path).map_err(failed)?;
    decode(&bytes).map_err(|fault| FileError::Content {
        file: path.into(),
        fault,
    })
}

/// Maps a file into memory; its bytes are read on access.
///
/// # Errors
/// When the system cannot map the file.
#[cfg(not(target_arch = "wasm32"))]
pub fn map(file: &File) -> io::Result<memmap2::Mmap> {
    // SAFETY: the mapping is only read. Should another program shorten the file meanwhile, the
    // system ends this process; this one never does, as it replaces files whole.
    unsafe { memmap2::Mmap::map(file) }
}

/// Writes encoded bytes to a file, whole or not at all.
pub fn write_encoded(path: &Path, bytes: Result<Vec<u8>, FormatError>) -> Result<(), FileError> {
    let bytes = bytes.map_err(|fault| FileError::Content {
        file: path.into(),
        fault,
    })?;
    replace(path, &bytes)
}

/// Replaces a file with [`write_whole`], with an error that names it.
///
/// # Errors
/// When the file cannot be written, for example because the disk is full. A file that was at `path`
/// is then unchanged.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    write_whole(path, bytes).map_err(|cause| FileError::Write {
        file: path.into(),
        cause,
    })
}

/// Writes a file beside `path` and renames it, so that the target is either the old file or the
/// whole new one.
///
/// # Errors
/// When the file cannot be written. A file that was at `path` is then unchanged.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // Two threads may write the same file: each has a part of its own.
    static WRITES: AtomicU64 = AtomicU64::new(0);
    let write = WRITES.fetch_add(1, Ordering::Relaxed);
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.{write}.part", std::process::id()));
    let part = path.with_file_name(name);
    let outcome = write_synced(&part, bytes).and_then(|()| fs::rename(&part, path));
    if outcome.is_err() {
        // A failed removal is not reported: the user must see the first failure.
        fs::remove_file(&part).ok();
    }
    outcome
}

fn write_synced(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}
