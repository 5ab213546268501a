//! Where the document and the bytes of a glTF file are: both in one file (GLB), or the document
//! alone. Chunks may be padded or not, with spaces or zeros, and counted with their padding or
//! without: programs differ in all of it.

use effigy_core::io::{
    file::{FormatError, excerpt},
    text,
};
use serde::Deserialize;
use std::borrow::Cow;

/// Types of the chunks of a GLB.
const JSON: u32 = 0x4E4F_534A;
const BINARY: u32 = 0x004E_4942;
/// Bytes of the header, and of a chunk's.
const HEADER: usize = 12;
const CHUNK: usize = 8;

/// A file's parts.
pub struct GlbChunks<'a> {
    /// JSON.
    pub document: Cow<'a, [u8]>,
    /// The bytes of the first buffer.
    pub binary: Option<&'a [u8]>,
}

struct Chunk<'a> {
    kind: u32,
    content: &'a [u8],
    end: usize,
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    let word = bytes.get(at..)?.first_chunk()?;
    Some(u32::from_le_bytes(*word))
}

fn chunk(bytes: &[u8], at: usize) -> Option<Chunk<'_>> {
    let start = at.checked_add(CHUNK)?;
    let end = start.checked_add(word(bytes, at)? as usize)?;
    Some(Chunk {
        kind: word(bytes, at + 4)?,
        content: bytes.get(start..end)?,
        end,
    })
}

/// The next chunk of a known type from `at`, behind padding that the last one may not have counted.
fn padded_chunk(bytes: &[u8], at: usize) -> Option<Chunk<'_>> {
    let is_padding = |start: usize| {
        let padding = bytes.get(at..start).unwrap_or_default();
        padding.iter().all(|byte| matches!(byte, 0 | b' '))
    };
    let starts = (at..at + 4).filter(|&start| is_padding(start));
    let mut chunks = starts.filter_map(|start| chunk(bytes, start));
    chunks.find(|chunk| matches!(chunk.kind, JSON | BINARY))
}

/// Takes a file apart; what is no GLB is all document.
///
/// # Errors
/// When a GLB is of another version, has no document or is cut off.
pub fn parts(bytes: &[u8]) -> Result<GlbChunks<'_>, FormatError> {
    if !bytes.starts_with(b"glTF") {
        return Ok(GlbChunks {
            document: json(bytes),
            binary: None,
        });
    }
    let cut = |expected: String| {
        FormatError::container(
            format!("a .glb of {} bytes", bytes.len()),
            format!("{expected}; the file is incomplete"),
        )
    };
    let version = word(bytes, 4).filter(|version| *version != 2);
    if let Some(version) = version {
        return Err(other_version(&version.to_string()));
    }
    let length = word(bytes, 8).ok_or_else(|| cut(format!("{HEADER} bytes of a header")))?;
    if length as usize > bytes.len() {
        return Err(cut(format!("{length} bytes")));
    }
    let mut document = None;
    let mut at = HEADER;
    while at + CHUNK <= bytes.len() {
        let next = padded_chunk(bytes, at).or_else(|| chunk(bytes, at));
        let Some(Chunk { kind, content, end }) = next else {
            // What is behind the length that the file gives itself is not of it.
            if document.is_some() && at >= length as usize {
                break;
            }
            let promised = word(bytes, at).unwrap_or_default();
            return Err(cut(format!("{promised} bytes of a chunk from byte {at}")));
        };
        at = end;
        match (kind, document) {
            (JSON, None) => document = Some(content),
            (BINARY, Some(document)) => {
                return Ok(GlbChunks {
                    document: json(document),
                    binary: Some(content),
                });
            }
            // Others are for extensions that are not read.
            _ => {}
        }
    }
    let document = document
        .ok_or_else(|| FormatError::container("a .glb without a document", "a chunk JSON"))?;
    Ok(GlbChunks {
        document: json(document),
        binary: None,
    })
}

/// A document without marks before it and zeros behind it.
fn json(bytes: &[u8]) -> Cow<'_, [u8]> {
    let end = bytes.iter().rposition(|&byte| byte != 0);
    text::utf8(&bytes[..end.map_or(0, |last| last + 1)])
}

/// The error of a document that can't be read: `error`, or that it is of another version of glTF.
pub fn unreadable(document: &[u8], error: &serde_json::Error) -> FormatError {
    #[derive(Deserialize)]
    struct Versioned {
        asset: Option<Asset>,
    }
    #[derive(Deserialize)]
    struct Asset {
        version: Option<String>,
    }
    let version = serde_json::from_slice::<Versioned>(document).ok();
    let version = version.and_then(|versioned| versioned.asset?.version);
    match version.filter(|version| !version.starts_with('2')) {
        Some(version) => other_version(&version),
        None => FormatError::container(
            format!(
                "a glTF document that can't be read: {}",
                excerpt(&error.to_string())
            ),
            "JSON as glTF 2.0 has it",
        ),
    }
}

fn other_version(version: &str) -> FormatError {
    FormatError::container(
        format!("version {} of glTF", excerpt(version)),
        "version 2: `gltf-pipeline -i IN -o OUT` converts from 1.0",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A GLB of a document of 13 bytes and a buffer of 3. `behind`: padding of the document;
    /// `counted`: how much of it its chunk counts.
    fn glb(behind: &[u8], counted: usize) -> Vec<u8> {
        let document = [br#"{"asset": {}}"#, behind].concat();
        let length = (13 + counted) as u32;
        let chunks = [
            &length.to_le_bytes()[..],
            &JSON.to_le_bytes(),
            &document,
            &3u32.to_le_bytes(),
            &BINARY.to_le_bytes(),
            &[1, 2, 3],
        ];
        let chunks = chunks.concat();
        let whole = (HEADER + chunks.len()) as u32;
        [
            b"glTF",
            &2u32.to_le_bytes()[..],
            &whole.to_le_bytes(),
            &chunks,
        ]
        .concat()
    }

    #[test]
    fn padding_may_be_anything_and_count_or_not() {
        for (behind, counted) in [
            (&b""[..], 0),
            (b"   ", 3),
            (b"   ", 0),
            (b"\0\0\0", 3),
            (b"\0\0\0", 0),
            (b"  ", 2),
        ] {
            let bytes = glb(behind, counted);
            let parts = parts(&bytes).unwrap();
            assert_eq!(parts.document.trim_ascii(), br#"{"asset": {}}"#);
            assert_eq!(parts.binary, Some(&[1, 2, 3][..]), "{behind:?} {counted}");
        }
    }

    #[test]
    fn other_chunks_are_passed_over_and_ends_named() {
        let mut bytes = glb(b"", 0);
        let other = [4u32.to_le_bytes(), *b"abcd", [9; 4]].concat();
        bytes.splice(33..33, other);
        let length = bytes.len() as u32;
        bytes[8..12].copy_from_slice(&length.to_le_bytes());
        assert_eq!(parts(&bytes).unwrap().binary, Some(&[1, 2, 3][..]));
        bytes.extend([0; 100]);
        assert_eq!(parts(&bytes).unwrap().binary, Some(&[1, 2, 3][..]));
        for end in 4..length as usize {
            assert!(parts(&bytes[..end]).is_err(), "{end}");
        }
    }

    #[test]
    fn older_versions_are_named() {
        let document = br#"{"asset": {"version": "1.0"}, "nodes": {}}"#;
        let error = serde_json::from_slice::<Vec<u8>>(document).unwrap_err();
        let said = unreadable(document, &error).to_string();
        assert!(said.starts_with("found version 1.0 of glTF"), "{said}");
    }
}
