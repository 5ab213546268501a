//! The compute form of `raster`: order, splats and lists of bins go in, an image comes out.

use super::{
    super::{
        device::Gpu,
        error::Result,
        kernel::{Blocks, Bound, Kernel},
    },
    bins::Bins,
    inputs::{Draw, RasterInputs},
};
use crate::wgsl;
use effigy_core::{frame::passes::RenderTarget, layout::SHARED_REGION};
use wgpu::{TextureFormat, TextureView};

pub struct Tiles {
    bins: Bins,
    /// Draws to the image, or in turn to the atlas.
    raster: Kernel,
    format: TextureFormat,
}

impl Tiles {
    /// `image`: what it draws to, of a format.
    pub fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        format: TextureFormat,
        image: &TextureView,
    ) -> Result<Self> {
        let bins = Bins::new(gpu, blocks, inputs)?;
        let bound = bindings(blocks, inputs, &bins, Bound::FrameImage(image, format));
        Ok(Self {
            raster: Kernel::new(gpu, &wgsl::RASTER_SHARED, &bound),
            bins,
            format,
        })
    }

    /// The lists of bins.
    pub fn bins(&self) -> &Bins {
        &self.bins
    }

    /// Draws to another image or atlas from now on, of the same format.
    pub fn set_image(
        &mut self,
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        target: RenderTarget,
        image: &TextureView,
    ) {
        let image = Bound::FrameImage(image, self.format);
        let bound = bindings(blocks, inputs, &self.bins, image);
        self.raster.set(gpu, turn(target), &bound);
    }

    /// Blends the lists of the regions in the damage rectangle.
    pub fn record(&self, pass: &mut wgpu::ComputePass, draw: &Draw) {
        let [first, end] = draw.damage.regions(SHARED_REGION);
        let groups = [end[0] - first[0], end[1] - first[1]];
        self.raster
            .dispatch_turn(pass, turn(draw.target), draw.block, groups);
    }
}

/// Which of the kernel's resources hold an image. The one that every renderer has comes first.
fn turn(target: RenderTarget) -> usize {
    match target {
        RenderTarget::Image => 0,
        RenderTarget::Atlas => 1,
    }
}

fn bindings<'a>(
    blocks: &'a Blocks,
    inputs: RasterInputs<'a>,
    bins: &'a Bins,
    image: Bound<'a>,
) -> [(u32, Bound<'a>); 7] {
    [
        blocks.frame(),
        (1, Bound::Read(inputs.splats)),
        (2, Bound::Write(inputs.control.into())),
        (3, Bound::Read(bins.sorted())),
        (4, Bound::Read(bins.buffer())),
        (5, image),
        blocks.settings(),
    ]
}
