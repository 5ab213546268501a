//! A loss of two pictures on a device: what runs, from the pictures to the derivative.

use super::convolution::DeviceConvolution;
use super::operation::Operation;
use effigy_render::vulkan::compute::{Buffer, Slice};

/// What a loss makes of colours of 0 to 1: multiplies each channel, and takes something away.
#[derive(Clone, Copy)]
pub(super) struct ColorScale {
    pub factor: [f32; 3],
    pub offset: [f32; 3],
}

/// A loss of two pictures: what runs, one after the other, and what it reads and writes.
pub(super) struct LossSteps {
    // Operations go before what they are bound to.
    pub operations: Vec<Operation>,
    /// A picture, and its target. Shape: 2 · 3 · height · width.
    pub pair: Slice,
    /// The derivative with respect to the picture. Shape: 3 · height · width.
    pub gradient: Slice,
    /// Numbers that add up to the loss.
    pub sums: Buffer,
    pub sum_count: usize,
    pub color: ColorScale,
    /// What operations are bound to.
    pub _buffers: Vec<Buffer>,
    pub _convolutions: Vec<DeviceConvolution>,
}
