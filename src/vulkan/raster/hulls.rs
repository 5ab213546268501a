//! The graphics form of `raster`: one indirect draw of quads, blended far to near into an off-screen image.

use super::{ColorFormat, LEFT, Method, Touched, check_size, hand_over};
use crate::{
    frame::Skip,
    layout::RASTER_QUADS,
    vulkan::{
        RendererOptions,
        device::Gpu,
        error::{During, Error, Result},
        graphics::{self, Attachment, Depth, Drawing},
        memory::{Buffer, DEPTH_FORMAT, Image},
        model::OccluderMesh,
        pipeline::{Bindings, Slice},
        shaders,
        surface::SurfaceMesh,
    },
};
use ash::vk;
use std::sync::Arc;

/// The image and the framebuffer around it; made anew when the picture's size changes.
struct Target {
    gpu: Arc<Gpu>,
    image: Image,
    /// Where fragments are tested: what is in front of the avatar's solid inside, used within the render pass only.
    _depth: Option<Image>,
    framebuffer: vk::Framebuffer,
}

impl Drop for Target {
    fn drop(&mut self) {
        // SAFETY: owners drop a target only when no submitted work uses it.
        self.gpu.destroy(|device| unsafe { device.destroy_framebuffer(self.framebuffer, None) });
    }
}

pub struct Hulls {
    gpu: Arc<Gpu>,
    format: ColorFormat,
    render_pass: vk::RenderPass,
    pipeline: vk::Pipeline,
    bindings: Bindings,
    indices: Buffer,
    /// Where fragments are tested against it.
    surface: Option<SurfaceMesh>,
    target: Target,
    /// The part of the target that is drawn, from its upper left corner, px.
    drawn: [u32; 2],
}

impl Hulls {
    /// `order`, `splats` with their keys, and `control` as the stages before leave them.
    pub fn new(
        gpu: &Arc<Gpu>,
        frame: Slice,
        inputs: [Slice; 3],
        (mesh, pose): (&OccluderMesh, Slice),
        options: &RendererOptions,
    ) -> Result<Self> {
        let (format, size, depth) = (options.color.unwrap_or(Method::Hulls.color()), options.size, options.skip.contains(Skip::DEPTH));
        let stages = vk::ShaderStageFlags::VERTEX;
        let bindings = Bindings::new(gpu, stages, Some(frame), &inputs)?;
        bindings.label("raster");
        let quad = |quad: u32| [0, 1, 2, 2, 1, 3].map(|corner| (4 * quad + corner) as u16);
        let indices: Vec<u16> = (0..RASTER_QUADS).flat_map(quad).collect();
        let indices = Buffer::with_data(gpu, "quad indices", bytemuck::cast_slice(&indices), vk::BufferUsageFlags::INDEX_BUFFER)?;
        let render_pass = render_pass(gpu, format, depth)?;
        let target = Self::target(gpu, render_pass, format, depth, size);
        let pipeline = pipeline(gpu, render_pass, bindings.layout, options);
        let surface = depth.then(|| SurfaceMesh::new(gpu, frame, mesh, pose, render_pass, true)).transpose();
        match (target, pipeline, surface) {
            (Ok(target), Ok(pipeline), Ok(surface)) => {
                Ok(Self { gpu: gpu.clone(), format, render_pass, pipeline, bindings, indices, surface, target, drawn: size })
            }
            (target, pipeline, surface) => {
                // SAFETY: nothing was submitted that uses either.
                unsafe {
                    gpu.raw.destroy_pipeline(pipeline.as_ref().copied().unwrap_or_default(), None);
                    gpu.raw.destroy_render_pass(render_pass, None);
                }
                target
                    .map(|_| ())
                    .and(pipeline.map(|_| ()))
                    .and(surface.map(|_| ()))
                    .and_then(|()| Err(Error::Call { call: "vkCreateGraphicsPipelines", result: vk::Result::ERROR_UNKNOWN }))
            }
        }
    }

    fn target(gpu: &Arc<Gpu>, render_pass: vk::RenderPass, format: ColorFormat, depth: bool, size: [u32; 2]) -> Result<Target> {
        let limits = &gpu.probe.limits;
        let limit = limits.max_image_dimension2_d.min(limits.max_framebuffer_width).min(limits.max_framebuffer_height);
        check_size(gpu, size, limit)?;
        let usage = vk::ImageUsageFlags::COLOR_ATTACHMENT | vk::ImageUsageFlags::SAMPLED | vk::ImageUsageFlags::TRANSFER_SRC;
        let image = Image::new(gpu, "target", size, format.vulkan(), usage)?;
        let usage = vk::ImageUsageFlags::DEPTH_STENCIL_ATTACHMENT | vk::ImageUsageFlags::TRANSIENT_ATTACHMENT;
        let depth = depth.then(|| Image::new(gpu, "target depth", size, DEPTH_FORMAT, usage)).transpose()?;
        let views: Vec<_> = std::iter::once(&image).chain(&depth).map(|image| image.view).collect();
        let info =
            vk::FramebufferCreateInfo::default().render_pass(render_pass).attachments(&views).width(size[0]).height(size[1]).layers(1);
        // SAFETY: `info` and all it points to outlive the call.
        let framebuffer = unsafe { gpu.raw.create_framebuffer(&info, None) }.during("vkCreateFramebuffer")?;
        gpu.name(framebuffer, "raster");
        Ok(Target { gpu: gpu.clone(), image, _depth: depth, framebuffer })
    }

    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.target = Self::target(&self.gpu, self.render_pass, self.format, self.surface.is_some(), size)?;
        self.drawn = size;
        Ok(())
    }

    pub fn draw_within(&mut self, size: [u32; 2]) {
        self.drawn = size;
    }

    /// Changes the cutoff to that of `options`, which are otherwise those that it was made with. No submitted frame may still draw.
    pub fn set_cutoff(&mut self, options: &RendererOptions) -> Result<()> {
        let new = pipeline(&self.gpu, self.render_pass, self.bindings.layout, options)?;
        let old = std::mem::replace(&mut self.pipeline, new);
        // SAFETY: the caller promises that no submitted work uses it.
        unsafe { self.gpu.raw.destroy_pipeline(old, None) };
        Ok(())
    }

    pub fn image(&self) -> &Image {
        &self.target.image
    }

    pub fn drawn(&self) -> [u32; 2] {
        self.drawn
    }

    pub fn format(&self) -> ColorFormat {
        self.format
    }

    /// Clears what of the picture is to be drawn, and draws there what `control` says; graphics. `surfaces`: the blocks of those whose depth
    /// surface is drawn first, where fragments are tested against it at all.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32, control: vk::Buffer, surfaces: &[u32], touched: &Touched) {
        let [width, height] = self.drawn;
        let ([x, y], [right, bottom]) = (touched.min, touched.max);
        let area =
            vk::Rect2D { offset: vk::Offset2D { x: x as i32, y: y as i32 }, extent: vk::Extent2D { width: right - x, height: bottom - y } };
        if touched.anew {
            let readers = vk::PipelineStageFlags::FRAGMENT_SHADER | vk::PipelineStageFlags::TRANSFER;
            let write = vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT;
            let scopes = [(readers | write, vk::AccessFlags::COLOR_ATTACHMENT_WRITE), (write, vk::AccessFlags::COLOR_ATTACHMENT_WRITE)];
            hand_over(&self.gpu, commands, &self.target.image, scopes, [vk::ImageLayout::UNDEFINED, LEFT]);
        }
        let viewport = vk::Viewport { x: 0.0, y: 0.0, width: width as f32, height: height as f32, min_depth: 0.0, max_depth: 1.0 };
        let depth = vk::ClearDepthStencilValue { depth: 1.0, stencil: 0 };
        let clear = [vk::ClearValue::default(), vk::ClearValue { depth_stencil: depth }];
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(self.render_pass)
            .framebuffer(self.target.framebuffer)
            .render_area(area)
            .clear_values(&clear);
        let device = &self.gpu.raw;
        // SAFETY: the command buffer is recording; every object is alive and fits the pipeline's layout and the render pass.
        unsafe {
            device.cmd_begin_render_pass(commands, &begin, vk::SubpassContents::INLINE);
            device.cmd_set_viewport(commands, 0, &[viewport]);
            device.cmd_set_scissor(commands, 0, &[area]);
            surfaces.iter().zip(self.surface.iter().cycle()).for_each(|(&frame, mesh)| mesh.record(commands, frame));
            self.bindings.bind(commands, vk::PipelineBindPoint::GRAPHICS, frame);
            device.cmd_bind_pipeline(commands, vk::PipelineBindPoint::GRAPHICS, self.pipeline);
            device.cmd_bind_index_buffer(commands, self.indices.raw, 0, vk::IndexType::UINT16);
            device.cmd_draw_indexed_indirect(commands, control, 0, 1, 0);
            device.cmd_end_render_pass(commands);
        }
    }
}

impl Drop for Hulls {
    fn drop(&mut self) {
        // SAFETY: owners drop a stage only when no submitted work uses it.
        self.gpu.destroy(|device| unsafe {
            device.destroy_pipeline(self.pipeline, None);
            device.destroy_render_pass(self.render_pass, None);
        });
    }
}

/// Cleared, drawn and kept for whoever reads it next.
fn render_pass(gpu: &Gpu, format: ColorFormat, depth_tested: bool) -> Result<vk::RenderPass> {
    let readers = vk::PipelineStageFlags::FRAGMENT_SHADER | vk::PipelineStageFlags::TRANSFER;
    let writer =
        (vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT, vk::AccessFlags::COLOR_ATTACHMENT_READ | vk::AccessFlags::COLOR_ATTACHMENT_WRITE);
    let tests = vk::PipelineStageFlags::EARLY_FRAGMENT_TESTS | vk::PipelineStageFlags::LATE_FRAGMENT_TESTS;
    let depth = vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_READ | vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE;
    let dependencies = [
        // The frame before may still be read.
        vk::SubpassDependency::default()
            .src_subpass(vk::SUBPASS_EXTERNAL)
            .dst_subpass(0)
            .src_stage_mask(readers | writer.0 | tests)
            .src_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE | vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE)
            .dst_stage_mask(writer.0 | tests)
            .dst_access_mask(writer.1 | depth),
        vk::SubpassDependency::default()
            .src_subpass(0)
            .dst_subpass(vk::SUBPASS_EXTERNAL)
            .src_stage_mask(writer.0)
            .src_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE)
            .dst_stage_mask(readers)
            .dst_access_mask(vk::AccessFlags::SHADER_READ | vk::AccessFlags::TRANSFER_READ),
    ];
    let color = Attachment { format: format.vulkan(), load: vk::AttachmentLoadOp::CLEAR, found: LEFT, left: Some(LEFT) };
    graphics::render_pass(gpu, "raster", Some(color), depth_tested.then(|| graphics::depth(None)), &dependencies)
}

fn pipeline(gpu: &Gpu, render_pass: vk::RenderPass, layout: vk::PipelineLayout, options: &RendererOptions) -> Result<vk::Pipeline> {
    // "Over": C = αc + (1 − α) C, and coverage likewise, which leaves the picture premultiplied. The fragment's colour is not, so that a
    // blender that rounds uses one rounded alpha for both terms.
    let over = vk::PipelineColorBlendAttachmentState::default()
        .blend_enable(true)
        .src_color_blend_factor(vk::BlendFactor::SRC_ALPHA)
        .dst_color_blend_factor(vk::BlendFactor::ONE_MINUS_SRC_ALPHA)
        .src_alpha_blend_factor(vk::BlendFactor::ONE)
        .dst_alpha_blend_factor(vk::BlendFactor::ONE_MINUS_SRC_ALPHA);
    let least = options.cutoff.log2() as f32;
    let hull = if options.skip.contains(Skip::FAINT) { least } else { 0.0 };
    let tested = options.skip.contains(Skip::DEPTH);
    let drawing = Drawing {
        name: "raster",
        vertex: &shaders::RASTER_VERTEX,
        fragment: Some(&shaders::RASTER_FRAGMENT),
        constants: &[least.to_bits(), hull.to_bits(), tested.into()],
        layout,
        render_pass,
        blend: Some(over),
        depth: if tested { Depth::Test } else { Depth::Without },
        cull: vk::CullModeFlags::NONE,
    };
    graphics::pipeline(gpu, drawing)
}
