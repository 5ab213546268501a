//! A screen without a window: what a window would show lands in an image, which can be read back.

use super::{
    device::Gpu,
    error::{During, Result},
    memory::{Buffer, Image, to_host},
    picture,
    present::Present,
};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

const FORMAT: vk::Format = vk::Format::R8G8B8A8_UNORM;
const LAYOUT: vk::ImageLayout = vk::ImageLayout::TRANSFER_SRC_OPTIMAL;

/// Takes the `present` stage where there is no window.
pub struct Screen {
    gpu: Arc<Gpu>,
    present: Present,
    image: Image,
    framebuffer: vk::Framebuffer,
}

impl Screen {
    /// `size`: width and height, px.
    pub fn new(gpu: &Arc<Gpu>, size: [u32; 2]) -> Result<Self> {
        let present = Present::leaving(gpu, FORMAT, LAYOUT)?;
        let usage = vk::ImageUsageFlags::COLOR_ATTACHMENT | vk::ImageUsageFlags::TRANSFER_SRC;
        let image = Image::new(gpu, "screen", size, FORMAT, usage)?;
        let views = [image.view];
        let info = vk::FramebufferCreateInfo::default()
            .render_pass(present.render_pass)
            .attachments(&views)
            .width(size[0])
            .height(size[1])
            .layers(1);
        // SAFETY: `info` and all it points to outlive the call.
        let framebuffer = unsafe { gpu.raw.create_framebuffer(&info, None) }.during("vkCreateFramebuffer")?;
        gpu.name(framebuffer, "screen");
        Ok(Self { gpu: gpu.clone(), present, image, framebuffer })
    }

    /// Shows this picture from now on. No submitted frame may still show another.
    pub fn set_picture(&self, image: &Image) {
        self.present.set_picture(image);
    }

    /// Stretches the picture (`drawn` px of its image) over the screen, over a background: display-referred RGB, 0 to 1.
    pub fn record(&self, commands: vk::CommandBuffer, drawn: [u32; 2], background: [f32; 3]) {
        self.present.record(commands, (self.framebuffer, self.image.size, Default::default()), (drawn, background), || ());
    }

    /// Copies what it shows, RGBA row by row from the top left, and waits. Every submitted frame must be done.
    pub fn download(&self) -> Result<Vec<u8>> {
        let [width, height] = self.image.size;
        let bytes = 4 * width as usize * height as usize;
        let mut staging =
            Buffer::new(&self.gpu, "screen copy", bytes as u64, vk::BufferUsageFlags::TRANSFER_DST, MemoryLocation::GpuToCpu)?;
        self.gpu.run("reading a screen", |commands| {
            picture::copy(&self.gpu, commands, (self.image.raw, self.image.size, LAYOUT), staging.raw);
            to_host(&self.gpu, commands);
        })?;
        Ok(staging.mapped()[..bytes].to_vec())
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // SAFETY: owners drop a screen only when no submitted frame uses it.
        self.gpu.destroy(|device| unsafe { device.destroy_framebuffer(self.framebuffer, None) });
    }
}
