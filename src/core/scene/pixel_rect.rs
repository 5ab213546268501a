//! Rectangles of pixels.

use glam::UVec2;

/// An axis-aligned rectangle of an image, px from its top left corner. It is empty where `min` is
/// not below `max` in both axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// Column and row of the first pixel.
    pub min: UVec2,
    /// One past the last column and row.
    pub max: UVec2,
}

impl PixelRect {
    /// The empty rectangle that any [`Self::union`] ignores.
    pub const EMPTY: Self = Self {
        min: UVec2::MAX,
        max: UVec2::ZERO,
    };

    /// All of an image of a width and height.
    pub fn whole(size: [u32; 2]) -> Self {
        Self {
            min: UVec2::ZERO,
            max: size.into(),
        }
    }

    /// Whether it has no pixels.
    pub fn is_empty(&self) -> bool {
        !self.min.cmplt(self.max).all()
    }

    /// The smallest rectangle around both. Corners are merged whether or not either is empty:
    /// filter empty rectangles other than [`Self::EMPTY`] first.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }
}
