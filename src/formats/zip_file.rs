//! Opening of zips whose directory is worth reading.

use std::io::Cursor;
use zip::{
    ZipArchive,
    result::{ZipError, ZipResult},
};

/// Members of an archive: a checkpoint has some hundred. Each costs time and memory before anything
/// of it is read.
const MAX_MEMBERS: usize = 10_000;
/// The mark of the record at an archive's end.
const END: &[u8] = b"PK\x05\x06";
/// Where that record has the number of all members, 16 bits.
const COUNT: usize = 10;
/// The record with the longest comment.
const LONGEST_END: usize = 22 + 0xffff;

/// A zip in memory.
pub type ZipFile<'a> = ZipArchive<Cursor<&'a [u8]>>;

/// Opens a zip.
///
/// # Errors
/// When the bytes are none, or it has too many members.
pub fn open(bytes: &[u8]) -> ZipResult<ZipFile<'_>> {
    let end = &bytes[bytes.len().saturating_sub(LONGEST_END)..];
    let record = end.windows(END.len()).rposition(|four| four == END);
    let count = record.and_then(|at| end.get(at + COUNT..at + COUNT + 2));
    // More than 16 bits hold are told elsewhere, and are too many.
    if count
        .is_some_and(|count| usize::from(u16::from_le_bytes([count[0], count[1]])) > MAX_MEMBERS)
    {
        return Err(ZipError::InvalidArchive(
            format!("more than {MAX_MEMBERS} members").into(),
        ));
    }
    let archive = ZipArchive::new(Cursor::new(bytes))?;
    if archive.len() > MAX_MEMBERS {
        return Err(ZipError::InvalidArchive(
            format!("more than {MAX_MEMBERS} members").into(),
        ));
    }
    Ok(archive)
}
