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

use crate::{
    fault::tensor,
    zip_file::{self, Member},
};
use effigy_core::io::file::FormatError;
use std::{collections::BTreeMap, io::Read};
use zip::result::ZipError;

/// Bytes that any archive may unpack to.
pub const MAX_SMALL: u64 = 32 << 20;

/// The arrays of an archive: its members with the ending `.npy`, as NumPy takes them. Others may be
/// beside them.
fn arrays(bytes: &[u8]) -> Result<Vec<Member>, FormatError> {
    let members = zip_file::members(bytes).map_err(|error| unreadable(bytes, &error))?;
    let array = |member: Member| {
        let name = member.name.strip_suffix(".npy")?.to_owned();
        Some(Member { name, ..member })
    };
    Ok(members.into_iter().filter_map(array).collect())
}

/// The names of an archive's arrays, in its order.
///
/// # Errors
/// When the bytes are no zip.
pub fn names(bytes: &[u8]) -> Result<Vec<String>, FormatError> {
    let arrays = arrays(bytes)?.into_iter();
    Ok(arrays.map(|member| member.name).collect())
}

/// The `.npy` files of an archive whose names, without that ending, are wanted. `small`: what any
/// archive may unpack to, bytes.
///
/// # Errors
/// When the bytes are no zip, or unpack to more than the limits.
pub fn members(
    bytes: &[u8],
    small: u64,
    wanted: impl Fn(&str) -> bool,
) -> Result<BTreeMap<String, Vec<u8>>, FormatError> {
    let fault = |error: ZipError| unreadable(bytes, &error);
    let mut archive = zip_file::open(bytes).map_err(fault)?;
    let limit = zip_file::allowance(bytes, small);
    let mut left = limit;
    let mut members = BTreeMap::new();
    for Member { index, name } in arrays(bytes)? {
        if !wanted(&name) {
            continue;
        }
        let too_large = || {
            FormatError::container(
                format!("an archive that unpacks to more than {limit} bytes"),
                format!("at most {} times its size", zip_file::MAX_GROWTH),
            )
        };
        let mut entry = archive.by_index(index).map_err(fault)?;
        // A zip may say less than an entry has, but not more than is read here.
        let promised = entry.size();
        if promised > left {
            return Err(too_large());
        }
        let mut content = Vec::with_capacity(promised as usize);
        (&mut entry)
            .take(promised + 1)
            .read_to_end(&mut content)
            .map_err(|error| tensor(&name, format!("no data: {error}"), "an array"))?;
        if content.len() as u64 > promised {
            return Err(too_large());
        }
        left -= promised;
        members.insert(name, content);
    }
    Ok(members)
}

fn unreadable(bytes: &[u8], error: &ZipError) -> FormatError {
    zip_file::unreadable(bytes, error, "a NumPy .npz or a file of PyTorch")
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
    /// When the bytes are no zip, hold arrays of something else than numbers, or unpack to more than
    /// the limits.
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

    /// Bytes of all arrays.
    pub fn bytes(&self) -> usize {
        self.arrays.values().map(Array::bytes).sum()
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
