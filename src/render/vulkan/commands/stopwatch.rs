//! Times of work outside of frames: by the device's clock where it has one, and by the host's.

use crate::vulkan::device::{
    error::{During, Result},
    gpu::Gpu,
    handle::QueryPool,
    recording::Recording,
};
use ash::vk;
use std::{
    sync::Arc,
    time::{Duration, Instant},
};

/// How long some work took.
#[derive(Clone, Copy, Debug)]
pub struct RunTimes {
    /// From the work's start to its end on the device; as `wall` where the device has no
    /// timestamps.
    pub device: Duration,
    /// From hand-over to the host's knowing that it is done.
    pub wall: Duration,
}

/// Submits work, waits for it, and tells how long it took.
pub(crate) struct Stopwatch {
    gpu: Arc<Gpu>,
    /// Two timestamps. None where the device has none.
    queries: Option<QueryPool>,
}

impl Stopwatch {
    /// `name`: what it times.
    pub fn new(gpu: &Arc<Gpu>, name: &str) -> Result<Self> {
        let queries = if gpu.probe.timestamp_bits > 0 {
            Some(QueryPool::timestamps(&gpu.device, 2, name)?)
        } else {
            None
        };
        Ok(Self {
            gpu: gpu.clone(),
            queries,
        })
    }

    /// Times what `work` records, after what `before` records. `what`: the work, for errors.
    pub fn time(
        &self,
        what: &'static str,
        before: impl FnOnce(Recording),
        work: impl FnOnce(Recording),
    ) -> Result<RunTimes> {
        let start = Instant::now();
        self.gpu.run(what, |commands| {
            if let Some(queries) = &self.queries {
                let device = &self.gpu.raw;
                // SAFETY: the command buffer is recording; the pool is alive, and `run` waits.
                unsafe { device.cmd_reset_query_pool(commands.raw(), queries.raw(), 0, 2) };
            }
            before(commands);
            self.mark(commands, vk::PipelineStageFlags::TOP_OF_PIPE, 0);
            work(commands);
            self.mark(commands, vk::PipelineStageFlags::BOTTOM_OF_PIPE, 1);
        })?;
        let wall = start.elapsed();
        Ok(RunTimes {
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
}
