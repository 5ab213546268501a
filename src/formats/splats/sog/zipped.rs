//! SOGs in zips, at the root or in a folder.

use super::{LOD_META, META};
use crate::{
    splats::beside::Archive,
    zip_file::{self, Member, ZipFile},
};
use effigy_core::io::file::FormatError;

/// Bytes that any archive may unpack to, and how many times its size: images do not deflate.
const SMALL: u64 = 1 << 20;
const GROWTH: u64 = 2;

/// Whether a zip of these members is a SOG: it has one document of that name, or of a streamed SOG.
pub fn is_sog(members: &[Member]) -> bool {
    let has = |document: &&str| folder_of(members, document).is_some();
    [LOD_META, META].iter().any(has)
}

/// The folder in which the only document of a name is, with its last slash.
fn folder_of(members: &[Member], document: &str) -> Option<String> {
    let folder = |name: &str| {
        let folder = name.strip_suffix(document)?;
        let is_folder = folder.is_empty() || folder.ends_with('/');
        is_folder.then(|| folder.to_owned())
    };
    let mut folders = members.iter().filter_map(|member| folder(&member.name));
    folders.next().filter(|_| folders.next().is_none())
}

/// A zip that may be a SOG.
pub struct Zipped<'a> {
    members: Vec<Member>,
    zip: ZipFile<'a>,
    left: u64,
}

impl<'a> Zipped<'a> {
    /// Opens it.
    ///
    /// # Errors
    /// When the bytes are no zip.
    pub fn new(bytes: &'a [u8]) -> Result<Self, FormatError> {
        let unreadable = |error| zip_file::unreadable(bytes, &error, "a .sog");
        Ok(Self {
            members: zip_file::members(bytes).map_err(unreadable)?,
            zip: zip_file::open(bytes).map_err(unreadable)?,
            left: SMALL.max(GROWTH * bytes.len() as u64),
        })
    }

    /// See [`folder_of`].
    pub fn folder_of(&self, document: &str) -> Option<String> {
        folder_of(&self.members, document)
    }

    /// The files of a folder.
    pub fn files(self, folder: &str) -> Archive<'a> {
        Archive::new(self.zip, folder, self.left)
    }
}
