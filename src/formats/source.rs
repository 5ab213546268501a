//! A file of another program, out of what it is packed in: gzip, a zip with one file in it that is
//! read, a byte order mark. Every reader of whole files starts here.

use crate::{
    splats::{self, Archive, Beside},
    zip_file::{self, Member, is_zip},
};
use effigy_core::io::{
    file::{FormatError, excerpt},
    text,
};
use flate2::read::GzDecoder;
use std::{
    ffi::OsStr,
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
/// Files that a sentence names, at most.
const NAMED: usize = 6;
/// Endings of files that are read.
const READ: [&str; 20] = [
    "ply", "splat", "spz", "sog", "ksplat", "glb", "gltf", "vrm", "vrma", "bvh", "fbx", "npz",
    "npy", "pkl", "pt", "pth", "avatar", "motion", "gz", "zip",
];

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
}

/// What may still be unpacked of a file.
#[derive(Clone, Copy)]
struct Budget {
    depth: usize,
    /// Bytes.
    left: u64,
    /// Whether the first [`START`] bytes are enough.
    start: bool,
}

impl Source<'_> {
    /// What an avatar or a clip of the file is called.
    pub fn stem(&self) -> String {
        let stem = self.name.file_stem().unwrap_or_default();
        stem.to_string_lossy().into_owned()
    }

    /// Hands over what is in the file: itself where it is packed in nothing. At most
    /// [`zip_file::MAX_GROWTH`] times its size is unpacked, or 32 MB.
    ///
    /// # Errors
    /// Those of `then`; or when an archive can't be read, unpacks to more, or has not one file in it
    /// that is read. The error lists what it has.
    pub fn inside<T>(
        self,
        then: impl FnOnce(Source) -> Result<T, FormatError>,
    ) -> Result<T, FormatError> {
        let budget = Budget::of(&self, false);
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
        let budget = Budget::of(&self, true);
        unpack(self, budget, then)
    }
}

impl Budget {
    fn of(source: &Source, start: bool) -> Self {
        Self {
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
    } = source;
    let text = text::utf8(bytes);
    let bytes = &*text;
    let is_gzip = is_gzip(bytes) && !splats::is_packed_spz(bytes);
    let members = match is_zip(bytes) {
        true => packed_members(bytes)?,
        false => None,
    };
    if !is_gzip && members.is_none() {
        return then(Source {
            bytes,
            name,
            beside,
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
        };
        return unpack(source, budget, then);
    };
    let member = only(&members)?;
    let mut archive = zip_file::open(bytes).map_err(|error| unreadable(bytes, &error))?;
    let entry = archive.by_index(member.index);
    let entry = entry.map_err(|error| unreadable(bytes, &error))?;
    let size = entry.size();
    let content = budget.read(entry, |_| Ok(size), &format!("`{}`", excerpt(&member.name)))?;
    // It is called as its archive is.
    let mut named = name.file_stem().unwrap_or_default().to_owned();
    named.push(".");
    named.push(ending(&member.name).unwrap_or_default());
    let folder = member
        .name
        .rsplit_once('/')
        .map_or("", |(folder, _)| folder);
    let source = Source {
        bytes: &content,
        name: Path::new(&named),
        beside: &mut Archive::new(archive, folder, budget.left),
    };
    unpack(source, budget, then)
}

fn unreadable(bytes: &[u8], error: &zip::result::ZipError) -> FormatError {
    zip_file::unreadable(bytes, error, "a whole zip")
}

/// The members of a zip that is only packing; None: some reader takes it whole.
fn packed_members(bytes: &[u8]) -> Result<Option<Vec<Member>>, FormatError> {
    let members = zip_file::members(bytes).map_err(|error| unreadable(bytes, &error))?;
    let is_read = |member: &Member| {
        member.name.ends_with(".npy")
            || member
                .name
                .split_once('/')
                .is_some_and(|(_, name)| name == "data.pkl")
    };
    let is_known = splats::is_sog(&members) || members.iter().any(is_read);
    Ok((!is_known).then_some(members))
}

/// The ending of a name, in small letters.
fn ending(name: &str) -> Option<String> {
    let ending = Path::new(name).extension().and_then(OsStr::to_str)?;
    Some(ending.to_ascii_lowercase())
}

/// The only file of an archive that is read.
fn only(members: &[Member]) -> Result<&Member, FormatError> {
    let ends = |member: &&Member, of: &[&str]| {
        ending(&member.name).is_some_and(|ending| of.contains(&&*ending))
    };
    let mut read = members.iter().filter(|member| ends(member, &READ));
    if let (Some(member), None) = (read.next(), read.next()) {
        return Ok(member);
    }
    let of_usd = members
        .iter()
        .any(|member| ends(&member, &["usd", "usda", "usdc"]));
    let expected = if of_usd {
        "another format than USD: convert it to .ply or glTF"
    } else if members.iter().any(|member| ends(&member, &READ)) {
        "one file that is read: unpack the zip and open one of them"
    } else {
        "a file in it that is read: splats, motion or an avatar"
    };
    // Those that could be meant first.
    let mut named: Vec<&Member> = members.iter().collect();
    named.sort_by_key(|member| !ends(member, &READ));
    let mut names: Vec<String> = named
        .iter()
        .take(NAMED)
        .map(|member| format!("`{}`", excerpt(&member.name)))
        .collect();
    if named.len() > NAMED {
        names.push(format!("{} more", named.len() - NAMED));
    }
    let names = if names.is_empty() {
        "nothing".into()
    } else {
        names.join(", ")
    };
    Err(FormatError::container(
        format!("a zip of {names}"),
        expected,
    ))
}
