//! Render passes and graphics pipelines of the stages that draw: a render pass with a colour
//! attachment and, where depths are tested, one of depth, and a pipeline that draws triangles to
//! it. A second subpass may show what the first has drawn.

use super::{
    module::{flags, list, shader_module, specialization_entries, take_over},
    shaders::Module,
};
use crate::vulkan::{
    device::{
        error::{During, Error, Result},
        gpu::Gpu,
        handle::{Pipeline, RenderPass, ShaderModule},
    },
    memory::DEPTH_FORMAT,
};
use ash::vk;
use bytemuck::cast_slice;
use std::sync::Arc;

/// An attachment of a render pass.
#[derive(Clone, Copy)]
pub(crate) struct Attachment {
    pub format: vk::Format,
    pub load: vk::AttachmentLoadOp,
    /// Layout before the render pass. With `UNDEFINED` the contents are lost, outside the render
    /// area too.
    pub initial_layout: vk::ImageLayout,
    /// Layout after the render pass. None: nothing reads the attachment, and it is not stored.
    pub final_layout: Option<vk::ImageLayout>,
}

/// What a depth attachment is cleared to: as far as can be.
pub(crate) const FURTHEST: vk::ClearValue = vk::ClearValue {
    depth_stencil: vk::ClearDepthStencilValue {
        depth: 1.0,
        stencil: 0,
    },
};

/// "Over", back to front: C = αc + (1 − α) C, and coverage likewise, which leaves the image
/// premultiplied. The fragment's colour is not, so that a blender that rounds uses one rounded
/// alpha for both terms.
pub(crate) fn over() -> vk::PipelineColorBlendAttachmentState {
    vk::PipelineColorBlendAttachmentState::default()
        .blend_enable(true)
        .src_color_blend_factor(vk::BlendFactor::SRC_ALPHA)
        .dst_color_blend_factor(vk::BlendFactor::ONE_MINUS_SRC_ALPHA)
        .src_alpha_blend_factor(vk::BlendFactor::ONE)
        .dst_alpha_blend_factor(vk::BlendFactor::ONE_MINUS_SRC_ALPHA)
}

/// A depth attachment that is cleared, and that nothing reads after the render pass.
pub(crate) fn depth() -> Attachment {
    Attachment {
        format: DEPTH_FORMAT,
        load: vk::AttachmentLoadOp::CLEAR,
        initial_layout: vk::ImageLayout::UNDEFINED,
        final_layout: None,
    }
}

fn description(attachment: Attachment, used: vk::ImageLayout) -> vk::AttachmentDescription {
    let store = if attachment.final_layout.is_some() {
        vk::AttachmentStoreOp::STORE
    } else {
        vk::AttachmentStoreOp::DONT_CARE
    };
    vk::AttachmentDescription::default()
        .format(attachment.format)
        .samples(vk::SampleCountFlags::TYPE_1)
        .load_op(attachment.load)
        .store_op(store)
        .stencil_load_op(vk::AttachmentLoadOp::DONT_CARE)
        .stencil_store_op(vk::AttachmentStoreOp::DONT_CARE)
        .initial_layout(attachment.initial_layout)
        .final_layout(attachment.final_layout.unwrap_or(used))
}

/// Attachments are colour, then depth, then the screen: a second subpass writes it, and reads the
/// colour that the first has written to the same pixel.
pub(crate) fn render_pass(
    gpu: &Gpu,
    name: &str,
    color: Attachment,
    depth: Option<Attachment>,
    screen: Option<Attachment>,
    dependencies: &[vk::SubpassDependency],
) -> Result<RenderPass> {
    const COLOR: vk::ImageLayout = vk::ImageLayout::COLOR_ATTACHMENT_OPTIMAL;
    const DEPTH: vk::ImageLayout = vk::ImageLayout::DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
    const INPUT: vk::ImageLayout = vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL;
    let color_last = if screen.is_some() { INPUT } else { COLOR };
    let attachments: Vec<_> = std::iter::once(description(color, color_last))
        .chain(depth.map(|depth| description(depth, DEPTH)))
        .chain(screen.map(|screen| description(screen, COLOR)))
        .collect();
    let reference = |attachment, layout| vk::AttachmentReference { attachment, layout };
    let colors = [reference(0, COLOR)];
    let depths = reference(1, DEPTH);
    let inputs = [reference(0, INPUT)];
    let screens = [reference(attachments.len() as u32 - 1, COLOR)];
    let mut subpass = vk::SubpassDescription::default()
        .pipeline_bind_point(vk::PipelineBindPoint::GRAPHICS)
        .color_attachments(&colors);
    if depth.is_some() {
        subpass = subpass.depth_stencil_attachment(&depths);
    }
    let shows = vk::SubpassDescription::default()
        .pipeline_bind_point(vk::PipelineBindPoint::GRAPHICS)
        .input_attachments(&inputs)
        .color_attachments(&screens);
    let subpasses: Vec<_> = std::iter::once(subpass)
        .chain(screen.map(|_| shows))
        .collect();
    let info = vk::RenderPassCreateInfo::default()
        .attachments(&attachments)
        .subpasses(&subpasses)
        .dependencies(dependencies);
    // SAFETY: `info` and all it points to outlive the call; the render pass is new and belongs to
    // its owner.
    unsafe {
        let raw = gpu.raw.create_render_pass(&info, None);
        let raw = raw.during("vkCreateRenderPass")?;
        Ok(RenderPass::new(&gpu.device, raw, name))
    }
}

/// Use of the depth attachment by a pipeline.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum DepthUse {
    /// The render pass has no depth attachment.
    Without,
    /// Keeps the nearest.
    Write,
    /// Draws fragments that are no further than the stored depth.
    Test,
}

/// Description of a graphics pipeline.
pub(crate) struct PipelineDescription<'a> {
    pub name: &'static str,
    pub vertex: &'static Module,
    pub fragment: &'static Module,
    /// Specialization constants, 0 upwards; a module need not have all of them.
    pub constants: &'a [u32],
    pub layout: vk::PipelineLayout,
    pub render_pass: vk::RenderPass,
    pub subpass: u32,
    pub blend: vk::PipelineColorBlendAttachmentState,
    pub depth: DepthUse,
}

/// Triangles, no vertex buffers, viewport and scissor set while recording.
///
/// # Errors
/// When the device fails, or its driver crashes when it draws triangles.
pub(crate) fn pipeline(gpu: &Arc<Gpu>, drawing: PipelineDescription) -> Result<Pipeline> {
    if !gpu.probe.draws_triangles() {
        return Err(Error::NoTriangles {
            device: gpu.probe.name.clone(),
        });
    }
    let vertex = shader_module(gpu, drawing.vertex)?;
    let fragment = shader_module(gpu, drawing.fragment)?;
    let entries = specialization_entries(drawing.constants);
    let specialization = vk::SpecializationInfo::default()
        .map_entries(&entries)
        .data(cast_slice(drawing.constants));
    let stage = |stage, module: &ShaderModule| {
        let info = vk::PipelineShaderStageCreateInfo::default()
            .stage(stage)
            .module(module.raw());
        info.name(c"main").specialization_info(&specialization)
    };
    let stages = [
        stage(vk::ShaderStageFlags::VERTEX, &vertex),
        stage(vk::ShaderStageFlags::FRAGMENT, &fragment),
    ];
    let vertices = vk::PipelineVertexInputStateCreateInfo::default();
    let assembly = vk::PipelineInputAssemblyStateCreateInfo::default()
        .topology(vk::PrimitiveTopology::TRIANGLE_LIST);
    let viewports = vk::PipelineViewportStateCreateInfo::default()
        .viewport_count(1)
        .scissor_count(1);
    let rasterization = vk::PipelineRasterizationStateCreateInfo::default()
        .cull_mode(vk::CullModeFlags::NONE)
        .line_width(1.0);
    let samples = vk::PipelineMultisampleStateCreateInfo::default()
        .rasterization_samples(vk::SampleCountFlags::TYPE_1);
    let depth = vk::PipelineDepthStencilStateCreateInfo::default()
        .depth_test_enable(drawing.depth != DepthUse::Without)
        .depth_write_enable(drawing.depth == DepthUse::Write)
        .depth_compare_op(vk::CompareOp::LESS_OR_EQUAL);
    let attachments = [drawing
        .blend
        .color_write_mask(vk::ColorComponentFlags::RGBA)];
    let blend = vk::PipelineColorBlendStateCreateInfo::default().attachments(&attachments);
    let dynamic = vk::PipelineDynamicStateCreateInfo::default()
        .dynamic_states(&[vk::DynamicState::VIEWPORT, vk::DynamicState::SCISSOR]);
    let info = vk::GraphicsPipelineCreateInfo::default()
        .flags(flags(gpu))
        .stages(&stages)
        .vertex_input_state(&vertices)
        .input_assembly_state(&assembly)
        .viewport_state(&viewports)
        .rasterization_state(&rasterization)
        .multisample_state(&samples)
        .depth_stencil_state(&depth)
        .color_blend_state(&blend)
        .dynamic_state(&dynamic)
        .layout(drawing.layout)
        .render_pass(drawing.render_pass)
        .subpass(drawing.subpass);
    let modules = [drawing.vertex, drawing.fragment];
    let constants = list(drawing.constants);
    let files: Vec<_> = modules.iter().map(|module| module.file).collect();
    tracing::debug!("compiling {} [{constants}]", files.join("+"));
    // SAFETY: `info` and all it points to outlive the call; the pipeline is new.
    unsafe {
        let created = gpu
            .raw
            .create_graphics_pipelines(gpu.cache.raw(), &[info], None);
        let pipeline = created
            .map_err(|(_, result)| result)
            .during("vkCreateGraphicsPipelines")?[0];
        take_over(gpu, pipeline, drawing.name, &modules, &constants)
    }
}

/// A viewport for all depths, px.
pub(crate) fn viewport(x: f32, y: f32, width: f32, height: f32) -> vk::Viewport {
    vk::Viewport {
        x,
        y,
        width,
        height,
        min_depth: 0.0,
        max_depth: 1.0,
    }
}
