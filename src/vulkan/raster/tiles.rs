//! The `bins` stage and the compute form of `raster`: order, splats and control go in, a picture comes out.

use super::{ColorFormat, LEFT, Method, Touched, check_size, hand_over};
use crate::{
    frame::Skip,
    layout::{BINS, BINS_BLOCKS, BINS_LEVELS, BINS_NODE, BINS_SIZE},
    vulkan::{
        RendererOptions,
        device::Gpu,
        error::Result,
        memory::{Buffer, Image},
        pipeline::{Bindings, BoundImage, Kernel, Launch, Slice, barrier},
        shaders,
    },
};
use ash::vk::{self, AccessFlags, ImageLayout, PipelineStageFlags};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// What the `bins` stage left, read back: numbers of splats, nearest first, of each tile of each level, row by row from the top left.
pub struct Bins {
    tiles: Vec<Vec<u32>>,
}

impl Bins {
    /// Those of a level's tile, the finest being level 0. Column and row of that level.
    pub fn tile(&self, level: u32, [column, row]: [u32; 2]) -> &[u32] {
        &self.tiles[(BINS.first_tile(level) + row * (BINS.side >> (2 * level)) + column) as usize]
    }

    /// Those of all levels that a finest tile lies in, level by level.
    pub fn at(&self, [column, row]: [u32; 2]) -> [&[u32]; BINS_LEVELS as usize] {
        let whole = BINS_LEVELS - 1;
        std::array::from_fn(|k| k as u32)
            .map(|level| self.tile(level, if level < whole { [column, row].map(|v| v >> (2 * level)) } else { [0; 2] }))
    }
}

pub struct Tiles {
    gpu: Arc<Gpu>,
    bins: Kernel,
    raster: Kernel,
    buffer: Buffer,
    format: ColorFormat,
    image: Image,
    /// The part of the image that is drawn, from its upper left corner, px.
    drawn: [u32; 2],
}

impl Tiles {
    pub fn new(gpu: &Arc<Gpu>, frame: Slice, (inputs, capacity): ([Slice; 3], u32), options: &RendererOptions) -> Result<Self> {
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
        let buffer = Buffer::new(gpu, "bins", BINS.bytes(capacity)[1], usage, MemoryLocation::GpuOnly)?;
        let [order, splats, control] = inputs;
        let storage = [order, splats, control, (&buffer).into()];
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), &storage)?;
        let bins = Kernel::new(gpu, &shaders::BINS, &[BINS.nodes(capacity)[0]], bindings)?;
        let color = options.color.unwrap_or(Method::Tiles.color());
        let module = match (Variant::suited(gpu), color) {
            (Variant::Alone, ColorFormat::Rgba8) => &shaders::RASTER_RGBA8,
            (Variant::Alone, ColorFormat::Rgba16F) => &shaders::RASTER_RGBA16F,
            (Variant::Together, ColorFormat::Rgba8) => &shaders::RASTER_TOGETHER_RGBA8,
            (Variant::Together, ColorFormat::Rgba16F) => &shaders::RASTER_TOGETHER_RGBA16F,
        };
        let storage = [splats, control, (&buffer).into()];
        let bindings = Bindings::with_image(gpu, Some(frame), &storage, BoundImage::Written)?;
        let raster = Kernel::with_launch(gpu, module, &constants(options), bindings, launch(gpu))?;
        let image = picture(gpu, color, options.size)?;
        raster.set_image(vk::Sampler::null(), image.view);
        Ok(Self { gpu: gpu.clone(), bins, raster, buffer, format: color, image, drawn: options.size })
    }

    pub fn image(&self) -> &Image {
        &self.image
    }

    pub fn drawn(&self) -> [u32; 2] {
        self.drawn
    }

    pub fn format(&self) -> ColorFormat {
        self.format
    }

    /// The bins of the last frame, for tests.
    pub fn download(&self) -> Result<Bins> {
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(&self.buffer.download(self.buffer.size as usize)?);
        let [tiles, blocks, node] = [BINS.tiles(), BINS_BLOCKS, BINS_NODE].map(|number| number as usize);
        let heads = 1 + tiles;
        let nodes = heads + tiles * blocks - node;
        let chain = |at: usize| {
            let mut splats = Vec::new();
            let mut chain = words[at] as usize;
            while chain != 0 {
                let held = chain % node;
                splats.extend((chain - held + 1..=chain).rev().map(|slot| words[nodes + slot]));
                chain = words[nodes + chain - held] as usize;
            }
            splats
        };
        let tile = |tile: usize| (0..blocks).rev().flat_map(|block| chain(heads + tile * blocks + block)).collect();
        Ok(Bins { tiles: (0..tiles).map(tile).collect() })
    }

    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.image = picture(&self.gpu, self.format, size)?;
        self.raster.set_image(vk::Sampler::null(), self.image.view);
        self.drawn = size;
        Ok(())
    }

    pub fn draw_within(&mut self, size: [u32; 2]) {
        self.drawn = size;
    }

    /// Changes the cutoff to that of `options`, which are otherwise those that it was made with. No submitted frame may still draw.
    pub fn set_cutoff(&mut self, options: &RendererOptions) -> Result<()> {
        self.raster.specialize(&constants(options), launch(&self.gpu))
    }

    /// Notes which splats meet which tile. Reads what the sort left; a transfer and compute.
    pub fn record_bins(&self, commands: vk::CommandBuffer, frame: u32) {
        let compute = PipelineStageFlags::COMPUTE_SHADER;
        let written = (PipelineStageFlags::TRANSFER, AccessFlags::TRANSFER_WRITE);
        barrier(&self.gpu, commands, (compute, AccessFlags::SHADER_WRITE), written);
        // SAFETY: the command buffer is recording, the range lies in the buffer, which is alive.
        unsafe { self.gpu.raw.cmd_fill_buffer(commands, self.buffer.raw, 0, BINS.bytes(0)[0], 0) };
        barrier(&self.gpu, commands, written, (compute, AccessFlags::SHADER_READ | AccessFlags::SHADER_WRITE));
        self.bins.dispatch(commands, frame, BINS_BLOCKS / BINS_SIZE);
    }

    /// Draws what of the picture is to be drawn, every pixel there. Reads what `bins` left; compute.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32, touched: &Touched) {
        let compute = (PipelineStageFlags::COMPUTE_SHADER, AccessFlags::SHADER_WRITE);
        let readers = PipelineStageFlags::FRAGMENT_SHADER | PipelineStageFlags::TRANSFER;
        let found = if touched.anew { ImageLayout::UNDEFINED } else { LEFT };
        hand_over(&self.gpu, commands, &self.image, [(readers, AccessFlags::empty()), compute], [found, ImageLayout::GENERAL]);
        self.raster.dispatch_within(commands, frame, touched.regions());
        let readers = (readers, AccessFlags::SHADER_READ | AccessFlags::TRANSFER_READ);
        hand_over(&self.gpu, commands, &self.image, [compute, readers], [ImageLayout::GENERAL, LEFT]);
    }
}

/// Of the raster kernel: the cutoff, what is left where a pixel counts as full, and whether to count.
fn constants(options: &RendererOptions) -> [u32; 3] {
    let full = if options.skip.contains(Skip::FULL) { options.cutoff as f32 } else { 0.0 };
    [(options.cutoff as f32).to_bits(), full.to_bits(), options.count.into()]
}

/// What the kernel is compiled as.
#[derive(PartialEq)]
enum Variant {
    /// Each invocation walks its tiles' chains by itself.
    Alone,
    /// Each subgroup lies in one tile and hands splats round: 8 invocations, of 4 by 4 pixels each, in tiles of at least 16. Processors
    /// alone: Mali's compiler spills 700 registers there; and not 16 invocations, which was not timed.
    Together,
}

impl Variant {
    fn suited(gpu: &Gpu) -> Self {
        let eight = gpu.probe.subgroup_shuffle && gpu.probe.subgroup_size == 8;
        if gpu.probe.is_cpu() && eight && !gpu.probe.driver.starts_with("SwiftShader") { Self::Together } else { Self::Alone }
    }
}

/// Full subgroups of the size that the device reports, where it can be asked for that.
fn launch(gpu: &Gpu) -> Launch {
    let together = |[low, high]: &[u32; 2]| Variant::suited(gpu) == Variant::Together && (*low..=*high).contains(&gpu.probe.subgroup_size);
    Launch { subgroup: gpu.probe.subgroup_sizes.filter(together).map(|_| gpu.probe.subgroup_size), anywhere: true }
}

fn picture(gpu: &Arc<Gpu>, format: ColorFormat, size: [u32; 2]) -> Result<Image> {
    check_size(gpu, size, gpu.probe.limits.max_image_dimension2_d)?;
    let usage = vk::ImageUsageFlags::STORAGE | vk::ImageUsageFlags::SAMPLED | vk::ImageUsageFlags::TRANSFER_SRC;
    Image::new(gpu, "target", size, format.vulkan(), usage)
}
