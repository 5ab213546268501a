//! The render passes that write a screen. In one of them quads are drawn too: GPUs that blend in
//! tile memory then store the screen alone; otherwise they store the image, of twice as many bytes,
//! and read it again.

use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass},
    },
    memory::Image,
    pipeline::{
        graphics::{self, Attachment, DepthUse, PipelineDescription},
        set::Set,
        shaders,
    },
    raster::{Raster, quad_pass::QuadPass},
};
use ash::vk;
use std::sync::Arc;

/// Bytes of the push constants of what writes a screen.
pub(super) const PUSHED: u32 = 4 * 14;

pub(super) const IMAGE: vk::DescriptorType = vk::DescriptorType::COMBINED_IMAGE_SAMPLER;
const INPUT: vk::DescriptorType = vk::DescriptorType::INPUT_ATTACHMENT;

/// One image of a screen, drawn over whole and then shown.
pub(super) fn screen(format: vk::Format, layout: vk::ImageLayout) -> Attachment {
    Attachment {
        format,
        load: vk::AttachmentLoadOp::DONT_CARE,
        initial_layout: vk::ImageLayout::UNDEFINED,
        final_layout: Some(layout),
    }
}

/// Render passes for one screen are compatible, whatever they do with what it shows.
pub(super) fn render_pass(gpu: &Gpu, screen: Attachment) -> Result<RenderPass> {
    // The submission waits for the image at this stage, so the change of its layout has to wait
    // there too.
    let output = vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT;
    let dependencies = [vk::SubpassDependency::default()
        .src_subpass(vk::SUBPASS_EXTERNAL)
        .dst_subpass(0)
        .src_stage_mask(output)
        .src_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE)
        .dst_stage_mask(output)
        .dst_access_mask(
            vk::AccessFlags::COLOR_ATTACHMENT_READ | vk::AccessFlags::COLOR_ATTACHMENT_WRITE,
        )];
    graphics::render_pass(gpu, "present", screen, None, None, &dependencies)
}

/// A render pass that draws a raster's quads and shows them, and what its second subpass draws with.
pub(super) struct OnePass {
    pub quads: QuadPass,
    pub set: Set,
    pub pipeline: Pipeline,
    /// Draws over what the screen shows.
    pub over: RenderPass,
}

impl OnePass {
    /// None for a raster without quads. `screen`: as [`screen`] says.
    pub fn new(gpu: &Arc<Gpu>, raster: &Raster, screen: Attachment) -> Result<Option<Self>> {
        let Some(quads) = raster.one_pass(screen)? else {
            return Ok(None);
        };
        let stages = vk::ShaderStageFlags::FRAGMENT;
        let set = Set::new(gpu, "one pass", stages, &[(0, INPUT), (1, IMAGE)], PUSHED)?;
        let drawing = PipelineDescription {
            name: "one pass",
            vertex: &shaders::PRESENT_VERTEX,
            fragment: &shaders::PRESENT_IN_PASS,
            constants: &[],
            layout: set.layouts.pipeline.raw(),
            render_pass: quads.render_pass().raw(),
            subpass: 1,
            blend: vk::PipelineColorBlendAttachmentState::default(),
            depth: DepthUse::Without,
        };
        let over = Attachment {
            load: vk::AttachmentLoadOp::LOAD,
            initial_layout: screen.final_layout.unwrap_or(screen.initial_layout),
            ..screen
        };
        Ok(Some(Self {
            pipeline: graphics::pipeline(gpu, drawing)?,
            over: render_pass(gpu, over)?,
            quads,
            set,
        }))
    }

    /// Reads this image.
    ///
    /// # Safety
    /// No submitted work may use this; the image must outlive the work that will.
    pub unsafe fn set_image(&self, gpu: &Gpu, image: &Image) {
        let info = [vk::DescriptorImageInfo::default()
            .image_view(image.view())
            .image_layout(vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL)];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.set.raw)
            .dst_binding(0)
            .descriptor_type(INPUT)
            .image_info(&info);
        // SAFETY: the set is not in use, and the view alive, as the caller promises.
        unsafe { gpu.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Around the raster's image and a screen's of `size` px. None, and two passes, where they
    /// don't match or the driver has no memory for it.
    pub fn framebuffer(
        &self,
        raster: &Raster,
        screen: vk::ImageView,
        size: [u32; 2],
    ) -> Option<Framebuffer> {
        let made = raster.framebuffer(&self.quads, screen, size);
        made.unwrap_or_else(|error| {
            tracing::warn!("images are stored before they are shown: {error}");
            None
        })
    }
}
