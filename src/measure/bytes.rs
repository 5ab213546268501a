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
    vulkan::{RendererOptions, harmonics},
};

/// Operations from a Gaussian's numbers to its splat, correctives apart: blend four matrices (96), interpolate nodes (18), transform
/// (18), rotation from quaternion (40), scales (6), covariance in space and on screen (190), hull, colour and packing (52).
const SPLAT: u64 = 420;
/// The first three of these: as far as to know where a Gaussian is.
const PLACE: u64 = 132;
/// Bytes of a Gaussian when every number is as small as can be: position 6, quaternion 4, scales 3, colour 3, opacity 1, joints 4,
/// weights 3, nodes 6, their weights 2.
const GAUSSIAN_FLOOR: u64 = 32;
/// Bytes of a splat as handed to the raster stage.
const SPLAT_BYTES: u64 = 16;
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
    /// Gaussians that came in, and those that were drawn.
    pub gaussians: u64,
    pub drawn: u64,
    /// Pixels covered; all of the picture where that is not known.
    pub covered: Option<u64>,
    pub fragments: Option<u64>,
}

/// The work of each stage for a frame in which everything changed.
pub fn per_stage(avatar: &Avatar, options: &RendererOptions, seen: Seen) -> Vec<Work> {
    let lit = avatar.harmonics.is_some().then(|| view_colors(avatar, seen));
    let model = [features(avatar), nodes(avatar)].into_iter().chain(lit);
    model.chain([splats(avatar, seen), sort(options, seen), raster(options, seen)]).collect()
}

fn halves(count: usize) -> u64 {
    2 * count as u64
}

/// Numbers in the feature vectors of all parts.
fn feature_count(avatar: &Avatar) -> u64 {
    (avatar.parts.len() * avatar.networks.output()) as u64
}

fn features(avatar: &Avatar) -> Work {
    let layers = &avatar.networks.layers;
    let networks: u64 = layers.iter().map(|layer| halves(layer.weight.len() + layer.bias.len())).sum();
    let parts = avatar.parts.len() as u64;
    let of = |layer: &Layer, input: u64| 2 * input * layer.output as u64;
    let operations: u64 = layers.iter().map(|layer| parts * of(layer, layer.input.next_multiple_of(4) as u64)).sum();
    let all: u64 = layers.iter().map(|layer| parts * of(layer, layer.input as u64)).sum();
    // Parts outside the head see the expression as zeros.
    let body = parts - (avatar.parts.head as u64).min(parts);
    let zeros = layers.first().map_or(0, |layer| body * of(layer, avatar.inputs.expression as u64));
    Work {
        stage: "features",
        bytes: networks + 4 * feature_count(avatar),
        bytes_floor: networks + 2 * feature_count(avatar),
        operations: Some(operations),
        operations_floor: Some(all - zeros),
    }
}

fn nodes(avatar: &Avatar) -> Work {
    let (nodes, basis) = (avatar.nodes.len() as u64, halves(avatar.nodes.basis.len()));
    let operations = Some(basis);
    Work {
        stage: "nodes",
        bytes: basis + 8 * nodes + 4 * feature_count(avatar) + 16 * nodes,
        // An offset in, a displacement out; nodes in the order of their parts need no index.
        bytes_floor: basis + 6 * nodes + 2 * feature_count(avatar) + 6 * nodes,
        operations,
        operations_floor: operations,
    }
}

/// Colours of the view's direction, of avatars that have them.
fn view_colors(avatar: &Avatar, seen: Seen) -> Work {
    let coefficients = harmonics::bytes(avatar);
    // Position and joints in, and the colour to and fro; where the colour goes is up to the layout.
    let bytes = coefficients + (16 + 8 + 8) * seen.gaussians;
    let bytes_floor = coefficients.min(bytes);
    Work { stage: "harmonics", bytes, bytes_floor, operations: Some(coefficients), operations_floor: Some(coefficients) }
}

fn splats(avatar: &Avatar, seen: Seen) -> Work {
    let rows = halves(avatar.rotation_rows.basis.len() + avatar.scale_rows.basis.len() + avatar.color_rows.basis.len());
    let (features, nodes) = (feature_count(avatar), avatar.nodes.len() as u64);
    let Seen { gaussians, drawn, .. } = seen;
    Work {
        stage: "splats",
        bytes: 48 * gaussians + gaussians + rows + 4 * features + 16 * nodes + SPLAT_BYTES * drawn + 4 * gaussians,
        bytes_floor: GAUSSIAN_FLOOR * gaussians + rows + 2 * features + 6 * nodes + (SPLAT_BYTES + 2) * drawn,
        operations: Some(SPLAT * gaussians + rows),
        operations_floor: Some(PLACE * (gaussians - drawn.min(gaussians)) + SPLAT * drawn + rows),
    }
}

fn sort(options: &RendererOptions, seen: Seen) -> Work {
    // Keys of the culled are read by the first pass too; a pass reads entries twice (count, scatter) and writes them once.
    let [key, entry, value] = [4, 8, 4];
    let Seen { gaussians, drawn, .. } = seen;
    let passes = u64::from(options.key_bits.passes());
    let bytes = (2 * key * gaussians + entry * drawn) + (passes - 2) * 3 * entry * drawn + (2 * entry * drawn + value * drawn);
    // Histograms come for free with the keys. A pass reads what is left of the key, and the value but for the first, which knows it.
    let pass = |left: u64| if left == passes { left + (left - 1 + value) } else { (left + value) + (left - 1 + value) };
    let bytes_floor = drawn * (1..=passes).map(pass).sum::<u64>();
    Work { stage: "sort", bytes, bytes_floor, operations: None, operations_floor: None }
}

fn raster(options: &RendererOptions, seen: Seen) -> Work {
    let picture = u64::from(options.size[0]) * u64::from(options.size[1]);
    let pixel = options.color.bytes() as u64;
    let splats = (4 + SPLAT_BYTES) * seen.drawn;
    Work {
        stage: "raster",
        bytes: splats + 2 * picture * pixel,
        bytes_floor: splats + seen.covered.unwrap_or(picture) * pixel,
        operations: seen.fragments.map(|fragments| FRAGMENT * fragments),
        operations_floor: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{demo, vulkan::sort::KeyBits};

    #[test]
    fn no_floor_is_above_what_is_counted() {
        let avatar = demo::avatar().expect("inside the program");
        let gaussians = avatar.gaussians.len() as u64;
        for key_bits in [KeyBits::Sixteen, KeyBits::TwentyFour, KeyBits::ThirtyTwo] {
            let options = RendererOptions { key_bits, ..RendererOptions::new([256, 256]) };
            for drawn in [0, gaussians / 2, gaussians] {
                let seen = Seen { gaussians, drawn, covered: Some(9000), fragments: Some(100_000) };
                for work in per_stage(&avatar, &options, seen) {
                    assert!(work.bytes_floor <= work.bytes, "{work:?}");
                    assert!(work.operations_floor <= work.operations, "{work:?}");
                    assert!(work.stage == "sort" || work.stage == "raster" || work.operations_floor > Some(0), "{work:?}");
                }
            }
        }
    }

    #[test]
    fn a_pass_more_costs_what_a_pass_moves() {
        let seen = Seen { gaussians: 1000, drawn: 1000, ..Seen::default() };
        let of = |key_bits| sort(&RendererOptions { key_bits, ..RendererOptions::new([1, 1]) }, seen);
        let (two, three) = (of(KeyBits::Sixteen), of(KeyBits::TwentyFour));
        assert_eq!(three.bytes - two.bytes, 24 * 1000);
        // 2 in, 1 + 4 out, 1 + 4 in, 4 out; then 3 in, 2 + 4 out, 2 + 4 in, 1 + 4 out, 1 + 4 in, 4 out.
        assert_eq!([two.bytes_floor, three.bytes_floor], [16 * 1000, 29 * 1000]);
    }
}
