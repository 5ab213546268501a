//! The compute form of `raster`: order, splats and lists go in, an image comes out.

use super::{
    super::{
        device::Gpu,
        error::Result,
        kernel::{Blocks, Bound, Kernel},
    },
    bins::Bins,
    inputs::{Draw, RasterInputs},
    runs::Runs,
};
use crate::wgsl;
use effigy_core::{
    frame::{TileKernel, passes::Target},
    layout::{RASTER_REGION, SHARED_REGION},
};
use wgpu::{TextureFormat, TextureView};

/// The lists that a kernel walks.
enum Lists {
    Runs(Runs),
    Bins(Box<Bins>),
}

pub struct Tiles {
    lists: Lists,
    /// Draws to the image, or in turn to the atlas.
    raster: Kernel,
    kernel: TileKernel,
    format: TextureFormat,
}

impl Tiles {
    /// `image`: what it draws to, of a format.
    pub fn new(
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        kernel: TileKernel,
        format: TextureFormat,
        image: &TextureView,
    ) -> Result<Self> {
        let (lists, module) = match kernel {
            TileKernel::Shared => (
                Lists::Bins(Box::new(Bins::new(gpu, blocks, inputs)?)),
                &wgsl::RASTER_SHARED,
            ),
            // There is no cooperative kernel: such options are refused.
            TileKernel::PerThread | TileKernel::Cooperative => {
                (Lists::Runs(Runs::new(gpu, blocks, inputs)?), &wgsl::RASTER)
            }
        };
        let bound = bindings(blocks, inputs, &lists, Bound::FrameImage(image, format));
        Ok(Self {
            raster: Kernel::new(gpu, module, &bound),
            lists,
            kernel,
            format,
        })
    }

    /// The kernel that it draws with.
    pub fn kernel(&self) -> TileKernel {
        self.kernel
    }

    /// Side of the region that a workgroup draws, px.
    pub fn region(&self) -> u32 {
        match self.lists {
            Lists::Runs(_) => RASTER_REGION,
            Lists::Bins(_) => SHARED_REGION,
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

    /// Draws to another image or atlas from now on, of the same format.
    pub fn set_image(
        &mut self,
        gpu: &Gpu,
        blocks: &Blocks,
        inputs: RasterInputs,
        target: Target,
        image: &TextureView,
    ) {
        let bound = bindings(
            blocks,
            inputs,
            &self.lists,
            Bound::FrameImage(image, self.format),
        );
        self.raster.set(gpu, turn(target), &bound);
    }

    /// Blends the lists of the regions in the damage rectangle.
    pub fn record(&self, pass: &mut wgpu::ComputePass, draw: &Draw) {
        let [first, end] = draw.damage.regions(self.region());
        let groups = [end[0] - first[0], end[1] - first[1]];
        self.raster
            .dispatch_turn(pass, turn(draw.target), draw.block, groups);
    }
}

/// Which of the kernel's resources hold an image. The one that every renderer has comes first.
fn turn(target: Target) -> usize {
    match target {
        Target::Image => 0,
        Target::Atlas => 1,
    }
}

fn bindings<'a>(
    blocks: &'a Blocks,
    inputs: RasterInputs<'a>,
    lists: &'a Lists,
    image: Bound<'a>,
) -> [(u32, Bound<'a>); 7] {
    let [third, fourth, fifth] = match lists {
        Lists::Runs(runs) => [Bound::Read(runs.buffer()), image, Bound::Read(inputs.keys)],
        Lists::Bins(bins) => [
            Bound::Read(bins.sorted()),
            Bound::Read(bins.buffer()),
            image,
        ],
    };
    [
        blocks.frame(),
        (1, Bound::Read(inputs.splats)),
        (2, Bound::Write(inputs.control.into())),
        (3, third),
        (4, fourth),
        (5, fifth),
        blocks.settings(),
    ]
}
