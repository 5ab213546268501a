//! Draws an avatar, or several copies of it in one scene: poses and a camera go in, an image on the
//! device comes out. [`FrameSchedule::new`] says what a frame runs, `execute.rs` records it.

mod blocks;
mod execute;
mod prepared;
mod stages;

pub use prepared::PreparedAvatar;
pub use stages::Stages;

use super::{
    commands::{
        FRAMES_IN_FLIGHT, FrameReport, Semaphores,
        control::control,
        frame_in_flight::{CountSources, FrameInFlight, HostMarks},
    },
    device::{
        error::{Error, Result},
        gpu::Gpu,
        recording::Recording,
    },
    memory::Buffer,
    passes::{mlp::Mlp, model::Model, project::Project, sh::SphericalHarmonics},
    pipeline::FrameMemory,
    raster::{
        Raster,
        choice::{MethodChoice, strike_off},
        download::{self, Copied},
        draw::{Draw, RasterInputs},
        drawn_by,
        quad_pass::OnePassTarget,
        resolved,
    },
    sort::{self, Sort, SortOptions},
};
use crate::ndk::section;
use ash::vk;
use blocks::BlockRing;
use bytemuck::bytes_of;
use effigy_core::{
    avatar::Avatar,
    frame::{
        Counters, DEPTH_KEYS, Damage, FramePlan, FrameSchedule, Layer, RendererOptions, Skip,
        Stage, StageDispatches, Unusable,
        block::PoseLayout,
        capacity::Capacity,
        passes::{Pass, RenderTarget},
        resource::Resource,
        schedule::{DeviceState, Equipment},
        state::{FrameState, PlanInput},
        validate,
    },
    scene::{AvatarBounds, Camera, Detail, FrameImage, PartDependencies, PixelRect, Posed},
};
use execute::Executor;
use prepared::ms_since;
use std::{sync::Arc, time::Instant};

/// How a frame reaches a screen: what to wait for and signal, and the commands that follow the
/// image.
pub struct Presentation<'a> {
    semaphores: Option<Semaphores>,
    record: &'a mut dyn FnMut(Recording, bool),
    screen: Option<OnePassTarget<'a>>,
}

impl<'a> Presentation<'a> {
    /// `semaphores`: None if nothing else waits for the frame. `record` also gets whether the frame
    /// went to [`Self::in_one_pass`].
    ///
    /// # Safety
    /// Everything that `record` uses must stay alive until the frame is done
    /// ([`Renderer::finish`]), and so must the semaphores. The semaphore that is waited for must be
    /// signalled, and the other one must not be used elsewhere.
    pub unsafe fn new(
        semaphores: Option<Semaphores>,
        record: &'a mut dyn FnMut(Recording, bool),
    ) -> Self {
        Self {
            semaphores,
            record,
            screen: None,
        }
    }

    /// Lets the frame go to `screen` in the render pass that draws it, if it can: with quads, while
    /// the image changes from frame to frame, has the screen's size, and holds no avatar that was
    /// averaged. [`Renderer::copy`] then has nothing to copy.
    pub fn in_one_pass(self, screen: Option<OnePassTarget<'a>>) -> Self {
        Self { screen, ..self }
    }
}

/// An avatar on a device, in as many poses as it was made for.
pub struct Renderer {
    // The first field: dropping it waits for the frames that use all others.
    frames_in_flight: Vec<FrameInFlight>,
    mlp: Mlp,
    /// Of the avatar, then of its levels; empty if colours don't depend on the view.
    sh: Vec<SphericalHarmonics>,
    project: Project,
    sort: Sort,
    raster: Raster,
    control: Buffer,
    /// Features, then node displacements, of one avatar after the other; then a vector of zeros.
    pose: Buffer,
    /// A block for each avatar of each frame under way.
    blocks: BlockRing,
    /// Why it draws by its method. None if the options named the method.
    choice: Option<MethodChoice>,
    model: Model,
    extent: AvatarBounds,
    capacity: Capacity,
    needs: PartDependencies,
    options: RendererOptions,
    state: FrameState,
    /// The key count that the control holds; None before the first frame.
    key_count: Option<u32>,
    /// A box around all pixels that the last frames drew; None if they are not known.
    damaged: Option<PixelRect>,
    /// Whether a frame was drawn into the image.
    has_image: bool,
    /// The pass that drew the last image, if it went to the screen alone.
    lost_image: Option<Pass>,
    /// Whether the last frame changed the image.
    moves: bool,
    next: usize,
    report: FrameReport,
    gpu: Arc<Gpu>,
}

/// The state that the frame before left.
#[derive(Clone, Copy)]
struct FrameBefore {
    /// The key count that the control holds; None before the first frame.
    key_count: Option<u32>,
    /// A box around all pixels that may be drawn; None if they are not known.
    damaged: Option<PixelRect>,
    /// The pass that drew the image, if that went to the screen alone.
    lost_image: Option<Pass>,
}

impl Renderer {
    /// Uploads an avatar, and compiles the kernels. Options that are None are chosen as suits the
    /// device's class, or as was measured on it ([`question`](crate::vulkan::question)).
    ///
    /// # Errors
    /// When the options can't be drawn with, [`Avatar::check`] finds a fault, the device's memory
    /// does not suffice, or it fails.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        Self::from_prepared(gpu, &PreparedAvatar::new(avatar)?, options)
    }

    /// [`Self::new`] for an avatar that was prepared before there was a device.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn from_prepared(
        gpu: &Arc<Gpu>,
        prepared: &PreparedAvatar,
        options: RendererOptions,
    ) -> Result<Self> {
        if options.method.is_some() {
            return Self::with(gpu, prepared, options);
        }
        let choice = MethodChoice::of(gpu);
        let with = |method| Self::with(gpu, prepared, drawn_by(gpu, options, method));
        let (choice, made) = match with(choice.method) {
            Err(error) if choice.is_rival() => {
                if !error.may_pass(gpu.probe.is_cpu()) {
                    strike_off(gpu, choice.method, &error.to_string());
                }
                if !error.leaves_the_device() {
                    return Err(error);
                }
                // It may also need less memory.
                let made = with(choice.class);
                let method = choice.class;
                (MethodChoice { method, ..choice }, made)
            }
            made => (choice, made),
        };
        Ok(Self {
            choice: Some(choice),
            ..made?
        })
    }

    /// Without measurements.
    fn with(gpu: &Arc<Gpu>, prepared: &PreparedAvatar, options: RendererOptions) -> Result<Self> {
        options.check()?;
        let avatar = prepared.avatar;
        let mut options = resolved(gpu, options);
        // Colours that change with the view can't come from a pose cache.
        if avatar.sh.is_some() {
            options.skip -= Skip::SKINNING;
        }
        let model = upload(gpu, prepared)?;
        let began = Instant::now();
        let constants = &model.own().constants;
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC;
        let extent = prepared.bounds.clone().filtered(options.filter);
        let capacity = Capacity::new(&options, &extent)?;
        // The last vector stays zero.
        let zeros = vec![0; 16 * PoseLayout::new(constants, capacity).total() as usize];
        let pose = Buffer::with_data(gpu, "pose", &zeros, storage)?;
        let blocks = BlockRing::new(gpu, options.instances, constants)?;
        let control = Buffer::with_data(
            gpu,
            "control",
            bytes_of(&control(0)),
            storage | vk::BufferUsageFlags::INDIRECT_BUFFER,
        )?;
        let memory = FrameMemory::new(blocks.slice()).with(Resource::Pose, &pose);
        let variant = sort::choice::allowed(gpu, options.sort)?;
        let project = Project::new(gpu, &model, &memory, variant, &options, capacity)?;
        let sort_options = SortOptions {
            counts: Some(project.counts()),
            ..SortOptions::new(DEPTH_KEYS, variant)
        };
        let max_keys = project.capacity();
        // SAFETY: the renderer owns these buffers, and drops them after its frames.
        let sort = unsafe { Sort::new(gpu, project.keys(), &control, max_keys, sort_options) }?;
        let inputs = RasterInputs {
            memory: memory
                .with(Resource::Order, sort.order())
                .with(Resource::Splats, project.whole_buffer())
                .with(Resource::Control, &control),
            capacity: max_keys,
            sort: variant,
        };
        let raster = Raster::new(gpu, &inputs, &options)?;
        let sh = SphericalHarmonics::of_model(gpu, avatar, &model, &memory)?;
        let renderer = Self {
            frames_in_flight: (0..FRAMES_IN_FLIGHT)
                .map(|_| FrameInFlight::new(gpu))
                .collect::<Result<_>>()?,
            mlp: Mlp::new(gpu, &model, &memory)?,
            sh,
            project,
            sort,
            raster,
            control,
            pose,
            blocks,
            extent,
            capacity,
            needs: PartDependencies::new(avatar),
            model,
            options,
            choice: None,
            state: FrameState::default(),
            key_count: None,
            damaged: None,
            has_image: false,
            lost_image: None,
            moves: false,
            next: 0,
            report: FrameReport::default(),
            gpu: gpu.clone(),
        };
        tracing::info!("made the kernels in {:.1} ms", ms_since(began));
        Ok(renderer)
    }

    /// Draws this avatar from now on, which has the lengths of the one before in every array, the
    /// same capacity, and no spherical harmonics: kernels, bindings and image stay. Waits for
    /// submitted frames. Returns false and changes nothing if the avatar needs a renderer of its
    /// own.
    ///
    /// # Errors
    /// When the device fails, or its memory does not suffice. Then nothing has changed.
    pub fn replace_avatar(&mut self, prepared: &PreparedAvatar) -> Result<bool> {
        let avatar = prepared.avatar;
        let extent = prepared.bounds.clone().filtered(self.options.filter);
        let has_sh = !self.sh.is_empty() || avatar.sh.is_some();
        let packed = &prepared.packed;
        let poses = [
            self.model.own().constants.as_ref(),
            &packed.sets[0].constants,
        ]
        .map(|constants| PoseLayout::new(constants, self.capacity).total());
        if has_sh || poses[0] != poses[1] || Capacity::new(&self.options, &extent)? != self.capacity
        {
            return Ok(false);
        }
        self.finish()?;
        if !self.model.replace(&self.gpu, avatar, packed)? {
            return Ok(false);
        }
        self.extent = extent;
        self.needs = PartDependencies::new(avatar);
        self.blocks.forget_poses();
        self.has_image = false;
        self.forget();
        Ok(true)
    }

    /// The device that it draws on.
    pub fn gpu(&self) -> &Arc<Gpu> {
        &self.gpu
    }

    /// The avatar's bounds.
    pub fn bounds(&self) -> &AvatarBounds {
        &self.extent
    }

    fn equipment(&self) -> Equipment {
        Equipment {
            sh: !self.sh.is_empty(),
            supersampling: self.options.supersampling.is_on(),
            method: self.raster.method(),
            skip: self.options.skip,
        }
    }

    /// The `raster` stage, which holds the image.
    pub fn raster(&self) -> &Raster {
        &self.raster
    }

    /// What the last finished frame took and drew: at most two frames old. A frame that needed
    /// nothing is finished at once.
    pub fn report(&self) -> &FrameReport {
        &self.report
    }

    /// The options that it draws with now, resolved.
    pub fn options(&self) -> &RendererOptions {
        &self.options
    }

    /// Why it draws by its method. None if the options named the method.
    pub fn choice(&self) -> Option<&MethodChoice> {
        self.choice.as_ref()
    }

    /// Strikes off this renderer's method for all made from now on, unless it is that of the
    /// device's class. Call it when the device is lost or hangs. Returns whether the next renderer
    /// draws by another method.
    pub fn strike_off(&self, why: &str) -> bool {
        let Some(choice) = self.choice.as_ref().filter(|choice| choice.is_rival()) else {
            return false;
        };
        strike_off(&self.gpu, choice.method, why);
        true
    }

    /// Submits a frame of one avatar. Waits only when two frames are still under way. `camera` must
    /// have the image's size.
    ///
    /// # Errors
    /// When the pose or the camera holds a number that can't be drawn, or the device fails.
    pub fn draw(
        &mut self,
        posed: &Posed,
        camera: &Camera,
        presentation: Option<Presentation>,
    ) -> Result<()> {
        self.draw_scene(&[posed], camera, presentation)
    }

    /// Submits a frame of several avatars, at most [`RendererOptions::instances`], sorted together.
    /// Caches and changes go by place in `poses`: keep each copy of the avatar at its place from
    /// frame to frame. See [`Self::draw`].
    ///
    /// # Errors
    /// When a pose or the camera holds a number that can't be drawn, there are more poses than the
    /// renderer was made for, or the device fails.
    pub fn draw_scene(
        &mut self,
        poses: &[&Posed],
        camera: &Camera,
        mut presentation: Option<Presentation>,
    ) -> Result<()> {
        validate::frame(poses, camera, &self.extent, &self.options)?;
        let frame = self.next;
        let began = Instant::now();
        self.finish_frame(frame)?;
        let waited = Instant::now();
        self.resize_lists(frame)?;
        // Should anything below fail, nothing of this frame counts as drawn.
        let mut state = std::mem::take(&mut self.state);
        let before = FrameBefore {
            key_count: self.key_count.take(),
            damaged: self.damaged.take(),
            lost_image: self.lost_image.take(),
        };
        let plan = state.plan(PlanInput {
            poses,
            camera,
            bounds: &self.extent,
            dependencies: &self.needs,
            options: &self.options,
            capacity: self.capacity,
            always_submit: presentation.is_some(),
        });
        if !plan.redraw && presentation.is_none() && before.lost_image.is_none() {
            self.state = state;
            self.key_count = before.key_count;
            self.damaged = before.damaged;
            self.moves = false;
            self.report = FrameReport::idle(&self.equipment());
            return Ok(());
        }
        self.make_atlas(&plan)?;
        if plan.stores_poses() && !self.project.has_cache() && !self.make_pose_cache()? {
            // Planned anew, and nothing is stored.
            return self.draw_scene(poses, camera, presentation);
        }
        let recording = section(c"record");
        let screen = presentation.as_mut().and_then(|own| own.screen.take());
        let screen = screen.filter(|screen| self.shows_at_once(&plan, screen));
        let schedule = self.record(frame, &plan, camera, before, screen.as_ref())?;
        let mut semaphores = None;
        if let Some(presentation) = presentation {
            let record = |commands: Recording| (presentation.record)(commands, screen.is_some());
            self.frames_in_flight[frame].stage("present", record);
            semaphores = presentation.semaphores;
        }
        drop(recording);
        let recorded = Instant::now();
        let _submitting = section(c"submit");
        let counts = self.count_sources();
        // SAFETY: the frame is recording. What the stages use is dropped or changed only after
        // waiting for the frames in flight; the maker of the presentation promised it for the
        // presentation's objects and semaphores.
        unsafe { self.frames_in_flight[frame].submit(counts, semaphores) }?;
        self.frames_in_flight[frame].timed(HostMarks {
            began,
            waited,
            recorded,
        });
        self.state = state;
        self.key_count = Some(schedule.key_count);
        self.moves = plan.redraw;
        self.has_image = screen.is_none();
        self.lost_image = schedule.quads().filter(|_| screen.is_some());
        let drawn = plan.redraw || before.lost_image.is_some();
        self.damaged = match (screen, drawn) {
            (Some(_), _) => None,
            (None, true) => Some(plan.drawn_rect),
            (None, false) => before.damaged,
        };
        self.next = (frame + 1) % FRAMES_IN_FLIGHT;
        Ok(())
    }

    /// Whether a frame is shown in the render pass that draws it. One that stands still may be shown
    /// again, so it is stored.
    fn shows_at_once(&self, plan: &FramePlan, screen: &OnePassTarget) -> bool {
        self.options.shows_at_once()
            && self.moves
            && plan.redraw
            && plan.atlas.is_none()
            && screen.size == self.raster.drawn()
    }

    /// Waits for the frame before the last, and takes its report. `frame`: its index.
    fn finish_frame(&mut self, frame: usize) -> Result<()> {
        let _waiting = section(c"wait");
        if let Some(report) = self.frames_in_flight[frame].finish()? {
            self.report = report;
        }
        Ok(())
    }

    /// Gives the tile lists the length that a finished frame asked for, if it is another one, after
    /// waiting for submitted frames.
    fn resize_lists(&mut self, frame: usize) -> Result<()> {
        if let Some(asked) = self.frames_in_flight[frame].take_list_blocks()
            && let Some(blocks) = self.raster.other_blocks(asked)
        {
            self.finish()?;
            // SAFETY: every frame is done.
            unsafe { self.raster.resize_lists(blocks) };
        }
        Ok(())
    }

    /// Makes the atlas that a frame draws into, if there is none as large, after waiting for
    /// submitted frames.
    fn make_atlas(&mut self, plan: &FramePlan) -> Result<()> {
        if let Some(atlas) = &plan.atlas
            && plan.redraw
            && !self.raster.has_atlas(atlas.layer.size)
        {
            self.finish()?;
            // SAFETY: every frame is done.
            unsafe { self.raster.make_atlas(atlas.layer.size) }?;
        }
        Ok(())
    }

    /// Begins a frame in flight, and records a plan. `frame`: its index.
    fn record(
        &mut self,
        frame: usize,
        plan: &FramePlan,
        camera: &Camera,
        before: FrameBefore,
        screen: Option<&OnePassTarget>,
    ) -> Result<FrameSchedule> {
        let sources = blocks::BlockSources {
            extent: &self.extent,
            options: &self.options,
            capacity: self.capacity,
            splats: &self.project,
            sort: &self.sort,
            model: &self.model,
        };
        self.blocks.write(frame, plan, camera, &sources);
        self.frames_in_flight[frame].begin()?;
        let device_state = DeviceState {
            key_count: before.key_count,
            lost_image: before.lost_image,
        };
        let schedule = FrameSchedule::new(plan, &self.equipment(), device_state);
        // A screen holds nothing of the frame before.
        let damaged = before.damaged.filter(|_| screen.is_none());
        let damage = Damage::new(plan.drawn_rect, damaged, self.raster.drawn());
        self.execute(frame, &schedule, plan, &damage, screen);
        Ok(schedule)
    }

    /// Records a schedule. The frame in flight must be recording. `frame`: its index.
    fn execute(
        &mut self,
        frame: usize,
        schedule: &FrameSchedule,
        plan: &FramePlan,
        damage: &Damage,
        screen: Option<&OnePassTarget>,
    ) {
        let stages = StageDispatches {
            has_sh: !self.sh.is_empty(),
            sort: schedule.runs(Stage::Sort) * self.sort.dispatches(true) as u64,
            // Quads have no dispatches without the stages before them.
            raster: schedule.runs(Stage::Binning) * self.raster.dispatches(),
        };
        let counters = Counters {
            damaged: if plan.redraw { damage.pixels() } else { 0 },
            ..plan.counters(self.model.own().constants.gaussians, &stages)
        };
        let draw = |layer: &Layer, target, damage| Draw {
            target,
            size: layer.size,
            frame: self.blocks.of_layer(frame, layer),
            control: self.control.raw(),
            damage,
            count: self.options.count,
        };
        let whole_atlas = plan.atlas.as_ref().map(|atlas| atlas.damage());
        let atlas = plan.atlas.as_ref().zip(whole_atlas.as_ref());
        let executor = Executor {
            mlp: &self.mlp,
            sh: &self.sh,
            project: &self.project,
            sort: &self.sort,
            raster: &self.raster,
            control: &self.control,
            counts: self.count_sources(),
            blocks: &self.blocks,
            plan,
            frame,
            screen,
            image: draw(&plan.image, RenderTarget::Image, damage),
            atlas: atlas.map(|(atlas, damage)| draw(&atlas.layer, RenderTarget::Atlas, damage)),
        };
        let in_flight = &mut self.frames_in_flight[frame];
        in_flight.note(counters);
        executor.execute(in_flight, schedule);
    }

    /// Where frames leave their counts.
    fn count_sources(&self) -> CountSources {
        CountSources {
            control: (&self.control).into(),
            reasons: self.project.reasons(),
            list_blocks: self.raster.list_blocks(),
        }
    }

    /// Makes the memory of the pose cache, after waiting for submitted frames. Returns false if the
    /// device has no memory left: no pose is cached from now on.
    fn make_pose_cache(&mut self) -> Result<bool> {
        self.finish()?;
        // SAFETY: every frame is done, and all that binds the buffer gets the new one below.
        let replacement = match unsafe { self.project.make_cache(&self.gpu) } {
            Ok(replacement) => replacement,
            Err(error) if error.leaves_the_device() => {
                tracing::warn!("poses are not cached: {error}");
                self.options.skip -= Skip::SKINNING;
                return Ok(false);
            }
            Err(error) => return Err(error),
        };
        // SAFETY: every frame is done; the stage before keeps the new buffer, which is laid out as
        // the old one was.
        unsafe {
            self.sort.replace(replacement);
            self.raster.replace(replacement);
        }
        Ok(true)
    }

    /// Waits for every submitted frame.
    pub fn finish(&mut self) -> Result<()> {
        for offset in 0..FRAMES_IN_FLIGHT {
            if let Some(report) =
                self.frames_in_flight[(self.next + offset) % FRAMES_IN_FLIGHT].finish()?
            {
                self.report = report;
            }
        }
        Ok(())
    }

    /// Changes the image's size. On failure the old image stays.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.finish()?;
        // SAFETY: every frame is done.
        unsafe { self.raster.resize(size) }?;
        self.options.size = size;
        self.has_image = false;
        self.forget();
        Ok(())
    }

    /// Draws images of `size` px from now on, in the upper left corner of what it was made or
    /// resized for, at this level of detail. Waits for submitted frames where that changes anything.
    /// Nothing is allocated.
    ///
    /// # Errors
    /// When the size does not fit, or the device fails. Then the next frame is drawn as before.
    pub fn adjust(&mut self, size: [u32; 2], detail: Detail) -> Result<()> {
        if size == self.options.size && detail == self.options.detail {
            return Ok(());
        }
        let capacity = self.raster.image().size;
        if !(0..2).all(|axis| (1..=capacity[axis]).contains(&size[axis])) {
            let [found, capacity] =
                [size, capacity].map(|[width, height]| format!("{width} × {height} px"));
            return Err(Error::Unusable(Unusable {
                what: "the drawn part of the image".into(),
                found,
                expected: format!("1 px to {capacity}"),
            }));
        }
        self.finish()?;
        self.has_image &= self.raster.drawn() == size;
        self.raster.draw_within(size);
        self.options.size = size;
        self.options.detail = detail;
        self.forget();
        Ok(())
    }

    /// Has the next frame draw all, whatever the last one showed.
    fn forget(&mut self) {
        self.state = FrameState::default();
        self.damaged = None;
        self.lost_image = None;
    }

    /// Waits, and copies the image of the last frame to the host.
    ///
    /// # Errors
    /// When no frame was drawn at this size, or the last one went to its screen alone, the device
    /// fails, or it has too little memory.
    pub fn read_image(&mut self) -> Result<FrameImage> {
        Ok(self.copy()?.decode())
    }

    /// Waits, and copies the image of the last frame to the host, without the work of decoding it.
    ///
    /// # Errors
    /// Those of [`Renderer::read_image`].
    pub fn copy(&mut self) -> Result<Copied> {
        if !self.has_image {
            return Err(Error::NothingDrawn);
        }
        self.finish()?;
        download::read_image(&self.gpu, &self.raster)
    }

    /// Waits, and copies every stage's output of the last frame to the host.
    pub fn stages(&mut self) -> Result<Stages> {
        self.finish()?;
        let sources = stages::StageSources {
            model: &self.model,
            pose: &self.pose,
            control: &self.control,
            splats: &self.project,
            sort: &self.sort,
        };
        sources.download()
    }
}

fn upload(gpu: &Arc<Gpu>, prepared: &PreparedAvatar) -> Result<Model> {
    let began = Instant::now();
    let model = Model::new(gpu, prepared.avatar, &prepared.packed)?;
    tracing::info!("uploaded the avatar in {:.1} ms", ms_since(began));
    Ok(model)
}
