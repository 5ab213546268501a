//! NumPy's `.npz`: a zip of `.npy` arrays.
//!
//! The arrays are read here and not by the crate `npyz`, which multiplies the sizes of a shape
//! without looking for overflow and believes a header about its own length.

mod array;
mod element;
mod header;
mod write;

pub use array::Array;
pub(crate) use element::{Element, Kind};
pub use write::{NpzWriter, Number};

use crate::{fault::tensor, zip_file};
use effigy_core::io::file::{FormatError, excerpt};
use std::{collections::BTreeMap, io::Read};
use zip::result::ZipError;

/// How many times its own size an archive may unpack to, beside [`MAX_SMALL`]: real arrays of
/// numbers deflate to half at best.
pub const MAX_GROWTH: u64 = 3;
/// Bytes that any archive may unpack to.
pub const MAX_SMALL: u64 = 32 << 20;

/// Whether bytes begin as a zip does.
pub fn is_zip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06")
}

/// Whether a file is an archive with an array of this name.
pub fn lists(bytes: &[u8], name: &str) -> bool {
    let archive = zip_file::open(bytes);
    archive.is_ok_and(|archive| archive.index_for_name(&format!("{name}.npy")).is_some())
}

/// The names of an archive's arrays, in its order.
///
/// # Errors
/// When the bytes are no zip, or hold something else than arrays.
pub fn names(bytes: &[u8]) -> Result<Vec<String>, FormatError> {
    let mut archive = zip_file::open(bytes).map_err(unreadable)?;
    let mut names = Vec::new();
    for index in 0..archive.len() {
        let entry = archive.by_index_raw(index).map_err(unreadable)?;
        names.push(array_name(&entry.name().map_err(unreadable)?)?.to_owned());
    }
    Ok(names)
}

/// The `.npy` files of an archive whose names, without that ending, are wanted. `small`: what any
/// archive may unpack to, bytes.
///
/// # Errors
/// When the bytes are no zip, hold something else than arrays, or unpack to more than the limits.
pub fn members(
    bytes: &[u8],
    small: u64,
    wanted: impl Fn(&str) -> bool,
) -> Result<BTreeMap<String, Vec<u8>>, FormatError> {
    let mut archive = zip_file::open(bytes).map_err(unreadable)?;
    let limit = (MAX_GROWTH * bytes.len() as u64).max(small);
    let mut left = limit;
    let mut members = BTreeMap::new();
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).map_err(unreadable)?;
        let full = entry.name().map_err(unreadable)?.into_owned();
        let name = array_name(&full)?;
        if !wanted(name) {
            continue;
        }
        let too_large = || {
            FormatError::container(
                format!("an archive that unpacks to more than {limit} bytes"),
                format!("at most {MAX_GROWTH} times its size"),
            )
        };
        // A zip may say less than an entry has, but not more than is read here.
        let promised = entry.size();
        if promised > left {
            return Err(too_large());
        }
        let mut content = Vec::with_capacity(promised as usize);
        (&mut entry)
            .take(promised + 1)
            .read_to_end(&mut content)
            .map_err(|error| tensor(name, format!("no data: {error}"), "an array"))?;
        if content.len() as u64 > promised {
            return Err(too_large());
        }
        left -= promised;
        members.insert(name.to_owned(), content);
    }
    Ok(members)
}

fn unreadable(error: ZipError) -> FormatError {
    FormatError::container(format!("a zip that can't be read: {error}"), "a NumPy .npz")
}

fn array_name(full: &str) -> Result<&str, FormatError> {
    full.strip_suffix(".npy").ok_or_else(|| {
        FormatError::container(
            format!("`{}` in the archive", excerpt(full)),
            "names that end in .npy alone",
        )
    })
}

/// The pickle in a `.npy` file that holds Python's objects; None where it holds something else.
pub fn pickle_of(npy: &[u8]) -> Option<&[u8]> {
    let text = header::text(npy).ok()?;
    let objects = text.content.contains("'descr': '|O'");
    objects.then(|| &npy[text.end..])
}

/// The arrays of an archive, unpacked.
#[derive(Clone, Debug, Default)]
pub struct Npz {
    arrays: BTreeMap<String, Array>,
}

impl Npz {
    /// Reads every array of an archive.
    ///
    /// # Errors
    /// When the bytes are no zip, hold something else than arrays of numbers, or unpack to more
    /// than the limits.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FormatError> {
        Self::some_from_bytes(bytes, MAX_SMALL, |_| true)
    }

    /// Reads the arrays of an archive whose names are wanted. The others may hold anything.
    /// `small`: what any archive may unpack to, bytes.
    ///
    /// # Errors
    /// Those of [`Self::from_bytes`].
    pub fn some_from_bytes(
        bytes: &[u8],
        small: u64,
        wanted: impl Fn(&str) -> bool,
    ) -> Result<Self, FormatError> {
        let mut arrays = BTreeMap::new();
        for (name, content) in members(bytes, small, wanted)? {
            arrays.insert(name.clone(), Array::from_npy(&name, content)?);
        }
        Ok(Self { arrays })
    }

    /// The names of the arrays, in alphabetical order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.arrays.keys().map(String::as_str)
    }

    /// Whether there is an array of a name.
    pub fn has(&self, name: &str) -> bool {
        self.arrays.contains_key(name)
    }

    /// Takes an array out.
    ///
    /// # Errors
    /// When there is none of that name. The error lists those that there are.
    pub fn take(&mut self, name: &str) -> Result<Array, FormatError> {
        self.arrays.remove(name).ok_or_else(|| {
            let names: Vec<&str> = self.names().collect();
            tensor(
                name,
                "nothing",
                format!("the array; the file has also {}", names.join(", ")),
            )
        })
    }
}
