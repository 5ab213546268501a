//! Images as files: PNG, JPEG or WebP, by the ending.

use crate::output::Output;
use anyhow::Context;
use image::{ImageFormat, RgbImage, RgbaImage, buffer::ConvertBuffer, codecs::jpeg::JpegEncoder};
use image_webp::{ColorType, WebPEncoder};
use std::io::Cursor;

/// Of JPEGs, 1 to 100: no edge of an avatar shows blocks.
const QUALITY: u8 = 95;

/// Writes an image. Alpha is straight, and left out of a .jpg, which has none.
pub fn write(image: &RgbaImage, out: &Output) -> anyhow::Result<()> {
    let bytes = encoded(image, out.ending())
        .with_context(|| format!("{} can't be written", out.display()))?;
    out.write(bytes)
}

/// `ending`: jpg, webp for one without loss, or png.
fn encoded(image: &RgbaImage, ending: &str) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Cursor::new(Vec::new());
    let [width, height] = [image.width(), image.height()];
    match ending {
        "jpg" => {
            let opaque: RgbImage = image.convert();
            JpegEncoder::new_with_quality(&mut bytes, QUALITY).encode_image(&opaque)?;
        }
        "webp" => WebPEncoder::new(&mut bytes).encode(image, width, height, ColorType::Rgba8)?,
        _ => image.write_to(&mut bytes, ImageFormat::Png)?,
    }
    Ok(bytes.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_ending_is_its_format_and_straight_alpha_is_kept() {
        let pixel = |x: u32, y: u32| image::Rgba([40 * x as u8, 200, 30 * y as u8, 60 * x as u8]);
        let image = RgbaImage::from_fn(5, 7, pixel);
        let [png, webp, jpg] =
            ["png", "webp", "jpg"].map(|ending| encoded(&image, ending).unwrap());
        assert_eq!(image::load_from_memory(&png).unwrap().to_rgba8(), image);
        let mut webp = image_webp::WebPDecoder::new(Cursor::new(webp)).unwrap();
        let mut pixels = vec![0; 4 * 5 * 7];
        webp.read_image(&mut pixels).unwrap();
        assert!(!webp.is_lossy() && pixels == *image.as_raw());
        let jpg = image::load_from_memory_with_format(&jpg, ImageFormat::Jpeg).unwrap();
        assert_eq!([jpg.width(), jpg.height()], [5, 7]);
    }
}
