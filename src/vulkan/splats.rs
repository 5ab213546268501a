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

/// Bytes behind the keys: how many Gaussians were left out for each reason (`shaders/left_out.glsl`).
pub const REASONS: u64 = 16;

pub struct Splats {
    gpu: Arc<Gpu>,
    kernel: Kernel,
    groups: u32,
    /// Gaussians that there is room for: those of all avatars.
    count: u32,
    counted: bool,
    /// 16 bytes a Gaussian, then a key of four bytes a Gaussian, then the reasons.
    buffer: Buffer,
}

impl Splats {
    /// For `actors` copies of the model; `counted`: whether to count why Gaussians are left out.
    pub fn new(gpu: &Arc<Gpu>, model: &Model, (frame, pose): (Slice, Slice), actors: u32, counted: bool) -> Result<Self> {
        let count = actors * model.constants.gaussians;
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
        // The keys start at a multiple of 256 bytes, the largest alignment of a storage buffer's offset that a device may ask for.
        let buffer = Buffer::new(gpu, "splats", reasons_at(count) + REASONS, usage, MemoryLocation::GpuOnly)?;
        let storage = [(&model.gaussians).into(), (&model.rows).into(), pose, (&buffer).into()];
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), &storage)?;
        let constants = [u32::from(counted), (reasons_at(count) / 4) as u32];
        let kernel = Kernel::new(gpu, &shaders::SPLATS, &constants, bindings)?;
        let groups = model.constants.gaussians.div_ceil(SPLATS_SIZE);
        Ok(Self { gpu: gpu.clone(), kernel, groups, count, counted, buffer })
    }

    /// 16 bytes a Gaussian, in each avatar's order; those that were culled hold what an earlier frame left.
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

    /// How many Gaussians the last frame left out for each reason, where they are counted: [`REASONS`] bytes.
    pub fn reasons(&self) -> Option<Slice> {
        self.counted.then_some(Slice { buffer: self.buffer.raw, offset: reasons_at(self.count), size: REASONS })
    }

    /// Zeroes those counts: a transfer.
    pub fn clear(&self, commands: vk::CommandBuffer) {
        if let Some(reasons) = self.reasons() {
            // SAFETY: the command buffer is recording; the range lies in the buffer, which is alive.
            unsafe { self.gpu.raw.cmd_fill_buffer(commands, reasons.buffer, reasons.offset, reasons.size, 0) };
        }
    }

    /// The first `count` splats and keys as they are, for tests.
    pub fn download(&self, count: u32) -> Result<(Vec<[u32; 4]>, Vec<u32>)> {
        let bytes = self.buffer.download(reasons_at(self.count) as usize)?;
        let (splats, keys) = bytes.split_at(key_offset(self.count) as usize);
        let count = count.min(self.count) as usize;
        Ok((bytemuck::pod_collect_to_vec(&splats[..16 * count]), bytemuck::pod_collect_to_vec(&keys[..4 * count])))
    }

    /// One avatar's. Reads what `nodes` and `features` wrote; compute.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32) {
        self.kernel.dispatch(commands, frame, self.groups);
    }
}

/// Where what counts reasons starts, in bytes.
fn reasons_at(count: u32) -> u64 {
    key_offset(count) + 4 * u64::from(count)
}

/// Where the keys of `count` Gaussians start, in bytes.
pub fn key_offset(count: u32) -> u64 {
    (16 * u64::from(count)).next_multiple_of(256)
}
