//! The stages that all people of a frame share, and their buffers: made for a capacity, and made anew
//! where a scene needs more.

use super::blocks::BlockRing;
use crate::vulkan::{
    commands::{control::control, frame_in_flight::CountSources},
    device::{error::Result, gpu::Gpu},
    memory::{Buffer, Replacement},
    passes::splat_buffer::SplatBuffer,
    pipeline::FrameMemory,
    raster::{Raster, draw::RasterInputs},
    sort::{self, Sort, SortOptions},
};
use ash::vk;
use bytemuck::bytes_of;
use effigy_core::frame::{DEPTH_KEYS, RendererOptions, block::SharedSizes, resource::Resource};
use std::sync::Arc;

/// Stages and buffers that all people share.
pub(super) struct SharedStages {
    pub splats: SplatBuffer,
    pub sort: Sort,
    pub raster: Raster,
    pub control: Buffer,
    /// Features, then node displacements, of one person after the other; then a vector of zeros.
    pub pose: Buffer,
    /// A block for each person of each frame under way.
    pub blocks: BlockRing,
    /// What the kernels of avatars bind of all this.
    pub memory: FrameMemory,
    pub sizes: SharedSizes,
}

impl SharedStages {
    /// For frames of these sizes. `before`: the stages that these come in place of, whose image
    /// stays.
    pub fn new(
        gpu: &Arc<Gpu>,
        options: &RendererOptions,
        sizes: SharedSizes,
        before: Option<&Self>,
    ) -> Result<Self> {
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC;
        // The last vector stays zero.
        let zeros = vec![0; 16 * sizes.pose_layout().total() as usize];
        let pose = Buffer::with_data(gpu, "pose", &zeros, storage)?;
        let blocks = BlockRing::new(gpu, options.instances)?;
        let control = Buffer::with_data(
            gpu,
            "control",
            bytes_of(&control(0)),
            storage | vk::BufferUsageFlags::INDIRECT_BUFFER,
        )?;
        let variant = sort::choice::allowed(gpu, options.sort)?;
        let SharedSizes {
            capacity,
            cache_words,
            ..
        } = sizes;
        let splats = SplatBuffer::new(gpu, variant, options, capacity, cache_words)?;
        let sort_options = SortOptions {
            counts: Some(splats.counts()),
            ..SortOptions::new(DEPTH_KEYS, variant)
        };
        let max_keys = splats.capacity();
        // SAFETY: the renderer owns these buffers, and drops them after its frames.
        let sort = unsafe { Sort::new(gpu, splats.keys(), &control, max_keys, sort_options) }?;
        let memory = FrameMemory::new(blocks.slice())
            .with(Resource::Pose, &pose)
            .with(Resource::Splats, splats.whole_buffer());
        let inputs = RasterInputs {
            memory: memory
                .with(Resource::Order, sort.order())
                .with(Resource::Control, &control),
            capacity: max_keys,
            sort: variant,
        };
        Ok(Self {
            raster: match before {
                Some(before) => before.raster.rebound(&inputs, options)?,
                None => Raster::new(gpu, &inputs, options)?,
            },
            splats,
            sort,
            control,
            pose,
            blocks,
            memory,
            sizes,
        })
    }

    /// Binds the one buffer of splats in place of the other.
    ///
    /// # Safety
    /// No submitted work may use the stages, and the new buffer must outlive what will, and be laid
    /// out as the old one.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        self.memory.replace(replacement);
        // SAFETY: the caller promises what the functions ask for.
        unsafe {
            self.sort.replace(replacement);
            self.raster.replace(replacement);
        }
    }

    /// Where frames leave their counts.
    pub fn count_sources(&self) -> CountSources {
        CountSources {
            control: (&self.control).into(),
            reasons: self.splats.reasons(),
            list_blocks: self.raster.list_blocks(),
        }
    }
}
