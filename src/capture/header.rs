//! Width, height and channels of a picture from the first bytes of its file, without decoding it: a
//! capture has tens of thousands. (The crate `imagesize` knows of no alpha, and refuses JPEGs with
//! fill bytes before a marker.)

use crate::limits;
use effigy_core::io::file::FormatError;
use std::{
    fs::File,
    io::{self, BufReader, Read},
    path::Path,
};

const PNG: &[u8; 8] = b"\x89PNG\r\n\x1a\n";
/// Segments before a JPEG's size, at most; comments and colour profiles have some tens.
const MAX_SEGMENTS: usize = 1000;

/// Width and height, px.
pub type PixelSize = [u32; 2];

/// What a file says of its image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Head {
    pub size: PixelSize,
    /// Whether it has an alpha channel.
    pub has_alpha: bool,
}

/// What a PNG or JPEG says of its image.
pub fn read(path: &Path) -> Result<Head, FormatError> {
    let failed = |error: io::Error| FormatError::container(error, "a PNG or JPEG");
    let file = File::open(path).map_err(failed)?;
    let about = file.metadata().map_err(failed)?;
    if !about.is_file() || about.len() > limits::IMAGE {
        return Err(FormatError::container(
            format!("{} bytes", about.len()),
            format!("a file of at most {} bytes", limits::IMAGE),
        ));
    }
    head_in(&mut BufReader::new(file))
}

fn head_in(from: &mut impl Read) -> Result<Head, FormatError> {
    let mut has_alpha = false;
    let cut = |_| FormatError::container("an end inside the header", "a whole PNG or JPEG");
    let mut start = [0; 2];
    from.read_exact(&mut start).map_err(cut)?;
    let size = if start == [0xFF, 0xD8] {
        jpeg(from)?
    } else {
        let mut rest = [0; 24];
        from.read_exact(&mut rest).map_err(cut)?;
        let word = |at: usize| u32::from_be_bytes(std::array::from_fn(|k| rest[at - 2 + k]));
        if start != PNG[..2] || rest[..6] != PNG[2..] || rest[10..14] != *b"IHDR" {
            return Err(FormatError::container(
                "neither of their first bytes",
                "a PNG or JPEG",
            ));
        }
        // Grey and RGB with alpha.
        has_alpha = matches!(rest[23], 4 | 6);
        [word(16), word(20)]
    };
    let fits = size.iter().all(|side| (1..=limits::SIDE).contains(side));
    if !fits || u64::from(size[0]) * u64::from(size[1]) > limits::PIXELS {
        return Err(FormatError::container(
            format!("{} x {} px", size[0], size[1]),
            format!("sides of 1 to {} px", limits::SIDE),
        ));
    }
    Ok(Head { size, has_alpha })
}

/// The size in a JPEG's frame header, after its first two bytes.
fn jpeg(from: &mut impl Read) -> Result<PixelSize, FormatError> {
    let cut = |_| FormatError::container("an end inside the header", "a whole JPEG");
    let mut byte = || {
        let mut byte = [0];
        from.read_exact(&mut byte).map(|()| byte[0])
    };
    for _ in 0..MAX_SEGMENTS {
        let mut marker = byte().map_err(cut)?;
        while marker != 0xFF {
            marker = byte().map_err(cut)?;
        }
        while marker == 0xFF {
            marker = byte().map_err(cut)?;
        }
        // Without a length: filling, restarts.
        if matches!(marker, 0x00 | 0x01 | 0xD0..=0xD7) {
            continue;
        }
        let mut word = || -> io::Result<u32> { Ok(u32::from(byte()?) << 8 | u32::from(byte()?)) };
        let length = word().map_err(cut)?;
        // Frame headers, but for C4, C8 and CC: tables and an extension.
        if matches!(marker, 0xC0..=0xCF) && !matches!(marker, 0xC4 | 0xC8 | 0xCC) {
            let depth = byte().map_err(cut)?;
            if depth != 8 {
                let found = format!("{depth} bits a channel");
                return Err(FormatError::container(found, "8 bits"));
            }
            let mut word =
                || -> io::Result<u32> { Ok(u32::from(byte()?) << 8 | u32::from(byte()?)) };
            let height = word().map_err(cut)?;
            return Ok([word().map_err(cut)?, height]);
        }
        if matches!(marker, 0xD9 | 0xDA) {
            break;
        }
        for _ in 2..length {
            byte().map_err(cut)?;
        }
    }
    Err(FormatError::container("no frame header", "a JPEG"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_from_headers_alone() {
        let mut png = PNG.to_vec();
        png.extend(b"\0\0\0\x0dIHDR\0\0\x02\0\0\0\x01\0\x08\x02");
        let head = |size, has_alpha| Some(Head { size, has_alpha });
        assert_eq!(head_in(&mut &png[..]).ok(), head([512, 256], false));
        png[25] = 6;
        assert_eq!(head_in(&mut &png[..]).ok(), head([512, 256], true));
        let jpeg = b"\xff\xd8\xff\xe0\0\x04ab\xff\xff\xc2\0\x11\x08\0\x30\0\x40\x03";
        assert_eq!(head_in(&mut &jpeg[..]).ok(), head([64, 48], false));
        for length in 0..jpeg.len() - 1 {
            assert!(head_in(&mut &jpeg[..length]).is_err(), "{length}");
        }
    }

    #[test]
    fn odd_headers_are_refused() {
        let deep = b"\xff\xd8\xff\xc0\0\x11\x0c\0\x30\0\x40\x03";
        let tables = b"\xff\xd8\xff\xda\0\x04ab";
        let flat = b"\xff\xd8\xff\xc0\0\x11\x08\0\x00\0\x40\x03";
        let mut large = PNG.to_vec();
        large.extend(b"\0\0\0\x0dIHDR\x7f\0\x02\0\x7f\0\x01\0\x08\x02");
        for bytes in [
            &deep[..],
            tables,
            flat,
            &large,
            b"GIF89a and more than enough of it",
        ] {
            assert!(head_in(&mut &bytes[..]).is_err(), "{bytes:?}");
        }
    }
}
