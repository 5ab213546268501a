//! Draws scenes against the clock: an avatar, a setting and scenes go in; a time and a report a frame come out.
//!
//! Two frames are in flight, as in use. Frame time is the time from one frame's hand-over to the next, which in a steady state is what
//! a frame takes.

use super::{
    Case,
    backend::{Opened, Renderer, Result},
    scene::Scene,
};
#[cfg(feature = "webgpu")]
use crate::webgpu;
use crate::{
    avatar::Avatar,
    frame::{FrameReport, Picture, RendererOptions, Skip},
    vulkan::{Gpu, GpuOptions, commands::SLOTS},
};
use std::{borrow::Cow, time::Instant};

/// Tells how far a measurement is: what is being done, and how many of how many.
pub type Progress<'a> = &'a mut dyn FnMut(&str, usize, usize);

/// How to draw: everything that trades time for error.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    pub options: RendererOptions,
    /// Read f16 as words even where the device has 16-bit storage.
    pub packed_words: bool,
    /// Share of the basis rows to keep, 0 to 1.
    pub rows: f64,
    /// Frames that a pose is held, at least 1.
    pub hold: usize,
}

impl Setting {
    /// As a case is drawn: in full motion every frame is, even where an avatar stands still before a single camera.
    pub fn of(&self, case: Case) -> Self {
        let mut setting = *self;
        if case == Case::Full {
            setting.options.skip -= Skip::FRAME;
        }
        setting
    }

    /// The avatar as this setting draws it.
    pub fn fit<'a>(&self, avatar: &'a Avatar) -> Cow<'a, Avatar> {
        if self.rows < 1.0 { Cow::Owned(avatar.keep_rows(self.rows)) } else { Cow::Borrowed(avatar) }
    }
}

/// One device opened in as many ways as settings need: opened when first asked for.
pub struct Devices {
    backend: Backend,
    options: GpuOptions,
    open: [Option<Opened>; 2],
}

/// Which of the backends draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Backend {
    #[default]
    Vulkan,
    #[cfg(feature = "webgpu")]
    WebGpu,
}

impl Devices {
    pub fn new(backend: Backend, options: GpuOptions) -> Self {
        Self { backend, options, open: [None, None] }
    }

    /// The device as a setting wants it.
    pub fn get(&mut self, setting: &Setting) -> Result<Opened> {
        let place = &mut self.open[usize::from(setting.packed_words)];
        if let Some(gpu) = place {
            return Ok(gpu.clone());
        }
        let gpu = match self.backend {
            Backend::Vulkan => Opened::Vulkan(Gpu::new(&GpuOptions { packed_words: setting.packed_words, ..self.options.clone() })?),
            #[cfg(feature = "webgpu")]
            Backend::WebGpu => Opened::WebGpu(webgpu::Gpu::open(self.options.device.as_deref())?),
        };
        Ok(place.insert(gpu).clone())
    }
}

/// What draws scenes.
pub struct Drawer {
    renderer: Renderer,
}

impl Drawer {
    /// `avatar` as the setting fits it. `count`: whether to count what costs time to count.
    pub fn new(gpu: &Opened, avatar: &Avatar, setting: &Setting, case: Case, count: bool) -> Result<Self> {
        let options = RendererOptions { actors: case.actors(), count, ..setting.options };
        Ok(Self { renderer: Renderer::new(gpu, avatar, options)? })
    }

    /// Corners and triangles of the depth surface.
    pub fn surface(&self) -> [u64; 2] {
        self.renderer.surface_size()
    }

    /// Submits a frame, or finds that none is needed.
    pub fn draw(&mut self, scene: &Scene) -> Result<()> {
        self.renderer.draw(scene)
    }

    /// Waits for every submitted frame.
    pub fn finish(&mut self) -> Result<()> {
        self.renderer.finish()
    }

    /// Waits, and copies the last frame's picture.
    pub fn picture(&mut self) -> Result<Picture> {
        self.renderer.picture()
    }
}

/// What timing gave, an entry a frame.
#[derive(Default)]
pub struct Samples {
    /// ms
    pub intervals: Vec<f64>,
    pub reports: Vec<FrameReport>,
}

/// Draws the scenes, `warm_up` of them once before the clock starts. `tick` is told how many were timed.
pub fn time(drawer: &mut Drawer, scenes: &[Scene], warm_up: usize, mut tick: impl FnMut(usize)) -> Result<Samples> {
    for scene in scenes.iter().cycle().take(warm_up) {
        drawer.draw(scene)?;
    }
    drawer.finish()?;
    let mut samples = Samples::default();
    // A frame is over when its slot is free again, a few hand-overs later; until the pipeline is full, hand-overs come at another pace.
    let filling = 2 * SLOTS;
    let mut last = Instant::now();
    for at in 0..scenes.len() + filling {
        drawer.draw(&scenes[at % scenes.len()])?;
        let now = Instant::now();
        if at >= filling {
            samples.intervals.push((now - last).as_secs_f64() * 1e3);
            samples.reports.push(drawer.renderer.report().clone());
            tick(samples.reports.len());
        }
        last = now;
    }
    drawer.finish()?;
    Ok(samples)
}

/// Draws the scenes once without a clock, and says what each took in, left out and drew.
pub fn count(drawer: &mut Drawer, scenes: &[Scene], mut tick: impl FnMut(usize)) -> Result<Vec<FrameReport>> {
    // What is kept from the frame before is kept in the first one too, as where frames are timed.
    scenes.last().map_or(Ok(()), |scene| drawer.draw(scene))?;
    let mut reports = Vec::with_capacity(scenes.len());
    for scene in scenes {
        drawer.finish()?;
        drawer.draw(scene)?;
        drawer.finish()?;
        reports.push(drawer.renderer.report().clone());
        tick(reports.len());
    }
    Ok(reports)
}
