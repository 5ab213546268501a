//! Zips whose directory is worth reading, and how much an archive may unpack to.

use effigy_core::io::file::FormatError;
use std::{io::Cursor, ops::Range};
use zip::{
    ZipArchive,
    result::{ZipError, ZipResult},
};

/// Members of an archive: a checkpoint has some hundred. Each costs time and memory before anything
/// of it is read.
const MAX_MEMBERS: u64 = 10_000;
/// How many times its own size an archive may unpack to, as an `.avatar` may: f64 that were f32 and
/// hands at rest deflate to a fourth.
pub const MAX_GROWTH: u64 = 16;
/// The record with the longest comment, with what comes before it in large archives.
const LONGEST_END: usize = 22 + 0xffff + 128;

/// A record at an archive's end that has the number of all members.
struct EndRecord {
    mark: &'static [u8],
    /// Where the number is, and how many bytes it has.
    count: Range<usize>,
}

const RECORDS: [EndRecord; 2] = [
    EndRecord {
        mark: b"PK\x05\x06",
        count: 10..12,
    },
    // Of zip64.
    EndRecord {
        mark: b"PK\x06\x06",
        count: 32..40,
    },
];

/// A zip in memory.
pub type ZipFile<'a> = ZipArchive<Cursor<&'a [u8]>>;

/// A file of an archive.
#[derive(Clone, Debug)]
pub struct Member {
    pub index: usize,
    /// With the folders that it is in.
    pub name: String,
}

/// Whether bytes begin as a zip does.
pub fn is_zip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06")
}

/// Bytes that an archive may unpack to. `small`: what any may.
pub fn allowance(bytes: &[u8], small: u64) -> u64 {
    MAX_GROWTH.saturating_mul(bytes.len() as u64).max(small)
}

/// The files of an archive in its order, without folders and what systems leave beside files.
///
/// # Errors
/// When the bytes are no zip, or it has too many members.
pub fn members(bytes: &[u8]) -> ZipResult<Vec<Member>> {
    let mut archive = open(bytes)?;
    let mut members = vec![];
    for index in 0..archive.len() {
        let name = archive.by_index_raw(index)?.name()?.into_owned();
        let own = name.rsplit('/').next().unwrap_or_default();
        let is_litter = own.is_empty()
            || own.starts_with('.')
            || name.starts_with("__MACOSX/")
            || ["Thumbs.db", "desktop.ini"].contains(&own);
        if !is_litter {
            members.push(Member { index, name });
        }
    }
    Ok(members)
}

/// Bytes of an archive's files together, unpacked, as its directory says.
///
/// # Errors
/// When the bytes are no zip, or it has too many members.
pub fn unpacked_size(bytes: &[u8]) -> ZipResult<u64> {
    let mut archive = open(bytes)?;
    (0..archive.len()).try_fold(0u64, |sum, index| {
        Ok(sum.saturating_add(archive.by_index_raw(index)?.size()))
    })
}

/// What a zip that can't be read is refused with. `expected`: what it would have been.
pub fn unreadable(bytes: &[u8], error: &ZipError, expected: &str) -> FormatError {
    // Every zip ends with a record of this mark, and then a comment.
    let has_end = bytes.windows(4).any(|four| four == RECORDS[0].mark);
    let found = if has_end {
        format!("a zip that can't be read: {error}")
    } else {
        "a zip without its end: the file is incomplete".into()
    };
    FormatError::container(found, expected)
}

/// Opens a zip.
///
/// # Errors
/// When the bytes are none, or it has too many members.
pub fn open(bytes: &[u8]) -> ZipResult<ZipFile<'_>> {
    let too_many = || ZipError::InvalidArchive(format!("more than {MAX_MEMBERS} members").into());
    if promises(bytes) > MAX_MEMBERS {
        return Err(too_many());
    }
    let archive = ZipArchive::new(Cursor::new(bytes))?;
    if archive.len() as u64 > MAX_MEMBERS {
        return Err(too_many());
    }
    Ok(archive)
}

/// The most members that any record at the end speaks of: which of them a reader believes is its
/// own business.
fn promises(bytes: &[u8]) -> u64 {
    let end = &bytes[bytes.len().saturating_sub(LONGEST_END)..];
    let mut most = 0;
    for (at, four) in end.windows(4).enumerate() {
        for record in RECORDS.iter().filter(|record| record.mark == four) {
            let count = end[at..].get(record.count.clone()).unwrap_or_default();
            let count = count
                .iter()
                .rev()
                .fold(0, |sum, &byte| sum << 8 | u64::from(byte));
            most = most.max(count);
        }
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;
    use zip::{ZipWriter, write::SimpleFileOptions};

    fn small() -> Vec<u8> {
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        writer
            .start_file("a", SimpleFileOptions::default())
            .unwrap();
        writer.write_all(b"a").unwrap();
        writer.finish().unwrap().into_inner()
    }

    #[test]
    fn archives_that_speak_of_too_many_members_are_refused() {
        assert_eq!(open(&small()).unwrap().len(), 1);
        let refused = |bytes: &[u8]| match open(bytes) {
            Ok(_) => "nothing".to_owned(),
            Err(error) => error.to_string(),
        };
        let mut many = small();
        let end = many.len() - 22;
        many[end + 10..end + 12].fill(0xff);
        assert!(refused(&many).contains("10000 members"));
        // Another record before the last one.
        let mut two = many.clone();
        two.extend_from_slice(&small()[end..]);
        assert!(refused(&two).contains("10000 members"));
        let mut large = small();
        let record = [
            &b"PK\x06\x06"[..],
            &[0; 28],
            &1_000_000u64.to_le_bytes(),
            &[0; 16],
        ]
        .concat();
        large.splice(end..end, record);
        assert!(refused(&large).contains("10000 members"));
    }
}
