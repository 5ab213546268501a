//! Opening of avatars and clips of any kind by their paths, told apart by content.

pub use crate::read::{CaptureOptions, ClipOptions, OpenOptions, OpenedClip};

use crate::{
    capture::Captured,
    content::Content,
    mmlphuman::{self, Checkpoint},
    pickle::Pickle,
    read::{self, Source},
    retarget::Girth,
    splats::{Folder, Found},
    webavatar::ForeignAvatar,
};
use effigy_core::{
    avatar::{Avatar, Clip, Skeleton},
    io::{
        file::{FileError, FormatError, read_with},
        splats::Up,
    },
};
use std::path::{Path, PathBuf};

/// What a file is. One that can't be read gives its error when it is opened.
pub fn content(path: &Path) -> Content {
    let content = read_with(path, |bytes| Ok(Content::of(bytes, path)));
    content.unwrap_or_else(|_| Content::of(&[], path))
}

/// Maps a file, and reads it with the files of its folder beside it.
fn read_file<T>(
    path: &Path,
    read: impl FnOnce(Source) -> Result<T, FormatError>,
) -> Result<T, FileError> {
    read_with(path, |bytes| {
        read(Source::new(bytes, path, &mut Folder::of(path)))
    })
}

/// Whether a file is the paper's model.
pub fn is_foreign(path: &Path) -> bool {
    content(path) == Content::Model
}

/// Whether a file is a training checkpoint of mmlphuman.
pub fn is_checkpoint(path: &Path) -> bool {
    content(path) == Content::Checkpoint
}

/// Reads a training checkpoint of mmlphuman and hands it over. Its networks stay in the file, which
/// is mapped that long.
///
/// # Errors
/// When the file cannot be opened, is none, or breaks a rule.
pub fn checkpoint<T>(
    path: &Path,
    options: &mmlphuman::Options,
    then: impl FnOnce(Checkpoint) -> T,
) -> Result<T, FileError> {
    read_file(path, |source| {
        source.inside(|source| {
            let pickle = Pickle::from_bytes(source.bytes)?;
            Ok(then(Checkpoint::new(&pickle, options)?))
        })
    })
}

/// Whether a file consists of splats: by its content, or by its name where that tells nothing.
pub fn is_splats(path: &Path) -> bool {
    matches!(content(path), Content::Splats(_))
}

/// The error of a file that is no avatar or motion of Effigy's: what it seems to be, where that is
/// known.
pub fn unknown(path: &Path, error: FileError) -> FileError {
    let FileError::Content { file, fault } = error else {
        return error;
    };
    let found: Result<FormatError, FileError> =
        read_with(path, |bytes| Ok(read::unknown(bytes, fault.clone())));
    FileError::Content {
        file,
        fault: found.unwrap_or(fault),
    }
}

/// Whether a file is motion: Effigy's own, or of another program.
pub fn is_motion(path: &Path) -> bool {
    match content(path) {
        Content::Other => Clip::read(path).is_ok(),
        content => content.is_motion(),
    }
}

/// Whether a file is motion of another program, of a body that the avatar need not have.
pub fn is_capture(path: &Path) -> bool {
    content(path).is_motion()
}

/// Reads the splats of a file. `up`: the axis that points up; None: as the file or its format says.
///
/// # Errors
/// When the file cannot be opened, has no splats, or breaks a rule.
pub fn splats(path: &Path, up: Option<Up>) -> Result<Found, FileError> {
    read_file(path, |source| read::splats(source, up))
}

/// Reads an avatar: Effigy's own, the paper's `.npz` or splats.
///
/// # Errors
/// When the file cannot be opened, is none of them, or breaks a rule.
pub fn avatar(path: &Path, options: &OpenOptions) -> Result<ForeignAvatar, FileError> {
    read_file(path, |source| read::avatar(source, options))
}

/// Reads motion of another program, as [`read::capture`] does.
///
/// # Errors
/// When the file cannot be opened, is of no known kind, or breaks a rule.
pub fn capture(path: &Path, options: &CaptureOptions) -> Result<Captured, FileError> {
    read_file(path, |source| read::capture(source, options))
}

/// Reads a clip for an avatar, as [`read::clip`] does.
///
/// # Errors
/// When the file cannot be opened, is none of them, or breaks a rule.
pub fn clip(path: &Path, avatar: &Avatar, options: &ClipOptions) -> Result<OpenedClip, FileError> {
    let girth = || Girth::of(avatar);
    read_file(path, |source| {
        read::clip(source, &avatar.skeleton, girth, options)
    })
}

/// Reads a clip for a skeleton alone: motion of another body may push arms into the trunk.
///
/// # Errors
/// Those of [`clip`].
pub fn clip_of(
    path: &Path,
    skeleton: &Skeleton,
    options: &ClipOptions,
) -> Result<OpenedClip, FileError> {
    read_file(path, |source| {
        read::clip(source, skeleton, || None, options)
    })
}

/// The poses that belong to `NAME.npz`: `NAME_poses.json` beside it, where there is one.
pub fn poses_beside(path: &Path) -> Option<PathBuf> {
    let mut name = path.file_stem()?.to_owned();
    name.push("_poses.json");
    let poses = path.with_file_name(name);
    poses.is_file().then_some(poses)
}
