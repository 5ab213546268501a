//! The `splats` stage: from a Gaussian of the model to a splat on the screen and its depth key (model.md, steps 2 and 4 to 8).
//!
//! Where the camera alone moves, what it can't change is kept: the first such frame writes it, in the space of its own camera, and those
//! after it only project. `shaders/posed.glsl` has the 20 bytes a Gaussian.

use super::{
    RendererOptions,
    device::Gpu,
    error::Result,
    memory::Buffer,
    model::Model,
    pipeline::{Bindings, Kernel, Slice},
    shaders,
    sort::{KeyBits, Variant, counts_size},
};
use crate::{
    frame::{Body, scene::slots},
    layout::{Frame, POSED_WORDS, SORT_DROPPED, SPLATS_SIZE},
};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// Bytes of what counts the Gaussians left out for each reason (`shaders/left_out.glsl`).
pub const REASONS: u64 = 16;
/// There is room for a multiple of so many Gaussians: pipelines are compiled for that number, and avatars of about one size share them.
const ROOM: u32 = 4096;

pub struct Splats {
    gpu: Arc<Gpu>,
    computing: Kernel,
    /// Computes and keeps; draws what was kept. None where nothing is kept.
    keeping: Option<[Kernel; 2]>,
    counted: bool,
    areas: Areas,
    buffer: Buffer,
}

/// Where things are in the splats' buffer, bytes. Every start is a multiple of 256, the largest alignment of a storage buffer's offset
/// that a device may ask for.
#[derive(Clone, Copy)]
struct Areas {
    /// Gaussians that there is room for: those of all avatars.
    count: u64,
    bits: KeyBits,
    /// Where the sort's counts start, and their length.
    counts: [u64; 2],
    /// Where reasons are counted.
    reasons: u64,
    /// Where the posed Gaussians start.
    posed: u64,
}

impl Areas {
    fn new(count: u32, bits: KeyBits, variant: Variant) -> Self {
        let start = (key_offset(count) + bits.bytes(u64::from(count))).next_multiple_of(256);
        let counts = counts_size(count, variant);
        let reasons = (start + counts).next_multiple_of(256);
        Self { count: u64::from(count), bits, counts: [start, counts], reasons, posed: reasons + 256 }
    }
}

impl Splats {
    /// `keep`: whether frames in which only the camera moved shall find what it can't change.
    pub fn new(
        gpu: &Arc<Gpu>,
        model: &Model,
        (frame, pose): (Slice, Slice),
        variant: Variant,
        (options, keep): (&RendererOptions, bool),
    ) -> Result<Self> {
        let count = model.constants.gaussians;
        let capacity = (options.actors as u32 * slots(count)).next_multiple_of(ROOM);
        let areas = Areas::new(capacity, options.key_bits, variant);
        let counting = if options.count { [1, (areas.reasons / 4) as u32] } else { [0, 0] };
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
        let size = areas.posed + if keep { 4 * u64::from(POSED_WORDS) * areas.count } else { 0 };
        let buffer = Buffer::new(gpu, "splats", size, usage, MemoryLocation::GpuOnly)?;
        let kernel = |module, constants: &[u32], storage: &[Slice]| {
            let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), storage)?;
            Kernel::new(gpu, module, &[constants, &counting[..]].concat(), bindings)
        };
        let all = [(&model.gaussians).into(), (&model.rows).into(), pose, (&buffer).into()];
        let keeping = || -> Result<_> { Ok([kernel(&shaders::SPLATS, &[1], &all)?, kernel(&shaders::SPLATS_POSED, &[0], &all[2..])?]) };
        Ok(Self {
            gpu: gpu.clone(),
            computing: kernel(&shaders::SPLATS, &[0], &all)?,
            keeping: keep.then(keeping).transpose()?,
            counted: options.count,
            areas,
            buffer,
        })
    }

    /// Says in a frame's block where what is kept of an avatar is, by its place in the renderer.
    pub fn fill_actor(&self, block: &mut Frame, number: u32) {
        block.posed_start = (self.areas.posed / 4) as u32 + number * POSED_WORDS * block.gaussians;
    }

    /// Says in a frame's block where things are that are all avatars'.
    pub fn fill(&self, block: &mut Frame) {
        block.key_start = (key_offset(self.capacity()) / 4) as u32;
        block.half_keys = u32::from(self.areas.bits.halves());
        block.count_start = (self.areas.counts[0] / 4) as u32;
    }

    /// Splats that there is room for.
    pub fn capacity(&self) -> u32 {
        self.areas.count as u32
    }

    /// Splats, then the keys, then more.
    pub fn all(&self) -> Slice {
        (&self.buffer).into()
    }

    /// A key a Gaussian, larger is nearer; `SORT_DROPPED` for those that were culled.
    pub fn keys(&self) -> Slice {
        let Areas { count, bits, .. } = self.areas;
        Slice { buffer: self.buffer.raw, offset: key_offset(count as u32), size: bits.bytes(count).max(4) }
    }

    /// Where the sort counts, so that this stage can do it.
    pub fn counts(&self) -> Slice {
        let [offset, size] = self.areas.counts;
        Slice { buffer: self.buffer.raw, offset, size }
    }

    /// How many Gaussians the last frame left out for each reason, where they are counted: [`REASONS`] bytes.
    pub fn reasons(&self) -> Option<Slice> {
        self.counted.then_some(Slice { buffer: self.buffer.raw, offset: self.areas.reasons, size: REASONS })
    }

    /// Zeroes those counts: a transfer.
    pub fn clear(&self, commands: vk::CommandBuffer) {
        if let Some(reasons) = self.reasons() {
            // SAFETY: the command buffer is recording; the range lies in the buffer, which is alive.
            unsafe { self.gpu.raw.cmd_fill_buffer(commands, reasons.buffer, reasons.offset, reasons.size, 0) };
        }
    }

    /// The first `count` splats and keys as they are, for tests. Splats that were culled hold what an earlier frame left.
    pub fn download(&self, count: u32) -> Result<(Vec<[u32; 4]>, Vec<u32>)> {
        let (keys, count) = (self.keys(), (count as usize).min(self.areas.count as usize));
        let bytes = self.buffer.download((keys.offset + keys.size) as usize)?;
        let splats = bytemuck::pod_collect_to_vec(&bytes[..16 * count]);
        let keys = &bytes[keys.offset as usize..];
        let keys = if self.areas.bits.halves() {
            let halves: Vec<u16> = bytemuck::pod_collect_to_vec(keys);
            halves[..count].iter().map(|&key| if key == u16::MAX { SORT_DROPPED } else { u32::from(key) }).collect()
        } else {
            bytemuck::pod_collect_to_vec(&keys[..4 * count])
        };
        Ok((splats, keys))
    }

    /// One avatar's, of which so many Gaussians are drawn. Reads what `features` wrote, and counts what [`super::sort::Sort::clear`] has cleared; compute.
    pub fn record(&self, commands: vk::CommandBuffer, (frame, drawn): (u32, u32), body: Body) {
        let kernel = match (body, &self.keeping) {
            (Body::Keep, Some([keep, _])) => keep,
            (Body::Kept, Some([_, kept])) => kept,
            _ => &self.computing,
        };
        kernel.dispatch(commands, frame, drawn.div_ceil(SPLATS_SIZE));
    }
}

/// Where the keys of `count` Gaussians start, in bytes.
pub fn key_offset(count: u32) -> u64 {
    (16 * u64::from(count)).next_multiple_of(256)
}
