//! The `present` stage: the picture goes in, an image of a screen with the picture, stretched to fill it, over a background comes out.

use super::{
    device::Gpu,
    error::{During, Result},
    graphics::{self, Attachment, Depth, Drawing},
    memory::Image,
    shaders,
    turn::Turn,
};
use ash::vk;
use bytemuck::cast_slice;
use std::sync::Arc;

/// Bytes that the shader is told: the background, how the screen is turned, the picture's size and the screen's.
const PUSHED: u32 = 4 * 14;

/// Draws pictures over a background, in a render pass that others may draw in afterwards.
pub struct Present {
    gpu: Arc<Gpu>,
    pub render_pass: vk::RenderPass,
    /// Of the windows that it draws into.
    pub format: vk::Format,
    sampler: vk::Sampler,
    set_layout: vk::DescriptorSetLayout,
    layout: vk::PipelineLayout,
    pool: vk::DescriptorPool,
    set: vk::DescriptorSet,
    pipeline: vk::Pipeline,
}

impl Present {
    /// For windows of a format whose numbers are shown as they are.
    pub fn new(gpu: &Arc<Gpu>, format: vk::Format) -> Result<Self> {
        Self::leaving(gpu, format, vk::ImageLayout::PRESENT_SRC_KHR)
    }

    /// For images that are left in a layout.
    pub fn leaving(gpu: &Arc<Gpu>, format: vk::Format, layout: vk::ImageLayout) -> Result<Self> {
        let mut new = Self {
            gpu: gpu.clone(),
            render_pass: Default::default(),
            format,
            sampler: Default::default(),
            set_layout: Default::default(),
            layout: Default::default(),
            pool: Default::default(),
            set: Default::default(),
            pipeline: Default::default(),
        };
        let stages = vk::ShaderStageFlags::FRAGMENT;
        let kind = vk::DescriptorType::COMBINED_IMAGE_SAMPLER;
        let bindings = [vk::DescriptorSetLayoutBinding::default().binding(0).descriptor_type(kind).descriptor_count(1).stage_flags(stages)];
        let sizes = [vk::DescriptorPoolSize { ty: kind, descriptor_count: 1 }];
        let constants = [vk::PushConstantRange { stage_flags: stages, offset: 0, size: PUSHED }];
        // SAFETY: every structure outlives the call it is passed to; what was made before a failure is destroyed by `drop`.
        unsafe {
            let edge = vk::SamplerAddressMode::CLAMP_TO_EDGE;
            let info = vk::SamplerCreateInfo::default()
                .mag_filter(vk::Filter::LINEAR)
                .min_filter(vk::Filter::LINEAR)
                .address_mode_u(edge)
                .address_mode_v(edge);
            new.sampler = gpu.raw.create_sampler(&info, None).during("vkCreateSampler")?;
            let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            new.set_layout = gpu.raw.create_descriptor_set_layout(&info, None).during("vkCreateDescriptorSetLayout")?;
            let layouts = [new.set_layout];
            let info = vk::PipelineLayoutCreateInfo::default().set_layouts(&layouts).push_constant_ranges(&constants);
            new.layout = gpu.raw.create_pipeline_layout(&info, None).during("vkCreatePipelineLayout")?;
            let info = vk::DescriptorPoolCreateInfo::default().max_sets(1).pool_sizes(&sizes);
            new.pool = gpu.raw.create_descriptor_pool(&info, None).during("vkCreateDescriptorPool")?;
            let info = vk::DescriptorSetAllocateInfo::default().descriptor_pool(new.pool).set_layouts(&layouts);
            new.set = gpu.raw.allocate_descriptor_sets(&info).during("vkAllocateDescriptorSets")?[0];
        }
        new.label();
        new.render_pass = render_pass(gpu, format, layout)?;
        new.pipeline = pipeline(gpu, new.render_pass, new.layout)?;
        Ok(new)
    }

    /// Names what no other function names.
    fn label(&self) {
        let (gpu, name) = (&self.gpu, "present");
        gpu.name(self.sampler, name);
        gpu.name(self.set_layout, name);
        gpu.name(self.layout, name);
        gpu.name(self.pool, name);
        gpu.name(self.set, name);
    }

    /// Shows this picture from now on. No submitted frame may still show another.
    pub fn set_picture(&self, image: &Image) {
        let picture = [vk::DescriptorImageInfo {
            sampler: self.sampler,
            image_view: image.view,
            image_layout: vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL,
        }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.set)
            .dst_binding(0)
            .descriptor_type(vk::DescriptorType::COMBINED_IMAGE_SAMPLER)
            .image_info(&picture);
        // SAFETY: the caller promises that the set is not in use; view and sampler are alive.
        unsafe { self.gpu.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Draws the picture over a background into a screen's framebuffer, then what `then` records. The screen has a size as it is seen, px, and
    /// lies turned in its framebuffer. `picture`: how much of the image is the picture, px from its upper left corner.
    pub fn record(
        &self,
        commands: vk::CommandBuffer,
        (framebuffer, size, turn): (vk::Framebuffer, [u32; 2], Turn),
        (picture, background): ([u32; 2], [f32; 3]),
        then: impl FnOnce(),
    ) {
        let [width, height] = turn.extent(size);
        let area = vk::Rect2D { offset: vk::Offset2D::default(), extent: vk::Extent2D { width, height } };
        let viewport = vk::Viewport { x: 0.0, y: 0.0, width: width as f32, height: height as f32, min_depth: 0.0, max_depth: 1.0 };
        let begin = vk::RenderPassBeginInfo::default().render_pass(self.render_pass).framebuffer(framebuffer).render_area(area);
        let [[x, y], [w, h]] = [picture, size].map(|size| size.map(|side| side as f32));
        let ([r, g, b], (matrix, origin)) = (background, turn.back(size));
        let [xx, xy, yx, yy] = matrix.to_cols_array();
        let constants = [r, g, b, 1.0, xx, xy, yx, yy, origin.x, origin.y, x, y, w, h];
        let device = &self.gpu.raw;
        let point = vk::PipelineBindPoint::GRAPHICS;
        // SAFETY: the command buffer is recording; every object is alive and fits the pipeline's layout and the render pass.
        unsafe {
            device.cmd_begin_render_pass(commands, &begin, vk::SubpassContents::INLINE);
            device.cmd_bind_pipeline(commands, point, self.pipeline);
            device.cmd_bind_descriptor_sets(commands, point, self.layout, 0, &[self.set], &[]);
            device.cmd_push_constants(commands, self.layout, vk::ShaderStageFlags::FRAGMENT, 0, cast_slice(&constants));
            device.cmd_set_viewport(commands, 0, &[viewport]);
            device.cmd_set_scissor(commands, 0, &[area]);
            device.cmd_draw(commands, 3, 1, 0, 0);
            then();
            device.cmd_end_render_pass(commands);
        }
    }
}

impl Drop for Present {
    fn drop(&mut self) {
        // SAFETY: owners drop a stage only when no submitted work uses it. Destroying null handles does nothing.
        self.gpu.destroy(|device| unsafe {
            device.destroy_pipeline(self.pipeline, None);
            device.destroy_render_pass(self.render_pass, None);
            device.destroy_descriptor_pool(self.pool, None);
            device.destroy_pipeline_layout(self.layout, None);
            device.destroy_descriptor_set_layout(self.set_layout, None);
            device.destroy_sampler(self.sampler, None);
        });
    }
}

/// One image of a screen, drawn over whole and then shown.
fn render_pass(gpu: &Gpu, format: vk::Format, layout: vk::ImageLayout) -> Result<vk::RenderPass> {
    // The submission waits for the image at this stage, so the change of its layout has to wait there too.
    let output = vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT;
    let dependencies = [vk::SubpassDependency::default()
        .src_subpass(vk::SUBPASS_EXTERNAL)
        .dst_subpass(0)
        .src_stage_mask(output)
        .src_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE)
        .dst_stage_mask(output)
        .dst_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_READ | vk::AccessFlags::COLOR_ATTACHMENT_WRITE)];
    let attachment = Attachment { format, load: vk::AttachmentLoadOp::DONT_CARE, found: vk::ImageLayout::UNDEFINED, left: Some(layout) };
    graphics::render_pass(gpu, "present", Some(attachment), None, &dependencies)
}

fn pipeline(gpu: &Gpu, render_pass: vk::RenderPass, layout: vk::PipelineLayout) -> Result<vk::Pipeline> {
    let drawing = Drawing {
        name: "present",
        vertex: &shaders::PRESENT_VERTEX,
        fragment: Some(&shaders::PRESENT_FRAGMENT),
        constants: &[],
        layout,
        render_pass,
        blend: Some(vk::PipelineColorBlendAttachmentState::default()),
        depth: Depth::Without,
        cull: vk::CullModeFlags::NONE,
    };
    graphics::pipeline(gpu, drawing)
}
