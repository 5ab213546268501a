//! What a soak draws without a window: an avatar in full motion before a camera that stands still, onto a screen that no one sees.

use crate::{
    avatar::{Avatar, motion::Player},
    frame::{Camera, Extent, Posed},
    measure::{governor::Quality, upright},
    vulkan::{
        Gpu, Renderer, RendererOptions, Result,
        commands::FrameReport,
        picture::Copied,
        renderer::Presentation,
        screen::Screen,
        watch::{Seen, Watch},
    },
};
use std::sync::Arc;

/// Vertical field of view, and where the camera stands, radians.
const FOV: f64 = 35f64.to_radians();
const YAW: f64 = 20f64.to_radians();
const PITCH: f64 = 5f64.to_radians();
/// Behind the avatar, display-referred RGB.
const BACKGROUND: [f32; 3] = [0.847, 0.867, 0.890];

/// Draws frame after frame.
pub struct Stage<'a> {
    avatar: &'a Avatar,
    player: &'a Player,
    renderer: Renderer,
    screen: Screen,
    watch: Watch,
    camera: Camera,
    /// The cutoff of the whole quality.
    options: RendererOptions,
    quality: Quality,
    posed: Posed,
    /// Frames that the pose was shown for.
    held: u32,
}

/// The middle of a clip, and the camera that a soak stands at, for a picture of `size` px: what is drawn before and after, to be compared.
pub fn middle(avatar: &Avatar, player: &Player, size: [u32; 2]) -> (Posed, Camera) {
    let posed = Posed::new(avatar, &player.pose(0.5 * player.clip().duration()));
    let camera = Camera::around(upright(Extent::new(avatar).bounds(&posed.joints)), YAW, PITCH, FOV, size);
    (posed, camera)
}

impl<'a> Stage<'a> {
    pub fn new(gpu: &Arc<Gpu>, (avatar, player): (&'a Avatar, &'a Player), options: RendererOptions) -> Result<Self> {
        // Those whose place or shape is no number are counted among what is left out.
        let options = RendererOptions { count: true, ..options };
        let renderer = Renderer::new(gpu, avatar, options)?;
        let screen = Screen::new(gpu, options.size)?;
        screen.set_picture(renderer.raster().image());
        let (posed, camera) = middle(avatar, player, options.size);
        let watch = Watch::new(gpu, renderer.raster())?;
        Ok(Self { avatar, player, screen, watch, camera, options, quality: Quality::FULL, posed, held: 0, renderer })
    }

    /// Draws at this quality from now on.
    pub fn set_quality(&mut self, quality: Quality) -> Result<()> {
        self.renderer.adjust(quality.size(self.options.size), quality.cutoff(&self.options), quality.detail(&self.options))?;
        (self.quality, self.held) = (quality, 0);
        Ok(())
    }

    /// Submits a frame of a moment, seconds since the start: the clip goes round and round. `look`: have the picture looked at, if the last
    /// one was.
    pub fn frame(&mut self, seconds: f64, look: bool) -> Result<()> {
        if self.held == 0 {
            let duration = self.player.clip().duration();
            let at = if duration > 0.0 { seconds % duration } else { 0.0 };
            self.posed = Posed::new(self.avatar, &self.player.pose(at));
        }
        self.held = (self.held + 1) % self.quality.hold;
        let camera = self.camera.stretched(self.renderer.options().size);
        let (drawn, image) = (self.renderer.raster().drawn(), self.renderer.raster().image().raw);
        let (screen, watch) = (&self.screen, &mut self.watch);
        let look = look && watch.is_idle();
        let mut record = |commands| {
            screen.record(commands, drawn, BACKGROUND);
            if look {
                watch.record(commands, image, drawn);
            }
        };
        self.renderer.draw(&self.posed, &camera, Some(Presentation { semaphores: None, record: &mut record }))
    }

    /// What was seen in the picture that was looked at, once, some frames later.
    pub fn seen(&mut self) -> Option<Seen> {
        self.watch.step()
    }

    /// What the last frame that is done took and drew.
    pub fn report(&self) -> &FrameReport {
        self.renderer.report()
    }

    /// GPU time of the last frame that is done, ms. None where nothing tells.
    pub fn busy_ms(&self) -> Option<f64> {
        let report = self.renderer.report();
        (!report.stages.is_empty()).then(|| report.gpu_ms())
    }

    /// Waits for every submitted frame.
    pub fn finish(&mut self) -> Result<()> {
        self.renderer.finish()
    }

    /// The middle of the clip, as it is posed and seen.
    pub fn middle(&self) -> (Posed, Camera) {
        (Posed::new(self.avatar, &self.player.pose(0.5 * self.player.clip().duration())), self.camera)
    }

    /// The picture of [`Self::middle`] at the whole quality.
    pub fn picture(&mut self) -> Result<Copied> {
        self.set_quality(Quality::FULL)?;
        let (posed, camera) = self.middle();
        self.renderer.draw(&posed, &camera, None)?;
        self.renderer.copy()
    }
}
