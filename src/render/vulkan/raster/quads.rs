//! The graphics form of `raster`: one indirect draw of quads, blended far to near into an
//! off-screen image.

use super::{
    draw::{Draw, RasterInputs, rect},
    quad_pass::{OnePassTarget, QuadParts, QuadPass, exponents},
    saturation::Saturation,
    target::{check_size, forget, vulkan_format},
};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, handle::Framebuffer, recording::Recording},
    memory::{Buffer, DEPTH_FORMAT, Image, Replacement},
    pipeline::{
        bindings::Bindings,
        graphics::{self, Attachment},
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
    image: Arc<Image>,
    /// Saturation depths, where fragments are tested; used within the render pass only.
    depth: Option<Image>,
}

impl QuadTarget {
    /// The views of its attachments.
    fn views(&self) -> Vec<vk::ImageView> {
        let depth = self.depth.as_ref().map(Image::view);
        std::iter::once(self.image.view()).chain(depth).collect()
    }
}

pub struct Quads {
    gpu: Arc<Gpu>,
    format: ColorFormat,
    /// Finds what quads are tested against; None where no frame tests depth.
    saturation: Option<Box<Saturation>>,
    exponents: [f32; 2],
    bindings: Bindings,
    indices: Buffer,
    target: QuadTarget,
    /// Where avatars are drawn larger than they are shown; None until a frame has one.
    atlas: Option<QuadTarget>,
    /// Stores the image.
    pass: QuadPass,
    /// The part of the target that is drawn, from its upper left corner, px.
    drawn: [u32; 2],
}

impl Quads {
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        inputs: &RasterInputs,
        options: &RendererOptions,
        image: Option<Arc<Image>>,
    ) -> Result<Self> {
        check_target(gpu, options.size)?;
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
        let saturation = if depth {
            Some(Box::new(Saturation::new(gpu, inputs, options)?))
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
        let parts = QuadParts {
            bindings: &bindings,
            saturation: saturation.as_deref(),
            format,
            exponents: exponents(options),
        };
        let pass = QuadPass::new(gpu, &parts, None)?;
        Ok(Self {
            gpu: gpu.clone(),
            format,
            target: match image {
                Some(image) => target_around(gpu, &pass, &parts, image)?,
                None => target(gpu, &pass, &parts, options.size)?,
            },
            exponents: parts.exponents,
            bindings,
            saturation,
            indices,
            atlas: None,
            pass,
            drawn: options.size,
        })
    }

    fn parts(&self) -> QuadParts<'_> {
        QuadParts {
            bindings: &self.bindings,
            saturation: self.saturation(),
            format: self.format,
            exponents: self.exponents,
        }
    }

    /// A render pass that draws quads and has a second subpass for `screen`.
    pub fn one_pass(&self, screen: Attachment) -> Result<QuadPass> {
        QuadPass::new(&self.gpu, &self.parts(), Some(screen))
    }

    /// Around the image and a screen's of the same size, for such a render pass. All three must
    /// outlive its use.
    pub fn framebuffer(&self, pass: &QuadPass, screen: vk::ImageView) -> Result<Framebuffer> {
        let mut views = self.target.views();
        views.push(screen);
        let size = self.target.image.size;
        let render_pass = pass.render_pass();
        Framebuffer::around(
            &self.gpu.device,
            render_pass,
            &views,
            size,
            "raster and screen",
        )
    }

    /// Changes the image's size. On failure it stays.
    ///
    /// # Safety
    /// No submitted work may use the image.
    pub unsafe fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        let target = target(&self.gpu, &self.pass, &self.parts(), size)?;
        if let Some(saturation) = &mut self.saturation {
            // SAFETY: the caller promises that no work uses it.
            unsafe { saturation.resize(size) }?;
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
        self.atlas = Some(target(&self.gpu, &self.pass, &self.parts(), size)?);
        Ok(())
    }

    /// The atlas, if there is one.
    pub fn atlas(&self) -> Option<&Image> {
        self.atlas.as_ref().map(|atlas| &*atlas.image)
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
            if let Some(saturation) = &mut self.saturation {
                saturation.replace(replacement);
            }
        }
    }

    pub fn image(&self) -> &Arc<Image> {
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
        self.saturation.as_deref()
    }

    /// Clears the damage rectangle, and draws the control's splats in what is drawn of it;
    /// graphics. `tested`: whether [`Self::saturation`] found this frame's depths. With a `screen`
    /// the damage must be whole; the image goes there and is lost.
    pub fn record(
        &self,
        commands: Recording,
        draw: &Draw,
        tested: bool,
        screen: Option<&OnePassTarget>,
    ) {
        let target = match (draw.target, &self.atlas) {
            (RenderTarget::Atlas, Some(atlas)) => atlas,
            _ => &self.target,
        };
        let [width, height] = draw.size;
        let area = draw.area();
        let (pass, framebuffer) = match screen {
            Some(screen) => (screen.pass, screen.framebuffer),
            None => (&self.pass, &target.framebuffer),
        };
        if draw.damage.whole && screen.is_none() {
            forget(commands, &target.image);
        }
        let viewport = graphics::viewport(0.0, 0.0, width as f32, height as f32);
        let clear = [vk::ClearValue::default(), graphics::FURTHEST];
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(pass.render_pass().raw())
            .framebuffer(framebuffer.raw())
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
            let mut pipeline = &pass.plain;
            if let (true, Some(saturation), Some(own)) = (tested, self.saturation(), &pass.tested) {
                saturation.draw(commands, &own.depth);
                pipeline = &own.quads;
            }
            self.bindings.bind(commands, point, draw.frame);
            device.cmd_bind_pipeline(raw, point, pipeline.raw());
            device.cmd_bind_index_buffer(raw, self.indices.raw(), 0, vk::IndexType::UINT16);
            device.cmd_draw_indexed_indirect(raw, draw.control, 0, 1, 0);
            if let Some(screen) = screen {
                device.cmd_next_subpass(raw, vk::SubpassContents::INLINE);
                device.cmd_set_scissor(raw, 0, &[area]);
                (screen.show)(commands);
            }
            device.cmd_end_render_pass(raw);
        }
    }
}

/// Fails where a device can't draw to an image of this size, px.
fn check_target(gpu: &Gpu, size: [u32; 2]) -> Result<()> {
    let limits = &gpu.probe.limits;
    let limit = limits
        .max_image_dimension2_d
        .min(limits.max_framebuffer_width)
        .min(limits.max_framebuffer_height);
    check_size(gpu, size, limit)
}

/// The image can also be read by a second subpass.
fn target(
    gpu: &Arc<Gpu>,
    pass: &QuadPass,
    parts: &QuadParts,
    size: [u32; 2],
) -> Result<QuadTarget> {
    check_target(gpu, size)?;
    let usage = vk::ImageUsageFlags::COLOR_ATTACHMENT
        | vk::ImageUsageFlags::INPUT_ATTACHMENT
        | vk::ImageUsageFlags::SAMPLED
        | vk::ImageUsageFlags::TRANSFER_SRC;
    let image = Image::new(gpu, "target", size, vulkan_format(parts.format), usage)?;
    target_around(gpu, pass, parts, Arc::new(image))
}

fn target_around(
    gpu: &Arc<Gpu>,
    pass: &QuadPass,
    parts: &QuadParts,
    image: Arc<Image>,
) -> Result<QuadTarget> {
    let size = image.size;
    let mut views = vec![image.view()];
    let depth = if parts.saturation.is_some() {
        let usage = vk::ImageUsageFlags::DEPTH_STENCIL_ATTACHMENT
            | vk::ImageUsageFlags::TRANSIENT_ATTACHMENT;
        let depth = Image::new(gpu, "target depth", size, DEPTH_FORMAT, usage)?;
        views.push(depth.view());
        Some(depth)
    } else {
        None
    };
    let render_pass = pass.render_pass();
    Ok(QuadTarget {
        framebuffer: Framebuffer::around(&gpu.device, render_pass, &views, size, "raster")?,
        image,
        depth,
    })
}
