//! The render passes that draw quads, and their pipelines. In one the image is stored; in the other
//! a second subpass shows it, and on GPUs that blend in tile memory it never leaves that.

use super::{
    saturation::Saturation,
    target::{FINAL_LAYOUT, READER_SCOPE, READER_STAGES, vulkan_format},
};
use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass},
        recording::Recording,
    },
    memory::Scope,
    pipeline::{
        bindings::Bindings,
        graphics::{self, Attachment, DepthUse, PipelineDescription},
        shaders,
    },
};
use ash::vk::{self, AccessFlags, PipelineStageFlags, SubpassDependency};
use effigy_core::frame::{ColorFormat, RendererOptions, Skip};
use std::sync::Arc;

/// A render pass whose first subpass draws quads, and the pipelines for that subpass.
pub struct QuadPass {
    render_pass: RenderPass,
    /// Draws every fragment.
    pub(super) plain: Pipeline,
    /// None where no frame tests depth.
    pub(super) tested: Option<TestedPipelines>,
}

/// Pipelines of a frame that tests depth.
pub(super) struct TestedPipelines {
    /// Writes the saturation depth.
    pub depth: Pipeline,
    /// Draws the fragments that pass.
    pub quads: Pipeline,
}

/// A screen's image, to which quads go in the render pass that draws them.
pub struct OnePassTarget<'a> {
    pub(crate) pass: &'a QuadPass,
    /// Of that pass, around the image of the quads and that of the screen.
    pub(crate) framebuffer: &'a Framebuffer,
    /// Width and height of both, px.
    pub(crate) size: [u32; 2],
    /// Records the second subpass.
    pub(crate) show: Box<dyn Fn(Recording) + 'a>,
}

/// What pipelines of quads are made from.
pub(super) struct QuadParts<'a> {
    pub bindings: &'a Bindings,
    pub saturation: Option<&'a Saturation>,
    pub format: ColorFormat,
    /// Of the opacity under which nothing is drawn, and of the least that quads are large enough
    /// for.
    pub exponents: [f32; 2],
}

impl QuadPass {
    /// A render pass that stores the image in the layout [`FINAL_LAYOUT`]; or, with a `screen`, one
    /// whose second subpass reads each pixel of the image and writes that of the screen.
    pub(super) fn new(
        gpu: &Arc<Gpu>,
        parts: &QuadParts,
        screen: Option<Attachment>,
    ) -> Result<Self> {
        let render_pass = render_pass(gpu, parts, screen)?;
        let tested = |saturation| -> Result<_> {
            Ok(TestedPipelines {
                depth: Saturation::depth_pipeline(saturation, &render_pass)?,
                quads: pipeline(gpu, &render_pass, parts, Some(saturation))?,
            })
        };
        Ok(Self {
            plain: pipeline(gpu, &render_pass, parts, None)?,
            tested: parts.saturation.map(tested).transpose()?,
            render_pass,
        })
    }

    /// The render pass.
    pub(crate) fn render_pass(&self) -> &RenderPass {
        &self.render_pass
    }
}

/// The exponents of [`QuadParts`].
pub(super) fn exponents(options: &RendererOptions) -> [f32; 2] {
    let cutoff = options.cutoff.log2() as f32;
    let faint = options.skip.contains(Skip::FAINT);
    [cutoff, if faint { cutoff } else { 0.0 }]
}

/// What subpasses wait for, and what waits for them.
fn dependency(from: u32, to: u32, before: Scope, after: Scope) -> SubpassDependency {
    vk::SubpassDependency::default()
        .src_subpass(from)
        .dst_subpass(to)
        .src_stage_mask(before.stages)
        .src_access_mask(before.access)
        .dst_stage_mask(after.stages)
        .dst_access_mask(after.access)
}

fn render_pass(gpu: &Gpu, parts: &QuadParts, screen: Option<Attachment>) -> Result<RenderPass> {
    const OUTSIDE: u32 = vk::SUBPASS_EXTERNAL;
    let output = PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT;
    let tests = PipelineStageFlags::EARLY_FRAGMENT_TESTS | PipelineStageFlags::LATE_FRAGMENT_TESTS;
    let written = AccessFlags::COLOR_ATTACHMENT_WRITE;
    let blended = AccessFlags::COLOR_ATTACHMENT_READ | written;
    let depth_written = AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE;
    let depth_tested = AccessFlags::DEPTH_STENCIL_ATTACHMENT_READ | depth_written;
    let drawn = Scope::new(output, written);
    // The frame before may still be read.
    let before = Scope::new(READER_STAGES | output | tests, written | depth_written);
    let quads = Scope::new(output | tests, blended | depth_tested);
    let begins = dependency(OUTSIDE, 0, before, quads);
    let dependencies = if screen.is_some() {
        let read = Scope::new(
            PipelineStageFlags::FRAGMENT_SHADER,
            AccessFlags::INPUT_ATTACHMENT_READ,
        );
        vec![
            begins,
            // Each pixel waits for itself alone: that leaves the image in tile memory.
            dependency(0, 1, drawn, read).dependency_flags(vk::DependencyFlags::BY_REGION),
            // The submission waits for the screen at this stage.
            dependency(OUTSIDE, 1, drawn, Scope::new(output, blended)),
            // More may be drawn over it.
            dependency(1, OUTSIDE, drawn, Scope::new(output, blended)),
        ]
    } else {
        vec![begins, dependency(0, OUTSIDE, drawn, READER_SCOPE)]
    };
    let color = Attachment {
        format: vulkan_format(parts.format),
        load: vk::AttachmentLoadOp::CLEAR,
        initial_layout: if screen.is_some() {
            vk::ImageLayout::UNDEFINED
        } else {
            FINAL_LAYOUT
        },
        final_layout: screen.is_none().then_some(FINAL_LAYOUT),
    };
    let depth = parts.saturation.map(|_| graphics::depth());
    graphics::render_pass(gpu, "raster", color, depth, screen, &dependencies)
}

fn pipeline(
    gpu: &Arc<Gpu>,
    render_pass: &RenderPass,
    parts: &QuadParts,
    saturation: Option<&Saturation>,
) -> Result<Pipeline> {
    let [cutoff, quad] = parts.exponents.map(f32::to_bits);
    let own = [cutoff, quad, saturation.is_some().into()];
    let constants = match saturation {
        Some(saturation) => saturation.bins().constants(own).to_vec(),
        None => own.to_vec(),
    };
    let drawing = PipelineDescription {
        name: "raster",
        vertex: &shaders::QUADS_VERTEX,
        fragment: &shaders::QUADS_FRAGMENT,
        constants: &constants,
        layout: parts.bindings.layout(),
        render_pass: render_pass.raw(),
        subpass: 0,
        blend: graphics::over(),
        depth: match saturation {
            Some(_) => DepthUse::Test,
            None => DepthUse::Without,
        },
    };
    graphics::pipeline(gpu, drawing)
}
