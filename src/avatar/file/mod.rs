//! `NAME.avatar` and `NAME.motion`: a path or bytes go in, an [`Avatar`] or a [`Clip`] comes out, or one sentence on what is wrong
//! with the file; and the way back. [`format`] says what the files hold.

mod arrays;
mod check;
mod coding;
mod container;
mod deflate;
mod encode;
pub mod format;
mod header;
mod order;
pub use order::Neutral;

use super::{Avatar, Clip};
use format::{AvatarHeader, ClipHeader, Document, Order};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Why a file was not read or written.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    #[error("cannot read {}: {cause}", .file.display())]
    Read { file: PathBuf, cause: io::Error },
    #[error("cannot write {}: {cause}", .file.display())]
    Write { file: PathBuf, cause: io::Error },
    #[error("{}: {fault}", .file.display())]
    Content { file: PathBuf, fault: Fault },
}

/// What is wrong with a file's content.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    #[error("found {found}, expected {expected}")]
    Container { found: String, expected: String },
    #[error("in metadata `{field}` found {found}, expected {expected}")]
    Metadata { field: String, found: String, expected: String },
    #[error("in tensor `{tensor}` found {found}, expected {expected}")]
    Tensor { tensor: String, found: String, expected: String },
}

impl Fault {
    pub(crate) fn metadata(field: &str, found: impl ToString, expected: impl ToString) -> Self {
        Self::Metadata { field: field.into(), found: found.to_string(), expected: expected.to_string() }
    }

    pub(crate) fn container(found: impl ToString, expected: impl ToString) -> Self {
        Self::Container { found: found.to_string(), expected: expected.to_string() }
    }
}

/// The beginning of a text from a file, on one line.
pub(crate) fn clip(text: &str) -> String {
    let line: String = text.chars().take(100).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if line.len() < text.len() { line + "…" } else { line }
}

/// A tensor as a file stores it.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct TensorInfo {
    pub name: String,
    /// U8, I8, U16, U32, F16 or F32.
    pub dtype: String,
    pub shape: Vec<usize>,
    pub bytes: usize,
    /// Bytes in the file.
    pub stored: usize,
    /// How its bytes are arranged, where they are deflated.
    pub deflated: Option<Order>,
    /// What the numbers are.
    pub what: &'static str,
}

/// What a file of either kind holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    Avatar(Box<Avatar>),
    Clip(Box<Clip>),
}

impl Content {
    /// Reads a file of either kind, told apart by its content.
    ///
    /// # Errors
    /// When the file cannot be opened, is neither, or breaks a rule of [`format`].
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// The same from the file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are neither, or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Fault> {
        match container::is_of::<ClipHeader>(bytes)? {
            true => Ok(Self::Clip(Box::new(container::decode::<ClipHeader>(bytes)?))),
            false => Ok(Self::Avatar(Box::new(container::decode::<AvatarHeader>(bytes)?))),
        }
    }
}

/// The tensors of a file of either kind, as it stores them.
///
/// # Errors
/// When the file cannot be opened, is neither, or breaks a rule.
pub fn tensors(path: &Path) -> Result<Vec<TensorInfo>, FileError> {
    read_with(path, tensors_of)
}

/// The same from the file's bytes, at any alignment.
///
/// # Errors
/// When the bytes are neither, or break a rule.
pub fn tensors_of(bytes: &[u8]) -> Result<Vec<TensorInfo>, Fault> {
    match container::is_of::<ClipHeader>(bytes)? {
        true => container::list::<ClipHeader>(bytes),
        false => container::list::<AvatarHeader>(bytes),
    }
}

/// Maps a file and decodes it.
pub(super) fn read_with<T>(path: &Path, decode: impl FnOnce(&[u8]) -> Result<T, Fault>) -> Result<T, FileError> {
    let failed = |cause| FileError::Read { file: path.into(), cause };
    let file = File::open(path).map_err(failed)?;
    if !file.metadata().map_err(failed)?.is_file() {
        return Err(failed(io::Error::other("found a folder or device, expected a file")));
    }
    #[cfg(not(target_arch = "wasm32"))]
    let bytes = map(&file).map_err(failed)?;
    #[cfg(target_arch = "wasm32")]
    let bytes = fs::read(path).map_err(failed)?;
    decode(&bytes).map_err(|fault| FileError::Content { file: path.into(), fault })
}

/// The bytes of a file, read as they are asked for.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn map(file: &File) -> io::Result<memmap2::Mmap> {
    // SAFETY: the mapping is only read. Should another program shorten the file meanwhile, the system ends this process; this one never
    // does, as it replaces files whole.
    unsafe { memmap2::Mmap::map(file) }
}

fn write(bytes: Result<Vec<u8>, Fault>, path: &Path) -> Result<(), FileError> {
    replace(path, &bytes.map_err(|fault| FileError::Content { file: path.into(), fault })?)
}

/// Writes beside the target and renames, so that the target is either the old file or the whole new one.
///
/// # Errors
/// When the file cannot be written: the disk is full, say. What was at `path` stays as it was.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let outcome = fill(&part, bytes).and_then(|()| fs::rename(&part, path));
    outcome.map_err(|cause| {
        // What remains of a failed write is of no use, and the failure itself is what the user must hear of.
        fs::remove_file(&part).ok();
        FileError::Write { file: path.into(), cause }
    })
}

fn fill(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

impl Avatar {
    /// Reads an avatar file. Every rule in [`format`] is checked before memory is taken for the avatar.
    ///
    /// # Errors
    /// When the file cannot be opened, is not an avatar, or breaks a rule.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// The same from the file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are not an avatar or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Fault> {
        container::decode::<AvatarHeader>(bytes)
    }

    /// How many bytes of an avatar's file [`Avatar::neutral`] needs, as far as its first ones tell: those of the header, once that is there
    /// those of what is drawn.
    ///
    /// # Errors
    /// When the bytes are not the beginning of a file.
    pub fn neutral_needs(bytes: &[u8]) -> Result<usize, Fault> {
        order::needs(bytes)
    }

    /// The avatar without its correctives, from the beginning of a file that is `length` bytes long: it moves with its joints alone. Its
    /// arrays have the lengths of the whole avatar's.
    ///
    /// # Errors
    /// When the bytes are not the beginning of an avatar's file, or break a rule.
    pub fn neutral(bytes: &[u8], length: usize) -> Result<Neutral, Fault> {
        order::neutral(bytes, length)
    }

    /// Writes an avatar file; on failure what was at `path` stays as it was.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`format`], or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write(self.to_bytes(), path)
    }

    /// The bytes that [`Avatar::write`] writes.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`format`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, Fault> {
        encode::encode(self, AvatarHeader::of(self), false)
    }

    /// A file as small as holds the same avatar: codes where they lose nothing, and what is worth it deflated. What is rounded first so
    /// that more can be codes is in [`super::pack`].
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`format`].
    pub fn to_packed_bytes(&self) -> Result<Vec<u8>, Fault> {
        encode::encode(self, AvatarHeader::packed(self), true)
    }

    /// Writes such a file; on failure what was at `path` stays as it was.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`format`], or the file cannot be written.
    pub fn write_packed(&self, path: &Path) -> Result<(), FileError> {
        write(self.to_packed_bytes(), path)
    }

    /// The tensors that its plain file holds.
    pub fn tensors(&self) -> Vec<TensorInfo> {
        container::list_plain::<AvatarHeader>(self)
    }
}

impl Clip {
    /// Reads a motion file. Every rule in [`format`] is checked before memory is taken for the clip.
    ///
    /// # Errors
    /// When the file cannot be opened, is not a motion, or breaks a rule.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// The same from the file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are not a motion or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Fault> {
        container::decode::<ClipHeader>(bytes)
    }

    /// Writes a motion file; on failure what was at `path` stays as it was.
    ///
    /// # Errors
    /// When the clip breaks a rule of [`format`], or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write(self.to_bytes(), path)
    }

    /// The bytes that [`Clip::write`] writes.
    ///
    /// # Errors
    /// When the clip breaks a rule of [`format`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, Fault> {
        encode::encode(self, ClipHeader::of(self), false)
    }

    /// The tensors that its file holds.
    pub fn tensors(&self) -> Vec<TensorInfo> {
        container::list_plain::<ClipHeader>(self)
    }
}
