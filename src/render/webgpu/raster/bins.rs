//! The lists of bins: which splats meet which square of the image, nearest first.
//! `shaders/common/bins.glsl` says how they are made.

use super::{
    super::{
        buffer::{STORAGE, Slice, empty},
        device::Gpu,
        error::{Error, Result},
        frame_in_flight::{FrameInFlight, Writes},
        kernel::{Blocks, Bound, Kernel, settings},
        owned::Buffer,
        sort::{self, Sort, SortInputs},
    },
    inputs::{Draw, RasterInputs},
};
use crate::wgsl;
use bytemuck::bytes_of;
use effigy_core::{
    frame::{KeyBits, SortVariant, Stage},
    layout::{BIN_WORKGROUP, BinLayout, Control, SettingsBlock, bin_count},
};
use std::mem::offset_of;
use wgpu::BufferUsages;

/// The lists are for GPUs: so is their sort.
const VARIANT: SortVariant = SortVariant::ReduceThenScan;

/// The kernels that make the lists, and their memory.
pub struct Bins {
    count: Kernel,
    scan: Kernel,
    pairs: Kernel,
    sort: Sort,
    starts: Kernel,
    layout: BinLayout,
    buffer: Buffer,
    /// A bit for each splat that is seen somewhere.
    marks: Buffer,
    /// Settings of the sort of pairs.
    settings: Buffer,
    /// The bin of each pair. WebGPU does not let a kernel read part of a buffer of which it writes
    /// another.
    _keys: Buffer,
    _counts: Buffer,
}

impl Bins {
    pub fn new(gpu: &Gpu, blocks: &Blocks, inputs: RasterInputs) -> Result<Self> {
        let layout = BinLayout::new(inputs.capacity);
        if layout.pairs > sort::MAX_KEYS {
            return Err(Error::TooLarge {
                what: "pairs of splats and bins",
                found: 4 * u64::from(layout.pairs),
                limit: 4 * u64::from(sort::MAX_KEYS),
                device: gpu.name().into(),
            });
        }
        // Keys and marks, which end the layout, have buffers of their own.
        let buffer = empty(gpu, "bins", 4 * u64::from(layout.keys_start), STORAGE)?;
        let keys = empty(gpu, "bin keys", 2 * u64::from(layout.pairs), STORAGE)?;
        let marks = 4 * u64::from(layout.words - layout.marks_start);
        let marks = empty(gpu, "marks", marks, STORAGE)?;
        let size = sort::counts_size(layout.pairs, VARIANT);
        let counts = empty(gpu, "bin counts", size, STORAGE)?;
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let own = empty(gpu, "pair sort", size_of::<SettingsBlock>() as u64, uniform)?;
        let sort_inputs = SortInputs {
            bits: KeyBits::Sixteen,
            keys: (&keys).into(),
            counts: (&counts).into(),
            control: Slice {
                size: size_of::<Control>() as u64,
                ..(&buffer).into()
            },
            capacity: layout.pairs,
            counted: false,
        };
        let sort = Sort::new(gpu, settings(&own), &sort_inputs, VARIANT)?;
        let mut sizes = SettingsBlock::default();
        sort.fill(&mut sizes);
        gpu.queue.write_buffer(&own, 0, bytes_of(&sizes));
        let bins = (4, Bound::Write((&buffer).into()));
        let kernel = |module, bound: &[(u32, Bound)]| {
            let shared = [blocks.frame(), blocks.settings()];
            Kernel::new(gpu, module, &[bound, &shared].concat())
        };
        let splats = [
            (1, Bound::Read(inputs.order)),
            (2, Bound::Read(inputs.splats)),
            (3, Bound::Read(inputs.control.into())),
            bins,
        ];
        let pair_keys = Slice::from(&keys);
        Ok(Self {
            count: kernel(&wgsl::BINNING_COUNT, &splats),
            scan: kernel(
                &wgsl::BINNING_SCAN,
                &[(1, Bound::Write(inputs.control.into())), (2, bins.1)],
            ),
            pairs: kernel(
                &wgsl::BINNING_PAIRS,
                &[&splats[..], &[(5, Bound::Write(pair_keys))]].concat(),
            ),
            starts: kernel(
                &wgsl::BINNING_STARTS,
                &[
                    (1, Bound::Read(sort.order())),
                    (2, bins.1),
                    (3, Bound::Read(pair_keys)),
                ],
            ),
            sort,
            layout,
            buffer,
            marks,
            settings: own,
            _keys: keys,
            _counts: counts,
        })
    }

    /// Writes to the settings block where the lists are.
    pub fn fill(settings: &mut SettingsBlock, capacity: u32) {
        let layout = BinLayout::new(capacity);
        settings.counts_start = layout.counts_start;
        settings.starts_start = layout.starts_start;
        settings.pairs_start = layout.pairs_start;
        settings.pair_capacity = layout.pairs;
    }

    /// The pairs in the order of bins.
    pub fn sorted(&self) -> Slice<'_> {
        self.sort.order()
    }

    /// Everything else but the marks.
    pub fn buffer(&self) -> Slice<'_> {
        (&self.buffer).into()
    }

    /// A bit for each splat that is seen somewhere.
    pub fn marks(&self) -> Slice<'_> {
        (&self.marks).into()
    }

    /// Dispatches of a frame.
    pub fn dispatches(&self) -> u64 {
        4 + self.sort.dispatches() as u64
    }

    /// Makes the lists of a layer, clears the marks, and zeroes the control's count of fragments.
    pub fn record(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        draw: &Draw,
        [begin, end]: Writes,
    ) {
        let block = draw.block;
        encoder.clear_buffer(&self.marks, 0, None);
        let blocks = [self.layout.blocks, 1];
        {
            let mut pass = in_flight.pass(encoder, Stage::Binning, [begin, None]);
            self.count.dispatch(&mut pass, block, blocks);
            self.scan.dispatch(&mut pass, block, [1, 1]);
            self.pairs.dispatch(&mut pass, block, blocks);
        }
        // How many pairs there are is a setting of their sort, since a barrier must not depend on a
        // buffer that is written.
        let from = offset_of!(Control, key_count) as u64;
        let to = offset_of!(SettingsBlock, key_count) as u64;
        encoder.copy_buffer_to_buffer(&self.buffer, from, &self.settings, to, 4);
        let mut pass = in_flight.pass(encoder, Stage::Binning, [None, end]);
        self.sort.record(&mut pass);
        let bins = bin_count(draw.size);
        let groups = [(bins + 1).div_ceil(BIN_WORKGROUP), 1];
        self.starts.dispatch(&mut pass, block, groups);
    }

    /// The lists of the last frame, of an image of a size, px, read back for tests.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn download(&self, gpu: &Gpu, size: [u32; 2]) -> Result<effigy_core::layout::BinLists> {
        let words = super::super::buffer::download(gpu, self.buffer())?;
        let sorted = super::super::buffer::download(gpu, self.sorted())?;
        Ok(effigy_core::layout::BinLists::new(
            &self.layout,
            size,
            &bytemuck::pod_collect_to_vec::<u8, u32>(&words),
            &bytemuck::pod_collect_to_vec::<u8, u32>(&sorted),
        ))
    }
}
