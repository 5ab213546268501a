//! The sort on a device: its kernels and its memory.

use super::{
    options::{SortOptions, counts_size, tiles, unsupported},
    passes::{self, SortPass},
};
use crate::vulkan::{
    device::{
        error::{Error, Result},
        gpu::Gpu,
        recording::Recording,
    },
    memory::{Buffer, Replacement, Scope, Slice},
};
use ash::vk;
use effigy_core::{
    frame::SortVariant,
    layout::{SORT_DIGITS, SORT_FALLBACKS, SORT_STATE},
};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// A sort on a device: its kernels and its scratch memory.
pub struct Sort {
    passes: Vec<SortPass>,
    tiles: u32,
    variant: SortVariant,
    counts: Slice,
    /// The counts, where they are the sort's own.
    own_counts: Option<Buffer>,
    /// What passes write in turn: entries, and then the order.
    in_turn: [Buffer; 2],
    /// Which of those has the order.
    last: usize,
}

impl Sort {
    /// Sorts at most `capacity` keys, fewer than 2³⁰.
    ///
    /// # Errors
    /// When the device has too little memory, or lacks what the variant needs.
    ///
    /// # Safety
    /// The buffers of `keys`, `control` and `options.counts` must outlive every submission of what
    /// this sort records, be of `gpu`, and hold `capacity` keys and
    /// [`counts_size`](super::counts_size) bytes.
    pub unsafe fn new(
        gpu: &Arc<Gpu>,
        keys: Slice,
        control: &Buffer,
        capacity: u32,
        options: SortOptions,
    ) -> Result<Self> {
        let variant = options.variant;
        if let Some(reason) = unsupported(variant, gpu) {
            return Err(Error::Unsupported {
                device: gpu.probe.name.clone(),
                missing: format!("for {}: {reason}", variant.name()),
            });
        }
        let too_large = |keys: u64, limit: u64| Error::TooLarge {
            what: "sort keys",
            found: 4 * keys,
            limit: 4 * limit,
            device: gpu.probe.name.clone(),
        };
        if capacity >= 1 << 30 {
            return Err(too_large(capacity.into(), 1 << 30));
        }
        let tiles = tiles(capacity, variant);
        let limit = gpu.probe.limits.max_compute_work_group_count[0];
        if tiles > limit {
            let tile = u64::from(variant.tile());
            return Err(too_large(tile * u64::from(tiles), tile * u64::from(limit)));
        }
        let storage = |name, size| {
            let usage = vk::BufferUsageFlags::STORAGE_BUFFER
                | vk::BufferUsageFlags::TRANSFER_SRC
                | vk::BufferUsageFlags::TRANSFER_DST;
            Buffer::new(gpu, name, size, usage, MemoryLocation::GpuOnly)
        };
        let mut own_counts = None;
        let counts = match options.counts {
            Some(counts) => counts,
            None => {
                let own = storage("sort counts", counts_size(capacity, variant))?;
                (&*own_counts.insert(own)).into()
            }
        };
        let sort_size = passes::SortSize {
            capacity,
            tiles,
            options,
        };
        let [first, second] = options.bits.written_in_turn(capacity);
        let in_turn = [
            storage("sort entries", first)?,
            storage("sort entries", second)?,
        ];
        let buffers = passes::SortBuffers {
            keys,
            counts,
            control: control.into(),
        };
        Ok(Self {
            passes: sort_size.passes(gpu, buffers, &in_turn)?,
            tiles: sort_size.tiles,
            variant,
            counts,
            own_counts,
            in_turn,
            last: options.bits.last(),
        })
    }

    /// Reads keys and counts in one buffer that it read in the other.
    ///
    /// # Safety
    /// No submitted work may use the sort. For the new buffer holds what [`Self::new`] asks.
    pub(crate) unsafe fn replace(&mut self, replacement: Replacement) {
        replacement.apply(&mut self.counts);
        for pass in &mut self.passes {
            // SAFETY: the caller promises what the function asks for.
            unsafe { pass.replace(replacement) };
        }
    }

    /// The indices of the visible keys, lowest key first, equal keys in index order.
    pub fn order(&self) -> Slice {
        (&self.in_turn[self.last]).into()
    }

    /// The variant that it was made with.
    pub fn variant(&self) -> SortVariant {
        self.variant
    }

    /// Keys of a tile: where a kernel that counts keys adds to (`shaders/sort/first_counts.glsl`).
    pub fn tile(&self) -> u32 {
        self.variant.tile()
    }

    /// How often each value of the lowest digit occurs in each tile: a row of 256 words a tile.
    pub fn first_counts(&self) -> Slice {
        Slice {
            size: 4 * u64::from(self.tiles * SORT_DIGITS),
            ..self.counts
        }
    }

    /// Dispatches of a sort, of keys counted already or not.
    pub fn dispatches(&self, counted: bool) -> usize {
        self.passes.iter().map(SortPass::dispatches).sum::<usize>() - usize::from(counted)
    }

    /// Bytes of device memory that are the sort's own.
    pub fn memory(&self) -> u64 {
        let own = self.in_turn.iter().chain(&self.own_counts);
        own.map(|buffer| buffer.size).sum()
    }

    /// The first `count` indices, for tests.
    pub fn download(&self, count: u32) -> Result<Vec<u32>> {
        Ok(bytemuck::pod_collect_to_vec(
            &self.in_turn[self.last].download(4 * count as usize)?,
        ))
    }

    /// How often a workgroup of OneSweep counted another's tile in the last sort, for tests. None
    /// where the counts are the caller's.
    pub fn fallbacks(&self) -> Result<Option<u32>> {
        let Some(own) = &self.own_counts else {
            return Ok(None);
        };
        let at = 4 * (self.tiles * SORT_DIGITS + SORT_FALLBACKS) as usize;
        Ok(Some(bytemuck::pod_read_unaligned(
            &own.download(at + 4)?[at..],
        )))
    }

    /// Zeroes the counts of the first pass and the state of the sort, before a kernel adds keys to
    /// them: a transfer.
    pub fn clear(&self, commands: Recording) {
        let words = self.tiles * SORT_DIGITS + SORT_STATE + 3 * SORT_DIGITS;
        let part = Slice {
            size: 4 * u64::from(words),
            ..self.counts
        };
        // SAFETY: the part lies in the counts, whose buffer is alive.
        unsafe { commands.clear(part) };
    }

    /// Sorts. Reads keys and control; compute.
    pub fn record(&self, commands: Recording) {
        self.record_passes(commands, false);
    }

    /// Sorts keys whose lowest digits are in [`Self::first_counts`].
    pub fn record_counted(&self, commands: Recording) {
        self.record_passes(commands, true);
    }

    fn record_passes(&self, commands: Recording, counted: bool) {
        for (number, pass) in self.passes.iter().enumerate() {
            if number > 0 {
                commands.barrier(Scope::KERNEL_WRITES, Scope::KERNEL);
            }
            pass.record(commands, self.tiles, counted && number == 0);
        }
    }
}
