//! A window's surface and the images that it shows in turn.

pub use super::target::Target;
use super::{
    commands::SLOTS,
    device::Gpu,
    error::{During, Error, Result},
    memory::COLOR,
    timing::{Timing, Told},
    turn::Turn,
};
use ash::{khr, vk};
use std::{sync::Arc, time::Duration};

/// How long to wait for an image before the program looks after its other work, and how often.
const ACQUIRE: (Duration, u32) = (Duration::from_secs(1), 30);

/// A window's surface. The window must outlive it.
pub struct Surface {
    gpu: Arc<Gpu>,
    loader: khr::surface::Instance,
    raw: vk::SurfaceKHR,
    format: vk::SurfaceFormatKHR,
    _target: Target,
}

impl Surface {
    /// Fails where the device can't show pictures in this window.
    pub fn new(gpu: &Arc<Gpu>, target: Target) -> Result<Self> {
        let loader = khr::surface::Instance::new(&gpu.instance.entry, &gpu.instance.raw);
        let (entry, instance) = (&gpu.instance.entry, &gpu.instance.raw);
        // SAFETY: the caller keeps the window alive; the instance has the extensions that `extensions` named.
        let raw = unsafe { ash_window::create_surface(entry, instance, target.display, target.window, None) };
        let raw = raw.during("vkCreateSurface")?;
        let mut surface = Self { gpu: gpu.clone(), loader, raw, format: Default::default(), _target: target };
        surface.format = surface.choose_format()?;
        Ok(surface)
    }

    fn choose_format(&self) -> Result<vk::SurfaceFormatKHR> {
        let refused = |why: &str| Error::Lacks { device: self.gpu.probe.name.clone(), lacks: why.into() };
        let physical = self.gpu.probe.physical;
        // SAFETY: device and surface are alive and of the same instance.
        let supported = unsafe { self.loader.get_physical_device_surface_support(physical, self.gpu.queue_family, self.raw) };
        if self.gpu.swapchain.is_none() || !supported.during("vkGetPhysicalDeviceSurfaceSupportKHR")? {
            return Err(refused("it can't show pictures in this window; name another with --device"));
        }
        // SAFETY: as above.
        let formats = unsafe { self.loader.get_physical_device_surface_formats(physical, self.raw) };
        let formats = formats.during("vkGetPhysicalDeviceSurfaceFormatsKHR")?;
        let plain = [vk::Format::B8G8R8A8_UNORM, vk::Format::R8G8B8A8_UNORM, vk::Format::A8B8G8R8_UNORM_PACK32];
        let found = plain.iter().find_map(|&wanted| {
            formats.iter().find(|found| found.format == wanted && found.color_space == vk::ColorSpaceKHR::SRGB_NONLINEAR)
        });
        found.copied().ok_or_else(|| refused("its windows have no 8-bit format without conversion"))
    }

    pub fn format(&self) -> vk::Format {
        self.format.format
    }
}

impl Drop for Surface {
    fn drop(&mut self) {
        // SAFETY: owners drop a surface after its swapchains.
        unsafe { self.loader.destroy_surface(self.raw, None) };
    }
}

/// What asking for an image came to.
#[derive(Clone, Copy, Debug)]
pub enum Acquired {
    /// An image to draw to: its number, and what is signalled when it is free.
    Image(u32, vk::Semaphore),
    /// The window has changed: make the swapchain anew.
    Outdated,
    /// The window has none to give yet, for instance since it is hidden.
    NotYet,
}

/// The images of a window of one size.
pub struct Swapchain {
    gpu: Arc<Gpu>,
    loader: khr::swapchain::Device,
    raw: vk::SwapchainKHR,
    views: Vec<vk::ImageView>,
    framebuffers: Vec<vk::Framebuffer>,
    /// Signalled when an image has been drawn; one an image, since it is free again when that image is acquired again.
    finished: Vec<vk::Semaphore>,
    /// Signalled when an image may be drawn to. One more than frames in flight: the next is taken before the oldest frame is waited for.
    acquired: Vec<vk::Semaphore>,
    next: usize,
    waited: u32,
    /// When its images are shown, where the display tells.
    timing: Option<Timing>,
    /// Width and height of the picture as it is seen, px.
    pub size: [u32; 2],
    /// How it lies in the images.
    pub turn: Turn,
}

impl Swapchain {
    /// `wanted` is the window's size, px, where the surface does not say itself. None while the window has no area.
    /// No submitted frame may still use `old`.
    pub fn new(
        gpu: &Arc<Gpu>,
        surface: &Surface,
        render_pass: vk::RenderPass,
        (wanted, old): ([u32; 2], Option<Self>),
    ) -> Result<Option<Self>> {
        let Some(loader) = gpu.swapchain.clone() else { return Ok(None) };
        // SAFETY: device and surface are alive and of the same instance.
        let capabilities = unsafe { surface.loader.get_physical_device_surface_capabilities(gpu.probe.physical, surface.raw) };
        let capabilities = capabilities.during("vkGetPhysicalDeviceSurfaceCapabilitiesKHR")?;
        let size = match (capabilities.current_extent.width, capabilities.current_extent.height) {
            (u32::MAX, _) => {
                let (min, max) = (capabilities.min_image_extent, capabilities.max_image_extent);
                [wanted[0].clamp(min.width, max.width.max(min.width)), wanted[1].clamp(min.height, max.height.max(min.height))]
            }
            (width, height) => [width, height],
        };
        if size.contains(&0) || wanted.contains(&0) {
            return Ok(None);
        }
        let transforms = (capabilities.supported_transforms, capabilities.current_transform);
        let turn = Turn::asked(transforms.1).filter(|_| transforms.0.contains(transforms.1));
        let info = info(surface, &capabilities, turn.unwrap_or_default().extent(size), turn.is_some())
            .old_swapchain(old.as_ref().map_or(vk::SwapchainKHR::null(), |old| old.raw));
        // SAFETY: `info` and all it points to outlive the call.
        let raw = unsafe { loader.create_swapchain(&info, None) }.during("vkCreateSwapchainKHR")?;
        drop(old);
        let mut new = Self {
            gpu: gpu.clone(),
            loader,
            raw,
            views: Vec::new(),
            framebuffers: Vec::new(),
            finished: Vec::new(),
            acquired: Vec::new(),
            next: 0,
            waited: 0,
            timing: Timing::new(gpu),
            size,
            turn: turn.unwrap_or_default(),
        };
        new.fill(surface.format.format, render_pass)?;
        Ok(Some(new))
    }

    /// Makes what goes with each image.
    fn fill(&mut self, format: vk::Format, render_pass: vk::RenderPass) -> Result<()> {
        let device = &self.gpu.raw;
        let semaphore = vk::SemaphoreCreateInfo::default();
        // SAFETY: every structure outlives the call it is passed to; what was made before a failure is destroyed by `drop`.
        unsafe {
            for image in self.loader.get_swapchain_images(self.raw).during("vkGetSwapchainImagesKHR")? {
                let info = vk::ImageViewCreateInfo::default()
                    .image(image)
                    .view_type(vk::ImageViewType::TYPE_2D)
                    .format(format)
                    .subresource_range(COLOR);
                let view = device.create_image_view(&info, None).during("vkCreateImageView")?;
                self.gpu.name(image, "window");
                self.gpu.name(view, "window");
                self.views.push(view);
                let [width, height] = self.turn.extent(self.size);
                let views = [view];
                let info =
                    vk::FramebufferCreateInfo::default().render_pass(render_pass).attachments(&views).width(width).height(height).layers(1);
                self.framebuffers.push(device.create_framebuffer(&info, None).during("vkCreateFramebuffer")?);
                self.finished.push(device.create_semaphore(&semaphore, None).during("vkCreateSemaphore")?);
            }
            self.gpu.name(self.raw, "window");
            self.framebuffers.iter().for_each(|&framebuffer| self.gpu.name(framebuffer, "window"));
            self.finished.iter().for_each(|&semaphore| self.gpu.name(semaphore, "frame drawn"));
            for _ in 0..=SLOTS {
                self.acquired.push(device.create_semaphore(&semaphore, None).during("vkCreateSemaphore")?);
            }
            self.acquired.iter().for_each(|&semaphore| self.gpu.name(semaphore, "image acquired"));
        }
        Ok(())
    }

    /// Asks for the next image to draw to.
    pub fn acquire(&mut self) -> Result<Acquired> {
        let semaphore = self.acquired[self.next];
        let (timeout, tries) = ACQUIRE;
        // SAFETY: the semaphore is free: the frame that last used it is more frames back than can be in flight.
        let result = unsafe { self.loader.acquire_next_image(self.raw, timeout.as_nanos() as u64, semaphore, vk::Fence::null()) };
        match result {
            Ok((image, _)) => {
                self.next = (self.next + 1) % self.acquired.len();
                self.waited = 0;
                Ok(Acquired::Image(image, semaphore))
            }
            Err(vk::Result::ERROR_OUT_OF_DATE_KHR) => Ok(Acquired::Outdated),
            Err(vk::Result::TIMEOUT | vk::Result::NOT_READY) if self.waited + 1 < tries => {
                self.waited += 1;
                Ok(Acquired::NotYet)
            }
            Err(vk::Result::TIMEOUT | vk::Result::NOT_READY) => {
                Err(Error::Timeout { what: "getting an image of the window", seconds: timeout.as_secs() * u64::from(tries) })
            }
            Err(error) => Err(error).during("vkAcquireNextImageKHR"),
        }
    }

    /// What to draw an image with, and what to signal when it is drawn.
    pub fn image(&self, image: u32) -> (vk::Framebuffer, vk::Semaphore) {
        (self.framebuffers[image as usize], self.finished[image as usize])
    }

    /// What the display tells of its refreshes. None where it never does.
    pub fn told(&self) -> Option<Told> {
        self.timing.as_ref().map(|timing| timing.told(self.raw))
    }

    /// Shows an image once it is drawn, and not before a time where the display can be told: nanoseconds of the system's monotonic clock.
    /// True where the swapchain still fits the window.
    pub fn present(&mut self, image: u32, at: Option<u64>) -> Result<bool> {
        let (wait, swapchains, images) = ([self.finished[image as usize]], [self.raw], [image]);
        let wishes: Vec<_> = self.timing.iter_mut().map(|timing| timing.wish(at)).collect();
        let mut times = vk::PresentTimesInfoGOOGLE::default().times(&wishes);
        let mut info = vk::PresentInfoKHR::default().wait_semaphores(&wait).swapchains(&swapchains).image_indices(&images);
        if !wishes.is_empty() {
            info = info.push_next(&mut times);
        }
        match self.gpu.present(&self.loader, &info) {
            Ok(suboptimal) => Ok(!suboptimal),
            Err(vk::Result::ERROR_OUT_OF_DATE_KHR) => Ok(false),
            Err(error) => Err(error).during("vkQueuePresentKHR"),
        }
    }
}

/// First in, first out: no tearing, at the display's rate, and on every device. `turned`: pictures are drawn the way the display is mounted.
fn info<'a>(
    surface: &Surface,
    capabilities: &vk::SurfaceCapabilitiesKHR,
    [width, height]: [u32; 2],
    turned: bool,
) -> vk::SwapchainCreateInfoKHR<'a> {
    let most = if capabilities.max_image_count == 0 { u32::MAX } else { capabilities.max_image_count };
    let alpha = [vk::CompositeAlphaFlagsKHR::OPAQUE, vk::CompositeAlphaFlagsKHR::INHERIT, vk::CompositeAlphaFlagsKHR::PRE_MULTIPLIED];
    let alpha = alpha.into_iter().find(|&alpha| capabilities.supported_composite_alpha.contains(alpha));
    let upright = !turned && capabilities.supported_transforms.contains(vk::SurfaceTransformFlagsKHR::IDENTITY);
    vk::SwapchainCreateInfoKHR::default()
        .surface(surface.raw)
        .min_image_count((capabilities.min_image_count + 1).min(most))
        .image_format(surface.format.format)
        .image_color_space(surface.format.color_space)
        .image_extent(vk::Extent2D { width, height })
        .image_array_layers(1)
        .image_usage(vk::ImageUsageFlags::COLOR_ATTACHMENT)
        .pre_transform(if upright { vk::SurfaceTransformFlagsKHR::IDENTITY } else { capabilities.current_transform })
        .composite_alpha(alpha.unwrap_or(vk::CompositeAlphaFlagsKHR::POST_MULTIPLIED))
        .present_mode(vk::PresentModeKHR::FIFO)
        .clipped(true)
}

impl Drop for Swapchain {
    fn drop(&mut self) {
        let device = &self.gpu.raw;
        // What is left in the queue is at most the wait of the last presentation for a frame that is done.
        if matches!(self.gpu.idle(), Err(Error::Timeout { .. })) {
            tracing::warn!("the device does not finish its last frame; what belongs to the window is not freed");
            return;
        }
        // SAFETY: owners drop a swapchain only when no submitted frame uses it.
        unsafe {
            self.framebuffers.iter().for_each(|&framebuffer| device.destroy_framebuffer(framebuffer, None));
            self.views.iter().for_each(|&view| device.destroy_image_view(view, None));
            self.finished.iter().chain(&self.acquired).for_each(|&semaphore| device.destroy_semaphore(semaphore, None));
            self.loader.destroy_swapchain(self.raw, None);
        }
    }
}
