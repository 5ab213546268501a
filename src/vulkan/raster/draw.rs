//! Inputs of both raster methods.

use crate::vulkan::{memory::Slice, passes::model::OccluderMesh};
use ash::vk;
use effigy_core::frame::Damage;

/// Inputs of the stage.
pub struct RasterInputs<'a> {
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
    /// The occluder mesh, against which quads test fragments.
    pub occluder: &'a OccluderMesh,
    /// Output of the `mlp` stage: the occluder's corners follow its nodes.
    pub pose: Slice,
}

/// The draw of a frame.
pub struct Draw<'a> {
    /// Where in the ring of blocks the one with the image's size is, bytes.
    pub frame: u32,
    /// Offsets in the ring, bytes, of the blocks of avatars whose occluder is drawn first, where
    /// fragments are tested against it. Empty draws none.
    pub occluders: &'a [u32],
    /// The control: holds the arguments of the indirect draw.
    pub control: vk::Buffer,
    /// The rectangle to draw.
    pub damage: &'a Damage,
    /// Whether to count fragments.
    pub count: bool,
}
