//! The `splats` stage: from a Gaussian of the model to a splat on the screen and its depth key (model.md, steps 2 and 4 to 8).

use super::{
    device::Gpu,
    error::Result,
    memory::Buffer,
    model::Model,
    pipeline::{Bindings, Kernel, Slice},
    shaders,
};
use crate::layout::SPLATS_SIZE;
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

pub struct Splats {
    kernel: Kernel,
    groups: u32,
    count: u32,
    /// 16 bytes a Gaussian, then a key of four bytes a Gaussian.
    buffer: Buffer,
}

impl Splats {
    pub fn new(gpu: &Arc<Gpu>, model: &Model, frame: Slice, pose: Slice) -> Result<Self> {
        let count = model.constants.gaussians;
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC;
        // The keys start at a multiple of 256 bytes, the largest alignment of a storage buffer's offset that a device may ask for.
        let buffer = Buffer::new(gpu, "splats", key_offset(count) + 4 * u64::from(count), usage, MemoryLocation::GpuOnly)?;
        let storage = [(&model.gaussians).into(), (&model.rows).into(), pose, (&buffer).into()];
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), &storage)?;
        Ok(Self { kernel: Kernel::new(gpu, &shaders::SPLATS, &[], bindings)?, groups: count.div_ceil(SPLATS_SIZE), count, buffer })
    }

    /// 16 bytes a Gaussian, in the avatar's order; those that were culled hold what an earlier frame left.
    pub fn splats(&self) -> Slice {
        Slice { buffer: self.buffer.raw, offset: 0, size: (16 * u64::from(self.count)).max(16) }
    }

    /// Splats, then the keys.
    pub fn all(&self) -> Slice {
        (&self.buffer).into()
    }

    /// A 32-bit key a Gaussian, larger is nearer; `SORT_DROPPED` for those that were culled.
    pub fn keys(&self) -> Slice {
        Slice { buffer: self.buffer.raw, offset: key_offset(self.count), size: (4 * u64::from(self.count)).max(4) }
    }

    /// Splats and keys as they are, for tests.
    pub fn download(&self) -> Result<(Vec<[u32; 4]>, Vec<u32>)> {
        let bytes = self.buffer.download((key_offset(self.count) + 4 * u64::from(self.count)) as usize)?;
        let splats = bytemuck::pod_collect_to_vec(&bytes[..16 * self.count as usize]);
        Ok((splats, bytemuck::pod_collect_to_vec(&bytes[key_offset(self.count) as usize..])))
    }

    /// Reads what `nodes` and `features` wrote; compute.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32) {
        self.kernel.dispatch(commands, frame, self.groups);
    }
}

/// Where the keys of `count` Gaussians start, in bytes.
pub fn key_offset(count: u32) -> u64 {
    (16 * u64::from(count)).next_multiple_of(256)
}
