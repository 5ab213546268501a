//! Draws an avatar, or several copies of it in one scene: poses and a camera go in, an image on the
//! device comes out. [`FrameSchedule::new`] says what a frame runs, `execute.rs` records it.

use super::{
    buffer::{STORAGE, empty},
    device::Gpu,
    error::Result,
    execute::{Executor, control},
    frame_in_flight::{FRAMES_IN_FLIGHT, FrameInFlight},
    kernel::{Blocks, block_offset},
    mlp::Mlp,
    model::{self, Model},
    options::{accepted, capacity},
    owned::Buffer,
    project::Project,
    raster::{Draw, Raster, RasterInputs},
    sh::SphericalHarmonics,
    sort::{self, Sort, SortInputs},
};
use bytemuck::bytes_of;
use effigy_core::{
    avatar::Avatar,
    frame::{
        Counters, DEPTH_KEYS, Damage, FrameReport, FrameSchedule, RendererOptions, Skinning, Stage,
        block::{self, PoseLayout},
        capacity::Capacity,
        passes::RenderTarget,
        pose_cache::PoseCache,
        schedule::{DeviceState, Equipment},
        state::{AvatarInstance, FramePlan, FrameState, Layer, PlanInput, StageDispatches},
        validate,
    },
    layout::{Control, FrameBlock, SORT_TILE, SettingsBlock},
    scene::{AvatarBounds, Camera, PartDependencies, PixelRect, Posed},
};
use std::sync::Arc;

/// An avatar on a device, in as many poses as it was made for.
pub struct Renderer {
    pub(super) frames_in_flight: Vec<FrameInFlight>,
    mlp: Mlp,
    sh: Option<SphericalHarmonics>,
    pub(super) project: Project,
    pub(super) sort: Sort,
    pub(super) raster: Raster,
    pub(super) control: Buffer,
    /// Features, then node displacements, of one avatar after the other; then a vector of zeros.
    pub(super) pose: Buffer,
    pub(super) blocks: Blocks,
    settings: SettingsBlock,
    /// What is written to an avatar's block.
    frame: Box<FrameBlock>,
    pub(super) model: Model,
    pub(super) avatar_bounds: AvatarBounds,
    capacity: Capacity,
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
    AvatarBounds::new(avatar).filtered(options.filter)
}

fn raster_inputs<'a>(
    project: &'a Project,
    sort: &'a Sort,
    control: &'a wgpu::Buffer,
) -> RasterInputs<'a> {
    RasterInputs {
        order: sort.order(),
        splats: project.all(),
        control,
        capacity: project.capacity(),
    }
}

impl Renderer {
    /// # Errors
    /// When the options can't be drawn with, [`Avatar::check`] finds a fault, or the device's
    /// memory does not suffice.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let mut new = Self::empty(gpu, avatar, options)?;
        new.write(avatar)?;
        Ok(new)
    }

    /// Buffers and kernels for an avatar. A browser compiles kernels on other threads: meanwhile
    /// call [`Self::upload`], which fills them. Nothing may be drawn before that.
    ///
    /// # Errors
    /// When the options can't be drawn with, [`Avatar::check`] finds a fault, or the device is out
    /// of memory.
    pub fn empty(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let options = accepted(gpu, avatar, options)?;
        avatar.check()?;
        let levels = model::levels(avatar);
        let model = Model::empty(gpu, avatar, &levels)?;
        let avatar_bounds = bounds_of(avatar, &options);
        let capacity = capacity(gpu, &options, &avatar_bounds)?;
        let layout = PoseLayout::new(model.constants(0), capacity);
        let pose = empty(gpu, "pose", 16 * u64::from(layout.total()), STORAGE)?;
        let control = empty(
            gpu,
            "control",
            size_of::<Control>() as u64,
            STORAGE | wgpu::BufferUsages::INDIRECT,
        )?;
        let blocks = Blocks::new(gpu, options.instances)?;
        let project = Project::new(gpu, &model, &blocks, &pose, &options, capacity)?;
        let sort_inputs = SortInputs {
            bits: DEPTH_KEYS,
            keys: project.keys(),
            counts: project.counts(),
            control: (&control).into(),
            capacity: project.capacity(),
            counted: true,
        };
        let variant = sort::variant(&options);
        let sort = Sort::new(gpu, blocks.settings(), &sort_inputs, variant)?;
        let inputs = raster_inputs(&project, &sort, &control);
        let raster = Raster::new(gpu, &blocks, inputs, &options)?;
        let mlp = Mlp::new(gpu, &model, &blocks, &pose);
        let sh = SphericalHarmonics::new(gpu, avatar, &levels, &model, &blocks, &pose)?;
        let mut settings = SettingsBlock::default();
        sort.fill(&mut settings);
        raster.fill(&mut settings, &options, project.capacity());
        let new = Self {
            frames_in_flight: (0..FRAMES_IN_FLIGHT)
                .map(|_| FrameInFlight::new(gpu))
                .collect::<Result<_>>()?,
            mlp,
            sh,
            project,
            sort,
            raster,
            control,
            pose,
            blocks,
            settings,
            frame: Box::new(*model.constants(0)),
            avatar_bounds,
            capacity,
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
        let levels = model::levels(avatar);
        if !self.model.fits(avatar) || !self.model.fits_levels(&levels) {
            return Ok(false);
        }
        self.model.fill(&self.gpu, avatar);
        self.model.fill_levels(&self.gpu, avatar, &levels);
        self.gpu.check()?;
        Ok(true)
    }

    /// Draws small images of the avatar from its levels, too, from the next frame on. This is for a
    /// renderer that was made of the avatar without them, so that a page's first frame does not
    /// wait for them. No kernel is compiled unless a level has longer arrays than the avatar.
    /// Returns false and changes nothing if the avatar has no levels or is another one, if the
    /// renderer has levels already, or if the capacity is too small to draw from levels.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, or the device is lost or out of memory.
    pub fn add_levels(&mut self, avatar: &Avatar) -> Result<bool> {
        if avatar.levels.is_empty() || self.model.sets() > 1 || !self.model.fits(avatar) {
            return Ok(false);
        }
        avatar.check()?;
        let bounds = bounds_of(avatar, &self.options);
        if !self.has_capacity(&bounds)? {
            return Ok(false);
        }
        let levels = model::levels(avatar);
        self.make_room(&levels)?;
        self.show_anew(avatar, &levels, bounds)?;
        Ok(true)
    }

    /// Whether the buffers hold all that frames of an avatar with these bounds may draw.
    fn has_capacity(&self, bounds: &AvatarBounds) -> Result<bool> {
        let capacity = Capacity::new(&self.options, bounds)?;
        Ok(capacity.gaussians <= self.capacity.gaussians && capacity.posed <= self.capacity.posed)
    }

    /// Makes buffers for these levels in place of those before. The harmonics must be replaced,
    /// too.
    fn make_room(&mut self, levels: &[Avatar]) -> Result<()> {
        self.model.make_room(&self.gpu, levels)?;
        self.project
            .bind(&self.gpu, &self.model, &self.blocks, &self.pose);
        Ok(())
    }

    /// Writes levels and harmonics, and has the next frame compute and draw all of an avatar.
    fn show_anew(
        &mut self,
        avatar: &Avatar,
        levels: &[Avatar],
        bounds: AvatarBounds,
    ) -> Result<()> {
        self.model.fill_levels(&self.gpu, avatar, levels);
        if let Some(sh) = &mut self.sh {
            sh.replace(
                &self.gpu,
                avatar,
                levels,
                &self.model,
                &self.blocks,
                &self.pose,
            )?;
        }
        self.avatar_bounds = bounds;
        self.needs = PartDependencies::new(avatar);
        for cache in &mut self.pose_caches {
            *cache = PoseCache::default();
        }
        self.state = FrameState::default();
        self.gpu.check()
    }

    /// Draws this avatar from now on, which has the Gaussians and the nodes of the one before and
    /// may have other correctives of the same number, other spherical harmonics of the same degree
    /// and any levels: kernels stay, as with [`Self::add_levels`]. False, and nothing has changed,
    /// where its arrays have other lengths.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, or the device is lost.
    pub fn replace_avatar(&mut self, avatar: &Avatar) -> Result<bool> {
        avatar.check()?;
        let bounds = bounds_of(avatar, &self.options);
        let degree = SphericalHarmonics::degree_of(avatar);
        if degree != self.sh.as_ref().map(SphericalHarmonics::degree)
            || !self.model.fits(avatar)
            || !self.has_capacity(&bounds)?
        {
            return Ok(false);
        }
        let levels = model::levels(avatar);
        if !self.model.fits_levels(&levels) {
            self.make_room(&levels)?;
        }
        self.model.fill(&self.gpu, avatar);
        self.show_anew(avatar, &levels, bounds)?;
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
            supersampling: self.options.supersampling.is_on(),
            method: self.raster.method(),
            skip: self.options.skip,
        }
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
        // Should anything below fail, nothing of this frame counts as drawn.
        let mut state = std::mem::take(&mut self.state);
        let damaged = self.damaged.take();
        let plan = state.plan(PlanInput {
            poses,
            camera,
            bounds: &self.avatar_bounds,
            dependencies: &self.needs,
            options: &self.options,
            capacity: self.capacity,
            always_submit: false,
        });
        if !plan.redraw {
            self.state = state;
            self.damaged = damaged;
            self.report = FrameReport::idle(&self.equipment());
            return Ok(false);
        }
        if let Some(atlas) = &plan.atlas {
            let Self {
                gpu,
                raster,
                blocks,
                project,
                sort,
                control,
                ..
            } = self;
            let inputs = raster_inputs(project, sort, control);
            raster.make_atlas(gpu, blocks, inputs, atlas.layer.size)?;
            raster.write_slots(gpu, &atlas.slots);
        }
        let damage = Damage::new(plan.drawn_rect, damaged, self.options.size);
        let device_state = DeviceState {
            key_count: self.key_count,
            lost_image: None,
        };
        let schedule = FrameSchedule::new(&plan, &self.equipment(), device_state);
        self.write_frame(&schedule, &plan, camera, &damage);
        self.submit(&schedule, &plan, &damage);
        self.state = state;
        self.damaged = Some(plan.drawn_rect);
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
    fn submit(&mut self, schedule: &FrameSchedule, plan: &FramePlan, damage: &Damage) {
        let stages = StageDispatches {
            has_sh: self.sh.is_some(),
            sort: schedule.runs(Stage::Sort) * self.sort.dispatches() as u64,
            // Quads have none without the stages before them.
            raster: schedule.runs(Stage::Binning) * self.raster.dispatches(),
        };
        let counters = Counters {
            damaged: damage.pixels(),
            ..plan.counters(self.model.constants(0).gaussians, &stages)
        };
        // An empty image has a block of its own.
        let own = self.options.instances;
        let draw = |layer: &Layer, target, damage| Draw {
            target,
            size: layer.size,
            block: block_offset(layer.instances.first().map_or(own, |first| first.index)),
            damage,
        };
        let whole_atlas = plan.atlas.as_ref().map(|atlas| atlas.damage());
        let atlas = plan.atlas.as_ref().zip(whole_atlas.as_ref());
        let executor = Executor {
            gpu: &self.gpu,
            mlp: &self.mlp,
            sh: self.sh.as_ref(),
            project: &self.project,
            sort: &self.sort,
            raster: &self.raster,
            control: &self.control,
            blocks: &self.blocks,
            plan,
            image: draw(&plan.image, RenderTarget::Image, damage),
            atlas: atlas.map(|(atlas, damage)| draw(&atlas.layer, RenderTarget::Atlas, damage)),
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
        schedule: &FrameSchedule,
        plan: &FramePlan,
        camera: &Camera,
        damage: &Damage,
    ) {
        let image = SettingsBlock {
            key_count: schedule.key_count,
            first_region: self.raster.first_region(damage),
            ..self.settings
        };
        let first = match &plan.atlas {
            Some(atlas) => SettingsBlock {
                key_count: atlas.layer.key_count(),
                first_region: [0; 2],
                ..self.settings
            },
            None => image,
        };
        if self.key_count.is_none() || self.settings != first {
            self.settings = first;
            self.gpu
                .queue
                .write_buffer(&self.blocks.settings, 0, bytes_of(&first));
        }
        if plan.layers().count() > 1 {
            self.settings = image;
            self.blocks
                .write_second(&self.gpu, &image, &control(image.key_count));
        }
        for instance in plan
            .instances()
            .filter(|instance| instance.changes.skinning == Skinning::ComputeAndStore)
        {
            self.pose_caches[instance.index] =
                PoseCache::new(&self.avatar_bounds, instance.posed, camera);
        }
        for layer in plan.layers() {
            for instance in &layer.instances {
                self.write_block(layer, camera, Some(instance));
            }
        }
        // An image without avatars has a size too.
        if plan.image.instances.is_empty() {
            self.write_block(&plan.image, camera, None);
        }
    }

    fn write_block(&mut self, layer: &Layer, camera: &Camera, instance: Option<&AvatarInstance>) {
        let number = instance.map_or(self.options.instances, |instance| instance.index);
        let set = instance.map_or(0, |instance| instance.model);
        let block = &mut *self.frame;
        block::write_constants(block, self.model.constants(set));
        block::write_shared(block, &self.options, layer, camera);
        self.project.fill(block);
        block.count_tile = SORT_TILE;
        if let Some(instance) = instance {
            let pose = PoseLayout::new(self.model.constants(0), self.capacity);
            block::write_instance(block, &self.options, layer, instance, pose);
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
        let inputs = raster_inputs(project, sort, control);
        raster.resize(&self.gpu, blocks, inputs, size)?;
        self.options.size = size;
        self.state = FrameState::default();
        self.damaged = None;
        self.gpu.check()
    }
}
