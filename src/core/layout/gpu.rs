//! Every struct and constant that the GPU reads. `shaders/common` mirrors the structs in
//! `frame.glsl`, `control.glsl` and `settings.glsl`; `tests/host/layout.rs` compares the two by
//! reflecting the compiled modules. [`super::MACROS`] passes the constants to the shader compiler.
//!
//! Buffers are arrays of 32-bit words, of 16-byte vectors, or of "half quads": four f16 in eight
//! bytes, the same bytes whether a device reads them as f16 or unpacks words.

#[cfg(doc)]
use crate::avatar::LowPass;
use crate::avatar::limits;
use bytemuck::{Pod, Zeroable};

/// Invocations of a workgroup of the mlp stage: one for each neuron of the paper's layers.
pub const MLP_WORKGROUP: u32 = 64;
/// Invocations of a workgroup of the sh stage.
pub const SH_WORKGROUP: u32 = 64;
/// Invocations of a workgroup of the `project` stage.
pub const PROJECT_WORKGROUP: u32 = 64;
/// Invocations of a workgroup of the sort: the 128 that every Vulkan device has.
pub const SORT_WORKGROUP: u32 = 128;
/// Keys of a tile of the reduce-then-scan sort.
pub const SORT_TILE: u32 = 4096;
/// Invocations of a workgroup of the per-thread sort, each with its own counters: 8 KB in all.
pub const SORT_RUNS: u32 = 8;
/// Keys of a tile of OneSweep.
pub const SORT_ONESWEEP_TILE: u32 = 2048;
/// Tiles whose histograms one workgroup sums, if there are too many for every workgroup to sum them
/// all.
pub const SORT_GROUP: u32 = 32;
/// The most tiles whose histograms each scatter kernel of the sort sums itself. With more, two
/// kernels before it do.
pub const MAX_SUMMED_TILES: u32 = 128;
/// How often a workgroup of OneSweep polls an earlier tile's count before it counts that tile
/// itself.
pub const SORT_POLLS: u32 = 1024;
/// Words of the sort's state: a ticket a pass, and at [`SORT_FALLBACKS`] how often a workgroup
/// counted another workgroup's tile.
pub const SORT_STATE: u32 = 16;
/// Word of the sort's state that counts fallbacks.
pub const SORT_FALLBACKS: u32 = 8;
/// Values of a sort digit.
pub const SORT_DIGITS: u32 = 256;
/// The key of a Gaussian that is not drawn; the sort discards it.
pub const SORT_CULLED: u32 = u32::MAX;

/// Quads in an instance of the draw. One quad an instance is slow on several drivers
/// (docs/architecture.md, "Device facts").
pub const QUADS_PER_INSTANCE: u32 = 128;
/// Pairs of words of a Gaussian in the model buffer.
pub const GAUSSIAN_PAIRS: u32 = 4;
/// Pairs of words that 32 Gaussians share.
pub const BLOCK_PAIRS: u32 = 4;
/// Words of a Gaussian in the pose cache, but for where it faces.
pub const POSE_CACHE_WORDS: u32 = 6;
/// Words of where a Gaussian faces there.
pub const POSE_CACHE_FACING_WORDS: u32 = 1;
/// Vectors of 128 bits, one bit for each part that an avatar may have.
pub const PART_BITS: usize = limits::PARTS / 128;
/// Levels of tiles, each with a sixteenth of the tiles of the one before; the last is one tile, the
/// whole image.
pub const TILE_LEVELS: u32 = 4;
/// Runs of the drawing order, one for each invocation of the binning stage and bit of a word.
pub const BINNING_RUNS: u32 = 32;
/// Invocations of a workgroup of the binning stage.
pub const BINNING_WORKGROUP: u32 = 8;
/// Words of a block of a tile's list: a link, then splats.
pub const BINNING_BLOCK: u32 = 8;
/// Maximum number of tiles whose lists a splat enters at one level.
pub const BINNING_TILES_MAX: u32 = 16;
/// Side of the square that an invocation of the tile rasterizer draws, px.
pub const RASTER_SQUARE: u32 = 4;
/// Side of the region that a workgroup of the tile rasterizer draws, px: 8 × 8 invocations.
pub const RASTER_REGION: u32 = 8 * RASTER_SQUARE;
/// Invocations of a workgroup of the tile rasterizer.
pub const RASTER_WORKGROUP: u32 = 64;
/// Sides that bins may have: the finest, and each twice as long as the one before. With the last an
/// image of 16384 px is one bin.
pub const BIN_SIDES: u32 = 10;
/// Splats whose pairs a workgroup of the binning stage makes.
pub const BIN_BLOCK: u32 = 256;
/// Invocations of a workgroup that makes bins.
pub const BIN_WORKGROUP: u32 = 128;
/// Side of the region that a workgroup of the shared-memory tile rasterizer draws, px: 16 × 16
/// invocations of 2 × 2 pixels.
pub const SHARED_REGION: u32 = 32;
/// Invocations of a workgroup of the shared-memory tile rasterizer.
pub const SHARED_WORKGROUP: u32 = 256;
/// Side of the region that a workgroup of the saturation stage takes, px: 8 × 8 invocations of
/// 2 × 2 samples, each of 2 × 2 pixels.
pub const SATURATION_REGION: u32 = 32;
/// Invocations of a workgroup of the copy that measures bandwidth.
pub const RATES_WORKGROUP: u32 = 64;
/// Bits of a splat's fixed-point coordinate ([`super::CenterGrids`]).
pub const POSITION_BITS: u32 = 20;
/// Bits of the quotient of two neighbouring grids' steps ([`super::CenterGrids`]).
pub const CENTER_GRID_BITS: u32 = 6;

/// Vectors for network inputs in [`FrameBlock`].
pub const INPUT_QUADS: usize = limits::MLP_INPUT / 4;

/// Where a layer of the networks is in a part's block, in half quads.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct LayerLayout {
    /// Quads of inputs, the last padded with zeros.
    pub input_quads: u32,
    /// Neurons.
    pub output_count: u32,
    /// Where in a part's block the weights start: quad k of neuron o is at
    /// `weight + k · output_count + o`.
    pub weight: u32,
    /// Where in a part's block the biases start, four a quad.
    pub bias: u32,
}

/// The uniform block of one avatar in one frame, with the sizes of the model. It stays within the
/// 16 KB that every device has.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct FrameBlock {
    /// Focal lengths, px.
    pub focal: [f32; 2],
    /// Principal point, px.
    pub center: [f32; 2],
    /// Smallest x/z and y/z for the perspective's derivative.
    pub derivative_min: [f32; 2],
    /// Largest x/z and y/z for the perspective's derivative.
    pub derivative_max: [f32; 2],
    /// Width and height, px.
    pub size: [f32; 2],
    /// How far outside the image the finest grid of centres reaches, px.
    pub guard: f32,
    /// Nearest depth drawn, metres.
    pub near: f32,
    /// Depth of key 0 (the far end), metres; keys grow towards the camera by `key_scale` a metre up
    /// to `key_max`.
    pub key_far: f32,
    /// Keys a metre.
    pub key_scale: f32,
    /// Largest key of a depth.
    pub key_max: u32,
    /// Steps of the finest grid of centres in a pixel.
    pub fixed_scale: f32,
    /// Gaussian positions: `position_min + step · 16-bit coordinate`, metres.
    pub position_min: [f32; 4],
    /// Metres a step of a 16-bit coordinate.
    pub position_step: [f32; 4],
    /// From a splat's coordinates to clip space: `(steps − z) · xy − 1`; w is a standard deviation
    /// of √(2 ln 2) px in steps.
    pub clip: [f32; 4],
    /// Gaussians of the avatar.
    pub gaussians: u32,
    /// Position nodes of the avatar.
    pub nodes: u32,
    /// Parts of the avatar.
    pub parts: u32,
    /// Parts, from the first on, whose networks see the expression.
    pub head_parts: u32,
    /// N_B / 4.
    pub basis_quads: u32,
    /// Length of e / 4.
    pub feature_quads: u32,
    /// Where in e the nodes' features start, in quads.
    pub node_feature: u32,
    /// Where in the pose buffer the nodes' displacements start, in vectors. A node takes half a
    /// vector.
    pub node_start: u32,
    /// Where in the row buffer the rows of rotations start, in words.
    pub rotation_start: u32,
    /// Where the rows of scales start, in words.
    pub scale_start: u32,
    /// Where the rows of colours start, in words.
    pub color_start: u32,
    /// Factor of negative activations.
    pub slope: f32,
    /// Layers of a network.
    pub layers: u32,
    /// Half quads of a part's network.
    pub network_quads: u32,
    /// Where in the splats' buffer the keys start, in words.
    pub key_start: u32,
    /// Opacity under which nothing is drawn, of 255.
    pub cutoff: f32,
    /// Quads are sized for at least this opacity, of 255; 0 fits them to each Gaussian.
    pub quad_opacity: f32,
    /// Quads of inputs that the first layer reads outside the head; later ones are zero.
    pub body_quads: u32,
    /// Log scales: `log_scale_min + log_scale_step · 10-bit code`.
    pub log_scale_min: f32,
    /// Log scale a code.
    pub log_scale_step: f32,
    /// Where in the model the view-dependent colours start, in pairs; 0 without spherical
    /// harmonics.
    pub sh_color_start: u32,
    /// Where in the model the words are that say from where Gaussians are drawn, in pairs; 0: all
    /// are drawn from everywhere.
    pub facing_start: u32,
    /// Where in the splats' buffer the sort's first counts start, in words.
    pub count_start: u32,
    /// How many keys share a row of counts.
    pub count_tile: u32,
    /// Where in the splats' buffer this avatar's pose cache starts, in words.
    pub cache_start: u32,
    /// Unit of the longest axes in the pose cache, metres.
    pub cache_unit: f32,
    /// Where in the pose buffer this avatar's features start, in vectors.
    pub feature_start: u32,
    /// Index of this avatar's first splat and key among those of the scene.
    pub first_splat: u32,
    /// Side of a tile, px.
    pub tile_side: f32,
    /// Level of detail: every 2^`detail_level`-th Gaussian is drawn.
    pub detail_level: u32,
    /// Gaussians drawn.
    pub drawn: u32,
    /// Factor on covariances at this level of detail.
    pub covariance_scale: f32,
    /// Side of the finest bins, px.
    pub bin_side: u32,
    /// [`LowPass::variance`], px².
    pub low_pass: f32,
    /// [`LowPass::compensation`].
    pub compensation: f32,
    /// How much of a splat must be within `area`: 1 any of it, −1 all of it.
    pub area_reach: f32,
    /// First and last corner of what this avatar may draw to, px.
    pub area: [f32; 4],
    /// Lower corner of the box that positions in the pose cache are relative to, metres.
    pub cache_min: [f32; 4],
    /// Sides of that box, metres.
    pub cache_size: [f32; 4],
    /// Rows of the matrix from the pose cache's space to the camera's.
    pub camera_from_cache: [[f32; 4]; 3],
    /// A bit for each part whose network need not run.
    pub idle_parts: [[u32; 4]; PART_BITS],
    /// A bit for each part that is all outside the view.
    pub culled_parts: [[u32; 4]; PART_BITS],
    /// Where each layer of the networks is in a part's block; `layers` of them are used.
    pub layer: [LayerLayout; limits::MLP_LAYERS],
    /// θ_p ⊕ θ_e as the head parts see it, then as the others do, with zeros for θ_e.
    pub input: [[[f32; 4]; INPUT_QUADS]; 2],
    /// Rows of view · G_j, canonical space to camera, three a joint.
    pub joint: [[[f32; 4]; 3]; limits::JOINTS],
}

impl FrameBlock {
    /// Words of a Gaussian in the pose cache.
    pub fn pose_cache_words(&self) -> u32 {
        if self.facing_start > 0 {
            POSE_CACHE_WORDS + POSE_CACHE_FACING_WORDS
        } else {
            POSE_CACHE_WORDS
        }
    }
}

const _: () = assert!(
    size_of::<FrameBlock>() <= 16384,
    "a uniform block is at most 16 KB on the smallest devices"
);

/// Settings of the WGSL shaders, which are specialization constants in Vulkan:
/// `shaders/common/settings.glsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SettingsBlock {
    /// Base-2 logarithm of the opacity under which nothing is drawn.
    pub cutoff_exponent: f32,
    /// Quads are sized for at least this base-2 logarithm of opacity.
    pub quad_exponent: f32,
    /// Opacity under which nothing is drawn.
    pub cutoff: f32,
    /// A pixel is saturated when its transmittance is below this.
    pub saturation: f32,
    /// Capacity of the sort, tiles.
    pub sort_tiles: u32,
    /// Capacity of the sort, keys.
    pub key_capacity: u32,
    /// Whether the tiles are too many for every workgroup to sum their histograms.
    pub scanned: u32,
    /// Keys that enter the sort.
    pub key_count: u32,
    /// Whether fragments and culled Gaussians are counted.
    pub counted: u32,
    /// 0.
    pub unused: u32,
    /// Column and row of the first region to draw.
    pub first_region: [u32; 2],
    /// [`BinLayout::counts_start`](super::BinLayout::counts_start).
    pub counts_start: u32,
    /// [`BinLayout::starts_start`](super::BinLayout::starts_start).
    pub starts_start: u32,
    /// [`BinLayout::pairs_start`](super::BinLayout::pairs_start).
    pub pairs_start: u32,
    /// [`BinLayout::pairs`](super::BinLayout::pairs).
    pub pair_capacity: u32,
}

/// Counts that the sort writes and the draw reads. The first five words are a
/// `VkDrawIndexedIndirectCommand`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
pub struct Control {
    /// Indices of an instance of the draw.
    pub index_count: u32,
    /// `visible_count` in groups of [`QUADS_PER_INSTANCE`], rounded up.
    pub instance_count: u32,
    /// 0.
    pub first_index: u32,
    /// 0.
    pub vertex_offset: i32,
    /// 0.
    pub first_instance: u32,
    /// Keys that enter the sort.
    pub key_count: u32,
    /// Keys that leave it: those that were not [`SORT_CULLED`].
    pub visible_count: u32,
    /// Pixels that the tile rasterizer evaluated, if they are counted.
    pub fragments: u32,
}
