//! Draws people: avatars, who of them stands where, and a camera go in, an image on the device comes
//! out. [`FrameSchedule::new`] says what a frame runs, `execute.rs` records it.

use super::{
    device::Gpu,
    error::Result,
    execute::{Executor, control},
    frame_in_flight::{FRAMES_IN_FLIGHT, FrameInFlight},
    held::{HeldAvatar, traits_of},
    kernel::block_offset,
    model::{self, Model},
    options::accepted,
    raster::Draw,
    sh::SphericalHarmonics,
    shared::SharedStages,
};
use bytemuck::bytes_of;
use effigy_core::{
    avatar::Avatar,
    frame::{
        AvatarId, AvatarTraits, ByAvatar, Counters, Damage, FrameReport, FrameSchedule, Person,
        RendererOptions, Skinning, Stage,
        block::{self, SharedSizes},
        capacity::Capacity,
        passes::RenderTarget,
        people::{PlannedPerson, planned},
        pose_cache::PoseCache,
        schedule::{DeviceState, Equipment},
        state::{AvatarInstance, FramePlan, FrameState, Layer, PlanInput, StageDispatches},
        validate,
    },
    layout::{FrameBlock, SORT_TILE, SettingsBlock},
    scene::{AvatarBounds, Camera, PixelRect, Posed},
};
use std::sync::Arc;

/// Avatars on a device, and the stages that draw people of them.
pub struct Renderer {
    pub(super) frames_in_flight: Vec<FrameInFlight>,
    pub(super) avatars: ByAvatar<HeldAvatar>,
    pub(super) shared: SharedStages,
    /// Of the avatar that it was made with.
    bounds: AvatarBounds,
    /// What is written to a person's block.
    frame: Box<FrameBlock>,
    /// One a person.
    pose_caches: Vec<PoseCache>,
    pub(super) options: RendererOptions,
    state: FrameState,
    /// Keys that the control says the sort takes; None before the first frame.
    key_count: Option<u32>,
    /// A box around all pixels that the last frames drew; None where they are not known.
    damaged: Option<PixelRect>,
    pub(super) next: usize,
    pub(super) report: FrameReport,
    pub(super) gpu: Arc<Gpu>,
}

impl Renderer {
    /// # Errors
    /// When the options can't be drawn with, [`Avatar::check`] finds a fault, or the device's
    /// memory does not suffice.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let mut new = Self::empty(gpu, avatar, options)?;
        new.write(AvatarId::FIRST, avatar)?;
        Ok(new)
    }

    /// Buffers and kernels for an avatar. A browser compiles kernels on other threads: meanwhile
    /// call [`Self::upload`], which fills them. Nothing may be drawn before that.
    ///
    /// # Errors
    /// When the options can't be drawn with, [`Avatar::check`] finds a fault, or the device is out
    /// of memory.
    pub fn empty(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let options = accepted(gpu, options)?;
        avatar.check()?;
        let levels = model::levels(avatar);
        let model = Model::empty(gpu, avatar, &levels)?;
        let traits = traits_of(avatar, &options);
        let capacity = Capacity::new(&options, &traits.bounds)?;
        let sizes = SharedSizes::new(std::iter::once(model.constants(0)), capacity);
        let shared = SharedStages::new(gpu, &options, sizes)?;
        let bounds = traits.bounds.clone();
        let frame = Box::new(*model.constants(0));
        let held = HeldAvatar::new(gpu, avatar, &levels, traits, model, &options, &shared)?;
        let new = Self {
            frames_in_flight: (0..FRAMES_IN_FLIGHT)
                .map(|_| FrameInFlight::new(gpu))
                .collect::<Result<_>>()?,
            avatars: ByAvatar::new(held),
            shared,
            bounds,
            frame,
            pose_caches: (0..options.instances)
                .map(|_| PoseCache::default())
                .collect(),
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

    /// Holds another avatar from now on, of which people can be drawn. A browser compiles its
    /// kernels on other threads: meanwhile call [`Self::upload`] with what this returns; nobody of
    /// it may be drawn before that. Adding one twice takes its memory twice: people of one avatar
    /// share it.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, or the device is lost or out of memory.
    pub fn add_avatar(&mut self, avatar: &Avatar) -> Result<AvatarId> {
        avatar.check()?;
        let levels = model::levels(avatar);
        let model = Model::empty(&self.gpu, avatar, &levels)?;
        let traits = traits_of(avatar, &self.options);
        let held = self.avatars.values().map(|held| held.model.constants(0));
        let sizes = SharedSizes::new(held.chain([model.constants(0)]), self.shared.sizes.capacity);
        self.make_room(sizes)?;
        let held = HeldAvatar::new(
            &self.gpu,
            avatar,
            &levels,
            traits,
            model,
            &self.options,
            &self.shared,
        )?;
        self.gpu.check()?;
        Ok(self.avatars.insert(held))
    }

    /// Gives an avatar's memory back: no person of it can be drawn any more. False if it is not
    /// held.
    pub fn remove_avatar(&mut self, avatar: AvatarId) -> bool {
        self.avatars.remove(avatar).is_some()
    }

    /// Makes what is shared anew if these sizes are more than it has; the image stays.
    fn make_room(&mut self, sizes: SharedSizes) -> Result<()> {
        if self.shared.sizes.hold(&sizes) {
            return Ok(());
        }
        let sizes = sizes.union(self.shared.sizes);
        self.shared
            .resize_buffers(&self.gpu, &self.options, sizes)?;
        for held in self.avatars.values_mut() {
            held.rebind(&self.gpu, &self.options, &self.shared);
        }
        self.key_count = None;
        self.forget();
        self.gpu.check()
    }

    /// Has the next frame compute and draw all.
    fn forget(&mut self) {
        for cache in &mut self.pose_caches {
            *cache = PoseCache::default();
        }
        self.state = FrameState::default();
        self.damaged = None;
    }

    /// Fills the buffers that [`Self::empty`] or [`Self::add_avatar`] made for this avatar, whose
    /// spherical harmonics they have uploaded. False, and nothing has changed, where its arrays have
    /// other lengths.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, the device's memory does not suffice, or it is lost.
    pub fn upload(&mut self, id: AvatarId, avatar: &Avatar) -> Result<bool> {
        avatar.check()?;
        self.write(id, avatar)
    }

    /// [`Self::upload`] of an avatar that was checked.
    fn write(&mut self, id: AvatarId, avatar: &Avatar) -> Result<bool> {
        let levels = model::levels(avatar);
        let Some(held) = self.avatars.get_mut(id) else {
            return Ok(false);
        };
        if !held.model.fits(avatar) || !held.model.fits_levels(&levels) {
            return Ok(false);
        }
        held.model.fill(&self.gpu, avatar);
        held.model.fill_levels(&self.gpu, avatar, &levels);
        self.gpu.check()?;
        Ok(true)
    }

    /// Draws small images of an avatar from its levels, too, from the next frame on. This is for one
    /// that was uploaded without them, so that a page's first frame does not wait for them. No
    /// kernel is compiled unless a level has longer arrays than the avatar. Returns false and
    /// changes nothing if the avatar has no levels or is another one, if it has levels already, or
    /// if the capacity is too small to draw from levels.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, or the device is lost or out of memory.
    pub fn add_levels(&mut self, id: AvatarId, avatar: &Avatar) -> Result<bool> {
        let Some(held) = self.avatars.get(id) else {
            return Ok(false);
        };
        if avatar.levels.is_empty() || held.model.sets() > 1 || !held.model.fits(avatar) {
            return Ok(false);
        }
        avatar.check()?;
        let traits = traits_of(avatar, &self.options);
        if !self.has_capacity(&traits.bounds)? {
            return Ok(false);
        }
        self.show_anew(id, avatar, traits)?;
        Ok(true)
    }

    /// Whether the buffers hold all that frames of an avatar with these bounds may draw.
    fn has_capacity(&self, bounds: &AvatarBounds) -> Result<bool> {
        let capacity = Capacity::new(&self.options, bounds)?;
        Ok(self.shared.sizes.capacity.holds(&capacity))
    }

    /// Writes levels and harmonics, and has the next frame compute and draw all of an avatar.
    fn show_anew(&mut self, id: AvatarId, avatar: &Avatar, traits: AvatarTraits) -> Result<()> {
        let levels = model::levels(avatar);
        let Some(held) = self.avatars.get_mut(id) else {
            return Ok(());
        };
        if id == AvatarId::FIRST {
            self.bounds = traits.bounds.clone();
        }
        held.show_anew(&self.gpu, avatar, &levels, traits, &self.shared)?;
        self.forget();
        self.gpu.check()
    }

    /// Draws this avatar in place of one that is held from now on, which has its Gaussians and nodes
    /// and may have other correctives of the same number, other spherical harmonics of the same
    /// degree and any levels: kernels stay, as with [`Self::add_levels`]. False, and nothing has
    /// changed, where its arrays have other lengths.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault, or the device is lost.
    pub fn replace_avatar(&mut self, id: AvatarId, avatar: &Avatar) -> Result<bool> {
        avatar.check()?;
        let traits = traits_of(avatar, &self.options);
        let has_capacity = self.has_capacity(&traits.bounds)?;
        let Some(held) = self.avatars.get_mut(id) else {
            return Ok(false);
        };
        let degree = SphericalHarmonics::degree_of(avatar);
        if degree != held.sh.as_ref().map(SphericalHarmonics::degree)
            || !held.model.fits(avatar)
            || !has_capacity
        {
            return Ok(false);
        }
        held.model.fill(&self.gpu, avatar);
        self.show_anew(id, avatar, traits)?;
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

    /// What it draws with, resolved.
    pub fn options(&self) -> &RendererOptions {
        &self.options
    }

    /// The image, premultiplied.
    pub fn image_view(&self) -> &wgpu::TextureView {
        self.shared.raster.view()
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

    /// Submits a frame of people, at most [`RendererOptions::instances`], sorted together; says
    /// whether anything had to be drawn. Caches and changes go by place in `people`: keep everybody's
    /// from frame to frame. Natively it waits when two frames are
    /// still under way; in a browser, call it when [`Self::ready`].
    ///
    /// # Errors
    /// When a pose or the camera holds a number that can't be drawn, a pose is another avatar's or
    /// its avatar is not held, there are too many people, or the device is lost or out of memory.
    pub fn draw_scene(&mut self, people: &[Person], camera: &Camera) -> Result<bool> {
        self.make_room_for(people, camera)?;
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
            people: &self.planned(people)?,
            camera,
            options: &self.options,
            capacity: self.shared.sizes.capacity,
            always_submit: false,
        });
        if !plan.redraw {
            self.state = state;
            self.damaged = damaged;
            self.report = FrameReport::idle(&self.equipment());
            return Ok(false);
        }
        if let Some(atlas) = &plan.atlas {
            self.shared.make_atlas(&self.gpu, atlas.layer.size)?;
            self.shared.raster.write_slots(&self.gpu, &atlas.slots);
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
        self.draw_scene(&[posed.into()], camera)
    }

    /// People with what is known of their avatars.
    fn planned<'pose>(&self, people: &[Person<'pose>]) -> Result<Vec<PlannedPerson<'_, 'pose>>> {
        let traits = |id| self.avatars.get(id).map(|held| &held.traits);
        Ok(planned(people, traits)?)
    }

    /// Checks a frame, and makes the buffers larger if it needs that.
    fn make_room_for(&mut self, people: &[Person], camera: &Camera) -> Result<()> {
        let planned = self.planned(people)?;
        validate::frame(&planned, camera, &self.options)?;
        let bounds = planned.iter().map(|person| &person.traits.bounds);
        let sizes = SharedSizes {
            capacity: Capacity::of(&self.options, bounds)?,
            ..self.shared.sizes
        };
        self.make_room(sizes)
    }

    /// Records a schedule, and submits it.
    fn submit(&mut self, schedule: &FrameSchedule, plan: &FramePlan, damage: &Damage) {
        let stages = StageDispatches {
            sort: schedule.runs(Stage::Sort) * self.shared.sort.dispatches() as u64,
            // Quads have none without the stages before them.
            raster: schedule.runs(Stage::Binning) * self.shared.raster.dispatches(),
        };
        let counters = Counters {
            damaged: damage.pixels(),
            ..plan.counters(&stages)
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
            avatars: &self.avatars,
            shared: &self.shared,
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
        let SharedStages {
            control, splats, ..
        } = &self.shared;
        in_flight.submit(&self.gpu, encoder, control, splats);
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
            first_region: self.shared.raster.first_region(damage),
            ..self.shared.settings
        };
        let first = match &plan.atlas {
            Some(atlas) => SettingsBlock {
                key_count: atlas.layer.key_count(),
                first_region: [0; 2],
                ..self.shared.settings
            },
            None => image,
        };
        if self.key_count.is_none() || self.shared.settings != first {
            self.shared.settings = first;
            self.gpu
                .queue
                .write_buffer(&self.shared.blocks.settings, 0, bytes_of(&first));
        }
        if plan.layers().count() > 1 {
            self.shared.settings = image;
            self.shared
                .blocks
                .write_second(&self.gpu, &image, &control(image.key_count));
        }
        for instance in plan
            .instances()
            .filter(|instance| instance.changes.skinning == Skinning::ComputeAndStore)
        {
            if let Some(held) = self.avatars.get(instance.avatar) {
                self.pose_caches[instance.index] =
                    PoseCache::new(&held.traits.bounds, instance.posed, camera);
            }
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
        let block = &mut *self.frame;
        if let Some(instance) = instance
            && let Some(held) = self.avatars.get(instance.avatar)
        {
            block::write_constants(block, held.model.constants(instance.model));
        }
        block::write_shared(block, &self.options, layer, camera);
        self.shared.splats.fill(block);
        block.count_tile = SORT_TILE;
        if let Some(instance) = instance {
            let pose = self.shared.sizes.pose_layout();
            block::write_instance(block, &self.options, layer, instance, pose);
            self.shared
                .splats
                .fill_instance(block, instance.cache_start);
            self.pose_caches[number].write_to(block, camera);
        }
        self.gpu.queue.write_buffer(
            &self.shared.blocks.frames,
            u64::from(block_offset(number)),
            bytes_of(block),
        );
    }

    /// Changes the image's size. On failure the old image stays.
    ///
    /// # Errors
    /// When the device does not draw that size.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.shared.resize_image(&self.gpu, size)?;
        self.options.size = size;
        self.state = FrameState::default();
        self.damaged = None;
        self.gpu.check()
    }
}
