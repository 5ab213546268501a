//! Two frames in flight: a command buffer, a fence and a query pool each, and what a finished frame
//! says about itself.

use crate::vulkan::{
    device::{
        error::{During, Result},
        gpu::Gpu,
        handle::{CommandPool, Fence, QueryPool},
        recording::Recording,
    },
    memory::{Buffer, Slice},
};
use ash::vk;
use bytemuck::{Pod, Zeroable};
use effigy_core::{
    frame::{
        Counters, CullReasons,
        report::{FrameReport, HostTimes, STAGES},
    },
    layout::Control,
};
use gpu_allocator::MemoryLocation;
use std::{ffi::CString, mem::offset_of, sync::Arc, time::Instant};

/// Frames that may be under way at once.
pub const FRAMES_IN_FLIGHT: usize = 2;

/// Layers that a frame may have: the atlas and the image.
const LAYERS: usize = 2;
/// Timestamps of a frame: one before its first stage, and one after each, of each layer.
const BORDERS: usize = LAYERS * STAGES.len() + 1;
/// Bytes of the counts of a layer.
const LAYER_COUNTS: u64 = size_of::<LayerCounts>() as u64;

/// The counts of a layer, as the device copies them. What was not counted holds anything.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct LayerCounts {
    control: Control,
    reasons: [u32; CullReasons::COUNT],
    list_blocks: u32,
}

/// Where a layer's kernels leave their counts. What it holds must stay alive until the frame that
/// copies them is finished or dropped.
#[derive(Clone, Copy)]
pub struct CountSources {
    /// The control.
    pub control: Slice,
    /// How many Gaussians were culled for each reason, where they are counted.
    pub reasons: Option<Slice>,
    /// How many blocks the tiles' lists asked for, where there are such lists.
    pub list_blocks: Option<Slice>,
}

/// What a frame waits for and signals.
#[derive(Clone, Copy)]
pub struct Semaphores {
    /// Waited for before colour output: signalled when there is something to draw to.
    pub wait: vk::Semaphore,
    /// Signalled when the frame is drawn.
    pub signal: vk::Semaphore,
}

/// Times of a finished frame.
#[derive(Default)]
struct StageTimes {
    /// Milliseconds of each stage: [`FrameReport::stages`].
    stages: Vec<(&'static str, f64)>,
    /// When each stage began and ended: [`FrameReport::ticks`].
    ticks: Vec<[u64; 2]>,
}

/// When the host came how far with a frame.
pub struct HostMarks {
    /// It began the frame.
    pub began: Instant,
    /// The frame before it in this [`FrameInFlight`] was done.
    pub waited: Instant,
    /// The commands were written.
    pub recorded: Instant,
}

/// How a frame's fragments are counted.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Counted {
    No,
    /// The device's pipeline statistics.
    Statistics,
    /// The frame's kernels, in the control.
    Itself,
}

/// One of the frames under way.
pub struct FrameInFlight {
    gpu: Arc<Gpu>,
    commands: vk::CommandBuffer,
    /// The command buffer's.
    pool: CommandPool,
    fence: Fence,
    /// Timestamps: the borders of the stages. None where the device has none.
    queries: Option<QueryPool>,
    /// Counts fragments. None where the device can't.
    statistics: Option<QueryPool>,
    counted: Counted,
    /// Draws whose fragments the device's statistics count.
    counted_draws: u32,
    /// Layers whose counts were copied.
    kept_layers: u64,
    /// Whether the frame's kernels count samples of the saturation depth, in the control.
    samples: bool,
    /// What was known of the frame before it was drawn.
    known: Counters,
    reasons: bool,
    /// Whether list blocks were counted.
    has_lists: bool,
    /// [`Self::take_list_blocks`].
    list_blocks: Option<u32>,
    /// The frame's counts, copied here by the device.
    counts: Buffer,
    /// Stages of the frame under way, each with a timestamp after it.
    marked: Vec<&'static str>,
    skipped: Vec<&'static str>,
    /// Of the frame under way; it is not finished yet.
    host: Option<HostTimes>,
    pending: bool,
}

impl FrameInFlight {
    pub fn new(gpu: &Arc<Gpu>) -> Result<Self> {
        let counts = Buffer::new(
            gpu,
            "frame counts",
            LAYERS as u64 * LAYER_COUNTS,
            vk::BufferUsageFlags::TRANSFER_DST,
            MemoryLocation::GpuToCpu,
        )?;
        let pool = CommandPool::transient(&gpu.device, gpu.queue_family, "frame")?;
        let queries = if gpu.probe.timestamp_bits > 0 {
            Some(QueryPool::timestamps(
                &gpu.device,
                BORDERS as u32,
                "borders of stages",
            )?)
        } else {
            None
        };
        let statistics = if gpu.probe.pipeline_statistics {
            Some(QueryPool::fragments(
                &gpu.device,
                LAYERS as u32,
                "fragments",
            )?)
        } else {
            None
        };
        Ok(Self {
            gpu: gpu.clone(),
            commands: pool.allocate("frame")?,
            pool,
            fence: Fence::unsignalled(&gpu.device, "frame done")?,
            queries,
            statistics,
            counted: Counted::No,
            counted_draws: 0,
            kept_layers: 0,
            samples: false,
            known: Counters::default(),
            reasons: false,
            has_lists: false,
            list_blocks: None,
            counts,
            marked: Vec::with_capacity(STAGES.len()),
            skipped: Vec::with_capacity(STAGES.len()),
            host: None,
            pending: false,
        })
    }

    /// Waits until its frame is done, and reports on it. None where no frame is pending.
    pub fn finish(&mut self) -> Result<Option<FrameReport>> {
        if !self.pending {
            return Ok(None);
        }
        self.fence.wait("a frame")?;
        let finished = Instant::now();
        self.pending = false;
        let mut control = Control::default();
        let mut reasons = [0; CullReasons::COUNT];
        self.list_blocks = None;
        let counts = self.counts.mapped().chunks_exact(LAYER_COUNTS as usize);
        for layer in counts.take(self.kept_layers as usize) {
            let own: LayerCounts = bytemuck::pod_read_unaligned(layer);
            control.visible_count += own.control.visible_count;
            control.fragments += own.control.fragments;
            // Nothing writes what is not counted.
            if self.has_lists {
                self.list_blocks = self.list_blocks.max(Some(own.list_blocks));
            }
            for (sum, own) in reasons.iter_mut().zip(own.reasons) {
                *sum += if self.reasons { own } else { 0 };
            }
        }
        let counters = self.known.with_device_counts(
            &control,
            self.reasons.then_some(reasons),
            self.fragments(&control)?,
            self.samples.then(|| control.fragments.into()),
        );
        let times = self.times()?;
        let host = self.host.map(|host| HostTimes { finished, ..host });
        Ok(Some(FrameReport {
            stages: times.stages,
            ticks: times.ticks,
            host,
            counters,
            skipped: self.skipped.clone(),
        }))
    }

    /// The time of each stage, and when it began and ended: from one border to the next.
    fn times(&self) -> Result<StageTimes> {
        let Some(queries) = self.queries.as_ref().filter(|_| !self.marked.is_empty()) else {
            return Ok(StageTimes::default());
        };
        let mut borders = [0; BORDERS];
        let borders = &mut borders[..=self.marked.len()];
        queries.read(borders).during("vkGetQueryPoolResults")?;
        let mask = self.gpu.probe.tick_mask();
        let period = f64::from(self.gpu.probe.limits.timestamp_period) * 1e-6;
        let mut times = StageTimes::default();
        for (&name, pair) in self.marked.iter().zip(borders.windows(2)) {
            let [began, ended] = [pair[0] & mask, pair[1] & mask];
            let ms = (ended.wrapping_sub(began) & mask) as f64 * period;
            times.stages.push((name, ms));
            times.ticks.push([began, ended]);
        }
        Ok(times)
    }

    /// The most blocks that the tiles' lists of a layer of the last finished frame asked for: once
    /// for a frame, None where there were no lists.
    pub fn take_list_blocks(&mut self) -> Option<u32> {
        self.list_blocks.take()
    }

    /// Starts recording a frame. [`Self::finish`] must have returned.
    pub fn begin(&mut self) -> Result<()> {
        self.marked.clear();
        self.skipped.clear();
        self.counted = Counted::No;
        self.counted_draws = 0;
        self.kept_layers = 0;
        self.samples = false;
        let device = &self.gpu.raw;
        // SAFETY: its last frame is done, so its pool, and with it the command buffer, is free.
        unsafe {
            device
                .reset_command_pool(self.pool.raw(), vk::CommandPoolResetFlags::empty())
                .during("vkResetCommandPool")?;
            let info = vk::CommandBufferBeginInfo::default()
                .flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
            device
                .begin_command_buffer(self.commands, &info)
                .during("vkBeginCommandBuffer")?;
            if let Some(queries) = &self.queries {
                device.cmd_reset_query_pool(self.commands, queries.raw(), 0, BORDERS as u32);
            }
            if let Some(statistics) = &self.statistics {
                device.cmd_reset_query_pool(self.commands, statistics.raw(), 0, LAYERS as u32);
            }
        }
        Ok(())
    }

    /// The command buffer, between [`Self::begin`] and [`Self::submit`].
    fn recording(&self) -> Recording<'_> {
        // SAFETY: the renderer begins a frame before it records stages, and submits it after that.
        unsafe { Recording::new(&self.gpu, self.commands) }
    }

    /// Records what is no stage. Its time counts to the stage that follows.
    pub fn record(&self, record: impl FnOnce(Recording)) {
        record(self.recording());
    }

    /// Records a stage under its name in a GPU profiler, and the border after it.
    pub fn stage(&mut self, name: &'static str, record: impl FnOnce(Recording)) {
        if self.marked.is_empty() {
            self.border(0);
        }
        self.label(name);
        record(self.recording());
        self.border(self.marked.len() as u32 + 1);
        if let Some(labels) = &self.gpu.labels {
            // SAFETY: the command buffer is recording, with the label above open.
            unsafe { labels.cmd_end_debug_utils_label(self.commands) };
        }
        self.marked.push(name);
    }

    /// Records a stage that draws, whose fragments are counted where `count` asks for it and the
    /// device can.
    pub fn drawing(&mut self, name: &'static str, count: bool, record: impl FnOnce(Recording)) {
        let Some(pool) = self.statistics.as_ref().filter(|_| count) else {
            self.counted = Counted::No;
            self.stage(name, record);
            return;
        };
        let pool = pool.raw();
        let gpu = self.gpu.clone();
        self.counted = Counted::Statistics;
        let query = self.counted_draws;
        self.counted_draws += 1;
        self.stage(name, |commands| {
            let none = vk::QueryControlFlags::empty();
            // SAFETY: the command buffer is recording outside a render pass; the pool is alive, and
            // its query was reset in `begin`.
            unsafe { gpu.raw.cmd_begin_query(commands.raw(), pool, query, none) };
            record(commands);
            // SAFETY: the query was begun above.
            unsafe { gpu.raw.cmd_end_query(commands.raw(), pool, query) };
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

    /// Notes that the frame's kernels count samples of the saturation depth.
    pub fn counts_samples(&mut self) {
        self.samples = true;
    }

    /// How many fragments the finished frame had, where they were counted.
    fn fragments(&self, control: &Control) -> Result<Option<u64>> {
        match (self.counted, &self.statistics) {
            (Counted::Itself, _) => Ok(Some(control.fragments.into())),
            (Counted::Statistics, Some(statistics)) => {
                let mut counts = [0; LAYERS];
                let counts = &mut counts[..self.counted_draws as usize];
                statistics.read(counts).during("vkGetQueryPoolResults")?;
                Ok(Some(counts.iter().sum()))
            }
            _ => Ok(None),
        }
    }

    /// Notes how far the host had come when, with a frame that it has just submitted.
    pub fn timed(&mut self, marks: HostMarks) {
        let submitted = Instant::now();
        self.host = Some(HostTimes {
            began: marks.began,
            waited: marks.waited,
            recorded: marks.recorded,
            submitted,
            finished: submitted,
        });
    }

    /// Notes a stage that this frame does not need.
    pub fn skip(&mut self, name: &'static str) {
        self.skipped.push(name);
    }

    fn label(&self, name: &str) {
        let Some(labels) = &self.gpu.labels else {
            return;
        };
        let Ok(name) = CString::new(name) else {
            return;
        };
        // SAFETY: the command buffer is recording; the name outlives the call.
        unsafe {
            labels.cmd_begin_debug_utils_label(
                self.commands,
                &vk::DebugUtilsLabelEXT::default().label_name(&name),
            )
        };
    }

    /// Has the device write its clock once all work recorded before is done. Two stages share such
    /// a border: a timestamp at a stage's beginning may be written before the stage waits for the
    /// one before it, or, by a driver that defers it, once the stage is done.
    fn border(&self, query: u32) {
        if let Some(queries) = &self.queries {
            // SAFETY: the command buffer is recording, the query was reset in `begin`.
            unsafe {
                self.gpu.raw.cmd_write_timestamp(
                    self.commands,
                    vk::PipelineStageFlags::BOTTOM_OF_PIPE,
                    queries.raw(),
                    query,
                )
            };
        }
    }

    /// Adds a layer's counts to the frame's: a transfer.
    ///
    /// # Safety
    /// It must be recording outside a render pass, with at most one layer kept before, and the
    /// sources must stay alive until this frame is finished or dropped.
    pub unsafe fn keep_counts(&mut self, sources: CountSources) {
        let start = self.kept_layers * LAYER_COUNTS;
        self.kept_layers += 1;
        let copy = |from: Slice, at: usize| {
            let region = vk::BufferCopy {
                src_offset: from.offset,
                dst_offset: start + at as u64,
                size: from.size,
            };
            let to = self.counts.raw();
            // SAFETY: the command buffer is recording, as the caller promises; both buffers are
            // alive and hold the region.
            unsafe {
                self.gpu
                    .raw
                    .cmd_copy_buffer(self.commands, from.buffer, to, &[region])
            };
        };
        let control = sources.control.part(0, size_of::<Control>() as u64);
        copy(control, offset_of!(LayerCounts, control));
        if let Some(reasons) = sources.reasons {
            copy(reasons, offset_of!(LayerCounts, reasons));
        }
        if let Some(list_blocks) = sources.list_blocks {
            copy(list_blocks, offset_of!(LayerCounts, list_blocks));
        }
    }

    /// Copies the frame's counts, ends recording and submits.
    ///
    /// # Safety
    /// It must be recording. All that was recorded since [`Self::begin`], the sources and the
    /// semaphores must stay alive until this frame is finished or dropped. Something must signal
    /// the one semaphore, and nothing else use the other.
    pub unsafe fn submit(
        &mut self,
        sources: CountSources,
        semaphores: Option<Semaphores>,
    ) -> Result<()> {
        // SAFETY: the caller promises that it is recording and that the buffers stay alive.
        unsafe { self.keep_counts(sources) };
        let device = &self.gpu.raw;
        self.recording().show_host();
        // SAFETY: the command buffer is recording, and the fence is free: its last frame is done.
        unsafe {
            device
                .end_command_buffer(self.commands)
                .during("vkEndCommandBuffer")?;
            device
                .reset_fences(&[self.fence.raw()])
                .during("vkResetFences")?;
        }
        let commands = [self.commands];
        let stages = [vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT];
        let mut work = vk::SubmitInfo::default().command_buffers(&commands);
        let wait = semaphores.map(|semaphores| [semaphores.wait]);
        let signal = semaphores.map(|semaphores| [semaphores.signal]);
        if let (Some(wait), Some(signal)) = (&wait, &signal) {
            work = work
                .wait_semaphores(wait)
                .wait_dst_stage_mask(&stages)
                .signal_semaphores(signal);
        }
        // SAFETY: commands and fence are ready; the caller promises that the semaphores are, and
        // that all of it stays alive until the fence is waited for.
        unsafe { self.gpu.submit(&[work], &self.fence) }?;
        self.reasons = sources.reasons.is_some();
        self.has_lists = sources.list_blocks.is_some();
        self.pending = true;
        Ok(())
    }
}

impl Drop for FrameInFlight {
    fn drop(&mut self) {
        if self.pending
            && !self.gpu.hangs()
            && let Err(error) = self.fence.wait("the last frame")
        {
            tracing::warn!("the last frame is not finished: {error}");
        }
    }
}
