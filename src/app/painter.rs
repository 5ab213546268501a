//! Draws frames into a window: a pose, a camera and the overlay's triangles go in; what comes out is on the screen.

use super::{device, scene::Look};
use crate::{
    avatar::Avatar,
    frame::{Camera, Posed},
    measure::governor::Quality,
    vulkan::{
        Error, Gpu, GpuOptions, Renderer, RendererOptions, Result,
        commands::{FrameReport, SLOTS},
        error::During,
        picture::Copied,
        present::Present,
        renderer::Presentation,
        swapchain::{Acquired, Surface, Swapchain, Target},
        timing::Told,
        turn::Turn,
        watch::{Seen, Watch},
    },
};
use ash::vk;
use egui::{ClippedPrimitive, Pos2, Rect, TexturesDelta, epaint::Primitive};
use egui_ash_renderer::{Options, RenderMode, Renderer as Egui, RendererError, allocator::GpuAllocator};
use glam::Vec2;
use raw_window_handle::{HasDisplayHandle, HasWindowHandle};
use std::{mem::ManuallyDrop, sync::Arc};
use winit::window::Window;

/// The overlay of a frame, as egui hands it over.
#[derive(Default)]
pub struct Panel {
    pub triangles: Vec<ClippedPrimitive>,
    pub pixels_per_point: f32,
}

impl Panel {
    /// The same as it lies in the images of a window of `size` px.
    fn turned(&mut self, turn: Turn, size: [u32; 2]) {
        if turn == Turn::default() {
            return;
        }
        let size = Vec2::new(size[0] as f32, size[1] as f32) / self.pixels_per_point;
        let place = |point: Pos2| Pos2::from(turn.place(Vec2::new(point.x, point.y), size).to_array());
        for part in &mut self.triangles {
            part.clip_rect = Rect::from_two_pos(place(part.clip_rect.min), place(part.clip_rect.max));
            if let Primitive::Mesh(mesh) = &mut part.primitive {
                mesh.vertices.iter_mut().for_each(|vertex| vertex.pos = place(vertex.pos));
            }
        }
    }
}

/// Everything of the device that a window needs.
pub struct Painter {
    // In the order in which they have to go.
    egui: ManuallyDrop<Egui<GpuAllocator>>,
    textures: vk::CommandPool,
    swapchain: Option<Swapchain>,
    present: Present,
    surface: Option<Surface>,
    renderer: Renderer,
    /// What the whole quality is drawn with.
    drawing: RendererOptions,
    /// Looks at pictures, once one was to be looked at.
    watch: Option<Watch>,
    look: bool,
    /// Before when the next frame is not to be shown, nanoseconds of the system's monotonic clock.
    show: Option<u64>,
    gpu: Arc<Gpu>,
    target: Target,
    window: Arc<Window>,
    /// The window's size when the swapchain was made, px.
    fitted: [u32; 2],
    stale: bool,
}

impl Painter {
    /// Opens a device for a window: the one that `options` names, else the first that can show pictures in it.
    pub fn new(window: &Arc<Window>, avatar: &Avatar, options: &GpuOptions, drawing: RendererOptions) -> anyhow::Result<Self> {
        let (target, surface, gpu) = device::open(window, options)?;
        let present = Present::new(&gpu, surface.format())?;
        let renderer = Renderer::new(&gpu, avatar, drawing)?;
        present.set_picture(renderer.raster().image());
        let options = Options { in_flight_frames: SLOTS, ..Options::default() };
        let mode = RenderMode::RenderPass(present.render_pass);
        let egui = overlay(Egui::with_gpu_allocator(Arc::clone(&gpu.allocator), gpu.raw.clone(), mode, options))?;
        let info = vk::CommandPoolCreateInfo::default().queue_family_index(gpu.queue_family).flags(vk::CommandPoolCreateFlags::TRANSIENT);
        // SAFETY: `info` outlives the call.
        let textures = unsafe { gpu.raw.create_command_pool(&info, None) }.during("vkCreateCommandPool")?;
        gpu.name(textures, "panel's textures");
        Ok(Self {
            egui: ManuallyDrop::new(egui),
            textures,
            swapchain: None,
            present,
            surface: Some(surface),
            renderer,
            drawing,
            watch: None,
            look: false,
            show: None,
            gpu,
            target,
            window: window.clone(),
            fitted: [0; 2],
            stale: true,
        })
    }

    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// What it draws with now.
    pub fn options(&self) -> &RendererOptions {
        self.renderer.options()
    }

    /// Width and height of the whole picture, px.
    pub fn size(&self) -> [u32; 2] {
        self.renderer.raster().image().size
    }

    /// Draws at this quality from now on. Waits for submitted frames where it is another.
    pub fn set_quality(&mut self, quality: &Quality) -> Result<()> {
        self.renderer.adjust(quality.size(self.size()), quality.cutoff(&self.drawing), quality.detail(&self.drawing))
    }

    /// Has the next frame's picture looked at, if the last one was. [`Self::seen`] says what was seen some frames later.
    pub fn look(&mut self) {
        self.look = true;
    }

    /// The next frame is not to be shown before a time, where the display can be told: nanoseconds of the system's monotonic clock.
    pub fn show_at(&mut self, at: Option<u64>) {
        self.show = at;
    }

    /// What the display has told of its refreshes since the last frame. None where it never does.
    pub fn told(&self) -> Option<Told> {
        self.swapchain.as_ref()?.told()
    }

    /// To be called after every frame.
    pub fn seen(&mut self) -> Option<Seen> {
        self.watch.as_mut()?.step()
    }

    /// What the last finished frame took and drew.
    pub fn report(&self) -> &FrameReport {
        self.renderer.report()
    }

    /// Fits the pictures to a window of `wanted` px, and says their size. None while the window has no area: then there is nothing to draw.
    pub fn fit(&mut self, wanted: [u32; 2]) -> Result<Option<[u32; 2]>> {
        if !self.stale && wanted == self.fitted {
            return Ok(self.swapchain.as_ref().map(|swapchain| swapchain.size));
        }
        self.renderer.finish()?;
        let surface = match self.surface.take() {
            Some(surface) => surface,
            None => Surface::new(&self.gpu, self.target.clone())?,
        };
        let made = Swapchain::new(&self.gpu, &surface, self.present.render_pass, (wanted, self.swapchain.take()));
        self.surface = Some(surface);
        self.swapchain = made?;
        (self.fitted, self.stale) = (wanted, self.swapchain.is_none());
        let Some(size) = self.swapchain.as_ref().map(|swapchain| swapchain.size) else { return Ok(None) };
        if self.renderer.raster().image().size != size {
            self.renderer.resize(size)?;
            self.watch = None;
            self.present.set_picture(self.renderer.raster().image());
        }
        Ok(Some(size))
    }

    /// The window is going away; everything that is not its own stays. The next [`Self::resume`] and fit bring another.
    pub fn suspend(&mut self) -> Result<()> {
        self.gpu.save_pipelines();
        self.lose_surface()
    }

    /// There is a window again. False where its pictures are of another format: then all has to be made anew.
    pub fn resume(&mut self, window: &Arc<Window>) -> anyhow::Result<bool> {
        let given = Target::new(window.display_handle()?, window.window_handle()?);
        let (before, surface) = (self.present.format, Surface::new(&self.gpu, given.clone())?);
        self.target = given;
        let fits = surface.format() == before;
        self.surface = Some(surface);
        Ok(fits)
    }

    /// The surface is gone: the next fit makes another.
    pub fn lose_surface(&mut self) -> Result<()> {
        self.renderer.finish()?;
        self.stale = true;
        self.swapchain = None;
        self.surface = None;
        Ok(())
    }

    /// Takes in what changed of the overlay's textures. It waits, but only few frames bring new glyphs.
    pub fn set_textures(&mut self, mut delta: TexturesDelta) -> Result<()> {
        if delta.is_empty() {
            return Ok(());
        }
        self.renderer.finish()?;
        for (id, images) in delta.set.drain() {
            for image in images {
                overlay(self.egui.set_texture(self.gpu.queue, self.textures, id, &image))?;
            }
        }
        overlay(delta.free.drain().try_for_each(|id| self.egui.free_texture(id)))
    }

    /// Draws a frame and shows it; the panel is used up. False when the window could not take it: it has changed, or has no image to give yet.
    pub fn paint(&mut self, posed: &Posed, look: &Look, panel: &mut Panel) -> Result<bool> {
        let Some(swapchain) = &mut self.swapchain else { return Ok(false) };
        let (image, acquired) = match swapchain.acquire()? {
            Acquired::Image(image, acquired) => (image, acquired),
            Acquired::NotYet => return Ok(false),
            Acquired::Outdated => {
                self.stale = true;
                return Ok(false);
            }
        };
        let (framebuffer, finished) = swapchain.image(image);
        let (size, turn) = (swapchain.size, swapchain.turn);
        let [width, height] = turn.extent(size);
        panel.turned(turn, size);
        let (picture, taken) = (self.renderer.raster().drawn(), self.renderer.raster().image().raw);
        let look_at_it = std::mem::take(&mut self.look);
        if look_at_it && self.watch.is_none() {
            self.watch = Some(Watch::new(&self.gpu, self.renderer.raster())?);
        }
        let mut watch = self.watch.as_mut().filter(|watch| look_at_it && watch.is_idle());
        let mut drawn = Ok(());
        let mut record = |commands| {
            self.present.record(commands, (framebuffer, size, turn), (picture, look.background), || {
                drawn = self.egui.cmd_draw(commands, vk::Extent2D { width, height }, panel.pixels_per_point, &panel.triangles);
            });
            watch.take().into_iter().for_each(|watch| watch.record(commands, taken, picture));
        };
        self.renderer.draw(
            posed,
            &look.camera.stretched(picture),
            Some(Presentation { semaphores: Some((acquired, finished)), record: &mut record }),
        )?;
        self.window.pre_present_notify();
        self.stale = !swapchain.present(image, self.show.take())?;
        overlay(drawn).map(|()| true)
    }

    /// A frame at the whole quality that is not shown: what it makes of a pose, as a camera sees it.
    pub fn still(&mut self, posed: &Posed, camera: &Camera) -> Result<Copied> {
        self.set_quality(&Quality::FULL)?;
        self.renderer.draw(posed, camera, None)?;
        self.renderer.copy()
    }

    /// Copies the picture of the last frame, without overlay and background. It takes no longer than a frame.
    pub fn copy(&mut self) -> Result<Copied> {
        self.renderer.copy()
    }
}

impl Drop for Painter {
    fn drop(&mut self) {
        if let Err(error) = self.renderer.finish() {
            tracing::debug!("the last frames did not finish: {error}");
        }
        if self.gpu.hangs() {
            return;
        }
        // SAFETY: dropped once, here; no submitted frame uses the overlay's objects, or the device is lost.
        unsafe {
            ManuallyDrop::drop(&mut self.egui);
            self.gpu.raw.destroy_command_pool(self.textures, None);
        }
    }
}

/// The overlay's errors as the renderer's own.
fn overlay<T>(result: std::result::Result<T, RendererError>) -> Result<T> {
    let call = "drawing the overlay";
    match result {
        Ok(value) => Ok(value),
        Err(RendererError::Vulkan(result)) => Err(result).during(call),
        Err(RendererError::GpuAllocator(source)) => Err(Error::Allocation { what: "the overlay".into(), source }),
        Err(other) => {
            tracing::error!("{other}");
            Err(Error::Call { call, result: vk::Result::ERROR_UNKNOWN })
        }
    }
}
