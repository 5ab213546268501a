//! The `present` stage: draws the rendered image, stretched to fill the canvas, over a colour or a
//! picture; or shows quads in the render pass that draws them.

use super::{
    pre_transform::PreTransform,
    screen_pass::{IMAGE, OnePass, PUSHED, render_pass, screen},
};
use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Framebuffer, Pipeline, RenderPass, Sampler},
        recording::Recording,
    },
    memory::{Image, fill_image},
    pipeline::{
        graphics::{self, DepthUse, PipelineDescription},
        set::Set,
        shaders,
    },
    raster::{Raster, quad_pass::OnePassTarget},
};
use ash::vk;
use bytemuck::cast_slice;
use glam::Vec2;
use std::sync::Arc;

/// Draws rendered images over a background, in a render pass that others may draw in afterwards.
pub struct Present {
    gpu: Arc<Gpu>,
    pipeline: Pipeline,
    render_pass: RenderPass,
    set: Set,
    sampler: Sampler,
    /// Behind images that ask for no colour: a texel until there is another.
    picture: Image,
    /// Of the windows that it draws into.
    pub format: vk::Format,
    /// The layout in which frames leave their images.
    layout: vk::ImageLayout,
    /// None until a raster with quads is connected.
    one_pass: Option<OnePass>,
}

/// The target that a rendered image is drawn into.
#[derive(Clone, Copy)]
pub struct PresentTarget<'a> {
    /// Of the render pass of [`Present`].
    pub framebuffer: &'a Framebuffer,
    /// Of [`Present::one_pass_framebuffer`].
    pub one_pass: Option<&'a Framebuffer>,
    /// Width and height as a viewer sees it, px.
    pub size: [u32; 2],
    /// How it lies in the framebuffer.
    pub pre_transform: PreTransform,
}

/// The image to present.
#[derive(Clone, Copy)]
pub struct PresentedImage {
    /// The drawn part of the image: width and height from its upper left corner, px.
    pub drawn: [u32; 2],
    /// Display-referred RGB, 0 to 1. None: the picture, which must be as large as the canvas.
    pub background: Option<[f32; 3]>,
}

impl Present {
    /// For windows of a format whose numbers are shown as they are.
    pub fn new(gpu: &Arc<Gpu>, format: vk::Format) -> Result<Self> {
        Self::with_final_layout(gpu, format, vk::ImageLayout::PRESENT_SRC_KHR)
    }

    /// For images of which each frame leaves the layout as `layout`.
    pub fn with_final_layout(
        gpu: &Arc<Gpu>,
        format: vk::Format,
        layout: vk::ImageLayout,
    ) -> Result<Self> {
        let stages = vk::ShaderStageFlags::FRAGMENT;
        let set = Set::new(gpu, "present", stages, &[(0, IMAGE), (1, IMAGE)], PUSHED)?;
        let edge = vk::SamplerAddressMode::CLAMP_TO_EDGE;
        let info = vk::SamplerCreateInfo::default()
            .mag_filter(vk::Filter::LINEAR)
            .min_filter(vk::Filter::LINEAR)
            .address_mode_u(edge)
            .address_mode_v(edge);
        let render_pass = render_pass(gpu, screen(format, layout))?;
        let new = Self {
            gpu: gpu.clone(),
            pipeline: pipeline(gpu, &render_pass, set.layouts.pipeline.raw())?,
            render_pass,
            set,
            sampler: Sampler::with(&gpu.device, &info, "present")?,
            picture: picture(gpu, [1; 2], &[0; 4])?,
            format,
            layout,
            one_pass: None,
        };
        new.bind_picture();
        Ok(new)
    }

    /// The render pass that it draws in.
    pub fn render_pass(&self) -> &RenderPass {
        &self.render_pass
    }

    /// Shows this raster's image from now on, where it can in the render pass that draws it.
    ///
    /// # Errors
    /// When the device fails. Then nothing has changed.
    ///
    /// # Safety
    /// Those of [`Self::set_image`]. The raster must be alive while frames are drawn to targets of
    /// [`Self::one_pass`].
    pub unsafe fn connect(&mut self, raster: &Raster) -> Result<()> {
        self.one_pass = OnePass::new(&self.gpu, raster, screen(self.format, self.layout))?;
        self.bind_picture();
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.set_image(raster.image()) };
        Ok(())
    }

    /// Shows this image from now on: that of the raster that is connected, if one is.
    ///
    /// # Safety
    /// No submitted work may use this. When it is recorded and done, the image must be alive and in
    /// `SHADER_READ_ONLY_OPTIMAL`.
    pub unsafe fn set_image(&self, image: &Image) {
        bind(&self.gpu, &self.set, 0, &self.sampler, image);
        if let Some(one_pass) = &self.one_pass {
            // SAFETY: the caller promises what the function asks for.
            unsafe { one_pass.set_image(&self.gpu, image) };
        }
    }

    /// For showing quads in the render pass that draws them: a framebuffer around the connected
    /// raster's image and that of a screen, which must outlive its use. None where the two have
    /// other sizes or orientations, and where nothing with quads is connected.
    pub(super) fn one_pass_framebuffer(
        &self,
        raster: &Raster,
        screen: vk::ImageView,
        size: [u32; 2],
        pre_transform: PreTransform,
    ) -> Option<Framebuffer> {
        let one_pass = self.one_pass.as_ref();
        let upright = one_pass.filter(|_| pre_transform == PreTransform::default());
        upright?.framebuffer(raster, screen, size)
    }

    /// The target for a frame that may be shown in the render pass that draws it. None where an
    /// image has to be stored first.
    pub fn one_pass<'a>(
        &'a self,
        canvas: PresentTarget<'a>,
        background: Option<[f32; 3]>,
    ) -> Option<OnePassTarget<'a>> {
        let one_pass = self.one_pass.as_ref()?;
        let shown = PresentedImage {
            drawn: canvas.size,
            background,
        };
        let constants = constants(canvas, shown);
        let show = move |commands: Recording| {
            draw(
                &self.gpu,
                commands,
                &one_pass.set,
                &one_pass.pipeline,
                &constants,
            );
        };
        Some(OnePassTarget {
            pass: &one_pass.quads,
            framebuffer: canvas.one_pass?,
            size: canvas.size,
            show: Box::new(show),
        })
    }

    /// Width and height of the picture, px.
    pub fn picture_size(&self) -> [u32; 2] {
        self.picture.size
    }

    /// Has this picture behind images that ask for no colour. `size`: width and height, px.
    /// `pixels`: RGBA of 8 bits, row by row from the top left; alpha is not looked at.
    ///
    /// # Errors
    /// When the device has no room for it.
    ///
    /// # Safety
    /// No submitted work may use this.
    ///
    /// # Panics
    /// When it has other pixels than its size says.
    pub unsafe fn set_picture(&mut self, size: [u32; 2], pixels: &[u8]) -> Result<()> {
        self.picture = picture(&self.gpu, size, pixels)?;
        self.bind_picture();
        Ok(())
    }

    /// No submitted work may use the sets.
    fn bind_picture(&self) {
        let sets = std::iter::once(&self.set).chain(self.one_pass.iter().map(|own| &own.set));
        for set in sets {
            bind(&self.gpu, set, 1, &self.sampler, &self.picture);
        }
    }

    /// Draws the image, stretched to fill a canvas, over a background, then what `then` records in
    /// the same render pass.
    pub fn record(
        &self,
        commands: Recording,
        canvas: PresentTarget,
        shown: PresentedImage,
        then: impl FnOnce(),
    ) {
        let [width, height] = canvas.pre_transform.extent(canvas.size);
        let area = vk::Rect2D {
            offset: vk::Offset2D::default(),
            extent: vk::Extent2D { width, height },
        };
        self.in_pass(commands, &self.render_pass, canvas, area, || {
            let viewport = graphics::viewport(0.0, 0.0, width as f32, height as f32);
            let device = &self.gpu.raw;
            let raw = commands.raw();
            // SAFETY: the command buffer is recording.
            unsafe {
                device.cmd_set_viewport(raw, 0, &[viewport]);
                device.cmd_set_scissor(raw, 0, &[area]);
            }
            let constants = constants(canvas, shown);
            draw(&self.gpu, commands, &self.set, &self.pipeline, &constants);
            then();
        });
    }

    /// Draws what `then` records over a canvas on which [`Self::one_pass`] has shown a frame, within
    /// `area`, px.
    pub fn record_over(
        &self,
        commands: Recording,
        canvas: PresentTarget,
        area: vk::Rect2D,
        then: impl FnOnce(),
    ) {
        if let Some(one_pass) = &self.one_pass {
            self.in_pass(commands, &one_pass.over, canvas, area, then);
        }
    }

    /// Records what `inside` does in a render pass on a canvas.
    fn in_pass(
        &self,
        commands: Recording,
        render_pass: &RenderPass,
        canvas: PresentTarget,
        area: vk::Rect2D,
        inside: impl FnOnce(),
    ) {
        let begin = vk::RenderPassBeginInfo::default()
            .render_pass(render_pass.raw())
            .framebuffer(canvas.framebuffer.raw())
            .render_area(area);
        let device = &self.gpu.raw;
        let raw = commands.raw();
        // SAFETY: the command buffer is recording; render pass and framebuffer are alive and fit.
        unsafe { device.cmd_begin_render_pass(raw, &begin, vk::SubpassContents::INLINE) };
        inside();
        // SAFETY: the render pass was begun above.
        unsafe { device.cmd_end_render_pass(raw) };
    }
}

/// The push constants: the background, the pre-rotation, the sizes of the rendered image and of the
/// canvas.
fn constants(canvas: PresentTarget, shown: PresentedImage) -> [f32; 14] {
    let [x, y] = shown.drawn.map(|side| side as f32);
    let [w, h] = canvas.size.map(|side| side as f32);
    let [r, g, b] = shown.background.unwrap_or_default();
    let has_picture = f32::from(shown.background.is_none());
    let (matrix, origin) = canvas.pre_transform.back(canvas.size);
    let [xx, xy, yx, yy] = matrix.to_cols_array();
    let Vec2 { x: ox, y: oy } = origin;
    [r, g, b, has_picture, xx, xy, yx, yy, ox, oy, x, y, w, h]
}

/// Draws the triangle over a canvas. The commands must be inside the pipeline's subpass, with
/// viewport and scissor set.
fn draw(gpu: &Gpu, commands: Recording, set: &Set, pipeline: &Pipeline, constants: &[f32; 14]) {
    let device = &gpu.raw;
    let raw = commands.raw();
    let point = vk::PipelineBindPoint::GRAPHICS;
    let layout = set.layouts.pipeline.raw();
    let stages = vk::ShaderStageFlags::FRAGMENT;
    // SAFETY: the command buffer is recording; every object is alive and fits the pipeline's layout
    // and the render pass.
    unsafe {
        device.cmd_bind_pipeline(raw, point, pipeline.raw());
        device.cmd_bind_descriptor_sets(raw, point, layout, 0, &[set.raw], &[]);
        device.cmd_push_constants(raw, layout, stages, 0, cast_slice(constants));
        device.cmd_draw(raw, 3, 1, 0, 0);
    }
}

/// Binds an image that is sampled. No submitted work may use the set; image and sampler must
/// outlive the work that will.
fn bind(gpu: &Gpu, set: &Set, binding: u32, sampler: &Sampler, image: &Image) {
    let info = [vk::DescriptorImageInfo {
        sampler: sampler.raw(),
        image_view: image.view(),
        image_layout: vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL,
    }];
    let write = vk::WriteDescriptorSet::default()
        .dst_set(set.raw)
        .dst_binding(binding)
        .descriptor_type(IMAGE)
        .image_info(&info);
    // SAFETY: the set is not in use, and view and sampler are alive, as the caller promises.
    unsafe { gpu.raw.update_descriptor_sets(&[write], &[]) };
}

/// A picture on the device, filled.
fn picture(gpu: &Arc<Gpu>, size: [u32; 2], pixels: &[u8]) -> Result<Image> {
    let [width, height] = size.map(|side| side as usize);
    assert_eq!(pixels.len(), 4 * width * height, "a picture has its pixels");
    let usage = vk::ImageUsageFlags::SAMPLED | vk::ImageUsageFlags::TRANSFER_DST;
    let format = vk::Format::R8G8B8A8_UNORM;
    let image = Image::new(gpu, "background", size, format, usage)?;
    fill_image(gpu, &image, pixels)?;
    Ok(image)
}

fn pipeline(
    gpu: &Arc<Gpu>,
    render_pass: &RenderPass,
    layout: vk::PipelineLayout,
) -> Result<Pipeline> {
    let drawing = PipelineDescription {
        name: "present",
        vertex: &shaders::PRESENT_VERTEX,
        fragment: &shaders::PRESENT_FRAGMENT,
        constants: &[],
        layout,
        render_pass: render_pass.raw(),
        subpass: 0,
        blend: vk::PipelineColorBlendAttachmentState::default(),
        depth: DepthUse::Without,
    };
    graphics::pipeline(gpu, drawing)
}
