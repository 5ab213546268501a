//! What the stages before leave for this one.

use super::super::buffer::Slice;

/// Order, splats with their keys, and control as the stages before leave them.
#[derive(Clone, Copy)]
pub struct RasterInputs<'a> {
    /// Indices of splats in drawing order.
    pub order: Slice<'a>,
    /// Splats, one a Gaussian, then the keys.
    pub splats: Slice<'a>,
    /// A depth key for each splat.
    pub keys: Slice<'a>,
    /// Holds the number of visible splats, and the arguments of the draw.
    pub control: &'a wgpu::Buffer,
    /// The most splats that the buffers hold.
    pub capacity: u32,
}
