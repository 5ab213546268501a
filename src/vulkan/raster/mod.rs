//! The `raster` stage: splats in drawing order go in, a picture comes out (model.md, step 10).
//!
//! | method | how | fragments |
//! |---|---|---|
//! | [`Method::Hulls`] | a quad a splat, blended far to near by the device's blender | all that a quad covers |
//! | [`Method::Tiles`] | `bins` notes which splats meet which tile, a kernel blends each pixel near to far | none behind a full pixel |

mod hulls;
mod tiles;

use super::{
    RendererOptions,
    commands::Slot,
    control::{SHARED, WRITTEN},
    device::Gpu,
    error::{Error, Result},
    memory::{COLOR, Image},
    model::OccluderMesh,
    pipeline::{Slice, barrier},
};
use crate::frame::options::leaves_loops;
pub use crate::frame::{ColorFormat, Method, Touched};
use ash::vk::{self, AccessFlags, PipelineStageFlags};
use hulls::Hulls;
use std::sync::Arc;
pub use tiles::Bins;

impl ColorFormat {
    pub fn vulkan(self) -> vk::Format {
        match self {
            Self::Rgba8 => vk::Format::R8G8B8A8_UNORM,
            Self::Rgba16F => vk::Format::R16G16B16A16_SFLOAT,
        }
    }
}

/// How every frame leaves the picture.
const LEFT: vk::ImageLayout = vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL;

/// Draws by one of the methods.
pub enum Raster {
    Hulls(Hulls),
    Tiles(tiles::Tiles),
}

impl Raster {
    /// `inputs`: order, splats with their keys, and control as the stages before leave them. `capacity`: splats at most.
    pub fn new(
        gpu: &Arc<Gpu>,
        frame: Slice,
        (inputs, capacity): ([Slice; 3], u32),
        surface: (&OccluderMesh, Slice),
        options: &RendererOptions,
    ) -> Result<Self> {
        Ok(match options.method_on(gpu) {
            Method::Hulls => Self::Hulls(Hulls::new(gpu, frame, inputs, surface, options)?),
            Method::Tiles => {
                if leaves_loops(&gpu.probe.driver) {
                    tracing::warn!("{} leaves long loops early: tiles may lose parts of large scenes; hulls don't", gpu.probe.driver);
                }
                Self::Tiles(tiles::Tiles::new(gpu, frame, (inputs, capacity), options)?)
            }
        })
    }

    pub fn method(&self) -> Method {
        match self {
            Self::Hulls(_) => Method::Hulls,
            Self::Tiles(_) => Method::Tiles,
        }
    }

    /// The picture: premultiplied colour, in `SHADER_READ_ONLY_OPTIMAL` after every frame, visible to fragment shaders and transfers.
    pub fn image(&self) -> &Image {
        match self {
            Self::Hulls(hulls) => hulls.image(),
            Self::Tiles(tiles) => tiles.image(),
        }
    }

    /// Width and height of what is drawn, in the picture's upper left corner, px: all of it unless told otherwise.
    pub fn drawn(&self) -> [u32; 2] {
        match self {
            Self::Hulls(hulls) => hulls.drawn(),
            Self::Tiles(tiles) => tiles.drawn(),
        }
    }

    pub fn format(&self) -> ColorFormat {
        match self {
            Self::Hulls(hulls) => hulls.format(),
            Self::Tiles(tiles) => tiles.format(),
        }
    }

    /// Dispatches of a frame.
    pub fn dispatches(&self) -> u64 {
        match self {
            Self::Hulls(_) => 0,
            Self::Tiles(_) => 2,
        }
    }

    /// Draws what the sort left. `frame` is the block with the picture's size; the surfaces that are drawn first are those of the blocks in
    /// `surfaces`. `count`: whether to count fragments.
    pub(super) fn record(
        &self,
        gpu: &Gpu,
        slot: &mut Slot,
        (frame, surfaces): (u32, &[u32]),
        control: vk::Buffer,
        (touched, count): (&Touched, bool),
    ) {
        match self {
            Self::Hulls(hulls) => {
                let draw = PipelineStageFlags::DRAW_INDIRECT | PipelineStageFlags::VERTEX_SHADER | PipelineStageFlags::TRANSFER;
                let reads = AccessFlags::INDIRECT_COMMAND_READ | AccessFlags::SHADER_READ | AccessFlags::TRANSFER_READ;
                barrier(gpu, slot.commands, WRITTEN, (draw, reads));
                slot.drawing("raster", count, |commands| hulls.record(commands, frame, control, surfaces, touched));
            }
            Self::Tiles(tiles) => {
                slot.stage("bins", |commands| tiles.record_bins(commands, frame));
                barrier(gpu, slot.commands, WRITTEN, SHARED);
                if count {
                    slot.counts_itself();
                }
                slot.stage("raster", |commands| tiles.record(commands, frame, touched));
                barrier(gpu, slot.commands, WRITTEN, (PipelineStageFlags::TRANSFER, AccessFlags::TRANSFER_READ));
            }
        }
    }

    /// What the `bins` stage of the last frame left, for tests. None without that stage.
    pub fn bins(&self) -> Result<Option<Bins>> {
        match self {
            Self::Hulls(_) => Ok(None),
            Self::Tiles(tiles) => tiles.download().map(Some),
        }
    }

    /// Changes the picture's size. No submitted frame may still use the old one. On failure the old picture stays.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        match self {
            Self::Hulls(hulls) => hulls.resize(size),
            Self::Tiles(tiles) => tiles.resize(size),
        }
    }

    /// Draws that much of the picture from now on. It must fit.
    pub(super) fn draw_within(&mut self, size: [u32; 2]) {
        match self {
            Self::Hulls(hulls) => hulls.draw_within(size),
            Self::Tiles(tiles) => tiles.draw_within(size),
        }
    }

    /// Changes the cutoff to that of `options`, which are otherwise those that it was made with. No submitted frame may still draw.
    pub(super) fn set_cutoff(&mut self, options: &RendererOptions) -> Result<()> {
        match self {
            Self::Hulls(hulls) => hulls.set_cutoff(options),
            Self::Tiles(tiles) => tiles.set_cutoff(options),
        }
    }
}

/// Orders what is done to a picture, and changes its layout.
fn hand_over(
    gpu: &Gpu,
    commands: vk::CommandBuffer,
    image: &Image,
    [from, to]: [(PipelineStageFlags, AccessFlags); 2],
    layouts: [vk::ImageLayout; 2],
) {
    let barrier = vk::ImageMemoryBarrier::default()
        .src_access_mask(from.1)
        .dst_access_mask(to.1)
        .old_layout(layouts[0])
        .new_layout(layouts[1])
        .src_queue_family_index(vk::QUEUE_FAMILY_IGNORED)
        .dst_queue_family_index(vk::QUEUE_FAMILY_IGNORED)
        .image(image.raw)
        .subresource_range(COLOR);
    // SAFETY: the command buffer is recording, the image is alive and in the layout it is said to be in.
    unsafe { gpu.raw.cmd_pipeline_barrier(commands, from.0, to.0, vk::DependencyFlags::empty(), &[], &[], &[barrier]) };
}

/// Whether a device can have a picture of a size.
fn check_size(gpu: &Gpu, size: [u32; 2], limit: u32) -> Result<()> {
    if size.iter().any(|&side| side == 0 || side > limit) {
        let found = format!("{} × {}", size[0], size[1]);
        return Err(Error::PictureSize { found, limit, device: gpu.probe.name.clone() });
    }
    Ok(())
}
