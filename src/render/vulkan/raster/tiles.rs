//! The compute form of `raster`, and its `binning` stage: order, splats and control go in, an image
//! comes out.

use super::{
    bins::Bins,
    draw::{Draw, RasterInputs},
    runs::Runs,
    target::{FINAL_LAYOUT, READER_SCOPE, READER_STAGES, check_size, vulkan_format},
};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Image, LayoutChange, Replacement, Scope},
    pipeline::{Kernel, Launch, shaders},
};
use ash::vk::{self, AccessFlags, ImageLayout};
use effigy_core::{
    frame::{ColorFormat, RasterMethod, RendererOptions, Skip, kernels, passes::RenderTarget},
    layout::{RASTER_REGION, SHARED_REGION},
};
use std::sync::Arc;

/// The lists that a kernel walks.
enum Lists {
    Runs(Box<Runs>),
    Bins(Box<Bins>),
}

/// An image, and the kernel that writes it.
struct TileTarget {
    kernel: Kernel,
    image: Arc<Image>,
}

impl TileTarget {
    /// Draws what `lists` say to an image. `options`: resolved.
    fn new(
        gpu: &Arc<Gpu>,
        lists: &Lists,
        inputs: &RasterInputs,
        options: &RendererOptions,
        image: Arc<Image>,
    ) -> Result<Self> {
        let module = match (lists, options.color()) {
            (Lists::Runs(_), ColorFormat::Rgba8) => &shaders::RASTER_COOPERATIVE_RGBA8,
            (Lists::Runs(_), ColorFormat::Rgba16F) => &shaders::RASTER_COOPERATIVE_RGBA16F,
            (Lists::Bins(_), ColorFormat::Rgba8) => &shaders::RASTER_SHARED_RGBA8,
            (Lists::Bins(_), ColorFormat::Rgba16F) => &shaders::RASTER_SHARED_RGBA16F,
        };
        let (spec, memory) = match lists {
            Lists::Runs(runs) => (&kernels::RASTER_TILES, runs.add_to(&inputs.memory)),
            Lists::Bins(bins) => (&kernels::RASTER_BINS, bins.add_to(&inputs.memory)),
        };
        let constants = constants(lists, options);
        let launch = launch(gpu, lists);
        let kernel = Kernel::of_frame(gpu, spec, module, &constants, &memory, launch)?;
        // SAFETY: nothing uses the kernel yet; `record` has the image in the layout that it writes,
        // and the image lives as long as the kernel, or until it gets another.
        unsafe { kernel.set_image(image.view()) };
        Ok(Self { kernel, image })
    }
}

pub struct Tiles {
    gpu: Arc<Gpu>,
    lists: Lists,
    target: TileTarget,
    /// Where avatars are drawn larger than they are shown; None until a frame has one.
    atlas: Option<TileTarget>,
    inputs: RasterInputs,
    options: RendererOptions,
    /// The part of the image that is drawn, from its upper left corner, px.
    drawn: [u32; 2],
}

impl Tiles {
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        inputs: &RasterInputs,
        options: &RendererOptions,
        method: RasterMethod,
        image: Option<Arc<Image>>,
    ) -> Result<Self> {
        let image = match image {
            Some(image) => image,
            None => create_image(gpu, options, options.size)?,
        };
        let lists = if method == RasterMethod::CooperativeTiles {
            Lists::Runs(Box::new(Runs::new(gpu, inputs)?))
        } else {
            Lists::Bins(Box::new(Bins::new(gpu, inputs)?))
        };
        Ok(Self {
            gpu: gpu.clone(),
            target: TileTarget::new(gpu, &lists, inputs, options, image)?,
            atlas: None,
            lists,
            inputs: *inputs,
            options: *options,
            drawn: options.size,
        })
    }

    /// The method that it draws by.
    pub fn method(&self) -> RasterMethod {
        match self.lists {
            Lists::Runs(_) => RasterMethod::CooperativeTiles,
            Lists::Bins(_) => RasterMethod::SharedTiles,
        }
    }

    pub fn image(&self) -> &Arc<Image> {
        &self.target.image
    }

    pub fn drawn(&self) -> [u32; 2] {
        self.drawn
    }

    pub fn format(&self) -> ColorFormat {
        self.options.color()
    }

    /// Changes the image's size. On failure it stays.
    ///
    /// # Safety
    /// No submitted work may use the image or draw to it.
    pub unsafe fn resize(&mut self, size: [u32; 2]) -> Result<()> {
        let image = create_image(&self.gpu, &self.options, size)?;
        // SAFETY: no work uses the kernel, as the caller promises; `record` has the image in the
        // layout that it writes, and the image lives as long as the kernel, or until it gets
        // another.
        unsafe { self.target.kernel.set_image(image.view()) };
        self.target.image = image;
        self.drawn = size;
        Ok(())
    }

    /// Makes an atlas of a size. On failure the one before stays.
    ///
    /// # Safety
    /// No submitted work may use the one before.
    pub unsafe fn make_atlas(&mut self, size: [u32; 2]) -> Result<()> {
        let image = create_image(&self.gpu, &self.options, size)?;
        let atlas = TileTarget::new(&self.gpu, &self.lists, &self.inputs, &self.options, image)?;
        self.atlas = Some(atlas);
        Ok(())
    }

    /// The atlas, if there is one.
    pub fn atlas(&self) -> Option<&Image> {
        self.atlas.as_ref().map(|atlas| &*atlas.image)
    }

    pub fn draw_within(&mut self, size: [u32; 2]) {
        self.drawn = size;
    }

    /// Reads splats in the one buffer that it read in the other.
    ///
    /// # Safety
    /// No submitted work may draw with it, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        self.inputs.memory.replace(replacement);
        // SAFETY: the caller promises what the functions ask for.
        unsafe {
            match &mut self.lists {
                Lists::Runs(runs) => runs.replace(replacement),
                Lists::Bins(bins) => bins.replace(replacement),
            }
            self.bind(replacement);
        }
    }

    /// Gives the lists of tiles another number of blocks.
    ///
    /// # Safety
    /// No submitted work may draw with it.
    pub unsafe fn resize_lists(&mut self, blocks: u32) {
        if let Lists::Runs(runs) = &mut self.lists
            // SAFETY: the caller promises that no work uses them; the kernels bind the new ones.
            && let Some(replacement) = unsafe { runs.resize(&self.gpu, blocks) }
        {
            // SAFETY: the caller promises that no work uses them; the lists keep the new buffer.
            unsafe { self.bind(replacement) };
        }
    }

    /// # Safety
    /// No submitted work may use the kernels, and the new buffer must outlive what will.
    unsafe fn bind(&mut self, replacement: Replacement) {
        for target in std::iter::once(&mut self.target).chain(&mut self.atlas) {
            // SAFETY: the caller promises what the function asks for.
            unsafe { target.kernel.replace(replacement) };
        }
    }

    /// The lists of tiles, if the kernel walks those.
    pub fn runs(&self) -> Option<&Runs> {
        match &self.lists {
            Lists::Runs(runs) => Some(runs),
            Lists::Bins(_) => None,
        }
    }

    /// The lists of bins, if the kernel walks those.
    pub fn bins(&self) -> Option<&Bins> {
        match &self.lists {
            Lists::Runs(_) => None,
            Lists::Bins(bins) => Some(bins),
        }
    }

    /// Draws every pixel of the damage rectangle. Reads the output of `binning`; compute.
    pub fn record(&self, commands: Recording, draw: &Draw) {
        let target = match (draw.target, &self.atlas) {
            (RenderTarget::Atlas, Some(atlas)) => atlas,
            _ => &self.target,
        };
        let image = target.image.raw();
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
        let region = match self.lists {
            Lists::Runs(_) => RASTER_REGION,
            Lists::Bins(_) => SHARED_REGION,
        };
        let [first, beyond] = draw.damage.regions(region);
        target
            .kernel
            .dispatch_within(commands, draw.frame, first, beyond);
        // SAFETY: the image is alive, and in the layout that the kernel writes.
        unsafe { commands.change_layout(image, end) };
    }
}

/// Specialization constants of the `raster` kernel: the cutoff, the transmittance at which a pixel
/// counts as saturated, whether to count fragments, and where the lists are.
fn constants(lists: &Lists, options: &RendererOptions) -> Vec<u32> {
    let saturation = if options.skip.contains(Skip::SATURATED) {
        options.cutoff as f32
    } else {
        0.0
    };
    let [saturation, count] = [saturation.to_bits(), options.count.into()];
    match lists {
        Lists::Runs(_) => vec![(options.cutoff as f32).to_bits(), saturation, count],
        Lists::Bins(bins) => {
            let exponent = (options.cutoff.log2() as f32).to_bits();
            bins.constants([exponent, saturation, count]).to_vec()
        }
    }
}

/// Full subgroups of the size that the device reports, where it can be asked for that.
fn launch(gpu: &Gpu, lists: &Lists) -> Launch {
    let cooperative = matches!(lists, Lists::Runs(_));
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

fn create_image(gpu: &Arc<Gpu>, options: &RendererOptions, size: [u32; 2]) -> Result<Arc<Image>> {
    check_size(gpu, size, gpu.probe.limits.max_image_dimension2_d)?;
    let mut usage = vk::ImageUsageFlags::STORAGE
        | vk::ImageUsageFlags::SAMPLED
        | vk::ImageUsageFlags::TRANSFER_SRC;
    if options.supersampling.is_on() {
        usage |= vk::ImageUsageFlags::COLOR_ATTACHMENT;
    }
    let format = vulkan_format(options.color());
    Image::new(gpu, "target", size, format, usage).map(Arc::new)
}
