//! The `sort` stage: a stable radix sort of 16-bit keys in two passes, lowest first, without subgroups: each workgroup sums the
//! histograms of the tiles before its own; on processors each invocation has a run of keys to itself. Keys go in, the order comes out,
//! and in the control the number of survivors.

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::Result,
    kernel::{Blocks, Bound, Kernel},
    owned::Buffer,
};
use crate::{
    frame::{RendererOptions, Variant},
    layout::{SORT_DIGITS, SORT_GROUP, SORT_TILE, Settings},
    webgpu::shaders,
};

/// Above this many tiles two more kernels a pass sum their histograms.
const MOST_SUMMED: u32 = 128;

/// Keys that a sort can have: entries of the last pass hold a value in 24 bits.
pub const MOST: u32 = 1 << 24;

fn tiles(capacity: u32) -> u32 {
    capacity.div_ceil(SORT_TILE).max(1)
}

/// How keys are sorted here: in lanes where that was chosen, else by sums of masks.
pub fn variant(options: &RendererOptions) -> Variant {
    options.sort.filter(|&variant| variant == Variant::LaneScan).unwrap_or(Variant::SelfScan)
}

/// Bytes that the counts of a sort take.
pub fn counts_size(capacity: u32, variant: Variant) -> u64 {
    variant.counts_size(tiles(capacity))
}

/// Bytes of those that a kernel which makes keys adds to.
pub fn first_counts_size(capacity: u32) -> u64 {
    4 * u64::from(SORT_DIGITS * tiles(capacity))
}

pub struct Sort {
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
    /// Sorts at most `capacity` keys. `counts`: where their lowest digits are counted.
    pub fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        (keys, counts): (Slice, Slice),
        control: &wgpu::Buffer,
        (capacity, variant): (u32, Variant),
    ) -> Result<Self> {
        let between = empty(gpu, "sort entries", 4 * u64::from(capacity), STORAGE)?;
        let order = empty(gpu, "order", 4 * u64::from(capacity), STORAGE)?;
        let (read, write) = (|slice| Bound::Read(slice), |slice| Bound::Write(slice));
        let (entries, control) = (Slice::from(&between), Slice::from(control));
        let kernel = |module, bound: &[(u32, Bound)]| Kernel::new(gpu, module, &[bound, &[blocks.settings()]].concat());
        let scanned = tiles(capacity) > MOST_SUMMED;
        let lanes = variant == Variant::LaneScan;
        let moved = if lanes { write(counts) } else { read(counts) };
        let [first, last_count, last] = if lanes {
            [&shaders::SORT_LANES_FIRST, &shaders::SORT_LANES_LAST_COUNT, &shaders::SORT_LANES_LAST]
        } else {
            [&shaders::SORT_FIRST, &shaders::SORT_LAST_COUNT, &shaders::SORT_LAST]
        };
        let first_scan = || {
            [
                kernel(&shaders::SORT_FIRST_REDUCE, &[(2, write(counts))]),
                kernel(&shaders::SORT_FIRST_SCAN, &[(2, write(counts)), (3, write(control))]),
            ]
        };
        let last_scan = || {
            [
                kernel(&shaders::SORT_LAST_REDUCE, &[(2, write(counts)), (3, read(control))]),
                kernel(&shaders::SORT_LAST_SCAN, &[(2, write(counts)), (3, read(control))]),
            ]
        };
        Ok(Self {
            first_scan: scanned.then(first_scan),
            first: kernel(first, &[(1, read(keys)), (2, moved), (3, write(control)), (4, write(entries))]),
            last_count: kernel(last_count, &[(1, read(entries)), (2, write(counts)), (3, read(control))]),
            last_scan: scanned.then(last_scan),
            last: kernel(last, &[(1, read(entries)), (2, moved), (3, read(control)), (4, write((&order).into()))]),
            tiles: tiles(capacity),
            capacity,
            order,
            _between: between,
        })
    }

    /// Says what the kernels are told of their sizes.
    pub fn fill(&self, settings: &mut Settings) {
        settings.tiles = self.tiles;
        settings.capacity = self.capacity;
        settings.scanned = u32::from(self.first_scan.is_some());
    }

    /// The indices of the surviving keys, lowest key first, equal keys in index order.
    pub fn order(&self) -> Slice<'_> {
        (&self.order).into()
    }

    pub fn dispatches(&self) -> usize {
        3 + 2 * usize::from(self.first_scan.is_some()) + 2 * usize::from(self.last_scan.is_some())
    }

    /// Sorts keys whose lowest digits are counted.
    pub fn record(&self, pass: &mut wgpu::ComputePass) {
        let tiles = [self.tiles, 1];
        let groups = [self.tiles.div_ceil(SORT_GROUP), 1];
        self.first_scan.iter().flatten().for_each(|kernel| kernel.dispatch(pass, 0, groups));
        self.first.dispatch(pass, 0, tiles);
        self.last_count.dispatch(pass, 0, tiles);
        self.last_scan.iter().flatten().for_each(|kernel| kernel.dispatch(pass, 0, groups));
        self.last.dispatch(pass, 0, tiles);
    }
}
