//! Text as editors of other systems save it.

use std::borrow::Cow;

/// Bytes behind a mark that have to be text for it to be one: numbers may begin with the same bytes.
const LOOKED_AT: usize = 32;

/// Text in UTF-8 without a byte order mark; text in UTF-16 behind its own mark becomes UTF-8. Bytes
/// of anything else stay what they are.
pub fn utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    match bytes {
        [0xEF, 0xBB, 0xBF, text @ ..] if is_text(text) => text.into(),
        [0xFF, 0xFE, text @ ..] => utf16(bytes, text, u16::from_le_bytes),
        [0xFE, 0xFF, text @ ..] => utf16(bytes, text, u16::from_be_bytes),
        _ => bytes.into(),
    }
}

/// Whether the first bytes are text, the last character of which may be cut off.
fn is_text(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(LOOKED_AT)];
    let is_cut = |error: std::str::Utf8Error| error.error_len().is_none();
    let control = |byte: &u8| byte.is_ascii_control() && !byte.is_ascii_whitespace();
    !start.iter().any(control) && std::str::from_utf8(start).err().is_none_or(is_cut)
}

fn utf16<'a>(whole: &'a [u8], text: &[u8], unit: impl Fn([u8; 2]) -> u16) -> Cow<'a, [u8]> {
    let (pairs, _) = text.as_chunks::<2>();
    let units = pairs.iter().map(|&pair| unit(pair));
    let mut first = units.clone().take(2);
    // All texts that are read begin with letters or brackets.
    if !first.all(|unit| unit < 0x80) {
        return whole.into();
    }
    let letter = |unit: Result<char, _>| unit.unwrap_or(char::REPLACEMENT_CHARACTER);
    let start: String = char::decode_utf16(units.clone().take(LOOKED_AT))
        .map(letter)
        .collect();
    if !is_text(start.as_bytes()) {
        return whole.into();
    }
    let text: String = char::decode_utf16(units).map(letter).collect();
    text.into_bytes().into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_taken_off_text_alone() {
        let text = "{\"name\": \"Köln\"}";
        let marked = [b"\xEF\xBB\xBF", text.as_bytes()].concat();
        assert_eq!(&*utf8(&marked), text.as_bytes());
        assert_eq!(&*utf8(text.as_bytes()), text.as_bytes());
        let units: Vec<u16> = "\u{feff}[1, 2]".encode_utf16().collect();
        let little: Vec<u8> = units.iter().copied().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = units.iter().copied().flat_map(u16::to_be_bytes).collect();
        assert_eq!(&*utf8(&little), b"[1, 2]");
        assert_eq!(&*utf8(&big), b"[1, 2]");
        // A number of 0.374, and 64 bytes of noise.
        for numbers in [&b"\xEF\xBB\xBF\x3E\0\0\0\0"[..], &[0xFF, 0xFE, 3, 200]] {
            assert_eq!(&*utf8(numbers), numbers);
        }
    }
}
