//! The `binning` stage and the compute form of `raster`: order, splats and control go in, an image
//! comes out.

use super::{
    draw::{Draw, RasterInputs},
    target::{FINAL_LAYOUT, READER_SCOPE, READER_STAGES, check_size, vulkan_format},
};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Image, LayoutChange, Scope, Slice},
    pipeline::{BoundImage, Kernel, Launch, Resources, shaders},
};
use ash::vk::{self, AccessFlags, ImageLayout};
use effigy_core::{
    frame::{ColorFormat, RasterMethod, RendererOptions, Skip},
    layout::{BINNING_BLOCK, BINNING_RUNS, BINNING_WORKGROUP, TILE_LEVELS, TILING},
};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// The output of the `binning` stage, read back: indices of splats, nearest first, of each tile of
/// each level, row by row from the top left.
pub struct TileLists {
    tiles: Vec<Vec<u32>>,
}

impl TileLists {
    /// The list of one tile, by column and row in its level. Level 0 is the finest.
    pub fn tile(&self, level: u32, [column, row]: [u32; 2]) -> &[u32] {
        &self.tiles[(TILING.first_tile(level)
            + row * (TILING.tiles_per_side >> (2 * level))
            + column) as usize]
    }

    /// The lists of all tiles, level by level, that cover a tile of the finest level.
    pub fn at(&self, [column, row]: [u32; 2]) -> [&[u32]; TILE_LEVELS as usize] {
        let whole = TILE_LEVELS - 1;
        std::array::from_fn(|k| k as u32).map(|level| {
            self.tile(
                level,
                if level < whole {
                    [column, row].map(|v| v >> (2 * level))
                } else {
                    [0; 2]
                },
            )
        })
    }
}

pub struct Tiles {
    gpu: Arc<Gpu>,
    binning: Kernel,
    raster: Kernel,
    buffer: Buffer,
    format: ColorFormat,
    image: Image,
    /// The part of the image that is drawn, from its upper left corner, px.
    drawn: [u32; 2],
}

impl Tiles {
    pub fn new(gpu: &Arc<Gpu>, inputs: &RasterInputs, options: &RendererOptions) -> Result<Self> {
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let buffer = Buffer::new(
            gpu,
            "binning",
            TILING.bytes(inputs.capacity)[1],
            usage,
            MemoryLocation::GpuOnly,
        )?;
        let resources = Resources {
            uniform: Some(inputs.frame),
            storage: &[
                inputs.order,
                inputs.splats,
                inputs.control,
                (&buffer).into(),
            ],
            image: None,
        };
        let blocks = [TILING.blocks(inputs.capacity)[0]];
        let binning = Kernel::new(
            gpu,
            &shaders::BINNING,
            &blocks,
            resources,
            Launch::default(),
        )?;
        let color = options.color.unwrap_or(RasterMethod::Tiles.color());
        let module = match (KernelVariant::recommended_for(gpu), color) {
            (KernelVariant::PerThread, ColorFormat::Rgba8) => &shaders::RASTER_PER_THREAD_RGBA8,
            (KernelVariant::PerThread, ColorFormat::Rgba16F) => &shaders::RASTER_PER_THREAD_RGBA16F,
            (KernelVariant::Cooperative, ColorFormat::Rgba8) => &shaders::RASTER_COOPERATIVE_RGBA8,
            (KernelVariant::Cooperative, ColorFormat::Rgba16F) => {
                &shaders::RASTER_COOPERATIVE_RGBA16F
            }
        };
        let resources = Resources {
            uniform: Some(inputs.frame),
            storage: &[inputs.splats, inputs.control, (&buffer).into()],
            image: Some(BoundImage::Written),
        };
        let raster = Kernel::new(gpu, module, &constants(options), resources, launch(gpu))?;
        let image = create_image(gpu, color, options.size)?;
        // SAFETY: nothing uses the kernel yet; `record` has the image in the layout that it writes,
        // and the image lives as long as the kernel, or until it gets another.
        unsafe { raster.set_image(vk::Sampler::null(), image.view()) };
        Ok(Self {
            gpu: gpu.clone(),
            raster,
            binning,
            buffer,
            format: color,
            image,
            drawn: options.size,
        })
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

    /// The tile lists of the last frame, read back for tests.
    pub fn download(&self) -> Result<TileLists> {
        let words: Vec<u32> =
            bytemuck::pod_collect_to_vec(&self.buffer.download(self.buffer.size as usize)?);
        let tiles = TILING.tiles() as usize;
        let runs = BINNING_RUNS as usize;
        let block_size = BINNING_BLOCK as usize;
        let heads = 1 + tiles;
        // Blocks are numbered from 1: a head or link of 0 ends a list.
        let blocks = heads + tiles * runs - block_size;
        // Each run of a tile has a list of blocks. A head or link is the place of the list's last
        // splat; word 0 of a block links to the block before, splats follow.
        let list = |head: usize| {
            let mut splats = Vec::new();
            let mut last = words[head] as usize;
            while last != 0 {
                let count = last % block_size;
                let link = last - count;
                splats.extend((link + 1..=last).rev().map(|place| words[blocks + place]));
                last = words[blocks + link] as usize;
            }
            splats
        };
        let tile = |tile: usize| {
            (0..runs)
                .rev()
                .flat_map(|run| list(heads + tile * runs + run))
                .collect()
        };
        Ok(TileLists {
            tiles: (0..tiles).map(tile).collect(),
        })
    }

    /// Changes the image's size. On failure it stays.
    ///
    /// # Safety
    /// No submitted work may use the image or draw to it.
    pub unsafe fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        self.image = create_image(&self.gpu, self.format, size)?;
        // SAFETY: no work uses the kernel, as the caller promises; `record` has the image in the
        // layout that it writes, and the image lives as long as the kernel, or until it gets
        // another.
        unsafe {
            self.raster
                .set_image(vk::Sampler::null(), self.image.view())
        };
        self.drawn = size;
        Ok(())
    }

    pub fn draw_within(&mut self, size: [u32; 2]) {
        self.drawn = size;
    }

    /// Changes the cutoff to that of `options`, which are otherwise those that it was made with.
    ///
    /// # Safety
    /// No submitted work may draw with it.
    pub unsafe fn set_cutoff(&mut self, options: &RendererOptions) -> Result<()> {
        let launch = launch(&self.gpu);
        // SAFETY: the caller promises that no work uses the kernel.
        unsafe { self.raster.specialize(&constants(options), launch) }
    }

    /// Empties the tiles' lists; a transfer.
    pub fn clear_lists(&self, commands: Recording) {
        let heads = Slice {
            size: TILING.bytes(0)[0],
            ..(&self.buffer).into()
        };
        // SAFETY: the part lies in the buffer, which is alive.
        unsafe { commands.clear(heads) };
    }

    /// Writes splats to the lists of the tiles that they meet. Reads what the sort left; compute.
    pub fn record_binning(&self, commands: Recording, frame: u32) {
        self.binning
            .dispatch(commands, frame, BINNING_RUNS / BINNING_WORKGROUP);
    }

    /// Draws every pixel of the damage rectangle. Reads the output of `binning`; compute.
    pub fn record(&self, commands: Recording, draw: &Draw) {
        let image = self.image.raw();
        let begin = LayoutChange {
            from: Scope::new(READER_STAGES, AccessFlags::empty()),
            to: Scope::KERNEL_WRITES,
            old: if draw.damage.whole {
                ImageLayout::UNDEFINED
            } else {
                FINAL_LAYOUT
            },
            new: ImageLayout::GENERAL,
        };
        let end = LayoutChange {
            from: Scope::KERNEL_WRITES,
            to: READER_SCOPE,
            old: ImageLayout::GENERAL,
            new: FINAL_LAYOUT,
        };
        // SAFETY: the image is alive, and as the frame before left it, or as nobody did.
        unsafe { commands.change_layout(image, begin) };
        let [first, beyond] = draw.damage.regions();
        self.raster
            .dispatch_within(commands, draw.frame, first, beyond);
        // SAFETY: the image is alive, and in the layout that the kernel writes.
        unsafe { commands.change_layout(image, end) };
    }
}

/// Specialization constants of the `raster` kernel: the cutoff, the transmittance at which a pixel
/// counts as saturated, and whether to count fragments.
fn constants(options: &RendererOptions) -> [u32; 3] {
    let saturation = if options.skip.contains(Skip::SATURATED) {
        options.cutoff as f32
    } else {
        0.0
    };
    [
        (options.cutoff as f32).to_bits(),
        saturation.to_bits(),
        options.count.into(),
    ]
}

/// How the invocations of the `raster` kernel share the work of a tile.
#[derive(PartialEq)]
enum KernelVariant {
    /// Each invocation walks its tiles' lists by itself.
    PerThread,
    /// Each subgroup lies in one tile and shuffles splats between its 8 invocations, of 4 × 4
    /// pixels each, in tiles of at least 16 × 16 pixels. CPU drivers only: Mali's compiler spills
    /// 700 registers. Subgroups of 16 have not been timed.
    Cooperative,
}

impl KernelVariant {
    fn recommended_for(gpu: &Gpu) -> Self {
        let eight = gpu.probe.subgroup_shuffle && gpu.probe.subgroup_size == 8;
        if gpu.probe.is_cpu() && eight && !gpu.probe.driver.starts_with("SwiftShader") {
            Self::Cooperative
        } else {
            Self::PerThread
        }
    }
}

/// Full subgroups of the size that the device reports, where it can be asked for that.
fn launch(gpu: &Gpu) -> Launch {
    let cooperative = KernelVariant::recommended_for(gpu) == KernelVariant::Cooperative;
    let size = gpu.probe.subgroup_size;
    Launch {
        subgroup: gpu
            .probe
            .subgroup_sizes
            .filter(|[min, max]| cooperative && (*min..=*max).contains(&size))
            .map(|_| size),
        anywhere: true,
    }
}

fn create_image(gpu: &Arc<Gpu>, format: ColorFormat, size: [u32; 2]) -> Result<Image> {
    check_size(gpu, size, gpu.probe.limits.max_image_dimension2_d)?;
    let usage = vk::ImageUsageFlags::STORAGE
        | vk::ImageUsageFlags::SAMPLED
        | vk::ImageUsageFlags::TRANSFER_SRC;
    Image::new(gpu, "target", size, vulkan_format(format), usage)
}
