//! One of the two methods, as the frame sees it.

use super::{
    bins::Bins,
    draw::{Draw, RasterInputs},
    options::{method, tile_kernel},
    quads::Quads,
    runs::{Runs, TileLists},
    saturation::Saturation,
    tiles::Tiles,
};
use crate::{
    quirks::leaves_loops,
    vulkan::{
        device::{
            error::{Error, Result},
            gpu::Gpu,
            recording::Recording,
        },
        memory::Image,
    },
};
use effigy_core::{
    frame::{ColorFormat, RasterMethod, RendererOptions, TileKernel},
    layout::BinLists,
};
use std::sync::Arc;

/// The `raster` stage, by one of its methods.
pub enum Raster {
    /// Blends quads far to near with the device's blender.
    Quads(Box<Quads>),
    /// Blends the splats of each tile near to far in a compute kernel.
    Tiles(Box<Tiles>),
}

impl Raster {
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        inputs: &RasterInputs,
        options: &RendererOptions,
    ) -> Result<Self> {
        Ok(match method(options, gpu) {
            RasterMethod::Quads => Self::Quads(Box::new(Quads::new(gpu, inputs, options)?)),
            RasterMethod::Tiles => {
                let kernel = tile_kernel(options, gpu);
                if kernel == TileKernel::Cooperative && !gpu.probe.can_cooperate() {
                    return Err(Error::Unsupported {
                        device: gpu.probe.name.clone(),
                        missing: "for cooperative tiles: subgroups of 8 with shuffles".into(),
                    });
                }
                if leaves_loops(&gpu.probe.driver) {
                    tracing::warn!(
                        "{} leaves long loops early: tiles may lose parts of large scenes; quads don't",
                        gpu.probe.driver
                    );
                }
                Self::Tiles(Box::new(Tiles::new(gpu, inputs, options)?))
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
            Self::Quads(_) => self.bins().map_or(0, |bins| bins.dispatches() + 1),
            Self::Tiles(_) => 1 + self.bins().map_or(1, Bins::dispatches),
        }
    }

    fn runs(&self) -> Option<&Runs> {
        match self {
            Self::Quads(_) => None,
            Self::Tiles(tiles) => tiles.runs(),
        }
    }

    fn bins(&self) -> Option<&Bins> {
        match self {
            Self::Quads(quads) => quads.saturation().map(Saturation::bins),
            Self::Tiles(tiles) => tiles.bins(),
        }
    }

    /// Empties the tiles' lists, if there are any: a transfer.
    pub(crate) fn clear_tile_lists(&self, commands: Recording) {
        if let Some(runs) = self.runs() {
            runs.clear(commands);
        }
    }

    /// Writes splats to the lists of the tiles that they meet, if there are any; compute.
    pub(crate) fn record_binning(&self, commands: Recording, frame: u32) {
        if let Some(runs) = self.runs() {
            runs.record(commands, frame);
        }
    }

    /// Makes the lists of bins, if there are any; compute.
    pub(crate) fn record_bins(&self, commands: Recording, frame: u32) {
        if let Some(bins) = self.bins() {
            bins.record(commands, frame, self.drawn());
        }
    }

    /// Finds the saturation depth, if quads are tested against it; compute.
    pub(crate) fn record_saturation(&self, commands: Recording, draw: &Draw) {
        if let Self::Quads(quads) = self
            && let Some(saturation) = quads.saturation()
        {
            saturation.record(commands, draw);
        }
    }

    /// Draws what the sort left. `tested`: whether quads are tested against the saturation depth,
    /// which this frame found.
    pub(crate) fn record(&self, commands: Recording, draw: &Draw, tested: bool) {
        match self {
            Self::Quads(quads) => quads.record(commands, draw, tested),
            Self::Tiles(tiles) => tiles.record(commands, draw),
        }
    }

    /// The tile lists of the last frame, read back for tests. None where there are none.
    pub fn tile_lists(&self) -> Result<Option<TileLists>> {
        self.runs().map(Runs::download).transpose()
    }

    /// The lists of bins of the last frame, read back for tests. None where there are none.
    pub fn bin_lists(&self) -> Result<Option<BinLists>> {
        self.bins()
            .map(|bins| bins.download(self.drawn()))
            .transpose()
    }

    /// The saturation depth of each sample of the last frame, row by row, read back for tests. None
    /// without the stage.
    pub fn saturation_depths(&self) -> Result<Option<Vec<f32>>> {
        match self {
            Self::Quads(quads) => quads.saturation().map(Saturation::download).transpose(),
            Self::Tiles(_) => Ok(None),
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
