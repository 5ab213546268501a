//! What the stages of one view share.

use super::arrays::{filled, read, words};
use super::block::{MOST_BANDS, STRIDE};
use effigy::vulkan::compute::{
    Buffer, BufferUsageFlags, MemoryLocation, Slice, Sort, SortOptions, without_test,
};
use effigy::vulkan::{Gpu, Result};
use effigy_core::frame::KeyBits;
use effigy_core::layout::Control;
use std::sync::Arc;

/// What a view's stages share, used for one view after the other.
pub(super) struct PerView {
    pub gaussians: u32,
    pub blocks: Buffer,
    pub control: Buffer,
    pub splats: Buffer,
    pub splat_pairs: Buffer,
    pub image: Buffer,
    pub of_image: Buffer,
    pub status: Buffer,
    pub sort: Sort,
    pub canonical: Buffer,
    pub keys: Buffer,
    pub asked: Buffer,
    pub of_skinning: Buffer,
}

impl PerView {
    /// The block of the first band of the first view; others follow at offsets.
    pub fn uniform(&self) -> Slice {
        Slice::from(&self.blocks).part(0, STRIDE)
    }

    pub fn new(gpu: &Arc<Gpu>, gaussians: u32, pixels: usize, views: usize) -> Result<Self> {
        let count = gaussians as usize;
        let keys = words(gpu, "depth keys", count)?;
        let start = Control {
            key_count: gaussians,
            ..Control::default()
        };
        let control = filled(gpu, "control", &[start])?;
        let options = SortOptions::new(KeyBits::ThirtyTwo, without_test(gpu)?);
        // SAFETY: both buffers live as long as the sort, and `Gpu::run` waits for each submission.
        let sort = unsafe { Sort::new(gpu, (&keys).into(), &control, gaussians, options) }?;
        Ok(Self {
            gaussians,
            blocks: Buffer::new(
                gpu,
                "view blocks",
                STRIDE * u64::from(MOST_BANDS) * views as u64,
                BufferUsageFlags::UNIFORM_BUFFER,
                MemoryLocation::CpuToGpu,
            )?,
            control,
            splats: words(gpu, "training splats", 12 * count)?,
            splat_pairs: words(gpu, "splat pairs", 2 * count)?,
            image: words(gpu, "training image", 4 * pixels)?,
            of_image: words(gpu, "image derivative", 4 * pixels)?,
            status: read(gpu, "training status", 4)?,
            sort,
            canonical: words(gpu, "canonical Gaussians", 16 * count)?,
            keys,
            of_skinning: words(gpu, "skinning derivatives", 12 * count)?,
            asked: filled(gpu, "asked of the image", &vec![0.0f32; 4 * pixels])?,
        })
    }
}
