//! Files of `torch.save`: a zip of a pickle and of the memory that its tensors show, or pickles in
//! a row.

use super::{machine::Machine, node::Built};
use crate::zip_file;
use effigy_core::io::file::{FormatError, excerpt};
use std::{borrow::Cow, collections::BTreeMap};
use zip::{CompressionMethod, result::ZipError};

/// The start of what PyTorch wrote before 1.6: protocol 2, then the integer 0x1950a86a20f9469cfc6c.
const LEGACY: &[u8] = b"\x80\x02\x8a\x0al\xfc\x9cF\xf9 j\xa8P\x19.";

/// Whether bytes are a file that PyTorch wrote before its zips.
pub fn is_legacy(bytes: &[u8]) -> bool {
    bytes.starts_with(LEGACY)
}

/// The pickle of a zip of PyTorch's; None where there is none.
pub fn pickle_of(bytes: &[u8]) -> Option<&[u8]> {
    let mut archive = zip_file::open(bytes).ok()?;
    let is_pickle = |name: &Cow<str>| {
        name.split_once('/')
            .is_some_and(|(_, name)| name == "data.pkl")
    };
    let name = archive.file_names().flatten().find(is_pickle)?.into_owned();
    let index = archive.index_for_name(&name)?;
    let entry = archive.by_index_raw(index).ok()?;
    let start = usize::try_from(entry.data_start()?).ok()?;
    let size = usize::try_from(entry.size()).ok()?;
    bytes.get(start..)?.get(..size)
}

/// Reads a zip of PyTorch's. Entries are stored, so that memory stays in the file.
pub fn from_zip(bytes: &[u8]) -> Result<Built<'_>, FormatError> {
    const EXPECTED: &str = "a NumPy .npz or a file of PyTorch";
    let fault = |error: ZipError| zip_file::unreadable(bytes, &error, EXPECTED);
    let mut archive = zip_file::open(bytes).map_err(fault)?;
    let mut stored: BTreeMap<String, &[u8]> = BTreeMap::new();
    let mut pickle = None;
    for index in 0..archive.len() {
        let entry = archive.by_index_raw(index).map_err(fault)?;
        let name = entry.name().map_err(fault)?.into_owned();
        // What stands before is the name of the file as it was saved.
        let Some((_, name)) = name.split_once('/') else {
            continue;
        };
        let start = usize::try_from(entry.data_start().unwrap_or(u64::MAX)).unwrap_or(usize::MAX);
        let size = usize::try_from(entry.size()).unwrap_or(usize::MAX);
        let content = bytes.get(start..).and_then(|rest| rest.get(..size));
        let is_stored = entry.compression() == CompressionMethod::Stored;
        let content = content.filter(|_| is_stored).ok_or_else(|| {
            FormatError::container(
                format!("`{}`, which is not stored whole", excerpt(name)),
                "entries without compression, as PyTorch writes them",
            )
        })?;
        if name == "data.pkl" {
            pickle = Some(content);
        } else if let Some(key) = name.strip_prefix("data/") {
            stored.insert(key.to_owned(), content);
        }
    }
    let pickle =
        pickle.ok_or_else(|| FormatError::container("a zip without data.pkl", EXPECTED))?;
    let mut machine = Machine::new(bytes.len(), stored);
    let root = machine.run(pickle, 0, 0)?.root;
    Ok(Built {
        nodes: machine.nodes,
        root,
    })
}
