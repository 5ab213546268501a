//! The `project` stage: from a Gaussian of the model to a splat on the screen and its depth key
//! (model.md, steps 2 and 4 to 8).

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::Result,
    kernel::{Blocks, Bound, Kernel},
    model::Model,
    owned::Buffer,
    sort,
};
use crate::wgsl;
use effigy_core::{
    frame::{CullReasons, DEPTH_KEYS, RendererOptions, Skinning, Skip, capacity::Capacity},
    layout::{FrameBlock, PROJECT_WORKGROUP},
};

/// Where in the counts those of the sort start, bytes.
const COUNTS_AT: u64 = 256;

/// The kernels of frames in which only the camera moves.
struct Caching {
    /// Computes posed Gaussians and stores them.
    store: Kernel,
    /// Projects the stored Gaussians.
    cached: Kernel,
}

/// The `project` stage's kernels and buffers.
pub struct Project {
    compute: Kernel,
    /// None where poses are not cached.
    caching: Option<Caching>,
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

impl Project {
    pub fn new(
        gpu: &Gpu,
        model: &Model,
        blocks: &Blocks,
        pose: &wgpu::Buffer,
        options: &RendererOptions,
        capacity: Capacity,
    ) -> Result<Self> {
        let capacity = capacity.gaussians;
        // Whether frames in which only the camera moves use the pose cache.
        let caches = options.skip.contains(Skip::SKINNING);
        let keys = DEPTH_KEYS.bytes(u64::from(capacity));
        let cache_words = model.constants(0).pose_cache_words();
        let posed = (key_offset(capacity) + keys).next_multiple_of(256);
        let size = posed
            + if caches {
                4 * u64::from(cache_words) * u64::from(capacity)
            } else {
                0
            };
        let buffer = empty(gpu, "splats", size, STORAGE)?;
        let counts = empty(
            gpu,
            "counts",
            COUNTS_AT + sort::counts_size(capacity, sort::variant(options)),
            STORAGE,
        )?;
        let all = model_bindings(model, 0, blocks, pose, [&buffer, &counts]);
        let cached = [
            (1, Bound::Write((&buffer).into())),
            (6, Bound::Write((&counts).into())),
            blocks.frame(),
            blocks.settings(),
        ];
        let caching = || Caching {
            store: Kernel::when_needed(gpu, &wgsl::PROJECT_STORE, &all),
            cached: Kernel::when_needed(gpu, &wgsl::PROJECT_CACHED, &cached),
        };
        let mut new = Self {
            compute: Kernel::new(gpu, &wgsl::PROJECT, &all),
            caching: caches.then(caching),
            capacity,
            cache_start: (posed / 4) as u32,
            cache_words,
            buffer,
            counts,
        };
        new.bind(gpu, model, blocks, pose);
        Ok(new)
    }

    /// Reads these sets of Gaussians from now on.
    pub fn bind(&mut self, gpu: &Gpu, model: &Model, blocks: &Blocks, pose: &wgpu::Buffer) {
        for set in 0..model.sets() {
            let written = [&self.buffer, &self.counts];
            let bound = model_bindings(model, set, blocks, pose, written);
            self.compute.set(gpu, set, &bound);
            if let Some(caching) = &mut self.caching {
                caching.store.set(gpu, set, &bound);
            }
        }
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

    /// Projects one avatar, of which the first `gaussians` are drawn. `block`: offset of its
    /// uniform block, bytes. `model`: which of the avatar's levels; 0 is the avatar itself.
    pub fn record(
        &self,
        pass: &mut wgpu::ComputePass,
        block: u32,
        model: usize,
        gaussians: u32,
        skinning: Skinning,
    ) {
        let (kernel, turn) = match (skinning, &self.caching) {
            (Skinning::ComputeAndStore, Some(caching)) => (&caching.store, model),
            // Nothing of the model is read.
            (Skinning::Cached, Some(caching)) => (&caching.cached, 0),
            _ => (&self.compute, model),
        };
        let groups = [gaussians.div_ceil(PROJECT_WORKGROUP), 1];
        kernel.dispatch_turn(pass, turn, block, groups);
    }
}

/// What kernels that read a set of Gaussians are bound to. `written`: splats and counts.
fn model_bindings<'a>(
    model: &'a Model,
    set: usize,
    blocks: &'a Blocks,
    pose: &'a wgpu::Buffer,
    written: [&'a Buffer; 2],
) -> [(u32, Bound<'a>); 7] {
    let [splats, counts] = written;
    [
        (1, Bound::Read(model.gaussians.set(set))),
        (2, Bound::Read(model.rows.set(set))),
        (3, Bound::Read(pose.into())),
        (4, Bound::Write(splats.into())),
        (6, Bound::Write(counts.into())),
        blocks.frame(),
        blocks.settings(),
    ]
}

/// Where the keys of `count` Gaussians start, in bytes.
fn key_offset(count: u32) -> u64 {
    (16 * u64::from(count)).next_multiple_of(256)
}
