//! Errors of reading and writing captures.

use crate::left_out::{Omission, tally};
use effigy_core::io::file::{FileError, FormatError};
use std::{
    fs::File,
    io::{self, Read},
    path::{Path, PathBuf},
};

/// Why a capture, or a picture of one, was not read or written.
#[derive(Debug, thiserror::Error)]
pub enum CaptureError {
    /// A file can't be read or written, or breaks a rule of its format.
    #[error(transparent)]
    File(#[from] FileError),
    /// The folder has no layout that is known.
    #[error("{}: found no {}, expected a capture's folder", .folder.display(), .expected)]
    Layout {
        /// The folder.
        folder: PathBuf,
        /// The files that layouts are known by.
        expected: String,
    },
    /// Nothing is left to learn from.
    #[error(
        "{}: found 0 usable frames, expected at least 1; left out: {}",
        .folder.display(),
        reasons(.left_out)
    )]
    Empty {
        /// The folder.
        folder: PathBuf,
        /// What was left out, and why.
        left_out: Vec<Omission>,
    },
    /// A camera or a frame that does not exist was requested.
    #[error("camera {camera}, frame {frame}: found no picture that can be used")]
    NoPicture {
        /// Index of the camera.
        camera: usize,
        /// Index of the frame.
        frame: usize,
    },
}

/// The reasons with how often there was each, and an example.
fn reasons(left_out: &[Omission]) -> String {
    let counts = tally(left_out);
    let mut text: Vec<String> = counts
        .iter()
        .map(|(kind, count)| format!("{count} {kind}"))
        .collect();
    if let Some(first) = left_out.first() {
        text.push(format!("first {first}"));
    }
    if text.is_empty() {
        return "nothing, as there are no pictures".into();
    }
    text.join("; ")
}

/// A file breaks a rule.
pub fn content(
    file: &Path,
    found: impl std::fmt::Display,
    expected: impl ToString,
) -> CaptureError {
    fault(file, FormatError::container(found, expected))
}

/// A file breaks a rule of its format.
pub fn fault(file: &Path, fault: FormatError) -> CaptureError {
    CaptureError::File(FileError::Content {
        file: file.into(),
        fault,
    })
}

/// A file can't be read.
pub fn unreadable(file: &Path, cause: io::Error) -> CaptureError {
    CaptureError::File(FileError::Read {
        file: file.into(),
        cause,
    })
}

/// A file or folder can't be written.
pub fn unwritable(file: &Path, cause: io::Error) -> CaptureError {
    CaptureError::File(FileError::Write {
        file: file.into(),
        cause,
    })
}

/// The bytes of a file of at most `limit` bytes.
pub fn read_bytes(file: &Path, limit: u64) -> Result<Vec<u8>, CaptureError> {
    let failed = |cause| unreadable(file, cause);
    let opened = File::open(file).map_err(failed)?;
    let about = opened.metadata().map_err(failed)?;
    if !about.is_file() {
        let other = io::Error::other("found a folder or device, expected a file");
        return Err(unreadable(file, other));
    }
    let too_long = |length: u64| {
        content(
            file,
            format!("{length} bytes"),
            format!("at most {limit} bytes"),
        )
    };
    if about.len() > limit {
        return Err(too_long(about.len()));
    }
    let mut bytes = Vec::with_capacity(about.len() as usize);
    // It may grow meanwhile.
    opened
        .take(limit + 1)
        .read_to_end(&mut bytes)
        .map_err(failed)?;
    if bytes.len() as u64 > limit {
        return Err(too_long(bytes.len() as u64));
    }
    Ok(bytes)
}
