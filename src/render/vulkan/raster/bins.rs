//! The lists of bins: which splats meet which square of the image, nearest first.
//! `shaders/common/bins.glsl` says how they are made.

use super::draw::RasterInputs;
use crate::vulkan::{
    device::{
        error::{Error, Result},
        gpu::Gpu,
        recording::Recording,
    },
    memory::{Buffer, Replacement, Scope, Slice},
    pipeline::{
        FrameMemory, Kernel, Launch,
        shaders::{self, Module},
    },
    sort::{Sort, SortOptions},
};
use ash::vk;
use effigy_core::{
    frame::{
        KeyBits,
        kernels::{self, KernelSpec},
        resource::Resource,
    },
    layout::{BIN_BLOCK, BIN_WORKGROUP, BinLayout, BinLists, Control, bin_count},
};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// The kernels that make the lists, and their memory.
pub struct Bins {
    count: Kernel,
    scan: Kernel,
    pairs: Kernel,
    sort: Sort,
    starts: Kernel,
    layout: BinLayout,
    buffer: Buffer,
}

impl Bins {
    pub(crate) fn new(gpu: &Arc<Gpu>, inputs: &RasterInputs) -> Result<Self> {
        let layout = BinLayout::new(inputs.capacity);
        let limit = gpu.probe.limits.max_compute_work_group_count[0];
        if layout.blocks > limit {
            // A limit of workgroups, said in the 16 bytes of each splat.
            let splats = |blocks: u32| 16 * u64::from(blocks) * u64::from(BIN_BLOCK);
            return Err(Error::TooLarge {
                what: "splats in bins",
                found: splats(layout.blocks),
                limit: splats(limit),
                device: gpu.probe.name.clone(),
            });
        }
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let size = 4 * u64::from(layout.words);
        let buffer = Buffer::new(gpu, "bins", size, usage, MemoryLocation::GpuOnly)?;
        let bins = Slice::from(&buffer);
        let keys = Slice {
            offset: 4 * u64::from(layout.keys_start),
            size: 2 * u64::from(layout.pairs),
            ..bins
        };
        let options = SortOptions::new(KeyBits::Sixteen, inputs.sort);
        // SAFETY: this owns the buffer beside the sort, and is dropped after the frames in flight;
        // the keys have room for all pairs.
        let sort = unsafe { Sort::new(gpu, keys, &buffer, layout.pairs, options) }?;
        let constants = constants_of(&layout, [0; 3]);
        let memory = with_lists(&inputs.memory, &sort, &buffer);
        let kernel = |spec: &KernelSpec, module: &'static Module| {
            Kernel::of_frame(gpu, spec, module, &constants, &memory, Launch::default())
        };
        Ok(Self {
            count: kernel(&kernels::BIN_COUNT, &shaders::BINNING_COUNT)?,
            scan: kernel(&kernels::BIN_SCAN, &shaders::BINNING_SCAN)?,
            pairs: kernel(&kernels::BIN_PAIRS, &shaders::BINNING_PAIRS)?,
            starts: kernel(&kernels::BIN_STARTS, &shaders::BINNING_STARTS)?,
            sort,
            layout,
            buffer,
        })
    }

    /// Reads splats in the one buffer that it read in the other.
    ///
    /// # Safety
    /// No submitted work may use the kernels, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        for kernel in [&mut self.count, &mut self.pairs] {
            // SAFETY: the caller promises what the function asks for.
            unsafe { kernel.replace(replacement) };
        }
    }

    /// Specialization constants of a kernel that reads the lists: three of its own, then where the
    /// parts of the buffer are.
    pub fn constants(&self, own: [u32; 3]) -> [u32; 9] {
        constants_of(&self.layout, own)
    }

    /// This memory, and the lists.
    pub(crate) fn add_to(&self, memory: &FrameMemory) -> FrameMemory {
        with_lists(memory, &self.sort, &self.buffer)
    }

    /// Dispatches of a frame.
    pub fn dispatches(&self) -> u64 {
        4 + self.sort.dispatches(false) as u64
    }

    /// Makes the lists of an image of a size, px, and zeroes the control's count of fragments.
    /// Reads what the sort left; compute.
    pub fn record(&self, commands: Recording, frame: u32, size: [u32; 2]) {
        let then = || commands.barrier(Scope::KERNEL_WRITES, Scope::KERNEL);
        self.count.dispatch(commands, frame, self.layout.blocks);
        then();
        self.scan.dispatch(commands, frame, 1);
        then();
        self.pairs.dispatch(commands, frame, self.layout.blocks);
        then();
        self.sort.record(commands);
        then();
        let bins = bin_count(size);
        self.starts
            .dispatch(commands, frame, (bins + 1).div_ceil(BIN_WORKGROUP));
    }

    /// The lists of the last frame, of an image of a size, px, read back for tests.
    pub fn download(&self, size: [u32; 2]) -> Result<BinLists> {
        let words: Vec<u32> =
            bytemuck::pod_collect_to_vec(&self.buffer.download(self.buffer.size as usize)?);
        let control: Control = bytemuck::pod_read_unaligned(bytemuck::cast_slice(&words[..8]));
        let sorted = self.sort.download(control.visible_count)?;
        Ok(BinLists::new(&self.layout, size, &words, &sorted))
    }
}

/// This memory, and the pairs in the order of bins with the buffer that has everything else.
fn with_lists(memory: &FrameMemory, sort: &Sort, buffer: &Buffer) -> FrameMemory {
    memory
        .with(Resource::Pairs, sort.order())
        .with(Resource::Bins, buffer)
}

fn constants_of(layout: &BinLayout, own: [u32; 3]) -> [u32; 9] {
    let [first, second, third] = own;
    [
        first,
        second,
        third,
        layout.counts_start,
        layout.starts_start,
        layout.pairs_start,
        layout.keys_start,
        layout.marks_start,
        layout.pairs,
    ]
}
