//! The `sort` stage: a stable radix sort, lowest digit first, without subgroups: each workgroup sums
//! the histograms of the tiles before its own; on CPU drivers each invocation has a run of keys to
//! itself. Keys go in; the order comes out, and the number of visible splats in the control.

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::Result,
    kernel::{Bound, Kernel},
    owned::Buffer,
};
use crate::wgsl::{self, WgslModule};
use effigy_core::{
    frame::{EntryForm, KeyBits, RendererOptions, SortVariant},
    layout::{MAX_SUMMED_TILES, SORT_DIGITS, SORT_GROUP, SORT_TILE, SettingsBlock},
};

/// The most keys of a sort: those of as many workgroups as a WebGPU device always dispatches.
pub const MAX_KEYS: u32 = 65_535 * SORT_TILE;

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
    /// Keys of so many bits.
    pub bits: KeyBits,
    /// The keys.
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

/// The kernels of a pass.
struct SortPass {
    /// None where the keys come counted.
    count: Option<Kernel>,
    scan: Option<[Kernel; 2]>,
    scatter: Kernel,
}

/// The kernels of the sort, and the buffers that they write.
pub struct Sort {
    passes: Vec<SortPass>,
    tiles: u32,
    capacity: u32,
    /// What passes write in turn: entries, and then the order.
    in_turn: [Buffer; 2],
    /// Which of those has the order.
    last: usize,
}

impl Sort {
    /// `settings`: the binding of a block with what [`Self::fill`] writes, and the number of keys.
    pub fn new(
        gpu: &Gpu,
        settings: (u32, Bound),
        inputs: &SortInputs,
        variant: SortVariant,
    ) -> Result<Self> {
        let SortInputs { bits, capacity, .. } = *inputs;
        let [first, second] = bits.written_in_turn(capacity);
        let in_turn = [
            empty(gpu, "sort entries", first, STORAGE)?,
            empty(gpu, "sort entries", second, STORAGE)?,
        ];
        let passes = (0..bits.passes()).map(|pass| {
            let entries = |pass: u32| Slice::from(&in_turn[pass as usize % 2]);
            let from = pass.checked_sub(1).map_or(inputs.keys, entries);
            sort_pass(gpu, settings, inputs, variant, pass, [from, entries(pass)])
        });
        Ok(Self {
            passes: passes.collect(),
            tiles: tiles(capacity),
            capacity,
            last: bits.last(),
            in_turn,
        })
    }

    /// Writes the sort's sizes to the settings block.
    pub fn fill(&self, settings: &mut SettingsBlock) {
        settings.sort_tiles = self.tiles;
        settings.key_capacity = self.capacity;
        settings.scanned = u32::from(is_scanned(self.capacity));
    }

    /// The indices of the visible splats, lowest key first, equal keys in index order.
    pub fn order(&self) -> Slice<'_> {
        (&self.in_turn[self.last]).into()
    }

    pub fn dispatches(&self) -> usize {
        let of_pass = |pass: &SortPass| {
            1 + usize::from(pass.count.is_some()) + 2 * usize::from(pass.scan.is_some())
        };
        self.passes.iter().map(of_pass).sum()
    }

    /// Sorts.
    pub fn record(&self, pass: &mut wgpu::ComputePass) {
        let tiles = [self.tiles, 1];
        let groups = [self.tiles.div_ceil(SORT_GROUP), 1];
        for kernels in &self.passes {
            if let Some(count) = &kernels.count {
                count.dispatch(pass, 0, tiles);
            }
            for kernel in kernels.scan.iter().flatten() {
                kernel.dispatch(pass, 0, groups);
            }
            kernels.scatter.dispatch(pass, 0, tiles);
        }
    }
}

fn is_scanned(capacity: u32) -> bool {
    tiles(capacity) > MAX_SUMMED_TILES
}

/// The kernels of a pass from the entries of the one buffer to those of the other.
fn sort_pass(
    gpu: &Gpu,
    settings: (u32, Bound),
    inputs: &SortInputs,
    variant: SortVariant,
    pass: u32,
    [from, to]: [Slice; 2],
) -> SortPass {
    let SortInputs { bits, capacity, .. } = *inputs;
    let [reads, writes] = [pass, pass + 1].map(|at| bits.form_before(at, capacity));
    let is_first = matches!(reads, EntryForm::Keys | EntryForm::Halves);
    // The ids of `shaders/sort/pass.glsl`.
    let constants = [
        ("0", f64::from(pass)),
        ("1", f64::from(reads as u32)),
        ("2", f64::from(writes as u32)),
        ("9", f64::from(bits.value_bits(capacity))),
    ];
    let [read, write] = [Bound::Read, Bound::Write];
    let kernel = |module: &'static WgslModule, bound: &[(u32, Bound)]| {
        // The module has those alone that it uses.
        let used = constants
            .into_iter()
            .filter(|(id, _)| module.wgsl.contains(&format!("@id({id}) ")));
        Kernel::specialized(gpu, module, &[bound, &[settings]].concat(), used.collect())
    };
    let entries = (1, read(from));
    let counts = (2, write(inputs.counts));
    let control = (3, read(inputs.control));
    // The first pass writes to the control how many there are.
    let (scan, scatter, per_thread_scatter, told) = if is_first {
        (
            &wgsl::SORT_SCAN_FIRST,
            &wgsl::SORT_SCATTER_FIRST,
            &wgsl::SORT_PER_THREAD_SCATTER_FIRST,
            (3, write(inputs.control)),
        )
    } else {
        (
            &wgsl::SORT_SCAN_LATER,
            &wgsl::SORT_SCATTER_LATER,
            &wgsl::SORT_PER_THREAD_SCATTER_LATER,
            control,
        )
    };
    let (count, scatter, moved) = if variant == SortVariant::PerThread {
        (&wgsl::SORT_PER_THREAD_COUNT, per_thread_scatter, counts)
    } else {
        (&wgsl::SORT_COUNT, scatter, (2, read(inputs.counts)))
    };
    SortPass {
        count: (!is_first || !inputs.counted).then(|| kernel(count, &[entries, counts, control])),
        scan: is_scanned(capacity).then(|| {
            [
                kernel(&wgsl::SORT_REDUCE, &[counts, control]),
                kernel(scan, &[counts, told]),
            ]
        }),
        scatter: kernel(scatter, &[entries, moved, told, (4, write(to))]),
    }
}
