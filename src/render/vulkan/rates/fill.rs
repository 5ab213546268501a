//! Layers of quads that cover an image.

use crate::vulkan::{
    commands::{RunTimes, Stopwatch},
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass},
        recording::Recording,
    },
    memory::{DEPTH_FORMAT, Image, image_bytes},
    pipeline::{
        Resources,
        bindings::Bindings,
        graphics::{self, Attachment, DepthUse, PipelineDescription},
        shaders,
    },
    raster::{
        ColorFormat,
        target::{check_size, vulkan_format},
    },
};
use ash::vk;
use std::sync::Arc;

/// Most layers of one draw: their depths differ in 16 bits.
pub const MOST_LAYERS: u32 = 1 << 12;

/// Side of the small quads, px: a typical splat of a body that fills the image.
const QUAD_SIDE: u32 = 16;
/// Exponent of the opacity at a small quad's edge: that of 1/255.
const EDGE_EXPONENT: f32 = -7.994_353;

/// The order that layers are drawn in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FillOrder {
    /// The furthest first. Every fragment shows, until the next layer covers it.
    BackToFront,
    /// The nearest first. Without blending the depth test rejects all layers but the first.
    FrontToBack,
}

/// What a layer is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FillShape {
    /// One quad over the whole image.
    Whole,
    /// Quads of 16 px, side by side.
    Quads,
    /// Gaussians in quads of 16 px: an exponential, and a discard outside of their ellipse.
    Gaussians,
}

/// What an image is filled with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filling {
    /// Format of the image.
    pub format: ColorFormat,
    /// Whether layers are blended; if not they are opaque, and tested against the depth.
    pub blended: bool,
    /// The order of the layers.
    pub order: FillOrder,
    /// What a layer is made of.
    pub shape: FillShape,
}

/// An image, and what fills it.
pub struct Fill {
    gpu: Arc<Gpu>,
    filling: Filling,
    columns: u32,
    rows: u32,
    pipeline: Pipeline,
    bindings: Bindings,
    framebuffer: Framebuffer,
    render_pass: RenderPass,
    image: Image,
    /// Where layers are opaque.
    _depth: Option<Image>,
    stopwatch: Stopwatch,
}

/// The layout that the render pass leaves the image in.
const FINAL_LAYOUT: vk::ImageLayout = vk::ImageLayout::TRANSFER_SRC_OPTIMAL;

impl Fill {
    /// `size`: width and height of the image, px. `opacity`: of every layer where it is blended, 0
    /// to 1.
    ///
    /// # Errors
    /// When the device can't have such an image, or its driver crashes when it draws triangles.
    pub fn new(gpu: &Arc<Gpu>, filling: Filling, size: [u32; 2], opacity: f32) -> Result<Self> {
        let limits = &gpu.probe.limits;
        let limit = limits
            .max_image_dimension2_d
            .min(limits.max_framebuffer_width)
            .min(limits.max_framebuffer_height);
        check_size(gpu, size, limit)?;
        let format = vulkan_format(filling.format);
        let usage = vk::ImageUsageFlags::COLOR_ATTACHMENT | vk::ImageUsageFlags::TRANSFER_SRC;
        let image = Image::new(gpu, "filled", size, format, usage)?;
        let mut views = vec![image.view()];
        let depth = if filling.blended {
            None
        } else {
            let usage = vk::ImageUsageFlags::DEPTH_STENCIL_ATTACHMENT
                | vk::ImageUsageFlags::TRANSIENT_ATTACHMENT;
            let depth = Image::new(gpu, "filled depth", size, DEPTH_FORMAT, usage)?;
            views.push(depth.view());
            Some(depth)
        };
        let color = Attachment {
            format,
            load: vk::AttachmentLoadOp::CLEAR,
            initial_layout: vk::ImageLayout::UNDEFINED,
            final_layout: Some(FINAL_LAYOUT),
        };
        let depth_attachment = depth.is_some().then(graphics::depth);
        let render_pass = graphics::render_pass(gpu, "fill", color, depth_attachment, None, &[])?;
        let bindings = Bindings::new(
            gpu,
            "fill",
            vk::ShaderStageFlags::VERTEX,
            Resources::default(),
        )?;
        let [columns, rows] = match filling.shape {
            FillShape::Whole => [1, 1],
            FillShape::Quads | FillShape::Gaussians => size.map(|side| side.div_ceil(QUAD_SIDE)),
        };
        let cutoff = match filling.shape {
            FillShape::Gaussians => EDGE_EXPONENT,
            FillShape::Whole | FillShape::Quads => 0.0,
        };
        let drawing = PipelineDescription {
            name: "fill",
            vertex: &shaders::RATES_FILL_VERTEX,
            fragment: &shaders::RATES_FILL_FRAGMENT,
            constants: &[
                columns,
                rows,
                MOST_LAYERS,
                (filling.order == FillOrder::FrontToBack).into(),
                cutoff.to_bits(),
                if filling.blended { opacity } else { 1.0 }.to_bits(),
            ],
            layout: bindings.layout(),
            render_pass: render_pass.raw(),
            subpass: 0,
            blend: blend(filling),
            depth: if filling.blended {
                DepthUse::Without
            } else {
                DepthUse::Write
            },
        };
        Ok(Self {
            gpu: gpu.clone(),
            filling,
            columns,
            rows,
            pipeline: graphics::pipeline(gpu, drawing)?,
            framebuffer: Framebuffer::around(&gpu.device, &render_pass, &views, size, "fill")?,
            render_pass,
            bindings,
            image,
            _depth: depth,
            stopwatch: Stopwatch::new(gpu, "fill")?,
        })
    }

    /// What it fills the image with.
    pub fn filling(&self) -> Filling {
        self.filling
    }

    /// Clears the image and draws so many layers, at most [`MOST_LAYERS`].
    pub fn time(&self, layers: u32) -> Result<RunTimes> {
        let nothing = |_: Recording| ();
        self.stopwatch
            .time("filling an image", nothing, |commands| {
                self.record(commands, layers.min(MOST_LAYERS));
            })
    }

    fn record(&self, commands: Recording, layers: u32) {
        let [width, height] = self.image.size();
        let area = vk::Rect2D {
            offset: vk::Offset2D::default(),
            extent: vk::Extent2D { width, height },
        };
        let clear = [vk::ClearValue::default(), graphics::FURTHEST];
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(self.render_pass.raw())
            .framebuffer(self.framebuffer.raw())
            .render_area(area)
            .clear_values(&clear);
        let viewport = graphics::viewport(0.0, 0.0, width as f32, height as f32);
        let device = &self.gpu.raw;
        let raw = commands.raw();
        let point = vk::PipelineBindPoint::GRAPHICS;
        // SAFETY: the command buffer is recording; every object is alive until the stopwatch has
        // waited, and fits the pipeline's layout and the render pass. Viewport and scissor are set
        // before anything is drawn.
        unsafe {
            device.cmd_begin_render_pass(raw, &begin, vk::SubpassContents::INLINE);
            device.cmd_set_viewport(raw, 0, &[viewport]);
            device.cmd_set_scissor(raw, 0, &[area]);
            self.bindings.bind(commands, point, 0);
            device.cmd_bind_pipeline(raw, point, self.pipeline.raw());
            device.cmd_draw(raw, 6 * self.columns * self.rows, layers, 0, 0);
            device.cmd_end_render_pass(raw);
        }
    }

    /// The bytes of the image that [`Self::time`] drew last, row by row.
    pub fn download(&self) -> Result<Vec<u8>> {
        let size = self.image.size();
        let bytes = self.filling.format.bytes();
        image_bytes(&self.gpu, &self.image, FINAL_LAYOUT, size, bytes)
    }
}

/// "Over" back to front, as the quads are blended; "under" front to back.
fn blend(filling: Filling) -> vk::PipelineColorBlendAttachmentState {
    let state = match filling.order {
        FillOrder::BackToFront => graphics::over(),
        FillOrder::FrontToBack => vk::PipelineColorBlendAttachmentState::default()
            .src_color_blend_factor(vk::BlendFactor::ONE_MINUS_DST_ALPHA)
            .dst_color_blend_factor(vk::BlendFactor::ONE)
            .src_alpha_blend_factor(vk::BlendFactor::ONE_MINUS_DST_ALPHA)
            .dst_alpha_blend_factor(vk::BlendFactor::ONE),
    };
    state.blend_enable(filling.blended)
}
