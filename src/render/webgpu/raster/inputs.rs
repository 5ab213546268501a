//! What the stages before leave for this one, and what a layer is drawn with.

use super::super::buffer::Slice;
use effigy_core::frame::{Damage, passes::RenderTarget};

/// Order, splats with their keys, and control as the stages before leave them.
#[derive(Clone, Copy)]
pub struct RasterInputs<'a> {
    /// Indices of splats in drawing order.
    pub order: Slice<'a>,
    /// Splats, one a Gaussian, then the keys.
    pub splats: Slice<'a>,
    /// Holds the number of visible splats, and the arguments of the draw.
    pub control: &'a wgpu::Buffer,
    /// The most splats that the buffers hold.
    pub capacity: u32,
}

/// The draw of a layer.
#[derive(Clone, Copy)]
pub struct Draw<'a> {
    /// The image that it goes into.
    pub target: RenderTarget,
    /// Width and height of what is drawn, in the target's upper left corner, px.
    pub size: [u32; 2],
    /// Where the uniform block with that size is, bytes.
    pub block: u32,
    /// The rectangles to clear and to draw.
    pub damage: &'a Damage,
}
