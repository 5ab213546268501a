//! The `sort` stage: a stable radix sort of 32-bit keys, 8 bits a pass, lowest first. Keys go in, the order comes out.
//!
//! A module of its own, for any Vulkan 1.1 program. It reads keys and a [`Control`], and writes the indices of the keys in order and the
//! control's `survivors` and `instance_count`. Keys equal to [`SORT_DROPPED`] are left out, which is how culled Gaussians disappear. How
//! many keys enter is read from the control on the device.
//!
//! | variant | how it knows where a tile's entries go | needs |
//! |---|---|---|
//! | [`Variant::OneSweep`] | decoupled look-back, bounded; ranks by ballots | subgroup ballots |
//! | [`Variant::SelfScan`] | each tile sums the histograms before it; ranks by bit masks in shared memory | nothing |
//! | [`Variant::LaneScan`] | the same; a run of keys and counters of its own for each invocation, for processors without wide groups | nothing |
//!
//! All give the same order on any device that does what Vulkan says, at any subgroup size, and none can hang: see `choice`, which
//! finds out what a device really does.
//!
//! **Storage**, for capacity n: the order, 4n bytes; between passes 4n (16-bit keys), 12n (24) or 16n (32), above 2²⁴ keys 8n, 16n and 16n; and the
//! counts, [`counts_size`], which the caller may provide inside a buffer of its own, so that a kernel that makes keys can count them too
//! without one more binding (`shaders/sort_fused.glsl`). Every kernel binds at most 4 storage buffers and shares at most 16 KB.
//!
//! **Barriers**: before [`Sort::record`], make keys and control visible to shader reads of compute, and let earlier readers of order and
//! control finish. [`Sort::record`] counts by itself and needs nothing cleared. Otherwise: [`Sort::clear`] (a transfer), a barrier from
//! transfer writes to compute reads and writes, the kernel that makes keys and counts, a barrier, [`Sort::record_counted`]. What either
//! wrote, by compute, is visible to nothing until the caller's barrier.

pub mod choice;
mod passes;
pub mod trial;
pub mod verdict;

use super::{device::Gpu, error::Result, memory::Buffer, pipeline::Slice};
pub use crate::frame::{KeyBits, Variant};
#[cfg(doc)]
use crate::layout::Control;
#[cfg(doc)]
use crate::layout::SORT_DROPPED;
use crate::layout::{SORT_DIGITS, SORT_FALLBACKS, SORT_STATE};
use ash::vk;
use gpu_allocator::MemoryLocation;
use passes::Pass;
use std::sync::Arc;

impl Variant {
    /// Why a device can't run it at all.
    pub fn lacks(self, gpu: &Gpu) -> Option<&'static str> {
        match self {
            Self::OneSweep if !gpu.probe.subgroup_ballot => Some("the device has no subgroup ballots in compute shaders"),
            _ => None,
        }
    }
}

/// What a sort is made with.
#[derive(Clone, Copy)]
pub struct SortOptions {
    pub bits: KeyBits,
    pub variant: Variant,
    /// Where the counts lie; [`counts_size`] bytes at an offset for storage buffers, in a buffer with transfer usage. None: the sort's own.
    pub counts: Option<Slice>,
    /// For tests of OneSweep: every so many tiles, one never tells its counts. 0: none.
    pub stall: u32,
    /// For tests of OneSweep: lanes of a subgroup, of those in `Probe::subgroup_sizes`.
    pub subgroup: Option<u32>,
}

impl SortOptions {
    pub fn new(bits: KeyBits, variant: Variant) -> Self {
        Self { bits, variant, counts: None, stall: 0, subgroup: None }
    }
}

/// Bytes that the counts of a sort take.
pub fn counts_size(capacity: u32, variant: Variant) -> u64 {
    variant.counts_size(tiles(capacity, variant))
}

fn tiles(capacity: u32, variant: Variant) -> u32 {
    capacity.div_ceil(variant.tile()).max(1)
}

/// A sort on a device: its kernels and its scratch memory.
pub struct Sort {
    gpu: Arc<Gpu>,
    passes: Vec<Pass>,
    tiles: u32,
    variant: Variant,
    counts: Slice,
    order: Buffer,
    /// Kept alive for the kernels: the entries between passes, and the counts where they are the sort's own.
    scratch: Vec<Buffer>,
}

impl Sort {
    /// Sorts at most `capacity` keys, fewer than 2³⁰. Fails where the device has no memory, or no subgroups for OneSweep.
    pub fn new(gpu: &Arc<Gpu>, keys: Slice, control: &Buffer, capacity: u32, options: SortOptions) -> Result<Self> {
        use super::error::Error;
        let variant = options.variant;
        if let Some(lacks) = variant.lacks(gpu) {
            return Err(Error::Lacks { device: gpu.probe.name.clone(), lacks: format!("for {}: {lacks}", variant.name()) });
        }
        if capacity >= 1 << 30 {
            let (found, limit) = (4 * u64::from(capacity), 4 << 30);
            return Err(Error::TooLarge { what: "sort keys", found, limit, device: gpu.probe.name.clone() });
        }
        let (groups, limit) = (tiles(capacity, variant), gpu.probe.limits.max_compute_work_group_count[0]);
        if groups > limit {
            let [found, limit] = [groups, limit].map(|count| 4 * u64::from(count) * u64::from(variant.tile()));
            return Err(Error::TooLarge { what: "sort keys", found, limit, device: gpu.probe.name.clone() });
        }
        let storage = |name, size| {
            let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
            Buffer::new(gpu, name, size, usage, MemoryLocation::GpuOnly)
        };
        let order = storage("order", 4 * u64::from(capacity))?;
        let mut scratch = Vec::new();
        let counts = match options.counts {
            Some(counts) => counts,
            None => {
                scratch.push(storage("sort counts", counts_size(capacity, variant))?);
                (&scratch[0]).into()
            }
        };
        let shape = passes::Shape { capacity, tiles: tiles(capacity, variant), options };
        let between = shape.between().into_iter().map(|bytes| storage("sort entries", bytes)).collect::<Result<Vec<_>>>()?;
        let ends = [keys, (&order).into()];
        let passes = shape.passes(gpu, ends, &between, [counts, control.into()])?;
        scratch.extend(between);
        Ok(Self { gpu: gpu.clone(), passes, tiles: shape.tiles, variant, counts, order, scratch })
    }

    /// The indices of the surviving keys, lowest key first, equal keys in index order.
    pub fn order(&self) -> Slice {
        (&self.order).into()
    }

    pub fn variant(&self) -> Variant {
        self.variant
    }

    /// Keys of a tile: where a kernel that counts keys adds to (`shaders/sort_fused.glsl`).
    pub fn tile(&self) -> u32 {
        self.variant.tile()
    }

    /// How often each value of the lowest digit occurs in each tile: a row of 256 words a tile.
    pub fn first_counts(&self) -> Slice {
        Slice { size: 4 * u64::from(self.tiles * SORT_DIGITS), ..self.counts }
    }

    /// Dispatches of a sort, of keys counted already or not.
    pub fn dispatches(&self, counted: bool) -> usize {
        self.passes.iter().map(Pass::dispatches).sum::<usize>() - usize::from(counted)
    }

    /// Bytes of device memory that are the sort's own.
    pub fn memory(&self) -> u64 {
        self.order.size + self.scratch.iter().map(|buffer| buffer.size).sum::<u64>()
    }

    /// The first `count` indices, for tests.
    pub fn download(&self, count: u32) -> Result<Vec<u32>> {
        Ok(bytemuck::pod_collect_to_vec(&self.order.download(4 * count as usize)?))
    }

    /// How often a workgroup of OneSweep counted another's tile in the last sort, for tests. None where the counts are the caller's.
    pub fn fallbacks(&self) -> Result<Option<u32>> {
        let Some(own) = self.scratch.first().filter(|own| own.raw == self.counts.buffer) else { return Ok(None) };
        let at = 4 * (self.tiles * SORT_DIGITS + SORT_FALLBACKS) as usize;
        Ok(Some(bytemuck::pod_read_unaligned(&own.download(at + 4)?[at..])))
    }

    /// Zeroes the counts of the first pass and the state of the sort, before a kernel adds keys to them: a transfer.
    pub fn clear(&self, commands: vk::CommandBuffer) {
        let words = self.tiles * SORT_DIGITS + SORT_STATE + 3 * SORT_DIGITS;
        // SAFETY: the command buffer is recording; the range lies in the counts, whose buffer is alive.
        unsafe { self.gpu.raw.cmd_fill_buffer(commands, self.counts.buffer, self.counts.offset, 4 * u64::from(words), 0) };
    }

    /// Sorts. Reads keys and control; compute.
    pub fn record(&self, commands: vk::CommandBuffer) {
        self.record_passes(commands, false);
    }

    /// Sorts keys whose lowest digits are in [`Self::first_counts`].
    pub fn record_counted(&self, commands: vk::CommandBuffer) {
        self.record_passes(commands, true);
    }

    fn record_passes(&self, commands: vk::CommandBuffer, counted: bool) {
        for (number, pass) in self.passes.iter().enumerate() {
            if number > 0 {
                passes::between(&self.gpu, commands);
            }
            pass.record(&self.gpu, commands, self.tiles, counted && number == 0);
        }
    }
}
