//! A screen without a window: what a window would show lands in an image, which can be read back.

use super::{
    pre_transform::PreTransform,
    present::{Present, PresentTarget, PresentedImage},
};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, handle::Framebuffer, recording::Recording},
    memory::{Buffer, Image, copy_image},
    raster::{Raster, quad_pass::OnePassTarget},
};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

const FORMAT: vk::Format = vk::Format::R8G8B8A8_UNORM;
const LAYOUT: vk::ImageLayout = vk::ImageLayout::TRANSFER_SRC_OPTIMAL;

/// Takes the `present` stage where there is no window.
pub struct Offscreen {
    gpu: Arc<Gpu>,
    present: Present,
    framebuffer: Framebuffer,
    /// Of a raster that is connected.
    one_pass: Option<Framebuffer>,
    image: Image,
}

impl Offscreen {
    /// `size`: width and height, px.
    pub fn new(gpu: &Arc<Gpu>, size: [u32; 2]) -> Result<Self> {
        let present = Present::with_final_layout(gpu, FORMAT, LAYOUT)?;
        let usage = vk::ImageUsageFlags::COLOR_ATTACHMENT | vk::ImageUsageFlags::TRANSFER_SRC;
        let image = Image::new(gpu, "screen", size, FORMAT, usage)?;
        let views = [image.view()];
        let framebuffer =
            Framebuffer::around(&gpu.device, present.render_pass(), &views, size, "screen")?;
        Ok(Self {
            gpu: gpu.clone(),
            present,
            framebuffer,
            one_pass: None,
            image,
        })
    }

    /// Shows this image from now on.
    ///
    /// # Safety
    /// No submitted work may use the screen. When it is recorded and done, the image must be alive
    /// and in `SHADER_READ_ONLY_OPTIMAL`.
    pub unsafe fn set_image(&self, image: &Image) {
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.present.set_image(image) };
    }

    /// Shows this raster's image from now on, as a window would.
    ///
    /// # Errors
    /// When the device fails.
    ///
    /// # Safety
    /// Those of [`Present::connect`].
    pub unsafe fn connect(&mut self, raster: &Raster) -> Result<()> {
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.present.connect(raster) }?;
        let Image { size, .. } = self.image;
        let upright = PreTransform::default();
        let view = self.image.view();
        self.one_pass = self
            .present
            .one_pass_framebuffer(raster, view, size, upright);
        Ok(())
    }

    /// See [`Present::one_pass`].
    pub fn one_pass(&self, background: [f32; 3]) -> Option<OnePassTarget<'_>> {
        self.present.one_pass(self.canvas(), Some(background))
    }

    fn canvas(&self) -> PresentTarget<'_> {
        PresentTarget {
            framebuffer: &self.framebuffer,
            one_pass: self.one_pass.as_ref(),
            size: self.image.size,
            pre_transform: PreTransform::default(),
        }
    }

    /// Stretches the upper left `drawn` px of the image over the target, over a background:
    /// display-referred RGB, 0 to 1.
    pub fn record(&self, commands: Recording, drawn: [u32; 2], background: [f32; 3]) {
        let shown = PresentedImage {
            drawn,
            background: Some(background),
        };
        self.present.record(commands, self.canvas(), shown, || ());
    }

    /// Copies what it shows, RGBA row by row from the top left, and waits. It must have shown
    /// something, and every submitted frame be done.
    pub fn download(&self) -> Result<Vec<u8>> {
        let [width, height] = self.image.size;
        let bytes = 4 * width as usize * height as usize;
        let mut staging = Buffer::new(
            &self.gpu,
            "screen copy",
            bytes as u64,
            vk::BufferUsageFlags::TRANSFER_DST,
            MemoryLocation::GpuToCpu,
        )?;
        self.gpu.run("reading a screen", |commands| {
            let image = &self.image;
            // SAFETY: image and buffer are alive, the buffer is large enough, and the image is in
            // the layout that `present` leaves it in; `run` waits.
            unsafe { copy_image(commands, image.raw(), LAYOUT, image.size, staging.raw()) };
            commands.show_host();
        })?;
        Ok(staging.mapped()[..bytes].to_vec())
    }
}
