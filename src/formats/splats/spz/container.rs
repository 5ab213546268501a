//! What is packed: a header and the attributes' bytes.

use super::super::{
    beside::limited,
    bytes::{slice, u32_at, u64_at},
    plausible,
};
use effigy_core::io::{
    file::FormatError,
    splats::{Up, functions_of},
};
use flate2::read::GzDecoder;
use ruzstd::decoding::StreamingDecoder;

/// The first bytes of the unpacked file, and of a file of version 4.
pub const MAGIC: &[u8; 4] = b"NGSP";
/// Bytes of the header of versions 1 to 3, and of version 4.
const HEADER: usize = 16;
const HEADER_4: usize = 32;
/// Highest degree of spherical harmonics in the format.
const DEGREE: u8 = 4;
/// The flag of splats that were trained with compensated opacities.
pub const ANTIALIASED: u8 = 1;
/// The flag that says that records of other vendors follow the header.
const EXTENSIONS: u8 = 2;
/// The record that names the file's axes, and those of the format's own.
const AXES_RECORD: u32 = 0xADBE_0003;
const RIGHT_UP_BACK: u32 = 4;
/// Bytes that may unpack in chunks of unknown length: records beyond the attributes.
const SLACK: u64 = 64 << 10;

/// An unpacked file.
pub struct Unpacked {
    pub version: u32,
    pub count: usize,
    /// 0 to 4.
    pub degree: usize,
    /// Bits of a position after the point.
    pub fraction: u8,
    pub up: Up,
    /// Whether splats were trained with compensated opacities.
    pub antialiased: bool,
    pub position: Vec<u8>,
    pub opacity: Vec<u8>,
    pub color: Vec<u8>,
    pub log_scale: Vec<u8>,
    pub rotation: Vec<u8>,
    pub harmonics: Vec<u8>,
}

/// The header's numbers, which all versions have at the same places.
struct SpzHeader {
    version: u32,
    count: u64,
    degree: u8,
    fraction: u8,
    flags: u8,
}

impl SpzHeader {
    fn read(bytes: &[u8], packed: usize) -> Result<Self, FormatError> {
        let start = slice(bytes, 0, HEADER as u64, "a header")?;
        if !start.starts_with(MAGIC) {
            return Err(FormatError::container(
                format!("`{}` at the start", start[..4].escape_ascii()),
                "`NGSP`, of an .spz",
            ));
        }
        let header = Self {
            version: u32_at(start, 4),
            count: u32_at(start, 8).into(),
            degree: start[12],
            fraction: start[13],
            flags: start[14],
        };
        if header.degree > DEGREE {
            return Err(FormatError::container(
                format!("harmonics of degree {}", header.degree),
                format!("0 to {DEGREE}"),
            ));
        }
        if header.fraction > 23 {
            return Err(FormatError::container(
                format!("{} bits after the point", header.fraction),
                "at most 23 of 24",
            ));
        }
        plausible::check(header.count, packed as u64)?;
        Ok(header)
    }

    /// Bytes a splat of each attribute, in the file's order.
    fn widths(&self) -> [u64; 6] {
        [
            if self.version == 1 { 6 } else { 9 },
            1,
            3,
            3,
            if self.version < 3 { 3 } else { 4 },
            3 * functions_of(self.degree.into()) as u64,
        ]
    }

    /// Bytes of all attributes.
    fn total(&self) -> u64 {
        self.widths().iter().map(|width| width * self.count).sum()
    }

    /// Takes an unpacked file of versions 1 to 3 apart.
    fn split(self, whole: &[u8]) -> Result<Unpacked, FormatError> {
        let mut at = HEADER as u64;
        let mut parts = [const { Vec::new() }; 6];
        for (part, width) in parts.iter_mut().zip(self.widths()) {
            let length = width * self.count;
            *part = slice(whole, at, length, "unpacked splats")?.to_vec();
            at += length;
        }
        let records = whole.get(at as usize..).unwrap_or_default();
        let up = up(self.flags, records)?;
        Ok(self.with(parts, up))
    }

    fn with(self, parts: [Vec<u8>; 6], up: Up) -> Unpacked {
        let [position, opacity, color, log_scale, rotation, harmonics] = parts;
        Unpacked {
            version: self.version,
            count: self.count as usize,
            degree: self.degree.into(),
            fraction: self.fraction,
            up,
            antialiased: self.flags & ANTIALIASED != 0,
            position,
            opacity,
            color,
            log_scale,
            rotation,
            harmonics,
        }
    }
}

fn wrong_version(version: u32, expected: &str) -> FormatError {
    FormatError::container(format!("version {version} of .spz"), expected)
}

/// Whether bytes are a gzip of a file of versions 1 to 3.
pub fn is_packed(bytes: &[u8]) -> bool {
    let mut start = [0; 8];
    let read = std::io::Read::read_exact(&mut GzDecoder::new(bytes), &mut start);
    read.is_ok() && start.starts_with(MAGIC) && (1..=3).contains(&u32_at(&start, 4))
}

/// Bytes that a file of any version unpacks to; None where it is none.
pub fn unpacked_size(bytes: &[u8]) -> Option<u64> {
    let start;
    let header = if bytes.starts_with(MAGIC) {
        bytes
    } else {
        let gzip = std::io::Read::take(GzDecoder::new(bytes), HEADER as u64);
        start = limited(gzip, HEADER as u64).ok()?;
        &start
    };
    let header = SpzHeader::read(header, bytes.len()).ok()?;
    Some(HEADER as u64 + header.total())
}

/// Unpacks a file of any version. Those of versions 1 to 3 may have lost their gzip.
///
/// # Errors
/// When it is none, says something impossible, or unpacks to something else than it says.
pub fn unpack(bytes: &[u8]) -> Result<Unpacked, FormatError> {
    if !bytes.starts_with(MAGIC) {
        return unpack_gzip(bytes);
    }
    let header = SpzHeader::read(bytes, bytes.len())?;
    match header.version {
        1..=3 => header.split(bytes),
        4 => unpack_4(bytes, header),
        other => Err(wrong_version(other, "1 to 4")),
    }
}

fn unpack_gzip(bytes: &[u8]) -> Result<Unpacked, FormatError> {
    let unreadable = |found: String| {
        FormatError::container(format!("{found} in the gzip"), "an .spz of version 1 to 3")
    };
    let gzip = std::io::Read::take(GzDecoder::new(bytes), HEADER as u64);
    let start = limited(gzip, HEADER as u64).map_err(unreadable)?;
    let header = SpzHeader::read(&start, bytes.len())?;
    if !(1..=3).contains(&header.version) {
        return Err(wrong_version(header.version, "1, 2 or 3 in a gzip"));
    }
    let most = HEADER as u64 + header.total() + SLACK;
    let whole = limited(GzDecoder::new(bytes), most).map_err(unreadable)?;
    header.split(&whole)
}

fn unpack_4(bytes: &[u8], header: SpzHeader) -> Result<Unpacked, FormatError> {
    let start = slice(bytes, 0, HEADER_4 as u64, "a header")?;
    let streams = u64::from(start[15]);
    let table_at = u64::from(u32_at(start, 16));
    let table = slice(bytes, table_at, 16 * streams, "a table")?;
    let records = bytes.get(HEADER_4..table_at as usize).ok_or_else(|| {
        FormatError::container(format!("a table at byte {table_at}"), "32 or more")
    })?;
    // Attributes of no bytes have no stream.
    let lengths = header.widths().map(|width| width * header.count);
    let expected = lengths.iter().filter(|length| **length > 0).count() as u64;
    if streams != expected {
        return Err(FormatError::container(
            format!("{streams} streams"),
            format!("{expected}"),
        ));
    }
    let mut at = table_at + 16 * streams;
    let mut parts = [const { Vec::new() }; 6];
    let full = parts
        .iter_mut()
        .zip(lengths)
        .filter(|(_, length)| *length > 0);
    for ((part, length), row) in full.zip(table.chunks_exact(16)) {
        let (packed, unpacked) = (u64_at(row, 0), u64_at(row, 8));
        if unpacked != length {
            return Err(FormatError::container(
                format!("a stream of {unpacked} bytes"),
                format!("{length}"),
            ));
        }
        let frame = slice(bytes, at, packed, "packed splats")?;
        *part = unzstd(frame, length)?;
        at += packed;
    }
    let up = up(header.flags, records)?;
    Ok(header.with(parts, up))
}

/// Unpacks a zstd frame to exactly `length` bytes.
fn unzstd(frame: &[u8], length: u64) -> Result<Vec<u8>, FormatError> {
    let unreadable = |error: String| {
        FormatError::container(
            format!("a zstd frame that can't be read: {error}"),
            format!("one of {length} bytes"),
        )
    };
    let window = window(frame).ok_or_else(|| unreadable("its header".into()))?;
    // A decoder may hold a whole window before it gives out a byte.
    if window > length.max(8 << 20) {
        return Err(unreadable(format!("a window of {window} bytes")));
    }
    let decoder = StreamingDecoder::new(frame).map_err(|error| unreadable(error.to_string()))?;
    let unpacked = limited(decoder, length).map_err(unreadable)?;
    if unpacked.len() as u64 != length {
        return Err(unreadable(format!("{} bytes", unpacked.len())));
    }
    Ok(unpacked)
}

/// Bytes that a frame's decoder has to hold, by its header (RFC 8878, 3.1.1.1). None: no frame.
fn window(frame: &[u8]) -> Option<u64> {
    let rest = frame.strip_prefix(&[0x28, 0xB5, 0x2F, 0xFD])?;
    let (&descriptor, rest) = rest.split_first()?;
    let single = descriptor >> 5 & 1 == 1;
    if !single {
        let &code = rest.first()?;
        let base = 1u64 << (10 + (code >> 3));
        return Some(base + base / 8 * u64::from(code & 7));
    }
    let rest = rest.get([0, 1, 2, 4][usize::from(descriptor & 3)]..)?;
    let field = |length: usize| {
        let bytes = rest.get(..length)?.iter().rev();
        Some(bytes.fold(0, |sum, &byte| sum << 8 | u64::from(byte)))
    };
    match descriptor >> 6 {
        0 => field(1),
        1 => field(2)?.checked_add(256),
        2 => field(4),
        _ => field(8),
    }
}

/// The axis that points up: y, unless a record says otherwise.
fn up(flags: u8, mut records: &[u8]) -> Result<Up, FormatError> {
    if flags & EXTENSIONS == 0 {
        return Ok(Up::Y);
    }
    let mut axes = RIGHT_UP_BACK;
    while records.len() >= 8 {
        let (kind, length) = (u32_at(records, 0), u32_at(records, 4));
        let content = slice(records, 8, length.into(), "a record")?;
        if kind == AXES_RECORD && content.len() >= 4 {
            axes = u32_at(content, 0);
        }
        records = &records[8 + content.len()..];
    }
    match axes {
        // Left down back, right down front.
        1 | 6 => Ok(Up::MinusY),
        // Right up back, left up front.
        4 | 7 => Ok(Up::Y),
        // Right front up, left back up.
        12 | 15 => Ok(Up::Z),
        // Left front down, right back down.
        9 | 14 => Ok(Up::MinusZ),
        _ => Err(FormatError::container(
            format!("axes of code {axes}"),
            "right-handed ones: 1, 4, 6, 7, 9, 12, 14 or 15",
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frames_window_is_read() {
        let frame = |rest: &[u8]| window(&[&[0x28, 0xB5, 0x2F, 0xFD], rest].concat());
        assert_eq!(frame(&[0x00, 0x00]), Some(1024));
        assert_eq!(frame(&[0x00, 0x0F]), Some(2048 + 7 * 256));
        assert_eq!(frame(&[0x20, 0x07]), Some(7));
        assert_eq!(frame(&[0x60, 0x01, 0x01]), Some(257 + 256));
        assert_eq!(frame(&[0xA0, 1, 0, 0, 1]), Some((1 << 24) + 1));
        assert_eq!(frame(&[0x00]), None);
        assert_eq!(window(b"NGSP"), None);
    }

    #[test]
    fn axes_of_records_are_taken() {
        let record = |kind: u32, content: &[u8]| {
            let length = content.len() as u32;
            [&kind.to_le_bytes(), &length.to_le_bytes(), content].concat()
        };
        let axes = |code: u32| record(AXES_RECORD, &code.to_le_bytes());
        let other = record(7, &[1, 2, 3]);
        assert_eq!(up(0, &axes(6)).ok(), Some(Up::Y));
        assert_eq!(up(2, &[other, axes(6)].concat()).ok(), Some(Up::MinusY));
        assert!(up(2, &axes(8)).is_err());
        assert!(up(2, &axes(6)[..10]).is_err());
    }
}
