//! Images whose pixels are numbers.

use effigy_core::io::file::{FormatError, excerpt};
use image_webp::WebPDecoder;
use std::io::Cursor;

/// Bytes of an image that any WebP may have: its own headers.
const SLACK: u64 = 64 << 10;

/// The pixels of an image, RGBA.
pub struct Texture {
    pub width: usize,
    pub pixels: Vec<[u8; 4]>,
}

/// Most bytes of the file of an image of so many pixels: WebP does not make them larger.
pub fn most_bytes(pixels: u64) -> u64 {
    4 * pixels + SLACK
}

impl Texture {
    /// Decodes an image of `least` to `most` pixels.
    pub fn decode(bytes: &[u8], name: &str, least: u64, most: u64) -> Result<Self, FormatError> {
        let unreadable = |found: String| {
            FormatError::container(format!("{found} in `{}`", excerpt(name)), "a WebP image")
        };
        let mut decoder =
            WebPDecoder::new(Cursor::new(bytes)).map_err(|error| unreadable(error.to_string()))?;
        let (width, height) = decoder.dimensions();
        let pixels = u64::from(width) * u64::from(height);
        if !(least..=most).contains(&pixels) {
            return Err(FormatError::container(
                format!("{width} × {height} pixels in `{}`", excerpt(name)),
                format!("{least} to {most}"),
            ));
        }
        if decoder.is_animated() {
            return Err(unreadable("an animation".into()));
        }
        let channels = if decoder.has_alpha() { 4 } else { 3 };
        let mut raw = vec![0; channels * pixels as usize];
        decoder.set_memory_limit(most_bytes(most) as usize);
        decoder
            .read_image(&mut raw)
            .map_err(|error| unreadable(error.to_string()))?;
        let pixel = |bytes: &[u8]| match *bytes {
            [r, g, b, a] => [r, g, b, a],
            [r, g, b] => [r, g, b, 255],
            _ => [0; 4],
        };
        Ok(Self {
            width: width as usize,
            pixels: raw.chunks_exact(channels).map(pixel).collect(),
        })
    }
}
