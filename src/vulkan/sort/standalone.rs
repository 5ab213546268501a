//! A sort with keys of its own: runs it, times it, and compares the order with a stable sort on the
//! CPU. For the self-test, the benchmark and the tests.

use super::{options::SortOptions, stage::Sort};
use crate::vulkan::{
    device::{
        error::{During, Result},
        gpu::Gpu,
        handle::QueryPool,
        recording::Recording,
    },
    memory::{Buffer, Scope},
};
use ash::vk;
use effigy_core::{
    frame::KeyBits,
    layout::{Control, QUADS_PER_INSTANCE},
};
use std::{
    sync::Arc,
    time::{Duration, Instant},
};

/// A sort, and the buffers around it.
pub struct StandaloneSort {
    gpu: Arc<Gpu>,
    keys: Buffer,
    control: Buffer,
    sort: Sort,
    bits: KeyBits,
    /// Two timestamps. None where the device has none.
    queries: Option<QueryPool>,
}

/// How long a run took.
#[derive(Clone, Copy, Debug)]
pub struct SortTimes {
    /// From the first kernel's start to the last one's end; as `wall` where the device has no
    /// timestamps.
    pub device: Duration,
    /// From hand-over to the host's knowing that it is done.
    pub wall: Duration,
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
        let queries = if gpu.probe.timestamp_bits > 0 {
            Some(QueryPool::timestamps(&gpu.device, 2, "standalone sort")?)
        } else {
            None
        };
        Ok(Self {
            gpu: gpu.clone(),
            keys,
            control,
            sort,
            bits: options.bits,
            queries,
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

    /// Sorts once.
    pub fn run(&self) -> Result<SortTimes> {
        self.run_after(|_| ())
    }

    /// Sorts once, after other transfers.
    pub fn run_after(&self, first: impl FnOnce(Recording)) -> Result<SortTimes> {
        let start = Instant::now();
        self.gpu.run("a sort", |commands| {
            if let Some(queries) = &self.queries {
                let device = &self.gpu.raw;
                // SAFETY: the command buffer is recording; the pool is alive, and `run` waits.
                unsafe { device.cmd_reset_query_pool(commands.raw(), queries.raw(), 0, 2) };
            }
            first(commands);
            commands.barrier(Scope::TRANSFER_WRITES, Scope::KERNEL);
            self.mark(commands, vk::PipelineStageFlags::TOP_OF_PIPE, 0);
            self.sort.record(commands);
            self.mark(commands, vk::PipelineStageFlags::BOTTOM_OF_PIPE, 1);
        })?;
        let wall = start.elapsed();
        Ok(SortTimes {
            device: self.device_time()?.unwrap_or(wall),
            wall,
        })
    }

    fn mark(&self, commands: Recording, stage: vk::PipelineStageFlags, query: u32) {
        if let Some(queries) = &self.queries {
            let device = &self.gpu.raw;
            // SAFETY: the command buffer is recording; the pool is alive and was reset in it.
            unsafe { device.cmd_write_timestamp(commands.raw(), stage, queries.raw(), query) };
        }
    }

    fn device_time(&self) -> Result<Option<Duration>> {
        let Some(queries) = &self.queries else {
            return Ok(None);
        };
        let mut ticks = [0; 2];
        queries.read(&mut ticks).during("vkGetQueryPoolResults")?;
        let ticks = ticks[1].wrapping_sub(ticks[0]) & self.gpu.probe.tick_mask();
        let ns = ticks as f64 * f64::from(self.gpu.probe.limits.timestamp_period);
        Ok(Some(Duration::from_nanos(ns as u64)))
    }

    /// Compares what the last run made of `keys` with what it should be. None: the same; otherwise
    /// what differs.
    pub fn difference(&self, keys: &[u32]) -> Result<Option<String>> {
        let expected = expected(keys, self.bits);
        let control: Control =
            bytemuck::pod_read_unaligned(&self.control.download(size_of::<Control>())?);
        if control.visible_count as usize != expected.len() {
            return Ok(Some(format!(
                "{} of {} keys are visible, expected {}",
                control.visible_count,
                keys.len(),
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
                "of {} keys, place {at} has index {}, expected {}",
                keys.len(),
                order[at],
                expected[at]
            )
        }))
    }
}

/// The order that a sort of so many bits must give.
pub fn expected(keys: &[u32], bits: KeyBits) -> Vec<u32> {
    let mask = u32::MAX >> (32 - 8 * bits.passes());
    let mut order: Vec<u32> = (0..keys.len() as u32)
        .filter(|&i| !bits.drops(keys[i as usize]))
        .collect();
    order.sort_by_key(|&i| keys[i as usize] & mask);
    order
}
