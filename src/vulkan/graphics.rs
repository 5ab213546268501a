//! What the two drawing stages share: a render pass with one colour attachment, and a pipeline that draws triangles to it.

use super::{
    device::Gpu,
    error::{During, Result},
    pipeline::ShaderModule,
    shaders::Module,
};
use ash::vk;

/// The one colour attachment of a render pass: what it holds at the start, and how it is left for whoever reads it next.
pub(super) struct Attachment {
    pub format: vk::Format,
    pub load: vk::AttachmentLoadOp,
    pub left: vk::ImageLayout,
}

pub(super) fn render_pass(gpu: &Gpu, attachment: Attachment, dependencies: &[vk::SubpassDependency]) -> Result<vk::RenderPass> {
    let attachments = [vk::AttachmentDescription::default()
        .format(attachment.format)
        .samples(vk::SampleCountFlags::TYPE_1)
        .load_op(attachment.load)
        .store_op(vk::AttachmentStoreOp::STORE)
        .stencil_load_op(vk::AttachmentLoadOp::DONT_CARE)
        .stencil_store_op(vk::AttachmentStoreOp::DONT_CARE)
        .final_layout(attachment.left)];
    let color = [vk::AttachmentReference { attachment: 0, layout: vk::ImageLayout::COLOR_ATTACHMENT_OPTIMAL }];
    let subpasses = [vk::SubpassDescription::default().pipeline_bind_point(vk::PipelineBindPoint::GRAPHICS).color_attachments(&color)];
    let info = vk::RenderPassCreateInfo::default().attachments(&attachments).subpasses(&subpasses).dependencies(dependencies);
    // SAFETY: `info` and all it points to outlive the call.
    unsafe { gpu.raw.create_render_pass(&info, None) }.during("vkCreateRenderPass")
}

/// What a pipeline runs, and where it draws to.
pub(super) struct Drawing {
    pub name: &'static str,
    pub vertex: &'static Module,
    pub fragment: &'static Module,
    pub layout: vk::PipelineLayout,
    pub render_pass: vk::RenderPass,
    pub blend: vk::PipelineColorBlendAttachmentState,
}

/// Triangles of either winding, no vertex buffers, viewport and scissor set while recording.
pub(super) fn pipeline(gpu: &Gpu, drawing: Drawing) -> Result<vk::Pipeline> {
    let (vertex, fragment) = (ShaderModule::new(gpu, drawing.vertex)?, ShaderModule::new(gpu, drawing.fragment)?);
    let stage = |stage, module: &ShaderModule| vk::PipelineShaderStageCreateInfo::default().stage(stage).module(module.raw).name(c"main");
    let stages = [stage(vk::ShaderStageFlags::VERTEX, &vertex), stage(vk::ShaderStageFlags::FRAGMENT, &fragment)];
    let vertices = vk::PipelineVertexInputStateCreateInfo::default();
    let assembly = vk::PipelineInputAssemblyStateCreateInfo::default().topology(vk::PrimitiveTopology::TRIANGLE_LIST);
    let viewports = vk::PipelineViewportStateCreateInfo::default().viewport_count(1).scissor_count(1);
    let rasterization = vk::PipelineRasterizationStateCreateInfo::default().cull_mode(vk::CullModeFlags::NONE).line_width(1.0);
    let samples = vk::PipelineMultisampleStateCreateInfo::default().rasterization_samples(vk::SampleCountFlags::TYPE_1);
    let attachments = [drawing.blend.color_write_mask(vk::ColorComponentFlags::RGBA)];
    let blend = vk::PipelineColorBlendStateCreateInfo::default().attachments(&attachments);
    let dynamic = vk::PipelineDynamicStateCreateInfo::default().dynamic_states(&[vk::DynamicState::VIEWPORT, vk::DynamicState::SCISSOR]);
    let info = vk::GraphicsPipelineCreateInfo::default()
        .stages(&stages)
        .vertex_input_state(&vertices)
        .input_assembly_state(&assembly)
        .viewport_state(&viewports)
        .rasterization_state(&rasterization)
        .multisample_state(&samples)
        .color_blend_state(&blend)
        .dynamic_state(&dynamic)
        .layout(drawing.layout)
        .render_pass(drawing.render_pass);
    // SAFETY: `info` and all it points to outlive the call.
    let created = unsafe { gpu.raw.create_graphics_pipelines(gpu.cache.raw, &[info], None) };
    let pipeline = created.map_err(|(_, result)| result).during("vkCreateGraphicsPipelines")?[0];
    gpu.name(pipeline, drawing.name);
    Ok(pipeline)
}
