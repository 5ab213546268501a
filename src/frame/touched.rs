//! What of the picture a frame draws. In: boxes around what is in view now, and was before. Out: the pixels to clear and to draw.

use super::extent::around;
use crate::layout::RASTER_REGION;
use glam::UVec2;

/// Whole regions of [`RASTER_REGION`] px, but for the picture's edges, and at least one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Touched {
    /// Column and row of the first pixel.
    pub min: [u32; 2],
    /// Of the first that is beyond.
    pub max: [u32; 2],
    /// Nothing that the picture held is kept: it is not known, or all of it is drawn.
    pub anew: bool,
}

impl Touched {
    /// `now`: where something is drawn; `before`: where something may be left of earlier frames, None where that is not known. Corners of
    /// boxes in a picture of `size` px, at least 1.
    pub fn new(now: [UVec2; 2], before: Option<[UVec2; 2]>, size: [u32; 2]) -> Self {
        let whole = [UVec2::ZERO, size.into()];
        let [min, max] = around(now, before.unwrap_or(whole));
        let min = min.min(whole[1] - 1) / RASTER_REGION * RASTER_REGION;
        let max = max.max(min + 1).map(|side| side.next_multiple_of(RASTER_REGION)).min(whole[1]);
        Self { min: min.into(), max: max.into(), anew: before.is_none() || [min, max] == whole }
    }

    pub fn pixels(&self) -> u64 {
        (0..2).map(|axis| u64::from(self.max[axis] - self.min[axis])).product()
    }

    /// Column and row of the first region, and of the first that is beyond.
    pub fn regions(&self) -> [[u32; 2]; 2] {
        [self.min.map(|at| at / RASTER_REGION), self.max.map(|at| at.div_ceil(RASTER_REGION))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::extent::NOWHERE;

    #[test]
    fn what_is_and_was_there_is_touched_in_whole_regions() {
        let size = [10 * RASTER_REGION + 3, 100];
        let at = |x, y| UVec2::new(x, y);
        let touched = |now, before| Touched::new(now, before, size);
        assert_eq!(touched([at(40, 33), at(41, 34)], None), Touched { min: [0, 0], max: size, anew: true });
        let region = [RASTER_REGION; 2];
        assert_eq!(touched(NOWHERE, Some(NOWHERE)).regions()[1].map(|end| end > 0), [true; 2]);
        let one = touched([region.into(), at(region[0] + 1, region[1] + 1)], Some(NOWHERE));
        assert_eq!((one.min, one.max, one.anew), (region, region.map(|side| 2 * side), false));
        let both = touched([at(1, 1), at(2, 2)], Some([region.into(), size.into()]));
        assert_eq!((both.min, both.max, both.anew, both.pixels()), ([0, 0], size, true, u64::from(size[0] * size[1])));
    }
}
