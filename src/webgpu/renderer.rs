//! Draws an avatar, or several copies of it in one scene: poses and a camera go in, an image on the
//! device comes out. [`Schedule::new`] says what a frame runs, `Renderer::execute` runs it.

use super::{
    buffer::{STORAGE, empty},
    device::Gpu,
    error::Result,
    frame_in_flight::{FRAMES_IN_FLIGHT, FrameInFlight},
    kernel::{Blocks, FRAME_STRIDE},
    mlp::Mlp,
    model::Model,
    occluder::OccluderPass,
    options::accepted,
    owned::Buffer,
    project::Project,
    raster::{Raster, RasterInputs},
    sh::SphericalHarmonics,
    sort::{self, Sort, SortInputs},
};
use bytemuck::bytes_of;
use effigy_core::{
    avatar::Avatar,
    frame::{
        Counters, Damage, FrameReport, RasterMethod, RendererOptions, Schedule, Skinning, block,
        passes::Pass,
        pose_cache::PoseCache,
        schedule::{Command, DeviceState, Equipment, ScheduledStage, Step},
        state::{AvatarInstance, FramePlan, FrameState, PlanInput, StageDispatches},
        validate,
    },
    layout::{
        Control, FrameBlock, PYRAMID_WORDS, QUADS_PER_INSTANCE, SORT_TILE, SettingsBlock,
        TILING_WEB,
    },
    scene::{AvatarBounds, Camera, PartDependencies, PixelRect, Posed},
};
use std::sync::Arc;

/// An avatar on a device, in as many poses as it was made for.
pub struct Renderer {
    pub(super) frames_in_flight: Vec<FrameInFlight>,
    pub(super) occluder: Option<OccluderPass>,
    mlp: Mlp,
    sh: Option<SphericalHarmonics>,
    pub(super) project: Project,
    pub(super) sort: Sort,
    pub(super) raster: Raster,
    pub(super) control: Buffer,
    /// Features, then node displacements, of one avatar after the other; then the occluder's depth
    /// pyramid.
    pub(super) pose: Buffer,
    pub(super) blocks: Blocks,
    settings: SettingsBlock,
    /// What is written to an avatar's block.
    pub(super) frame: Box<FrameBlock>,
    pub(super) model: Model,
    pub(super) avatar_bounds: AvatarBounds,
    pub(super) needs: PartDependencies,
    /// One an avatar.
    pub(super) pose_caches: Vec<PoseCache>,
    pub(super) options: RendererOptions,
    pub(super) state: FrameState,
    /// Keys that the control says the sort takes; None before the first frame.
    key_count: Option<u32>,
    /// A box around all pixels that the last frames drew; None where they are not known.
    damaged: Option<PixelRect>,
    pub(super) next: usize,
    pub(super) report: FrameReport,
    pub(super) gpu: Arc<Gpu>,
}

/// Where an avatar's uniform block is, bytes.
fn block_offset(number: usize) -> u32 {
    (number as u64 * FRAME_STRIDE) as u32
}

impl Renderer {
    /// # Errors
    /// When the options can't be drawn with, or the device's memory does not suffice.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let mut new = Self::empty(gpu, avatar, options)?;
        new.take(avatar)?;
        Ok(new)
    }

    /// Buffers and kernels for an avatar. A browser compiles kernels on other threads: meanwhile
    /// call [`Self::take`], which fills it and makes the occluder. Nothing may be drawn before
    /// that.
    ///
    /// # Errors
    /// When the options can't be drawn with, or the device is out of memory.
    pub fn empty(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let options = accepted(gpu, avatar, options)?;
        let model = Model::empty(gpu, avatar)?;
        let constants = &model.constants;
        let instances = options.instances as u32;
        let words = 4 * u64::from(instances) * u64::from(block::pose_vectors(constants))
            + u64::from(PYRAMID_WORDS);
        let pose = empty(gpu, "pose", 4 * words.next_multiple_of(4), STORAGE)?;
        let control = empty(
            gpu,
            "control",
            size_of::<Control>() as u64,
            STORAGE | wgpu::BufferUsages::INDIRECT,
        )?;
        let blocks = Blocks::new(gpu, options.instances)?;
        let project = Project::new(gpu, &model, &blocks, &pose, &options)?;
        let sort_inputs = SortInputs {
            keys: project.keys(),
            counts: project.counts(),
            control: &control,
            capacity: project.capacity(),
        };
        let sort = Sort::new(gpu, &blocks, sort_inputs, sort::variant(&options))?;
        let inputs = RasterInputs {
            order: sort.order(),
            splats: project.all(),
            keys: project.keys(),
            control: &control,
            capacity: project.capacity(),
        };
        let raster = Raster::new(gpu, &blocks, inputs, &options)?;
        let mlp = Mlp::new(gpu, &model, &blocks, &pose);
        let sh = SphericalHarmonics::new(gpu, avatar, &model, &blocks)?;
        let mut settings = SettingsBlock::default();
        sort.fill(&mut settings);
        Raster::fill(&mut settings, &options, project.capacity());
        let new = Self {
            frames_in_flight: (0..FRAMES_IN_FLIGHT)
                .map(|_| FrameInFlight::new(gpu))
                .collect::<Result<_>>()?,
            occluder: None,
            mlp,
            sh,
            project,
            sort,
            raster,
            control,
            pose,
            blocks,
            settings,
            frame: model.constants.clone(),
            avatar_bounds: AvatarBounds::new(avatar),
            needs: PartDependencies::new(avatar),
            pose_caches: (0..options.instances)
                .map(|_| PoseCache::default())
                .collect(),
            model,
            options,
            state: FrameState::default(),
            key_count: None,
            damaged: None,
            next: 0,
            report: FrameReport::default(),
            gpu: gpu.clone(),
        };
        gpu.check()?;
        Ok(new)
    }

    /// The device that it draws on.
    pub fn gpu(&self) -> &Arc<Gpu> {
        &self.gpu
    }

    /// The avatar's bounds.
    pub fn bounds(&self) -> &AvatarBounds {
        &self.avatar_bounds
    }

    /// Numbers of corners and triangles of the occluder mesh.
    pub fn occluder_size(&self) -> [u64; 2] {
        self.occluder.as_ref().map_or([0; 2], OccluderPass::size)
    }

    /// What it draws with, resolved.
    pub fn options(&self) -> &RendererOptions {
        &self.options
    }

    /// The image, premultiplied.
    pub fn image_view(&self) -> &wgpu::TextureView {
        self.raster.view()
    }

    /// What the last finished frame took and drew: at most two frames old. A frame that needed
    /// nothing is finished at once.
    pub fn report(&self) -> &FrameReport {
        &self.report
    }

    /// Whether the next frame can be submitted without more than two under way. Takes note of
    /// finished ones.
    pub fn ready(&mut self) -> bool {
        if let Some(report) = self.frames_in_flight[self.next].finish() {
            self.report = report;
        }
        !self.frames_in_flight[self.next].is_pending()
    }

    /// Submits a frame of several avatars, at most [`RendererOptions::instances`], sorted together;
    /// says whether anything had to be drawn. Caches and changes go by place in `poses`: keep each
    /// copy of the avatar at its place from frame to frame. Natively it waits when two frames are
    /// still under way; in a browser, call it when [`Self::ready`].
    ///
    /// # Errors
    /// When a pose or the camera holds a number that can't be drawn, there are too many poses, or
    /// the device is lost.
    pub fn draw_scene(&mut self, poses: &[&Posed], camera: &Camera) -> Result<bool> {
        validate::frame(poses, camera, &self.avatar_bounds, &self.options)?;
        self.gpu.check()?;
        #[cfg(not(target_arch = "wasm32"))]
        if let Some(submission) = self.frames_in_flight[self.next].submission() {
            self.gpu.wait(Some(submission), "a frame")?;
        }
        if !self.ready() {
            return Ok(false);
        }
        let plan = self.state.plan(PlanInput {
            poses,
            camera,
            bounds: &self.avatar_bounds,
            dependencies: &self.needs,
            options: &self.options,
            has_occluder: self.occluder.is_some(),
            always_submit: false,
        });
        if !plan.redraw {
            self.report = FrameReport::idle(self.sh.is_some());
            return Ok(false);
        }
        let damage = Damage::new(plan.drawn_rect, self.damaged, self.options.size);
        self.damaged = Some(plan.drawn_rect);
        let equipment = Equipment {
            sh: self.sh.is_some(),
            method: self.options.method.unwrap_or(RasterMethod::Quads),
            skip: self.options.skip,
        };
        let device_state = DeviceState {
            key_count: self.key_count,
        };
        let schedule = Schedule::new(&plan, &equipment, device_state);
        self.write_frame(&plan, camera, &damage);
        self.execute(&schedule, &plan, &damage);
        self.next = (self.next + 1) % FRAMES_IN_FLIGHT;
        Ok(true)
    }

    /// Submits a frame of one avatar; see [`Self::draw_scene`].
    ///
    /// # Errors
    /// When the pose or the camera holds a number that can't be drawn, or the device is lost.
    pub fn draw(&mut self, posed: &Posed, camera: &Camera) -> Result<bool> {
        self.draw_scene(&[posed], camera)
    }

    /// Runs a schedule. WebGPU orders memory by itself, so barriers are passed over; the key count
    /// is written with the uniform blocks.
    fn execute(&mut self, schedule: &Schedule, plan: &FramePlan, damage: &Damage) {
        let Self {
            frames_in_flight,
            mlp,
            sh,
            occluder,
            project,
            sort,
            raster,
            ..
        } = self;
        let blocks: Vec<u32> = plan
            .instances
            .iter()
            .map(|instance| block_offset(instance.index))
            .collect();
        // An empty image has a size too: the first block's.
        let image_block = blocks.first().copied().unwrap_or(0);
        let stages = StageDispatches {
            has_sh: sh.is_some(),
            has_occluder: occluder.is_some() && plan.occluder_view.is_some(),
            sort: sort.dispatches() as u64,
            raster: raster.dispatches(),
        };
        let in_flight = &mut frames_in_flight[self.next];
        let counters = Counters {
            damaged: damage.pixels(),
            ..plan.counters(self.model.constants.gaussians, &stages)
        };
        in_flight.begin(counters, self.options.count);
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor {
                label: Some("frame"),
            });
        let dispatch = |pass: &Pass, compute: &mut wgpu::ComputePass| match *pass {
            Pass::Mlp { instance, parts } => mlp.record(compute, block_offset(instance), parts),
            Pass::Sh {
                instance,
                gaussians,
            } => {
                if let Some(sh) = sh.as_ref() {
                    sh.record(compute, block_offset(instance), gaussians);
                }
            }
            Pass::Project {
                instance,
                gaussians,
                skinning,
            } => project.record(compute, block_offset(instance), gaussians, skinning),
            Pass::Sort => sort.record(compute),
            Pass::Binning => raster.way().record_binning(compute, image_block),
            Pass::RasterTiles => raster.way().record_tiles(compute, image_block, damage),
            // These are no compute passes: they are recorded where they stand in the schedule.
            Pass::SetKeyCount { .. }
            | Pass::ClearCounts
            | Pass::Occluder { .. }
            | Pass::ClearTileLists
            | Pass::RasterQuads { .. }
            | Pass::ReadCounts => {}
        };
        for step in &schedule.steps {
            match step {
                Step::Skip(stage, _) => in_flight.skip(*stage),
                Step::Command(Command::Run(Pass::ClearCounts)) => project.clear(&mut encoder),
                // The API orders memory, and counts are copied where the frame is submitted.
                Step::Command(_) => {}
                Step::Stage(ScheduledStage { stage, commands }) => match commands[..] {
                    [Command::Run(Pass::Occluder { .. })] => {
                        if let Some(occluder) = occluder.as_ref() {
                            occluder.record(in_flight, &mut encoder, &blocks);
                        }
                    }
                    [Command::Run(Pass::RasterQuads { .. })] => {
                        let control = &self.control;
                        raster.record_quads(in_flight, &mut encoder, image_block, control);
                    }
                    _ => {
                        let passes = commands.iter().filter_map(Command::pass);
                        if passes.clone().any(|pass| *pass == Pass::ClearTileLists) {
                            raster.way().clear_tile_lists(&mut encoder);
                        }
                        let writes = in_flight.stage(*stage);
                        let mut compute = in_flight.pass(&mut encoder, *stage, writes);
                        for pass in passes {
                            dispatch(pass, &mut compute);
                        }
                    }
                },
            }
        }
        in_flight.submit(&self.gpu, encoder, &self.control, project);
    }

    /// Fills the uniform blocks of a frame.
    fn write_frame(&mut self, plan: &FramePlan, camera: &Camera, damage: &Damage) {
        let keys = plan.key_count();
        let settings = SettingsBlock {
            key_count: keys,
            first_region: damage.regions()[0],
            ..self.settings
        };
        if self.key_count.is_none() || self.settings != settings {
            self.settings = settings;
            self.gpu
                .queue
                .write_buffer(&self.blocks.settings, 0, bytes_of(&settings));
        }
        if self.key_count != Some(keys) {
            self.key_count = Some(keys);
            let control = Control {
                index_count: 6 * QUADS_PER_INSTANCE,
                key_count: keys,
                ..Control::default()
            };
            self.gpu
                .queue
                .write_buffer(&self.control, 0, bytes_of(&control));
        }
        for instance in plan
            .instances
            .iter()
            .filter(|instance| instance.changes.skinning == Skinning::ComputeAndStore)
        {
            self.pose_caches[instance.index] =
                PoseCache::new(&self.avatar_bounds, instance.posed, camera);
        }
        // A frame without avatars has a size too.
        if plan.instances.is_empty() {
            self.write_block(plan, camera, 0, None);
        }
        for instance in &plan.instances {
            self.write_block(plan, camera, instance.index, Some(instance));
        }
    }

    fn write_block(
        &mut self,
        plan: &FramePlan,
        camera: &Camera,
        number: usize,
        instance: Option<&AvatarInstance>,
    ) {
        let block = &mut *self.frame;
        block::write_shared(block, &self.options, plan, camera);
        if self.occluder.is_none() {
            block.pyramid_start = 0;
        }
        self.project.fill(block);
        block.tile_side = TILING_WEB.tile(camera.size) as f32;
        block.count_tile = SORT_TILE;
        if let Some(instance) = instance {
            block::write_instance(block, &self.options, instance, camera);
            self.project.fill_instance(block, number as u32);
            self.pose_caches[number].write_to(block, camera);
        }
        self.gpu.queue.write_buffer(
            &self.blocks.frames,
            u64::from(block_offset(number)),
            bytes_of(block),
        );
    }

    /// Changes the image's size. On failure the old image stays.
    ///
    /// # Errors
    /// When the device does not draw that size.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        let Self {
            project,
            sort,
            control,
            raster,
            blocks,
            ..
        } = self;
        let inputs = RasterInputs {
            order: sort.order(),
            splats: project.all(),
            keys: project.keys(),
            control,
            capacity: project.capacity(),
        };
        raster.resize(&self.gpu, blocks, inputs, size)?;
        self.options.size = size;
        self.state = FrameState::default();
        self.damaged = None;
        self.gpu.check()
    }
}
