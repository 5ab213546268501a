//! Where the bytes of a glTF file are: in the file (GLB), in the JSON, or beside it.

use super::document::{Buffer, Document};
use effigy_core::io::file::{FormatError, excerpt};
use std::borrow::Cow;

/// The bytes of each buffer. `beside`: gives the content of a file beside this one by its relative
/// path.
pub fn buffers<'a>(
    document: &Document,
    binary: Option<&'a [u8]>,
    beside: &mut dyn FnMut(&str) -> Option<Vec<u8>>,
) -> Result<Vec<Cow<'a, [u8]>>, FormatError> {
    let mut buffers = vec![];
    for (at, buffer) in document.buffers.iter().enumerate() {
        let field = format!("buffers[{at}]");
        let content = match (&buffer.uri, binary) {
            (Some(uri), _) => Cow::Owned(resource(uri, &field, beside)?),
            (None, Some(binary)) if at == 0 => Cow::Borrowed(binary),
            // What an extension fills is asked for by its views alone.
            (None, _) => Cow::Borrowed(&[][..]),
        };
        check_length(buffer, &content, &field)?;
        buffers.push(content);
    }
    Ok(buffers)
}

fn check_length(buffer: &Buffer, content: &[u8], field: &str) -> Result<(), FormatError> {
    if content.is_empty() || content.len() as u64 >= buffer.length {
        return Ok(());
    }
    Err(FormatError::metadata(
        field,
        format!("{} bytes", content.len()),
        format!("{}", buffer.length),
    ))
}

fn resource(
    uri: &str,
    field: &str,
    beside: &mut dyn FnMut(&str) -> Option<Vec<u8>>,
) -> Result<Vec<u8>, FormatError> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        return encoded.and_then(base64).ok_or_else(|| {
            FormatError::metadata(field, format!("`{}`", excerpt(uri)), "data in base64")
        });
    }
    let path = decoded(uri);
    let safe = path.as_deref().filter(|path| {
        let up = path.split(['/', '\\']).any(|part| part == "..");
        !up && !path.starts_with(['/', '\\']) && !path.contains(':')
    });
    let Some(path) = safe else {
        return Err(FormatError::metadata(
            field,
            format!("`{}`", excerpt(uri)),
            "the name of a file beside this one",
        ));
    };
    beside(path).ok_or_else(|| {
        FormatError::metadata(
            field,
            format!("no file `{}`", excerpt(path)),
            "it beside this one",
        )
    })
}

/// A URI without its percent signs.
fn decoded(uri: &str) -> Option<String> {
    let mut bytes = vec![];
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let mut digit = || char::from(rest.next()?).to_digit(16);
        let high = digit()?;
        bytes.push((16 * high + digit()?) as u8);
    }
    String::from_utf8(bytes).ok()
}

/// RFC 4648's base64.
fn base64(text: &str) -> Option<Vec<u8>> {
    let text = text.trim_end_matches('=');
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 2);
    let (mut word, mut bits) = (0u32, 0);
    for letter in text.bytes() {
        let value = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return None,
        };
        word = word << 6 | u32::from(value);
        bits += 6;
        if bits >= 8 {
            bits -= 8;
            bytes.push((word >> bits) as u8);
        }
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_in_base64_is_read() {
        assert_eq!(base64("SGkhIQ==").as_deref(), Some(&b"Hi!!"[..]));
        assert_eq!(base64("AP8=").as_deref(), Some(&[0, 255][..]));
        assert_eq!(base64("A*"), None);
    }

    #[test]
    fn files_beside_stay_beside() {
        let mut asked = vec![];
        let mut beside = |path: &str| {
            asked.push(path.to_owned());
            Some(vec![1])
        };
        for odd in [
            "../secret",
            "/etc/passwd",
            "http://host/a.bin",
            "a/%2e%2e/b",
            "c:\\a",
        ] {
            assert!(resource(odd, "buffers[0]", &mut beside).is_err(), "{odd}");
        }
        assert!(resource("walk%20cycle.bin", "buffers[0]", &mut beside).is_ok());
        assert_eq!(asked, ["walk cycle.bin"]);
    }
}
