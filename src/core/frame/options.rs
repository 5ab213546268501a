//! Renderer options: everything that trades time or memory for quality.

use super::Skip;
use crate::layout::{
    SORT_DIGITS, SORT_GROUP, SORT_ONESWEEP_TILE, SORT_RUNS, SORT_STATE, SORT_TILE,
};
use crate::{
    avatar::Filter,
    constants::ALPHA_MIN,
    scene::{Detail, Supersampling},
};
use serde::{Deserialize, Serialize};

/// The options of a renderer. [`RendererOptions::check`] says whether they are valid.
#[derive(Clone, Copy, Debug)]
pub struct RendererOptions {
    /// Width and height of the image, px.
    pub size: [u32; 2],
    /// How splats are rasterized. None: the method recommended for the device.
    pub method: Option<RasterMethod>,
    /// Store the image in 16-bit floats by every method ([`Self::color`]). [`Self::exactly`] also
    /// turns off what changes it by more than rounding.
    pub exact: bool,
    /// How to sort. None: the fastest variant that passes the device's self-test.
    pub sort: Option<SortVariant>,
    /// Work that may be skipped where the scene does not need it.
    pub skip: Skip,
    /// Contributions below this opacity are not drawn, at least 1/255 (docs/model.md, step 10).
    pub cutoff: f64,
    /// How many of an avatar's Gaussians are drawn.
    pub detail: Detail,
    /// How many times its size an avatar is drawn, before it is averaged.
    pub supersampling: Supersampling,
    /// The low-pass to draw with. None: the avatar's own, with which alone it looks as it was
    /// learned.
    pub filter: Option<Filter>,
    /// Maximum number of people in a scene, 1 to 1024; memory grows with it.
    pub instances: usize,
    /// Maximum number of Gaussians that a frame draws, of all copies together; memory grows with it,
    /// too. If there are more, the copies with the most Gaussians a pixel are drawn from coarser
    /// levels ([`super::capacity`]). None: those of all copies; with more than 16 copies, as many as
    /// four have.
    pub gaussians: Option<u32>,
    /// Count fragments, where the device can, and why Gaussians are culled. For measurements: some
    /// devices are slower then.
    pub count: bool,
}

impl RendererOptions {
    /// Format of the image, of resolved options.
    pub fn color(&self) -> ColorFormat {
        match self.method {
            Some(method) if method.is_tiles() && !self.exact => ColorFormat::Rgba8,
            _ => ColorFormat::Rgba16F,
        }
    }

    /// Whether images that change from frame to frame may go to the screen in the render pass that
    /// draws them, of resolved options. So it is with quads, which suit GPUs that blend in tile
    /// memory: the image never leaves that. Not where fragments are counted, which would be those of
    /// both.
    pub fn shows_at_once(&self) -> bool {
        self.method == Some(RasterMethod::Quads) && !self.count
    }

    /// These options for an image that is exact: nothing is skipped or added that changes it by
    /// more than rounding. Quads draw what lies behind the saturation depth, small avatars are
    /// drawn as the model says and not as the area of each pixel shows them, and all of a crowd is
    /// drawn.
    pub fn exactly(self) -> Self {
        Self {
            exact: true,
            skip: self.skip - Skip::DEPTH,
            cutoff: ALPHA_MIN,
            detail: Detail::FULL,
            supersampling: Supersampling::OFF,
            gaussians: Some(u32::MAX),
            ..self
        }
    }

    /// The defaults for an image of a width and height, px.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            size,
            method: None,
            exact: false,
            sort: None,
            skip: Skip::all(),
            cutoff: ALPHA_MIN,
            detail: Detail::FULL,
            supersampling: Supersampling::BySize,
            filter: None,
            instances: 1,
            gaussians: None,
            count: false,
        }
    }
}

/// Format that the image is blended or stored in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum ColorFormat {
    /// 8 bits a channel: 4 bytes a pixel. For tiles, which round each pixel once.
    Rgba8,
    /// 16-bit floating point: 8 bytes a pixel. For quads, which round with every Gaussian, and for
    /// exact images.
    Rgba16F,
}

impl ColorFormat {
    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rgba8 => "rgba8",
            Self::Rgba16F => "rgba16f",
        }
    }

    /// Bytes of a pixel.
    pub fn bytes(self) -> usize {
        match self {
            Self::Rgba8 => 4,
            Self::Rgba16F => 8,
        }
    }
}

/// How splats are rasterized: one way for each class of device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum RasterMethod {
    /// Quads through the graphics pipeline: for phones' GPUs, which blend them in tile memory.
    Quads,
    /// A compute kernel whose workgroups of 256 invocations read the list of their bin in batches
    /// into shared memory, with a bit for each 4 × 4 of its 32 × 32 pixels that a splat's ellipse
    /// meets, until all pixels are saturated: for desktop GPUs.
    SharedTiles,
    /// A compute kernel whose subgroups each lie in one tile of at least 16 × 16 pixels and shuffle
    /// splats between their 4 or 8 invocations, of 4 × 4 pixels each, until all are saturated: for
    /// CPU drivers, which execute subgroups in step. Mali's compiler spills 700 registers.
    CooperativeTiles,
}

impl RasterMethod {
    /// Every method.
    pub const ALL: [Self; 3] = [Self::Quads, Self::SharedTiles, Self::CooperativeTiles];

    /// Its name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quads => "quads",
            Self::SharedTiles => "tiles-shared",
            Self::CooperativeTiles => "tiles-cooperative",
        }
    }

    /// Whether a compute kernel draws.
    pub fn is_tiles(self) -> bool {
        self != Self::Quads
    }
}

/// The variants of the radix sort; docs/architecture.md compares them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum SortVariant {
    /// One pass a digit, with decoupled look-back.
    OneSweep,
    /// Histograms of all tiles, then a scan, then a scatter.
    ReduceThenScan,
    /// Each invocation sorts a run of keys of its own: for CPU drivers.
    PerThread,
}

impl SortVariant {
    /// Every variant.
    pub const ALL: [Self; 3] = [Self::OneSweep, Self::ReduceThenScan, Self::PerThread];

    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::OneSweep => "OneSweep",
            Self::ReduceThenScan => "reduce-then-scan",
            Self::PerThread => "per-thread",
        }
    }

    /// Keys of a tile: how many one workgroup sorts.
    pub fn tile(self) -> u32 {
        match self {
            Self::OneSweep => SORT_ONESWEEP_TILE,
            Self::ReduceThenScan => SORT_TILE,
            Self::PerThread => 1024 * SORT_RUNS,
        }
    }

    /// Bytes of the counts of a sort of this many tiles; `shaders/sort/pass.glsl` has their layout.
    pub fn counts_size(self, tiles: u32) -> u64 {
        let groups = u64::from(tiles.div_ceil(SORT_GROUP));
        let tiles = u64::from(tiles);
        let areas = match self {
            Self::OneSweep => 2 * tiles,
            Self::ReduceThenScan => 0,
            Self::PerThread => u64::from(SORT_RUNS + 1) * tiles,
        };
        4 * (u64::from(SORT_DIGITS) * (tiles + 3 + groups + areas) + u64::from(SORT_STATE))
    }
}
