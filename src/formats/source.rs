//! A file of another program, out of what it is packed in: gzip, a zip with one file in it that is
//! read, a byte order mark. Every reader of whole files starts here.

use crate::{
    assumption::Assumption,
    splats::{self, Archive, Beside},
    wanted::{Chosen, Wanted},
    zip_file::{self, Member, is_zip},
};
use effigy_core::io::{
    file::{self, FormatError, excerpt},
    text,
};
use flate2::read::GzDecoder;
use std::{
    fmt::Display,
    io::{self, Read},
    path::Path,
};

/// Archives inside archives, at most.
const DEPTH: usize = 4;
/// Bytes that any archive may unpack to.
const SMALL: u64 = 32 << 20;
/// Bytes that tell what a file is: the document of a glTF has to name its extensions within them.
pub const START: usize = 4 << 20;

/// Whether bytes begin as an archive does.
pub fn is_packed(bytes: &[u8]) -> bool {
    is_gzip(bytes) || is_zip(bytes)
}

/// Whether bytes begin as a gzip does, which all are deflated.
fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x1f\x8b\x08")
}

/// A file of another program, whole.
pub struct Source<'a> {
    /// All its bytes.
    pub bytes: &'a [u8],
    /// Its name or path: the stem is what an avatar or a clip is called, and the ending says what
    /// content that tells nothing was meant to be. It is not opened.
    pub name: &'a Path,
    /// Where the files are that it refers to.
    pub beside: &'a mut dyn Beside,
    /// What was chosen of the archives that it was in.
    pub(crate) chosen: Vec<Assumption>,
}

/// What may still be unpacked of a file, all its layers together.
#[derive(Clone, Copy)]
struct Budget {
    wanted: Wanted,
    depth: usize,
    /// Bytes.
    left: u64,
    /// Whether the first [`START`] bytes are enough.
    start: bool,
}

impl<'a> Source<'a> {
    /// A file as it was found. See the fields.
    pub fn new(bytes: &'a [u8], name: &'a Path, beside: &'a mut dyn Beside) -> Self {
        Self {
            bytes,
            name,
            beside,
            chosen: vec![],
        }
    }

    /// What an avatar or a clip of the file is called.
    pub fn stem(&self) -> String {
        let stem = self.name.file_stem().unwrap_or_default();
        stem.to_string_lossy().into_owned()
    }

    /// Hands over what is in the file: itself where it is packed in nothing. At most
    /// `zip_file::MAX_GROWTH` times its size is unpacked, or 32 MB, by all its layers together: what
    /// a reader then unpacks of an archive in an archive counts too.
    ///
    /// # Errors
    /// Those of `then`; or when an archive can't be read, unpacks to more, or has not one file in it
    /// that is read. The error lists what it has.
    pub fn inside<T>(
        self,
        then: impl FnOnce(Source) -> Result<T, FormatError>,
    ) -> Result<T, FormatError> {
        let budget = Budget::of(&self, Wanted::Content, false);
        unpack(self, budget, then)
    }

    /// As [`Self::inside`], of a file with cameras.
    ///
    /// # Errors
    /// Those of [`Self::inside`].
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn cameras<T>(
        self,
        then: impl FnOnce(Source) -> Result<T, FormatError>,
    ) -> Result<T, FormatError> {
        let budget = Budget::of(&self, Wanted::Cameras, false);
        unpack(self, budget, then)
    }

    /// As [`Self::inside`], of which the first [`START`] bytes may be all that is handed over.
    ///
    /// # Errors
    /// Those of [`Self::inside`].
    pub fn start<T>(
        self,
        then: impl FnOnce(Source) -> Result<T, FormatError>,
    ) -> Result<T, FormatError> {
        let budget = Budget::of(&self, Wanted::Content, true);
        unpack(self, budget, then)
    }
}

impl Budget {
    fn of(source: &Source, wanted: Wanted, start: bool) -> Self {
        Self {
            wanted,
            depth: DEPTH,
            left: zip_file::allowance(source.bytes, SMALL),
            start,
        }
    }

    /// Reads what is unpacked. `size`: bytes that it has, or more than it is given; `what`: its name
    /// in errors.
    fn read(
        &mut self,
        mut packed: impl Read,
        size: impl FnOnce(u64) -> io::Result<u64>,
        what: &str,
    ) -> Result<Vec<u8>, FormatError> {
        let left = self.left;
        let fault = |found: &dyn Display| {
            let expected = format!("a whole file of at most {left} bytes");
            FormatError::container(format!("{found} in {what}"), expected)
        };
        let mut bytes = vec![];
        let first = (&mut packed).take(START as u64).read_to_end(&mut bytes);
        first.map_err(|error| fault(&error))?;
        // The directory of a zip is at its end.
        if bytes.len() == START && (is_zip(&bytes) || !self.start) {
            let size = size(left).map_err(|error| fault(&error))?;
            let rest = size.saturating_sub(START as u64);
            if size > left {
                return Err(fault(&format_args!("more than {left} bytes")));
            }
            bytes.reserve_exact(rest as usize);
            let read = packed.take(rest + 1).read_to_end(&mut bytes);
            read.map_err(|error| fault(&error))?;
            if bytes.len() as u64 > size {
                return Err(fault(&format_args!(
                    "more than the {size} bytes that it says"
                )));
            }
        }
        self.left -= (bytes.len() as u64).min(left);
        Ok(bytes)
    }

    /// Refuses what its reader would unpack to more than is left. The reader's own limit follows from
    /// the size of what it is given, which is enough for what was packed in nothing.
    fn check_unpacked_again(&self, bytes: &[u8]) -> Result<(), FormatError> {
        if self.start || self.depth == DEPTH {
            return Ok(());
        }
        let size = unpacked_size(bytes);
        let most = self.left.saturating_add(bytes.len() as u64);
        if size <= most {
            return Ok(());
        }
        Err(FormatError::container(
            format!("{size} bytes in an archive in an archive"),
            format!("at most {most} bytes: unpack the outer archive"),
        ))
    }
}

/// Bytes that the reader of a file unpacks it to, as the file says: no reader takes more. 0: it
/// unpacks nothing, or can't be read.
fn unpacked_size(bytes: &[u8]) -> u64 {
    if is_zip(bytes) {
        return zip_file::unpacked_size(bytes).unwrap_or(0);
    }
    if let Some(size) = splats::unpacked_spz(bytes) {
        return size;
    }
    let tensors = file::tensors_of(bytes).unwrap_or_default();
    tensors.iter().map(|tensor| tensor.bytes as u64).sum()
}

/// Bytes that a gzip unpacks to, as far as they are no more than `most`.
fn gzip_size(bytes: &[u8], most: u64) -> io::Result<u64> {
    let gzip = GzDecoder::new(bytes).take(most.saturating_add(1));
    io::copy(&mut { gzip }, &mut io::sink())
}

fn unpack<T>(
    source: Source,
    mut budget: Budget,
    then: impl FnOnce(Source) -> Result<T, FormatError>,
) -> Result<T, FormatError> {
    let Source {
        bytes,
        name,
        beside,
        mut chosen,
    } = source;
    let text = text::utf8(bytes);
    let bytes = &*text;
    let is_gzip = is_gzip(bytes) && !splats::is_packed_spz(bytes);
    let members = match is_zip(bytes) {
        true => packed_members(bytes, budget.wanted)?,
        false => None,
    };
    if !is_gzip && members.is_none() {
        budget.check_unpacked_again(bytes)?;
        return then(Source {
            bytes,
            name,
            beside,
            chosen,
        });
    }
    budget.depth = budget.depth.checked_sub(1).ok_or_else(|| {
        FormatError::container(
            "archives in archives in archives",
            "a file that is unpacked",
        )
    })?;
    let Some(members) = members else {
        let content = budget.read(
            GzDecoder::new(bytes),
            |most| gzip_size(bytes, most),
            "a gzip",
        )?;
        let named = name.extension().is_some_and(|ending| ending == "gz");
        let name = if named {
            Path::new(name.file_stem().unwrap_or_default())
        } else {
            name
        };
        let source = Source {
            bytes: &content,
            name,
            beside,
            chosen,
        };
        return unpack(source, budget, then);
    };
    let Chosen { member, why } = budget.wanted.of(&members)?;
    chosen.extend(why);
    let mut archive = zip_file::open(bytes).map_err(|error| unreadable(bytes, &error))?;
    let entry = archive.by_index(member.index);
    let entry = entry.map_err(|error| unreadable(bytes, &error))?;
    let size = entry.size();
    let content = budget.read(entry, |_| Ok(size), &format!("`{}`", excerpt(&member.name)))?;
    let named = budget.wanted.called(member, name);
    let folder = member
        .name
        .rsplit_once('/')
        .map_or("", |(folder, _)| folder);
    let source = Source {
        bytes: &content,
        name: Path::new(&named),
        beside: &mut Archive::new(archive, folder, budget.left),
        chosen,
    };
    unpack(source, budget, then)
}

fn unreadable(bytes: &[u8], error: &zip::result::ZipError) -> FormatError {
    zip_file::unreadable(bytes, error, "a whole zip")
}

/// The members of a zip that is only packing; None: some reader takes it whole.
fn packed_members(bytes: &[u8], wanted: Wanted) -> Result<Option<Vec<Member>>, FormatError> {
    let members = zip_file::members(bytes).map_err(|error| unreadable(bytes, &error))?;
    Ok((!wanted.is_whole(&members)).then_some(members))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splats::Nothing;

    #[test]
    fn what_a_reader_unpacks_is_known_beforehand() {
        let spz = include_bytes!("../../tests/data/splats/small-2.spz");
        let npz = include_bytes!("../../tests/data/webavatar/small.npz");
        let mut whole = vec![];
        GzDecoder::new(&spz[..]).read_to_end(&mut whole).unwrap();
        assert_eq!(unpacked_size(spz), whole.len() as u64);
        let arrays = crate::npz::members(npz, SMALL, |_| true).unwrap();
        let arrays: usize = arrays.values().map(Vec::len).sum();
        assert_eq!(unpacked_size(npz), arrays as u64);
        let name = Path::new("a");
        let imported = crate::read::avatar(
            Source::new(npz, name, &mut Nothing),
            &crate::read::OpenOptions::default(),
        );
        let avatar = imported.unwrap().avatar;
        let tensors: usize = avatar.tensors().iter().map(|tensor| tensor.bytes).sum();
        let plain = avatar.to_bytes().unwrap();
        assert_eq!(unpacked_size(&plain), tensors as u64);
        assert_eq!(unpacked_size(b"ply\n"), 0);
    }

    #[test]
    fn layers_share_what_may_be_unpacked() {
        let npz = include_bytes!("../../tests/data/webavatar/small.npz");
        let budget = |depth, left| Budget {
            wanted: Wanted::Content,
            depth,
            left,
            start: false,
        };
        let more = unpacked_size(npz) - npz.len() as u64;
        assert!(budget(DEPTH, 0).check_unpacked_again(npz).is_ok());
        assert!(budget(DEPTH - 1, more).check_unpacked_again(npz).is_ok());
        let refused = budget(DEPTH - 1, more - 1).check_unpacked_again(npz);
        assert!(refused.is_err_and(|error| error.to_string().contains("archive in an archive")));
    }
}
