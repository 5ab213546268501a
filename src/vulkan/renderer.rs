//! Draws an avatar, or several copies of it in one scene: poses and a camera go in, a picture on the device comes out.
//! [`Renderer::record`] is the frame, top to bottom.

mod adjust;
mod blocks;
mod readback;

pub use readback::Stages;

use blocks::{FRAME_STRIDE, frame_at};

use super::{
    commands::{FrameReport, SLOTS, Slot},
    control::{BEFORE, COMPUTE, SHARED, WRITTEN, control, in_turn, prepare},
    device::Gpu,
    error::Result,
    features::Features,
    harmonics::Harmonics,
    memory::Buffer,
    model::Model,
    pipeline::{Slice, barrier},
    raster::{Raster, Touched},
    sort::{Sort, SortOptions, choice},
    splats::Splats,
    surface::Surface,
};
use crate::{
    avatar::Avatar,
    frame::{
        Camera, Counters, Extent, Needs, Posed, RendererOptions, Skip, block,
        keeper::Keeper,
        refuse,
        scene::{Scene, Staged},
    },
    layout::{Frame, PYRAMID_WORDS},
    measure::android::section,
};
use ash::vk::{self, PipelineStageFlags};
use bytemuck::bytes_of;
use glam::UVec2;
use gpu_allocator::MemoryLocation;
use std::{sync::Arc, time::Instant};

/// How a frame reaches a screen: what to wait for and signal, and the commands that follow the picture.
pub struct Presentation<'a> {
    /// Signalled when there is something to draw to, and when it is drawn. None where nobody else waits.
    pub semaphores: Option<(vk::Semaphore, vk::Semaphore)>,
    pub record: &'a mut dyn FnMut(vk::CommandBuffer),
}

/// An avatar on a device, in as many poses as it was made for.
pub struct Renderer {
    // Slots come first: dropping them waits for the frames that use all else.
    slots: Vec<Slot>,
    /// None where nothing is left out behind it.
    surface: Option<Surface>,
    features: Features,
    harmonics: Option<Harmonics>,
    splats: Splats,
    sort: Sort,
    raster: Raster,
    control: Buffer,
    /// Features, then node displacements, of one avatar after the other; then the depth surface's pyramid.
    pose: Buffer,
    /// A block for each avatar of each frame under way.
    frames: Buffer,
    model: Model,
    extent: Extent,
    needs: Needs,
    /// One an avatar.
    keepers: Vec<Keeper>,
    options: RendererOptions,
    scene: Scene,
    /// Keys that the control says enter the sort, once it was told.
    entering: Option<u32>,
    /// A box in the picture around all that frames have left there; None where that is not known.
    filled: Option<[UVec2; 2]>,
    next: usize,
    report: FrameReport,
    gpu: Arc<Gpu>,
}

impl Renderer {
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        options.check()?;
        let options = options.settled(gpu);
        let surfaces = options.skip.intersects(Skip::HIDDEN | Skip::DEPTH);
        let model = Model::new(gpu, avatar, surfaces)?;
        let constants = &model.constants;
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC;
        let actors = options.actors as u32;
        let words = 4 * u64::from(actors) * u64::from(block::vectors(constants)) + u64::from(PYRAMID_WORDS);
        // Zeros: a corner of the depth surface may follow a node of a part that no frame has shown yet.
        let pose = Buffer::with_data(gpu, "pose", &vec![0; 4 * words.next_multiple_of(2) as usize], storage)?;
        let blocks = SLOTS * options.actors;
        let frames = (blocks * FRAME_STRIDE) as u64;
        let mut frames = Buffer::new(gpu, "frames", frames, vk::BufferUsageFlags::UNIFORM_BUFFER, MemoryLocation::CpuToGpu)?;
        for block in 0..blocks {
            frames.mapped()[block * FRAME_STRIDE..][..size_of::<Frame>()].copy_from_slice(bytes_of(&*model.constants));
        }
        let control = Buffer::with_data(gpu, "control", bytes_of(&control(0)), storage | vk::BufferUsageFlags::INDIRECT_BUFFER)?;
        let frame = Slice { buffer: frames.raw, offset: 0, size: size_of::<Frame>() as u64 };
        let variant = match options.sort {
            Some(variant) => choice::allow(gpu, variant).map(|()| variant)?,
            None => choice::choose(gpu)?.variant,
        };
        // Where colours change with the view, nothing is kept.
        let options =
            RendererOptions { skip: if avatar.harmonics.is_some() { options.skip - Skip::SKINNING } else { options.skip }, ..options };
        let keep = options.skip.contains(Skip::SKINNING);
        let splats = Splats::new(gpu, &model, (frame, (&pose).into()), variant, (&options, keep))?;
        let sort_options = SortOptions { counts: Some(splats.counts()), ..SortOptions::new(options.key_bits, variant) };
        let sort = Sort::new(gpu, splats.keys(), &control, splats.capacity(), sort_options)?;
        let inputs = ([sort.order(), splats.all(), (&control).into()], splats.capacity());
        let raster = Raster::new(gpu, frame, inputs, (&model.occluder, (&pose).into()), &options)?;
        Ok(Self {
            slots: (0..SLOTS).map(|_| Slot::new(gpu)).collect::<Result<_>>()?,
            surface: (surfaces && model.occluder.index_count > 0)
                .then(|| Surface::new(gpu, frame, &model.occluder, (&pose).into()))
                .transpose()?,
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
            keepers: (0..options.actors).map(|_| Keeper::default()).collect(),
            model,
            options,
            scene: Scene::default(),
            entering: None,
            filled: None,
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

    /// Submits a frame of one avatar. Waits only when two frames are still under way. `camera` must have the picture's size.
    ///
    /// # Errors
    /// When the pose or the camera holds a number that can't be drawn, or the device fails.
    pub fn draw(&mut self, posed: &Posed, camera: &Camera, presentation: Option<Presentation>) -> Result<()> {
        self.draw_scene(&[posed], camera, presentation)
    }

    /// The same of several, at most [`RendererOptions::actors`], sorted together. What is kept from frame to frame goes by place in `poses`.
    ///
    /// # Errors
    /// As [`Self::draw`], and when there are more poses than the renderer was made for.
    pub fn draw_scene(&mut self, poses: &[&Posed], camera: &Camera, presentation: Option<Presentation>) -> Result<()> {
        refuse::frame(poses, camera, &self.extent, &self.options)?;
        let slot = self.next;
        let began = Instant::now();
        let waiting = section(c"wait");
        if let Some(report) = self.slots[slot].finish()? {
            self.report = report;
        }
        drop(waiting);
        let waited = Instant::now();
        // Should anything below fail, nothing of this frame counts as drawn.
        let mut scene = std::mem::take(&mut self.scene);
        let (entering, filled) = (self.entering.take(), self.filled.take());
        let staged =
            scene.next(poses, camera, (&self.extent, &self.needs, &self.options), (self.surface.is_some(), presentation.is_some()));
        if !staged.view && presentation.is_none() {
            (self.scene, self.entering, self.filled) = (scene, entering, filled);
            self.report = FrameReport::idle(self.harmonics.is_some());
            return Ok(());
        }
        let recording = section(c"record");
        self.write_frame(slot, &staged, camera);
        self.slots[slot].begin()?;
        let entering = self.record(slot, &staged, entering, filled);
        let semaphores = presentation.and_then(|presentation| {
            self.slots[slot].stage("present", presentation.record);
            presentation.semaphores
        });
        drop(recording);
        let recorded = Instant::now();
        let _submitting = section(c"submit");
        self.slots[slot].submit(&self.control, self.splats.reasons(), semaphores)?;
        self.slots[slot].timed([began, waited, recorded]);
        (self.scene, self.entering) = (scene, Some(entering));
        self.filled = if staged.view { Some(staged.area) } else { filled };
        self.next = (slot + 1) % SLOTS;
        Ok(())
    }

    /// The frame: which stages run, in which order, and what each waits for. `entering`: what the control says; what it says after the
    /// frame comes out. `filled`: where the picture may hold something.
    fn record(&mut self, slot: usize, staged: &Staged, entering: Option<u32>, filled: Option<[UVec2; 2]>) -> u32 {
        let actors = self.options.actors;
        let at = |number: usize| frame_at(slot, number, actors) as u32;
        let views: Vec<u32> = staged.actors.iter().map(|actor| at(actor.number)).collect();
        let Self { slots, options, features, harmonics, surface, splats, sort, raster, control, gpu, model, .. } = self;
        let slot = &mut slots[slot];
        let commands = slot.commands;
        let hides = surface.as_ref().zip(staged.place).filter(|_| options.skip.contains(Skip::HIDDEN));
        let touched = Touched::new(staged.area, filled, raster.drawn());
        let stages = (harmonics.is_some(), hides.is_some(), sort.dispatches(true));
        let counters = staged.counters(model.constants.gaussians, stages, raster.dispatches());
        slot.note(Counters { area: if staged.view { touched.pixels() } else { 0 }, ..counters });
        let keys = if staged.view { staged.keys() } else { entering.unwrap_or(0) };
        // The frame before may still read what this one writes.
        barrier(gpu, commands, BEFORE, SHARED);
        if entering != Some(keys) || staged.view {
            prepare(gpu, commands, (entering != Some(keys)).then_some((control.raw, keys)), |commands| {
                if staged.view {
                    sort.clear(commands);
                    splats.clear(commands);
                }
            });
        }
        let posed = || staged.actors.iter().filter(|actor| !actor.networks.is_empty());
        if posed().next().is_some() {
            slot.stage("features", |commands| {
                in_turn(gpu, commands, posed(), |actor| features.record(commands, at(actor.number), actor.networks.end() as u32));
            });
            barrier(gpu, commands, WRITTEN, (COMPUTE | PipelineStageFlags::VERTEX_SHADER, SHARED.1));
        } else {
            slot.skip("features");
        }
        if !staged.view {
            harmonics.iter().for_each(|_| slot.skip("harmonics"));
            ["splats", "sort", "raster"].into_iter().for_each(|stage| slot.skip(stage));
            return keys;
        }
        if let Some(lead) = staged.actors.first() {
            let first = at(lead.number);
            if let Some(harmonics) = harmonics {
                slot.stage("harmonics", |commands| harmonics.record(commands, (first, lead.drawn)));
                barrier(gpu, commands, WRITTEN, SHARED);
            }
            if let Some((surface, place)) = hides {
                slot.stage("surface", |commands| surface.record(commands, &views, &place));
                barrier(gpu, commands, WRITTEN, SHARED);
            }
            slot.stage("splats", |commands| {
                in_turn(gpu, commands, staged.actors.iter(), |actor| {
                    let frame = at(actor.number);
                    // All share the model's colours: one avatar's give way to the next's once they are used.
                    if let Some(harmonics) = harmonics.as_ref().filter(|_| frame != first) {
                        harmonics.record(commands, (frame, actor.drawn));
                        barrier(gpu, commands, WRITTEN, SHARED);
                    }
                    splats.record(commands, (frame, actor.drawn), actor.needed.body);
                });
            });
            barrier(gpu, commands, WRITTEN, SHARED);
            slot.stage("sort", |commands| sort.record_counted(commands));
        } else {
            ["splats", "sort"].into_iter().for_each(|stage| slot.skip(stage));
        }
        let covers = staged.place.is_some() && options.skip.contains(Skip::DEPTH);
        let frame = views.first().copied().unwrap_or(at(0));
        raster.record(gpu, slot, (frame, if covers { &views } else { &[] }), control.raw, (&touched, options.count));
        keys
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
        (self.scene, self.filled) = (Scene::default(), None);
        Ok(())
    }
}
