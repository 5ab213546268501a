//! The buffers that the stages of a frame share: splats, their keys and the pose cache, and what
//! atomics add to.

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::Result,
    owned::Buffer,
    sort,
};
use effigy_core::{
    frame::{CullReasons, DEPTH_KEYS, RendererOptions, Skip, capacity::Capacity},
    layout::FrameBlock,
};

/// Where in the counts those of the sort start, bytes.
const COUNTS_AT: u64 = 256;

/// Splats, keys and pose cache, and counts.
pub struct SplatBuffer {
    /// The capacity, Gaussians: those of all avatars.
    capacity: u32,
    cache_start: u32,
    /// Words of a Gaussian in the pose cache.
    cache_words: u32,
    /// Splats, keys, and the pose cache.
    buffer: Buffer,
    /// Reasons, then the sort's counts: all that atomics add to.
    counts: Buffer,
}

impl SplatBuffer {
    /// For so many Gaussians. `cache_words`: of one of them in the pose cache, for which there is
    /// room where frames in which only the camera moves use it.
    pub fn new(
        gpu: &Gpu,
        options: &RendererOptions,
        capacity: Capacity,
        cache_words: u32,
    ) -> Result<Self> {
        let capacity = capacity.gaussians;
        let keys = DEPTH_KEYS.bytes(u64::from(capacity));
        let posed = (key_offset(capacity) + keys).next_multiple_of(256);
        let cache = if options.skip.contains(Skip::SKINNING) {
            4 * u64::from(cache_words) * u64::from(capacity)
        } else {
            0
        };
        let counts = COUNTS_AT + sort::counts_size(capacity, sort::variant(options));
        Ok(Self {
            buffer: empty(gpu, "splats", posed + cache, STORAGE)?,
            counts: empty(gpu, "counts", counts, STORAGE)?,
            capacity,
            cache_start: (posed / 4) as u32,
            cache_words,
        })
    }

    /// Reasons, then the sort's counts.
    pub fn all_counts(&self) -> Slice<'_> {
        (&self.counts).into()
    }

    /// The most Gaussians of all avatars together.
    pub fn capacity(&self) -> u32 {
        self.capacity
    }

    /// Writes to a frame's block where the avatar's pose cache starts. `first`: its place among
    /// those of all avatars, Gaussians.
    pub fn fill_instance(&self, block: &mut FrameBlock, first: u32) {
        block.cache_start = self.cache_start + self.cache_words * first;
    }

    /// Writes to a frame's block where the buffers of all avatars start.
    pub fn fill(&self, block: &mut FrameBlock) {
        block.key_start = (key_offset(self.capacity) / 4) as u32;
        block.count_start = (COUNTS_AT / 4) as u32;
    }

    /// Splats, then the keys, then more.
    pub fn all(&self) -> Slice<'_> {
        (&self.buffer).into()
    }

    /// A key a Gaussian, larger is nearer.
    pub fn keys(&self) -> Slice<'_> {
        Slice {
            buffer: &self.buffer,
            offset: key_offset(self.capacity),
            size: DEPTH_KEYS.bytes(u64::from(self.capacity)).max(4),
        }
    }

    /// Where this stage counts the keys' lowest digits for the sort.
    pub fn counts(&self) -> Slice<'_> {
        Slice {
            buffer: &self.counts,
            offset: COUNTS_AT,
            size: self.counts.size() - COUNTS_AT,
        }
    }

    /// How many Gaussians were culled for each reason: [`CullReasons::BYTES`].
    pub fn reasons(&self) -> Slice<'_> {
        Slice {
            buffer: &self.counts,
            offset: 0,
            size: CullReasons::BYTES,
        }
    }

    /// Zeroes what this stage adds to.
    pub fn clear(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(
            &self.counts,
            0,
            Some(COUNTS_AT + sort::first_counts_size(self.capacity)),
        );
    }
}

/// Where the keys of `count` Gaussians start, in bytes.
fn key_offset(count: u32) -> u64 {
    (16 * u64::from(count)).next_multiple_of(256)
}
