//! The panel's icons and its font.

use egui::{
    Color32, FontData, FontDefinitions, FontFamily, Rect, Response, Sense, Shape, Stroke, Ui, Vec2,
};

/// An icon of a media player's button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// Starts playback.
    Play,
    /// Pauses playback.
    Pause,
    /// Goes to the previous clip.
    Previous,
    /// Goes to the next clip.
    Next,
}

/// Adds a square button with an icon.
pub fn button(ui: &mut Ui, icon: Icon) -> Response {
    let side = ui.spacing().interact_size.y;
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::click());
    let visuals = ui.style().interact(&response);
    ui.painter()
        .rect_filled(rect, visuals.corner_radius, visuals.weak_bg_fill);
    ui.painter()
        .extend(shapes(icon, rect.shrink(0.28 * side), visuals.text_color()));
    response
}

/// The shapes of an icon that fills a square.
fn shapes(icon: Icon, square: Rect, ink: Color32) -> Vec<Shape> {
    let at = |x: f32, y: f32| square.lerp_inside(egui::vec2(x, y));
    let triangle = |from: f32, to: f32| {
        let corners = [at(from, 0.0), at(to, 0.5), at(from, 1.0)];
        // egui wants its outlines clockwise.
        let clockwise = if to > from {
            corners
        } else {
            [corners[0], corners[2], corners[1]]
        };
        Shape::convex_polygon(clockwise.to_vec(), ink, Stroke::NONE)
    };
    let bar = |from: f32, to: f32| {
        Shape::rect_filled(Rect::from_two_pos(at(from, 0.0), at(to, 1.0)), 0.0, ink)
    };
    match icon {
        Icon::Play => vec![triangle(0.08, 1.0)],
        Icon::Pause => vec![bar(0.1, 0.38), bar(0.62, 0.9)],
        Icon::Previous => vec![bar(0.0, 0.16), triangle(0.95, 0.2)],
        Icon::Next => vec![triangle(0.05, 0.8), bar(0.84, 1.0)],
    }
}

/// One font for everything. Its digits have one width, so that changing numbers do not jitter.
/// egui's fonts for emoji and code would add a quarter to the size of the Android library.
pub fn fonts() -> FontDefinitions {
    const NAME: &str = "Ubuntu-Light";
    let mut fonts = FontDefinitions::empty();
    fonts.font_data.insert(
        NAME.into(),
        FontData::from_static(epaint_default_fonts::UBUNTU_LIGHT).into(),
    );
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.insert(family, vec![NAME.into()]);
    }
    fonts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::action::{KEYS, POINTERS};
    use ab_glyph::{Font, FontRef, ScaleFont};
    use egui::pos2;

    #[test]
    fn the_font_has_all_letters_and_digits_of_one_width() {
        let Ok(font) = FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT) else {
            panic!("the font can't be read")
        };
        let keys = POINTERS
            .iter()
            .chain(&KEYS)
            .flat_map(|(key, what)| key.chars().chain(what.chars()));
        let missing: String = keys
            .chain(" ~".chars())
            .chain('!'..='~')
            .chain("×–µ°®".chars())
            .filter(|&c| font.glyph_id(c).0 == 0)
            .collect();
        assert_eq!(missing, "");
        let scaled = font.as_scaled(20.0);
        let widths: Vec<f32> = ('0'..='9')
            .map(|digit| scaled.h_advance(font.glyph_id(digit)))
            .collect();
        assert!(widths.iter().all(|&width| width == widths[0]), "{widths:?}");
    }

    #[test]
    fn icons_stay_in_their_square_and_differ() {
        let square = Rect::from_min_max(pos2(2.0, 3.0), pos2(12.0, 13.0));
        let all = [Icon::Play, Icon::Pause, Icon::Previous, Icon::Next]
            .map(|icon| shapes(icon, square, Color32::WHITE));
        for (number, shapes) in all.iter().enumerate() {
            assert!(
                shapes.iter().all(|shape| square
                    .expand(1.0)
                    .contains_rect(shape.visual_bounding_rect())),
                "{shapes:?}"
            );
            assert!(all[..number].iter().all(|other| other != shapes));
        }
    }
}
