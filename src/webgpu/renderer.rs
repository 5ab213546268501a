//! Draws an avatar, or several copies of it in one scene: poses and a camera go in, an image on the
//! device comes out. [`Schedule::new`] says what a frame runs, `execute.rs` records it.

use super::{
    buffer::{STORAGE, empty},
    device::Gpu,
    error::Result,
    execute::Executor,
    frame_in_flight::{FRAMES_IN_FLIGHT, FrameInFlight},
    kernel::{Blocks, FRAME_STRIDE},
    mlp::Mlp,
    model::Model,
    occluder::OccluderPass,
    options::{accepted, room},
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
        Counters, Damage, FrameReport, RendererOptions, Schedule, Skinning, Skip, Stage,
        block::{self, PoseLayout},
        pose_cache::PoseCache,
        room::Room,
        schedule::{DeviceState, Equipment},
        state::{AvatarInstance, FramePlan, FrameState, Layer, PlanInput, StageDispatches},
        validate,
    },
    layout::{Control, FrameBlock, SORT_TILE, SettingsBlock, TILING_WEB},
    scene::{AvatarBounds, Camera, PartDependencies, PixelRect, Posed},
};
use std::sync::Arc;

/// An avatar on a device, in as many poses as it was made for.
pub struct Renderer {
    pub(super) frames_in_flight: Vec<FrameInFlight>,
    pub(super) occluder: Option<OccluderPass>,
    /// Whether there is an occluder, or the avatar is too thin for one.
    occluder_sought: bool,
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
    room: Room,
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

/// The bounds of an avatar that is drawn with these options.
fn bounds_of(avatar: &Avatar, options: &RendererOptions) -> AvatarBounds {
    let bounds = AvatarBounds::new(avatar);
    bounds.filtered(options.filter).without_levels()
}

/// Where an avatar's uniform block is, bytes.
fn block_offset(number: usize) -> u32 {
    (number as u64 * FRAME_STRIDE) as u32
}

impl Renderer {
    /// # Errors
    /// When the options can't be drawn with, [`Avatar::check`] finds a fault, or the device's
    /// memory does not suffice.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let mut new = Self::empty(gpu, avatar, options)?;
        new.write(avatar)?;
        new.add_occluder(avatar)?;
        Ok(new)
    }

    /// Buffers and kernels for an avatar. A browser compiles kernels on other threads: meanwhile
    /// call [`Self::upload`], which fills them. Nothing may be drawn before that. Without
    /// [`Self::add_occluder`] nothing is hidden.
    ///
    /// # Errors
    /// When the options can't be drawn with, [`Avatar::check`] finds a fault, or the device is out
    /// of memory.
    pub fn empty(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let options = accepted(gpu, avatar, options)?;
        avatar.check()?;
        let model = Model::empty(gpu, avatar)?;
        let constants = &model.constants;
        let avatar_bounds = bounds_of(avatar, &options);
        let room = room(gpu, &options, &avatar_bounds)?;
        let layout = PoseLayout::new(constants, room);
        let pose = empty(gpu, "pose", 16 * u64::from(layout.total()), STORAGE)?;
        let control = empty(
            gpu,
            "control",
            size_of::<Control>() as u64,
            STORAGE | wgpu::BufferUsages::INDIRECT,
        )?;
        let blocks = Blocks::new(gpu, options.instances)?;
        let project = Project::new(gpu, &model, &blocks, &pose, &options, room)?;
        let sort_inputs = SortInputs {
            keys: project.keys(),
            counts: project.counts(),
            control: (&control).into(),
            capacity: project.capacity(),
            counted: true,
        };
        let variant = sort::variant(&options);
        let sort = Sort::new(gpu, blocks.settings(), sort_inputs, variant)?;
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
        raster.fill(&mut settings, &options, project.capacity());
        let new = Self {
            frames_in_flight: (0..FRAMES_IN_FLIGHT)
                .map(|_| FrameInFlight::new(gpu))
                .collect::<Result<_>>()?,
            occluder: None,
            occluder_sought: false,
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
            avatar_bounds,
            room,
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

    /// Fills the buffers that [`Self::empty`] made for this avatar. It may have spherical
    /// harmonics: [`Self::empty`] has uploaded those. False, and nothing has changed, where its
    /// arrays have other lengths.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, the device's memory does not suffice, or it is lost.
    pub fn upload(&mut self, avatar: &Avatar) -> Result<bool> {
        avatar.check()?;
        self.write(avatar)
    }

    /// [`Self::upload`] of an avatar that was checked.
    fn write(&mut self, avatar: &Avatar) -> Result<bool> {
        if !self.model.fill(&self.gpu, avatar) {
            return Ok(false);
        }
        self.gpu.check()?;
        Ok(true)
    }

    /// Makes the occluder of the avatar that was uploaded, which takes about as long as the upload:
    /// a page does so once its first frame is under way. Without effect where there is one, or it
    /// was found that there can be none.
    ///
    /// # Errors
    /// When the device is lost or out of memory.
    pub fn add_occluder(&mut self, avatar: &Avatar) -> Result<()> {
        if self.occluder_sought || !self.options.skip.contains(Skip::HIDDEN) {
            return Ok(());
        }
        self.occluder =
            OccluderPass::new(&self.gpu, avatar, &self.model, &self.blocks, &self.pose)?;
        self.occluder_sought = true;
        self.gpu.check()
    }

    /// Draws this avatar from now on, which has the Gaussians and the nodes of the one before and
    /// may have other correctives of the same number, and other spherical harmonics of the same
    /// degree: kernels and bindings stay, but for that of the harmonics. False, and nothing has
    /// changed, where its arrays have other lengths.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, or the device is lost.
    pub fn replace_avatar(&mut self, avatar: &Avatar) -> Result<bool> {
        let degree = SphericalHarmonics::degree_of(avatar);
        if degree != self.sh.as_ref().map(SphericalHarmonics::degree) || !self.upload(avatar)? {
            return Ok(false);
        }
        if degree.is_some() {
            self.sh = SphericalHarmonics::new(&self.gpu, avatar, &self.model, &self.blocks)?;
            self.gpu.check()?;
        }
        self.frame.clone_from(&self.model.constants);
        self.avatar_bounds = bounds_of(avatar, &self.options);
        self.needs = PartDependencies::new(avatar);
        for cache in &mut self.pose_caches {
            *cache = PoseCache::default();
        }
        self.state = FrameState::default();
        Ok(true)
    }

    /// The device that it draws on.
    pub fn gpu(&self) -> &Arc<Gpu> {
        &self.gpu
    }

    /// The avatar's bounds.
    pub fn bounds(&self) -> &AvatarBounds {
        &self.avatar_bounds
    }

    fn equipment(&self) -> Equipment {
        Equipment {
            sh: self.sh.is_some(),
            occluder: self.occluder.is_some(),
            supersampling: self.options.supersampling.is_on(),
            method: self.raster.method(),
            kernel: self.raster.kernel(),
            skip: self.options.skip,
        }
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
            room: self.room,
            has_occluder: self.occluder.is_some(),
            always_submit: false,
        });
        if !plan.redraw {
            self.report = FrameReport::idle(&self.equipment());
            return Ok(false);
        }
        let damage = Damage::new(plan.drawn_rect, self.damaged, self.options.size);
        self.damaged = Some(plan.drawn_rect);
        let device_state = DeviceState {
            key_count: self.key_count,
        };
        let schedule = Schedule::new(&plan, &self.equipment(), device_state);
        self.write_frame(&schedule, &plan, camera, &damage);
        self.submit(&schedule, &plan, &damage);
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

    /// Records a schedule, and submits it.
    fn submit(&mut self, schedule: &Schedule, plan: &FramePlan, damage: &Damage) {
        let stages = StageDispatches {
            has_sh: self.sh.is_some(),
            occluder: schedule.runs(Stage::Occluder),
            sort: schedule.runs(Stage::Sort) * self.sort.dispatches() as u64,
            // Quads have none without the stages before them.
            raster: schedule.runs(Stage::Binning) * self.raster.dispatches(),
        };
        let counters = Counters {
            damaged: damage.pixels(),
            ..plan.counters(self.model.constants.gaussians, &stages)
        };
        let blocks: Vec<u32> = plan
            .instances()
            .map(|instance| block_offset(instance.index))
            .collect();
        let executor = Executor {
            gpu: &self.gpu,
            mlp: &self.mlp,
            sh: self.sh.as_ref(),
            occluder: self.occluder.as_ref(),
            project: &self.project,
            sort: &self.sort,
            raster: &self.raster,
            control: &self.control,
            block: block_offset,
            blocks: &blocks,
            damage,
        };
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor {
                label: Some("frame"),
            });
        let in_flight = &mut self.frames_in_flight[self.next];
        in_flight.begin(counters, self.options.count);
        executor.execute(in_flight, &mut encoder, schedule);
        in_flight.submit(&self.gpu, encoder, &self.control, &self.project);
        self.key_count = Some(schedule.key_count);
    }

    /// Fills the uniform blocks of a frame.
    fn write_frame(
        &mut self,
        schedule: &Schedule,
        plan: &FramePlan,
        camera: &Camera,
        damage: &Damage,
    ) {
        let settings = SettingsBlock {
            key_count: schedule.key_count,
            first_region: self.raster.first_region(damage),
            ..self.settings
        };
        if self.key_count.is_none() || self.settings != settings {
            self.settings = settings;
            self.gpu
                .queue
                .write_buffer(&self.blocks.settings, 0, bytes_of(&settings));
        }
        for instance in plan
            .instances()
            .filter(|instance| instance.changes.skinning == Skinning::ComputeAndStore)
        {
            self.pose_caches[instance.index] =
                PoseCache::new(&self.avatar_bounds, instance.posed, camera);
        }
        // A frame without avatars has a size too.
        let layer = &plan.image;
        if layer.instances.is_empty() {
            self.write_block(layer, camera, 0, None);
        }
        for instance in &layer.instances {
            self.write_block(layer, camera, instance.index, Some(instance));
        }
    }

    fn write_block(
        &mut self,
        layer: &Layer,
        camera: &Camera,
        number: usize,
        instance: Option<&AvatarInstance>,
    ) {
        let pose = PoseLayout::new(&self.model.constants, self.room);
        let block = &mut *self.frame;
        block::write_shared(block, &self.options, layer, camera, pose);
        self.project.fill(block);
        block.tile_side = TILING_WEB.tile(layer.size) as f32;
        block.count_tile = SORT_TILE;
        if let Some(instance) = instance {
            block::write_instance(block, &self.options, instance, pose);
            self.project.fill_instance(block, instance.cache_start);
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
