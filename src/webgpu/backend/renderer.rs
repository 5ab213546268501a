//! Draws an avatar, or several copies of it in one scene: poses and a camera go in, a picture on the device comes out.
//! [`Renderer::record`] is the frame, top to bottom.

use super::{
    buffer::{STORAGE, empty},
    device::Gpu,
    error::Result,
    features::Features,
    harmonics::Harmonics,
    kernel::{Blocks, FRAME_STRIDE},
    model::Model,
    options::accepted,
    owned::Buffer,
    raster::{Inputs, Raster},
    slot::{SLOTS, Slot},
    sort::{self, Sort},
    splats::Splats,
    surface::Surface,
};
use crate::{
    avatar::Avatar,
    frame::{
        Body, Camera, Counters, Extent, FrameReport, Needs, Posed, RendererOptions, Touched, block,
        keeper::Keeper,
        refuse,
        scene::{Actor, Scene, Staged},
    },
    layout::{BINS_WEB, Control, Frame, PYRAMID_WORDS, RASTER_QUADS, SORT_TILE, Settings},
};
use bytemuck::bytes_of;
use glam::UVec2;
use std::sync::Arc;

/// An avatar on a device, in as many poses as it was made for.
pub struct Renderer {
    pub(super) slots: Vec<Slot>,
    pub(super) surface: Option<Surface>,
    features: Features,
    harmonics: Option<Harmonics>,
    pub(super) splats: Splats,
    pub(super) sort: Sort,
    pub(super) raster: Raster,
    pub(super) control: Buffer,
    /// Features, then node displacements, of one avatar after the other; then the depth surface's pyramid.
    pub(super) pose: Buffer,
    pub(super) blocks: Blocks,
    settings: Settings,
    /// What is written to an avatar's block.
    pub(super) frame: Box<Frame>,
    pub(super) model: Model,
    pub(super) extent: Extent,
    pub(super) needs: Needs,
    /// One an avatar.
    pub(super) keepers: Vec<Keeper>,
    pub(super) options: RendererOptions,
    pub(super) scene: Scene,
    /// Keys that the control says enter the sort, once it was told.
    entering: Option<u32>,
    /// A box in the picture around all that frames have left there; None where that is not known.
    filled: Option<[UVec2; 2]>,
    pub(super) next: usize,
    pub(super) report: FrameReport,
    pub(super) gpu: Arc<Gpu>,
}

/// Where an avatar's uniform block is, bytes.
fn frame_at(number: usize) -> u32 {
    (number as u64 * FRAME_STRIDE) as u32
}

impl Renderer {
    /// # Errors
    /// When the options can't be drawn with, or the device has no room.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let mut new = Self::empty(gpu, avatar, options)?;
        new.take(avatar)?;
        Ok(new)
    }

    /// Room for an avatar and kernels for it, which a browser compiles elsewhere: meanwhile there is time for [`Self::take`], which fills it,
    /// makes the depth surface, and without which nothing may be drawn.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(crate) fn empty(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        let options = accepted(gpu, avatar, options)?;
        let model = Model::empty(gpu, avatar)?;
        let constants = &model.constants;
        let actors = options.actors as u32;
        let words = 4 * u64::from(actors) * u64::from(block::vectors(constants)) + u64::from(PYRAMID_WORDS);
        let pose = empty(gpu, "pose", 4 * words.next_multiple_of(4), STORAGE)?;
        let control = empty(gpu, "control", size_of::<Control>() as u64, STORAGE | wgpu::BufferUsages::INDIRECT)?;
        let blocks = Blocks::new(gpu, options.actors)?;
        let splats = Splats::new(gpu, &model, (&blocks, &pose), &options)?;
        let sort = Sort::new(gpu, &blocks, (splats.keys(), splats.counts()), &control, (splats.capacity(), sort::variant(&options)))?;
        let inputs =
            Inputs { order: sort.order(), splats: splats.all(), keys: splats.keys(), control: &control, capacity: splats.capacity() };
        let raster = Raster::new(gpu, &blocks, inputs, &options)?;
        let features = Features::new(gpu, &model, &blocks, &pose);
        let harmonics = Harmonics::new(gpu, avatar, &model, &blocks)?;
        let mut settings = Settings::default();
        sort.fill(&mut settings);
        Raster::fill(&mut settings, &options, splats.capacity());
        let new = Self {
            slots: (0..SLOTS).map(|_| Slot::new(gpu)).collect::<Result<_>>()?,
            surface: None,
            features,
            harmonics,
            splats,
            sort,
            raster,
            control,
            pose,
            blocks,
            settings,
            frame: model.constants.clone(),
            extent: Extent::new(avatar),
            needs: Needs::new(avatar),
            keepers: (0..options.actors).map(|_| Keeper::default()).collect(),
            model,
            options,
            scene: Scene::default(),
            entering: None,
            filled: None,
            next: 0,
            report: FrameReport::default(),
            gpu: gpu.clone(),
        };
        gpu.check()?;
        Ok(new)
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
        self.surface.as_ref().map_or([0; 2], Surface::size)
    }

    /// What it draws with, everything settled.
    pub fn options(&self) -> &RendererOptions {
        &self.options
    }

    /// The picture, premultiplied.
    pub fn picture_view(&self) -> &wgpu::TextureView {
        self.raster.view()
    }

    /// What the last finished frame took and drew: at most two frames old. A frame that needed nothing is finished at once.
    pub fn report(&self) -> &FrameReport {
        &self.report
    }

    /// Whether the next frame can be submitted without more than two under way. Takes note of finished ones.
    pub fn ready(&mut self) -> bool {
        if let Some(report) = self.slots[self.next].finish() {
            self.report = report;
        }
        !self.slots[self.next].is_pending()
    }

    /// Submits a frame of several avatars, at most [`RendererOptions::actors`], sorted together; says whether anything had to be drawn.
    /// What is kept from frame to frame goes by place in `poses`. Natively it waits when two frames are still under way; in a browser,
    /// call it when [`Self::ready`].
    ///
    /// # Errors
    /// When a pose or the camera holds a number that can't be drawn, there are too many poses, or the device is lost.
    pub fn draw_scene(&mut self, poses: &[&Posed], camera: &Camera) -> Result<bool> {
        refuse::frame(poses, camera, &self.extent, &self.options)?;
        self.gpu.check()?;
        #[cfg(not(target_arch = "wasm32"))]
        if let Some(submission) = self.slots[self.next].submission() {
            self.gpu.wait(Some(submission), "a frame")?;
        }
        if !self.ready() {
            return Ok(false);
        }
        let staged = self.scene.next(poses, camera, (&self.extent, &self.needs, &self.options), (self.surface.is_some(), false));
        if !staged.view {
            self.report = FrameReport::idle(self.harmonics.is_some());
            return Ok(false);
        }
        let touched = Touched::new(staged.area, self.filled, self.options.size);
        self.filled = Some(staged.area);
        self.write_frame(&staged, camera, &touched);
        self.record(&staged, &touched);
        self.next = (self.next + 1) % SLOTS;
        Ok(true)
    }

    /// The same of one avatar.
    ///
    /// # Errors
    /// As [`Self::draw_scene`].
    pub fn draw(&mut self, posed: &Posed, camera: &Camera) -> Result<bool> {
        self.draw_scene(&[posed], camera)
    }

    /// The frame: which stages run, in which order.
    fn record(&mut self, staged: &Staged, touched: &Touched) {
        let Self { slots, options, features, harmonics, surface, splats, sort, raster, control, model, .. } = self;
        let views: Vec<u32> = staged.actors.iter().map(|actor| frame_at(actor.number)).collect();
        let slot = &mut slots[self.next];
        let hides = surface.as_ref().filter(|_| staged.place.is_some());
        let stages = (harmonics.is_some(), hides.is_some(), sort.dispatches());
        let counters = staged.counters(model.constants.gaussians, stages, raster.dispatches());
        slot.begin(Counters { area: touched.pixels(), ..counters }, options.count);
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame") });
        splats.clear(&mut encoder);
        if staged.actors.iter().any(|actor| !actor.networks.is_empty()) {
            let writes = slot.stage("features");
            let mut pass = slot.pass(&mut encoder, "features", writes);
            for actor in staged.actors.iter().filter(|actor| !actor.networks.is_empty()) {
                features.record(&mut pass, frame_at(actor.number), actor.networks.end() as u32);
            }
        } else {
            slot.skip("features");
        }
        if let Some(lead) = staged.actors.first() {
            let first = frame_at(lead.number);
            if let Some(harmonics) = harmonics {
                let writes = slot.stage("harmonics");
                harmonics.record(&mut slot.pass(&mut encoder, "harmonics", writes), (first, lead.drawn));
            }
            if let Some(surface) = hides {
                surface.record(slot, &mut encoder, &views);
            }
            let writes = slot.stage("splats");
            let mut pass = slot.pass(&mut encoder, "splats", writes);
            for actor in &staged.actors {
                let frame = frame_at(actor.number);
                // All share the model's colours: one avatar's give way to the next's once they are used.
                harmonics.iter().filter(|_| frame != first).for_each(|harmonics| harmonics.record(&mut pass, (frame, actor.drawn)));
                splats.record(&mut pass, (frame, actor.drawn), actor.needed.body);
            }
            drop(pass);
            let writes = slot.stage("sort");
            sort.record(&mut slot.pass(&mut encoder, "sort", writes));
        } else {
            ["splats", "sort"].into_iter().for_each(|stage| slot.skip(stage));
        }
        raster.record(slot, &mut encoder, views.first().copied().unwrap_or(0), (control, touched));
        slot.submit(&self.gpu, encoder, control, splats);
    }

    /// Fills the uniform blocks of a frame.
    fn write_frame(&mut self, staged: &Staged, camera: &Camera, touched: &Touched) {
        let keys = staged.keys();
        let settings = Settings { entering: keys, first_region: touched.regions()[0], ..self.settings };
        if self.entering.is_none() || self.settings != settings {
            self.settings = settings;
            self.gpu.queue.write_buffer(&self.blocks.settings, 0, bytes_of(&settings));
        }
        if self.entering != Some(keys) {
            self.entering = Some(keys);
            let control = Control { index_count: 6 * RASTER_QUADS, entering: keys, ..Control::default() };
            self.gpu.queue.write_buffer(&self.control, 0, bytes_of(&control));
        }
        for actor in staged.actors.iter().filter(|actor| actor.needed.body == Body::Keep) {
            self.keepers[actor.number] = Keeper::new(&self.extent, actor.posed, camera);
        }
        // An empty picture has a size too.
        if staged.actors.is_empty() {
            self.write_block(staged, camera, 0, None);
        }
        for actor in &staged.actors {
            self.write_block(staged, camera, actor.number, Some(actor));
        }
    }

    fn write_block(&mut self, staged: &Staged, camera: &Camera, number: usize, actor: Option<&Actor>) {
        let block = &mut *self.frame;
        block::fill_shared(block, &self.options, staged, camera);
        if self.surface.is_none() {
            block.surface_start = 0;
        }
        self.splats.fill(block);
        block.tile = BINS_WEB.tile(camera.size) as f32;
        block.count_tile = SORT_TILE;
        if let Some(actor) = actor {
            block::fill_actor(block, &self.options, actor, camera);
            self.splats.fill_actor(block, number as u32);
            self.keepers[number].fill(block, camera);
        }
        self.gpu.queue.write_buffer(&self.blocks.frames, u64::from(frame_at(number)), bytes_of(block));
    }

    /// Changes the picture's size. On failure the old picture stays.
    ///
    /// # Errors
    /// When the device does not draw that size.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        let Self { splats, sort, control, raster, blocks, .. } = self;
        let inputs = Inputs { order: sort.order(), splats: splats.all(), keys: splats.keys(), control, capacity: splats.capacity() };
        raster.resize(&self.gpu, blocks, inputs, size)?;
        self.options.size = size;
        (self.scene, self.filled) = (Scene::default(), None);
        self.gpu.check()
    }
}
