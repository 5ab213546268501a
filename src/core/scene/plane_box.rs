//! Boxes in the plane of an image.

use super::{Camera, PixelRect, PlaneRect};
use glam::{DVec2, DVec3, UVec2};

/// Coordinates in the plane of the image beyond this, px, belong to nothing that is drawn.
const PLANE_MAX: f64 = 1e6;

/// A box in the plane of the image, px; it may lie outside the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneBox {
    /// Lower corner.
    pub min: DVec2,
    /// Upper corner.
    pub max: DVec2,
}

impl PlaneBox {
    /// No point of the plane.
    pub const EMPTY: Self = Self {
        min: DVec2::INFINITY,
        max: DVec2::NEG_INFINITY,
    };
    /// All of it.
    pub const EVERYWHERE: Self = Self {
        min: DVec2::NEG_INFINITY,
        max: DVec2::INFINITY,
    };

    /// Encloses where anything within `margin` metres of a point may appear, and `reach` px
    /// further. `p`: in camera coordinates, further than `margin` from the camera's plane.
    pub fn around(p: DVec3, camera: &Camera, margin: f64, reach: f64) -> Self {
        let slope = p.truncate() / p.z;
        let at = camera.focal * slope + camera.center;
        let radius = projected_radius(camera, slope.abs(), p.z, margin) + reach;
        Self {
            min: at - radius,
            max: at + radius,
        }
    }

    /// Widens the box by another, which is worked out only where `bound`, a box around it, says
    /// that it may add something.
    pub fn include(&mut self, bound: &Self, other: impl FnOnce() -> Self) {
        if !self.contains(bound) {
            *self = self.union(other());
        }
    }

    /// Whether all of another lies inside. Not where one of its numbers is NaN.
    fn contains(&self, other: &Self) -> bool {
        self.min.cmple(other.min).all() && self.max.cmpge(other.max).all()
    }

    /// Whether all of it lies in an image of a size.
    pub fn is_inside(&self, size: UVec2) -> bool {
        let image = Self {
            min: DVec2::ZERO,
            max: size.as_dvec2(),
        };
        image.contains(self)
    }

    /// Whether nothing of it lies in an image of a size.
    pub fn is_outside(&self, size: UVec2) -> bool {
        self.max.cmplt(DVec2::ZERO).any() || self.min.cmpgt(size.as_dvec2()).any()
    }

    /// The pixels of an image that it touches: all of them where it has no end.
    pub fn within(&self, size: UVec2) -> PixelRect {
        if !self.min.is_finite() || !self.max.is_finite() {
            return PixelRect::whole(size.into());
        }
        let clamp = |at: DVec2| at.clamp(DVec2::ZERO, size.as_dvec2()).as_uvec2();
        PixelRect {
            min: clamp(self.min.floor()),
            max: clamp(self.max.ceil()),
        }
    }

    /// The smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The pixels of the plane that it touches. None where it is empty, or too large to be drawn.
    pub fn pixels(&self) -> Option<PlaneRect> {
        let drawn = |at: DVec2| at.abs().max_element() < PLANE_MAX;
        (drawn(self.min) && drawn(self.max)).then(|| PlaneRect {
            min: self.min.floor().as_ivec2(),
            max: self.max.ceil().as_ivec2(),
        })
    }
}

/// How far from a point's projection anything within `margin` metres of it may appear, px. `slope`:
/// its |x/z| and |y/z|; `z`: how far it is along the camera's axis, metres, more than `margin`.
pub fn projected_radius(camera: &Camera, slope: DVec2, z: f64, margin: f64) -> DVec2 {
    margin / (z - margin) * camera.focal * (1.0 + slope)
}
