//! Draws a soak without a window: an avatar in motion before a fixed camera, onto an offscreen
//! target.

use effigy_core::{
    avatar::{Avatar, motion::Player},
    scene::{AvatarBounds, Camera, Orbit, Posed},
};
use effigy_render::vulkan::{
    Copied, FrameReport, FrameValidator, Gpu, Offscreen, PixelCounts, Presentation, Recording,
    Renderer, RendererOptions, Result,
};
use effigy_runtime::governor::FrameQuality;
use std::sync::Arc;

/// Vertical field of view, and the camera's direction, radians.
const FOV: f64 = 35f64.to_radians();
const YAW: f64 = 20f64.to_radians();
const PITCH: f64 = 5f64.to_radians();
/// Behind the avatar, display-referred RGB.
const BACKGROUND: [f32; 3] = [0.847, 0.867, 0.890];

/// Draws one frame after another.
pub struct SoakRenderer<'a> {
    avatar: &'a Avatar,
    player: &'a Player,
    renderer: Renderer,
    screen: Offscreen,
    validator: FrameValidator,
    camera: Camera,
    /// The options at full quality.
    options: RendererOptions,
    quality: FrameQuality,
    posed: Posed,
    /// Frames that the pose has been held for.
    held: u32,
}

/// The middle of a clip and the camera of a soak, for an image of `size` px: the frame that is
/// drawn before and after a soak to be compared.
pub fn middle_frame(avatar: &Avatar, player: &Player, size: [u32; 2]) -> (Posed, Camera) {
    let posed = Posed::new(avatar, &player.pose(0.5 * player.clip().duration()));
    let framing = AvatarBounds::new(avatar).framing(&posed.joints);
    let camera = Camera::around(
        framing,
        Orbit {
            yaw: YAW,
            pitch: PITCH,
            fov: FOV,
        },
        size,
    );
    (posed, camera)
}

impl<'a> SoakRenderer<'a> {
    /// A renderer at full quality.
    ///
    /// # Errors
    /// When the device can't draw the avatar with these options.
    pub fn new(
        gpu: &Arc<Gpu>,
        avatar: &'a Avatar,
        player: &'a Player,
        options: RendererOptions,
    ) -> Result<Self> {
        // Gaussians whose place or shape is NaN are counted among the culled ones.
        let options = RendererOptions {
            count: true,
            ..options
        };
        let renderer = Renderer::new(gpu, avatar, options)?;
        let screen = Offscreen::new(gpu, options.size)?;
        // SAFETY: nothing uses the screen yet, every frame leaves the image in the layout that the
        // screen reads, and the renderer's image has the screen's size.
        unsafe { screen.set_image(renderer.raster().image()) };
        let (posed, camera) = middle_frame(avatar, player, options.size);
        let validator = FrameValidator::new(gpu, renderer.raster())?;
        Ok(Self {
            avatar,
            player,
            renderer,
            screen,
            validator,
            camera,
            options,
            quality: FrameQuality::FULL,
            posed,
            held: 0,
        })
    }

    /// Sets the quality of the next frames.
    ///
    /// # Errors
    /// When the device fails.
    pub fn set_quality(&mut self, quality: FrameQuality) -> Result<()> {
        self.renderer.adjust(
            quality.size(self.options.size),
            quality.detail(self.options.detail),
        )?;
        self.quality = quality;
        self.held = 0;
        Ok(())
    }

    /// Submits the frame at a time, seconds since the start; the clip is repeated. With `check`,
    /// the image is checked, unless a check is still in progress.
    ///
    /// # Errors
    /// When the device fails.
    pub fn draw(&mut self, seconds: f64, check: bool) -> Result<()> {
        if self.held == 0 {
            let duration = self.player.clip().duration();
            let clip_time = if duration > 0.0 {
                seconds % duration
            } else {
                0.0
            };
            self.posed = Posed::new(self.avatar, &self.player.pose(clip_time));
        }
        self.held = (self.held + 1) % self.quality.hold;
        let camera = self.camera.stretched(self.renderer.options().size);
        let drawn = self.renderer.raster().drawn();
        let image = self.renderer.raster().image().raw();
        let screen = &self.screen;
        let validator = &mut self.validator;
        let check = check && validator.is_idle();
        let mut record = |commands: Recording, _| {
            screen.record(commands, drawn, BACKGROUND);
            if check {
                // SAFETY: this follows the frame, whose image lives as long as the renderer.
                unsafe { validator.record(commands, image, drawn) };
            }
        };
        // SAFETY: the renderer is dropped before the screen and the validator, and waits for its
        // frames.
        let presentation = unsafe { Presentation::new(None, &mut record) };
        self.renderer.draw(&self.posed, &camera, Some(presentation))
    }

    /// The result of a check, once, some frames after its image was drawn. To be called after each
    /// frame.
    pub fn finished_check(&mut self) -> Option<PixelCounts> {
        self.validator.step()
    }

    /// Times and counts of the last finished frame.
    pub fn report(&self) -> &FrameReport {
        self.renderer.report()
    }

    /// GPU time of the last finished frame, ms. None without timestamps.
    pub fn busy_ms(&self) -> Option<f64> {
        let report = self.renderer.report();
        (!report.stages.is_empty()).then(|| report.gpu_ms())
    }

    /// Waits for every submitted frame.
    ///
    /// # Errors
    /// When the device fails.
    pub fn finish(&mut self) -> Result<()> {
        self.renderer.finish()
    }

    /// The image of [`middle_frame`] at full quality.
    ///
    /// # Errors
    /// When the device fails.
    pub fn draw_middle_frame(&mut self) -> Result<Copied> {
        self.set_quality(FrameQuality::FULL)?;
        let (posed, camera) = middle_frame(self.avatar, self.player, self.options.size);
        self.renderer.draw(&posed, &camera, None)?;
        self.renderer.copy()
    }
}
