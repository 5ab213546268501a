//! The `present` stage: draws the rendered image, stretched to fill the canvas, over a colour or a
//! picture.

use super::pre_transform::PreTransform;
use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass, Sampler},
        recording::Recording,
    },
    memory::{Image, fill_image},
    pipeline::{
        graphics::{self, Attachment, DepthUse, PipelineDescription},
        set::Set,
        shaders,
    },
};
use ash::vk;
use bytemuck::cast_slice;
use std::sync::Arc;

/// Bytes of the push constants: the background, the pre-rotation, the sizes of the rendered image
/// and of the canvas.
const PUSHED: u32 = 4 * 14;

const IMAGE: vk::DescriptorType = vk::DescriptorType::COMBINED_IMAGE_SAMPLER;

/// Draws rendered images over a background, in a render pass that others may draw in afterwards.
pub struct Present {
    gpu: Arc<Gpu>,
    pipeline: Pipeline,
    render_pass: RenderPass,
    set: Set,
    sampler: Sampler,
    /// Behind images that ask for no colour: a texel until there is another.
    picture: Image,
    /// Of the windows that it draws into.
    pub format: vk::Format,
}

/// The target that a rendered image is drawn into.
#[derive(Clone, Copy)]
pub struct PresentTarget<'a> {
    /// Of the render pass of [`Present`].
    pub framebuffer: &'a Framebuffer,
    /// Width and height as a viewer sees it, px.
    pub size: [u32; 2],
    /// How it lies in the framebuffer.
    pub pre_transform: PreTransform,
}

/// The image to present.
#[derive(Clone, Copy)]
pub struct PresentedImage {
    /// The drawn part of the image: width and height from its upper left corner, px.
    pub drawn: [u32; 2],
    /// Display-referred RGB, 0 to 1. None: the picture, which must be as large as the canvas.
    pub background: Option<[f32; 3]>,
}

impl Present {
    /// For windows of a format whose numbers are shown as they are.
    pub fn new(gpu: &Arc<Gpu>, format: vk::Format) -> Result<Self> {
        Self::with_final_layout(gpu, format, vk::ImageLayout::PRESENT_SRC_KHR)
    }

    /// For images of which each frame leaves the layout as `layout`.
    pub fn with_final_layout(
        gpu: &Arc<Gpu>,
        format: vk::Format,
        layout: vk::ImageLayout,
    ) -> Result<Self> {
        let stages = vk::ShaderStageFlags::FRAGMENT;
        let set = Set::new(gpu, "present", stages, &[(0, IMAGE), (1, IMAGE)], PUSHED)?;
        let edge = vk::SamplerAddressMode::CLAMP_TO_EDGE;
        let info = vk::SamplerCreateInfo::default()
            .mag_filter(vk::Filter::LINEAR)
            .min_filter(vk::Filter::LINEAR)
            .address_mode_u(edge)
            .address_mode_v(edge);
        let render_pass = render_pass(gpu, format, layout)?;
        let new = Self {
            gpu: gpu.clone(),
            pipeline: pipeline(gpu, &render_pass, set.layouts.pipeline.raw())?,
            render_pass,
            set,
            sampler: Sampler::with(&gpu.device, &info, "present")?,
            picture: picture(gpu, [1; 2], &[0; 4])?,
            format,
        };
        // SAFETY: nothing uses it yet, and the picture was filled.
        unsafe { new.bind(1, &new.picture) };
        Ok(new)
    }

    /// The render pass that it draws in.
    pub fn render_pass(&self) -> &RenderPass {
        &self.render_pass
    }

    /// Shows this image from now on.
    ///
    /// # Safety
    /// No submitted work may use this. When it is recorded and done, the image must be alive and in
    /// `SHADER_READ_ONLY_OPTIMAL`.
    pub unsafe fn set_image(&self, image: &Image) {
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.bind(0, image) };
    }

    /// Width and height of the picture, px.
    pub fn picture_size(&self) -> [u32; 2] {
        self.picture.size
    }

    /// Has this picture behind images that ask for no colour. `size`: width and height, px.
    /// `pixels`: RGBA of 8 bits, row by row from the top left; alpha is not looked at.
    ///
    /// # Errors
    /// When the device has no room for it.
    ///
    /// # Safety
    /// No submitted work may use this.
    ///
    /// # Panics
    /// When it has other pixels than its size says.
    pub unsafe fn set_picture(&mut self, size: [u32; 2], pixels: &[u8]) -> Result<()> {
        self.picture = picture(&self.gpu, size, pixels)?;
        // SAFETY: nothing uses it, as the caller promises, and the picture was filled.
        unsafe { self.bind(1, &self.picture) };
        Ok(())
    }

    /// # Safety
    /// As for [`Self::set_image`].
    unsafe fn bind(&self, binding: u32, image: &Image) {
        let info = [vk::DescriptorImageInfo {
            sampler: self.sampler.raw(),
            image_view: image.view(),
            image_layout: vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL,
        }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.set.raw)
            .dst_binding(binding)
            .descriptor_type(IMAGE)
            .image_info(&info);
        // SAFETY: the set is not in use, and view and sampler are alive, as the caller promises.
        unsafe { self.gpu.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Draws the image, stretched to fill a canvas, over a background, then what `then` records in
    /// the same render pass.
    pub fn record(
        &self,
        commands: Recording,
        canvas: PresentTarget,
        shown: PresentedImage,
        then: impl FnOnce(),
    ) {
        let [width, height] = canvas.pre_transform.extent(canvas.size);
        let area = vk::Rect2D {
            offset: vk::Offset2D::default(),
            extent: vk::Extent2D { width, height },
        };
        let viewport = graphics::viewport(0.0, 0.0, width as f32, height as f32);
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(self.render_pass.raw())
            .framebuffer(canvas.framebuffer.raw())
            .render_area(area);
        let [x, y] = shown.drawn.map(|side| side as f32);
        let [w, h] = canvas.size.map(|side| side as f32);
        let [r, g, b] = shown.background.unwrap_or_default();
        let has_picture = f32::from(shown.background.is_none());
        let (matrix, origin) = canvas.pre_transform.back(canvas.size);
        let [xx, xy, yx, yy] = matrix.to_cols_array();
        let constants = [
            r,
            g,
            b,
            has_picture,
            xx,
            xy,
            yx,
            yy,
            origin.x,
            origin.y,
            x,
            y,
            w,
            h,
        ];
        let device = &self.gpu.raw;
        let raw = commands.raw();
        let point = vk::PipelineBindPoint::GRAPHICS;
        let layout = self.set.layouts.pipeline.raw();
        let stages = vk::ShaderStageFlags::FRAGMENT;
        // SAFETY: the command buffer is recording; every object is alive and fits the pipeline's
        // layout and the render pass.
        unsafe {
            device.cmd_begin_render_pass(raw, &begin, vk::SubpassContents::INLINE);
            device.cmd_bind_pipeline(raw, point, self.pipeline.raw());
            device.cmd_bind_descriptor_sets(raw, point, layout, 0, &[self.set.raw], &[]);
            device.cmd_push_constants(raw, layout, stages, 0, cast_slice(&constants));
            device.cmd_set_viewport(raw, 0, &[viewport]);
            device.cmd_set_scissor(raw, 0, &[area]);
            device.cmd_draw(raw, 3, 1, 0, 0);
            then();
            device.cmd_end_render_pass(raw);
        }
    }
}

/// A picture on the device, filled.
fn picture(gpu: &Arc<Gpu>, size: [u32; 2], pixels: &[u8]) -> Result<Image> {
    let [width, height] = size.map(|side| side as usize);
    assert_eq!(pixels.len(), 4 * width * height, "a picture has its pixels");
    let usage = vk::ImageUsageFlags::SAMPLED | vk::ImageUsageFlags::TRANSFER_DST;
    let format = vk::Format::R8G8B8A8_UNORM;
    let image = Image::new(gpu, "background", size, format, usage)?;
    fill_image(gpu, &image, pixels)?;
    Ok(image)
}

/// One image of a screen, drawn over whole and then shown.
fn render_pass(gpu: &Gpu, format: vk::Format, layout: vk::ImageLayout) -> Result<RenderPass> {
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
    let attachment = Attachment {
        format,
        load: vk::AttachmentLoadOp::DONT_CARE,
        initial_layout: vk::ImageLayout::UNDEFINED,
        final_layout: Some(layout),
    };
    graphics::render_pass(gpu, "present", attachment, None, &dependencies)
}

fn pipeline(
    gpu: &Arc<Gpu>,
    render_pass: &RenderPass,
    layout: vk::PipelineLayout,
) -> Result<Pipeline> {
    let drawing = PipelineDescription {
        name: "present",
        vertex: &shaders::PRESENT_VERTEX,
        fragment: &shaders::PRESENT_FRAGMENT,
        constants: &[],
        layout,
        render_pass: render_pass.raw(),
        blend: vk::PipelineColorBlendAttachmentState::default(),
        depth: DepthUse::Without,
    };
    graphics::pipeline(gpu, drawing)
}
