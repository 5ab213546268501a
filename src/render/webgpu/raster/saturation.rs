//! The `saturation` stage, which the quads' depth test needs: splats and bins go in, an image of
//! depths and colours comes out, a sample for every four pixels. Behind a sample's depth hardly
//! anything shows at any of the four. A triangle over the whole image writes it to the depth image
//! of the quads, and the colour to the image under them.

use super::{
    super::{
        device::Gpu,
        drawing::{DEPTH_FORMAT, TrianglePipeline, depth_test, texture},
        error::Result,
        kernel::{Bindings, Blocks, Bound, Kernel},
        owned::OwnedTexture,
    },
    bins::Bins,
    inputs::{Draw, RasterInputs},
};
use crate::wgsl;
use effigy_core::{
    constants::saturation_light,
    frame::RendererOptions,
    layout::{SATURATION_REGION, SettingsBlock},
};
use wgpu::{ShaderStages, TextureFormat, TextureUsages, TextureView};

/// Every device can write and read it.
const FORMAT: TextureFormat = TextureFormat::R32Uint;

/// What is made anew when the image's size changes.
struct Images {
    /// Read back by tests, which are not run in browsers.
    #[cfg_attr(target_arch = "wasm32", expect(dead_code))]
    samples: OwnedTexture,
    sampled: TextureView,
    _depth: OwnedTexture,
    depth: TextureView,
}

/// The kernel, its image, and what draws the image as depth.
pub struct Saturation {
    bins: Bins,
    kernel: Kernel,
    images: Images,
    triangle: Bindings,
    pipeline: wgpu::RenderPipeline,
}

impl Saturation {
    /// `format`: of the image that quads are drawn to.
    pub fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        format: TextureFormat,
        size: [u32; 2],
    ) -> Result<Self> {
        let bins = Bins::new(gpu, blocks, inputs)?;
        let images = Images::new(gpu, size);
        let bound = kernel_bindings(blocks, inputs, &bins, &images);
        let kernel = Kernel::new(gpu, &wgsl::SATURATION, &bound);
        let bound = triangle_bindings(&images);
        let triangle = Bindings::new(gpu, ShaderStages::FRAGMENT, &bound);
        let drawing = TrianglePipeline {
            label: "saturation depth",
            bindings: &triangle,
            bound: &bound,
            vertex: &wgsl::PRESENT_VERTEX,
            fragment: &wgsl::SATURATION_DEPTH,
            target: wgpu::ColorTargetState {
                format,
                blend: None,
                write_mask: wgpu::ColorWrites::ALL,
            },
            depth: Some(depth_test(true)),
        };
        Ok(Self {
            bins,
            kernel,
            pipeline: drawing.pipeline(gpu)?,
            triangle,
            images,
        })
    }

    /// Writes what its shaders read to the settings block.
    pub fn fill(settings: &mut SettingsBlock, options: &RendererOptions, capacity: u32) {
        settings.saturation = saturation_light(options.cutoff) as f32;
        Bins::fill(settings, capacity);
    }

    /// Changes the size of the quads' image.
    pub fn resize(&mut self, gpu: &Gpu, blocks: &Blocks, inputs: RasterInputs, size: [u32; 2]) {
        let images = Images::new(gpu, size);
        let bound = kernel_bindings(blocks, inputs, &self.bins, &images);
        self.kernel.set(gpu, 0, &bound);
        self.triangle.set(gpu, 0, &triangle_bindings(&images));
        self.images = images;
    }

    /// The lists that the samples are made from.
    pub fn bins(&self) -> &Bins {
        &self.bins
    }

    /// The depth image of the quads.
    pub fn depth(&self) -> &TextureView {
        &self.images.depth
    }

    /// The samples of the last frame, for tests.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn samples(&self) -> &wgpu::Texture {
        &self.images.samples
    }

    /// Finds the depth of each sample that a pixel looks at which is drawn. Reads the lists.
    pub fn record(&self, pass: &mut wgpu::ComputePass, draw: &Draw) {
        let [first, end] = draw.damage.drawn_regions(SATURATION_REGION);
        let groups = [end[0] - first[0], end[1] - first[1]];
        self.kernel.dispatch(pass, draw.block, groups);
    }

    /// Writes the depths to [`Self::depth`], which the pass must have cleared to the furthest, and
    /// the colours to the image.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        pass.set_pipeline(&self.pipeline);
        self.triangle.bind_draw(pass, 0);
        pass.draw(0..3, 0..1);
    }
}

impl Images {
    fn new(gpu: &Gpu, size: [u32; 2]) -> Self {
        let usage = TextureUsages::STORAGE_BINDING
            | TextureUsages::TEXTURE_BINDING
            | TextureUsages::COPY_SRC;
        let half = size.map(|side| side.div_ceil(2));
        let samples = texture(gpu, "saturation", half, FORMAT, usage);
        let usage = TextureUsages::RENDER_ATTACHMENT;
        let depth = texture(gpu, "target depth", size, DEPTH_FORMAT, usage);
        Self {
            sampled: samples.create_view(&Default::default()),
            samples,
            depth: depth.create_view(&Default::default()),
            _depth: depth,
        }
    }
}

fn kernel_bindings<'a>(
    blocks: &'a Blocks,
    inputs: RasterInputs<'a>,
    bins: &'a Bins,
    images: &'a Images,
) -> [(u32, Bound<'a>); 8] {
    [
        blocks.frame(),
        (1, Bound::Read(inputs.splats)),
        (2, Bound::Write(inputs.control.into())),
        (3, Bound::Read(bins.sorted())),
        (4, Bound::Read(bins.buffer())),
        (5, Bound::FrameImage(&images.sampled, FORMAT)),
        (6, Bound::Write(bins.marks())),
        blocks.settings(),
    ]
}

fn triangle_bindings(images: &Images) -> [(u32, Bound<'_>); 1] {
    [(1, Bound::Words(&images.sampled))]
}
