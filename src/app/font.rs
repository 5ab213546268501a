//! Text drawn by the CPU, for a screen whose GPU can't be used.

use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};
use image::{Rgba, RgbaImage};

/// Height of the letters, points.
const HEIGHT: f32 = 18.0;
/// Margin of the page, points.
const MARGIN: f32 = 24.0;
const PAPER: [u8; 3] = [24, 26, 30];
const INK: [u8; 3] = [225, 225, 225];

/// Draws a text on a page of `size` px. `scale`: px a point. Text that does not fit is cut off.
pub fn draw_page(text: &str, size: [u32; 2], scale: f32) -> RgbaImage {
    let [r, g, b] = PAPER;
    let mut image = RgbaImage::from_pixel(size[0], size[1], Rgba([r, g, b, 255]));
    let Ok(font) = FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT) else {
        return image;
    };
    let scaled = font.as_scaled(PxScale::from(HEIGHT * scale));
    let width = (size[0] as f32 - 2.0 * MARGIN * scale).max(1.0);
    let lines = break_lines(text, |part| text_width(&scaled, part), width);
    for (number, line) in lines.iter().enumerate() {
        let baseline =
            2.0 * MARGIN * scale + scaled.ascent() + number as f32 * (1.3 * scaled.height());
        let mut x = MARGIN * scale;
        for letter in line.chars() {
            let glyph: Glyph = font
                .glyph_id(letter)
                .with_scale_and_position(scaled.scale(), point(x, baseline));
            x += scaled.h_advance(glyph.id);
            let Some(outline) = font.outline_glyph(glyph) else {
                continue;
            };
            let corner = outline.px_bounds().min;
            outline.draw(|dx, dy, coverage| {
                let x = corner.x + dx as f32;
                let y = corner.y + dy as f32;
                blend_ink(&mut image, x, y, coverage);
            });
        }
    }
    image
}

fn text_width<F: Font>(font: &impl ScaleFont<F>, text: &str) -> f32 {
    text.chars()
        .map(|letter| font.h_advance(font.glyph_id(letter)))
        .sum()
}

/// Blends ink over the pixel at a point, px; points outside the image are ignored.
fn blend_ink(image: &mut RgbaImage, x: f32, y: f32, coverage: f32) {
    if x < 0.0 || y < 0.0 {
        return;
    }
    let Some(pixel) = image.get_pixel_mut_checked(x as u32, y as u32) else {
        return;
    };
    let coverage = coverage.clamp(0.0, 1.0);
    for (channel, ink) in pixel.0.iter_mut().zip(INK) {
        let paper = f32::from(*channel);
        *channel = (paper + coverage * (f32::from(ink) - paper)).round() as u8;
    }
}

/// Breaks a text into lines no wider than `width`, at spaces. A longer word has a line to itself.
fn break_lines(text: &str, text_width: impl Fn(&str) -> f32, width: f32) -> Vec<String> {
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            let longer = if line.is_empty() {
                word.to_string()
            } else {
                format!("{line} {word}")
            };
            if !line.is_empty() && text_width(&longer) > width {
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
        let broken = break_lines(
            "one two three\n\nfour extraordinarily",
            |part| part.len() as f32,
            8.0,
        );
        assert_eq!(broken, ["one two", "three", "", "four", "extraordinarily"]);
    }

    #[test]
    fn a_page_of_any_size_keeps_its_margins() {
        let image = draw_page(
            "Effigy can't run here. The device lacks Vulkan 1.1, and this line is long.",
            [300, 400],
            1.0,
        );
        let ink = |x: u32, y: u32| image.get_pixel(x, y).0[..3] != PAPER;
        let inked = (0..400)
            .flat_map(|y| (0..300).map(move |x| (x, y)))
            .filter(|&(x, y)| ink(x, y))
            .collect::<Vec<_>>();
        assert!(inked.len() > 1000, "{} pixels of ink", inked.len());
        assert!(
            inked.iter().all(|&(x, _)| (22..278).contains(&x)),
            "letters in the margin"
        );
        assert!(
            inked.iter().any(|&(_, y)| y > 80),
            "the long line was not broken"
        );
        for size in [[1, 1], [3, 2000], [2000, 3]] {
            assert_eq!(draw_page("a text", size, 3.0).dimensions(), size.into());
        }
    }
}
