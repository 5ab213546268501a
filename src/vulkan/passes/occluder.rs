//! The `occluder` stage: finds what the avatar itself hides. The occluder mesh is drawn from the
//! camera into a small depth image, which is reduced to a pyramid: each texel holds the furthest
//! depth of the pixels under it. `project` culls Gaussians behind that depth.

use super::model::OccluderMesh;
use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass, Sampler},
        recording::Recording,
    },
    memory::{DEPTH_FORMAT, Image, Slice},
    pipeline::{
        BoundImage, Kernel, Launch, Resources,
        bindings::Bindings,
        graphics::{self, Depth, Drawing},
        shaders,
    },
};
use ash::vk;
use effigy_core::{
    layout::{OCCLUDER_SIDE, PYRAMID_SIDE, PYRAMID_WORKGROUP_HEIGHT, PYRAMID_WORKGROUP_WIDTH},
    scene::occluder_view::OccluderView,
};
use std::sync::Arc;

/// Draws the occluder mesh in one render pass.
struct OccluderDraw {
    gpu: Arc<Gpu>,
    bindings: Bindings,
    pipeline: Pipeline,
    indices: vk::Buffer,
    index_count: u32,
}

impl OccluderDraw {
    fn new(
        gpu: &Arc<Gpu>,
        frame: Slice,
        mesh: &OccluderMesh,
        pose: Slice,
        render_pass: &RenderPass,
    ) -> Result<Self> {
        let resources = Resources {
            uniform: Some(frame),
            storage: &[(&mesh.corners).into(), pose],
            image: None,
        };
        let bindings = Bindings::new(gpu, "occluder", vk::ShaderStageFlags::VERTEX, resources)?;
        let drawing = Drawing {
            name: "occluder",
            vertex: &shaders::OCCLUDER_DEPTH,
            fragment: None,
            constants: &[],
            layout: bindings.layout(),
            render_pass: render_pass.raw(),
            blend: None,
            depth: Depth::Write,
            cull: vk::CullModeFlags::BACK,
        };
        let pipeline = graphics::pipeline(gpu, drawing)?;
        Ok(Self {
            gpu: gpu.clone(),
            bindings,
            pipeline,
            indices: mesh.indices.raw(),
            index_count: mesh.index_count,
        })
    }

    /// Draws the mesh of the avatar whose uniform block is at `frame`, bytes.
    ///
    /// # Safety
    /// The commands must be inside the render pass, with viewport and scissor set.
    unsafe fn record(&self, commands: Recording, frame: u32) {
        let point = vk::PipelineBindPoint::GRAPHICS;
        self.bindings.bind(commands, point, frame);
        let device = &self.gpu.raw;
        let raw = commands.raw();
        // SAFETY: the command buffer is recording inside the pipeline's render pass, as the caller
        // promises; pipeline and buffers are alive.
        unsafe {
            device.cmd_bind_pipeline(raw, point, self.pipeline.raw());
            device.cmd_bind_index_buffer(raw, self.indices, 0, vk::IndexType::UINT16);
            device.cmd_draw_indexed(raw, self.index_count, 1, 0, 0, 0);
        }
    }
}

/// The depth image, the render pass that draws it, and the kernel that makes the pyramid of it.
pub struct OccluderPass {
    gpu: Arc<Gpu>,
    mesh: OccluderDraw,
    pyramid: Kernel,
    _sampler: Sampler,
    framebuffer: Framebuffer,
    render_pass: RenderPass,
    _image: Image,
}

impl OccluderPass {
    /// Writes the pyramid to `pose`, from the word on that the frame says.
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        frame: Slice,
        mesh: &OccluderMesh,
        pose: Slice,
    ) -> Result<Self> {
        let device = &gpu.device;
        let usage = vk::ImageUsageFlags::DEPTH_STENCIL_ATTACHMENT | vk::ImageUsageFlags::SAMPLED;
        let size = [OCCLUDER_SIDE; 2];
        let image = Image::new(gpu, "occluder", size, DEPTH_FORMAT, usage)?;
        let render_pass = render_pass(gpu)?;
        let framebuffer =
            Framebuffer::around(device, &render_pass, &[image.view()], size, "occluder")?;
        let mesh = OccluderDraw::new(gpu, frame, mesh, pose, &render_pass)?;
        let resources = Resources {
            uniform: Some(frame),
            storage: &[pose],
            image: Some(BoundImage::Sampled),
        };
        let pyramid = Kernel::new(
            gpu,
            &shaders::OCCLUDER_PYRAMID,
            &[],
            resources,
            Launch::default(),
        )?;
        let sampler = Sampler::with(device, &vk::SamplerCreateInfo::default(), "occluder")?;
        // SAFETY: nothing uses the kernel yet. The render pass leaves the image in the layout that
        // the kernel reads; image and sampler live as long as it.
        unsafe { pyramid.set_image(sampler.raw(), image.view()) };
        Ok(Self {
            gpu: gpu.clone(),
            mesh,
            pyramid,
            _sampler: sampler,
            framebuffer,
            render_pass,
            _image: image,
        })
    }

    /// Draws the mesh of each of `frames`, at least one, in `view`; graphics, then compute.
    pub fn record(&self, commands: Recording, frames: &[u32], view: &OccluderView) {
        let whole = vk::Rect2D {
            offset: vk::Offset2D::default(),
            extent: vk::Extent2D {
                width: OCCLUDER_SIDE,
                height: OCCLUDER_SIDE,
            },
        };
        let clear = [graphics::FURTHEST];
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(self.render_pass.raw())
            .framebuffer(self.framebuffer.raw())
            .render_area(whole)
            .clear_values(&clear);
        let device = &self.gpu.raw;
        let raw = commands.raw();
        let [at, size] = view.viewport();
        let viewport = graphics::viewport(at.x, at.y, size.x, size.y);
        // SAFETY: the command buffer is recording, render pass and framebuffer are alive; viewport
        // and scissor are set before the mesh is drawn.
        unsafe {
            device.cmd_begin_render_pass(raw, &begin, vk::SubpassContents::INLINE);
            device.cmd_set_viewport(raw, 0, &[viewport]);
            device.cmd_set_scissor(raw, 0, &[whole]);
            for &frame in frames {
                self.mesh.record(commands, frame);
            }
            device.cmd_end_render_pass(raw);
        }
        let groups = [
            PYRAMID_SIDE / PYRAMID_WORKGROUP_WIDTH,
            PYRAMID_SIDE / PYRAMID_WORKGROUP_HEIGHT,
        ];
        self.pyramid.dispatch_2d(commands, frames[0], groups);
    }
}

fn render_pass(gpu: &Gpu) -> Result<RenderPass> {
    let tests =
        vk::PipelineStageFlags::EARLY_FRAGMENT_TESTS | vk::PipelineStageFlags::LATE_FRAGMENT_TESTS;
    let writes = vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_READ
        | vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE;
    let compute = vk::PipelineStageFlags::COMPUTE_SHADER;
    let dependencies = [
        // The frame before may still read the depth image.
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
    let read = vk::ImageLayout::DEPTH_STENCIL_READ_ONLY_OPTIMAL;
    let depth = graphics::depth(Some(read));
    graphics::render_pass(gpu, "occluder", None, Some(depth), &dependencies)
}
