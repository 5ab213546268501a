//! Reading and writing avatars and clips.

use super::{
    container,
    disk::{read_with, write_encoded},
    document::Document,
    encode,
    error::{FileError, FormatError},
    header::{AvatarHeader, ClipHeader},
    order::{self, Neutral},
    tensors::TensorInfo,
};
use crate::avatar::{Avatar, Clip};
use std::path::Path;

/// The content of a file of either kind.
#[derive(Clone, Debug, PartialEq)]
pub enum FileContent {
    /// An avatar.
    Avatar(Box<Avatar>),
    /// A clip of motion.
    Clip(Box<Clip>),
}

impl FileContent {
    /// Reads a file of either kind, told apart by its content.
    ///
    /// # Errors
    /// When the file cannot be opened, is neither, or breaks a rule of [`super::format`].
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// Reads the content from a file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are neither, or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FormatError> {
        if container::has_format::<ClipHeader>(bytes)? {
            Ok(Self::Clip(Box::new(container::decode::<ClipHeader>(
                bytes,
            )?)))
        } else {
            let avatar = container::decode::<AvatarHeader>(bytes)?;
            Ok(Self::Avatar(Box::new(avatar)))
        }
    }
}

/// Lists the tensors of a file of either kind.
///
/// # Errors
/// When the file cannot be opened, is neither, or breaks a rule.
pub fn tensors(path: &Path) -> Result<Vec<TensorInfo>, FileError> {
    read_with(path, tensors_of)
}

/// The tensors in a file's bytes, at any alignment.
///
/// # Errors
/// When the bytes are neither, or break a rule.
pub fn tensors_of(bytes: &[u8]) -> Result<Vec<TensorInfo>, FormatError> {
    if container::has_format::<ClipHeader>(bytes)? {
        container::list::<ClipHeader>(bytes)
    } else {
        container::list::<AvatarHeader>(bytes)
    }
}

impl Avatar {
    /// Reads an avatar file. Every rule in [`super::format`] is checked before memory is taken for
    /// the avatar.
    ///
    /// # Errors
    /// When the file cannot be opened, is not an avatar, or breaks a rule.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// Reads an avatar from a file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are not an avatar or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FormatError> {
        container::decode::<AvatarHeader>(bytes)
    }

    /// How many bytes [`Avatar::neutral`] needs from the start of an avatar's file, as far as its
    /// first bytes tell: those of the header, and once the header is there those of the neutral
    /// avatar.
    ///
    /// # Errors
    /// When the bytes are not the beginning of a file.
    pub fn neutral_needs(bytes: &[u8]) -> Result<usize, FormatError> {
        order::needs(bytes)
    }

    /// The avatar without its correctives, from the beginning of a file that is `length` bytes
    /// long: it moves with its joints alone. Its arrays have the lengths of the whole avatar's.
    ///
    /// # Errors
    /// When the bytes are not the beginning of an avatar's file, or break a rule.
    pub fn neutral(bytes: &[u8], length: usize) -> Result<Neutral, FormatError> {
        order::neutral(bytes, length)
    }

    /// Writes an avatar file; on failure a file that was at `path` is unchanged.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`], or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write_encoded(path, self.to_bytes())
    }

    /// The bytes that [`Avatar::write`] writes.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, FormatError> {
        encode::encode(self, AvatarHeader::from_model(self), false)
    }

    /// The smallest file that holds this avatar without loss: codes where they are exact, and
    /// deflated tensors where that is shorter. [`crate::io::pack`] rounds an avatar so that more of
    /// it can be codes.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`].
    pub fn to_packed_bytes(&self) -> Result<Vec<u8>, FormatError> {
        encode::encode(self, AvatarHeader::packed(self), true)
    }

    /// Writes the file of [`Avatar::to_packed_bytes`]; on failure a file that was at `path` is
    /// unchanged.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`], or the file cannot be written.
    pub fn write_packed(&self, path: &Path) -> Result<(), FileError> {
        write_encoded(path, self.to_packed_bytes())
    }

    /// Lists the tensors of the file that [`Avatar::write`] writes.
    pub fn tensors(&self) -> Vec<TensorInfo> {
        container::list_plain::<AvatarHeader>(self)
    }
}

impl Clip {
    /// Reads a motion file. Every rule in [`super::format`] is checked before memory is taken for
    /// the clip.
    ///
    /// # Errors
    /// When the file cannot be opened, is not a motion, or breaks a rule.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// Reads a clip from a file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are not a motion or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FormatError> {
        container::decode::<ClipHeader>(bytes)
    }

    /// Writes a motion file; on failure a file that was at `path` is unchanged.
    ///
    /// # Errors
    /// When the clip breaks a rule of [`super::format`], or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write_encoded(path, self.to_bytes())
    }

    /// The bytes that [`Clip::write`] writes.
    ///
    /// # Errors
    /// When the clip breaks a rule of [`super::format`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, FormatError> {
        encode::encode(self, ClipHeader::from_model(self), false)
    }

    /// Lists the tensors of the file that [`Clip::write`] writes.
    pub fn tensors(&self) -> Vec<TensorInfo> {
        container::list_plain::<ClipHeader>(self)
    }
}
