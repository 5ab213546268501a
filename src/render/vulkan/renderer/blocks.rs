//! The uniform blocks of frames under way: one a person.

use super::held::HeldAvatar;
use crate::vulkan::{
    commands::FRAMES_IN_FLIGHT,
    device::{error::Result, gpu::Gpu},
    memory::{Buffer, Slice},
    passes::splat_buffer::SplatBuffer,
    sort::Sort,
};
use ash::vk;
use bytemuck::from_bytes_mut;
use effigy_core::{
    frame::{
        ByAvatar, RendererOptions, Skinning,
        block::{self, PoseLayout},
        pose_cache::PoseCache,
        state::{AvatarInstance, FramePlan, Layer},
    },
    layout::FrameBlock,
    scene::Camera,
};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// Bytes from one frame's uniform block to the next: every device's alignment divides 256.
const STRIDE: usize = size_of::<FrameBlock>().next_multiple_of(256);

/// A ring of uniform blocks, and the pose cache of each person.
pub(super) struct BlockRing {
    buffer: Buffer,
    instances: usize,
    /// One an avatar.
    pose_caches: Vec<PoseCache>,
}

/// Where a frame's values come from.
pub(super) struct BlockSources<'a> {
    pub avatars: &'a ByAvatar<HeldAvatar>,
    pub options: &'a RendererOptions,
    pub pose: PoseLayout,
    pub splats: &'a SplatBuffer,
    pub sort: &'a Sort,
}

impl BlockRing {
    /// For so many people a frame.
    pub fn new(gpu: &Arc<Gpu>, instances: usize) -> Result<Self> {
        // One more for an image without avatars.
        let count = FRAMES_IN_FLIGHT * (instances + 1);
        let mut buffer = Buffer::new(
            gpu,
            "frames",
            (count * STRIDE) as u64,
            vk::BufferUsageFlags::UNIFORM_BUFFER,
            MemoryLocation::CpuToGpu,
        )?;
        buffer.mapped().fill(0);
        Ok(Self {
            buffer,
            instances,
            pose_caches: (0..instances).map(|_| PoseCache::default()).collect(),
        })
    }

    /// No cached pose holds any more.
    pub fn forget_poses(&mut self) {
        self.pose_caches.fill_with(PoseCache::default);
    }

    /// The first block. Kernels bind it with a dynamic offset, which selects another.
    pub fn slice(&self) -> Slice {
        Slice {
            size: size_of::<FrameBlock>() as u64,
            ..(&self.buffer).into()
        }
    }

    /// Where in the ring an avatar's block is, bytes. `frame`: index of the frame in flight.
    /// `number`: the avatar's place in the renderer.
    pub fn offset(&self, frame: usize, number: usize) -> usize {
        (frame * (self.instances + 1) + number) * STRIDE
    }

    /// Where in the ring the block of a layer's image is, bytes: its first avatar's, or one of its
    /// own. `frame`: index of the frame in flight.
    pub fn of_layer(&self, frame: usize, layer: &Layer) -> u32 {
        let first = layer.instances.first();
        self.offset(
            frame,
            first.map_or(self.instances, |instance| instance.index),
        ) as u32
    }

    /// Fills the blocks of a frame. `frame`: index of the frame in flight.
    pub fn write(
        &mut self,
        frame: usize,
        plan: &FramePlan,
        camera: &Camera,
        sources: &BlockSources,
    ) {
        for instance in plan.instances() {
            if plan.redraw
                && instance.changes.skinning == Skinning::ComputeAndStore
                && let Some(held) = sources.avatars.get(instance.avatar)
            {
                self.pose_caches[instance.index] =
                    PoseCache::new(&held.traits.bounds, instance.posed, camera);
            }
        }
        for layer in plan.layers() {
            for instance in &layer.instances {
                self.fill(frame, Some(instance), layer, camera, sources);
            }
        }
        if plan.image.instances.is_empty() {
            self.fill(frame, None, &plan.image, camera, sources);
        }
    }

    fn fill(
        &mut self,
        frame: usize,
        instance: Option<&AvatarInstance>,
        layer: &Layer,
        camera: &Camera,
        sources: &BlockSources,
    ) {
        let number = instance.map_or(self.instances, |instance| instance.index);
        let start = self.offset(frame, number);
        let bytes = &mut self.buffer.mapped()[start..][..size_of::<FrameBlock>()];
        let block: &mut FrameBlock = from_bytes_mut(bytes);
        if let Some(instance) = instance
            && let Some(held) = sources.avatars.get(instance.avatar)
        {
            block::write_constants(block, &held.model.sets[instance.model].constants);
        }
        block::write_shared(block, sources.options, layer, camera);
        sources.splats.fill(block);
        block.count_tile = sources.sort.tile();
        if let Some(instance) = instance {
            block::write_instance(block, sources.options, layer, instance, sources.pose);
            sources.splats.fill_instance(block, instance.cache_start);
            self.pose_caches[number].write_to(block, camera);
        }
    }
}
