//! Where the depth surface lies in the picture.

use crate::layout::{Frame, SURFACE_DRAWN, SURFACE_FINEST};
use glam::{DVec2, UVec2, Vec2};

/// Which part of the picture the depth surface covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    picture: DVec2,
    origin: DVec2,
    /// Drawn texels in a pixel, at most 1.
    scale: DVec2,
}

impl Place {
    /// Covers a box of a picture: lower and upper corner, px.
    pub fn new(picture: [u32; 2], [min, max]: [UVec2; 2]) -> Self {
        let drawn = f64::from(SURFACE_DRAWN);
        let scale = (drawn / (max - min).max(UVec2::ONE).as_dvec2()).min(DVec2::ONE);
        Self { picture: UVec2::from(picture).as_dvec2(), origin: min.as_dvec2(), scale }
    }

    /// Tells `splats` where to look.
    pub fn write(&self, frame: &mut Frame) {
        frame.surface_origin = self.origin.as_vec2().to_array();
        frame.surface_scale = (self.scale * f64::from(SURFACE_FINEST) / f64::from(SURFACE_DRAWN)).as_vec2().to_array();
    }

    /// The upper left corner and the size of the viewport that it is drawn with, texels.
    pub fn viewport(&self) -> [Vec2; 2] {
        [(-self.origin * self.scale).as_vec2(), (self.picture * self.scale).as_vec2()]
    }
}
