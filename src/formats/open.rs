//! Opening of avatars and clips of any kind, told apart by content.

use crate::{
    npz,
    splats::{self, Folder, Found, SplatFormat},
    webavatar::{self, Imported},
};
use effigy_core::{
    avatar::{Avatar, Clip, Skeleton},
    io::{
        file::{FileError, read_with},
        splats::Up,
    },
};
use std::{
    fs::File,
    io::Read,
    path::{Path, PathBuf},
};

/// What files leave open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OpenOptions {
    /// The axis of a splat file that points up; None: as the file or its format says.
    pub up: Option<Up>,
    /// Of the paper's model.
    pub webavatar: webavatar::Options,
}

/// What a file is by its content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Content {
    Splats(SplatFormat),
    Npz,
    Json,
    /// Effigy's own, or nothing that is known.
    Other,
}

impl Content {
    fn of(path: &Path) -> Self {
        // A file that can't be read gives its error when it is opened.
        let known = Start::read(path).ok().and_then(|start| start.content());
        let named = || SplatFormat::of_name(path).map(Self::Splats);
        known.or_else(named).unwrap_or(Self::Other)
    }
}

/// The first bytes of a file.
struct Start {
    file: File,
    bytes: Vec<u8>,
    /// Of the whole file.
    length: u64,
}

impl Start {
    fn read(path: &Path) -> std::io::Result<Self> {
        let file = File::open(path)?;
        let length = file.metadata()?.len();
        let mut bytes = Vec::new();
        (&file)
            .take(SplatFormat::START as u64)
            .read_to_end(&mut bytes)?;
        Ok(Self {
            file,
            bytes,
            length,
        })
    }

    fn content(self) -> Option<Content> {
        if npz::is_zip(&self.bytes) {
            let is_sog = splats::is_sog(self.file);
            return Some(if is_sog {
                Content::Splats(SplatFormat::Sog)
            } else {
                Content::Npz
            });
        }
        let first = self.bytes.iter().find(|byte| !byte.is_ascii_whitespace());
        if first == Some(&b'[') {
            return Some(Content::Json);
        }
        SplatFormat::of(&self.bytes, self.length).map(Content::Splats)
    }
}

/// Whether a file is the paper's model.
pub fn is_foreign(path: &Path) -> bool {
    Content::of(path) == Content::Npz
}

/// Whether a file consists of splats: by its content, or by its name where that tells nothing.
pub fn is_splats(path: &Path) -> bool {
    matches!(Content::of(path), Content::Splats(_))
}

/// Reads the splats of a file. `up`: the axis that points up; None: as the file or its format says.
///
/// # Errors
/// When the file cannot be opened, has no splats, or breaks a rule.
pub fn splats(path: &Path, up: Option<Up>) -> Result<Found, FileError> {
    // What is of no known format is refused as the most common one.
    let format = match Content::of(path) {
        Content::Splats(format) => format,
        _ => SplatFormat::Ply,
    };
    let mut found = read_with(path, |bytes| {
        splats::read(bytes, format, &mut Folder::of(path))
    })?;
    found.splats.up = up.unwrap_or(found.splats.up);
    Ok(found)
}

/// Reads an avatar: Effigy's own, the paper's `.npz` or splats.
///
/// # Errors
/// When the file cannot be opened, is none of them, or breaks a rule.
pub fn avatar(path: &Path, options: &OpenOptions) -> Result<Imported, FileError> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    match Content::of(path) {
        Content::Splats(_) => {
            let Found {
                splats,
                assumptions,
            } = splats(path, options.up)?;
            let avatar = splats
                .to_avatar(&name)
                .map_err(|fault| FileError::Content {
                    file: path.into(),
                    fault,
                })?;
            Ok(Imported {
                avatar,
                assumptions,
            })
        }
        Content::Npz => read_with(path, |bytes| {
            webavatar::from_bytes(bytes, &name, &options.webavatar)
        }),
        Content::Json | Content::Other => Ok(Imported {
            avatar: Avatar::read(path)?,
            assumptions: vec![],
        }),
    }
}

/// Reads a clip for an avatar: Effigy's own, or the poses beside the paper's model. `rate`: frames
/// a second of a file that does not say.
///
/// # Errors
/// When the file cannot be opened, is neither, or breaks a rule.
pub fn clip(path: &Path, skeleton: &Skeleton, rate: f64) -> Result<Clip, FileError> {
    if Content::of(path) != Content::Json {
        return Clip::read(path);
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    read_with(path, |bytes| {
        webavatar::read_poses(bytes, &name, skeleton, rate)
    })
}

/// The poses that belong to `NAME.npz`: `NAME_poses.json` beside it, where there is one.
pub fn poses_beside(path: &Path) -> Option<PathBuf> {
    let mut name = path.file_stem()?.to_owned();
    name.push("_poses.json");
    let poses = path.with_file_name(name);
    poses.is_file().then_some(poses)
}
