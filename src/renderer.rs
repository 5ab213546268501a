//! Avatars on a device, drawn to images.

use crate::{AvatarBounds, AvatarId, Camera, FrameImage, FrameReport, Gpu, Person, Posed, Result};
use effigy_core::{avatar::Avatar, frame, scene::Supersampling};
use effigy_render::vulkan;

/// What an image is drawn with. The defaults are the best that a device can do at its speed.
#[derive(Clone, Copy, Debug)]
pub struct RendererOptions(frame::RendererOptions);

impl RendererOptions {
    /// The defaults, for images of a width and height, px.
    pub fn new(size: [u32; 2]) -> Self {
        Self(frame::RendererOptions::new(size))
    }

    /// Images that differ from the model by no more than rounding: 16-bit floats, nothing skipped
    /// that changes them by more, and small avatars as the model says, not as the area of each pixel
    /// shows them.
    pub fn exactly(self) -> Self {
        Self(self.0.exactly())
    }

    /// At most so many people in a scene, 1 to 1024 [default: 1]; memory grows with it.
    pub fn people(mut self, most: usize) -> Self {
        self.0.instances = most;
        self
    }

    /// At most so many Gaussians a frame, of all people together; where there are more, those with
    /// the most a pixel are drawn from coarser levels [default: all, or those of four people where
    /// there may be more than 16]. Memory grows with it.
    pub fn gaussians(mut self, most: u32) -> Self {
        self.0.gaussians = Some(most);
        self
    }

    /// Draws avatars as large as they are shown. By default those under 720 px are drawn larger and
    /// averaged, which shows the area of each pixel.
    pub fn without_supersampling(mut self) -> Self {
        self.0.supersampling = Supersampling::OFF;
        self
    }
}

/// Avatars on a device, and people of them. Dropping it waits for its frames.
pub struct Renderer(vulkan::Renderer);

impl Renderer {
    /// Uploads an avatar, and compiles what it is drawn with.
    ///
    /// # Errors
    /// When the avatar's arrays contradict each other, an option is out of range, or the device has
    /// too little memory or fails.
    pub fn new(gpu: &Gpu, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        vulkan::Renderer::new(&gpu.0, avatar, options.0).map(Self)
    }

    /// How far the avatar that it was made with reaches in any pose: frames it in a camera.
    pub fn bounds(&self) -> &AvatarBounds {
        self.0.bounds()
    }

    /// Submits a frame, and waits only when two frames are still under way. `camera` has the image's
    /// size.
    ///
    /// # Errors
    /// When the pose or the camera holds a number that can't be drawn, or the device fails.
    pub fn draw(&mut self, posed: &Posed, camera: &Camera) -> Result<()> {
        self.0.draw(posed, camera, None)
    }

    /// Holds another avatar from now on, of which people can be drawn. Waits for submitted frames.
    /// People of one avatar share its memory: add it once.
    ///
    /// # Errors
    /// When the avatar's arrays contradict each other, or the device has too little memory or fails.
    /// Then it is not held.
    pub fn add_avatar(&mut self, avatar: &Avatar) -> Result<AvatarId> {
        self.0.add_avatar(&vulkan::PreparedAvatar::new(avatar)?)
    }

    /// Gives an avatar's memory back, after waiting for submitted frames: no person of it can be
    /// drawn any more. False if it is not held.
    ///
    /// # Errors
    /// When the device fails.
    pub fn remove_avatar(&mut self, avatar: AvatarId) -> Result<bool> {
        self.0.remove_avatar(avatar)
    }

    /// Submits a frame of several people, sorted together, so that they may pass through each other.
    /// Keep everybody's place in `people` from frame to frame: what is cached and what has changed
    /// goes by it. [`Posed::placed`] says where somebody stands. Waits for submitted frames where
    /// buffers have to grow.
    ///
    /// # Errors
    /// Those of [`Renderer::draw`]; when there are more people than [`RendererOptions::people`], or
    /// an avatar was removed.
    pub fn draw_people(&mut self, people: &[Person], camera: &Camera) -> Result<()> {
        self.0.draw_scene(people, camera, None)
    }

    /// Waits for every submitted frame.
    ///
    /// # Errors
    /// When the device fails or hangs.
    pub fn finish(&mut self) -> Result<()> {
        self.0.finish()
    }

    /// Changes the image's size, px. On failure the old image stays.
    ///
    /// # Errors
    /// When the device draws no images of that size, has too little memory, or fails.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.0.resize(size)
    }

    /// Waits, and copies the last frame's image to the host.
    ///
    /// # Errors
    /// When no frame was drawn at this size, the device fails, or it has too little memory.
    pub fn read_image(&mut self) -> Result<FrameImage> {
        self.0.read_image()
    }

    /// The last finished frame: the time of each stage, and what was counted.
    pub fn report(&self) -> &FrameReport {
        self.0.report()
    }
}
