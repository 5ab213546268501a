//! Two frames under way: what each is timed and counted with, read back once the device is done
//! with it and nobody waits for it.

use super::{
    buffer::empty,
    device::Gpu,
    error::Result,
    owned::{Buffer, Owned, QuerySet},
    splat_buffer::SplatBuffer,
};
use effigy_core::{
    frame::{Counters, CullReasons, FrameReport, Stage, report::STAGES},
    layout::Control,
};
use std::sync::{
    Arc,
    atomic::{AtomicU8, Ordering},
};
use wgpu::{BufferUsages, MapMode};

/// Frames that may be under way at once.
pub const FRAMES_IN_FLIGHT: usize = 2;
/// Images that a frame draws avatars into: the atlas, and its own.
const LAYERS: usize = 2;
/// Bytes of a layer's counts.
const LAYER_COUNTS: u64 = size_of::<Control>() as u64 + CullReasons::BYTES;
/// Bytes of all layers' counts, before the timestamps.
const COUNTS: u64 = LAYERS as u64 * LAYER_COUNTS;
/// Timestamps of a frame: one before its first stage, and one after each.
const BORDERS: u32 = (LAYERS * STAGES.len()) as u32 + 1;
/// Bytes of all that is read back.
const SIZE: u64 = COUNTS + 8 * BORDERS as u64;

const FREE: u8 = 0;
const PENDING: u8 = 1;
const MAPPED: u8 = 2;
const FAILED: u8 = 3;

/// The timestamps that a pass writes: at its beginning, where no stage ran before, and at its end,
/// where its stage ends too.
pub type Writes = [Option<u32>; 2];

/// One of the frames under way.
pub struct FrameInFlight {
    queries: Option<(QuerySet, Buffer)>,
    period: f64,
    staging: Buffer,
    state: Arc<AtomicU8>,
    submission: Option<wgpu::SubmissionIndex>,
    known: Counters,
    counted: bool,
    /// Whether the control counts samples of the saturation depth, not fragments.
    samples: bool,
    /// Layers whose counts were copied.
    kept_layers: u64,
    marked: Vec<&'static str>,
    skipped: Vec<&'static str>,
}

impl FrameInFlight {
    pub fn new(gpu: &Gpu) -> Result<Self> {
        let queries = || -> Result<_> {
            let set = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("stages"),
                ty: wgpu::QueryType::Timestamp,
                count: BORDERS,
            });
            let usage = BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC;
            Ok((
                Owned(set),
                empty(gpu, "timestamps", 8 * u64::from(BORDERS), usage)?,
            ))
        };
        Ok(Self {
            queries: gpu.timestamps.then(queries).transpose()?,
            period: f64::from(gpu.queue.get_timestamp_period()) * 1e-6,
            staging: empty(
                gpu,
                "frame counts",
                SIZE,
                BufferUsages::MAP_READ | BufferUsages::COPY_DST,
            )?,
            state: Arc::new(AtomicU8::new(FREE)),
            submission: None,
            known: Counters::default(),
            counted: false,
            samples: false,
            kept_layers: 0,
            marked: Vec::with_capacity(LAYERS * STAGES.len()),
            skipped: Vec::with_capacity(STAGES.len()),
        })
    }

    /// Whether its frame is under way: submitted, and not yet reported done.
    pub fn is_pending(&self) -> bool {
        self.state.load(Ordering::Acquire) == PENDING
    }

    /// What to wait for, where a frame is under way.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn submission(&self) -> Option<wgpu::SubmissionIndex> {
        self.submission.clone().filter(|_| self.is_pending())
    }

    /// What its frame was, once.
    pub fn finish(&mut self) -> Option<FrameReport> {
        match self.state.load(Ordering::Acquire) {
            MAPPED => {}
            FAILED => {
                self.state.store(FREE, Ordering::Release);
                return None;
            }
            _ => return None,
        }
        let report = self
            .staging
            .get_mapped_range(..)
            .ok()
            .map(|bytes| self.report(&bytes));
        self.staging.unmap();
        self.state.store(FREE, Ordering::Release);
        report
    }

    fn report(&self, bytes: &[u8]) -> FrameReport {
        let (counts, ticks) = bytes.split_at(COUNTS as usize);
        // Sums over the layers.
        let mut control = Control::default();
        let mut reasons = [0; CullReasons::COUNT];
        let layers = counts.chunks_exact(LAYER_COUNTS as usize);
        for layer in layers.take(self.kept_layers as usize) {
            let (own, culled) = layer.split_at(size_of::<Control>());
            let own: Control = bytemuck::pod_read_unaligned(own);
            control.visible_count += own.visible_count;
            control.fragments += own.fragments;
            let culled: [u32; CullReasons::COUNT] = bytemuck::pod_read_unaligned(culled);
            for (sum, count) in reasons.iter_mut().zip(culled) {
                *sum += count;
            }
        }
        let evaluated =
            (self.counted && control.fragments > 0).then_some(u64::from(control.fragments));
        let counters = self.known.with_device_counts(
            &control,
            self.counted.then_some(reasons),
            evaluated.filter(|_| !self.samples),
            evaluated.filter(|_| self.samples),
        );
        let ticks: Vec<u64> = bytemuck::pod_collect_to_vec(ticks);
        let ms = |pair: &[u64]| pair[1].saturating_sub(pair[0]) as f64 * self.period;
        let stages = if self.queries.is_some() {
            let times = ticks.windows(2).map(ms);
            self.marked.iter().copied().zip(times).collect()
        } else {
            Vec::new()
        };
        FrameReport {
            stages,
            counters,
            skipped: self.skipped.clone(),
            ..FrameReport::default()
        }
    }

    /// Starts a frame. [`Self::is_pending`] must be false. `counted`: whether its kernels count
    /// reasons and fragments, which costs time.
    pub fn begin(&mut self, known: Counters, counted: bool) {
        self.known = known;
        self.counted = counted;
        self.samples = false;
        self.kept_layers = 0;
        self.marked.clear();
        self.skipped.clear();
    }

    /// Notes a stage that this frame does not need.
    pub fn skip(&mut self, stage: Stage) {
        self.skipped.push(stage.name());
    }

    /// The timestamps at the beginning and the end of a stage. Stages share their borders: the end
    /// of one is the beginning of the next.
    pub fn stage(&mut self, stage: Stage) -> Writes {
        self.samples |= stage == Stage::Saturation;
        let begin = self.marked.is_empty().then_some(0);
        self.marked.push(stage.name());
        [begin, Some(self.marked.len() as u32)]
    }

    /// Begins a compute pass that writes these timestamps, where the device has them.
    pub fn pass<'a>(
        &self,
        encoder: &'a mut wgpu::CommandEncoder,
        stage: Stage,
        writes: Writes,
    ) -> wgpu::ComputePass<'a> {
        let [beginning_of_pass_write_index, end_of_pass_write_index] = writes;
        let timestamp_writes =
            self.queries_of(writes)
                .map(|query_set| wgpu::ComputePassTimestampWrites {
                    query_set,
                    beginning_of_pass_write_index,
                    end_of_pass_write_index,
                });
        encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some(stage.name()),
            timestamp_writes,
        })
    }

    /// The timestamps of a render pass; None where it writes none.
    pub fn draw_writes(&self, writes: Writes) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        let [beginning_of_pass_write_index, end_of_pass_write_index] = writes;
        self.queries_of(writes)
            .map(|query_set| wgpu::RenderPassTimestampWrites {
                query_set,
                beginning_of_pass_write_index,
                end_of_pass_write_index,
            })
    }

    /// What a pass writes its timestamps to. None where the device has none, or the pass writes
    /// none: WebGPU refuses an empty list.
    fn queries_of(&self, writes: Writes) -> Option<&wgpu::QuerySet> {
        let (set, _) = self.queries.as_ref()?;
        writes.iter().any(Option::is_some).then_some(&**set)
    }

    /// Copies a layer's counts, before those of another replace them.
    pub fn keep_counts(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        control: &wgpu::Buffer,
        splats: &SplatBuffer,
    ) {
        let start = self.kept_layers * LAYER_COUNTS;
        self.kept_layers += 1;
        let size = size_of::<Control>() as u64;
        let mut copy = |from: &wgpu::Buffer, offset, to, size| {
            encoder.copy_buffer_to_buffer(from, offset, &self.staging, to, size);
        };
        copy(control, 0, start, size);
        let reasons = splats.reasons();
        copy(
            reasons.buffer,
            reasons.offset,
            start + size,
            CullReasons::BYTES,
        );
    }

    /// Copies the frame's counts, submits it, and has them mapped when it is done.
    pub fn submit(
        &mut self,
        gpu: &Gpu,
        mut encoder: wgpu::CommandEncoder,
        control: &wgpu::Buffer,
        splats: &SplatBuffer,
    ) {
        self.keep_counts(&mut encoder, control, splats);
        if let Some((set, resolved)) = self.queries.as_ref().filter(|_| !self.marked.is_empty()) {
            let borders = self.marked.len() as u32 + 1;
            encoder.resolve_query_set(set, 0..borders, resolved, 0);
            let size = 8 * u64::from(borders);
            encoder.copy_buffer_to_buffer(resolved, 0, &self.staging, COUNTS, size);
        }
        self.submission = Some(gpu.queue.submit([encoder.finish()]));
        self.state.store(PENDING, Ordering::Release);
        let state = self.state.clone();
        self.staging.map_async(MapMode::Read, .., move |result| {
            state.store(
                if result.is_ok() { MAPPED } else { FAILED },
                Ordering::Release,
            );
        });
    }
}
