//! The `resolve` stage: avatars that were drawn larger than they are shown go in, each in its slot
//! of the atlas; they are averaged and blended into the frame's image. Avatars before what the
//! image holds go over it, the others behind it ([`effigy_core::frame::atlas`]).

use super::{
    draw::{Draw, rect},
    target::{FINAL_LAYOUT, READER_SCOPE, READER_STAGES, vulkan_format},
};
use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass, Sampler},
        recording::Recording,
    },
    memory::Image,
    pipeline::{
        graphics::{self, Attachment, DepthUse, PipelineDescription},
        set::Set,
        shaders,
    },
};
use ash::vk;
use bytemuck::{Pod, Zeroable, bytes_of};
use effigy_core::frame::{ColorFormat, atlas::AtlasSlot};
use std::sync::Arc;

const ATLAS: vk::DescriptorType = vk::DescriptorType::COMBINED_IMAGE_SAMPLER;

/// What `shaders/resolve` is told of a slot.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Pushed {
    /// Column and row in the image of the first pixel that the slot holds.
    shown: [i32; 2],
    /// Column and row in the atlas of its first texel.
    first: [i32; 2],
    /// Texels of the atlas in a pixel, each way.
    factor: f32,
}

/// What averages the atlas into the image.
pub struct Resolve {
    gpu: Arc<Gpu>,
    /// Blends a slot over what the image holds.
    over: Pipeline,
    /// Blends it behind that.
    behind: Pipeline,
    set: Set,
    sampler: Sampler,
    framebuffer: Framebuffer,
    /// Where the image holds something already.
    keeping: RenderPass,
    /// Where it does not.
    clearing: RenderPass,
}

impl Resolve {
    /// `image`: what it blends into; it must live as long as this, or until it gets another.
    pub fn new(gpu: &Arc<Gpu>, image: &Image, format: ColorFormat) -> Result<Self> {
        let stages = vk::ShaderStageFlags::FRAGMENT;
        let pushed = size_of::<Pushed>() as u32;
        let set = Set::new(gpu, "resolve", stages, &[(0, ATLAS)], pushed)?;
        let keeping = render_pass(gpu, format, vk::AttachmentLoadOp::LOAD)?;
        let layout = set.layouts.pipeline.raw();
        Ok(Self {
            gpu: gpu.clone(),
            over: pipeline(gpu, &keeping, layout, over())?,
            behind: pipeline(gpu, &keeping, layout, behind())?,
            sampler: Sampler::with(&gpu.device, &vk::SamplerCreateInfo::default(), "resolve")?,
            set,
            framebuffer: framebuffer(gpu, &keeping, image)?,
            clearing: render_pass(gpu, format, vk::AttachmentLoadOp::CLEAR)?,
            keeping,
        })
    }

    /// Averages this atlas from now on.
    ///
    /// # Safety
    /// No submitted work may use this. When it is recorded and done, the atlas must be alive and in
    /// `SHADER_READ_ONLY_OPTIMAL`.
    pub unsafe fn set_atlas(&self, atlas: &Image) {
        let info = [vk::DescriptorImageInfo {
            sampler: self.sampler.raw(),
            image_view: atlas.view(),
            image_layout: FINAL_LAYOUT,
        }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.set.raw)
            .dst_binding(0)
            .descriptor_type(ATLAS)
            .image_info(&info);
        // SAFETY: the set is not in use, and view and sampler are alive, as the caller promises.
        unsafe { self.gpu.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Averages slots into the image's damage rectangle, in their order; graphics. `clear`: whether
    /// the image holds nothing, which is cleared first.
    pub fn record(&self, commands: Recording, draw: &Draw, slots: &[AtlasSlot], clear: bool) {
        let [width, height] = draw.size;
        let area = draw.area();
        let render_pass = if clear { &self.clearing } else { &self.keeping };
        let cleared = [vk::ClearValue::default()];
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(render_pass.raw())
            .framebuffer(self.framebuffer.raw())
            .render_area(area)
            .clear_values(&cleared);
        let device = &self.gpu.raw;
        let raw = commands.raw();
        let point = vk::PipelineBindPoint::GRAPHICS;
        let layout = self.set.layouts.pipeline.raw();
        let stages = vk::ShaderStageFlags::FRAGMENT;
        let viewport = graphics::viewport(0.0, 0.0, width as f32, height as f32);
        // SAFETY: the command buffer is recording; every object is alive and fits the pipelines'
        // layout and the render pass. Viewport and scissor are set before each draw.
        unsafe {
            device.cmd_begin_render_pass(raw, &begin, vk::SubpassContents::INLINE);
            device.cmd_set_viewport(raw, 0, &[viewport]);
            device.cmd_bind_descriptor_sets(raw, point, layout, 0, &[self.set.raw], &[]);
            for slot in slots {
                let shown = slot.shown(draw.size).intersection(draw.damage.drawn);
                if shown.is_empty() {
                    continue;
                }
                let pipeline = if slot.behind {
                    &self.behind
                } else {
                    &self.over
                };
                let pushed = Pushed {
                    shown: slot.around.min.into(),
                    first: slot.at.as_ivec2().into(),
                    factor: slot.factor as f32,
                };
                device.cmd_bind_pipeline(raw, point, pipeline.raw());
                device.cmd_push_constants(raw, layout, stages, 0, bytes_of(&pushed));
                device.cmd_set_scissor(raw, 0, &[rect(shown)]);
                device.cmd_draw(raw, 3, 1, 0, 0);
            }
            device.cmd_end_render_pass(raw);
        }
    }
}

/// Premultiplied "over": C = c + (1 − α) C.
fn over() -> vk::PipelineColorBlendAttachmentState {
    blend(vk::BlendFactor::ONE, vk::BlendFactor::ONE_MINUS_SRC_ALPHA)
}

/// What is drawn goes behind what is there: C = (1 − A) c + C.
fn behind() -> vk::PipelineColorBlendAttachmentState {
    blend(vk::BlendFactor::ONE_MINUS_DST_ALPHA, vk::BlendFactor::ONE)
}

fn blend(
    source: vk::BlendFactor,
    destination: vk::BlendFactor,
) -> vk::PipelineColorBlendAttachmentState {
    vk::PipelineColorBlendAttachmentState::default()
        .blend_enable(true)
        .src_color_blend_factor(source)
        .dst_color_blend_factor(destination)
        .src_alpha_blend_factor(source)
        .dst_alpha_blend_factor(destination)
}

fn framebuffer(gpu: &Gpu, render_pass: &RenderPass, image: &Image) -> Result<Framebuffer> {
    let views = [image.view()];
    Framebuffer::around(&gpu.device, render_pass, &views, image.size(), "resolve")
}

/// Blends into the image, and leaves it in [`FINAL_LAYOUT`]. Render passes that differ in `load`
/// alone are compatible.
fn render_pass(gpu: &Gpu, format: ColorFormat, load: vk::AttachmentLoadOp) -> Result<RenderPass> {
    let output = vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT;
    let write = vk::AccessFlags::COLOR_ATTACHMENT_WRITE;
    let dependencies = [
        // The image was drawn, or the frame before is still read.
        vk::SubpassDependency::default()
            .src_subpass(vk::SUBPASS_EXTERNAL)
            .dst_subpass(0)
            .src_stage_mask(READER_STAGES | output)
            .src_access_mask(write)
            .dst_stage_mask(output)
            .dst_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_READ | write),
        vk::SubpassDependency::default()
            .src_subpass(0)
            .dst_subpass(vk::SUBPASS_EXTERNAL)
            .src_stage_mask(output)
            .src_access_mask(write)
            .dst_stage_mask(READER_SCOPE.stages)
            .dst_access_mask(READER_SCOPE.access),
    ];
    let color = Attachment {
        format: vulkan_format(format),
        load,
        initial_layout: FINAL_LAYOUT,
        final_layout: Some(FINAL_LAYOUT),
    };
    graphics::render_pass(gpu, "resolve", color, None, None, &dependencies)
}

fn pipeline(
    gpu: &Arc<Gpu>,
    render_pass: &RenderPass,
    layout: vk::PipelineLayout,
    blend: vk::PipelineColorBlendAttachmentState,
) -> Result<Pipeline> {
    let drawing = PipelineDescription {
        name: "resolve",
        vertex: &shaders::PRESENT_VERTEX,
        fragment: &shaders::RESOLVE_FRAGMENT,
        constants: &[],
        layout,
        render_pass: render_pass.raw(),
        subpass: 0,
        blend,
        depth: DepthUse::Without,
    };
    graphics::pipeline(gpu, drawing)
}
