//! Two frames in flight: a command buffer, a fence and a query pool each, and what a finished frame says about itself.

use super::{
    device::Gpu,
    error::{During, Result},
    memory::{Buffer, to_host},
    pipeline::Slice,
    splats::REASONS,
};
pub use crate::frame::report::{FrameReport, HostTimes, STAGES};
use crate::{
    frame::{Counters, Reasons},
    layout::Control,
};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::{sync::Arc, time::Instant};

/// Frames that may be under way at once.
pub const SLOTS: usize = 2;

/// [`FrameReport::stages`] and [`FrameReport::ticks`].
type Times = (Vec<(&'static str, f64)>, Vec<[u64; 2]>);

/// Who counts a frame's fragments.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Counted {
    No,
    /// The device's pipeline statistics.
    Statistics,
    /// The frame's kernels, in the control.
    Itself,
}

/// One of the frames under way.
pub struct Slot {
    gpu: Arc<Gpu>,
    pool: vk::CommandPool,
    pub commands: vk::CommandBuffer,
    fence: vk::Fence,
    queries: Option<vk::QueryPool>,
    /// Counts fragments.
    statistics: Option<vk::QueryPool>,
    counted: Counted,
    /// What was known of the frame before it was drawn.
    known: Counters,
    reasons: bool,
    /// The frame's counts, copied here by the device.
    counts: Buffer,
    /// Stages with a pair of timestamps in the frame under way.
    marked: Vec<&'static str>,
    skipped: Vec<&'static str>,
    /// Of the frame under way; it is not finished yet.
    host: Option<HostTimes>,
    pending: bool,
}

impl Slot {
    pub fn new(gpu: &Arc<Gpu>) -> Result<Self> {
        let size = size_of::<Control>() as u64 + REASONS;
        let counts = Buffer::new(gpu, "frame counts", size, vk::BufferUsageFlags::TRANSFER_DST, MemoryLocation::GpuToCpu)?;
        let mut slot = Self {
            gpu: gpu.clone(),
            pool: Default::default(),
            commands: Default::default(),
            fence: Default::default(),
            queries: None,
            statistics: None,
            counted: Counted::No,
            known: Counters::default(),
            reasons: false,
            counts,
            marked: Vec::with_capacity(STAGES.len()),
            skipped: Vec::with_capacity(STAGES.len()),
            host: None,
            pending: false,
        };
        // SAFETY: every structure outlives its call; what was made before a failure is destroyed by `drop`.
        unsafe {
            let info =
                vk::CommandPoolCreateInfo::default().queue_family_index(gpu.queue_family).flags(vk::CommandPoolCreateFlags::TRANSIENT);
            slot.pool = gpu.raw.create_command_pool(&info, None).during("vkCreateCommandPool")?;
            gpu.name(slot.pool, "frame");
            let info = vk::CommandBufferAllocateInfo::default().command_pool(slot.pool).command_buffer_count(1);
            slot.commands = gpu.raw.allocate_command_buffers(&info).during("vkAllocateCommandBuffers")?[0];
            gpu.name(slot.commands, "frame");
            slot.fence = gpu.raw.create_fence(&vk::FenceCreateInfo::default(), None).during("vkCreateFence")?;
            gpu.name(slot.fence, "frame done");
            if gpu.probe.timestamp_bits > 0 {
                let info = vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(2 * STAGES.len() as u32);
                let queries = gpu.raw.create_query_pool(&info, None).during("vkCreateQueryPool")?;
                gpu.name(queries, "times of stages");
                slot.queries = Some(queries);
            }
            if gpu.probe.pipeline_statistics {
                let info = vk::QueryPoolCreateInfo::default()
                    .query_type(vk::QueryType::PIPELINE_STATISTICS)
                    .query_count(1)
                    .pipeline_statistics(vk::QueryPipelineStatisticFlags::FRAGMENT_SHADER_INVOCATIONS);
                let statistics = gpu.raw.create_query_pool(&info, None).during("vkCreateQueryPool")?;
                gpu.name(statistics, "fragments");
                slot.statistics = Some(statistics);
            }
        }
        Ok(slot)
    }

    /// Waits until the slot's frame is done, and says what it was. None when none is under way.
    pub fn finish(&mut self) -> Result<Option<FrameReport>> {
        if !self.pending {
            return Ok(None);
        }
        self.gpu.wait(self.fence, "a frame")?;
        let finished = Instant::now();
        self.pending = false;
        let (control, reasons) = self.counts.mapped().split_at(size_of::<Control>());
        let control: Control = bytemuck::pod_read_unaligned(control);
        let [outside, hidden, faint, degenerate] = bytemuck::pod_read_unaligned::<[u32; 4]>(&reasons[..REASONS as usize]).map(u64::from);
        let drawn = u64::from(control.survivors);
        let counters = Counters {
            culled: self.known.gaussians.saturating_sub(drawn),
            drawn,
            reasons: self.reasons.then_some(Reasons { outside, hidden, faint, degenerate }),
            fragments: self.fragments(&control)?,
            ..self.known
        };
        let (stages, ticks) = self.times()?;
        let host = self.host.map(|host| HostTimes { finished, ..host });
        Ok(Some(FrameReport { stages, ticks, host, counters, skipped: self.skipped.clone() }))
    }

    /// The time of each stage, ms, and when it began and ended, ticks.
    fn times(&self) -> Result<Times> {
        let (Some(queries), false) = (self.queries, self.marked.is_empty()) else { return Ok(Default::default()) };
        let mut ticks = [0u64; 2 * STAGES.len()];
        let ticks = &mut ticks[..2 * self.marked.len()];
        // SAFETY: the frame is done, so the queries written in it are available.
        unsafe { self.gpu.raw.get_query_pool_results(queries, 0, ticks, vk::QueryResultFlags::TYPE_64) }.during("vkGetQueryPoolResults")?;
        let mask = self.gpu.probe.tick_mask();
        let period = f64::from(self.gpu.probe.limits.timestamp_period) * 1e-6;
        let ticks: Vec<_> = ticks.chunks_exact(2).map(|pair| [pair[0] & mask, pair[1] & mask]).collect();
        let ms = |[began, ended]: &[u64; 2]| (ended.wrapping_sub(*began) & mask) as f64 * period;
        Ok((self.marked.iter().copied().zip(ticks.iter().map(ms)).collect(), ticks))
    }

    /// Starts recording a frame. The slot must be finished.
    pub fn begin(&mut self) -> Result<vk::CommandBuffer> {
        self.marked.clear();
        self.skipped.clear();
        self.counted = Counted::No;
        // SAFETY: the slot's last frame is done, so its pool and fence are free.
        unsafe {
            self.gpu.raw.reset_command_pool(self.pool, vk::CommandPoolResetFlags::empty()).during("vkResetCommandPool")?;
            let info = vk::CommandBufferBeginInfo::default().flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
            self.gpu.raw.begin_command_buffer(self.commands, &info).during("vkBeginCommandBuffer")?;
            if let Some(queries) = self.queries {
                self.gpu.raw.cmd_reset_query_pool(self.commands, queries, 0, 2 * STAGES.len() as u32);
            }
            if let Some(statistics) = self.statistics {
                self.gpu.raw.cmd_reset_query_pool(self.commands, statistics, 0, 1);
            }
        }
        Ok(self.commands)
    }

    /// Records a stage between two timestamps, under its name in a GPU profiler.
    pub fn stage(&mut self, name: &'static str, record: impl FnOnce(vk::CommandBuffer)) {
        let first = 2 * self.marked.len() as u32;
        self.label(name);
        self.mark(vk::PipelineStageFlags::TOP_OF_PIPE, first);
        record(self.commands);
        self.mark(vk::PipelineStageFlags::BOTTOM_OF_PIPE, first + 1);
        if let Some(labels) = &self.gpu.labels {
            // SAFETY: the command buffer is recording, with the label above open.
            unsafe { labels.cmd_end_debug_utils_label(self.commands) };
        }
        self.marked.push(name);
    }

    /// The same for a stage that draws, whose fragments are counted where `count` asks for it and the device can.
    pub fn drawing(&mut self, name: &'static str, count: bool, record: impl FnOnce(vk::CommandBuffer)) {
        let gpu = self.gpu.clone();
        let statistics = self.statistics.filter(|_| count);
        self.counted = if statistics.is_some() { Counted::Statistics } else { Counted::No };
        self.stage(name, |commands| {
            // SAFETY: the command buffer is recording outside a render pass, the query was reset in `begin`.
            statistics.inspect(|&pool| unsafe { gpu.raw.cmd_begin_query(commands, pool, 0, vk::QueryControlFlags::empty()) });
            record(commands);
            // SAFETY: the query was begun above.
            statistics.inspect(|&pool| unsafe { gpu.raw.cmd_end_query(commands, pool, 0) });
        });
    }

    /// Notes what is known of the frame before it is drawn.
    pub fn note(&mut self, known: Counters) {
        self.known = known;
    }

    /// Notes that the frame's kernels count its fragments.
    pub fn counts_itself(&mut self) {
        self.counted = Counted::Itself;
    }

    fn fragments(&self, control: &Control) -> Result<Option<u64>> {
        if self.counted == Counted::Itself {
            return Ok(Some(control.fragments.into()));
        }
        let Some(statistics) = self.statistics.filter(|_| self.counted == Counted::Statistics) else { return Ok(None) };
        let mut count = [0u64];
        // SAFETY: the frame is done, so the query written in it is available.
        unsafe { self.gpu.raw.get_query_pool_results(statistics, 0, &mut count, vk::QueryResultFlags::TYPE_64) }
            .during("vkGetQueryPoolResults")?;
        Ok(Some(count[0]))
    }

    /// Notes when the host began the frame, got the slot, and had its commands written; it has just submitted them.
    pub fn timed(&mut self, [began, waited, recorded]: [Instant; 3]) {
        let submitted = Instant::now();
        self.host = Some(HostTimes { began, waited, recorded, submitted, finished: submitted });
    }

    /// Notes a stage that this frame does not need.
    pub fn skip(&mut self, name: &'static str) {
        self.skipped.push(name);
    }

    fn label(&self, name: &str) {
        let (Some(labels), Ok(name)) = (&self.gpu.labels, std::ffi::CString::new(name)) else { return };
        // SAFETY: the command buffer is recording; the name outlives the call.
        unsafe { labels.cmd_begin_debug_utils_label(self.commands, &vk::DebugUtilsLabelEXT::default().label_name(&name)) };
    }

    fn mark(&self, stage: vk::PipelineStageFlags, query: u32) {
        if let Some(queries) = self.queries {
            // SAFETY: the command buffer is recording, the query was reset in `begin`.
            unsafe { self.gpu.raw.cmd_write_timestamp(self.commands, stage, queries, query) };
        }
    }

    /// Copies the frame's counts, ends recording and submits. `reasons`: why Gaussians were left out, where that was counted.
    /// `semaphores`: what to wait for before colour output, and what to signal.
    pub fn submit(&mut self, control: &Buffer, reasons: Option<Slice>, semaphores: Option<(vk::Semaphore, vk::Semaphore)>) -> Result<()> {
        let device = &self.gpu.raw;
        let size = size_of::<Control>() as u64;
        let (wait, signal): (Vec<_>, Vec<_>) = semaphores.into_iter().unzip();
        let stages = [vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT];
        let commands = [self.commands];
        let submit = vk::SubmitInfo::default()
            .command_buffers(&commands)
            .wait_semaphores(&wait)
            .wait_dst_stage_mask(&stages[..wait.len()])
            .signal_semaphores(&signal);
        // SAFETY: the command buffer is recording; buffers, fence and semaphores are alive and free.
        unsafe {
            device.cmd_copy_buffer(self.commands, control.raw, self.counts.raw, &[vk::BufferCopy { src_offset: 0, dst_offset: 0, size }]);
            if let Some(reasons) = reasons {
                let region = vk::BufferCopy { src_offset: reasons.offset, dst_offset: size, size: reasons.size };
                device.cmd_copy_buffer(self.commands, reasons.buffer, self.counts.raw, &[region]);
            }
            to_host(&self.gpu, self.commands);
            device.end_command_buffer(self.commands).during("vkEndCommandBuffer")?;
            device.reset_fences(&[self.fence]).during("vkResetFences")?;
        }
        self.gpu.submit(&[submit], self.fence)?;
        self.reasons = reasons.is_some();
        self.pending = true;
        Ok(())
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        if self.pending
            && !self.gpu.hangs()
            && let Err(error) = self.gpu.wait(self.fence, "the last frame")
        {
            tracing::warn!("the last frame is not finished: {error}");
        }
        // SAFETY: the slot's frame is done, or the device is lost, or it hangs and nothing happens. Destroying null handles does nothing.
        self.gpu.destroy(|device| unsafe {
            device.destroy_query_pool(self.queries.unwrap_or_default(), None);
            device.destroy_query_pool(self.statistics.unwrap_or_default(), None);
            device.destroy_fence(self.fence, None);
            device.destroy_command_pool(self.pool, None);
        });
    }
}
