//! A sort with keys of its own: runs it, times it, and compares the order with a stable sort on the
//! CPU. For the self-test, the benchmark and the tests.

use super::{options::SortOptions, stage::Sort};
use crate::vulkan::{
    commands::{RunTimes, Stopwatch},
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Scope},
};
use ash::vk;
use effigy_core::{
    frame::KeyBits,
    layout::{Control, QUADS_PER_INSTANCE},
};
use std::sync::Arc;

/// A sort, and the buffers around it.
pub struct StandaloneSort {
    keys: Buffer,
    control: Buffer,
    sort: Sort,
    bits: KeyBits,
    stopwatch: Stopwatch,
}

impl StandaloneSort {
    /// Sorts at most `capacity` keys, which [`Self::load`] uploads. The counts are its own, whatever
    /// the options say. Fails where [`Sort::new`] does.
    pub fn new(gpu: &Arc<Gpu>, capacity: u32, options: SortOptions) -> Result<Self> {
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let keys = Buffer::new(
            gpu,
            "keys",
            4 * u64::from(capacity),
            storage,
            gpu_allocator::MemoryLocation::GpuOnly,
        )?;
        let control = Buffer::with_data(
            gpu,
            "control",
            bytemuck::bytes_of(&Control::default()),
            storage,
        )?;
        let options = SortOptions {
            counts: None,
            ..options
        };
        // SAFETY: both buffers live as long as the sort, and every run waits for its end.
        let sort = unsafe { Sort::new(gpu, (&keys).into(), &control, capacity, options) }?;
        Ok(Self {
            keys,
            control,
            sort,
            bits: options.bits,
            stopwatch: Stopwatch::new(gpu, "standalone sort")?,
        })
    }

    /// The sort between the buffers.
    pub fn sort(&self) -> &Sort {
        &self.sort
    }

    /// The control buffer: number of keys, number of visible keys, and the indirect draw.
    pub fn control(&self) -> &Buffer {
        &self.control
    }

    /// Uploads keys, at most as many as it was made for.
    pub fn load(&self, keys: &[u32]) -> Result<()> {
        self.keys
            .upload(bytemuck::cast_slice(&self.bits.pack(keys)))?;
        // A visible count that no sort gives shows a sort that writes none.
        let control = Control {
            key_count: keys.len() as u32,
            visible_count: u32::MAX,
            ..Control::default()
        };
        self.control.upload(bytemuck::bytes_of(&control))
    }

    /// Sorts once. The times are those of the sort's kernels.
    pub fn run(&self) -> Result<RunTimes> {
        self.run_after(|_| ())
    }

    /// Sorts once, after other transfers.
    pub fn run_after(&self, first: impl FnOnce(Recording)) -> Result<RunTimes> {
        let before = |commands: Recording| {
            first(commands);
            commands.barrier(Scope::TRANSFER_WRITES, Scope::KERNEL);
        };
        self.stopwatch
            .time("a sort", before, |commands| self.sort.record(commands))
    }

    /// Compares what the last run made of `keys` with what it should be. None: the same; otherwise
    /// what differs.
    pub fn difference(&self, keys: &[u32]) -> Result<Option<String>> {
        self.difference_from(&expected(keys, self.bits), keys.len())
    }

    /// Compares what the last run made of so many keys with the order that [`expected`] gives.
    /// None: the same; otherwise what differs.
    pub fn difference_from(&self, expected: &[u32], keys: usize) -> Result<Option<String>> {
        let control: Control =
            bytemuck::pod_read_unaligned(&self.control.download(size_of::<Control>())?);
        if control.visible_count as usize != expected.len() {
            return Ok(Some(format!(
                "{} of {} keys are visible, expected {}",
                control.visible_count,
                keys,
                expected.len()
            )));
        }
        let instances = control.visible_count.div_ceil(QUADS_PER_INSTANCE);
        if control.instance_count != instances {
            return Ok(Some(format!(
                "{} instances, expected {instances}",
                control.instance_count
            )));
        }
        let order = self.sort.download(control.visible_count)?;
        let wrong = (0..order.len()).find(|&at| order[at] != expected[at]);
        Ok(wrong.map(|at| {
            format!(
                "of {keys} keys, place {at} has index {}, expected {}",
                order[at], expected[at]
            )
        }))
    }
}

/// The order that a sort of so many bits must give.
pub fn expected(keys: &[u32], bits: KeyBits) -> Vec<u32> {
    let mask = u32::MAX >> (32 - bits.bits());
    let mut order: Vec<u32> = (0..keys.len() as u32)
        .filter(|&i| !bits.drops(keys[i as usize]))
        .collect();
    order.sort_by_key(|&i| keys[i as usize] & mask);
    order
}
