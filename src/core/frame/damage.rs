//! The damage rectangle: which pixels a frame clears and draws.

use crate::layout::RASTER_REGION;
use crate::scene::PixelRect;

/// The pixels that a frame clears: whole regions of [`RASTER_REGION`] px, cut off at the image's
/// edges, and at least one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Damage {
    /// Column and row of the first pixel.
    pub min: [u32; 2],
    /// One past the last column and row.
    pub max: [u32; 2],
    /// Whether all of the image is cleared, since its content is unknown or all of it is drawn.
    pub whole: bool,
    /// Where splats are drawn, by tiles in whole regions; the rest is only cleared. Otherwise what
    /// networks move further than the box around an avatar allows for would show wherever something
    /// was before. Never empty.
    pub drawn: PixelRect,
}

/// The whole regions around a part of an image, at least one.
pub fn regions_around(rect: PixelRect, size: [u32; 2]) -> PixelRect {
    let whole = PixelRect::whole(size);
    let min = rect.min.min(whole.max - 1) / RASTER_REGION * RASTER_REGION;
    let max = rect
        .max
        .max(min + 1)
        .map(|side| side.next_multiple_of(RASTER_REGION))
        .min(whole.max);
    PixelRect { min, max }
}

impl Damage {
    /// The damage of a frame that draws into `now`. `before`: where earlier frames may have left
    /// something; None if that is unknown. `size`: the image's, at least 1.
    pub fn new(now: PixelRect, before: Option<PixelRect>, size: [u32; 2]) -> Self {
        let whole = PixelRect::whole(size);
        let rect = regions_around(now.union(before.unwrap_or(whole)), size);
        Self {
            min: rect.min.into(),
            max: rect.max.into(),
            whole: before.is_none() || rect == whole,
            drawn: if now.is_empty() {
                regions_around(now, size)
            } else {
                now
            },
        }
    }

    /// The rectangle.
    pub fn rect(&self) -> PixelRect {
        PixelRect {
            min: self.min.into(),
            max: self.max.into(),
        }
    }

    /// Pixels of the rectangle.
    pub fn pixels(&self) -> u64 {
        self.rect().pixels()
    }

    /// Column and row of the first region of a side, px, and one past those of the last. The side
    /// must divide [`RASTER_REGION`].
    pub fn regions(&self, side: u32) -> [[u32; 2]; 2] {
        regions_of(self.rect(), side)
    }

    /// Column and row of the first region of a side, px, that has pixels that are drawn, and one past
    /// those of the last. The side must divide [`RASTER_REGION`].
    pub fn drawn_regions(&self, side: u32) -> [[u32; 2]; 2] {
        regions_of(self.drawn, side)
    }
}

/// Column and row of the first region of a side, px, that a rectangle meets, and one past those of
/// the last.
fn regions_of(rect: PixelRect, side: u32) -> [[u32; 2]; 2] {
    [
        (rect.min / side).into(),
        rect.max.map(|pixel| pixel.div_ceil(side)).into(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [u32; 2] = [10 * RASTER_REGION + 3, 100];
    const REGION: [u32; 2] = [RASTER_REGION; 2];

    fn rect(min: [u32; 2], max: [u32; 2]) -> PixelRect {
        PixelRect {
            min: min.into(),
            max: max.into(),
        }
    }

    #[test]
    fn unknown_content_damages_the_whole_image() {
        assert_eq!(
            Damage::new(rect([40, 33], [41, 34]), None, SIZE),
            Damage {
                min: [0, 0],
                max: SIZE,
                whole: true,
                drawn: rect([40, 33], [41, 34]),
            }
        );
    }

    #[test]
    fn damage_has_at_least_one_region() {
        let nothing = Damage::new(PixelRect::EMPTY, Some(PixelRect::EMPTY), SIZE);
        assert_eq!(
            nothing.regions(RASTER_REGION)[1].map(|end| end > 0),
            [true; 2]
        );
    }

    #[test]
    fn damage_covers_old_and_new_in_whole_regions() {
        let new = rect(REGION, REGION.map(|side| side + 1));
        assert_eq!(
            Damage::new(new, Some(PixelRect::EMPTY), SIZE),
            Damage {
                min: REGION,
                max: REGION.map(|side| 2 * side),
                whole: false,
                drawn: new,
            }
        );
        let both = Damage::new(rect([1, 1], [2, 2]), Some(rect(REGION, SIZE)), SIZE);
        assert_eq!(
            both,
            Damage {
                min: [0, 0],
                max: SIZE,
                whole: true,
                drawn: rect([1, 1], [2, 2]),
            }
        );
        assert_eq!(both.pixels(), u64::from(SIZE[0] * SIZE[1]));
    }

    #[test]
    fn drawn_pixels_are_in_the_regions_that_are_drawn() {
        let drawn_regions = |min, max| {
            let drawn = rect(min, max);
            let before = Some(rect([0, 0], SIZE));
            Damage::new(drawn, before, SIZE).drawn_regions(RASTER_REGION)
        };
        let [width, height] = SIZE.map(|side| side.div_ceil(RASTER_REGION));
        assert_eq!(drawn_regions([1, 1], [31, 31]), [[0, 0], [1, 1]]);
        assert_eq!(drawn_regions([32, 33], [63, 64]), [[1, 1], [2, 2]]);
        assert_eq!(drawn_regions([1, 1], [32, 31]), [[0, 0], [1, 1]]);
        assert_eq!(drawn_regions([32, 33], [65, 64]), [[1, 1], [3, 2]]);
        assert_eq!(drawn_regions([0, 0], SIZE), [[0, 0], [width, height]]);
    }
}
