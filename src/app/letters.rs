//! A page of text drawn by the CPU, for a screen whose GPU can't be used: a text goes in, a picture comes out.

use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};
use image::{Rgba, RgbaImage};

/// Letters' height and the page's margin, px on a screen of density 1.
const HEIGHT: f32 = 18.0;
const MARGIN: f32 = 24.0;
const PAPER: [u8; 3] = [24, 26, 30];
const INK: [u8; 3] = [225, 225, 225];

/// Sets a text in a page of `size` px; `scale` is how many px a point has. What does not fit the page is cut off.
pub fn page(text: &str, size: [u32; 2], scale: f32) -> RgbaImage {
    let [r, g, b] = PAPER;
    let mut picture = RgbaImage::from_pixel(size[0], size[1], Rgba([r, g, b, 255]));
    let Ok(font) = FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT) else { return picture };
    let scaled = font.as_scaled(PxScale::from(HEIGHT * scale));
    let width = (size[0] as f32 - 2.0 * MARGIN * scale).max(1.0);
    for (number, line) in lines(text, |part| length(&scaled, part), width).iter().enumerate() {
        let baseline = 2.0 * MARGIN * scale + scaled.ascent() + number as f32 * (1.3 * scaled.height());
        let mut x = MARGIN * scale;
        for letter in line.chars() {
            let glyph: Glyph = font.glyph_id(letter).with_scale_and_position(scaled.scale(), point(x, baseline));
            x += scaled.h_advance(glyph.id);
            let Some(outline) = font.outline_glyph(glyph) else { continue };
            let at = outline.px_bounds().min;
            outline.draw(|dx, dy, cover| blend(&mut picture, [at.x + dx as f32, at.y + dy as f32], cover));
        }
    }
    picture
}

fn length<F: Font>(font: &impl ScaleFont<F>, text: &str) -> f32 {
    text.chars().map(|letter| font.h_advance(font.glyph_id(letter))).sum()
}

fn blend(picture: &mut RgbaImage, [x, y]: [f32; 2], cover: f32) {
    if x < 0.0 || y < 0.0 {
        return;
    }
    let Some(pixel) = picture.get_pixel_mut_checked(x as u32, y as u32) else { return };
    for (channel, ink) in pixel.0.iter_mut().zip(INK) {
        *channel = (f32::from(*channel) + cover.clamp(0.0, 1.0) * (f32::from(ink) - f32::from(*channel))).round() as u8;
    }
}

/// Breaks a text into lines of at most `width` where it has spaces; a longer word has a line to itself.
fn lines(text: &str, length: impl Fn(&str) -> f32, width: f32) -> Vec<String> {
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            let longer = if line.is_empty() { word.to_string() } else { format!("{line} {word}") };
            if !line.is_empty() && length(&longer) > width {
                lines.push(std::mem::replace(&mut line, word.to_string()));
            } else {
                line = longer;
            }
        }
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_breaks_at_spaces_and_keeps_its_paragraphs() {
        let broken = lines("one two three\n\nfour extraordinarily", |part| part.len() as f32, 8.0);
        assert_eq!(broken, ["one two", "three", "", "four", "extraordinarily"]);
    }

    #[test]
    fn a_page_has_ink_inside_its_margins_only_and_any_size_is_drawn() {
        let picture = page("Effigy can't run here. The device lacks Vulkan 1.1, and this line is long.", [300, 400], 1.0);
        let ink = |x: u32, y: u32| picture.get_pixel(x, y).0[..3] != PAPER;
        let inked = (0..400).flat_map(|y| (0..300).map(move |x| (x, y))).filter(|&(x, y)| ink(x, y)).collect::<Vec<_>>();
        assert!(inked.len() > 1000, "{} pixels of ink", inked.len());
        assert!(inked.iter().all(|&(x, _)| (22..278).contains(&x)), "letters in the margin");
        assert!(inked.iter().any(|&(_, y)| y > 80), "the long line was not broken");
        for size in [[1, 1], [3, 2000], [2000, 3]] {
            assert_eq!(page("a text", size, 3.0).dimensions(), size.into());
        }
    }
}
