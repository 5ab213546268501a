//! Packs an avatar's arrays into the words and halves that the shaders read. Rounding happens in
//! [`super::compact`]; all other numbers keep the bits that the file has.

use super::compact::{self, CodedRow, LogScales, NodeBits};
use super::{BLOCK_PAIRS, Balance, FrameBlock, GAUSSIAN_PAIRS, LayerLayout};
use crate::{
    avatar::{Activation, Avatar, NetworkLayer, Rows, limits, matrix},
    constants::LEAKY_SLOPE,
    each,
};
use bytemuck::Zeroable;
use half::f16;

/// Gaussians that share a block.
const BLOCK: usize = 32;

/// The frame block's fields that are constant for an avatar; the others are 0.
pub fn constants(avatar: &Avatar) -> FrameBlock {
    let bounds = &avatar.gaussians.bounds;
    let [x, y, z] = bounds.min;
    let step: [f32; 3] = std::array::from_fn(|k| {
        ((f64::from(bounds.max[k]) - f64::from(bounds.min[k])) / 65535.0) as f32
    });
    let features = avatar.networks.output() / 4;
    let scales = LogScales::from_avatar(avatar);
    let (layer, network_quads) = network_layout(avatar);
    let [rotation_words, scale_words, _] = row_words(avatar);
    FrameBlock {
        position_min: [x, y, z, 0.0],
        position_step: [step[0], step[1], step[2], 0.0],
        gaussians: avatar.gaussians.len() as u32,
        nodes: avatar.nodes.len() as u32,
        parts: avatar.parts.len() as u32,
        head_parts: avatar.parts.head as u32,
        basis_quads: avatar.basis_len() as u32 / 4,
        feature_quads: features as u32,
        node_feature: avatar.node_feature_start() as u32 / 4,
        node_start: (avatar.parts.len() * features) as u32,
        layers: avatar.networks.layers.len() as u32,
        layer,
        network_quads,
        scale_start: rotation_words as u32,
        color_start: (rotation_words + scale_words) as u32,
        log_scale_min: scales.min as f32,
        log_scale_step: scales.step as f32,
        low_pass: avatar.filter.variance as f32,
        compensation: if avatar.filter.compensated { 1.0 } else { 0.0 },
        facing_start: plane(pairs(avatar), facing_pairs(avatar)),
        sh_color_start: plane(pairs(avatar) + facing_pairs(avatar), lit_pairs(avatar)),
        slope: match avatar.networks.activation {
            Activation::Relu => 0.0,
            Activation::LeakyRelu => LEAKY_SLOPE as f32,
        },
        ..FrameBlock::zeroed()
    }
}

/// Where each layer's weights and biases are in a part's block, and the quads of that block.
fn network_layout(avatar: &Avatar) -> ([LayerLayout; limits::MLP_LAYERS], u32) {
    let bytes = avatar.networks.in_bytes();
    let mut places = [LayerLayout::zeroed(); limits::MLP_LAYERS];
    let mut quads = 0;
    for (layer, place) in avatar.networks.layers.iter().zip(&mut places) {
        let input_quads = layer.input.div_ceil(4);
        let weight = quads;
        let bias = weight + input_quads * layer.output;
        let bias_quads = if bytes {
            layer.output
        } else {
            layer.output.div_ceil(4)
        };
        quads = bias + bias_quads;
        *place = LayerLayout {
            input_quads: input_quads as u32,
            output_count: layer.output as u32,
            weight: weight as u32,
            bias: bias as u32,
        };
    }
    (places, quads as u32)
}

/// Words of a part's block of so many quads.
fn network_words(avatar: &Avatar, quads: u32) -> usize {
    quads as usize * if avatar.networks.in_bytes() { 1 } else { 2 }
}

/// Packs weights and biases, [balanced](Balance), a block of words a part. In it each layer's
/// weights are ordered by quad of inputs, then by neuron, so that neighbouring invocations read
/// neighbouring quads. A quad is two words of four f16. For networks in bytes it is one word, and a
/// word of bias and step in f16 follows the layer's weights for each neuron.
pub fn networks(avatar: &Avatar, constants: &FrameBlock) -> Vec<u32> {
    let words = network_words(avatar, constants.network_quads);
    let bytes = avatar.networks.in_bytes();
    let balanced = Balance::new(avatar).map(|balance| balance.last_layer());
    let mut layers: Vec<&NetworkLayer> = avatar.networks.layers.iter().collect();
    if let (Some(balanced), Some(last)) = (&balanced, layers.last_mut()) {
        *last = balanced;
    }
    let mut data = vec![0; avatar.parts.len() * words];
    for (part, block) in data.chunks_exact_mut(words.max(1)).enumerate() {
        for (layer, place) in layers.iter().zip(&constants.layer) {
            network_layer(layer, place, part, block, bytes);
        }
    }
    data
}

fn network_layer(
    layer: &NetworkLayer,
    place: &LayerLayout,
    part: usize,
    block: &mut [u32],
    bytes: bool,
) {
    let weights = place.weight as usize;
    let biases = place.bias as usize;
    for neuron in 0..layer.output {
        let row = part * layer.output + neuron;
        let bias = u32::from(layer.bias[row].to_bits());
        match layer.weight.row(row, layer.input) {
            matrix::Row::Bytes { codes, step } if bytes => {
                for (k, codes) in codes.chunks(4).enumerate() {
                    block[weights + k * layer.output + neuron] = word(codes);
                }
                block[biases + neuron] = bias | u32::from(step.to_bits()) << 16;
            }
            numbers => {
                let mut put = |k: usize, weight: f16| {
                    let at = 2 * (weights + k / 4 * layer.output + neuron) + k % 4 / 2;
                    block[at] |= u32::from(weight.to_bits()) << (16 * (k % 2));
                };
                match numbers {
                    matrix::Row::Halves(halves) => {
                        for (k, &weight) in halves.iter().enumerate() {
                            put(k, weight);
                        }
                    }
                    matrix::Row::Bytes { .. } | matrix::Row::Doubles(_) => {
                        for (k, weight) in numbers.iter().enumerate() {
                            put(k, f16::from_f64(weight));
                        }
                    }
                }
                block[2 * biases + neuron / 2] |= bias << (16 * (neuron % 2));
            }
        }
    }
}

/// Sizes of an avatar's packed arrays, bytes, known before they are packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ModelSizes {
    /// Weights and biases.
    pub networks: u64,
    /// Position nodes.
    pub nodes: u64,
    /// First node of each part.
    pub node_starts: u64,
    /// Gaussians, their blocks, where they face, and view-dependent colours.
    pub gaussians: u64,
    /// Basis rows.
    pub rows: u64,
}

impl ModelSizes {
    /// The sizes of an avatar.
    pub fn from_avatar(avatar: &Avatar) -> Self {
        let words = |count: usize| 4 * count as u64;
        Self {
            networks: words(avatar.parts.len() * network_words(avatar, network_layout(avatar).1)),
            nodes: words((node_quads(avatar) + 2) * avatar.nodes.len()),
            node_starts: words(avatar.parts.len() + 1),
            gaussians: words(2 * all_pairs(avatar)),
            rows: words(row_words(avatar).iter().sum()),
        }
    }

    /// Sum of all arrays.
    pub fn total(self) -> u64 {
        self.networks + self.nodes + self.node_starts + self.gaussians + self.rows
    }
}

/// The order of nodes by their parts: the new index of each node, then the first new index of each
/// part, and the number of nodes at the end.
pub fn node_places(avatar: &Avatar) -> (Vec<u16>, Vec<u32>) {
    let mut order: Vec<usize> = (0..avatar.nodes.len()).collect();
    order.sort_by_key(|&node| avatar.nodes.part[node]);
    let mut places = vec![0; order.len()];
    for (place, &node) in order.iter().enumerate() {
        places[node] = place as u16;
    }
    let start = |part: usize| {
        order.partition_point(|&node| usize::from(avatar.nodes.part[node]) < part) as u32
    };
    (places, (0..=avatar.parts.len()).map(start).collect())
}

/// Quads of a node's basis.
fn node_quads(avatar: &Avatar) -> usize {
    3 * avatar.basis_len() / 4
}

/// Packs nodes, their bases [balanced](Balance), into planes of words, one entry a node; see
/// `shaders/mlp/mlp.glsl`.
pub fn nodes(avatar: &Avatar, places: &[u16]) -> Vec<u32> {
    let count = avatar.nodes.len();
    let quads = node_quads(avatar);
    let mut data = vec![0; (quads + 2) * count];
    for (node, &place) in places.iter().enumerate() {
        let [x, y, z] = avatar.nodes.offset[node].map(f16::to_bits);
        data[quads * count + 2 * usize::from(place)] = pair(x, y);
        data[quads * count + 2 * usize::from(place) + 1] = u32::from(z);
    }
    let balanced = Balance::new(avatar).map(|balance| balance.bases());
    let bases = balanced.as_ref().unwrap_or(&avatar.nodes.basis);
    for row in compact::node_rows(bases, 3 * avatar.basis_len()) {
        let place = usize::from(places[row.target as usize]);
        for (quad, codes) in row.codes.chunks_exact(4).enumerate() {
            data[quad * count + place] = word(codes);
        }
        data[quads * count + 2 * place + 1] |= u32::from(f16::from_f64(row.scale).to_bits()) << 16;
    }
    data
}

/// Packs up to four codes into a word; missing ones are 0.
fn word(codes: &[i8]) -> u32 {
    u32::from_le_bytes(std::array::from_fn(|k| {
        codes.get(k).copied().unwrap_or_default().cast_unsigned()
    }))
}

/// Words of all rows of rotation, of scale and of colour. A row has its step and part, the neutral
/// colour if it is a colour's, and its codes.
fn row_words(avatar: &Avatar) -> [usize; 3] {
    let quads = avatar.basis_len() / 4;
    let counts = [
        &avatar.rotation_rows.gaussian,
        &avatar.scale_rows.gaussian,
        &avatar.color_rows.gaussian,
    ]
    .map(Vec::len);
    [
        counts[0] * (1 + 4 * quads),
        counts[1] * (1 + 3 * quads),
        counts[2] * (3 + 3 * quads),
    ]
}

/// Packs the rows of rotation, scale and colour, one after the other; see
/// `shaders/project/project.comp`.
pub fn rows(avatar: &Avatar) -> Vec<u32> {
    let basis = avatar.basis_len();
    let mut data = Vec::with_capacity(row_words(avatar).iter().sum());
    let rotations = compact::rotation_rows(avatar);
    for row in rotations
        .iter()
        .chain(&compact::rows(&avatar.scale_rows, basis))
    {
        push_row(&mut data, avatar, row, &[]);
    }
    for row in compact::rows(&avatar.color_rows, basis) {
        let [red, green, blue] = avatar.gaussians.color[row.target as usize].map(f16::to_bits);
        push_row(
            &mut data,
            avatar,
            &row,
            &[pair(red, green), u32::from(blue)],
        );
    }
    data
}

fn push_row(data: &mut Vec<u32>, avatar: &Avatar, row: &CodedRow, neutral: &[u32]) {
    let part = avatar.parts.part_of(row.target as usize);
    data.push(pair(f16::from_f64(row.scale).to_bits(), part as u16));
    data.extend_from_slice(neutral);
    data.extend(row.codes.chunks_exact(4).map(word));
}

fn pair(low: u16, high: u16) -> u32 {
    u32::from(low) | u32::from(high) << 16
}

/// Pairs of words of all Gaussians and their blocks.
fn pairs(avatar: &Avatar) -> usize {
    GAUSSIAN_PAIRS as usize * avatar.gaussians.len()
        + BLOCK_PAIRS as usize * avatar.gaussians.len().div_ceil(BLOCK)
}

/// Pairs of words for where Gaussians face.
fn facing_pairs(avatar: &Avatar) -> usize {
    avatar.gaussians.facing.len().div_ceil(2)
}

/// Where a plane of so many pairs starts, or 0 if there is none.
fn plane(start: usize, pairs: usize) -> u32 {
    if pairs > 0 { start as u32 } else { 0 }
}

/// Pairs of words of all planes.
fn all_pairs(avatar: &Avatar) -> usize {
    pairs(avatar) + facing_pairs(avatar) + lit_pairs(avatar)
}

/// Pairs of words for view-dependent colours.
fn lit_pairs(avatar: &Avatar) -> usize {
    if avatar.sh.is_some() {
        avatar.gaussians.len()
    } else {
        0
    }
}

/// Packs a Gaussian: position, joints and scale; nodes; rotation, colour and opacity.
fn packed_gaussian(
    avatar: &Avatar,
    scales: LogScales,
    node_places: &[u16],
    i: usize,
) -> [[u32; 2]; GAUSSIAN_PAIRS as usize] {
    let g = &avatar.gaussians;
    let [x, y, z] = g.position[i];
    let scale = (0..3).fold(0, |word, k| {
        word | scales.encode(g.log_scale[i][k].to_f64()) << (10 * k)
    });
    let [a, b, c, _] = g.joint_weight[i];
    let (nodes, shares) = compact::node_shares(avatar, i);
    let places = nodes.map(|node| {
        node_places
            .get(usize::from(node))
            .copied()
            .unwrap_or_default()
    });
    let [nodes, last_node] = NodeBits::new(avatar.nodes.len()).pack(places, shares);
    let [red, green, blue] = g.color[i].map(|c| (c.to_f64().clamp(0.0, 1.0) * 255.0).round() as u8);
    let (rotation, _) = compact::encode_quaternion(g.rotation[i].map(f64::from));
    [
        [pair(x, y), pair(z, scale as u16)],
        [
            u32::from_le_bytes(g.joint[i]),
            u32::from_le_bytes([a, b, c, (scale >> 16) as u8]),
        ],
        [nodes, last_node | scale >> 24 << 26],
        [
            rotation,
            u32::from_le_bytes([red, green, blue, g.opacity[i]]),
        ],
    ]
}

/// Packs Gaussians into pairs of words; see `shaders/common/gaussian.glsl`.
pub fn gaussians(avatar: &Avatar, node_places: &[u16]) -> Vec<[u32; 2]> {
    let count = avatar.gaussians.len();
    let scales = LogScales::from_avatar(avatar);
    let packed = each::map(count, |i| packed_gaussian(avatar, scales, node_places, i));
    let mut data = vec![[0; 2]; all_pairs(avatar)];
    for (i, [first, second, nodes, look]) in packed.into_iter().enumerate() {
        data[2 * i] = first;
        data[2 * i + 1] = second;
        data[2 * count + i] = nodes;
        data[3 * count + i] = look;
    }
    let blocks = &mut data[GAUSSIAN_PAIRS as usize * count..pairs(avatar)];
    mark_rows(blocks, &avatar.rotation_rows, 0, 3);
    mark_rows(blocks, &avatar.scale_rows, 1, 4);
    mark_rows(blocks, &avatar.color_rows, 2, 5);
    let part = |gaussian: usize| avatar.parts.part_of(gaussian) as u16;
    for (at, block) in blocks.chunks_exact_mut(BLOCK_PAIRS as usize).enumerate() {
        block[3][0] = pair(part(at * BLOCK), part((at * BLOCK + BLOCK).min(count) - 1));
    }
    let facing = avatar.gaussians.facing.chunks(2);
    for (pair, codes) in data[pairs(avatar)..].iter_mut().zip(facing) {
        for (word, &[u, v, limit]) in pair.iter_mut().zip(codes) {
            *word = u32::from_le_bytes([u, v, limit, 0]);
        }
    }
    data
}

/// Sets the bit of every Gaussian that has a row in word `mask` of its block, and writes how many
/// rows come before the block into word `base`.
fn mark_rows<const C: usize>(blocks: &mut [[u32; 2]], rows: &Rows<C>, mask: usize, base: usize) {
    for &gaussian in &rows.gaussian {
        blocks[BLOCK_PAIRS as usize * (gaussian as usize / BLOCK) + mask / 2][mask % 2] |=
            1 << (gaussian as usize % BLOCK);
    }
    let mut before = 0;
    for block in blocks.chunks_exact_mut(BLOCK_PAIRS as usize) {
        block[base / 2][base % 2] = before;
        before += block[mask / 2][mask % 2].count_ones();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::pack::PackQuality;

    #[test]
    fn sizes_are_those_of_the_packed_arrays() {
        let whole = crate::demo::avatar().expect("inside the program");
        let bare = Avatar {
            rotation_rows: Rows::default(),
            color_rows: Rows::default(),
            ..whole.clone()
        };
        for avatar in [&whole.packed(PackQuality::Small), &whole, &bare] {
            let constants = constants(avatar);
            let (places, starts) = node_places(avatar);
            let packed = ModelSizes {
                networks: size_of_val(&networks(avatar, &constants)[..]) as u64,
                nodes: size_of_val(&nodes(avatar, &places)[..]) as u64,
                node_starts: size_of_val(&starts[..]) as u64,
                gaussians: size_of_val(&gaussians(avatar, &places)[..]) as u64,
                rows: size_of_val(&rows(avatar)[..]) as u64,
            };
            assert_eq!(ModelSizes::from_avatar(avatar), packed);
        }
    }
}
