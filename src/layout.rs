//! Every struct and constant that the GPU reads, once. `shaders/layout.glsl` mirrors the structs; `tests/layout.rs` compares the two
//! by reflecting the compiled modules; [`MACROS`] hands the constants to the shader compiler, so that no number stands twice.
//!
//! Buffers are arrays of 32-bit words, of 16-byte vectors, or of "half quads": four f16 in eight bytes, the same bytes whether a
//! device reads them as f16 or unpacks words.

pub mod bins;
pub mod compact;
pub mod harmonics;
pub mod pack;

use crate::{avatar::limits, frame};
use bytemuck::{Pod, Zeroable};

/// Invocations of a workgroup of `features`: one for each neuron of the paper's layers.
pub const FEATURES_SIZE: u32 = 64;
/// Invocations of a workgroup of `harmonics`.
pub const HARMONICS_SIZE: u32 = 64;
/// Invocations of a workgroup of `splats`.
pub const SPLATS_SIZE: u32 = 64;
/// Invocations of a workgroup of the sort: the 128 that every Vulkan device has.
pub const SORT_SIZE: u32 = 128;
/// Keys of a tile of the sort that needs no subgroups.
pub const SORT_TILE: u32 = 4096;
/// Invocations of a workgroup of the sort where each has counters of its own: 8 KB of them.
pub const SORT_LANES: u32 = 8;
/// Keys of a tile of OneSweep; the other variants choose theirs when they are made.
pub const SORT_CHAIN_TILE: u32 = 2048;
/// Tiles whose histograms are summed in one go where there are too many for every workgroup to sum them all.
pub const SORT_GROUP: u32 = 64;
/// Looks at an earlier tile's count before a workgroup of OneSweep counts that tile itself.
pub const SORT_POLLS: u32 = 1024;
/// Words of the sort's state: a ticket a pass, and at [`SORT_FALLBACKS`] how often a workgroup counted another's tile.
pub const SORT_STATE: u32 = 16;
/// Where in the sort's state its fallbacks are counted.
pub const SORT_FALLBACKS: u32 = 8;
/// Values of a sort digit.
pub const SORT_DIGITS: u32 = 256;
/// A key that the sort drops: what `splats` writes for a Gaussian that is not drawn.
pub const SORT_DROPPED: u32 = u32::MAX;
/// Quads in an instance of the draw. One quad an instance is slow on several drivers (design.md, "Device facts").
pub const RASTER_QUADS: u32 = 128;
/// Pairs of words of a Gaussian in the model buffer.
pub const GAUSSIAN_PAIRS: u32 = 4;
/// Pairs of words that every 32 Gaussians have together.
pub const BLOCK_PAIRS: u32 = 4;
/// Words of a Gaussian that are kept where only the camera moves.
pub const POSED_WORDS: u32 = 5;
/// Vectors in which every part has a bit.
pub const PART_BITS: usize = limits::PARTS / 128;
/// Texels along each side of the depth surface as it is drawn.
pub const SURFACE_DRAWN: u32 = 384;
/// Texels along each side of the pyramid's finest level.
pub const SURFACE_FINEST: u32 = SURFACE_DRAWN / 2;
/// Levels of the depth surface's pyramid; each halves the one before.
pub const SURFACE_LEVELS: u32 = 4;
/// Words of the pyramid in the pose buffer, two texels each.
pub const PYRAMID_WORDS: u32 = {
    let (mut words, mut level) = (0, 0);
    while level < SURFACE_LEVELS {
        words += (SURFACE_FINEST >> level) * (SURFACE_FINEST >> level) / 2;
        level += 1;
    }
    words
};
/// Texels of the finest level along the sides of a workgroup of `surface`: two or more of the coarsest level across, which share a word.
pub const SURFACE_WIDTH: u32 = 16;
pub const SURFACE_HEIGHT: u32 = 8;
/// How the Vulkan backend cuts pictures into tiles.
pub const BINS: bins::Tiling = bins::Tiling { side: 128, least: 16, nodes: 1 };
/// How the WebGPU backend does. Four lanes of a processor blend 8 by 8 pixels: each splat of a tile costs them the same, whether it meets
/// them or not.
pub const BINS_WEB: bins::Tiling = bins::Tiling { side: 256, least: 2 * RASTER_SQUARE, nodes: 2 };
/// Levels of tiles, each of a sixteenth of the tiles before it; the last is one tile, the whole picture.
pub const BINS_LEVELS: u32 = 4;
/// Blocks of the drawing order, an invocation of `bins` each: a bit of a word each.
pub const BINS_BLOCKS: u32 = 32;
/// Invocations of a workgroup of `bins`.
pub const BINS_SIZE: u32 = 8;
/// Words of a node of a tile's chain: a link, and splats.
pub const BINS_NODE: u32 = 8;
/// Tiles that a splat may meet and still be in each one's chain.
pub const BINS_NARROW: u32 = 16;
/// Pixels along each side of what an invocation of the compute form of `raster` draws.
pub const RASTER_SQUARE: u32 = 4;
/// Pixels along each side of what a workgroup of it draws: 8 by 8 invocations.
pub const RASTER_REGION: u32 = 8 * RASTER_SQUARE;
/// Invocations of such a workgroup.
pub const RASTER_SIZE: u32 = 64;
/// Bits of a splat's coordinate: a fixed-point number from −guard to guard + size.
pub const POSITION_BITS: u32 = 20;

/// Vectors for network inputs in [`Frame`].
pub const INPUT_QUADS: usize = limits::MLP_INPUT / 4;

/// Name and value of the constants that the shaders see as macros.
pub const MACROS: &[(&str, u32)] = &[
    ("FEATURES_SIZE", FEATURES_SIZE),
    ("HARMONICS_SIZE", HARMONICS_SIZE),
    ("SPLATS_SIZE", SPLATS_SIZE),
    ("SORT_SIZE", SORT_SIZE),
    ("SORT_TILE", SORT_TILE),
    ("SORT_LANES", SORT_LANES),
    ("SORT_CHAIN_TILE", SORT_CHAIN_TILE),
    ("SORT_GROUP", SORT_GROUP),
    ("SORT_POLLS", SORT_POLLS),
    ("SORT_STATE", SORT_STATE),
    ("SORT_FALLBACKS", SORT_FALLBACKS),
    ("SORT_DIGITS", SORT_DIGITS),
    ("SORT_DROPPED", SORT_DROPPED),
    ("RASTER_QUADS", RASTER_QUADS),
    ("GAUSSIAN_PAIRS", GAUSSIAN_PAIRS),
    ("BLOCK_PAIRS", BLOCK_PAIRS),
    ("PART_BITS", PART_BITS as u32),
    ("SURFACE_DRAWN", SURFACE_DRAWN),
    ("SURFACE_FINEST", SURFACE_FINEST),
    ("SURFACE_LEVELS", SURFACE_LEVELS),
    ("SURFACE_WIDTH", SURFACE_WIDTH),
    ("SURFACE_HEIGHT", SURFACE_HEIGHT),
    ("BINS_SIDE", BINS.side),
    ("BINS_WEB_SIDE", BINS_WEB.side),
    ("BINS_LEVELS", BINS_LEVELS),
    ("BINS_TILES", BINS.tiles()),
    ("BINS_WEB_TILES", BINS_WEB.tiles()),
    ("BINS_BLOCKS", BINS_BLOCKS),
    ("BINS_SIZE", BINS_SIZE),
    ("BINS_NODE", BINS_NODE),
    ("BINS_NARROW", BINS_NARROW),
    ("RASTER_SQUARE", RASTER_SQUARE),
    ("RASTER_REGION", RASTER_REGION),
    ("RASTER_SIZE", RASTER_SIZE),
    ("POSITION_BITS", POSITION_BITS),
    ("INPUT_QUADS", INPUT_QUADS as u32),
    ("MLP_WIDTH", limits::MLP_WIDTH as u32),
    ("MLP_LAYERS", limits::MLP_LAYERS as u32),
    ("JOINTS", limits::JOINTS as u32),
    ("FEATURE_MAX", frame::FEATURE_MAX as u32),
    ("LOG_SCALE_MAX", frame::LOG_SCALE_MAX as u32),
];

/// A layer of the networks, in half quads.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct Layer {
    /// Quads of inputs, the last padded with zeros.
    pub input_quads: u32,
    /// Neurons.
    pub output: u32,
    /// Where in a part's block the weights start: quad k of neuron o is at `weight + k · output + o`.
    pub weight: u32,
    /// Where in a part's block the biases start, four a quad.
    pub bias: u32,
}

/// What changes from frame to frame, and the sizes of the model: one uniform block, within the 16 KB that every device has.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Frame {
    /// Focal lengths and principal point, px.
    pub focal: [f32; 2],
    pub center: [f32; 2],
    /// Smallest and largest x/z and y/z for the perspective's derivative.
    pub derivative_min: [f32; 2],
    pub derivative_max: [f32; 2],
    /// Width and height, px.
    pub size: [f32; 2],
    /// How far outside the picture a centre may lie, px.
    pub guard: f32,
    /// Nearest depth drawn, metres.
    pub near: f32,
    /// Depth of key 0 (the far end), metres; keys grow towards the camera by `key_scale` a metre up to `key_max`.
    pub key_far: f32,
    pub key_scale: f32,
    pub key_max: u32,
    /// Steps of a splat's fixed-point coordinate in a pixel.
    pub fixed_scale: f32,
    /// Gaussian positions: `position_min + step · 16-bit coordinate`, metres.
    pub position_min: [f32; 4],
    pub position_step: [f32; 4],
    /// From a splat's coordinates to the clip space: `(steps − z) · xy − 1`; w is what a standard deviation of √(2 ln 2) is, steps.
    pub clip: [f32; 4],
    pub gaussians: u32,
    pub nodes: u32,
    pub parts: u32,
    pub head_parts: u32,
    /// N_B / 4.
    pub basis_quads: u32,
    /// Length of e / 4.
    pub feature_quads: u32,
    /// Where in e the nodes' features start, in quads.
    pub node_feature: u32,
    /// Where in the pose buffer the nodes' displacements start, in vectors. A node takes half a vector.
    pub node_start: u32,
    /// Where in the row buffer each attribute's rows start, in words.
    pub rotation_start: u32,
    pub scale_start: u32,
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
    /// What the depth surface is pushed back by, metres.
    pub margin: f32,
    /// Where in the pose buffer the pyramid starts, in words, its finest level first; 0 without a depth surface.
    pub surface_start: u32,
    /// Where in the picture the depth surface starts, px.
    pub surface_origin: [f32; 2],
    /// Texels of the pyramid's finest level in a pixel.
    pub surface_scale: [f32; 2],
    /// Hulls reach as far as for at least this opacity, of 255: 0 fits them to each Gaussian.
    pub hull_opacity: f32,
    /// Quads of inputs of the first layer outside the head: those after are zeros.
    pub body_quads: u32,
    /// Log scales: `log_scale_min + log_scale_step · 10-bit code`.
    pub log_scale_min: f32,
    pub log_scale_step: f32,
    /// Where in the model the colours that the camera sees start, in pairs; 0 where no harmonics make any.
    pub lit_start: u32,
    /// Whether two keys share a word.
    pub half_keys: u32,
    /// Where in the splats' buffer the sort's first counts start, in words, and how many keys share a row of them.
    pub count_start: u32,
    pub count_tile: u32,
    /// Where in the splats' buffer this avatar's posed Gaussians start, in words.
    pub posed_start: u32,
    /// What their longest axes are counted in, metres.
    pub posed_unit: f32,
    /// Where in the pose buffer this avatar's features start, in vectors.
    pub feature_start: u32,
    /// Where in the scene's splats and keys this avatar's start.
    pub first: u32,
    /// Side of a tile, px.
    pub tile: f32,
    /// The level of detail: every 2^`level`-th Gaussian is drawn, `drawn` in all, and what that multiplies covariances by.
    pub level: u32,
    pub drawn: u32,
    pub spread: f32,
    pub unused: [u32; 2],
    /// The box that their positions are coordinates in: its lower corner and its sides, metres.
    pub posed_min: [f32; 4],
    pub posed_size: [f32; 4],
    /// Rows of the map from the space that they are in to the camera's.
    pub turn: [[f32; 4]; 3],
    /// A bit for each part whose network need not run.
    pub idle: [[u32; 4]; PART_BITS],
    /// A bit for each part that is all outside the view.
    pub outside: [[u32; 4]; PART_BITS],
    pub layer: [Layer; limits::MLP_LAYERS],
    /// θ_p ⊕ θ_e as the head parts see it, then as the others do, with zeros for θ_e.
    pub input: [[[f32; 4]; INPUT_QUADS]; 2],
    /// Rows of view · G_j, canonical space to camera, three a joint.
    pub joint: [[[f32; 4]; 3]; limits::JOINTS],
}

const _: () = assert!(size_of::<Frame>() <= 16384, "a uniform block is at most 16 KB on the smallest devices");

/// What Vulkan takes as specialization constants, for shaders in WGSL: `shaders/settings.glsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Settings {
    /// Exponent of two of the opacity under which nothing is drawn.
    pub least: f32,
    /// Hulls reach as far as for at least this exponent.
    pub hull: f32,
    /// Opacity under which nothing is drawn.
    pub cutoff: f32,
    /// A pixel is full when what lies behind would show by less than this.
    pub full: f32,
    /// Tiles and keys that the sort has room for.
    pub tiles: u32,
    pub capacity: u32,
    /// Whether the tiles are too many for every workgroup to sum their histograms.
    pub scanned: u32,
    /// Keys that enter the sort.
    pub entering: u32,
    /// Nodes for the tiles of the picture.
    pub nodes: u32,
    /// Whether fragments and Gaussians left out are counted.
    pub count: u32,
    /// Column and row of the first region that is drawn.
    pub first_region: [u32; 2],
}

/// Counts that the sort writes and the draw reads. The first five words are a VkDrawIndexedIndirectCommand.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
pub struct Control {
    pub index_count: u32,
    /// `survivors` in groups of [`RASTER_QUADS`], rounded up.
    pub instance_count: u32,
    pub first_index: u32,
    pub vertex_offset: i32,
    pub first_instance: u32,
    /// Keys that enter the sort.
    pub entering: u32,
    /// Keys that leave it: those that were not [`SORT_DROPPED`].
    pub survivors: u32,
    /// Pixels that the compute form of `raster` evaluated, where it counts them.
    pub fragments: u32,
}
