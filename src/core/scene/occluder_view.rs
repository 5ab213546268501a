//! Which part of the image the occluder pass covers.

use super::PixelRect;
use crate::layout::{FrameBlock, OCCLUDER_SIDE, PYRAMID_SIDE};
use glam::{DVec2, UVec2, Vec2};

/// The part of the image that the occluder pass covers, and at which resolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OccluderView {
    /// Size of the image, px.
    image_size: DVec2,
    /// Upper left corner of what is covered, px.
    origin: DVec2,
    /// Texels of the occluder pass in a pixel, at most 1.
    scale: DVec2,
}

impl OccluderView {
    /// Covers a rectangle of an image of the given size, px.
    pub fn new(image_size: [u32; 2], rect: PixelRect) -> Self {
        let sides = (rect.max - rect.min).max(UVec2::ONE).as_dvec2();
        Self {
            image_size: UVec2::from(image_size).as_dvec2(),
            origin: rect.min.as_dvec2(),
            scale: (f64::from(OCCLUDER_SIDE) / sides).min(DVec2::ONE),
        }
    }

    /// Writes where in the depth pyramid the project stage finds a pixel.
    pub fn write_to(&self, block: &mut FrameBlock) {
        let finest_texels = self.scale * f64::from(PYRAMID_SIDE) / f64::from(OCCLUDER_SIDE);
        block.occluder_origin = self.origin.as_vec2().to_array();
        block.occluder_scale = finest_texels.as_vec2().to_array();
    }

    /// Where in the occluder pass a pixel of the image lies, texels.
    pub fn texel(&self, pixel: DVec2) -> DVec2 {
        (pixel - self.origin) * self.scale
    }

    /// Upper left corner and size of the viewport to draw the occluder with, texels.
    pub fn viewport(&self) -> [Vec2; 2] {
        [
            (-self.origin * self.scale).as_vec2(),
            (self.image_size * self.scale).as_vec2(),
        ]
    }
}
