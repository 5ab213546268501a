//! The work of a frame, counted and not measured: bytes that each stage moves and operations that it does, and the fewest that would do.
//!
//! Bytes are counted from the sizes of what a stage reads and writes, every access to memory once. Blending is counted as one read and
//! one write of the covered picture (what a tiler's memory sees); fragments that blend in cache or in tile memory cost none. Caches can
//! only make the true figure smaller, except for gathers that fetch a line for a part of it.
//!
//! Floors take this model for granted (model.md, the file's precision) and nothing of the layout: every number that is needed is read
//! once, at the fewest whole bytes that keep the picture within 50 dB; what stages hand on is f16, keys are 2 bytes and shrink from pass
//! to pass, and only pixels that something covers are stored, once. Operations are additions and multiplications of floating-point
//! numbers; a root, a division or an exponential counts as one.

use crate::{
    avatar::{Avatar, Layer},
    frame::{Skip, Variant},
    layout::{SORT_DIGITS, SORT_LANES, SURFACE_DRAWN, SURFACE_FINEST, SURFACE_LEVELS},
    vulkan::{RendererOptions, harmonics, raster::Method},
};

/// Operations from a Gaussian's numbers to its splat, correctives apart: blend four matrices (96), interpolate nodes (18), transform
/// (18), rotation from quaternion (40), scales (6), covariance in space and on screen (190), hull, colour and packing (52).
const SPLAT: u64 = 420;
/// The first three of these: as far as to know where a Gaussian is.
const PLACE: u64 = 132;
/// Where the body is kept: a transform in place of the first three, and three axes less to make.
const KEPT: u64 = 250;
/// Bytes of a Gaussian as the model has it, of which all but the last 8 say where it is, and those that 32 Gaussians share, a Gaussian.
const GAUSSIAN: [u64; 3] = [24, 8, 1];
/// The same when every number is as small as can be: position 6, joints 4, weights 3, nodes 6, their weights 2; then quaternion 4,
/// scales 3, colour 3, opacity 1.
const GAUSSIAN_FLOOR: [u64; 2] = [21, 11];
/// Bytes of a Gaussian as it is kept, where it is and then how it looks; and when these are as small as can be.
const POSED: [u64; 2] = [8, 12];
const POSED_FLOOR: [u64; 2] = [6, 11];
/// Bytes of a splat as handed to the raster stage.
const SPLAT_BYTES: u64 = 16;
/// Bytes of a node's displacement as handed on.
const NODE_BYTES: u64 = 8;
/// Bytes of an index of the depth surface, and of a texel of its pyramid.
const INDEX_BYTES: u64 = 2;
const PYRAMID_BYTES: u64 = 2;
/// Operations of a fragment: offset from the centre (2), exponent (5), exponential, opacity (2) and blending of four channels (8).
const FRAGMENT: u64 = 18;

/// What one stage does in a frame that it runs in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    pub stage: &'static str,
    pub bytes: u64,
    pub bytes_floor: u64,
    /// None where nobody counts them: a sort does none, and fragments are unknown without pipeline statistics.
    pub operations: Option<u64>,
    pub operations_floor: Option<u64>,
}

/// What the counts depend on besides the avatar.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Seen {
    /// Gaussians that were looked at, and those that were drawn.
    pub gaussians: u64,
    pub drawn: u64,
    /// Networks that ran; all where that is not known.
    pub networks: Option<u64>,
    /// Whether what no camera changes came from an earlier frame.
    pub kept: bool,
    /// Corners and triangles of the depth surface.
    pub surface: [u64; 2],
    /// Bytes of the bins before their nodes.
    pub heads: u64,
    /// Pixels covered; all of the picture where that is not known.
    pub covered: Option<u64>,
    /// Pixels that may be touched; all of the picture where that is not known.
    pub area: Option<u64>,
    pub fragments: Option<u64>,
}

/// The work of each stage of a frame that it runs in.
pub fn per_stage(avatar: &Avatar, options: &RendererOptions, seen: Seen) -> Vec<Work> {
    let lit = avatar.harmonics.is_some().then(|| view_colors(avatar, seen));
    let hides = options.skip.contains(Skip::HIDDEN) && seen.surface[1] > 0;
    let surface = hides.then(|| surface(avatar, seen));
    let model = std::iter::once(features(avatar, options, seen)).chain(lit).chain(surface);
    let bins = (options.method == Some(Method::Tiles)).then(|| bins(seen));
    model.chain([splats(avatar, options, seen, hides), sort(options, seen)]).chain(bins).chain([raster(options, seen)]).collect()
}

/// What of `all` falls to `some` of `among` that are alike; nothing where there are none.
fn share(all: u64, some: u64, among: u64) -> u64 {
    (u128::from(all) * u128::from(some)).checked_div(u128::from(among)).unwrap_or_default() as u64
}

/// Numbers in the feature vectors of all parts.
fn feature_count(avatar: &Avatar) -> u64 {
    (avatar.parts.len() * avatar.networks.output()) as u64
}

/// Networks, and the nodes that follow them.
fn features(avatar: &Avatar, options: &RendererOptions, seen: Seen) -> Work {
    let layers = &avatar.networks.layers;
    let parts = avatar.parts.len() as u64;
    let head = (avatar.parts.head as u64).min(parts);
    let run = seen.networks.unwrap_or(parts).min(parts);
    // Parts outside the head see the expression as zeros.
    let body_input = |layer: &Layer| (layer.input - avatar.inputs.expression.min(layer.input)) as u64;
    let zeros: u64 = layers.first().map_or(0, |layer| (layer.input as u64 - body_input(layer)) * layer.output as u64);
    let padded = |numbers: u64| numbers.next_multiple_of(4);
    let read_zeros = layers.first().filter(|_| options.skip.contains(Skip::INPUTS));
    let unread = read_zeros.map_or(0, |layer| (padded(layer.input as u64) - padded(body_input(layer))) * layer.output as u64);
    let sum = |of: fn(&Layer) -> u64| layers.iter().map(of).sum::<u64>();
    let weights = sum(|layer| layer.input.next_multiple_of(4) as u64 * layer.output as u64);
    // Of a weight; of a bias, and its step where there is one.
    let [weight, bias] = if avatar.networks.in_bytes() { [1, 4] } else { [2, 2] };
    let padding = if avatar.networks.in_bytes() { 1 } else { 4 };
    let biases = layers.iter().map(|layer| layer.output.next_multiple_of(padding) as u64).sum::<u64>();
    let neurons = sum(|layer| layer.output as u64);
    let needed = sum(|layer| layer.input as u64 * layer.output as u64);
    let (nodes, basis) = (avatar.nodes.len() as u64, avatar.nodes.basis.len() as u64);
    // Of all parts; of those that ran their share.
    let share = |all| share(all, run, parts);
    let bytes = weight * (parts * weights - (parts - head) * unread) + bias * parts * biases + 4 * feature_count(avatar);
    let bytes_floor = weight * (parts * needed - (parts - head) * zeros) + bias * parts * neurons + 2 * feature_count(avatar);
    Work {
        stage: "features",
        // An offset in, a displacement out.
        bytes: share(bytes + basis + (8 + NODE_BYTES) * nodes + 4 * parts),
        bytes_floor: share(bytes_floor + basis + (6 + 6) * nodes),
        operations: Some(share(2 * (parts * weights - (parts - head) * unread) + 2 * basis)),
        operations_floor: Some(share(2 * (parts * needed - (parts - head) * zeros) + 2 * basis)),
    }
}

/// Colours of the view's direction, of avatars that have them.
fn view_colors(avatar: &Avatar, seen: Seen) -> Work {
    let coefficients = share(harmonics::bytes(avatar), seen.gaussians, avatar.gaussians.len() as u64);
    // Position and joints in, the colour out; where the colour goes is up to the layout.
    let bytes = coefficients + (16 + 8) * seen.gaussians;
    let bytes_floor = coefficients.min(bytes);
    Work { stage: "harmonics", bytes, bytes_floor, operations: Some(coefficients), operations_floor: Some(coefficients) }
}

/// Texels of the depth surface's pyramid.
fn pyramid() -> u64 {
    (0..SURFACE_LEVELS).map(|level| u64::from(SURFACE_FINEST >> level).pow(2)).sum()
}

/// The depth image is written and read once, and then reduced.
fn surface(avatar: &Avatar, seen: Seen) -> Work {
    let [corners, triangles] = seen.surface;
    let (nodes, drawn) = (avatar.nodes.len() as u64, u64::from(SURFACE_DRAWN).pow(2));
    Work {
        stage: "surface",
        bytes: 32 * corners + 3 * INDEX_BYTES * triangles + NODE_BYTES * nodes + 2 * 2 * drawn + PYRAMID_BYTES * pyramid(),
        bytes_floor: GAUSSIAN_FLOOR[0] * corners + 3 * 2 * triangles + 6 * nodes + 2 * 2 * drawn + 2 * pyramid(),
        operations: None,
        operations_floor: None,
    }
}

fn splats(avatar: &Avatar, options: &RendererOptions, seen: Seen, hides: bool) -> Work {
    let Seen { gaussians, drawn, .. } = seen;
    let drawn = drawn.min(gaussians);
    let numbers = (avatar.rotation_rows.basis.len() + avatar.scale_rows.basis.len() + avatar.color_rows.basis.len()) as u64;
    let heads = 4 * (avatar.rotation_rows.gaussian.len() + avatar.scale_rows.gaussian.len() + 3 * avatar.color_rows.gaussian.len()) as u64;
    // Those that are not drawn read no rows; which have some is taken to be the same among both.
    let model = avatar.gaussians.len() as u64;
    let share = |all| share(all, drawn, model);
    // A drawn key adds one to a count of the sort's first pass.
    let out = (SPLAT_BYTES + 8) * drawn + options.key_bits.bytes(gaussians) + if hides { PYRAMID_BYTES * pyramid() } else { 0 };
    // What is not drawn needs no key.
    let out_floor = (SPLAT_BYTES + 2) * drawn;
    if seen.kept {
        return Work {
            stage: "splats",
            bytes: POSED[0] * gaussians + POSED[1] * drawn + out,
            bytes_floor: POSED_FLOOR[0] * gaussians + POSED_FLOOR[1] * drawn + out_floor,
            operations: Some(18 * gaussians + KEPT * drawn),
            operations_floor: Some(18 * gaussians + KEPT * drawn),
        };
    }
    let (features, nodes) = (feature_count(avatar), avatar.nodes.len() as u64);
    let [place, look, block] = GAUSSIAN;
    let operations = PLACE * (gaussians - drawn) + SPLAT * drawn + share(2 * numbers);
    Work {
        stage: "splats",
        bytes: place * gaussians + block * model + look * drawn + share(numbers + heads) + 4 * features + NODE_BYTES * nodes + out,
        bytes_floor: GAUSSIAN_FLOOR[0] * gaussians + GAUSSIAN_FLOOR[1] * drawn + share(numbers) + 2 * features + 6 * nodes + out_floor,
        operations: Some(operations),
        operations_floor: Some(operations),
    }
}

fn sort(options: &RendererOptions, seen: Seen) -> Work {
    let Seen { gaussians, drawn, .. } = seen;
    let (passes, value) = (u64::from(options.key_bits.passes()), 4);
    // Keys of the culled are read by the first pass too, counted already. A later pass reads entries twice (count, scatter); the last
    // finds a digit and a value in one word.
    let entry = |pass: u64| if pass + 1 == passes { 4 } else { 8 };
    // Where the start-up test chose the variant, the one with most counts.
    let variants = options.sort.as_ref().map_or(&Variant::ALL[..], std::slice::from_ref);
    let counts = variants.iter().map(|&variant| counts(variant, gaussians, passes)).max().unwrap_or_default();
    let bytes = counts + options.key_bits.bytes(gaussians) + drawn * ((1..passes).map(|pass| 3 * entry(pass)).sum::<u64>() + value);
    // Histograms come for free with the keys. A pass reads what is left of the key, and the value but for the first, which knows it.
    let pass = |left: u64| if left == passes { left + (left - 1 + value) } else { (left + value) + (left - 1 + value) };
    let bytes_floor = drawn * (1..=passes).map(pass).sum::<u64>();
    Work { stage: "sort", bytes, bytes_floor, operations: None, operations_floor: None }
}

/// Bytes of a sort's counts: a tile's are cleared or written, and summed, in each pass. Lanes' own are written in each pass, and in all
/// but the first another kernel reads them.
fn counts(variant: Variant, gaussians: u64, passes: u64) -> u64 {
    let lanes = if variant == Variant::LaneScan { u64::from(SORT_LANES) * (2 * passes - 1) } else { 0 };
    4 * u64::from(SORT_DIGITS) * gaussians.div_ceil(u64::from(variant.tile())) * (3 * passes + lanes)
}

/// Tiles that a splat meets, about: 3 to 4 of a body 2000 pixels high.
const MET: u64 = 3;

/// Chains of tiles: their heads are cleared; an entry reads and writes a head, and writes itself.
fn bins(seen: Seen) -> Work {
    let bytes = seen.heads + (4 + SPLAT_BYTES + 12 * MET) * seen.drawn;
    Work { stage: "bins", bytes, bytes_floor: (4 + SPLAT_BYTES + 4 * MET) * seen.drawn, operations: None, operations_floor: None }
}

fn raster(options: &RendererOptions, seen: Seen) -> Work {
    let picture = seen.area.unwrap_or_else(|| options.size.into_iter().map(u64::from).product());
    let pixel = options.color.unwrap_or_default().bytes() as u64;
    let splats = (4 + SPLAT_BYTES) * seen.drawn;
    // Quads are blended over a picture that was cleared; tiles read their splats anew, and write once.
    let (splats_read, written) = if options.method == Some(Method::Tiles) { (MET * splats, 1) } else { (splats, 2) };
    Work {
        stage: "raster",
        bytes: splats_read + written * picture * pixel,
        bytes_floor: splats + seen.covered.unwrap_or(picture) * pixel,
        operations: seen.fragments.map(|fragments| FRAGMENT * fragments),
        operations_floor: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{avatar::pack::Step, demo, vulkan::sort::KeyBits};

    #[test]
    fn no_floor_is_above_what_is_counted() {
        let avatar = demo::avatar().expect("inside the program");
        let gaussians = avatar.gaussians.len() as u64;
        for key_bits in [KeyBits::Sixteen, KeyBits::TwentyFour, KeyBits::ThirtyTwo] {
            let options = RendererOptions { key_bits, ..RendererOptions::new([256, 256]) };
            for drawn in [0, gaussians / 2, gaussians] {
                let seen = Seen { gaussians, drawn, covered: Some(9000), fragments: Some(100_000), ..Seen::default() };
                for (kept, surface) in [(false, [0; 2]), (true, [500, 900])] {
                    for work in per_stage(&avatar, &options, Seen { kept, surface, ..seen }) {
                        assert!(work.bytes_floor <= work.bytes, "{work:?}");
                        assert!(work.operations_floor <= work.operations, "{work:?}");
                        let none = ["sort", "raster", "surface"].contains(&work.stage);
                        assert!(none || work.operations_floor > Some(0), "{work:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn networks_in_bytes_move_half() {
        let avatar = demo::avatar().expect("inside the program");
        let small = avatar.after(Step::Networks);
        let of = |avatar: &Avatar| features(avatar, &RendererOptions::new([1, 1]), Seen::default());
        let saved = avatar.networks.layers.iter().map(|layer| layer.weight.len() as u64).sum::<u64>();
        let gained = of(&avatar).bytes - of(&small).bytes;
        assert!(gained > saved * 8 / 10 && gained < saved, "{gained} of {saved} weights");
        assert_eq!(of(&avatar).operations, of(&small).operations);
        assert!(of(&small).bytes_floor <= of(&small).bytes);
    }

    #[test]
    fn networks_that_did_not_run_move_nothing() {
        let avatar = demo::avatar().expect("inside the program");
        let options = RendererOptions::new([1, 1]);
        let of = |networks| features(&avatar, &options, Seen { networks, ..Seen::default() });
        let (all, half) = (of(None), of(Some(avatar.parts.len() as u64 / 2)));
        assert!(half.bytes < all.bytes * 11 / 20 && of(Some(0)).bytes == 0 && of(Some(1 << 40)) == all);
        let zeros = RendererOptions { skip: Skip::empty(), ..options };
        assert!(features(&avatar, &zeros, Seen::default()).bytes > all.bytes, "the expression's columns are read outside the head too");
    }

    #[test]
    fn a_pass_more_costs_what_a_pass_moves() {
        let seen = Seen { gaussians: 1000, drawn: 1000, ..Seen::default() };
        let of = |key_bits| sort(&RendererOptions { key_bits, sort: Some(Variant::SelfScan), ..RendererOptions::new([1, 1]) }, seen);
        let (two, three) = (of(KeyBits::Sixteen), of(KeyBits::TwentyFour));
        // Two keys a word and one pass between words; a key a word, one pass between pairs and one between words.
        let counts = |passes| 3 * 4 * u64::from(SORT_DIGITS) * passes;
        let expected = [(2 + 3 * 4 + 4) * 1000 + counts(2), (4 + 3 * 8 + 3 * 4 + 4) * 1000 + counts(3)];
        assert_eq!([two.bytes, three.bytes], expected);
        // 2 in, 1 + 4 out, 1 + 4 in, 4 out; then 3 in, 2 + 4 out, 2 + 4 in, 1 + 4 out, 1 + 4 in, 4 out.
        assert_eq!([two.bytes_floor, three.bytes_floor], [16 * 1000, 29 * 1000]);
        // Lanes' counts are written by the first pass, and written and read by the second.
        let lanes = RendererOptions { key_bits: KeyBits::Sixteen, sort: Some(Variant::LaneScan), ..RendererOptions::new([1, 1]) };
        assert_eq!(sort(&lanes, seen).bytes - two.bytes, 4 * u64::from(SORT_DIGITS * SORT_LANES) * 3);
    }
}
