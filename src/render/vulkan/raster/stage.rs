//! One of the two methods, as the frame sees it.

use super::{
    bins::Bins,
    draw::{Draw, RasterInputs},
    options::method,
    quad_pass::{OnePassTarget, QuadPass},
    quads::Quads,
    resolve::Resolve,
    runs::{Runs, TileLists},
    saturation::Saturation,
    target::forget,
    tiles::Tiles,
};
use crate::{
    quirks::leaves_loops,
    vulkan::{
        device::{
            error::{Error, Result},
            gpu::Gpu,
            handle::Framebuffer,
            recording::Recording,
        },
        memory::{Image, Replacement, Slice},
        pipeline::graphics::Attachment,
    },
};
use ash::vk;
use effigy_core::{
    frame::{ColorFormat, RasterMethod, RendererOptions, atlas::AtlasSlot},
    layout::BinLists,
};
use std::sync::Arc;

/// Sides of atlases are multiples of this, px, so that a crowd that comes nearer does not make a
/// new one in each frame.
const ATLAS_STEP: u32 = 256;

/// The `raster` stage, and `resolve`.
pub struct Raster {
    /// None until a frame has an avatar that is drawn larger than it is shown.
    resolve: Option<Resolve>,
    method: Method,
    gpu: Arc<Gpu>,
}

/// The `raster` stage, by one of its methods.
enum Method {
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
        Self::with(gpu, inputs, options, None)
    }

    /// The stage for other inputs, which draws into the image of this one, for who reads it to go on
    /// reading it.
    pub(crate) fn rebound(&self, inputs: &RasterInputs, options: &RendererOptions) -> Result<Self> {
        let image = match &self.method {
            Method::Quads(quads) => quads.image(),
            Method::Tiles(tiles) => tiles.image(),
        };
        let options = RendererOptions {
            size: image.size,
            ..*options
        };
        let mut new = Self::with(&self.gpu, inputs, &options, Some(image.clone()))?;
        new.draw_within(self.drawn());
        Ok(new)
    }

    fn with(
        gpu: &Arc<Gpu>,
        inputs: &RasterInputs,
        options: &RendererOptions,
        image: Option<Arc<Image>>,
    ) -> Result<Self> {
        let chosen = method(options, gpu);
        let method = if chosen.is_tiles() {
            if let Some(missing) = gpu.probe.lacks_for(chosen) {
                return Err(Error::Unsupported {
                    device: gpu.probe.name.clone(),
                    missing: missing.into(),
                });
            }
            if leaves_loops(&gpu.probe.driver) {
                tracing::warn!(
                    "{} leaves long loops early: tiles may lose parts of large scenes; quads don't",
                    gpu.probe.driver
                );
            }
            Method::Tiles(Box::new(Tiles::new(gpu, inputs, options, chosen, image)?))
        } else {
            Method::Quads(Box::new(Quads::new(gpu, inputs, options, image)?))
        };
        Ok(Self {
            resolve: None,
            method,
            gpu: gpu.clone(),
        })
    }

    /// The method that it draws by.
    pub fn method(&self) -> RasterMethod {
        match &self.method {
            Method::Quads(_) => RasterMethod::Quads,
            Method::Tiles(tiles) => tiles.method(),
        }
    }

    /// The image: premultiplied colour, in `SHADER_READ_ONLY_OPTIMAL` after every frame, visible to
    /// fragment shaders and transfers.
    pub fn image(&self) -> &Image {
        match &self.method {
            Method::Quads(quads) => quads.image(),
            Method::Tiles(tiles) => tiles.image(),
        }
    }

    /// Width and height of what is drawn, in the image's upper left corner, px: all of it until
    /// `draw_within`.
    pub fn drawn(&self) -> [u32; 2] {
        match &self.method {
            Method::Quads(quads) => quads.drawn(),
            Method::Tiles(tiles) => tiles.drawn(),
        }
    }

    /// The image's colour format.
    pub fn format(&self) -> ColorFormat {
        match &self.method {
            Method::Quads(quads) => quads.format(),
            Method::Tiles(tiles) => tiles.format(),
        }
    }

    /// Dispatches of a frame.
    pub fn dispatches(&self) -> u64 {
        match &self.method {
            Method::Quads(_) => self.bins().map_or(0, |bins| bins.dispatches() + 1),
            Method::Tiles(_) => 1 + self.bins().map_or(1, Bins::dispatches),
        }
    }

    fn runs(&self) -> Option<&Runs> {
        match &self.method {
            Method::Quads(_) => None,
            Method::Tiles(tiles) => tiles.runs(),
        }
    }

    fn bins(&self) -> Option<&Bins> {
        match &self.method {
            Method::Quads(quads) => quads.saturation().map(Saturation::bins),
            Method::Tiles(tiles) => tiles.bins(),
        }
    }

    /// Reads splats in the one buffer that it read in the other.
    ///
    /// # Safety
    /// No submitted work may draw with it, and the new buffer must outlive what will.
    pub(crate) unsafe fn replace(&mut self, replacement: Replacement) {
        match &mut self.method {
            // SAFETY: the caller promises what the function asks for.
            Method::Quads(quads) => unsafe { quads.replace(replacement) },
            // SAFETY: the caller promises what the function asks for.
            Method::Tiles(tiles) => unsafe { tiles.replace(replacement) },
        }
    }

    /// Where a frame says how many blocks its tiles' lists asked for, if there are any.
    pub(crate) fn list_blocks(&self) -> Option<Slice> {
        self.runs().map(Runs::asked)
    }

    /// How many blocks the tiles' lists should have after a frame that asked for so many. None
    /// where nothing changes.
    pub(crate) fn other_blocks(&self, asked: u32) -> Option<u32> {
        self.runs().and_then(|runs| runs.other_blocks(asked))
    }

    /// Gives the tiles' lists another number of blocks.
    ///
    /// # Safety
    /// No submitted work may draw with it.
    pub(crate) unsafe fn resize_lists(&mut self, blocks: u32) {
        if let Method::Tiles(tiles) = &mut self.method {
            // SAFETY: the caller promises that no work draws with it.
            unsafe { tiles.resize_lists(blocks) };
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
    pub(crate) fn record_bins(&self, commands: Recording, draw: &Draw) {
        if let Some(bins) = self.bins() {
            bins.record(commands, draw.frame, draw.size);
        }
    }

    /// Finds the saturation depth, if quads are tested against it; compute.
    pub(crate) fn record_saturation(&self, commands: Recording, draw: &Draw) {
        if let Method::Quads(quads) = &self.method
            && let Some(saturation) = quads.saturation()
        {
            saturation.record(commands, draw);
        }
    }

    /// Draws what the sort left. `tested`: whether quads are tested against the saturation depth,
    /// which this frame found. `screen`: where quads go in the same render pass; the damage must be
    /// whole then.
    pub(crate) fn record(
        &self,
        commands: Recording,
        draw: &Draw,
        tested: bool,
        screen: Option<&OnePassTarget>,
    ) {
        match &self.method {
            Method::Quads(quads) => quads.record(commands, draw, tested, screen),
            Method::Tiles(tiles) => tiles.record(commands, draw),
        }
    }

    /// A render pass that draws quads and has a second subpass for `screen`. None by tiles.
    pub(crate) fn one_pass(&self, screen: Attachment) -> Result<Option<QuadPass>> {
        match &self.method {
            Method::Quads(quads) => quads.one_pass(screen).map(Some),
            Method::Tiles(_) => Ok(None),
        }
    }

    /// Around the image and a screen's of `size` px, for such a render pass. All three must outlive
    /// its use. None where the image has another size.
    pub(crate) fn framebuffer(
        &self,
        pass: &QuadPass,
        screen: vk::ImageView,
        size: [u32; 2],
    ) -> Result<Option<Framebuffer>> {
        match &self.method {
            Method::Quads(quads) if quads.image().size == size => {
                quads.framebuffer(pass, screen).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// The tile lists of the last frame, read back for tests. None without such lists.
    pub fn tile_lists(&self) -> Result<Option<TileLists>> {
        self.runs().map(Runs::download).transpose()
    }

    /// The lists of bins of the last frame, read back for tests. None without such lists.
    pub fn bin_lists(&self) -> Result<Option<BinLists>> {
        self.bins()
            .map(|bins| bins.download(self.drawn()))
            .transpose()
    }

    /// The saturation depth of each sample of the last frame and the colour there, row by row, read
    /// back for tests: words of `shaders/common/saturation.glsl`. None without the stage.
    pub fn saturation_samples(&self) -> Result<Option<Vec<u32>>> {
        match &self.method {
            Method::Quads(quads) => quads.saturation().map(Saturation::download).transpose(),
            Method::Tiles(_) => Ok(None),
        }
    }

    /// Changes the image's size. On failure the old image stays.
    ///
    /// # Safety
    /// No submitted work may use the image.
    pub(crate) unsafe fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        match &mut self.method {
            // SAFETY: the caller promises that no work uses the image.
            Method::Quads(quads) => unsafe { quads.resize(size) },
            // SAFETY: the caller promises that no work uses the image.
            Method::Tiles(tiles) => unsafe { tiles.resize(size) },
        }?;
        // The next frame that resolves anything makes another for this image.
        self.resolve = None;
        Ok(())
    }

    /// Whether there is an atlas of at least a size, and what resolves it.
    pub(crate) fn has_atlas(&self, size: [u32; 2]) -> bool {
        self.resolve.is_some()
            && self.atlas().is_some_and(|atlas| {
                let [width, height] = atlas.size();
                width >= size[0] && height >= size[1]
            })
    }

    fn atlas(&self) -> Option<&Image> {
        match &self.method {
            Method::Quads(quads) => quads.atlas(),
            Method::Tiles(tiles) => tiles.atlas(),
        }
    }

    /// Makes an atlas of at least a size, px, and what resolves it.
    ///
    /// # Safety
    /// No submitted work may use the ones before.
    pub(crate) unsafe fn make_atlas(&mut self, size: [u32; 2]) -> Result<()> {
        let before = self.atlas().map_or([0; 2], Image::size);
        let grown = [0, 1].map(|axis| size[axis].next_multiple_of(ATLAS_STEP).max(before[axis]));
        if grown != before {
            match &mut self.method {
                // SAFETY: the caller promises that no work uses the one before.
                Method::Quads(quads) => unsafe { quads.make_atlas(grown) },
                // SAFETY: the caller promises that no work uses the one before.
                Method::Tiles(tiles) => unsafe { tiles.make_atlas(grown) },
            }?;
        }
        let resolve = match self.resolve.take() {
            Some(resolve) => resolve,
            None => Resolve::new(&self.gpu, self.image(), self.format())?,
        };
        if let Some(atlas) = self.atlas() {
            // SAFETY: the caller promises that no work uses it. The atlas lives as long as this or
            // until it gets another, and every layer leaves it in the layout for readers.
            unsafe { resolve.set_atlas(atlas) };
        }
        self.resolve = Some(resolve);
        Ok(())
    }

    /// Averages slots of the atlas into the image. `clear`: whether the frame drew nothing else
    /// into it.
    pub(crate) fn record_resolve(
        &self,
        commands: Recording,
        draw: &Draw,
        slots: &[AtlasSlot],
        clear: bool,
    ) {
        if clear && draw.damage.whole {
            forget(commands, self.image());
        }
        if let Some(resolve) = &self.resolve {
            resolve.record(commands, draw, slots, clear);
        }
    }

    /// Draws that much of the image from now on. It must fit.
    pub(crate) fn draw_within(&mut self, size: [u32; 2]) {
        match &mut self.method {
            Method::Quads(quads) => quads.draw_within(size),
            Method::Tiles(tiles) => tiles.draw_within(size),
        }
    }
}
