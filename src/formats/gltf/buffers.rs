//! The bytes that a document refers to: the second chunk of a `.glb`, text in the document, or files
//! beside it.

use super::document::{Document, entry};
use base64::{
    Engine, alphabet,
    engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig},
};
use effigy_core::io::file::{FormatError, excerpt};
use std::borrow::Cow;

/// Gives the content of a file beside the document by its relative path, of at most so many bytes.
pub type ReadBeside<'a> = dyn FnMut(&str, u64) -> Result<Vec<u8>, FormatError> + 'a;

/// A document and its bytes.
pub struct GltfFile<'a> {
    pub document: Document<'a>,
    buffers: Vec<Cow<'a, [u8]>>,
}

impl<'a> GltfFile<'a> {
    /// Reads the buffers that `is_used` says. `binary`: the bytes of the first in a `.glb`.
    ///
    /// # Errors
    /// When a buffer is shorter than the document says, or its address leads nowhere.
    pub fn read(
        document: Document<'a>,
        binary: Option<&'a [u8]>,
        is_used: impl Fn(u32) -> bool,
        beside: &mut ReadBeside,
    ) -> Result<Self, FormatError> {
        let mut buffers = Vec::with_capacity(document.buffers.len());
        for (at, buffer) in document.buffers.iter().enumerate() {
            let length = buffer.byte_length;
            let content = match &buffer.uri {
                _ if !is_used(at as u32) => Cow::default(),
                Some(uri) => Cow::Owned(resource(uri, at, length, beside)?),
                // What an extension fills is asked for by its views alone.
                None => Cow::Borrowed(binary.filter(|_| at == 0).unwrap_or_default()),
            };
            if !content.is_empty() && (content.len() as u64) < length {
                return Err(FormatError::container(
                    format!("{} bytes of buffer {at}", content.len()),
                    format!("{length}; the file is incomplete"),
                ));
            }
            buffers.push(content);
        }
        Ok(Self { document, buffers })
    }

    /// Bytes of all buffers that are used together.
    pub fn size(&self) -> usize {
        self.buffers.iter().map(|buffer| buffer.len()).sum()
    }

    /// The bytes of a view.
    ///
    /// # Errors
    /// When there is no such view, or its buffer ends before it.
    pub fn view(&self, index: u32) -> Result<&[u8], FormatError> {
        let view = entry(&self.document.buffer_views, index, "buffer view")?;
        let fault = |found: String, expected: &str| {
            FormatError::metadata(&format!("bufferViews[{index}]"), found, expected)
        };
        let buffer = self.buffers.get(view.buffer as usize);
        let buffer = buffer.filter(|buffer| !buffer.is_empty());
        // Plain bytes may be there too, for readers without the extension.
        if buffer.is_none() && view.extensions.meshopt.is_some() {
            return Err(fault(
                "EXT_meshopt_compression".into(),
                "bytes that are not compressed: `gltf-transform copy IN OUT` unpacks them",
            ));
        }
        let bytes = buffer.and_then(|buffer| {
            let start = usize::try_from(view.byte_offset).ok()?;
            let length = usize::try_from(view.byte_length).ok()?;
            buffer.get(start..)?.get(..length)
        });
        bytes.ok_or_else(|| {
            let [length, start] = [view.byte_length, view.byte_offset];
            fault(
                format!(
                    "{length} bytes from byte {start} of buffer {}, beyond its end",
                    view.buffer
                ),
                "a buffer view inside its buffer",
            )
        })
    }
}

/// The content of the address of a buffer. `at`: the buffer's index.
fn resource(
    uri: &str,
    at: usize,
    length: u64,
    beside: &mut ReadBeside,
) -> Result<Vec<u8>, FormatError> {
    let fault = |expected| {
        let found = format!("the address `{}`", excerpt(uri));
        FormatError::metadata(&format!("buffers[{at}]"), found, expected)
    };
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        let bytes = encoded.and_then(base64);
        return bytes.ok_or_else(|| {
            fault("base64 in it: `data:`, a type, `;base64,` and then data in base64")
        });
    }
    let path = unescaped(uri);
    let up = path.split(['/', '\\']).any(|part| part == "..");
    if up || path.starts_with(['/', '\\']) || path.contains(':') {
        return Err(fault("the name of a file beside this one"));
    }
    beside(&path, length.saturating_add(3))
}

/// Base64 of either alphabet, padded or not.
fn base64(text: &str) -> Option<Vec<u8>> {
    let config = GeneralPurposeConfig::new()
        .with_decode_allow_trailing_bits(true)
        .with_decode_padding_mode(DecodePaddingMode::Indifferent);
    let mut alphabets = [&alphabet::STANDARD, &alphabet::URL_SAFE].into_iter();
    alphabets.find_map(|alphabet| GeneralPurpose::new(alphabet, config).decode(text).ok())
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
    fn data_in_base64_is_read() {
        assert_eq!(base64("SGkhIQ==").as_deref(), Some(&b"Hi!!"[..]));
        assert_eq!(base64("AP8=").as_deref(), Some(&[0, 255][..]));
        assert_eq!(base64("AP8").as_deref(), Some(&[0, 255][..]));
        assert_eq!(base64("-_8=").as_deref(), Some(&[251, 255][..]));
        assert_eq!(base64("A*"), None);
    }

    #[test]
    fn files_beside_stay_beside() {
        let mut asked = vec![];
        let mut beside = |path: &str, _: u64| {
            asked.push(path.to_owned());
            Ok(vec![1])
        };
        for odd in [
            "../secret",
            "/etc/passwd",
            "http://host/a.bin",
            "a/%2e%2e/b",
            "c:\\a",
        ] {
            assert!(resource(odd, 0, 1, &mut beside).is_err(), "{odd}");
        }
        assert!(resource("walk%20cycle.bin", 0, 1, &mut beside).is_ok());
        assert_eq!(asked, ["walk cycle.bin"]);
    }

    #[test]
    fn names_are_unescaped() {
        assert_eq!(unescaped("a%20b%2"), "a b%2");
        assert_eq!(unescaped("%C3%A4.bin"), "ä.bin");
        assert_eq!(unescaped("100%"), "100%");
    }
}
