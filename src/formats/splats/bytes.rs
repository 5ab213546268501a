//! Little-endian numbers at places of a file that may be too short for them.

use effigy_core::io::file::FormatError;

/// The bytes from `at`.
///
/// # Errors
/// When the file ends before `at` + `length`. `what`: what they are, in errors.
pub fn slice<'a>(
    bytes: &'a [u8],
    at: u64,
    length: u64,
    what: &str,
) -> Result<&'a [u8], FormatError> {
    let range = || {
        let start = usize::try_from(at).ok()?;
        let end = usize::try_from(at.checked_add(length)?).ok()?;
        bytes.get(start..end)
    };
    range().ok_or_else(|| {
        FormatError::container(
            format!("a file of {} bytes", bytes.len()),
            format!("{length} bytes of {what} from byte {at}; the file is incomplete"),
        )
    })
}

/// N bytes at an index of bytes that are known to be long enough.
pub fn array<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
    std::array::from_fn(|k| bytes[at + k])
}

pub fn u16_at(bytes: &[u8], at: usize) -> u16 {
    u16::from_le_bytes(array(bytes, at))
}

pub fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(array(bytes, at))
}

pub fn u64_at(bytes: &[u8], at: usize) -> u64 {
    u64::from_le_bytes(array(bytes, at))
}

pub fn f32_at(bytes: &[u8], at: usize) -> f32 {
    f32::from_le_bytes(array(bytes, at))
}
