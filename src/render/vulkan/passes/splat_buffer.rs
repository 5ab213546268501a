//! The buffer that the stages of a frame share: splats, their keys and the sort's counts, and the pose
//! cache. There is no cache until a frame stores something; `shaders/project/pose_cache.glsl` has the
//! words of a Gaussian.

use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Replacement, Slice},
    sort::counts_size,
};
use ash::vk;
use effigy_core::{
    frame::{CullReasons, DEPTH_KEYS, RendererOptions, SortVariant, capacity::Capacity},
    layout::FrameBlock,
};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// The capacity is a multiple of this many Gaussians: pipelines are compiled for the capacity, and
/// avatars of about one size share them.
const CAPACITY_STEP: u32 = 4096;

/// Splats, keys, the sort's counts, reasons, and the pose cache once there is one.
pub struct SplatBuffer {
    layout: SplatBufferLayout,
    buffer: Buffer,
    /// Whether frames count why Gaussians are culled.
    counted: bool,
    has_cache: bool,
}

/// Where the parts of the splats' buffer are, bytes. Every start is a multiple of 256, the largest
/// alignment of a storage buffer's offset that a device may ask for.
#[derive(Clone, Copy)]
struct SplatBufferLayout {
    /// The capacity, Gaussians: those of all avatars.
    count: u64,
    /// Where the sort's counts start, and their length.
    counts: [u64; 2],
    /// Where reasons are counted.
    reasons: u64,
    /// Where the posed Gaussians start: the end while there is no cache.
    posed: u64,
    /// Words of one of them.
    cache_words: u32,
}

impl SplatBufferLayout {
    fn new(count: u32, variant: SortVariant, cache_words: u32) -> Self {
        let start = (key_offset(count) + DEPTH_KEYS.bytes(u64::from(count))).next_multiple_of(256);
        let counts = counts_size(count, variant);
        let reasons = (start + counts).next_multiple_of(256);
        Self {
            count: u64::from(count),
            counts: [start, counts],
            reasons,
            posed: reasons + 256,
            cache_words,
        }
    }

    /// Bytes of the buffer with a pose cache.
    fn with_cache(&self) -> u64 {
        self.posed + 4 * u64::from(self.cache_words) * self.count
    }
}

impl SplatBuffer {
    /// For so many Gaussians, at most. `cache_words`: of a Gaussian in the pose cache.
    pub fn new(
        gpu: &Arc<Gpu>,
        variant: SortVariant,
        options: &RendererOptions,
        capacity: Capacity,
        cache_words: u32,
    ) -> Result<Self> {
        let capacity =
            capacity.gaussians.saturating_add(CAPACITY_STEP - 1) / CAPACITY_STEP * CAPACITY_STEP;
        let layout = SplatBufferLayout::new(capacity, variant, cache_words);
        Ok(Self {
            buffer: splat_buffer(gpu, layout.posed)?,
            layout,
            counted: options.count,
            has_cache: false,
        })
    }

    /// Whether there is memory for the pose cache.
    pub fn has_cache(&self) -> bool {
        self.has_cache
    }

    /// Makes room for the pose cache in another buffer, for who binds the one before to bind in its
    /// place. On failure all stays as it is.
    ///
    /// # Safety
    /// No submitted work may use the buffer. What binds it must bind the new one before it is used
    /// again.
    pub unsafe fn make_cache(&mut self, gpu: &Arc<Gpu>) -> Result<Replacement> {
        let buffer = splat_buffer(gpu, self.layout.with_cache())?;
        let replacement = Replacement {
            old: (&self.buffer).into(),
            new: (&buffer).into(),
        };
        self.buffer = buffer;
        self.has_cache = true;
        Ok(replacement)
    }

    /// The specialization constants that count reasons: whether to, and the first word.
    pub fn counting(&self) -> [u32; 2] {
        if self.counted {
            [1, (self.layout.reasons / 4) as u32]
        } else {
            [0, 0]
        }
    }

    /// Writes to a frame's block where the avatar's pose cache starts. `first`: its place among
    /// those of all avatars, Gaussians.
    pub fn fill_instance(&self, block: &mut FrameBlock, first: u32) {
        block.cache_start = (self.layout.posed / 4) as u32 + self.layout.cache_words * first;
    }

    /// Writes to a frame's block where the buffers of all avatars start.
    pub fn fill(&self, block: &mut FrameBlock) {
        block.key_start = (key_offset(self.capacity()) / 4) as u32;
        block.count_start = (self.layout.counts[0] / 4) as u32;
    }

    /// The most Gaussians of all avatars together.
    pub fn capacity(&self) -> u32 {
        self.layout.count as u32
    }

    /// The whole buffer: splats, keys, the sort's counts, reasons, and the pose cache once there is
    /// one.
    pub fn whole_buffer(&self) -> Slice {
        (&self.buffer).into()
    }

    /// A key a Gaussian, larger is nearer; `layout::SORT_CULLED` for those that were culled.
    pub fn keys(&self) -> Slice {
        let SplatBufferLayout { count, .. } = self.layout;
        Slice {
            buffer: self.buffer.raw(),
            offset: key_offset(count as u32),
            size: DEPTH_KEYS.bytes(count).max(4),
        }
    }

    /// Where this stage counts the keys' lowest digits for the sort.
    pub fn counts(&self) -> Slice {
        let [offset, size] = self.layout.counts;
        Slice {
            buffer: self.buffer.raw(),
            offset,
            size,
        }
    }

    /// How many Gaussians the last frame culled for each reason, where they are counted:
    /// [`CullReasons::BYTES`].
    pub fn reasons(&self) -> Option<Slice> {
        self.counted.then_some(Slice {
            buffer: self.buffer.raw(),
            offset: self.layout.reasons,
            size: CullReasons::BYTES,
        })
    }

    /// Zeroes those counts: a transfer.
    pub fn clear(&self, commands: Recording) {
        if let Some(reasons) = self.reasons() {
            // SAFETY: the part lies in the buffer, which is alive.
            unsafe { commands.clear(reasons) };
        }
    }

    /// The first `count` splats and keys as they are, for tests. Culled splats hold what an earlier
    /// frame left.
    pub fn download(&self, count: u32) -> Result<(Vec<[u32; 4]>, Vec<u32>)> {
        let keys = self.keys();
        let count = (count as usize).min(self.layout.count as usize);
        let bytes = self.buffer.download((keys.offset + keys.size) as usize)?;
        let splats = bytemuck::pod_collect_to_vec(&bytes[..16 * count]);
        let keys = bytemuck::pod_collect_to_vec(&bytes[keys.offset as usize..][..4 * count]);
        Ok((splats, keys))
    }
}

fn splat_buffer(gpu: &Arc<Gpu>, size: u64) -> Result<Buffer> {
    let usage = vk::BufferUsageFlags::STORAGE_BUFFER
        | vk::BufferUsageFlags::TRANSFER_SRC
        | vk::BufferUsageFlags::TRANSFER_DST;
    Buffer::new(gpu, "splats", size, usage, MemoryLocation::GpuOnly)
}

/// Where the keys of `count` Gaussians start, in bytes.
pub fn key_offset(count: u32) -> u64 {
    (16 * u64::from(count)).next_multiple_of(256)
}
