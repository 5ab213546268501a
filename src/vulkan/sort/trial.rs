//! A sort with keys of its own: runs it, times it, and compares the order with a stable sort on the CPU. For the self-test, the benchmark
//! and the tests.

use super::{KeyBits, Sort, SortOptions};
use crate::{
    layout::{Control, RASTER_QUADS},
    vulkan::{
        device::Gpu,
        error::{During, Result},
        memory::Buffer,
        pipeline::barrier,
    },
};
use ash::vk;
use std::{
    sync::Arc,
    time::{Duration, Instant},
};

/// A sort, and the buffers around it.
pub struct Trial {
    gpu: Arc<Gpu>,
    keys: Buffer,
    control: Buffer,
    sort: Sort,
    bits: KeyBits,
    /// Two timestamps. None where the device has none.
    queries: Option<vk::QueryPool>,
}

/// How long a run took.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// From the first kernel's start to the last one's end; as `wall` where the device has no timestamps.
    pub device: Duration,
    /// From hand-over to the host's knowing that it is done.
    pub wall: Duration,
}

impl Trial {
    pub fn new(gpu: &Arc<Gpu>, capacity: u32, options: SortOptions) -> Result<Self> {
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
        let keys = Buffer::new(gpu, "keys", 4 * u64::from(capacity), storage, gpu_allocator::MemoryLocation::GpuOnly)?;
        let control = Buffer::with_data(gpu, "control", bytemuck::bytes_of(&Control::default()), storage)?;
        let sort = Sort::new(gpu, (&keys).into(), &control, capacity, options)?;
        let info = vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(2);
        let queries = match gpu.probe.timestamp_bits {
            0 => None,
            // SAFETY: `info` outlives the call.
            _ => Some(unsafe { gpu.raw.create_query_pool(&info, None) }.during("vkCreateQueryPool")?)
                .inspect(|&pool| gpu.name(pool, "sort trial")),
        };
        Ok(Self { gpu: gpu.clone(), keys, control, sort, bits: options.bits, queries })
    }

    pub fn sort(&self) -> &Sort {
        &self.sort
    }

    /// What the sort reads and writes beside keys and order.
    pub fn control(&self) -> &Buffer {
        &self.control
    }

    /// Hands over keys, at most as many as there is room for.
    pub fn load(&self, keys: &[u32]) -> Result<()> {
        self.keys.upload(bytemuck::cast_slice(&self.bits.pack(keys)))?;
        // Survivors that no sort gives show a sort that writes none.
        let control = Control { entering: keys.len() as u32, survivors: u32::MAX, ..Control::default() };
        self.control.upload(bytemuck::bytes_of(&control))
    }

    /// Sorts once.
    pub fn run(&self) -> Result<Times> {
        self.run_after(|_| ())
    }

    /// The same after other transfers.
    pub fn run_after(&self, first: impl FnOnce(vk::CommandBuffer)) -> Result<Times> {
        let start = Instant::now();
        let mark = |commands, stage, query| {
            if let Some(queries) = self.queries {
                // SAFETY: the command buffer is recording; the pool is alive and was reset in it.
                unsafe { self.gpu.raw.cmd_write_timestamp(commands, stage, queries, query) };
            }
        };
        self.gpu.run("a sort", |commands| {
            if let Some(queries) = self.queries {
                // SAFETY: as above.
                unsafe { self.gpu.raw.cmd_reset_query_pool(commands, queries, 0, 2) };
            }
            first(commands);
            let transfer = (vk::PipelineStageFlags::TRANSFER, vk::AccessFlags::TRANSFER_WRITE);
            let compute = (vk::PipelineStageFlags::COMPUTE_SHADER, vk::AccessFlags::SHADER_READ | vk::AccessFlags::SHADER_WRITE);
            barrier(&self.gpu, commands, transfer, compute);
            mark(commands, vk::PipelineStageFlags::TOP_OF_PIPE, 0);
            self.sort.record(commands);
            mark(commands, vk::PipelineStageFlags::BOTTOM_OF_PIPE, 1);
        })?;
        let wall = start.elapsed();
        Ok(Times { device: self.device_time()?.unwrap_or(wall), wall })
    }

    fn device_time(&self) -> Result<Option<Duration>> {
        let Some(queries) = self.queries else { return Ok(None) };
        let mut ticks = [0u64; 2];
        // SAFETY: the run is done, so both queries are available.
        unsafe { self.gpu.raw.get_query_pool_results(queries, 0, &mut ticks, vk::QueryResultFlags::TYPE_64) }
            .during("vkGetQueryPoolResults")?;
        let bits = self.gpu.probe.timestamp_bits;
        let mask = if bits >= 64 { u64::MAX } else { (1 << bits) - 1 };
        let ns = (ticks[1].wrapping_sub(ticks[0]) & mask) as f64 * f64::from(self.gpu.probe.limits.timestamp_period);
        Ok(Some(Duration::from_nanos(ns as u64)))
    }

    /// Compares what the last run made of `keys` with what it should be. None: the same; otherwise what differs.
    pub fn difference(&self, keys: &[u32]) -> Result<Option<String>> {
        let expected = expected(keys, self.bits);
        let control: Control = bytemuck::pod_read_unaligned(&self.control.download(size_of::<Control>())?);
        if control.survivors as usize != expected.len() {
            return Ok(Some(format!("{} of {} keys survived, expected {}", control.survivors, keys.len(), expected.len())));
        }
        let instances = control.survivors.div_ceil(RASTER_QUADS);
        if control.instance_count != instances {
            return Ok(Some(format!("{} instances, expected {instances}", control.instance_count)));
        }
        let order = self.sort.download(control.survivors)?;
        let wrong = (0..order.len()).find(|&at| order[at] != expected[at]);
        Ok(wrong.map(|at| format!("of {} keys, place {at} has index {}, expected {}", keys.len(), order[at], expected[at])))
    }
}

impl Drop for Trial {
    fn drop(&mut self) {
        // SAFETY: every run was waited for. Destroying a null handle does nothing.
        self.gpu.destroy(|device| unsafe { device.destroy_query_pool(self.queries.unwrap_or_default(), None) });
    }
}

/// The order that a sort of so many bits must give.
pub fn expected(keys: &[u32], bits: KeyBits) -> Vec<u32> {
    let mask = u32::MAX >> (32 - 8 * bits.passes());
    let mut order: Vec<u32> = (0..keys.len() as u32).filter(|&i| !bits.drops(keys[i as usize])).collect();
    order.sort_by_key(|&i| keys[i as usize] & mask);
    order
}
