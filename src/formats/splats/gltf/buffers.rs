//! The bytes that a document refers to: the second chunk of a `.glb`, text in the document, or files
//! beside it.

use super::document::{Document, View, entry};
use crate::splats::{beside::Beside, bytes::slice};
use base64::{Engine, prelude::BASE64_STANDARD};
use effigy_core::io::file::{FormatError, excerpt};
use std::borrow::Cow;

/// The bytes of every buffer that splats use.
pub struct Buffers<'a> {
    document: &'a Document,
    bytes: Vec<Option<Cow<'a, [u8]>>>,
}

impl<'a> Buffers<'a> {
    /// Reads those buffers whose bit in `used` is set.
    pub fn read(
        document: &'a Document,
        binary: Option<&'a [u8]>,
        used: &[bool],
        beside: &mut dyn Beside,
    ) -> Result<Self, FormatError> {
        let mut bytes = Vec::with_capacity(document.buffers.len());
        for (index, buffer) in document.buffers.iter().enumerate() {
            if !used.get(index).is_some_and(|used| *used) {
                bytes.push(None);
                continue;
            }
            let content = match &buffer.uri {
                None => Cow::Borrowed(binary.filter(|_| index == 0).ok_or_else(|| {
                    FormatError::container(format!("no content of buffer {index}"), "a chunk BIN")
                })?),
                Some(uri) => Cow::Owned(from_uri(uri, buffer.byte_length, beside)?),
            };
            if (content.len() as u64) < buffer.byte_length {
                return Err(FormatError::container(
                    format!("{} bytes of buffer {index}", content.len()),
                    format!("{}; the file is incomplete", buffer.byte_length),
                ));
            }
            bytes.push(Some(content));
        }
        Ok(Self { document, bytes })
    }

    /// Bytes of all buffers together.
    pub fn total(&self) -> u64 {
        let lengths = self.bytes.iter().flatten();
        lengths.map(|bytes| bytes.len() as u64).sum()
    }

    /// A view and its bytes.
    pub fn view(&self, index: usize) -> Result<Viewed<'_>, FormatError> {
        let view = entry(&self.document.buffer_views, index, "buffer view")?;
        let buffer = entry(&self.bytes, view.buffer, "buffer")?;
        let buffer = buffer.as_deref().unwrap_or_default();
        let bytes = slice(buffer, view.byte_offset, view.byte_length, "a buffer view")?;
        Ok(Viewed { view, bytes })
    }
}

/// See [`Buffers::view`].
pub struct Viewed<'a> {
    pub view: &'a View,
    pub bytes: &'a [u8],
}

fn from_uri(uri: &str, length: u64, beside: &mut dyn Beside) -> Result<Vec<u8>, FormatError> {
    let Some(data) = uri.strip_prefix("data:") else {
        return beside.file(&unescaped(uri), length.saturating_add(3));
    };
    let content = data.split_once(";base64,").map(|(_, content)| content);
    let bytes = content.and_then(|content| BASE64_STANDARD.decode(content).ok());
    bytes.ok_or_else(|| {
        FormatError::container(
            format!("the address `data:{}`", excerpt(data)),
            "base64 in it",
        )
    })
}

/// A name without percent signs for its letters.
fn unescaped(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, tail @ ..] = rest {
        let escaped = (*first == b'%')
            .then(|| tail.get(..2))
            .flatten()
            .and_then(|digits| std::str::from_utf8(digits).ok())
            .and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(escaped.unwrap_or(*first));
        rest = if escaped.is_some() { &tail[2..] } else { tail };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unescaped() {
        assert_eq!(unescaped("a%20b%2"), "a b%2");
        assert_eq!(unescaped("%C3%A4.bin"), "ä.bin");
        assert_eq!(unescaped("100%"), "100%");
    }
}
