//! The `project` stage: from a Gaussian of the model to a splat on the screen and its depth key
//! (model.md, steps 2 and 4 to 8).
//!
//! While only the camera moves, posed Gaussians come from a cache: the first such frame stores
//! them, in its camera's space, and those after it only project them. There is no cache until a
//! frame stores something. `shaders/project/pose_cache.glsl` has the words of a Gaussian.

use super::model::{GaussianSet, Model};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Replacement, Slice},
    pipeline::{FrameMemory, Kernel, Launch, shaders},
    sort::counts_size,
};
use ash::vk;
use effigy_core::{
    frame::{
        CullReasons, DEPTH_KEYS, RendererOptions, Skinning, Skip, SortVariant,
        capacity::Capacity,
        kernels::{self, KernelSpec},
        resource::Resource,
    },
    layout::{FrameBlock, PROJECT_WORKGROUP},
};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// The capacity is a multiple of this many Gaussians: pipelines are compiled for the capacity, and
/// avatars of about one size share them.
const CAPACITY_STEP: u32 = 4096;

/// The kernels of the stage, and the buffer of splats, keys and pose cache that they write.
pub struct Project {
    /// Of the avatar, then of its levels, the finest first.
    sets: Vec<SetKernels>,
    counted: bool,
    layout: SplatBufferLayout,
    /// Splats, keys, the sort's counts, reasons, and the pose cache once there is one.
    buffer: Buffer,
    has_cache: bool,
}

/// The kernels that project a set of Gaussians.
struct SetKernels {
    compute: Kernel,
    /// None where poses are not cached.
    caching: Option<Caching>,
}

/// The kernels of frames in which only the camera moves.
struct Caching {
    /// Computes posed Gaussians and stores them.
    store: Kernel,
    /// Projects the stored Gaussians.
    cached: Kernel,
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

impl Project {
    /// Reads the output of the `mlp` stage. [`Skip::SKINNING`] in `options` says whether
    /// frames in which only the camera moved use the pose cache.
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        model: &Model,
        memory: &FrameMemory,
        variant: SortVariant,
        options: &RendererOptions,
        capacity: Capacity,
    ) -> Result<Self> {
        let caches = options.skip.contains(Skip::SKINNING);
        let capacity =
            capacity.gaussians.saturating_add(CAPACITY_STEP - 1) / CAPACITY_STEP * CAPACITY_STEP;
        let layout =
            SplatBufferLayout::new(capacity, variant, model.own().constants.pose_cache_words());
        let counting = if options.count {
            [1, (layout.reasons / 4) as u32]
        } else {
            [0, 0]
        };
        let buffer = splat_buffer(gpu, layout.posed)?;
        let set = |set: &GaussianSet| -> Result<SetKernels> {
            let memory = memory
                .with(Resource::Gaussians, &set.gaussians)
                .with(Resource::Rows, &set.rows)
                .with(Resource::Splats, &buffer);
            let kernel = |spec: &KernelSpec, module, stores: u32| {
                let constants = [stores, counting[0], counting[1]];
                Kernel::of_frame(gpu, spec, module, &constants, &memory, Launch::default())
            };
            let caching = if caches {
                Some(Caching {
                    store: kernel(&kernels::PROJECT_STORE, &shaders::PROJECT, 1)?,
                    cached: kernel(&kernels::PROJECT_CACHED, &shaders::PROJECT_CACHED, 0)?,
                })
            } else {
                None
            };
            Ok(SetKernels {
                compute: kernel(&kernels::PROJECT, &shaders::PROJECT, 0)?,
                caching,
            })
        };
        let sets = model.sets.iter().map(set).collect::<Result<_>>()?;
        Ok(Self {
            sets,
            counted: options.count,
            layout,
            buffer,
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
    /// No submitted work may use the stage. What binds the buffer must bind the new one before it
    /// is used again.
    pub unsafe fn make_cache(&mut self, gpu: &Arc<Gpu>) -> Result<Replacement> {
        let buffer = splat_buffer(gpu, self.layout.with_cache())?;
        let replacement = Replacement {
            old: (&self.buffer).into(),
            new: (&buffer).into(),
        };
        for set in &mut self.sets {
            let caching = set.caching.iter_mut();
            let caching = caching.flat_map(|kernels| [&mut kernels.store, &mut kernels.cached]);
            for kernel in caching.chain([&mut set.compute]) {
                // SAFETY: no work uses it, as the caller promises; this keeps the new buffer.
                unsafe { kernel.replace(replacement) };
            }
        }
        self.buffer = buffer;
        self.has_cache = true;
        Ok(replacement)
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

    /// Projects one avatar, of which the first `drawn` Gaussians are drawn. Reads the output of
    /// `mlp`, and adds to the counts that [`crate::vulkan::sort::Sort::clear`] zeroed; compute.
    ///
    /// `model`: which of the avatar's levels; 0 is the avatar itself.
    pub fn record(
        &self,
        commands: Recording,
        frame: u32,
        model: usize,
        drawn: u32,
        skinning: Skinning,
    ) {
        let set = &self.sets[model];
        let kernel = match (skinning, &set.caching) {
            (Skinning::ComputeAndStore, Some(caching)) => &caching.store,
            (Skinning::Cached, Some(caching)) => &caching.cached,
            _ => &set.compute,
        };
        kernel.dispatch(commands, frame, drawn.div_ceil(PROJECT_WORKGROUP));
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
