//! The `sort` stage: a stable radix sort of 16-bit keys in two passes, lowest first, without
//! subgroups: each workgroup sums the histograms of the tiles before its own; on CPU drivers each
//! invocation has a run of keys to itself. Keys go in; the order comes out, and the number of
//! visible splats in the control.

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::Result,
    kernel::{Bound, Kernel},
    owned::Buffer,
};
use crate::wgsl;
use effigy_core::{
    frame::{RendererOptions, SortVariant},
    layout::{MAX_SUMMED_TILES, SORT_DIGITS, SORT_GROUP, SORT_TILE, SettingsBlock},
};

/// The most keys of a sort: entries of the last pass hold a value in 24 bits.
pub const MAX_KEYS: u32 = 1 << 24;

fn tiles(capacity: u32) -> u32 {
    capacity.div_ceil(SORT_TILE).max(1)
}

/// The variant that WebGPU runs for these options: per-thread where it was chosen, otherwise
/// reduce-then-scan.
pub fn variant(options: &RendererOptions) -> SortVariant {
    options
        .sort
        .filter(|&variant| variant == SortVariant::PerThread)
        .unwrap_or(SortVariant::ReduceThenScan)
}

/// Bytes that the counts of a sort take.
pub fn counts_size(capacity: u32, variant: SortVariant) -> u64 {
    variant.counts_size(tiles(capacity))
}

/// Bytes of those that a kernel which makes keys adds to.
pub fn first_counts_size(capacity: u32) -> u64 {
    4 * u64::from(SORT_DIGITS * tiles(capacity))
}

/// Buffers that a sort reads and writes.
pub struct SortInputs<'a> {
    /// Keys of 16 bits, two a word.
    pub keys: Slice<'a>,
    /// Counts of the keys' lowest digits, and room for more: [`counts_size`].
    pub counts: Slice<'a>,
    /// A [`Control`](effigy_core::layout::Control): gets the number of visible keys.
    pub control: Slice<'a>,
    /// The most keys to sort.
    pub capacity: u32,
    /// Whether what makes the keys counts their lowest digits. If not, the sort does, which only
    /// the reduce-then-scan variant can.
    pub counted: bool,
}

/// The kernels of the sort, and the buffers that they write.
pub struct Sort {
    /// None where the keys come counted.
    first_count: Option<Kernel>,
    first_scan: Option<[Kernel; 2]>,
    first: Kernel,
    last_count: Kernel,
    last_scan: Option<[Kernel; 2]>,
    last: Kernel,
    tiles: u32,
    capacity: u32,
    order: Buffer,
    /// Entries between the passes.
    _between: Buffer,
}

impl Sort {
    /// `settings`: the binding of a block with what [`Self::fill`] writes, and the number of keys.
    pub fn new(
        gpu: &Gpu,
        settings: (u32, Bound),
        inputs: SortInputs,
        variant: SortVariant,
    ) -> Result<Self> {
        let SortInputs {
            keys,
            counts,
            control,
            capacity,
            counted,
        } = inputs;
        let between = empty(gpu, "sort entries", 4 * u64::from(capacity), STORAGE)?;
        let order = empty(gpu, "order", 4 * u64::from(capacity), STORAGE)?;
        let entries = Slice::from(&between);
        let read = Bound::Read;
        let write = Bound::Write;
        let kernel = |module, bound: &[(u32, Bound)]| {
            Kernel::new(gpu, module, &[bound, &[settings]].concat())
        };
        let scanned = tiles(capacity) > MAX_SUMMED_TILES;
        let per_thread = variant == SortVariant::PerThread;
        let moved = if per_thread {
            write(counts)
        } else {
            read(counts)
        };
        let [first, last_count, last] = if per_thread {
            [
                &wgsl::SORT_PER_THREAD_SCATTER_FIRST,
                &wgsl::SORT_PER_THREAD_COUNT_LAST,
                &wgsl::SORT_PER_THREAD_SCATTER_LAST,
            ]
        } else {
            [
                &wgsl::SORT_SCATTER_FIRST,
                &wgsl::SORT_COUNT_LAST,
                &wgsl::SORT_SCATTER_LAST,
            ]
        };
        let first_count = || {
            let bound = [(1, read(keys)), (2, write(counts)), (3, read(control))];
            kernel(&wgsl::SORT_COUNT_FIRST, &bound)
        };
        let first_scan = || {
            [
                kernel(&wgsl::SORT_REDUCE_FIRST, &[(2, write(counts))]),
                kernel(
                    &wgsl::SORT_SCAN_FIRST,
                    &[(2, write(counts)), (3, write(control))],
                ),
            ]
        };
        let last_scan = || {
            [
                kernel(
                    &wgsl::SORT_REDUCE_LAST,
                    &[(2, write(counts)), (3, read(control))],
                ),
                kernel(
                    &wgsl::SORT_SCAN_LAST,
                    &[(2, write(counts)), (3, read(control))],
                ),
            ]
        };
        Ok(Self {
            first_count: (!counted).then(first_count),
            first_scan: scanned.then(first_scan),
            first: kernel(
                first,
                &[
                    (1, read(keys)),
                    (2, moved),
                    (3, write(control)),
                    (4, write(entries)),
                ],
            ),
            last_count: kernel(
                last_count,
                &[(1, read(entries)), (2, write(counts)), (3, read(control))],
            ),
            last_scan: scanned.then(last_scan),
            last: kernel(
                last,
                &[
                    (1, read(entries)),
                    (2, moved),
                    (3, read(control)),
                    (4, write((&order).into())),
                ],
            ),
            tiles: tiles(capacity),
            capacity,
            order,
            _between: between,
        })
    }

    /// Writes the sort's sizes to the settings block.
    pub fn fill(&self, settings: &mut SettingsBlock) {
        settings.sort_tiles = self.tiles;
        settings.key_capacity = self.capacity;
        settings.scanned = u32::from(self.first_scan.is_some());
    }

    /// The indices of the visible splats, lowest key first, equal keys in index order.
    pub fn order(&self) -> Slice<'_> {
        (&self.order).into()
    }

    pub fn dispatches(&self) -> usize {
        3 + usize::from(self.first_count.is_some())
            + 2 * usize::from(self.first_scan.is_some())
            + 2 * usize::from(self.last_scan.is_some())
    }

    /// Sorts.
    pub fn record(&self, pass: &mut wgpu::ComputePass) {
        let tiles = [self.tiles, 1];
        let groups = [self.tiles.div_ceil(SORT_GROUP), 1];
        if let Some(count) = &self.first_count {
            count.dispatch(pass, 0, tiles);
        }
        for kernel in self.first_scan.iter().flatten() {
            kernel.dispatch(pass, 0, groups);
        }
        self.first.dispatch(pass, 0, tiles);
        self.last_count.dispatch(pass, 0, tiles);
        for kernel in self.last_scan.iter().flatten() {
            kernel.dispatch(pass, 0, groups);
        }
        self.last.dispatch(pass, 0, tiles);
    }
}
