//! The graphics form of `raster`: one indirect draw of quads, blended far to near into an
//! off-screen image.

use super::{
    draw::{Draw, RasterInputs, rect},
    saturation::Saturation,
    target::{FINAL_LAYOUT, READER_SCOPE, READER_STAGES, check_size, forget, vulkan_format},
};
use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass},
        recording::Recording,
    },
    memory::{Buffer, DEPTH_FORMAT, Image, Replacement, Scope},
    pipeline::{
        bindings::Bindings,
        graphics::{self, Attachment, DepthUse, PipelineDescription},
        shaders,
    },
};
use ash::vk;
use effigy_core::{
    frame::{
        ColorFormat, RendererOptions, Skip, kernels, passes::RenderTarget, resource::Resource,
    },
    layout::QUADS_PER_INSTANCE,
};
use std::sync::Arc;

/// The image and the framebuffer around it; made anew when its size changes.
struct QuadTarget {
    framebuffer: Framebuffer,
    image: Image,
    /// Saturation depths, where fragments are tested; used within the render pass only.
    _depth: Option<Image>,
}

/// What draws the quads that are tested against the saturation depth.
struct DepthTest {
    saturation: Saturation,
    pipeline: Pipeline,
}

pub struct Quads {
    gpu: Arc<Gpu>,
    format: ColorFormat,
    /// Draws every fragment.
    pipeline: Pipeline,
    /// None where no frame tests depth.
    test: Option<Box<DepthTest>>,
    bindings: Bindings,
    indices: Buffer,
    target: QuadTarget,
    /// Where avatars are drawn larger than they are shown; None until a frame has one.
    atlas: Option<QuadTarget>,
    render_pass: RenderPass,
    /// The part of the target that is drawn, from its upper left corner, px.
    drawn: [u32; 2],
}

impl Quads {
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        inputs: &RasterInputs,
        options: &RendererOptions,
    ) -> Result<Self> {
        let format = options.color();
        let depth = options.skip.contains(Skip::DEPTH);
        let quad = |quad: u32| [0, 1, 2, 2, 1, 3].map(|corner| (4 * quad + corner) as u16);
        let indices: Vec<u16> = (0..QUADS_PER_INSTANCE).flat_map(quad).collect();
        let indices = Buffer::with_data(
            gpu,
            "quad indices",
            bytemuck::cast_slice(&indices),
            vk::BufferUsageFlags::INDEX_BUFFER,
        )?;
        let render_pass = render_pass(gpu, format, depth)?;
        let target = target(gpu, &render_pass, format, depth, options.size)?;
        let saturation = if depth {
            Some(Saturation::new(gpu, inputs, &render_pass, options)?)
        } else {
            None
        };
        // The shader has the binding of bins, whether it reads it or not.
        let memory = match &saturation {
            Some(saturation) => saturation.bins().add_to(&inputs.memory),
            None => {
                let unread = inputs.memory.slice(Resource::Order);
                inputs.memory.with(Resource::Bins, unread)
            }
        };
        let bindings = memory.bound(&kernels::QUADS_TESTED, |resources| {
            Bindings::new(gpu, "raster", vk::ShaderStageFlags::VERTEX, resources)
        })?;
        let layout = bindings.layout();
        let test = match saturation {
            Some(saturation) => Some(Box::new(DepthTest {
                pipeline: pipeline(gpu, &render_pass, layout, Some(&saturation), options)?,
                saturation,
            })),
            None => None,
        };
        Ok(Self {
            gpu: gpu.clone(),
            format,
            pipeline: pipeline(gpu, &render_pass, layout, None, options)?,
            test,
            bindings,
            indices,
            target,
            atlas: None,
            render_pass,
            drawn: options.size,
        })
    }

    /// Changes the image's size. On failure it stays.
    ///
    /// # Safety
    /// No submitted work may use the image.
    pub unsafe fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        let depth = self.test.is_some();
        let target = target(&self.gpu, &self.render_pass, self.format, depth, size)?;
        if let Some(test) = &mut self.test {
            // SAFETY: the caller promises that no work uses it.
            unsafe { test.saturation.resize(size) }?;
        }
        self.target = target;
        self.drawn = size;
        Ok(())
    }

    /// Makes an atlas of a size. On failure the one before stays.
    ///
    /// # Safety
    /// No submitted work may use the one before.
    pub unsafe fn make_atlas(&mut self, size: [u32; 2]) -> Result<()> {
        let depth = self.test.is_some();
        let atlas = target(&self.gpu, &self.render_pass, self.format, depth, size)?;
        self.atlas = Some(atlas);
        Ok(())
    }

    /// The atlas, if there is one.
    pub fn atlas(&self) -> Option<&Image> {
        self.atlas.as_ref().map(|atlas| &atlas.image)
    }

    pub fn draw_within(&mut self, size: [u32; 2]) {
        self.drawn = size;
    }

    /// Reads splats in the one buffer that it read in the other.
    ///
    /// # Safety
    /// No submitted work may draw with it, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        // SAFETY: the caller promises what the functions ask for.
        unsafe {
            self.bindings.replace(replacement);
            if let Some(test) = &mut self.test {
                test.saturation.replace(replacement);
            }
        }
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

    /// The stage that finds the saturation depths, if there is one.
    pub fn saturation(&self) -> Option<&Saturation> {
        self.test.as_ref().map(|test| &test.saturation)
    }

    /// Clears the damage rectangle, and draws the control's splats in what is drawn of it;
    /// graphics. `tested`: whether [`Self::saturation`] found this frame's depths.
    pub fn record(&self, commands: Recording, draw: &Draw, tested: bool) {
        let target = match (draw.target, &self.atlas) {
            (RenderTarget::Atlas, Some(atlas)) => atlas,
            _ => &self.target,
        };
        let [width, height] = draw.size;
        let area = draw.area();
        if draw.damage.whole {
            forget(commands, &target.image);
        }
        let viewport = graphics::viewport(0.0, 0.0, width as f32, height as f32);
        let clear = [vk::ClearValue::default(), graphics::FURTHEST];
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(self.render_pass.raw())
            .framebuffer(target.framebuffer.raw())
            .render_area(area)
            .clear_values(&clear);
        let device = &self.gpu.raw;
        let raw = commands.raw();
        let point = vk::PipelineBindPoint::GRAPHICS;
        // SAFETY: the command buffer is recording; every object is alive and fits the pipeline's
        // layout and the render pass. Viewport and scissor are set before anything is drawn.
        unsafe {
            device.cmd_begin_render_pass(raw, &begin, vk::SubpassContents::INLINE);
            device.cmd_set_viewport(raw, 0, &[viewport]);
            device.cmd_set_scissor(raw, 0, &[rect(draw.damage.drawn)]);
            let test = self.test.as_ref().filter(|_| tested);
            if let Some(test) = test {
                test.saturation.draw(commands);
            }
            let pipeline = test.map_or(&self.pipeline, |test| &test.pipeline);
            self.bindings.bind(commands, point, draw.frame);
            device.cmd_bind_pipeline(raw, point, pipeline.raw());
            device.cmd_bind_index_buffer(raw, self.indices.raw(), 0, vk::IndexType::UINT16);
            device.cmd_draw_indexed_indirect(raw, draw.control, 0, 1, 0);
            device.cmd_end_render_pass(raw);
        }
    }
}

fn target(
    gpu: &Arc<Gpu>,
    render_pass: &RenderPass,
    format: ColorFormat,
    depth: bool,
    size: [u32; 2],
) -> Result<QuadTarget> {
    let limits = &gpu.probe.limits;
    let limit = limits
        .max_image_dimension2_d
        .min(limits.max_framebuffer_width)
        .min(limits.max_framebuffer_height);
    check_size(gpu, size, limit)?;
    let usage = vk::ImageUsageFlags::COLOR_ATTACHMENT
        | vk::ImageUsageFlags::SAMPLED
        | vk::ImageUsageFlags::TRANSFER_SRC;
    let image = Image::new(gpu, "target", size, vulkan_format(format), usage)?;
    let mut views = vec![image.view()];
    let depth = if depth {
        let usage = vk::ImageUsageFlags::DEPTH_STENCIL_ATTACHMENT
            | vk::ImageUsageFlags::TRANSIENT_ATTACHMENT;
        let depth = Image::new(gpu, "target depth", size, DEPTH_FORMAT, usage)?;
        views.push(depth.view());
        Some(depth)
    } else {
        None
    };
    Ok(QuadTarget {
        framebuffer: Framebuffer::around(&gpu.device, render_pass, &views, size, "raster")?,
        image,
        _depth: depth,
    })
}

/// Clears the image, draws, and stores it in the layout [`FINAL_LAYOUT`].
fn render_pass(gpu: &Gpu, format: ColorFormat, depth_tested: bool) -> Result<RenderPass> {
    let writer = Scope::new(
        vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT,
        vk::AccessFlags::COLOR_ATTACHMENT_READ | vk::AccessFlags::COLOR_ATTACHMENT_WRITE,
    );
    let tests =
        vk::PipelineStageFlags::EARLY_FRAGMENT_TESTS | vk::PipelineStageFlags::LATE_FRAGMENT_TESTS;
    let depth = vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_READ
        | vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE;
    let dependencies = [
        // The frame before may still be read.
        vk::SubpassDependency::default()
            .src_subpass(vk::SUBPASS_EXTERNAL)
            .dst_subpass(0)
            .src_stage_mask(READER_STAGES | writer.stages | tests)
            .src_access_mask(
                vk::AccessFlags::COLOR_ATTACHMENT_WRITE
                    | vk::AccessFlags::DEPTH_STENCIL_ATTACHMENT_WRITE,
            )
            .dst_stage_mask(writer.stages | tests)
            .dst_access_mask(writer.access | depth),
        vk::SubpassDependency::default()
            .src_subpass(0)
            .dst_subpass(vk::SUBPASS_EXTERNAL)
            .src_stage_mask(writer.stages)
            .src_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE)
            .dst_stage_mask(READER_SCOPE.stages)
            .dst_access_mask(READER_SCOPE.access),
    ];
    let color = Attachment {
        format: vulkan_format(format),
        load: vk::AttachmentLoadOp::CLEAR,
        initial_layout: FINAL_LAYOUT,
        final_layout: Some(FINAL_LAYOUT),
    };
    graphics::render_pass(
        gpu,
        "raster",
        color,
        depth_tested.then(graphics::depth),
        &dependencies,
    )
}

fn pipeline(
    gpu: &Arc<Gpu>,
    render_pass: &RenderPass,
    layout: vk::PipelineLayout,
    saturation: Option<&Saturation>,
    options: &RendererOptions,
) -> Result<Pipeline> {
    let cutoff_exponent = options.cutoff.log2() as f32;
    let quad_exponent = if options.skip.contains(Skip::FAINT) {
        cutoff_exponent
    } else {
        0.0
    };
    let own = [
        cutoff_exponent.to_bits(),
        quad_exponent.to_bits(),
        saturation.is_some().into(),
    ];
    let constants = match saturation {
        Some(saturation) => saturation.bins().constants(own).to_vec(),
        None => own.to_vec(),
    };
    let drawing = PipelineDescription {
        name: "raster",
        vertex: &shaders::QUADS_VERTEX,
        fragment: &shaders::QUADS_FRAGMENT,
        constants: &constants,
        layout,
        render_pass: render_pass.raw(),
        blend: graphics::over(),
        depth: match saturation {
            Some(_) => DepthUse::Test,
            None => DepthUse::Without,
        },
    };
    graphics::pipeline(gpu, drawing)
}
