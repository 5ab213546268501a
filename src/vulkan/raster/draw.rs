//! Inputs of both raster methods.

use crate::vulkan::memory::Slice;
use ash::vk;
use effigy_core::frame::{Damage, SortVariant};

/// Inputs of the stage.
pub struct RasterInputs {
    /// The ring of frame blocks.
    pub frame: Slice,
    /// Indices of splats in drawing order, as the sort leaves them.
    pub order: Slice,
    /// Splats with their keys.
    pub splats: Slice,
    /// The control, as the sort leaves it.
    pub control: Slice,
    /// The most splats that the buffers hold.
    pub capacity: u32,
    /// How pairs of splats and bins are sorted.
    pub sort: SortVariant,
}

/// The draw of a frame.
pub struct Draw<'a> {
    /// Where in the ring of blocks the one with the image's size is, bytes.
    pub frame: u32,
    /// The control: holds the arguments of the indirect draw.
    pub control: vk::Buffer,
    /// The rectangle to draw.
    pub damage: &'a Damage,
    /// Whether to count fragments.
    pub count: bool,
}
