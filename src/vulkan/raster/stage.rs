//! One of the two methods, as the frame sees it.

use super::{
    draw::{Draw, RasterInputs},
    options::method,
    quads::Quads,
    tiles::{TileLists, Tiles},
};
use crate::{
    quirks::leaves_loops,
    vulkan::{
        device::{error::Result, gpu::Gpu, recording::Recording},
        memory::Image,
    },
};
use effigy_core::frame::{ColorFormat, RasterMethod, RendererOptions};
use std::sync::Arc;

/// The `raster` stage, by one of its methods.
pub enum Raster {
    /// Blends quads far to near with the device's blender.
    Quads(Quads),
    /// Blends the splats of each tile near to far in a compute kernel.
    Tiles(Tiles),
}

impl Raster {
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        inputs: &RasterInputs,
        options: &RendererOptions,
    ) -> Result<Self> {
        Ok(match method(options, gpu) {
            RasterMethod::Quads => Self::Quads(Quads::new(gpu, inputs, options)?),
            RasterMethod::Tiles => {
                if leaves_loops(&gpu.probe.driver) {
                    tracing::warn!(
                        "{} leaves long loops early: tiles may lose parts of large scenes; quads don't",
                        gpu.probe.driver
                    );
                }
                Self::Tiles(Tiles::new(gpu, inputs, options)?)
            }
        })
    }

    /// The method that it draws by.
    pub fn method(&self) -> RasterMethod {
        match self {
            Self::Quads(_) => RasterMethod::Quads,
            Self::Tiles(_) => RasterMethod::Tiles,
        }
    }

    /// The image: premultiplied colour, in `SHADER_READ_ONLY_OPTIMAL` after every frame, visible to
    /// fragment shaders and transfers.
    pub fn image(&self) -> &Image {
        match self {
            Self::Quads(quads) => quads.image(),
            Self::Tiles(tiles) => tiles.image(),
        }
    }

    /// Width and height of what is drawn, in the image's upper left corner, px: all of it until
    /// `draw_within`.
    pub fn drawn(&self) -> [u32; 2] {
        match self {
            Self::Quads(quads) => quads.drawn(),
            Self::Tiles(tiles) => tiles.drawn(),
        }
    }

    /// The image's colour format.
    pub fn format(&self) -> ColorFormat {
        match self {
            Self::Quads(quads) => quads.format(),
            Self::Tiles(tiles) => tiles.format(),
        }
    }

    /// Dispatches of a frame.
    pub fn dispatches(&self) -> u64 {
        match self {
            Self::Quads(_) => 0,
            Self::Tiles(_) => 2,
        }
    }

    /// Empties the tiles' lists: a transfer. Quads have none.
    pub(crate) fn clear_tile_lists(&self, commands: Recording) {
        if let Self::Tiles(tiles) = self {
            tiles.clear_lists(commands);
        }
    }

    /// Writes splats to the lists of the tiles that they meet; compute. Quads have none.
    pub(crate) fn record_binning(&self, commands: Recording, frame: u32) {
        if let Self::Tiles(tiles) = self {
            tiles.record_binning(commands, frame);
        }
    }

    /// Draws what the sort left.
    pub(crate) fn record(&self, commands: Recording, draw: &Draw) {
        match self {
            Self::Quads(quads) => quads.record(commands, draw),
            Self::Tiles(tiles) => tiles.record(commands, draw),
        }
    }

    /// The tile lists of the last frame, read back for tests. None without the `binning` stage.
    pub fn tile_lists(&self) -> Result<Option<TileLists>> {
        match self {
            Self::Quads(_) => Ok(None),
            Self::Tiles(tiles) => tiles.download().map(Some),
        }
    }

    /// Changes the image's size. On failure the old image stays.
    ///
    /// # Safety
    /// No submitted work may use the image.
    pub(crate) unsafe fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        match self {
            // SAFETY: the caller promises that no work uses the image.
            Self::Quads(quads) => unsafe { quads.resize(size) },
            // SAFETY: the caller promises that no work uses the image.
            Self::Tiles(tiles) => unsafe { tiles.resize(size) },
        }
    }

    /// Draws that much of the image from now on. It must fit.
    pub(crate) fn draw_within(&mut self, size: [u32; 2]) {
        match self {
            Self::Quads(quads) => quads.draw_within(size),
            Self::Tiles(tiles) => tiles.draw_within(size),
        }
    }

    /// Changes the cutoff to that of `options`, which are otherwise those that it was made with.
    ///
    /// # Safety
    /// No submitted work may draw with it.
    pub(crate) unsafe fn set_cutoff(&mut self, options: &RendererOptions) -> Result<()> {
        match self {
            // SAFETY: the caller promises that no work draws with it.
            Self::Quads(quads) => unsafe { quads.set_cutoff(options) },
            // SAFETY: the caller promises that no work draws with it.
            Self::Tiles(tiles) => unsafe { tiles.set_cutoff(options) },
        }
    }
}
