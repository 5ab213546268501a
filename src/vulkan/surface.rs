//! The `surface` stage: what no one can see. The avatar's solid inside is drawn, seen from the camera, into a small depth image, and
//! reduced to a pyramid whose texels hold the furthest depth of what they cover: `splats` leaves out what lies behind that. `raster`
//! draws the same mesh first, so that hidden fragments of what is left fail the depth test.

use super::{
    device::Gpu,
    error::{During, Result},
    graphics::{self, Depth, Drawing},
    memory::{DEPTH_FORMAT, Image},
    model::OccluderMesh,
    pipeline::{Bindings, BoundImage, Kernel, Slice},
    shaders,
};
use crate::{
    frame::place::Place,
    layout::{SURFACE_DRAWN, SURFACE_FINEST, SURFACE_HEIGHT, SURFACE_WIDTH},
};
use ash::vk;
use std::sync::Arc;

/// Draws the mesh into one render pass.
pub struct SurfaceMesh {
    gpu: Arc<Gpu>,
    bindings: Bindings,
    pipeline: vk::Pipeline,
    indices: vk::Buffer,
    index_count: u32,
}

impl SurfaceMesh {
    /// `colored`: whether the render pass has a colour attachment, which is left alone.
    pub fn new(gpu: &Arc<Gpu>, frame: Slice, mesh: &OccluderMesh, pose: Slice, render_pass: vk::RenderPass, colored: bool) -> Result<Self> {
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::VERTEX, Some(frame), &[(&mesh.corners).into(), pose])?;
        bindings.label("surface");
        let nothing = vk::PipelineColorBlendAttachmentState::default().blend_enable(true).dst_color_blend_factor(vk::BlendFactor::ONE);
        let drawing = Drawing {
            name: "surface",
            vertex: &shaders::SURFACE_VERTEX,
            fragment: None,
            constants: &[],
            layout: bindings.layout,
            render_pass,
            blend: colored.then_some(nothing),
            depth: Depth::Write,
            cull: vk::CullModeFlags::BACK,
        };
        let pipeline = graphics::pipeline(gpu, drawing)?;
        Ok(Self { gpu: gpu.clone(), bindings, pipeline, indices: mesh.indices.raw, index_count: mesh.index_count })
    }

    /// Inside the render pass, viewport and scissor set.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32) {
        self.bindings.bind(commands, vk::PipelineBindPoint::GRAPHICS, frame);
        // SAFETY: the command buffer is recording inside the pipeline's render pass; pipeline and buffers are alive.
        unsafe {
            self.gpu.raw.cmd_bind_pipeline(commands, vk::PipelineBindPoint::GRAPHICS, self.pipeline);
            self.gpu.raw.cmd_bind_index_buffer(commands, self.indices, 0, vk::IndexType::UINT16);
            self.gpu.raw.cmd_draw_indexed(commands, self.index_count, 1, 0, 0, 0);
        }
    }
}

impl Drop for SurfaceMesh {
    fn drop(&mut self) {
        // SAFETY: owners drop a stage only when no submitted work uses it.
        self.gpu.destroy(|device| unsafe { device.destroy_pipeline(self.pipeline, None) });
    }
}

pub struct Surface {
    gpu: Arc<Gpu>,
    mesh: SurfaceMesh,
    pyramid: Kernel,
    pass: Pass,
    sampler: vk::Sampler,
    _image: Image,
}

/// The render pass and its one framebuffer.
struct Pass {
    gpu: Arc<Gpu>,
    render_pass: vk::RenderPass,
    framebuffer: vk::Framebuffer,
}

impl Drop for Pass {
    fn drop(&mut self) {
        // SAFETY: owners drop a stage only when no submitted work uses it. Destroying null handles does nothing.
        self.gpu.destroy(|device| unsafe {
            device.destroy_framebuffer(self.framebuffer, None);
            device.destroy_render_pass(self.render_pass, None);
        });
    }
}

impl Surface {
    /// Writes the pyramid to `pose`, from the word on that the frame says.
    pub fn new(gpu: &Arc<Gpu>, frame: Slice, mesh: &OccluderMesh, pose: Slice) -> Result<Self> {
        let usage = vk::ImageUsageFlags::DEPTH_STENCIL_ATTACHMENT | vk::ImageUsageFlags::SAMPLED;
        let image = Image::new(gpu, "surface", [SURFACE_DRAWN; 2], DEPTH_FORMAT, usage)?;
        let mut pass = Pass { gpu: gpu.clone(), render_pass: render_pass(gpu)?, framebuffer: vk::Framebuffer::null() };
        let views = [image.view];
        let info = vk::FramebufferCreateInfo::default().render_pass(pass.render_pass).attachments(&views);
        let info = info.width(SURFACE_DRAWN).height(SURFACE_DRAWN).layers(1);
        // SAFETY: `info` and all it points to outlive the call.
        pass.framebuffer = unsafe { gpu.raw.create_framebuffer(&info, None) }.during("vkCreateFramebuffer")?;
        gpu.name(pass.framebuffer, "surface");
        let mesh = SurfaceMesh::new(gpu, frame, mesh, pose, pass.render_pass, false)?;
        let bindings = Bindings::with_image(gpu, Some(frame), &[pose], BoundImage::Sampled)?;
        let pyramid = Kernel::new(gpu, &shaders::SURFACE, &[], bindings)?;
        // SAFETY: the structure outlives the call.
        let sampler = unsafe { gpu.raw.create_sampler(&vk::SamplerCreateInfo::default(), None) }.during("vkCreateSampler")?;
        gpu.name(sampler, "surface");
        pyramid.set_image(sampler, image.view);
        Ok(Self { gpu: gpu.clone(), mesh, pyramid, pass, sampler, _image: image })
    }

    /// Draws the mesh of each of `frames`, at least one, at `place`; graphics, then compute.
    pub fn record(&self, commands: vk::CommandBuffer, frames: &[u32], place: &Place) {
        let whole = vk::Rect2D { offset: vk::Offset2D::default(), extent: vk::Extent2D { width: SURFACE_DRAWN, height: SURFACE_DRAWN } };
        let clear = [vk::ClearValue { depth_stencil: vk::ClearDepthStencilValue { depth: 1.0, stencil: 0 } }];
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(self.pass.render_pass)
            .framebuffer(self.pass.framebuffer)
            .render_area(whole)
            .clear_values(&clear);
        let device = &self.gpu.raw;
        // SAFETY: the command buffer is recording, render pass and framebuffer are alive.
        unsafe {
            device.cmd_begin_render_pass(commands, &begin, vk::SubpassContents::INLINE);
            device.cmd_set_viewport(commands, 0, &[viewport(place)]);
            device.cmd_set_scissor(commands, 0, &[whole]);
            frames.iter().for_each(|&frame| self.mesh.record(commands, frame));
            device.cmd_end_render_pass(commands);
        }
        let groups = [SURFACE_FINEST / SURFACE_WIDTH, SURFACE_FINEST / SURFACE_HEIGHT];
        self.pyramid.dispatch_2d(commands, frames[0], groups);
    }
}

impl Drop for Surface {
    fn drop(&mut self) {
        // SAFETY: owners drop a stage only when no submitted work uses it.
        self.gpu.destroy(|device| unsafe { device.destroy_sampler(self.sampler, None) });
    }
}

fn viewport(place: &Place) -> vk::Viewport {
    let [at, size] = place.viewport();
    vk::Viewport { x: at.x, y: at.y, width: size.x, height: size.y, min_depth: 0.0, max_depth: 1.0 }
}

fn render_pass(gpu: &Gpu) -> Result<vk::RenderPass> {
    let tests = vk::PipelineStageFlags::EARLY_FRAGMENT_TESTS | vk::PipelineStageFlags::LATE_FRAGMENT_TESTS;
    let writes = vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_READ | vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE;
    let compute = vk::PipelineStageFlags::COMPUTE_SHADER;
    let dependencies = [
        // The frame before may still read its surface.
        vk::SubpassDependency::default()
            .src_subpass(vk::SUBPASS_EXTERNAL)
            .dst_subpass(0)
            .src_stage_mask(compute | tests)
            .src_access_mask(vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE)
            .dst_stage_mask(tests)
            .dst_access_mask(writes),
        vk::SubpassDependency::default()
            .src_subpass(0)
            .dst_subpass(vk::SUBPASS_EXTERNAL)
            .src_stage_mask(tests)
            .src_access_mask(vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE)
            .dst_stage_mask(compute)
            .dst_access_mask(vk::AccessFlags::SHADER_READ),
    ];
    graphics::render_pass(
        gpu,
        "surface",
        None,
        Some(graphics::depth(Some(vk::ImageLayout::DEPTH_STENCIL_READ_ONLY_OPTIMAL))),
        &dependencies,
    )
}
