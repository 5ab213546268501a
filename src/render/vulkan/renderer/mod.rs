//! Draws people: avatars, who of them stands where, and a camera go in, an image on the device comes
//! out. [`FrameSchedule::new`] says what a frame runs, `execute.rs` records it.

mod blocks;
mod execute;
mod held;
mod prepared;
mod shared;
mod stages;

pub use prepared::PreparedAvatar;
pub use stages::Stages;

use super::{
    commands::{
        FRAMES_IN_FLIGHT, FrameReport, Semaphores,
        frame_in_flight::{FrameInFlight, HostMarks},
    },
    device::{
        error::{Error, Result},
        gpu::Gpu,
        recording::Recording,
    },
    passes::model::Model,
    raster::{
        Raster,
        choice::{MethodChoice, strike_off},
        download::{self, Copied},
        draw::Draw,
        drawn_by,
        quad_pass::OnePassTarget,
        resolved,
    },
};
use crate::ndk::section;
use effigy_core::{
    avatar::Avatar,
    frame::{
        AvatarId, AvatarTraits, ByAvatar, Counters, Damage, FramePlan, FrameSchedule, Layer,
        Person, RendererOptions, Skip, Stage, StageDispatches, Unusable,
        block::SharedSizes,
        capacity::Capacity,
        passes::{Pass, RenderTarget},
        people::{PlannedPerson, planned},
        schedule::{DeviceState, Equipment},
        state::{FrameState, PlanInput},
        validate,
    },
    scene::{AvatarBounds, Camera, Detail, FrameImage, PixelRect, Posed},
};
use execute::Executor;
use held::{AvatarKernels, HeldAvatar, traits_of};
use prepared::ms_since;
use shared::SharedStages;
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

/// Avatars on a device, and the stages that draw people of them.
pub struct Renderer {
    // The first field: dropping it waits for the frames that use all others.
    frames_in_flight: Vec<FrameInFlight>,
    avatars: ByAvatar<HeldAvatar>,
    shared: SharedStages,
    /// Of the avatar that it was made with.
    bounds: AvatarBounds,
    /// Why it draws by its method. None if the options named the method.
    choice: Option<MethodChoice>,
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
        let options = resolved(gpu, options);
        let traits = traits_of(prepared, &options);
        let model = upload(gpu, prepared)?;
        let began = Instant::now();
        let capacity = Capacity::new(&options, &traits.bounds)?;
        let sizes = SharedSizes::new(std::iter::once(&*model.own().constants), capacity);
        let shared = SharedStages::new(gpu, &options, sizes, None)?;
        let kernels = kernels(gpu, &traits, &model, &options, &shared)?;
        let renderer = Self {
            frames_in_flight: (0..FRAMES_IN_FLIGHT)
                .map(|_| FrameInFlight::new(gpu))
                .collect::<Result<_>>()?,
            bounds: traits.bounds.clone(),
            avatars: ByAvatar::new(HeldAvatar {
                traits,
                model,
                kernels,
            }),
            shared,
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

    /// Holds another avatar from now on, of which people can be drawn. Waits for submitted frames.
    /// Adding one twice takes its memory twice: people of one avatar share it.
    ///
    /// # Errors
    /// When the device fails, or its memory does not suffice. Then it is not held.
    pub fn add_avatar(&mut self, prepared: &PreparedAvatar) -> Result<AvatarId> {
        self.finish()?;
        let traits = traits_of(prepared, &self.options);
        let model = upload(&self.gpu, prepared)?;
        let models = self.avatars.values().map(|held| &held.model);
        let constants = models.chain([&model]).map(|model| &*model.own().constants);
        let sizes = SharedSizes::new(constants, self.shared.sizes.capacity);
        self.make_room(sizes)?;
        let kernels = kernels(&self.gpu, &traits, &model, &self.options, &self.shared)?;
        Ok(self.avatars.insert(HeldAvatar {
            traits,
            model,
            kernels,
        }))
    }

    /// Gives an avatar's memory back, after waiting for submitted frames: no person of it can be
    /// drawn any more. False if it is not held.
    ///
    /// # Errors
    /// When the device fails.
    pub fn remove_avatar(&mut self, avatar: AvatarId) -> Result<bool> {
        self.finish()?;
        Ok(self.avatars.remove(avatar).is_some())
    }

    /// Makes the shared stages anew if these sizes are more than they have. Every frame must be
    /// done. On failure all stays as it is.
    fn make_room(&mut self, sizes: SharedSizes) -> Result<()> {
        if self.shared.sizes.hold(&sizes) {
            return Ok(());
        }
        let began = Instant::now();
        let sizes = sizes.union(self.shared.sizes);
        let shared = SharedStages::new(&self.gpu, &self.options, sizes, Some(&self.shared))?;
        let bind = |held: &HeldAvatar| {
            kernels(&self.gpu, &held.traits, &held.model, &self.options, &shared)
        };
        let bound: Vec<_> = self.avatars.values().map(bind).collect::<Result<_>>()?;
        for (held, kernels) in self.avatars.values_mut().zip(bound) {
            held.kernels = kernels;
        }
        self.shared = shared;
        self.has_image = false;
        self.key_count = None;
        self.forget();
        tracing::info!("made room for more in {:.1} ms", ms_since(began));
        Ok(())
    }

    /// Draws this avatar in place of one that is held from now on, whose arrays have the same
    /// lengths, and no spherical harmonics: kernels, bindings and image stay. Waits for submitted
    /// frames. Returns false and changes nothing if it has to be added instead.
    ///
    /// # Errors
    /// When the device fails, or its memory does not suffice. Then nothing has changed.
    pub fn replace_avatar(&mut self, id: AvatarId, prepared: &PreparedAvatar) -> Result<bool> {
        self.finish()?;
        let avatar = prepared.avatar;
        let traits = traits_of(prepared, &self.options);
        let Some(held) = self.avatars.get_mut(id) else {
            return Ok(false);
        };
        let has_sh = held.traits.has_sh || traits.has_sh;
        let capacity = Capacity::new(&self.options, &traits.bounds)?;
        let constants = std::iter::once(&*prepared.packed.sets[0].constants);
        if has_sh
            || !self
                .shared
                .sizes
                .hold(&SharedSizes::new(constants, capacity))
        {
            return Ok(false);
        }
        if !held.model.replace(&self.gpu, avatar, &prepared.packed)? {
            return Ok(false);
        }
        if id == AvatarId::FIRST {
            self.bounds = traits.bounds.clone();
        }
        held.traits = traits;
        self.shared.blocks.forget_poses();
        self.has_image = false;
        self.forget();
        Ok(true)
    }

    /// The device that it draws on.
    pub fn gpu(&self) -> &Arc<Gpu> {
        &self.gpu
    }

    /// The bounds of the avatar that it was made with.
    pub fn bounds(&self) -> &AvatarBounds {
        &self.bounds
    }

    fn equipment(&self) -> Equipment {
        Equipment {
            sh: self.avatars.values().any(|held| held.traits.has_sh),
            supersampling: self.options.supersampling.is_on(),
            method: self.shared.raster.method(),
            skip: self.options.skip,
        }
    }

    /// The `raster` stage, which holds the image.
    pub fn raster(&self) -> &Raster {
        &self.shared.raster
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
        self.draw_scene(&[posed.into()], camera, presentation)
    }

    /// Submits a frame of people, at most [`RendererOptions::instances`], sorted together. Caches and
    /// changes go by place in `people`: keep everybody's from frame to frame. Where buffers are too
    /// small it waits for submitted frames and makes larger ones. See [`Self::draw`].
    ///
    /// # Errors
    /// When a pose or the camera holds a number that can't be drawn, a pose is another avatar's or
    /// its avatar is not held, there are more people than the renderer was made for, or the device
    /// fails or its memory does not suffice.
    pub fn draw_scene(
        &mut self,
        people: &[Person],
        camera: &Camera,
        mut presentation: Option<Presentation>,
    ) -> Result<()> {
        self.make_room_for(people, camera)?;
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
            people: &self.planned(people)?,
            camera,
            options: &self.options,
            capacity: self.shared.sizes.capacity,
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
        if plan.stores_poses() && !self.shared.splats.has_cache() && !self.make_pose_cache()? {
            // Planned anew, and nothing is stored.
            return self.draw_scene(people, camera, presentation);
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
        let counts = self.shared.count_sources();
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
            && screen.size == self.shared.raster.drawn()
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
            && let Some(blocks) = self.shared.raster.other_blocks(asked)
        {
            self.finish()?;
            // SAFETY: every frame is done.
            unsafe { self.shared.raster.resize_lists(blocks) };
        }
        Ok(())
    }

    /// Makes the atlas that a frame draws into, if there is none as large, after waiting for
    /// submitted frames.
    fn make_atlas(&mut self, plan: &FramePlan) -> Result<()> {
        if let Some(atlas) = &plan.atlas
            && plan.redraw
            && !self.shared.raster.has_atlas(atlas.layer.size)
        {
            self.finish()?;
            // SAFETY: every frame is done.
            unsafe { self.shared.raster.make_atlas(atlas.layer.size) }?;
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
        let SharedStages {
            splats,
            sort,
            blocks,
            sizes,
            ..
        } = &mut self.shared;
        let sources = blocks::BlockSources {
            avatars: &self.avatars,
            options: &self.options,
            pose: sizes.pose_layout(),
            splats,
            sort,
        };
        blocks.write(frame, plan, camera, &sources);
        self.frames_in_flight[frame].begin()?;
        let device_state = DeviceState {
            key_count: before.key_count,
            lost_image: before.lost_image,
        };
        let schedule = FrameSchedule::new(plan, &self.equipment(), device_state);
        // A screen holds nothing of the frame before.
        let damaged = before.damaged.filter(|_| screen.is_none());
        let damage = Damage::new(plan.drawn_rect, damaged, self.shared.raster.drawn());
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
            sort: schedule.runs(Stage::Sort) * self.shared.sort.dispatches(true) as u64,
            // Quads have no dispatches without the stages before them.
            raster: schedule.runs(Stage::Binning) * self.shared.raster.dispatches(),
        };
        let counters = Counters {
            damaged: if plan.redraw { damage.pixels() } else { 0 },
            ..plan.counters(&stages)
        };
        let draw = |layer: &Layer, target, damage| Draw {
            target,
            size: layer.size,
            frame: self.shared.blocks.of_layer(frame, layer),
            control: self.shared.control.raw(),
            damage,
            count: self.options.count,
        };
        let whole_atlas = plan.atlas.as_ref().map(|atlas| atlas.damage());
        let atlas = plan.atlas.as_ref().zip(whole_atlas.as_ref());
        let executor = Executor {
            avatars: &self.avatars,
            shared: &self.shared,
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

    /// Makes the memory of the pose cache, after waiting for submitted frames. Returns false if the
    /// device has no memory left: no pose is cached from now on.
    fn make_pose_cache(&mut self) -> Result<bool> {
        self.finish()?;
        // SAFETY: every frame is done, and all that binds the buffer gets the new one below.
        let replacement = match unsafe { self.shared.splats.make_cache(&self.gpu) } {
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
            self.shared.replace(replacement);
            for held in self.avatars.values_mut() {
                held.kernels.replace(replacement);
            }
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
        unsafe { self.shared.raster.resize(size) }?;
        self.options.size = size;
        self.has_image = false;
        self.forget();
        Ok(())
    }

    /// People with what is known of their avatars.
    fn planned<'pose>(&self, people: &[Person<'pose>]) -> Result<Vec<PlannedPerson<'_, 'pose>>> {
        let traits = |id| self.avatars.get(id).map(|held| &held.traits);
        Ok(planned(people, traits)?)
    }

    /// Checks a frame, and makes the buffers larger if it needs that, after waiting for submitted
    /// frames.
    fn make_room_for(&mut self, people: &[Person], camera: &Camera) -> Result<()> {
        let planned = self.planned(people)?;
        validate::frame(&planned, camera, &self.options)?;
        let bounds = planned.iter().map(|person| &person.traits.bounds);
        let sizes = SharedSizes {
            capacity: Capacity::of(&self.options, bounds)?,
            ..self.shared.sizes
        };
        if !self.shared.sizes.hold(&sizes) {
            self.finish()?;
            self.make_room(sizes)?;
        }
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
        let capacity = self.shared.raster.image().size;
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
        self.has_image &= self.shared.raster.drawn() == size;
        self.shared.raster.draw_within(size);
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
        download::read_image(&self.gpu, &self.shared.raster)
    }

    /// Waits, and copies every stage's output of the last frame to the host; of what is an avatar's,
    /// that of the one that it was made with.
    pub fn stages(&mut self) -> Result<Stages> {
        self.finish()?;
        match self.avatars.get(AvatarId::FIRST) {
            Some(held) => stages::download(&held.model, &self.shared),
            None => Err(Error::NothingDrawn),
        }
    }
}

/// The kernels of an avatar, bound to the stages that all share.
fn kernels(
    gpu: &Arc<Gpu>,
    traits: &AvatarTraits,
    model: &Model,
    options: &RendererOptions,
    shared: &SharedStages,
) -> Result<AvatarKernels> {
    AvatarKernels::new(gpu, traits, model, options, &shared.memory, &shared.splats)
}

fn upload(gpu: &Arc<Gpu>, prepared: &PreparedAvatar) -> Result<Model> {
    let began = Instant::now();
    let model = Model::new(gpu, prepared.avatar, &prepared.packed)?;
    tracing::info!("uploaded the avatar in {:.1} ms", ms_since(began));
    Ok(model)
}
