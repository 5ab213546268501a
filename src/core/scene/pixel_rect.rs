//! Rectangles of pixels.

use glam::{IVec2, UVec2};

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

    /// How many pixels it has.
    pub fn pixels(&self) -> u64 {
        let size = self.max.saturating_sub(self.min);
        u64::from(size.x) * u64::from(size.y)
    }

    /// The smallest rectangle around both. Corners are merged whether or not either is empty:
    /// filter empty rectangles other than [`Self::EMPTY`] first.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The pixels of both; empty where there are none.
    pub fn intersection(self, other: Self) -> Self {
        Self {
            min: self.min.max(other.min),
            max: self.max.min(other.max),
        }
    }
}

/// An axis-aligned rectangle in the plane of an image, px from its top left corner, which may lie
/// outside the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlaneRect {
    /// Column and row of the first pixel.
    pub min: IVec2,
    /// One past the last column and row.
    pub max: IVec2,
}

impl PlaneRect {
    /// The smallest rectangle around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Whether both have a pixel in common.
    pub fn meets(self, other: Self) -> bool {
        self.min.cmplt(other.max).all() && other.min.cmplt(self.max).all()
    }

    /// Width and height, px, at least 1.
    pub fn sides(self) -> UVec2 {
        (self.max - self.min).max(IVec2::ONE).as_uvec2()
    }

    /// What of it lies in an image of a width and height.
    pub fn within(self, size: [u32; 2]) -> PixelRect {
        let size = UVec2::from(size).as_ivec2();
        let clamp = |at: IVec2| at.clamp(IVec2::ZERO, size).as_uvec2();
        PixelRect {
            min: clamp(self.min),
            max: clamp(self.max),
        }
    }
}
