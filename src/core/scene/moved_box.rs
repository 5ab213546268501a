//! Boxes in space as transforms move them, and where a camera sees them: corner by corner, or as a
//! bound that costs a tenth of that and is nearly as small.

use super::{Camera, PlaneBox, plane_box::projected_radius};
use glam::{BVec3, DAffine3, DMat3, DVec3};

/// A box along the axes of its space.
#[derive(Clone, Copy, Debug)]
pub struct AxisBox {
    /// Lower corner.
    pub min: DVec3,
    /// Upper corner.
    pub max: DVec3,
}

impl AxisBox {
    /// No point.
    pub const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// Widens the box by a point.
    pub fn add(&mut self, point: DVec3) {
        self.min = self.min.min(point);
        self.max = self.max.max(point);
    }

    /// The smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Its eight corners.
    pub fn corners(self) -> impl Iterator<Item = DVec3> {
        (0..8).map(move |k| {
            let is_upper = BVec3::new(k & 1 != 0, k & 2 != 0, k & 4 != 0);
            DVec3::select(is_upper, self.max, self.min)
        })
    }

    /// A box around the projections of all its points, each with what lies within `margin` metres
    /// of it and `reach` px further: a point's slopes x/z and y/z are largest where z is least, or
    /// furthest where they are negative. In camera coordinates; all further from the plane of the
    /// camera than `margin`.
    pub fn projection_bound(&self, camera: &Camera, margin: f64, reach: f64) -> PlaneBox {
        let nearest = self.min.z.recip();
        let furthest = self.max.z.recip();
        let [low, high] = [self.min.truncate(), self.max.truncate()];
        let min = (nearest * low).min(furthest * low);
        let max = (nearest * high).max(furthest * high);
        let steepest = max.max(-min);
        let radius = projected_radius(camera, steepest, self.min.z, margin) + reach;
        PlaneBox {
            min: camera.focal * min + camera.center - radius,
            max: camera.focal * max + camera.center + radius,
        }
    }
}

/// What moves boxes: a transform, and how far it stretches lengths along each axis.
pub struct BoxMover {
    transform: DAffine3,
    /// The transform's linear part without signs.
    stretch: DMat3,
}

impl BoxMover {
    /// Moves boxes by a transform.
    pub fn new(transform: DAffine3) -> Self {
        Self {
            transform,
            stretch: transform.matrix3.abs(),
        }
    }

    /// The smallest box along the axes around a moved one, which is not empty.
    #[inline]
    pub fn around(&self, own: &AxisBox) -> AxisBox {
        let center = self.transform.transform_point3(0.5 * (own.min + own.max));
        let half = self.stretch * (0.5 * (own.max - own.min));
        AxisBox {
            min: center - half,
            max: center + half,
        }
    }

    /// The corners of a moved box.
    pub fn corners(&self, own: AxisBox) -> impl Iterator<Item = DVec3> {
        own.corners()
            .map(|corner| self.transform.transform_point3(corner))
    }
}
