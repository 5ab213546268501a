//! Draws frames into a window: the avatar, the background and the panel.

use crate::{
    device::{self, WindowDevice},
    scene::{BehindImage, FrameContent},
};
use ash::vk;
use effigy_core::{
    avatar::Avatar,
    frame::AvatarId,
    scene::{Camera, FrameImage, Posed},
};
use effigy_render::vulkan::{
    CommandPool, Copied, During, Error, FRAMES_IN_FLIGHT, FrameReport, FrameValidator, Gpu,
    GpuOptions, PixelCounts, PreTransform, PreparedAvatar, Present, PresentFeedback, Presentation,
    PresentedImage, Recording, Renderer, RendererOptions, Result,
    swapchain::{Acquired, NativeWindow, Surface, Swapchain},
};
use effigy_runtime::governor::FrameQuality;
use egui::{ClippedPrimitive, Pos2, Rect, TexturesDelta, epaint::Primitive};
use egui_ash_renderer::{
    Options, RenderMode, Renderer as Egui, RendererError, allocator::GpuAllocator,
};
use glam::Vec2;
use raw_window_handle::{HasDisplayHandle, HasWindowHandle};
use std::{mem::ManuallyDrop, panic::resume_unwind, sync::Arc};
use winit::window::Window;

/// The triangles of the panel, from egui.
#[derive(Default)]
pub struct PanelMesh {
    /// Meshes with their clip rectangles, points.
    pub primitives: Vec<ClippedPrimitive>,
    /// Px a point.
    pub pixels_per_point: f32,
}

impl PanelMesh {
    /// A rectangle around all that it draws, px of an image of that size. None if it draws nothing.
    fn area(&self, size: [u32; 2]) -> Option<vk::Rect2D> {
        let mut area = Rect::NOTHING;
        for part in &self.primitives {
            if let Primitive::Mesh(mesh) = &part.primitive {
                let drawn = mesh.calc_bounds().intersect(part.clip_rect);
                if drawn.is_positive() {
                    area |= drawn;
                }
            }
        }
        let pixels = |point: Pos2, round: fn(f32) -> f32| {
            let [x, y] = [point.x, point.y].map(|side| round(side * self.pixels_per_point));
            [x.clamp(0.0, size[0] as f32), y.clamp(0.0, size[1] as f32)]
        };
        let [min_x, min_y] = pixels(area.min, f32::floor);
        let [max_x, max_y] = pixels(area.max, f32::ceil);
        (min_x < max_x && min_y < max_y).then_some(vk::Rect2D {
            offset: vk::Offset2D {
                x: min_x as i32,
                y: min_y as i32,
            },
            extent: vk::Extent2D {
                width: (max_x - min_x) as u32,
                height: (max_y - min_y) as u32,
            },
        })
    }

    /// Moves the mesh to where it belongs in the swapchain's images, which are rotated against a
    /// window of `size` px.
    fn pre_rotate(&mut self, pre_transform: PreTransform, size: [u32; 2]) {
        if pre_transform == PreTransform::default() {
            return;
        }
        let size = Vec2::new(size[0] as f32, size[1] as f32) / self.pixels_per_point;
        let rotate = |point: Pos2| {
            Pos2::from(
                pre_transform
                    .place(Vec2::new(point.x, point.y), size)
                    .to_array(),
            )
        };
        for part in &mut self.primitives {
            part.clip_rect =
                Rect::from_two_pos(rotate(part.clip_rect.min), rotate(part.clip_rect.max));
            if let Primitive::Mesh(mesh) = &mut part.primitive {
                for vertex in &mut mesh.vertices {
                    vertex.pos = rotate(vertex.pos);
                }
            }
        }
    }
}

/// A device with a renderer for one avatar and a swapchain for one window.
pub struct WindowPainter {
    // In the order in which they have to be dropped.
    egui: ManuallyDrop<Egui<GpuAllocator>>,
    textures: CommandPool,
    swapchain: Option<Swapchain>,
    present: Present,
    /// Put behind frames that have no colour of their own.
    picture: Option<BehindImage>,
    surface: Option<Surface>,
    renderer: Renderer,
    /// How to draw at full quality.
    full_quality: RendererOptions,
    /// What the renderer draws with, and why.
    drawing: String,
    /// Created with the first frame to validate.
    validator: Option<FrameValidator>,
    /// The next frame is to be validated.
    validation_requested: bool,
    /// The next frame is to be copied.
    copy_requested: bool,
    /// The earliest time to show the next frame, nanoseconds of the system's monotonic clock.
    show_at: Option<u64>,
    gpu: Arc<Gpu>,
    target: NativeWindow,
    window: Arc<Window>,
    /// The window's size when the swapchain was created, px.
    fitted: [u32; 2],
    /// The swapchain no longer fits the surface.
    stale: bool,
}

impl WindowPainter {
    /// Opens a device for a window: the one that `options` names. If it names none, the first that
    /// can present to the window.
    pub fn new(
        window: &Arc<Window>,
        avatar: &Avatar,
        options: &GpuOptions,
        full_quality: RendererOptions,
        picture: Option<BehindImage>,
    ) -> anyhow::Result<Self> {
        // Most of a start is the driver's: the avatar is packed meanwhile.
        let (device, prepared) = std::thread::scope(|scope| {
            let prepared = scope.spawn(|| PreparedAvatar::new(avatar));
            let device = device::open(window, options);
            let prepared = prepared.join().unwrap_or_else(|panic| resume_unwind(panic));
            (device, prepared)
        });
        let WindowDevice {
            target,
            surface,
            gpu,
        } = device?;
        let mut present = Present::new(&gpu, surface.format())?;
        let renderer = Renderer::from_prepared(&gpu, &prepared?, full_quality)?;
        let drawing = drawing(&renderer);
        // SAFETY: nothing uses it yet. Every frame leaves the image in this state, and `fit` sets
        // another after a resize; the renderer goes after every frame is done.
        unsafe { present.connect(renderer.raster()) }?;
        let options = Options {
            in_flight_frames: FRAMES_IN_FLIGHT,
            ..Options::default()
        };
        let mode = RenderMode::RenderPass(present.render_pass().raw());
        // SAFETY: the panel is dropped before the device, which it keeps beside it.
        let allocator = unsafe { gpu.allocator() };
        let egui = panel_error(Egui::with_gpu_allocator(
            allocator,
            gpu.raw.clone(),
            mode,
            options,
        ))?;
        let textures = gpu.command_pool("panel's textures")?;
        Ok(Self {
            egui: ManuallyDrop::new(egui),
            textures,
            swapchain: None,
            present,
            picture,
            surface: Some(surface),
            renderer,
            full_quality,
            drawing,
            validator: None,
            validation_requested: false,
            copy_requested: false,
            show_at: None,
            gpu,
            target,
            window: window.clone(),
            fitted: [0; 2],
            stale: true,
        })
    }

    /// Draws another avatar from the next frame on, at full quality. Waits for submitted frames; on
    /// an error the last avatar stays. One as large as the last takes its place without new
    /// kernels.
    ///
    /// # Errors
    /// Those of [`Renderer::from_prepared`], and when a check of the avatar finds a fault.
    pub fn replace_avatar(&mut self, avatar: &Avatar) -> Result<()> {
        let prepared = PreparedAvatar::new(avatar)?;
        // Before what frames under way use goes.
        self.renderer.finish()?;
        if self.renderer.replace_avatar(AvatarId::FIRST, &prepared)? {
            self.validator = None;
            return self.set_quality(&FrameQuality::FULL);
        }
        let options = self.full_quality();
        let renderer = Renderer::from_prepared(&self.gpu, &prepared, options)?;
        self.validator = None;
        // SAFETY: every frame is done. Every frame leaves the image in this state, and the next
        // resize sets another.
        unsafe {
            self.present.connect(renderer.raster())?;
            if let Some(swapchain) = &mut self.swapchain {
                swapchain.connect(&self.present, renderer.raster());
            }
        }
        self.renderer = renderer;
        self.drawing = drawing(&self.renderer);
        Ok(())
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The renderer's options at the current quality.
    pub fn options(&self) -> &RendererOptions {
        self.renderer.options()
    }

    /// The options of frames at full quality.
    pub fn full_quality(&self) -> RendererOptions {
        RendererOptions {
            size: self.size(),
            ..self.full_quality
        }
    }

    /// What frames are drawn with, and why.
    pub fn drawing(&self) -> &str {
        &self.drawing
    }

    /// The device was lost or hangs: has the next painter draw in the safest way, if this one draws
    /// in another. Returns whether it does.
    pub fn strike_off(&self, failure: &Error) -> bool {
        self.renderer.strike_off(&failure.to_string())
    }

    /// Width and height of a frame at full quality, px.
    pub fn size(&self) -> [u32; 2] {
        self.renderer.raster().image().size()
    }

    /// Draws at this quality from now on. A change waits for submitted frames.
    pub fn set_quality(&mut self, quality: &FrameQuality) -> Result<()> {
        self.renderer.adjust(
            quality.size(self.size()),
            quality.detail(self.full_quality.detail),
        )
    }

    /// Validates the next frame, unless the validation of an earlier one is still under way. The
    /// result comes some frames later from [`Self::poll_validation`].
    pub fn request_validation(&mut self) {
        self.validation_requested = true;
    }

    /// Keeps the next frame's image for [`Self::copy`].
    pub fn request_copy(&mut self) {
        self.copy_requested = true;
    }

    /// Returns the result of a validation that is done. Call it after every frame.
    pub fn poll_validation(&mut self) -> Option<PixelCounts> {
        self.validator.as_mut()?.step()
    }

    /// Sets the earliest time to show the next frame, if the display supports this: nanoseconds of
    /// the system's monotonic clock.
    pub fn show_at(&mut self, at: Option<u64>) {
        self.show_at = at;
    }

    /// The display's feedback about its refreshes since the last frame. None if it never gives
    /// any.
    pub fn present_feedback(&self) -> Option<PresentFeedback> {
        self.swapchain.as_ref()?.feedback()
    }

    /// Durations and counts of the last finished frame.
    pub fn report(&self) -> &FrameReport {
        self.renderer.report()
    }

    /// Fits the swapchain and the renderer to a window of `wanted` px. Returns the size of its
    /// frames, px. None while the window has no area.
    pub fn fit(&mut self, wanted: [u32; 2]) -> Result<Option<[u32; 2]>> {
        if !self.stale && wanted == self.fitted {
            return Ok(self.swapchain.as_ref().map(Swapchain::size));
        }
        self.renderer.finish()?;
        let surface = match self.surface.take() {
            Some(surface) => surface,
            None => Surface::new(&self.gpu, self.target.clone())?,
        };
        let made = Swapchain::new(
            &self.gpu,
            &surface,
            self.present.render_pass(),
            wanted,
            self.swapchain.take(),
        );
        self.surface = Some(surface);
        self.swapchain = made?;
        self.fitted = wanted;
        self.stale = self.swapchain.is_none();
        let Some(size) = self.swapchain.as_ref().map(Swapchain::size) else {
            return Ok(None);
        };
        if self.renderer.raster().image().size() != size {
            self.renderer.resize(size)?;
            self.validator = None;
            // SAFETY: every frame is done. Every frame leaves the image in this state, and the next
            // resize sets another.
            unsafe { self.present.set_image(self.renderer.raster().image()) };
        }
        if let Some(swapchain) = &mut self.swapchain {
            // SAFETY: every frame is done, and the next resize comes here too.
            unsafe { swapchain.connect(&self.present, self.renderer.raster()) };
        }
        if let Some(picture) = &self.picture
            && self.present.picture_size() != size
        {
            let image = picture(&FrameImage::empty(size));
            // SAFETY: every frame is done.
            unsafe { self.present.set_picture(size, image.as_raw()) }?;
        }
        Ok(Some(size))
    }

    /// Puts a frame's background behind an image: a colour, or else the picture.
    pub fn behind(&self, background: Option<[f32; 3]>) -> BehindImage {
        match (background, &self.picture) {
            (None, Some(picture)) => picture.clone(),
            (color, _) => Arc::new(move |image| image.over(color.unwrap_or_default())),
        }
    }

    /// The system takes the window away. The device and the avatar stay, for [`Self::resume`].
    pub fn suspend(&mut self) -> Result<()> {
        self.gpu.save_pipelines();
        self.drop_surface()
    }

    /// There is a window again. Returns false if its images have another format: then a new painter
    /// is needed.
    pub fn resume(&mut self, window: &Arc<Window>) -> anyhow::Result<bool> {
        // SAFETY: the window outlives the painter, or is taken from it in `suspend`.
        let target =
            unsafe { NativeWindow::new(window.display_handle()?, window.window_handle()?) };
        let surface = Surface::new(&self.gpu, target.clone())?;
        self.target = target;
        let fits = surface.format() == self.present.format;
        self.surface = Some(surface);
        Ok(fits)
    }

    /// Drops the surface. The next [`Self::fit`] creates another one.
    pub fn drop_surface(&mut self) -> Result<()> {
        self.renderer.finish()?;
        self.stale = true;
        self.swapchain = None;
        self.surface = None;
        Ok(())
    }

    /// Updates the panel's textures. It waits for submitted frames, but few frames bring new
    /// glyphs.
    pub fn set_textures(&mut self, mut delta: TexturesDelta) -> Result<()> {
        if delta.is_empty() {
            return Ok(());
        }
        self.renderer.finish()?;
        for (id, images) in delta.set.drain() {
            for image in images {
                // SAFETY: the window's frames and captures are submitted by this thread; the
                // texture is uploaded when the call returns.
                let queue = unsafe { self.gpu.queue() };
                let set = self
                    .egui
                    .set_texture(queue, self.textures.raw(), id, &image);
                panel_error(set)?;
            }
        }
        for id in delta.free.drain() {
            panel_error(self.egui.free_texture(id))?;
        }
        Ok(())
    }

    /// Draws a frame and presents it. `panel` is drawn over it, and can't be used again. Returns
    /// false if the window could not take the frame: it has changed, or has no free image yet.
    pub fn paint(
        &mut self,
        posed: &Posed,
        content: &FrameContent,
        panel: &mut PanelMesh,
    ) -> Result<bool> {
        let Some(swapchain) = &mut self.swapchain else {
            return Ok(false);
        };
        let image = match swapchain.acquire()? {
            Acquired::Image(image) => image,
            Acquired::NotYet => return Ok(false),
            Acquired::Outdated => {
                self.stale = true;
                return Ok(false);
            }
        };
        let canvas = swapchain.canvas(&image);
        let [width, height] = canvas.pre_transform.extent(canvas.size);
        panel.pre_rotate(canvas.pre_transform, canvas.size);
        let drawn_size = self.renderer.raster().drawn();
        let image_drawn = self.renderer.raster().image().raw();
        let validate = std::mem::take(&mut self.validation_requested);
        if validate && self.validator.is_none() {
            self.validator = Some(FrameValidator::new(&self.gpu, self.renderer.raster())?);
        }
        let mut validator = self
            .validator
            .as_mut()
            .filter(|validator| validate && validator.is_idle());
        let shown = PresentedImage {
            drawn: drawn_size,
            background: content.background,
        };
        // What is copied behind the frame has to be stored.
        let is_copied = std::mem::take(&mut self.copy_requested) || validate;
        let screen = if is_copied {
            None
        } else {
            self.present.one_pass(canvas, content.background)
        };
        let panel_area = panel.area([width, height]);
        let mut panel_drawn = Ok(());
        let mut record = |commands: Recording, is_shown: bool| {
            let draw_panel = || {
                panel_drawn = self.egui.cmd_draw(
                    commands.raw(),
                    vk::Extent2D { width, height },
                    panel.pixels_per_point,
                    &panel.primitives,
                );
            };
            if !is_shown {
                self.present.record(commands, canvas, shown, draw_panel);
            } else if let Some(area) = panel_area {
                self.present.record_over(commands, canvas, area, draw_panel);
            }
            if let Some(validator) = validator.take() {
                // SAFETY: it follows the frame, whose image lives until all frames are done.
                unsafe { validator.record(commands, image_drawn, drawn_size) };
            }
        };
        // SAFETY: the swapchain, the panel and the validator go only after every frame is done, and
        // the swapchain has just given the semaphores.
        let presentation = unsafe { Presentation::new(Some(image.semaphores), &mut record) };
        let presentation = presentation.in_one_pass(screen);
        let camera = content.camera.stretched(drawn_size);
        self.renderer.draw(posed, &camera, Some(presentation))?;
        self.window.pre_present_notify();
        // SAFETY: the frame draws to the image, and was submitted with its semaphores.
        let fits = unsafe { swapchain.present(image, self.show_at.take()) }?;
        self.stale = !fits;
        panel_error(panel_drawn)?;
        Ok(true)
    }

    /// Draws a frame at full quality without presenting it, and copies it.
    pub fn draw_offscreen(&mut self, posed: &Posed, camera: &Camera) -> Result<Copied> {
        self.set_quality(&FrameQuality::FULL)?;
        self.renderer.draw(posed, camera, None)?;
        self.renderer.copy()
    }

    /// Copies the last frame's image, without panel and background, after [`Self::request_copy`]
    /// for that frame. It takes no longer than a frame.
    pub fn copy(&mut self) -> Result<Copied> {
        self.renderer.copy()
    }
}

impl Drop for WindowPainter {
    fn drop(&mut self) {
        if let Err(error) = self.renderer.finish() {
            tracing::debug!("the last frames did not finish: {error}");
        }
        if self.gpu.hangs() {
            return;
        }
        // SAFETY: dropped once, here; no submitted frame uses the panel's objects, or the device is
        // lost.
        unsafe { ManuallyDrop::drop(&mut self.egui) };
    }
}

/// What a renderer draws with, and why.
fn drawing(renderer: &Renderer) -> String {
    let name = renderer.raster().method().name();
    match renderer.choice() {
        Some(choice) => format!("{name}: {}", choice.reason()),
        None => format!("{name}, as the options say"),
    }
}

/// Turns an error of the panel's renderer into one of ours.
fn panel_error<T>(result: std::result::Result<T, RendererError>) -> Result<T> {
    match result {
        Ok(value) => Ok(value),
        Err(RendererError::Vulkan(result)) => Err(result).during("drawing the panel"),
        Err(RendererError::GpuAllocator(source)) => Err(Error::Allocation {
            what: "the panel".into(),
            reason: source.to_string(),
        }),
        Err(other) => Err(Error::Overlay(other.to_string())),
    }
}
