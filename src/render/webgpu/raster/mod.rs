//! The `raster` stage: splats in drawing order go in, an image comes out (model.md, step 10). Two
//! ways, as [`RasterMethod`] says. And `resolve`, for what is drawn larger than it is shown.

mod bins;
mod inputs;
mod quads;
mod resolve;
mod saturation;
mod tiles;

pub use inputs::{Draw, RasterInputs};

use super::{
    device::Gpu,
    drawing::texture,
    error::{Error, Result},
    frame_in_flight::{FrameInFlight, Writes},
    kernel::Blocks,
    owned::OwnedTexture,
};
use bins::Bins;
use effigy_core::{
    frame::{
        ColorFormat, Damage, RasterMethod, RendererOptions, Skip, atlas::AtlasSlot,
        passes::RenderTarget,
    },
    layout::{SATURATION_REGION, SHARED_REGION, SettingsBlock},
};
use quads::{QuadFrame, Quads};
use resolve::{Resolve, SlotsFrame};
use saturation::Saturation;
use tiles::Tiles;
use wgpu::{TextureFormat, TextureUsages, TextureView};

/// Sides of atlases are multiples of this, px, so that a crowd that comes nearer does not make a
/// new one in each frame.
const ATLAS_STEP: u32 = 256;

/// The kernels of a [`RasterMethod`].
enum MethodKernels {
    Quads(Box<Quads>),
    Tiles(Box<Tiles>),
}

impl MethodKernels {
    /// Those of the options' method, which draw to `image`, of the options' format and size.
    fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        options: &RendererOptions,
        image: &TextureView,
    ) -> Result<Self> {
        let method = options.method.unwrap_or(RasterMethod::Quads);
        let texels = wgpu_format(options.color());
        Ok(if method.is_tiles() {
            Self::Tiles(Box::new(Tiles::new(gpu, blocks, inputs, texels, image)?))
        } else {
            Self::Quads(Box::new(Quads::new(gpu, blocks, inputs, texels, options)?))
        })
    }
}

/// The image of avatars that are drawn larger than they are shown, and the stage that averages it.
struct AtlasImage {
    image: OwnedTexture,
    view: TextureView,
    resolve: Resolve,
}

impl AtlasImage {
    fn size(&self) -> [u32; 2] {
        [self.image.width(), self.image.height()]
    }
}

pub struct Raster {
    method: MethodKernels,
    format: ColorFormat,
    image: OwnedTexture,
    view: TextureView,
    /// None until a frame has an avatar that is drawn larger than it is shown.
    atlas: Option<AtlasImage>,
    /// The most slots of an atlas: one an avatar.
    slots: usize,
}

impl Raster {
    /// `options` with colour, method and kernel resolved.
    pub fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        options: &RendererOptions,
    ) -> Result<Self> {
        let format = options.color();
        let image = create_image(gpu, format, options.size)?;
        let view = image.create_view(&Default::default());
        Ok(Self {
            method: MethodKernels::new(gpu, blocks, inputs, options, &view)?,
            format,
            image,
            view,
            atlas: None,
            slots: options.instances,
        })
    }

    /// Draws from other inputs from now on, into the same image. On failure nothing has changed.
    pub fn rebind(
        &mut self,
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        options: &RendererOptions,
    ) -> Result<()> {
        self.method = MethodKernels::new(gpu, blocks, inputs, options, &self.view)?;
        // Its kernels went with the others.
        self.atlas = None;
        Ok(())
    }

    /// Writes the options that the shaders read to the settings block.
    pub fn fill(&self, settings: &mut SettingsBlock, options: &RendererOptions, capacity: u32) {
        settings.cutoff = options.cutoff as f32;
        settings.cutoff_exponent = options.cutoff.log2() as f32;
        settings.quad_exponent = if options.skip.contains(Skip::FAINT) {
            settings.cutoff_exponent
        } else {
            0.0
        };
        settings.counted = options.count.into();
        match &self.method {
            MethodKernels::Quads(_) => Saturation::fill(settings, options, capacity),
            MethodKernels::Tiles(_) => {
                settings.saturation = if options.skip.contains(Skip::SATURATED) {
                    settings.cutoff
                } else {
                    0.0
                };
                Bins::fill(settings, capacity);
            }
        }
    }

    /// The image: premultiplied colour.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn image(&self) -> &wgpu::Texture {
        &self.image
    }

    pub fn view(&self) -> &TextureView {
        &self.view
    }

    #[cfg(not(target_arch = "wasm32"))]
    pub fn format(&self) -> ColorFormat {
        self.format
    }

    /// The saturation depth of each sample of the last frame, for tests. None without the stage.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn samples(&self) -> Option<&wgpu::Texture> {
        match &self.method {
            MethodKernels::Quads(quads) => quads.saturation().map(Saturation::samples),
            MethodKernels::Tiles(_) => None,
        }
    }

    /// The lists of bins of the last frame, read back for tests. None without such lists.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn bin_lists(&self, gpu: &Gpu) -> Result<Option<effigy_core::layout::BinLists>> {
        let size = [self.image.width(), self.image.height()];
        self.bins().map(|bins| bins.download(gpu, size)).transpose()
    }

    /// The method that it draws by.
    pub fn method(&self) -> RasterMethod {
        match self.method {
            MethodKernels::Quads(_) => RasterMethod::Quads,
            MethodKernels::Tiles(_) => RasterMethod::SharedTiles,
        }
    }

    fn bins(&self) -> Option<&Bins> {
        match &self.method {
            MethodKernels::Quads(quads) => quads.saturation().map(Saturation::bins),
            MethodKernels::Tiles(tiles) => Some(tiles.bins()),
        }
    }

    /// Dispatches of a frame.
    pub fn dispatches(&self) -> u64 {
        match self.method {
            MethodKernels::Quads(_) => self.bins().map_or(0, |bins| bins.dispatches() + 1),
            MethodKernels::Tiles(_) => 1 + self.bins().map_or(1, Bins::dispatches),
        }
    }

    /// Column and row of the first region that a frame draws into an image of a size, or has
    /// samples of.
    pub fn first_region(&self, damage: &Damage) -> [u32; 2] {
        match &self.method {
            MethodKernels::Quads(_) => damage.drawn_regions(SATURATION_REGION)[0],
            MethodKernels::Tiles(_) => damage.regions(SHARED_REGION)[0],
        }
    }

    /// Changes the image's size. On failure the old image stays.
    pub fn resize(
        &mut self,
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        size: [u32; 2],
    ) -> Result<()> {
        let image = create_image(gpu, self.format, size)?;
        let view = image.create_view(&Default::default());
        match &mut self.method {
            MethodKernels::Quads(quads) => quads.resize(gpu, blocks, inputs, size),
            MethodKernels::Tiles(tiles) => {
                tiles.set_image(gpu, blocks, inputs, RenderTarget::Image, &view)
            }
        }
        self.image = image;
        self.view = view;
        Ok(())
    }

    /// Makes an atlas of at least a size, px, and what averages it, where there is none. A device
    /// that has no memory for it says so with [`Gpu::check`], in browsers later: then nothing more
    /// can be drawn with this.
    pub fn make_atlas(
        &mut self,
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        size: [u32; 2],
    ) -> Result<()> {
        let before = self.atlas.as_ref().map_or([0; 2], AtlasImage::size);
        let grown = [0, 1].map(|axis| size[axis].next_multiple_of(ATLAS_STEP).max(before[axis]));
        if grown == before {
            return Ok(());
        }
        let image = create_image(gpu, self.format, grown)?;
        let view = image.create_view(&Default::default());
        let resolve = match self.atlas.take() {
            Some(mut atlas) => {
                atlas.resolve.set_atlas(gpu, &view);
                atlas.resolve
            }
            None => Resolve::new(gpu, &view, wgpu_format(self.format), self.slots)?,
        };
        if let MethodKernels::Tiles(tiles) = &mut self.method {
            tiles.set_image(gpu, blocks, inputs, RenderTarget::Atlas, &view);
        }
        self.atlas = Some(AtlasImage {
            image,
            view,
            resolve,
        });
        Ok(())
    }

    /// Says where the slots of the next frame's atlas are, which must have been made.
    pub fn write_slots(&self, gpu: &Gpu, slots: &[AtlasSlot]) {
        if let Some(atlas) = &self.atlas {
            atlas.resolve.write(gpu, slots);
        }
    }

    /// What a layer is drawn to.
    fn target(&self, target: RenderTarget) -> &TextureView {
        match (target, &self.atlas) {
            (RenderTarget::Atlas, Some(atlas)) => &atlas.view,
            _ => &self.view,
        }
    }

    /// Makes the lists of bins, if there are any. `writes`: its timestamps.
    pub fn record_bins(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        draw: &Draw,
        writes: Writes,
    ) {
        if let Some(bins) = self.bins() {
            bins.record(in_flight, encoder, draw, writes);
        }
    }

    /// Finds the saturation depth, if quads are tested against it.
    pub fn record_saturation(&self, pass: &mut wgpu::ComputePass, draw: &Draw) {
        if let MethodKernels::Quads(quads) = &self.method
            && let Some(saturation) = quads.saturation()
        {
            saturation.record(pass, draw);
        }
    }

    /// Blends the lists of the damage rectangle.
    pub fn record_tiles(&self, pass: &mut wgpu::ComputePass, draw: &Draw) {
        if let MethodKernels::Tiles(tiles) = &self.method {
            tiles.record(pass, draw);
        }
    }

    /// Blends every quad; see [`Quads::record`].
    pub fn record_quads(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        draw: &Draw,
        control: &wgpu::Buffer,
        tested: bool,
        writes: Writes,
    ) {
        if let MethodKernels::Quads(quads) = &self.method {
            let frame = QuadFrame {
                image: self.target(draw.target),
                draw,
                control,
                tested,
            };
            quads.record(in_flight, encoder, &frame, writes);
        }
    }

    /// Averages slots of the atlas into the image; see [`Resolve::record`].
    pub fn record_resolve(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        draw: &Draw,
        slots: &[AtlasSlot],
        clear: bool,
        writes: Writes,
    ) {
        if let Some(atlas) = &self.atlas {
            let frame = SlotsFrame {
                image: &self.view,
                draw,
                slots,
                clear,
            };
            atlas.resolve.record(in_flight, encoder, &frame, writes);
        }
    }
}

fn wgpu_format(format: ColorFormat) -> TextureFormat {
    match format {
        ColorFormat::Rgba8 => TextureFormat::Rgba8Unorm,
        ColorFormat::Rgba16F => TextureFormat::Rgba16Float,
    }
}

fn create_image(gpu: &Gpu, format: ColorFormat, size: [u32; 2]) -> Result<OwnedTexture> {
    let limit = gpu.device.limits().max_texture_dimension_2d;
    if size.iter().any(|&side| side == 0 || side > limit) {
        let found = format!("{} × {}", size[0], size[1]);
        return Err(Error::ImageSize {
            found,
            limit,
            device: gpu.name().into(),
        });
    }
    let all = [
        TextureUsages::RENDER_ATTACHMENT,
        TextureUsages::STORAGE_BINDING,
        TextureUsages::TEXTURE_BINDING,
        TextureUsages::COPY_SRC,
    ];
    let usage = all
        .into_iter()
        .fold(TextureUsages::empty(), |all, one| all | one);
    Ok(texture(gpu, "target", size, wgpu_format(format), usage))
}
