//! The work of a frame, computed and not measured: the bytes that each stage moves and the
//! operations that it does, and the fewest that would do.
//!
//! Bytes follow from the sizes of a stage's inputs and outputs; every access to memory counts once.
//! Blending counts as one read and one write of the image, which is the traffic of a tiler's
//! memory; fragments that blend in cache or in tile memory cost none. Caches can only make the true
//! number smaller, except for gathers, which fetch a cache line for a part of it.
//!
//! Frames count as those of a moving avatar in a window of the image's size: quads that go to the
//! screen in the render pass that draws them move no image, others have it read again.
//!
//! The minimum assumes the model (model.md, the file's precision) but nothing of the layout: every
//! number that is needed is read once, at the fewest whole bytes that keep the image within 50 dB;
//! stages hand on f16, keys are 2 bytes and shrink from pass to pass, and of pixels only the
//! screen's are stored, once. Operations are additions and multiplications of floating-point numbers; a root, a
//! division or an exponential counts as one.

use effigy_core::{
    avatar::{Avatar, NetworkLayer},
    frame::{
        DEPTH_KEYS, Skip, SortVariant,
        passes::{ListForm, Stage},
        schedule::Equipment,
    },
    layout::{self, BLOCK_PAIRS, GAUSSIAN_PAIRS, POSE_CACHE_WORDS, SORT_DIGITS, SORT_RUNS},
};
use effigy_render::vulkan::{RendererOptions, raster::RasterMethod};
use std::{
    iter::Sum,
    ops::{Add, Mul},
};

/// Bytes of a word, and of a pair of words.
const WORD: u64 = 4;
const PAIR: u64 = 2 * WORD;
/// Gaussians that share a block.
const BLOCK: u64 = 32;

/// A number of bytes or of anything else: as this program's layout has it, and the fewest that
/// would do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Amount {
    stored: u64,
    minimum: u64,
}

impl Amount {
    /// An amount that can't be less.
    const fn exact(amount: u64) -> Self {
        Self {
            stored: amount,
            minimum: amount,
        }
    }

    /// The share of an amount for `part` things, if it is for `whole` things that are alike.
    fn share(self, part: u64, whole: u64) -> Self {
        Self {
            stored: share(self.stored, part, whole),
            minimum: share(self.minimum, part, whole),
        }
    }
}

impl Add for Amount {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            stored: self.stored + other.stored,
            minimum: self.minimum + other.minimum,
        }
    }
}

impl Mul<u64> for Amount {
    type Output = Self;

    fn mul(self, count: u64) -> Self {
        Self {
            stored: self.stored * count,
            minimum: self.minimum * count,
        }
    }
}

impl Sum for Amount {
    fn sum<I: Iterator<Item = Self>>(amounts: I) -> Self {
        amounts.fold(Self::default(), Self::add)
    }
}

/// `total · part / whole`; 0 if `whole` is.
fn share(total: u64, part: u64, whole: u64) -> u64 {
    (u128::from(total) * u128::from(part))
        .checked_div(u128::from(whole))
        .unwrap_or_default() as u64
}

/// A Gaussian's place: position, joints and weights, nodes and their weights; in the layout the log
/// scales too. Minimum: 6 + 4 + 3 + 6 + 2.
const GAUSSIAN_PLACE: Amount = Amount {
    stored: PAIR * (GAUSSIAN_PAIRS as u64 - 1),
    minimum: 21,
};
/// A Gaussian's look: rotation, colour and opacity, of which the minimum is 4 + 3 + 1, and the log
/// scales, 3.
const GAUSSIAN_LOOK: Amount = Amount {
    stored: PAIR,
    minimum: 11,
};
/// A Gaussian's share of its block.
const GAUSSIAN_BLOCK: Amount = Amount {
    stored: PAIR * BLOCK_PAIRS as u64 / BLOCK,
    minimum: 0,
};
/// A Gaussian's place in the pose cache.
const CACHED_PLACE: Amount = Amount {
    stored: 3 * WORD,
    minimum: 9,
};
/// A Gaussian's look in the pose cache.
const CACHED_LOOK: Amount = Amount {
    stored: WORD * POSE_CACHE_WORDS as u64 - 3 * WORD,
    minimum: 11,
};
/// From where a Gaussian is drawn.
const FACING: Amount = Amount {
    stored: WORD,
    minimum: 3,
};
/// A splat as handed to the raster stage.
const SPLAT: Amount = Amount::exact(4 * WORD);
/// An index of a splat in drawing order.
const SPLAT_INDEX: Amount = Amount::exact(WORD);
/// A number of a feature vector.
const FEATURE: Amount = Amount {
    stored: WORD,
    minimum: 2,
};
/// A node's offset, with the step of its basis in the fourth number.
const NODE_OFFSET: Amount = Amount {
    stored: PAIR,
    minimum: 6,
};
/// A node's displacement.
const NODE_DISPLACEMENT: Amount = Amount {
    stored: PAIR,
    minimum: 6,
};
/// A part's first node.
const NODE_START: Amount = Amount {
    stored: WORD,
    minimum: 0,
};
/// A Gaussian's position, joints and nodes, which the colour from spherical harmonics needs too. At
/// the minimum they are read once for both.
const VIEWED_PLACE: Amount = Amount {
    stored: 3 * PAIR,
    minimum: 0,
};
/// That colour, which the layout hands from one stage to the next.
const VIEW_COLOR: Amount = Amount {
    stored: PAIR,
    minimum: 0,
};
/// A basis row's step and part, without its codes; of a colour the neutral colour too.
const ROW_HEAD: Amount = Amount {
    stored: WORD,
    minimum: 0,
};
const COLOR_ROW_HEAD: Amount = Amount {
    stored: 3 * WORD,
    minimum: 0,
};

/// Operations of placing a Gaussian: blend four matrices (96), interpolate nodes (18), transform
/// (18).
const PLACE_OPERATIONS: u64 = 132;
/// Operations from a Gaussian's numbers to its splat, correctives apart: placing; then rotation
/// from the quaternion (40), scales (6), covariance in space and in the image (190), bounds, colour
/// and packing (52).
const SPLAT_OPERATIONS: u64 = PLACE_OPERATIONS + 288;
/// Operations of placing a Gaussian from the pose cache: one transform.
const CACHED_PLACE_OPERATIONS: u64 = 18;
/// Operations of its splat: rotation and scales are in the cached shape, and the covariance has
/// three axes less to make.
const CACHED_SPLAT_OPERATIONS: u64 = 250;
/// Operations of a fragment: offset from the centre (2), exponent (5), exponential, opacity (2) and
/// blending of four channels (8).
const FRAGMENT_OPERATIONS: u64 = 18;
/// Tiles that a splat touches, about: 3 to 4 of a body 2000 pixels high.
const TILES_A_SPLAT: u64 = 3;
/// Bins of 32 px that a splat touches, about, on such a body.
const PAIRS_A_SPLAT: u64 = 2;
/// The bin of a pair.
const PAIR_KEY: u64 = 2;
/// A pixel of the screen.
const SCREEN_PIXEL: u64 = 4;

/// Work of one stage in a frame in which it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StageWork {
    /// The stage.
    pub stage: Stage,
    /// Bytes that it moves.
    pub bytes: u64,
    /// The fewest bytes that would do.
    pub bytes_floor: u64,
    /// None where they are not counted: a sort does none, and fragments are unknown without
    /// pipeline statistics.
    pub operations: Option<u64>,
    /// The fewest operations that would do.
    pub operations_floor: Option<u64>,
}

impl StageWork {
    /// A stage that does nothing.
    pub fn none(stage: Stage) -> Self {
        Self::moving(stage, Amount::default())
    }

    /// A stage whose operations are not counted.
    fn moving(stage: Stage, bytes: Amount) -> Self {
        Self {
            stage,
            bytes: bytes.stored,
            bytes_floor: bytes.minimum,
            operations: None,
            operations_floor: None,
        }
    }

    /// A stage that moves bytes and computes.
    fn computing(stage: Stage, bytes: Amount, operations: Amount) -> Self {
        Self {
            operations: Some(operations.stored),
            operations_floor: Some(operations.minimum),
            ..Self::moving(stage, bytes)
        }
    }

    /// The work of so many avatars, rounded.
    pub fn times(self, avatars: f64) -> Self {
        let times = |count: u64| (count as f64 * avatars).round() as u64;
        Self {
            stage: self.stage,
            bytes: times(self.bytes),
            bytes_floor: times(self.bytes_floor),
            operations: self.operations.map(times),
            operations_floor: self.operations_floor.map(times),
        }
    }
}

/// What averages avatars that were drawn larger than they are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ResolveCounts {
    /// Pixels that are averaged.
    pub averaged: u64,
    /// Pixels of the image that they are averaged into.
    pub resolved: u64,
}

/// Counts that the work depends on besides the avatar.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorkCounts {
    /// Gaussians that were projected.
    pub gaussians: u64,
    /// Gaussians that were drawn.
    pub drawn: u64,
    /// Networks that ran. None, if unknown, stands for all.
    pub networks: Option<u64>,
    /// Whether posed Gaussians came from the pose cache.
    pub pose_cached: bool,
    /// Bytes of the heads of all tiles' lists.
    pub tile_head_bytes: u64,
    /// Pixels that were covered. None, if unknown, stands for the whole image; so for the next.
    pub covered: Option<u64>,
    /// Pixels of the image that were redrawn.
    pub damaged: Option<u64>,
    /// Pixels that splats were blended into: `damaged`, where no avatar is drawn larger than it is
    /// shown.
    pub rastered: Option<u64>,
    /// None where no avatar is drawn larger than it is shown.
    pub resolve: Option<ResolveCounts>,
    /// Fragments that were shaded, if known.
    pub fragments: Option<u64>,
}

/// The work of each stage, in the order of a frame in which it runs.
pub fn work_per_stage(
    avatar: &Avatar,
    options: &RendererOptions,
    counts: WorkCounts,
) -> Vec<StageWork> {
    let mut stages = vec![mlp(avatar, options, counts)];
    if avatar.sh.is_some() {
        stages.push(view_colors(avatar, counts));
    }
    stages.push(project(avatar, options, counts));
    stages.push(sort(options, counts));
    // Options that are not resolved decide no lists.
    if let Some(method) = options.method {
        let equipment = Equipment {
            sh: avatar.sh.is_some(),
            supersampling: options.supersampling.is_on(),
            method,
            skip: options.skip,
        };
        match equipment.lists() {
            Some(ListForm::Tiles) => stages.push(binning(counts)),
            Some(ListForm::Bins) => stages.push(bins(counts)),
            None => {}
        }
        if equipment.has(Stage::Saturation) {
            stages.push(saturation(options, counts));
        }
    }
    stages.push(raster(options, counts));
    if let Some(counted) = counts.resolve {
        stages.push(resolve(options, counts, counted));
    }
    stages.push(present(options, counts));
    stages
}

/// Whether the image goes to the screen in the render pass that draws it.
fn shows_at_once(options: &RendererOptions, counts: WorkCounts) -> bool {
    options.shows_at_once() && counts.resolve.is_none()
}

/// Features of all parts.
fn features(avatar: &Avatar) -> Amount {
    FEATURE * (avatar.parts.len() * avatar.networks.output()) as u64
}

/// The networks' arrays, and how much of them is read.
struct NetworkArrays {
    /// Weights and biases of all parts.
    weights: Amount,
    biases: Amount,
    bytes_a_weight: u64,
    bytes_a_bias: u64,
}

impl NetworkArrays {
    fn new(avatar: &Avatar, options: &RendererOptions) -> Self {
        let networks = &avatar.networks;
        let parts = avatar.parts.len() as u64;
        let body_parts = parts - (avatar.parts.head as u64).min(parts);
        // Weights are padded to quads of inputs. Biases are padded to quads of neurons, or, in
        // bytes, stored with the step of their neuron's weights.
        let in_bytes = networks.in_bytes();
        let bias_group = if in_bytes { 1 } else { 4 };
        let weights_of = |layer: &NetworkLayer, inputs: usize| Amount {
            stored: (inputs.next_multiple_of(4) * layer.output) as u64,
            minimum: (inputs * layer.output) as u64,
        };
        let biases_of = |layer: &NetworkLayer| Amount {
            stored: layer.output.next_multiple_of(bias_group) as u64,
            minimum: layer.output as u64,
        };
        let layers = &networks.layers;
        let weights: Amount = layers
            .iter()
            .map(|layer| weights_of(layer, layer.input))
            .sum();
        let biases: Amount = layers.iter().map(biases_of).sum();
        // Outside the head the expression is 0, so its columns of the first layer need not be read.
        let mut unread = Amount::default();
        if let Some(first) = layers.first() {
            let expression = avatar.inputs.expression.min(first.input);
            let all = weights_of(first, first.input);
            let rest = weights_of(first, first.input - expression);
            unread.minimum = all.minimum - rest.minimum;
            if options.skip.contains(Skip::INPUTS) {
                unread.stored = all.stored - rest.stored;
            }
        }
        Self {
            weights: Amount {
                stored: parts * weights.stored - body_parts * unread.stored,
                minimum: parts * weights.minimum - body_parts * unread.minimum,
            },
            biases: biases * parts,
            bytes_a_weight: if in_bytes { 1 } else { 2 },
            bytes_a_bias: if in_bytes { 4 } else { 2 },
        }
    }

    fn bytes(&self) -> Amount {
        self.weights * self.bytes_a_weight + self.biases * self.bytes_a_bias
    }
}

/// Networks, and the nodes that follow them.
fn mlp(avatar: &Avatar, options: &RendererOptions, counts: WorkCounts) -> StageWork {
    let networks = NetworkArrays::new(avatar, options);
    let parts = avatar.parts.len() as u64;
    let nodes = avatar.nodes.len() as u64;
    let basis = Amount::exact(avatar.nodes.basis.len() as u64);
    let bytes = networks.bytes()
        + features(avatar)
        + basis
        + (NODE_OFFSET + NODE_DISPLACEMENT) * nodes
        + NODE_START * parts;
    let operations = (networks.weights + basis) * 2;
    let ran = counts.networks.unwrap_or(parts).min(parts);
    StageWork::computing(
        Stage::Mlp,
        bytes.share(ran, parts),
        operations.share(ran, parts),
    )
}

/// Colours from spherical harmonics.
fn view_colors(avatar: &Avatar, counts: WorkCounts) -> StageWork {
    let all = avatar.gaussians.len() as u64;
    let coefficients = Amount::exact(layout::sh::bytes(avatar)).share(counts.gaussians, all);
    let displacements = Amount {
        minimum: 0,
        ..NODE_DISPLACEMENT * avatar.nodes.len() as u64
    };
    let bytes = coefficients + (VIEWED_PLACE + VIEW_COLOR) * counts.gaussians + displacements;
    StageWork::computing(Stage::Sh, bytes, coefficients)
}

/// Basis rows of rotation, scale and colour.
struct RowArrays {
    /// Numbers, a byte each.
    numbers: u64,
    heads: Amount,
}

impl RowArrays {
    fn new(avatar: &Avatar) -> Self {
        let rotation = &avatar.rotation_rows;
        let scale = &avatar.scale_rows;
        let color = &avatar.color_rows;
        let numbers = rotation.basis.len() + scale.basis.len() + color.basis.len();
        let rows = rotation.gaussian.len() + scale.gaussian.len();
        Self {
            numbers: numbers as u64,
            heads: ROW_HEAD * rows as u64 + COLOR_ROW_HEAD * color.gaussian.len() as u64,
        }
    }

    fn bytes(&self) -> Amount {
        Amount::exact(self.numbers) + self.heads
    }
}

/// Skinning, projection and culling; also from the pose cache.
fn project(avatar: &Avatar, options: &RendererOptions, counts: WorkCounts) -> StageWork {
    let gaussians = counts.gaussians;
    let faces = options.skip.contains(Skip::FACING) && !avatar.gaussians.facing.is_empty();
    let facing = FACING * if faces { gaussians } else { 0 };
    let drawn = counts.drawn.min(gaussians);
    // A drawn key adds one to a count of the sort's first pass: a read and a write. At the minimum
    // a Gaussian that is not drawn needs no key.
    let counting = Amount {
        stored: 2 * WORD,
        minimum: 2,
    };
    let keys = Amount {
        stored: DEPTH_KEYS.bytes(gaussians),
        minimum: 0,
    };
    let handed_on = (SPLAT + counting) * drawn + keys + facing;
    if counts.pose_cached {
        let bytes = CACHED_PLACE * gaussians + CACHED_LOOK * drawn + handed_on;
        let operations = CACHED_PLACE_OPERATIONS * gaussians + CACHED_SPLAT_OPERATIONS * drawn;
        return StageWork::computing(Stage::Project, bytes, Amount::exact(operations));
    }
    // Only drawn Gaussians read rows. They are assumed to have them as often as the others.
    let all = avatar.gaussians.len() as u64;
    let rows = RowArrays::new(avatar);
    let bytes = GAUSSIAN_PLACE * gaussians
        + GAUSSIAN_BLOCK * all
        + GAUSSIAN_LOOK * drawn
        + rows.bytes().share(drawn, all)
        + features(avatar)
        + NODE_DISPLACEMENT * avatar.nodes.len() as u64
        + VIEW_COLOR * if avatar.sh.is_some() { drawn } else { 0 }
        + handed_on;
    let operations = PLACE_OPERATIONS * (gaussians - drawn)
        + SPLAT_OPERATIONS * drawn
        + share(2 * rows.numbers, drawn, all);
    StageWork::computing(Stage::Project, bytes, Amount::exact(operations))
}

/// Bytes of an index that is sorted along with its key.
const SORT_VALUE: u64 = WORD;

fn sort(options: &RendererOptions, counts: WorkCounts) -> StageWork {
    let passes = u64::from(DEPTH_KEYS.passes());
    let bytes = Amount {
        stored: stored_sort_bytes(options, counts, passes),
        minimum: minimum_sort_bytes(counts.drawn, passes),
    };
    StageWork::moving(Stage::Sort, bytes)
}

fn stored_sort_bytes(options: &RendererOptions, counts: WorkCounts, passes: u64) -> u64 {
    // If the self-test chose the variant, the one with the most counters stands for it.
    let variants = match &options.sort {
        Some(variant) => std::slice::from_ref(variant),
        None => &SortVariant::ALL,
    };
    let counters = variants
        .iter()
        .map(|&variant| counter_bytes(variant, counts.gaussians, passes));
    // An entry of a later pass is read twice, to count and to scatter, and was written once. The
    // first pass reads the keys of culled Gaussians too.
    let bits = DEPTH_KEYS;
    let count = u32::try_from(counts.gaussians).unwrap_or(u32::MAX);
    let entry = |pass| bits.form_before(pass, count).bytes();
    let later_passes: u64 = (1..bits.passes()).map(|pass| 3 * entry(pass)).sum();
    counters.max().unwrap_or_default()
        + bits.bytes(counts.gaussians)
        + counts.drawn * (later_passes + SORT_VALUE)
}

/// Histograms come for free with the keys. Each pass reads the bytes of the key that are left, and
/// writes one less; with them goes the index, which the first pass knows without reading it.
fn minimum_sort_bytes(drawn: u64, passes: u64) -> u64 {
    let pass = |key_bytes: u64| {
        let is_first = key_bytes == passes;
        let read = key_bytes + if is_first { 0 } else { SORT_VALUE };
        let written = key_bytes - 1 + SORT_VALUE;
        read + written
    };
    drawn * (1..=passes).map(pass).sum::<u64>()
}

/// Bytes of a sort's counters: in each pass those of a tile are cleared or written, and summed.
/// With counters for each thread these are written in each pass, and read by another kernel in all
/// but the first.
fn counter_bytes(variant: SortVariant, gaussians: u64, passes: u64) -> u64 {
    let tiles = gaussians.div_ceil(u64::from(variant.tile()));
    let accesses_of_threads = if variant == SortVariant::PerThread {
        u64::from(SORT_RUNS) * (2 * passes - 1)
    } else {
        0
    };
    WORD * u64::from(SORT_DIGITS) * tiles * (3 * passes + accesses_of_threads)
}

/// The tiles' lists: their heads are cleared. Adding a splat to a list reads and writes a head, and
/// writes an entry.
fn binning(counts: WorkCounts) -> StageWork {
    let list_entry = Amount {
        stored: 3 * WORD,
        minimum: WORD,
    };
    let heads = Amount {
        stored: counts.tile_head_bytes,
        minimum: 0,
    };
    let a_splat = SPLAT_INDEX + SPLAT + list_entry * TILES_A_SPLAT;
    StageWork::moving(Stage::Binning, heads + a_splat * counts.drawn)
}

/// The lists of bins: pairs are counted from the order and the splats, written with their keys,
/// and sorted in two passes, of which each counts first; the second reads and writes a word a pair.
fn bins(counts: WorkCounts) -> StageWork {
    let written = WORD + PAIR_KEY;
    let sorted = 2 * PAIR_KEY + WORD + 2 * WORD + WORD;
    let a_pair = Amount {
        stored: written + sorted,
        minimum: WORD,
    };
    let read = Amount {
        stored: 2 * (SPLAT_INDEX + SPLAT).stored,
        minimum: (SPLAT_INDEX + SPLAT).minimum,
    };
    let a_splat = read + a_pair * PAIRS_A_SPLAT;
    StageWork::moving(Stage::Binning, a_splat * counts.drawn)
}

/// Each bin reads its own splats and their keys; a sample is a quarter of a pixel's.
fn saturation(options: &RendererOptions, counts: WorkCounts) -> StageWork {
    let [width, height] = options.size.map(u64::from);
    let samples = counts.damaged.unwrap_or(width * height) / 4;
    let a_pair = 2 * WORD + SPLAT.stored + PAIR_KEY;
    let bytes = Amount {
        stored: PAIRS_A_SPLAT * a_pair * counts.drawn + WORD * samples,
        minimum: SPLAT.minimum * counts.drawn + PAIR_KEY * samples,
    };
    StageWork::moving(Stage::Saturation, bytes)
}

fn raster(options: &RendererOptions, counts: WorkCounts) -> StageWork {
    let [width, height] = options.size.map(u64::from);
    let redrawn = counts.rastered.or(counts.damaged).unwrap_or(width * height);
    let pixel = options.color().bytes() as u64;
    let splats = (SPLAT_INDEX + SPLAT) * counts.drawn;
    let by_tiles = options.method.is_some_and(RasterMethod::is_tiles);
    // Quads are blended over an image that was cleared. Each tile reads its own splats, and an
    // image is written once.
    let reads_a_splat = if by_tiles { TILES_A_SPLAT } else { 1 };
    let accesses_a_pixel = match by_tiles {
        true => 1,
        false if shows_at_once(options, counts) => 0,
        false => 2,
    };
    let bytes = Amount {
        stored: reads_a_splat * splats.stored + accesses_a_pixel * redrawn * pixel,
        minimum: splats.minimum,
    };
    StageWork {
        operations: counts
            .fragments
            .map(|fragments| FRAGMENT_OPERATIONS * fragments),
        ..StageWork::moving(Stage::Raster, bytes)
    }
}

/// Avatars that were drawn larger than they are shown: each of their pixels is read once, and their
/// means are blended into the image.
fn resolve(options: &RendererOptions, counts: WorkCounts, counted: ResolveCounts) -> StageWork {
    let ResolveCounts { averaged, resolved } = counted;
    let covered = counts.covered.unwrap_or(resolved).min(resolved);
    let pixels = Amount {
        stored: averaged + 2 * resolved,
        minimum: share(averaged, covered, resolved) + covered,
    };
    let pixel = options.color().bytes() as u64;
    StageWork::moving(Stage::Resolve, pixels * pixel)
}

/// The screen is written, after the image was read unless quads are shown at once.
fn present(options: &RendererOptions, counts: WorkCounts) -> StageWork {
    let [width, height] = options.size.map(u64::from);
    let pixel = options.color().bytes() as u64;
    let read = if shows_at_once(options, counts) {
        0
    } else {
        pixel
    };
    let a_pixel = Amount {
        stored: read + SCREEN_PIXEL,
        minimum: SCREEN_PIXEL,
    };
    StageWork::moving(Stage::Present, a_pixel * (width * height))
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::{avatar::ShCoefficients, io::pack::PackStep};
    use half::f16;

    fn demo() -> Avatar {
        effigy_demo::avatar().expect("the demo is built in")
    }

    #[test]
    fn no_minimum_is_above_the_stored_amount() {
        let avatar = demo();
        let gaussians = avatar.gaussians.len() as u64;
        for exact in [false, true] {
            let options = RendererOptions {
                exact,
                ..RendererOptions::new([256, 256])
            };
            for drawn in [0, gaussians / 2, gaussians] {
                for pose_cached in [false, true] {
                    let counts = WorkCounts {
                        gaussians,
                        drawn,
                        pose_cached,
                        covered: Some(9000),
                        fragments: Some(100_000),
                        resolve: Some(ResolveCounts {
                            averaged: 40_000,
                            resolved: 10_000,
                        }),
                        ..WorkCounts::default()
                    };
                    for work in work_per_stage(&avatar, &options, counts) {
                        assert!(work.bytes_floor <= work.bytes, "{work:?}");
                        assert!(work.operations_floor <= work.operations, "{work:?}");
                        let uncounted =
                            [Stage::Sort, Stage::Raster, Stage::Resolve, Stage::Present]
                                .contains(&work.stage);
                        assert!(uncounted || work.operations_floor > Some(0), "{work:?}");
                    }
                }
            }
        }
    }

    /// A colour from spherical harmonics is written by one stage and read by the next, of what is
    /// drawn alone.
    #[test]
    fn colours_from_harmonics_are_handed_on() {
        let plain = demo();
        let mut lit = plain.clone();
        lit.sh = Some(ShCoefficients {
            degree: 1,
            coefficients: vec![[f16::ZERO; 3]; 3 * plain.gaussians.len()],
        });
        let counts = |drawn| WorkCounts {
            gaussians: 1000,
            drawn,
            ..WorkCounts::default()
        };
        let options = RendererOptions::new([1, 1]);
        let bytes = |avatar, drawn, stage| {
            let work = work_per_stage(avatar, &options, counts(drawn));
            let work = work.into_iter().find(|work| work.stage == stage);
            work.map(|work| work.bytes)
        };
        for drawn in [0, 600] {
            let [lit, plain] = [&lit, &plain].map(|avatar| bytes(avatar, drawn, Stage::Project));
            assert_eq!(lit.unwrap() - plain.unwrap(), PAIR * drawn);
        }
        let coefficients = layout::sh::bytes(&lit) * 1000 / plain.gaussians.len() as u64;
        let nodes = PAIR * plain.nodes.len() as u64;
        let all = coefficients + 4 * PAIR * 1000 + nodes;
        assert_eq!(bytes(&lit, 600, Stage::Sh), Some(all));
        assert_eq!(bytes(&plain, 600, Stage::Sh), None);
    }

    /// An image that is drawn three times as large is read once, and blended where it is shown.
    #[test]
    fn enlarged_avatars_cost_their_pixels() {
        let avatar = demo();
        let options = RendererOptions::new([100, 100]);
        let bytes = |counts, stage| {
            let work = work_per_stage(&avatar, &options, counts);
            let work = work.into_iter().find(|work| work.stage == stage);
            work.map_or(0, |work| work.bytes)
        };
        let own = WorkCounts {
            damaged: Some(400),
            ..WorkCounts::default()
        };
        let enlarged = WorkCounts {
            rastered: Some(4000),
            resolve: Some(ResolveCounts {
                averaged: 3600,
                resolved: 400,
            }),
            ..own
        };
        let pixel = options.color().bytes() as u64;
        assert_eq!(bytes(enlarged, Stage::Resolve), (3600 + 2 * 400) * pixel);
        assert_eq!(bytes(own, Stage::Resolve), 0);
        assert_eq!(
            bytes(enlarged, Stage::Raster),
            10 * bytes(own, Stage::Raster)
        );
    }

    /// Quads that are shown at once move no image: 8 bytes a pixel written and 8 read of what is
    /// redrawn, and 8 read of what is shown.
    #[test]
    fn only_quads_leave_the_image_in_tile_memory() {
        let avatar = demo();
        let bytes = |method, resolve| {
            let options = RendererOptions {
                method: Some(method),
                ..RendererOptions::new([100, 100])
            };
            let counts = WorkCounts {
                damaged: Some(400),
                resolve,
                ..WorkCounts::default()
            };
            let work = work_per_stage(&avatar, &options, counts);
            let of = |stage| work.iter().find(|work| work.stage == stage);
            [Stage::Raster, Stage::Present].map(|stage| of(stage).map_or(0, |work| work.bytes))
        };
        assert_eq!(bytes(RasterMethod::Quads, None), [0, 40_000]);
        let resolve = Some(ResolveCounts::default());
        assert_eq!(bytes(RasterMethod::Quads, resolve), [6400, 120_000]);
        assert_eq!(bytes(RasterMethod::SharedTiles, None), [1600, 80_000]);
    }

    #[test]
    fn networks_in_bytes_move_half() {
        let avatar = demo();
        let small = avatar.after(PackStep::Networks);
        let options = RendererOptions::new([1, 1]);
        let work = |avatar: &Avatar| mlp(avatar, &options, WorkCounts::default());
        let layers = &avatar.networks.layers;
        let weights: u64 = layers.iter().map(|layer| layer.weight.len() as u64).sum();
        let saved = work(&avatar).bytes - work(&small).bytes;
        assert!(
            saved > weights * 8 / 10 && saved < weights,
            "{saved} of {weights} weights"
        );
        assert_eq!(work(&avatar).operations, work(&small).operations);
        assert!(work(&small).bytes_floor <= work(&small).bytes);
    }

    #[test]
    fn networks_that_did_not_run_move_nothing() {
        let avatar = demo();
        let options = RendererOptions::new([1, 1]);
        let work = |networks| {
            let counts = WorkCounts {
                networks,
                ..WorkCounts::default()
            };
            mlp(&avatar, &options, counts)
        };
        let all = work(None);
        let half = work(Some(avatar.parts.len() as u64 / 2));
        assert!(half.bytes < all.bytes * 11 / 20);
        assert_eq!(work(Some(0)).bytes, 0);
        assert_eq!(work(Some(1 << 40)), all);
        let with_expression = RendererOptions {
            skip: Skip::empty(),
            ..options
        };
        assert!(
            mlp(&avatar, &with_expression, WorkCounts::default()).bytes > all.bytes,
            "the expression's columns are read outside the head too"
        );
    }

    #[test]
    fn a_sort_costs_the_bytes_that_it_moves() {
        let counts = WorkCounts {
            gaussians: 1000,
            drawn: 1000,
            ..WorkCounts::default()
        };
        let work = |variant| {
            let options = RendererOptions {
                sort: Some(variant),
                ..RendererOptions::new([1, 1])
            };
            sort(&options, counts)
        };
        let sorted = work(SortVariant::ReduceThenScan);
        // A key a word, and two passes between words.
        let counters = 3 * 4 * u64::from(SORT_DIGITS) * 3;
        assert_eq!(sorted.bytes, (4 + 3 * 4 + 3 * 4 + 4) * 1000 + counters);
        // 3 in, 2 + 4 out, 2 + 4 in, 1 + 4 out, 1 + 4 in, 4 out.
        assert_eq!(sorted.bytes_floor, 29 * 1000);
        // Threads' counters are written by the first pass, and written and read by the others.
        let per_thread = work(SortVariant::PerThread);
        assert_eq!(
            per_thread.bytes - sorted.bytes,
            4 * u64::from(SORT_DIGITS * SORT_RUNS) * 5
        );
    }
}
