//! The `saturation` stage, which the quads' depth test needs: order, splats and bins go in, an
//! image of depths and colours comes out, a sample for every four pixels. Behind a sample's depth
//! hardly anything shows at any of the four. [`SaturationDepth`] writes it to the depth attachment
//! of the quads, and the colour to the image under them.

use super::{
    bins::Bins,
    draw::{Draw, RasterInputs},
};
use crate::vulkan::{
    device::{
        error::Result,
        gpu::Gpu,
        handle::{Pipeline, RenderPass, Sampler},
        recording::Recording,
    },
    memory::{Image, LayoutChange, Replacement, Scope, image_bytes},
    pipeline::{
        BoundImage, Kernel, Launch, Resources,
        bindings::Bindings,
        graphics::{self, DepthUse, PipelineDescription},
        shaders,
    },
};
use ash::vk;
use effigy_core::{
    constants::saturation_light,
    frame::{RendererOptions, kernels},
    layout::SATURATION_REGION,
};
use std::sync::Arc;

/// Every device can write and sample it.
const FORMAT: vk::Format = vk::Format::R32_UINT;

/// The kernel, its image, and what draws the image as depth.
pub struct Saturation {
    gpu: Arc<Gpu>,
    bins: Bins,
    kernel: Kernel,
    image: Image,
    depth: SaturationDepth,
}

impl Saturation {
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        inputs: &RasterInputs,
        options: &RendererOptions,
    ) -> Result<Self> {
        let bins = Bins::new(gpu, inputs)?;
        let kernel = Kernel::of_frame(
            gpu,
            &kernels::SATURATION,
            &shaders::SATURATION,
            &bins.constants(constants(options)),
            &bins.add_to(&inputs.memory),
            LAUNCH,
        )?;
        let depth = SaturationDepth::new(gpu)?;
        let image = create_image(gpu, options.size)?;
        let new = Self {
            gpu: gpu.clone(),
            bins,
            kernel,
            image,
            depth,
        };
        // SAFETY: nothing uses the sets yet.
        unsafe { new.bind_image() };
        Ok(new)
    }

    /// # Safety
    /// No submitted work may use the stage.
    unsafe fn bind_image(&self) {
        let view = self.image.view();
        // SAFETY: no work uses the sets, as the caller promises; `record` has the image in the
        // layout that both expect, and image and sampler live as long as they, or until they get
        // another.
        unsafe {
            self.kernel.set_image(view);
            let sampler = self.depth.sampler.raw();
            self.depth.bindings.set_image(sampler, view);
        }
    }

    /// Changes the size of the quads' image. On failure the old size stays.
    ///
    /// # Safety
    /// No submitted work may use the stage.
    pub unsafe fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.image = create_image(&self.gpu, size)?;
        // SAFETY: the caller promises that no work uses it.
        unsafe { self.bind_image() };
        Ok(())
    }

    /// Reads splats in the one buffer that it read in the other.
    ///
    /// # Safety
    /// No submitted work may use the stage, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        // SAFETY: the caller promises what the functions ask for.
        unsafe {
            self.bins.replace(replacement);
            self.kernel.replace(replacement);
        }
    }

    /// The lists that the samples are made from.
    pub fn bins(&self) -> &Bins {
        &self.bins
    }

    /// Finds the depth of each sample that a pixel looks at which is drawn. Reads the output of
    /// `binning`; compute.
    pub fn record(&self, commands: Recording, draw: &Draw) {
        // The samples of the frame before are of no use.
        let begin = LayoutChange {
            from: Scope::new(
                vk::PipelineStageFlags::FRAGMENT_SHADER | vk::PipelineStageFlags::COMPUTE_SHADER,
                vk::AccessFlags::SHADER_WRITE,
            ),
            to: Scope::KERNEL_WRITES,
            old: vk::ImageLayout::UNDEFINED,
            new: vk::ImageLayout::GENERAL,
        };
        // SAFETY: the image is alive.
        unsafe { commands.change_layout(self.image.raw(), begin) };
        let [first, end] = draw.damage.drawn_regions(SATURATION_REGION);
        self.kernel
            .dispatch_within(commands, draw.frame, first, end);
    }

    /// The samples of the last frame as words of `common/saturation.glsl`, row by row, read back
    /// for tests.
    pub fn download(&self) -> Result<Vec<u32>> {
        let layout = vk::ImageLayout::GENERAL;
        let bytes = image_bytes(&self.gpu, &self.image, layout, self.image.size(), 4)?;
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }

    /// What [`Self::draw`] draws with in the first subpass of a render pass that tests depth.
    pub fn depth_pipeline(&self, render_pass: &RenderPass) -> Result<Pipeline> {
        let replace = vk::PipelineColorBlendAttachmentState::default();
        let drawing = PipelineDescription {
            name: "saturation depth",
            vertex: &shaders::PRESENT_VERTEX,
            fragment: &shaders::SATURATION_DEPTH,
            constants: &[],
            layout: self.depth.bindings.layout(),
            render_pass: render_pass.raw(),
            subpass: 0,
            blend: replace,
            depth: DepthUse::Write,
        };
        graphics::pipeline(&self.gpu, drawing)
    }

    /// Writes the depths to the depth attachment, and the colours to the image.
    ///
    /// # Safety
    /// The commands must be inside the pipeline's render pass, with viewport and scissor set, and
    /// after [`Self::record`] made visible to fragment shaders.
    pub unsafe fn draw(&self, commands: Recording, pipeline: &Pipeline) {
        let point = vk::PipelineBindPoint::GRAPHICS;
        self.depth.bindings.bind(commands, point, 0);
        let device = &self.gpu.raw;
        let raw = commands.raw();
        // SAFETY: the command buffer is recording inside the pipeline's render pass, as the caller
        // promises; the pipeline is alive.
        unsafe {
            device.cmd_bind_pipeline(raw, point, pipeline.raw());
            device.cmd_draw(raw, 3, 1, 0, 0);
        }
    }
}

const LAUNCH: Launch = Launch {
    subgroup: None,
    anywhere: true,
};

/// Specialization constants of the kernel.
fn constants(options: &RendererOptions) -> [u32; 3] {
    [
        (options.cutoff.log2() as f32).to_bits(),
        (saturation_light(options.cutoff) as f32).to_bits(),
        options.count.into(),
    ]
}

/// What a triangle over the whole image reads that writes the samples as depth, and colours.
struct SaturationDepth {
    bindings: Bindings,
    sampler: Sampler,
}

impl SaturationDepth {
    fn new(gpu: &Arc<Gpu>) -> Result<Self> {
        let resources = Resources {
            image: Some(BoundImage::Read),
            ..Resources::default()
        };
        let stages = vk::ShaderStageFlags::FRAGMENT;
        Ok(Self {
            bindings: Bindings::new(gpu, "saturation depth", stages, resources)?,
            sampler: Sampler::with(&gpu.device, &vk::SamplerCreateInfo::default(), "saturation")?,
        })
    }
}

fn create_image(gpu: &Arc<Gpu>, size: [u32; 2]) -> Result<Image> {
    let usage = vk::ImageUsageFlags::STORAGE
        | vk::ImageUsageFlags::SAMPLED
        | vk::ImageUsageFlags::TRANSFER_SRC;
    let samples = size.map(|side| side.div_ceil(2));
    Image::new(gpu, "saturation", samples, FORMAT, usage)
}
