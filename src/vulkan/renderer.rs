//! Draws one avatar: a pose and a camera go in, a picture on the device comes out. [`Renderer::record`] is the frame, top to bottom.

use super::{
    block, check,
    commands::{FrameReport, SLOTS, Slot},
    device::Gpu,
    error::Result,
    features::Features,
    harmonics::Harmonics,
    keeper::Keeper,
    memory::Buffer,
    model::Model,
    picture::Copied,
    pipeline::{Slice, barrier},
    raster::{ColorFormat, Raster},
    sort::{KeyBits, Sort, SortOptions, Variant, choice},
    splats::Splats,
    surface::{PYRAMID_WORDS, Place, Surface},
};
use crate::{
    avatar::Avatar,
    frame::{ALPHA_MIN, Body, Camera, Counters, Extent, Needed, Needs, PartSet, Picture, Plan, Posed, Skip},
    layout::{Control, Frame, RASTER_QUADS},
};
use ash::vk::{self, AccessFlags, PipelineStageFlags};
use bytemuck::{bytes_of, from_bytes_mut};
use gpu_allocator::MemoryLocation;
use half::f16;
use std::sync::Arc;

/// What a renderer is made with.
#[derive(Clone, Copy, Debug)]
pub struct RendererOptions {
    /// Width and height of the picture, px.
    pub size: [u32; 2],
    pub color: ColorFormat,
    pub key_bits: KeyBits,
    /// How to sort. None: as the self-test finds best.
    pub sort: Option<Variant>,
    /// What is left out where the scene doesn't need it.
    pub skip: Skip,
    /// Contributions below this opacity are not drawn, at least 1/255 (model.md, step 10).
    pub cutoff: f64,
    /// How far behind the depth surface something is hidden, metres.
    pub margin: f64,
    /// Count fragments, where the device can: for measurements, since some devices are slower then.
    pub count: bool,
}

impl RendererOptions {
    /// The defaults at a size.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            size,
            color: ColorFormat::default(),
            key_bits: KeyBits::default(),
            sort: None,
            skip: Skip::all() - Skip::DEPTH,
            cutoff: ALPHA_MIN,
            margin: 0.005,
            count: false,
        }
    }
}

/// How a frame reaches a window: what to wait for and signal, and the commands that follow the picture.
pub struct Presentation<'a> {
    pub acquired: vk::Semaphore,
    pub finished: vk::Semaphore,
    pub record: &'a mut dyn FnMut(vk::CommandBuffer),
}

/// A stage's buffers read back, for tests.
pub struct Stages {
    /// Shape N_G, length of e.
    pub features: Vec<f32>,
    /// One displacement a node, metres; the fourth number is unused.
    pub nodes: Vec<[f32; 4]>,
    /// RGB of every Gaussian before correctives.
    pub colors: Vec<[f32; 3]>,
    pub splats: Vec<[u32; 4]>,
    pub keys: Vec<u32>,
    pub order: Vec<u32>,
    pub control: Control,
}

/// What a frame does with the avatar's parts.
struct Parts {
    outside: PartSet,
    /// Those that run.
    networks: PartSet,
}

/// An avatar on a device.
pub struct Renderer {
    // Slots come first: dropping them waits for the frames that use all else.
    slots: Vec<Slot>,
    surface: Surface,
    features: Features,
    harmonics: Option<Harmonics>,
    splats: Splats,
    sort: Sort,
    raster: Raster,
    control: Buffer,
    /// Features, then node displacements, then the depth surface's pyramid.
    pose: Buffer,
    frames: Buffer,
    model: Model,
    extent: Extent,
    needs: Needs,
    /// What was kept where only the camera moves.
    keeper: Keeper,
    options: RendererOptions,
    plan: Plan,
    next: usize,
    report: FrameReport,
    gpu: Arc<Gpu>,
}

/// Bytes from one frame's uniform block to the next: every device's alignment divides 256.
const FRAME_STRIDE: usize = size_of::<Frame>().next_multiple_of(256);

impl Renderer {
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        options.check()?;
        let surfaces = options.skip.intersects(Skip::HIDDEN | Skip::DEPTH);
        let model = Model::new(gpu, avatar, surfaces)?;
        let constants = &model.constants;
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC;
        let words = 4 * u64::from(constants.node_start) + 2 * u64::from(constants.nodes) + u64::from(PYRAMID_WORDS);
        // Zeros: a corner of the depth surface may follow a node of a part that no frame has shown yet.
        let pose = Buffer::with_data(gpu, "pose", &vec![0; 4 * words.next_multiple_of(2) as usize], storage)?;
        let frames = (SLOTS * FRAME_STRIDE) as u64;
        let mut frames = Buffer::new(gpu, "frames", frames, vk::BufferUsageFlags::UNIFORM_BUFFER, MemoryLocation::CpuToGpu)?;
        for slot in 0..SLOTS {
            frames.mapped()[slot * FRAME_STRIDE..][..size_of::<Frame>()].copy_from_slice(bytes_of(&*model.constants));
        }
        let control = Control { index_count: 6 * RASTER_QUADS, entering: constants.gaussians, ..Control::default() };
        let control = Buffer::with_data(gpu, "control", bytes_of(&control), storage | vk::BufferUsageFlags::INDIRECT_BUFFER)?;
        let frame = Slice { buffer: frames.raw, offset: 0, size: size_of::<Frame>() as u64 };
        let variant = options.sort.map_or_else(|| choice::choose(gpu).map(|verdict| verdict.variant), Ok)?;
        // Where colours change with the view, nothing is kept.
        let options =
            RendererOptions { skip: if avatar.harmonics.is_some() { options.skip - Skip::SKINNING } else { options.skip }, ..options };
        let keep = options.skip.contains(Skip::SKINNING);
        let splats = Splats::new(gpu, &model, frame, (&pose).into(), (options.key_bits, variant), keep)?;
        let sort_options = SortOptions { counts: Some(splats.counts()), ..SortOptions::new(options.key_bits, variant) };
        let sort = Sort::new(gpu, splats.keys(), &control, constants.gaussians, sort_options)?;
        let raster = Raster::new(gpu, frame, [sort.order(), splats.all(), (&control).into()], (&model.occluder, (&pose).into()), &options)?;
        Ok(Self {
            slots: (0..SLOTS).map(|_| Slot::new(gpu)).collect::<Result<_>>()?,
            surface: Surface::new(gpu, frame, &model.occluder, (&pose).into())?,
            features: Features::new(gpu, &model, frame, (&pose).into())?,
            harmonics: Harmonics::new(gpu, avatar, &model, frame)?,
            splats,
            sort,
            raster,
            control,
            pose,
            frames,
            extent: Extent::new(avatar),
            needs: Needs::new(avatar),
            keeper: Keeper::default(),
            model,
            options,
            plan: Plan::default(),
            next: 0,
            report: FrameReport::default(),
            gpu: gpu.clone(),
        })
    }

    pub fn gpu(&self) -> &Arc<Gpu> {
        &self.gpu
    }

    /// How far the avatar reaches.
    pub fn extent(&self) -> &Extent {
        &self.extent
    }

    /// Corners and triangles of the depth surface.
    pub fn surface_size(&self) -> [u64; 2] {
        let mesh = &self.model.occluder;
        [mesh.corners.size / 32, u64::from(mesh.index_count / 3)]
    }

    /// The stage that holds the picture.
    pub fn raster(&self) -> &Raster {
        &self.raster
    }

    /// What the last finished frame took and drew: at most two frames old. A frame that needed nothing is finished at once.
    pub fn report(&self) -> &FrameReport {
        &self.report
    }

    /// Submits a frame. Waits only when two frames are still under way. `camera` must have the picture's size.
    ///
    /// # Errors
    /// When the pose or the camera holds a number that can't be drawn, or the device fails.
    pub fn draw(&mut self, posed: &Posed, camera: &Camera, presentation: Option<Presentation>) -> Result<()> {
        check::frame(posed, camera, (&self.model.constants, &self.extent), self.options.size)?;
        let slot = self.next;
        if let Some(report) = self.slots[slot].finish()? {
            self.report = report;
        }
        // Should anything below fail, nothing of this frame counts as drawn.
        let mut plan = std::mem::take(&mut self.plan);
        let needed = plan.next(posed, camera, self.options.skip);
        if !needed.view && presentation.is_none() {
            self.plan = plan;
            self.report = FrameReport::idle(self.harmonics.is_some());
            return Ok(());
        }
        let seen = self.options.skip.contains(Skip::PARTS).then(|| self.extent.visible(&posed.joints, camera));
        let networks = plan.networks(&needed, &self.needs, seen.as_ref());
        let outside = seen.filter(|_| needed.body != Body::Keep).map_or(PartSet::EMPTY, |seen| self.needs.all() - seen);
        let parts = Parts { outside, networks };
        let surface = self.write_frame(slot, posed, camera, (needed.body, &parts));
        self.slots[slot].begin()?;
        self.record(slot, needed, &parts, surface);
        let semaphores = presentation.map(|presentation| {
            self.slots[slot].stage("present", presentation.record);
            (presentation.acquired, presentation.finished)
        });
        self.slots[slot].submit(&self.control, semaphores)?;
        self.plan = plan;
        self.next = (slot + 1) % SLOTS;
        Ok(())
    }

    /// The frame: which stages run, in which order, and what each waits for.
    fn record(&mut self, slot: usize, needed: Needed, parts: &Parts, place: Option<Place>) {
        let frame = (slot * FRAME_STRIDE) as u32;
        let Self { slots, options, features, harmonics, surface, splats, sort, raster, control, gpu, model, .. } = self;
        let constants = &model.constants;
        let slot = &mut slots[slot];
        let commands = slot.commands;
        let compute = PipelineStageFlags::COMPUTE_SHADER;
        let written = (compute, AccessFlags::SHADER_WRITE);
        let shared = (compute, AccessFlags::SHADER_READ | AccessFlags::SHADER_WRITE);
        let place = place.as_ref();
        let hides = place.filter(|_| options.skip.contains(Skip::HIDDEN));
        let networks = parts.networks;
        let view = 1 + u64::from(harmonics.is_some()) + u64::from(hides.is_some()) + sort.dispatches(true) as u64;
        slot.count(Counters {
            networks: networks.len() as u64,
            parts_outside: parts.outside.len() as u64,
            kept: if needed.view && needed.body == Body::Kept { constants.gaussians.into() } else { 0 },
            dispatches: u64::from(!networks.is_empty()) + if needed.view { view } else { 0 },
            ..Counters::default()
        });
        // The frame before may still read what this one writes.
        let readers = compute | PipelineStageFlags::VERTEX_SHADER | PipelineStageFlags::DRAW_INDIRECT | PipelineStageFlags::TRANSFER;
        let cleared = (PipelineStageFlags::TRANSFER, AccessFlags::TRANSFER_WRITE);
        barrier(gpu, commands, (readers, AccessFlags::SHADER_WRITE), (compute | cleared.0, shared.1 | cleared.1));
        if networks.is_empty() {
            slot.skip("features");
        } else {
            slot.stage("features", |commands| features.record(commands, frame, networks.end() as u32));
            barrier(gpu, commands, written, (compute | PipelineStageFlags::VERTEX_SHADER, shared.1));
        }
        if needed.view {
            sort.clear(commands);
            if let Some(harmonics) = harmonics {
                slot.stage("harmonics", |commands| harmonics.record(commands, frame));
                barrier(gpu, commands, written, shared);
            }
            if let Some(place) = hides {
                slot.stage("surface", |commands| surface.record(commands, frame, place));
                barrier(gpu, commands, written, shared);
            }
            barrier(gpu, commands, cleared, shared);
            slot.stage("splats", |commands| splats.record(commands, frame, needed.body));
            barrier(gpu, commands, written, shared);
            slot.stage("sort", |commands| sort.record_counted(commands));
            let draw = PipelineStageFlags::DRAW_INDIRECT | PipelineStageFlags::VERTEX_SHADER | PipelineStageFlags::TRANSFER;
            let reads = AccessFlags::INDIRECT_COMMAND_READ | AccessFlags::SHADER_READ | AccessFlags::TRANSFER_READ;
            barrier(gpu, commands, written, (draw, reads));
            let count = options.count;
            slot.drawing("raster", count, |commands| {
                raster.record(commands, frame, control.raw, place.is_some() && options.skip.contains(Skip::DEPTH))
            });
        } else {
            harmonics.iter().for_each(|_| slot.skip("harmonics"));
            ["splats", "sort", "raster"].into_iter().for_each(|stage| slot.skip(stage));
        }
    }

    /// Fills the frame's uniform block, and says where the depth surface is worth drawing.
    fn write_frame(&mut self, slot: usize, posed: &Posed, camera: &Camera, (body, parts): (Body, &Parts)) -> Option<Place> {
        let any = self.model.occluder.index_count > 0 && self.options.skip.intersects(Skip::HIDDEN | Skip::DEPTH);
        let place = any.then(|| Place::new(camera.size, self.extent.screen(&posed.joints, camera)));
        let block: &mut Frame = from_bytes_mut(&mut self.frames.mapped()[slot * FRAME_STRIDE..][..size_of::<Frame>()]);
        let depth = self.extent.depth(&posed.joints, camera);
        block::fill(block, &self.options, (depth, place), posed, camera);
        self.splats.fill(block);
        block.count_tile = self.sort.tile();
        block.idle = parts.networks.others().bits();
        block.outside = parts.outside.bits();
        if body == Body::Keep {
            self.keeper = Keeper::new(&self.extent, posed, camera);
        }
        self.keeper.fill(block, camera);
        place
    }

    /// Waits for every submitted frame.
    pub fn finish(&mut self) -> Result<()> {
        for offset in 0..SLOTS {
            if let Some(report) = self.slots[(self.next + offset) % SLOTS].finish()? {
                self.report = report;
            }
        }
        Ok(())
    }

    /// Changes the picture's size. On failure the old picture stays.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.finish()?;
        self.raster.resize(size)?;
        self.options.size = size;
        self.plan = Plan::default();
        Ok(())
    }

    /// Waits, and copies the picture of the last frame to the host.
    pub fn picture(&mut self) -> Result<Picture> {
        Ok(self.copy()?.decode())
    }

    /// The same without the work of decoding it.
    pub fn copy(&mut self) -> Result<Copied> {
        self.finish()?;
        super::picture::download(&self.gpu, &self.raster)
    }

    /// Waits, and copies every stage's output of the last frame to the host.
    pub fn stages(&mut self) -> Result<Stages> {
        self.finish()?;
        let constants = &self.model.constants;
        let features = 16 * constants.node_start as usize;
        let pose = self.pose.download(features + 8 * constants.nodes as usize)?;
        let nodes: Vec<[f16; 4]> = bytemuck::pod_collect_to_vec(&pose[features..]);
        let (splats, keys) = self.splats.download()?;
        let control: Control = bytemuck::pod_read_unaligned(&self.control.download(size_of::<Control>())?);
        Ok(Stages {
            features: bytemuck::pod_collect_to_vec(&pose[..features]),
            nodes: self.model.node_places.iter().map(|&place| nodes[usize::from(place)].map(f16::to_f32)).collect(),
            colors: self.model.colors()?,
            splats,
            keys,
            order: self.sort.download(control.survivors)?,
            control,
        })
    }
}
