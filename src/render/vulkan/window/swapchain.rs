//! A window's surface and the images that it shows in turn.

pub use super::target::NativeWindow;
use super::{
    pre_transform::PreTransform,
    present::{Present, PresentTarget},
    timing::{PresentFeedback, Timing},
};
use crate::vulkan::{
    commands::{FRAMES_IN_FLIGHT, Semaphores},
    device::{
        error::{During, Error, Result},
        gpu::Gpu,
        handle::{Framebuffer, ImageView, RenderPass, Semaphore},
        logical::Device,
    },
    memory::COLOR,
    raster::Raster,
};
use ash::{khr, vk};
use std::{rc::Rc, sync::Arc, time::Duration};

/// How long to wait for an image before the program looks after its other work.
const ACQUIRE: Duration = Duration::from_secs(1);
/// How often to wait that long before the device counts as hung.
const TRIES: u32 = 30;

/// A window's surface. The window must outlive it and its swapchains.
pub struct Surface {
    handle: Rc<SurfaceHandle>,
    format: vk::SurfaceFormatKHR,
}

/// A surface, destroyed when neither it nor a swapchain of it is used any more.
struct SurfaceHandle {
    raw: vk::SurfaceKHR,
    loader: khr::surface::Instance,
    _target: NativeWindow,
    /// Keeps the instance.
    _device: Arc<Device>,
}

impl Drop for SurfaceHandle {
    fn drop(&mut self) {
        // SAFETY: its swapchains hold a reference to it, so none is left.
        unsafe { self.loader.destroy_surface(self.raw, None) };
    }
}

impl Surface {
    /// Fails where the device can't show images in this window.
    pub fn new(gpu: &Arc<Gpu>, target: NativeWindow) -> Result<Self> {
        let loader = khr::surface::Instance::new(&gpu.instance.entry, &gpu.instance.raw);
        let entry = &gpu.instance.entry;
        let instance = &gpu.instance.raw;
        // SAFETY: who made the target keeps the window alive; the instance has the extensions that
        // `extensions` named, or the call fails.
        let raw = unsafe {
            ash_window::create_surface(entry, instance, target.display, target.window, None)
        };
        let raw = raw.during("vkCreateSurface")?;
        let handle = SurfaceHandle {
            raw,
            loader,
            _target: target,
            _device: gpu.device.clone(),
        };
        Ok(Self {
            format: choose_format(gpu, &handle)?,
            handle: Rc::new(handle),
        })
    }

    /// Format of its images: 8 bits a channel, without sRGB conversion.
    pub fn format(&self) -> vk::Format {
        self.format.format
    }
}

/// Result of [`Swapchain::acquire`].
pub enum Acquired {
    /// An image to draw to.
    Image(AcquiredImage),
    /// The window has changed: recreate the swapchain.
    Outdated,
    /// The window has none to give yet, for instance since it is hidden.
    NotYet,
}

/// An image of a window that may be drawn to.
pub struct AcquiredImage {
    index: usize,
    /// The semaphore to wait for before it is drawn to, and the one to signal when it is drawn.
    pub semaphores: Semaphores,
}

/// The images of a window of one size.
pub struct Swapchain {
    gpu: Arc<Gpu>,
    images: Vec<WindowImage>,
    /// Signalled when an image may be drawn to. One more than frames in flight: the next is taken
    /// before the oldest frame is waited for.
    acquired: Vec<Semaphore>,
    next: usize,
    /// Failed acquires in a row.
    failed_acquires: u32,
    /// When its images are shown, where the display tells.
    timing: Option<Timing>,
    /// Width and height of the window as it is seen, px.
    size: [u32; 2],
    /// How it lies in the images.
    pre_transform: PreTransform,
    handle: SwapchainHandle,
}

/// Objects of one image of a window.
struct WindowImage {
    framebuffer: Framebuffer,
    /// Of a raster that is connected.
    one_pass: Option<Framebuffer>,
    view: ImageView,
    /// Signalled when the image has been drawn; free again when it is acquired again.
    finished: Semaphore,
}

struct SwapchainHandle {
    raw: vk::SwapchainKHR,
    loader: khr::swapchain::Device,
    device: Arc<Device>,
    _surface: Rc<SurfaceHandle>,
}

impl Drop for SwapchainHandle {
    fn drop(&mut self) {
        if !self.device.hangs() {
            // SAFETY: no submitted frame uses its images: [`Swapchain`] has waited for the queue.
            unsafe { self.loader.destroy_swapchain(self.raw, None) };
        }
    }
}

impl Swapchain {
    /// `wanted` is the window's size, px, where the surface does not say itself. None while the
    /// window has no area. `old`: the swapchain that it takes the place of.
    pub fn new(
        gpu: &Arc<Gpu>,
        surface: &Surface,
        render_pass: &RenderPass,
        wanted: [u32; 2],
        old: Option<Self>,
    ) -> Result<Option<Self>> {
        let Some(loader) = gpu.swapchain.clone() else {
            return Ok(None);
        };
        let physical = gpu.probe.physical;
        // SAFETY: device and surface are alive and of the same instance.
        let capabilities = unsafe {
            surface
                .handle
                .loader
                .get_physical_device_surface_capabilities(physical, surface.handle.raw)
        };
        let capabilities = capabilities.during("vkGetPhysicalDeviceSurfaceCapabilitiesKHR")?;
        let size = size(&capabilities, wanted);
        if size.contains(&0) || wanted.contains(&0) {
            return Ok(None);
        }
        let transform = capabilities.current_transform;
        let pre_transform = PreTransform::asked(transform)
            .filter(|_| capabilities.supported_transforms.contains(transform));
        let extent = pre_transform.unwrap_or_default().extent(size);
        let info = info(surface, &capabilities, extent, pre_transform.is_some()).old_swapchain(
            old.as_ref()
                .map_or(vk::SwapchainKHR::null(), |old| old.handle.raw),
        );
        // SAFETY: `info` and all it points to outlive the call; the swapchain is new.
        let handle = unsafe {
            let raw = loader.create_swapchain(&info, None);
            let raw = raw.during("vkCreateSwapchainKHR")?;
            gpu.name(raw, "window");
            SwapchainHandle {
                raw,
                loader,
                device: gpu.device.clone(),
                _surface: surface.handle.clone(),
            }
        };
        drop(old);
        let device = &gpu.device;
        let acquired = (0..=FRAMES_IN_FLIGHT)
            .map(|_| Semaphore::unsignalled_binary(device, "image acquired"))
            .collect::<Result<_>>()?;
        Ok(Some(Self {
            gpu: gpu.clone(),
            images: images(&handle, surface.format.format, render_pass, extent)?,
            acquired,
            next: 0,
            failed_acquires: 0,
            timing: Timing::new(gpu),
            size,
            pre_transform: pre_transform.unwrap_or_default(),
            handle,
        }))
    }

    /// Width and height of the window as it is seen, px.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Asks for the next image to draw to.
    pub fn acquire(&mut self) -> Result<Acquired> {
        let semaphore = self.acquired[self.next].raw();
        // SAFETY: the semaphore is free: the frame that last used it is more frames back than can
        // be in flight.
        let result = unsafe {
            self.handle.loader.acquire_next_image(
                self.handle.raw,
                ACQUIRE.as_nanos() as u64,
                semaphore,
                vk::Fence::null(),
            )
        };
        match result {
            Ok((index, _)) => {
                self.next = (self.next + 1) % self.acquired.len();
                self.failed_acquires = 0;
                let index = index as usize;
                Ok(Acquired::Image(AcquiredImage {
                    index,
                    semaphores: Semaphores {
                        wait: semaphore,
                        signal: self.images[index].finished.raw(),
                    },
                }))
            }
            Err(vk::Result::ERROR_OUT_OF_DATE_KHR) => Ok(Acquired::Outdated),
            Err(vk::Result::TIMEOUT | vk::Result::NOT_READY)
                if self.failed_acquires + 1 < TRIES =>
            {
                self.failed_acquires += 1;
                Ok(Acquired::NotYet)
            }
            Err(vk::Result::TIMEOUT | vk::Result::NOT_READY) => Err(Error::Timeout {
                what: "getting an image of the window",
                seconds: ACQUIRE.as_secs() * u64::from(TRIES),
            }),
            Err(error) => Err(error).during("vkAcquireNextImageKHR"),
        }
    }

    /// Has frames of the raster that is connected go to the window in the render pass that draws
    /// them, where they can. To be called for each new swapchain, and each new image of a raster.
    ///
    /// # Safety
    /// No submitted work may use the swapchain's targets. The raster's image must outlive the work
    /// that will.
    pub unsafe fn connect(&mut self, present: &Present, raster: &Raster) {
        for image in &mut self.images {
            let view = image.view.raw();
            image.one_pass =
                present.one_pass_framebuffer(raster, view, self.size, self.pre_transform);
        }
    }

    /// The target for an image.
    pub fn canvas(&self, image: &AcquiredImage) -> PresentTarget<'_> {
        PresentTarget {
            framebuffer: &self.images[image.index].framebuffer,
            one_pass: self.images[image.index].one_pass.as_ref(),
            size: self.size,
            pre_transform: self.pre_transform,
        }
    }

    /// When the display showed images, and its refresh period. None where it never reports them.
    pub fn feedback(&self) -> Option<PresentFeedback> {
        let timing = self.timing.as_ref()?;
        // SAFETY: the swapchain is alive and of the device that `timing` was made for.
        Some(unsafe { timing.feedback(self.handle.raw) })
    }

    /// Shows an image once it is drawn. `at`: not before that time, nanoseconds of the system's
    /// monotonic clock, where the display supports it. True where the swapchain still fits the
    /// window.
    ///
    /// # Safety
    /// The image must be of this swapchain, and work that was submitted must draw to its canvas,
    /// and use both of its semaphores.
    pub unsafe fn present(&mut self, image: AcquiredImage, at: Option<u64>) -> Result<bool> {
        let wait = [image.semaphores.signal];
        let swapchains = [self.handle.raw];
        let indices = [image.index as u32];
        let mut info = vk::PresentInfoKHR::default()
            .wait_semaphores(&wait)
            .swapchains(&swapchains)
            .image_indices(&indices);
        let present_time = self.timing.as_mut().map(|timing| [timing.present_time(at)]);
        let mut times = vk::PresentTimesInfoGOOGLE::default();
        if let Some(present_time) = &present_time {
            times = times.times(present_time);
            info = info.push_next(&mut times);
        }
        // SAFETY: the image is acquired, and submitted work signals its semaphore, as the caller
        // promises; both are alive.
        match unsafe { self.gpu.present(&self.handle.loader, &info) } {
            Ok(suboptimal) => Ok(!suboptimal),
            Err(vk::Result::ERROR_OUT_OF_DATE_KHR) => Ok(false),
            Err(error) => Err(error).during("vkQueuePresentKHR"),
        }
    }
}

impl Drop for Swapchain {
    fn drop(&mut self) {
        // What is left in the queue is at max_image_count the wait of the last presentation for a
        // frame that is done.
        if matches!(self.gpu.idle(), Err(Error::Timeout { .. })) {
            tracing::warn!(
                "the device does not finish its last frame; what belongs to the window is not freed"
            );
        }
    }
}

/// The size of a surface, or what is nearest to `wanted` where it has none of its own, px.
fn size(capabilities: &vk::SurfaceCapabilitiesKHR, wanted: [u32; 2]) -> [u32; 2] {
    let current = capabilities.current_extent;
    if current.width != u32::MAX {
        return [current.width, current.height];
    }
    let min = capabilities.min_image_extent;
    let max = capabilities.max_image_extent;
    [
        wanted[0].clamp(min.width, max.width.max(min.width)),
        wanted[1].clamp(min.height, max.height.max(min.height)),
    ]
}

/// Makes what goes with each image of a swapchain.
fn images(
    swapchain: &SwapchainHandle,
    format: vk::Format,
    render_pass: &RenderPass,
    size: [u32; 2],
) -> Result<Vec<WindowImage>> {
    let device = &swapchain.device;
    // SAFETY: the swapchain is alive.
    let raw = unsafe { swapchain.loader.get_swapchain_images(swapchain.raw) };
    let mut images = Vec::new();
    for image in raw.during("vkGetSwapchainImagesKHR")? {
        // SAFETY: the image is alive and of this device.
        unsafe { device.name(image, "window") };
        let view = ImageView::with_range(device, image, format, COLOR, "window")?;
        images.push(WindowImage {
            framebuffer: Framebuffer::around(device, render_pass, &[view.raw()], size, "window")?,
            one_pass: None,
            view,
            finished: Semaphore::unsignalled_binary(device, "frame drawn")?,
        });
    }
    Ok(images)
}

/// Eight bits a channel, of which numbers are shown as they are.
fn choose_format(gpu: &Gpu, surface: &SurfaceHandle) -> Result<vk::SurfaceFormatKHR> {
    let physical = gpu.probe.physical;
    // SAFETY: device and surface are alive and of the same instance.
    let supported = unsafe {
        surface
            .loader
            .get_physical_device_surface_support(physical, gpu.queue_family, surface.raw)
    };
    if gpu.swapchain.is_none() || !supported.during("vkGetPhysicalDeviceSurfaceSupportKHR")? {
        return Err(Error::NoWindow {
            device: gpu.probe.name.clone(),
        });
    }
    // SAFETY: device and surface are alive and of the same instance.
    let formats = unsafe {
        surface
            .loader
            .get_physical_device_surface_formats(physical, surface.raw)
    };
    let formats = formats.during("vkGetPhysicalDeviceSurfaceFormatsKHR")?;
    let plain = [
        vk::Format::B8G8R8A8_UNORM,
        vk::Format::R8G8B8A8_UNORM,
        vk::Format::A8B8G8R8_UNORM_PACK32,
    ];
    let found = plain.iter().find_map(|&wanted| {
        formats.iter().find(|found| {
            found.format == wanted && found.color_space == vk::ColorSpaceKHR::SRGB_NONLINEAR
        })
    });
    found.copied().ok_or_else(|| Error::Unsupported {
        device: gpu.probe.name.clone(),
        missing: "its windows have no 8-bit format without conversion".into(),
    })
}

/// First in, first out: no tearing, at the display's rate, and on every device. `turned`: images
/// are drawn the way the display is mounted.
fn info<'a>(
    surface: &Surface,
    capabilities: &vk::SurfaceCapabilitiesKHR,
    extent: [u32; 2],
    turned: bool,
) -> vk::SwapchainCreateInfoKHR<'a> {
    let [width, height] = extent;
    let max_image_count = if capabilities.max_image_count == 0 {
        u32::MAX
    } else {
        capabilities.max_image_count
    };
    let alpha = [
        vk::CompositeAlphaFlagsKHR::OPAQUE,
        vk::CompositeAlphaFlagsKHR::INHERIT,
        vk::CompositeAlphaFlagsKHR::PRE_MULTIPLIED,
    ];
    let alpha = alpha
        .into_iter()
        .find(|&alpha| capabilities.supported_composite_alpha.contains(alpha));
    let upright = !turned
        && capabilities
            .supported_transforms
            .contains(vk::SurfaceTransformFlagsKHR::IDENTITY);
    vk::SwapchainCreateInfoKHR::default()
        .surface(surface.handle.raw)
        .min_image_count((capabilities.min_image_count + 1).min(max_image_count))
        .image_format(surface.format.format)
        .image_color_space(surface.format.color_space)
        .image_extent(vk::Extent2D { width, height })
        .image_array_layers(1)
        .image_usage(vk::ImageUsageFlags::COLOR_ATTACHMENT)
        .pre_transform(if upright {
            vk::SurfaceTransformFlagsKHR::IDENTITY
        } else {
            capabilities.current_transform
        })
        .composite_alpha(alpha.unwrap_or(vk::CompositeAlphaFlagsKHR::POST_MULTIPLIED))
        .present_mode(vk::PresentModeKHR::FIFO)
        .clipped(true)
}
