//! An avatar's arrays as the shaders read them: an [`Avatar`] goes in, words and halves come out. What it rounds is in
//! [`super::compact`]; all else keeps the bits that the file has.

use super::compact::{self, LogScales, Row};
use crate::{
    avatar::{Activation, Avatar, Layer, Occluder, Rows, limits, matrix, occluder::Vertex},
    layout::{self, BLOCK_PAIRS, Frame, GAUSSIAN_PAIRS},
};
use bytemuck::Zeroable;
use half::f16;

/// Gaussians that share a block.
const BLOCK: usize = 32;

/// The part of the uniform block that no frame changes.
pub fn constants(avatar: &Avatar) -> Frame {
    let bounds = &avatar.gaussians.bounds;
    let [x, y, z] = bounds.min;
    let step: [f32; 3] = std::array::from_fn(|k| ((f64::from(bounds.max[k]) - f64::from(bounds.min[k])) / 65535.0) as f32);
    let features = avatar.networks.output() / 4;
    let scales = LogScales::of(avatar);
    let (layer, network_quads) = network_layout(avatar);
    let [rotations, scales_of, _] = row_words(avatar);
    Frame {
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
        scale_start: rotations as u32,
        color_start: (rotations + scales_of) as u32,
        log_scale_min: scales.min as f32,
        log_scale_step: scales.step as f32,
        lit_start: avatar.harmonics.as_ref().map_or(0, |_| pairs(avatar) as u32),
        slope: match avatar.networks.activation {
            Activation::Relu => 0.0,
            Activation::LeakyRelu => 0.01,
        },
        ..Frame::zeroed()
    }
}

/// Where each layer's weights and biases are in a part's block, and the block's quads.
fn network_layout(avatar: &Avatar) -> ([layout::Layer; limits::MLP_LAYERS], u32) {
    let (mut places, mut quads, bytes) = ([layout::Layer::zeroed(); limits::MLP_LAYERS], 0, avatar.networks.in_bytes());
    for (layer, place) in avatar.networks.layers.iter().zip(&mut places) {
        let input_quads = layer.input.div_ceil(4);
        let weight = quads;
        let bias = weight + input_quads * layer.output;
        quads = bias + if bytes { layer.output } else { layer.output.div_ceil(4) };
        *place = layout::Layer { input_quads: input_quads as u32, output: layer.output as u32, weight: weight as u32, bias: bias as u32 };
    }
    (places, quads as u32)
}

/// Words of a part's block.
fn network_words(avatar: &Avatar, quads: u32) -> usize {
    quads as usize * if avatar.networks.in_bytes() { 1 } else { 2 }
}

/// Weights and biases, a block a part, as words; inside it each layer's weights by quad of inputs, then by neuron, so that neighbouring
/// invocations read neighbouring quads. A quad is two words of four f16; of networks in bytes it is one word, and so is what follows the
/// layer's weights for each neuron: bias and step, f16.
pub fn networks(avatar: &Avatar, constants: &Frame) -> Vec<u32> {
    let (words, bytes) = (network_words(avatar, constants.network_quads), avatar.networks.in_bytes());
    let mut data = vec![0; avatar.parts.len() * words];
    for (part, block) in data.chunks_exact_mut(words.max(1)).enumerate() {
        for (layer, place) in avatar.networks.layers.iter().zip(&constants.layer) {
            network_layer(layer, place, part, block, bytes);
        }
    }
    data
}

fn network_layer(layer: &Layer, place: &layout::Layer, part: usize, block: &mut [u32], bytes: bool) {
    let (weights, biases) = (place.weight as usize, place.bias as usize);
    for neuron in 0..layer.output {
        let row = part * layer.output + neuron;
        let bias = u32::from(layer.bias[row].to_bits());
        match layer.weight.row(row, layer.input) {
            matrix::Row::Bytes { codes, step } if bytes => {
                codes.chunks(4).enumerate().for_each(|(k, codes)| block[weights + k * layer.output + neuron] = word(codes));
                block[biases + neuron] = bias | u32::from(step.to_bits()) << 16;
            }
            numbers => {
                for (k, weight) in numbers.iter().enumerate() {
                    let at = 2 * (weights + k / 4 * layer.output + neuron) + k % 4 / 2;
                    block[at] |= u32::from(f16::from_f64(weight).to_bits()) << (16 * (k % 2));
                }
                block[2 * biases + neuron / 2] |= bias << (16 * (neuron % 2));
            }
        }
    }
}

/// How long an avatar's arrays are, bytes: known before any of them is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    pub networks: u64,
    pub nodes: u64,
    pub node_starts: u64,
    pub gaussians: u64,
    pub rows: u64,
}

impl Sizes {
    pub fn of(avatar: &Avatar) -> Self {
        let words = |count: usize| 4 * count as u64;
        Self {
            networks: words(avatar.parts.len() * network_words(avatar, network_layout(avatar).1)),
            nodes: words((node_quads(avatar) + 2) * avatar.nodes.len()),
            node_starts: words(avatar.parts.len() + 1),
            gaussians: words(2 * (pairs(avatar) + lit(avatar))),
            rows: words(row_words(avatar).iter().sum()),
        }
    }

    /// Of device memory.
    pub fn total(self) -> u64 {
        self.networks + self.nodes + self.node_starts + self.gaussians + self.rows
    }
}

/// Where each node is when nodes are in the order of their parts, and each part's first, and their number.
pub fn node_places(avatar: &Avatar) -> (Vec<u16>, Vec<u32>) {
    let mut order: Vec<usize> = (0..avatar.nodes.len()).collect();
    order.sort_by_key(|&node| avatar.nodes.part[node]);
    let mut places = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, &node)| places[node] = place as u16);
    let start = |part: usize| order.partition_point(|&node| usize::from(avatar.nodes.part[node]) < part) as u32;
    (places, (0..=avatar.parts.len()).map(start).collect())
}

/// Quads of a node's basis.
fn node_quads(avatar: &Avatar) -> usize {
    3 * avatar.basis_len() / 4
}

/// Planes of words, one entry a node; see `shaders/features.comp`.
pub fn nodes(avatar: &Avatar, places: &[u16]) -> Vec<u32> {
    let (count, quads) = (avatar.nodes.len(), node_quads(avatar));
    let mut data = vec![0; (quads + 2) * count];
    for (node, &place) in places.iter().enumerate() {
        let [x, y, z] = avatar.nodes.offset[node].map(f16::to_bits);
        data[quads * count + 2 * usize::from(place)] = pair(x, y);
        data[quads * count + 2 * usize::from(place) + 1] = u32::from(z);
    }
    for row in compact::node_rows(avatar) {
        let place = usize::from(places[row.of as usize]);
        row.codes.chunks_exact(4).enumerate().for_each(|(quad, codes)| data[quad * count + place] = word(codes));
        data[quads * count + 2 * place + 1] |= u32::from(f16::from_f64(row.scale).to_bits()) << 16;
    }
    data
}

/// Four steps, or fewer and zeros.
fn word(codes: &[i8]) -> u32 {
    u32::from_le_bytes(std::array::from_fn(|k| codes.get(k).copied().unwrap_or_default().cast_unsigned()))
}

/// Words of all rows of rotation, of scale and of colour. A row is a step and a part, of colour the neutral colour, and its codes.
fn row_words(avatar: &Avatar) -> [usize; 3] {
    let quads = avatar.basis_len() / 4;
    let counts = [&avatar.rotation_rows.gaussian, &avatar.scale_rows.gaussian, &avatar.color_rows.gaussian].map(Vec::len);
    [counts[0] * (1 + 4 * quads), counts[1] * (1 + 3 * quads), counts[2] * (3 + 3 * quads)]
}

/// Rows of rotation, scale and colour, one after the other; see `shaders/splats.comp`.
pub fn rows(avatar: &Avatar) -> Vec<u32> {
    let basis = avatar.basis_len();
    let mut data = Vec::with_capacity(row_words(avatar).iter().sum());
    compact::rotation_rows(avatar).for_each(|row| push(&mut data, avatar, &row, &[]));
    compact::rows(&avatar.scale_rows, basis).for_each(|row| push(&mut data, avatar, &row, &[]));
    for row in compact::rows(&avatar.color_rows, basis) {
        let [red, green, blue] = avatar.gaussians.color[row.of as usize].map(f16::to_bits);
        push(&mut data, avatar, &row, &[pair(red, green), u32::from(blue)]);
    }
    data
}

fn push(data: &mut Vec<u32>, avatar: &Avatar, row: &Row, neutral: &[u32]) {
    let part = avatar.parts.start.partition_point(|&start| start <= row.of) - 1;
    data.push(pair(f16::from_f64(row.scale).to_bits(), part as u16));
    data.extend_from_slice(neutral);
    data.extend(row.codes.chunks_exact(4).map(word));
}

fn pair(low: u16, high: u16) -> u32 {
    u32::from(low) | u32::from(high) << 16
}

/// Pairs of words of the Gaussians and their blocks.
fn pairs(avatar: &Avatar) -> usize {
    GAUSSIAN_PAIRS as usize * avatar.gaussians.len() + BLOCK_PAIRS as usize * avatar.gaussians.len().div_ceil(BLOCK)
}

/// Pairs of words for colours that a camera changes.
fn lit(avatar: &Avatar) -> usize {
    if avatar.harmonics.is_some() { avatar.gaussians.len() } else { 0 }
}

/// Pairs of words; see `shaders/gaussian.glsl`.
pub fn gaussians(avatar: &Avatar, node_places: &[u16]) -> Vec<[u32; 2]> {
    let g = &avatar.gaussians;
    let (count, scales) = (g.len(), LogScales::of(avatar));
    let mut data = vec![[0; 2]; pairs(avatar) + lit(avatar)];
    for i in 0..count {
        let [x, y, z] = g.position[i];
        let scale = (0..3).fold(0, |word, k| word | scales.encode(g.log_scale[i][k].to_f64()) << (10 * k));
        let [a, b, c, _] = g.joint_weight[i];
        let (nodes, [first, second]) = compact::node_shares(avatar, i);
        let n = nodes.map(|node| node_places.get(usize::from(node)).copied().unwrap_or_default());
        data[2 * i] = [pair(x, y), pair(z, scale as u16)];
        data[2 * i + 1] = [u32::from_le_bytes(g.joint[i]), u32::from_le_bytes([a, b, c, (scale >> 16) as u8])];
        data[2 * count + i] = [pair(n[0], n[1]), u32::from(n[2]) | first << 16 | second << 21 | scale >> 24 << 26];
        let [red, green, blue] = g.color[i].map(|c| (c.to_f64().clamp(0.0, 1.0) * 255.0).round() as u8);
        let (rotation, _) = compact::encode_quaternion(g.rotation[i].map(f64::from));
        data[3 * count + i] = [rotation, u32::from_le_bytes([red, green, blue, g.opacity[i]])];
    }
    let blocks = &mut data[GAUSSIAN_PAIRS as usize * count..pairs(avatar)];
    mark(blocks, &avatar.rotation_rows, 0, 3);
    mark(blocks, &avatar.scale_rows, 1, 4);
    mark(blocks, &avatar.color_rows, 2, 5);
    let part = |gaussian: usize| (avatar.parts.start.partition_point(|&start| start as usize <= gaussian) - 1) as u16;
    for (at, block) in blocks.chunks_exact_mut(BLOCK_PAIRS as usize).enumerate() {
        block[3][0] = pair(part(at * BLOCK), part((at * BLOCK + BLOCK).min(count) - 1));
    }
    data
}

/// Sets the bit of every Gaussian that keeps a row, in word `mask` of its block, and in word `base` how many rows come before the block.
fn mark<const C: usize>(blocks: &mut [[u32; 2]], rows: &Rows<C>, mask: usize, base: usize) {
    for &gaussian in &rows.gaussian {
        blocks[BLOCK_PAIRS as usize * (gaussian as usize / BLOCK) + mask / 2][mask % 2] |= 1 << (gaussian as usize % BLOCK);
    }
    let mut before = 0;
    for block in blocks.chunks_exact_mut(BLOCK_PAIRS as usize) {
        block[base / 2][base % 2] = before;
        before += block[mask / 2][mask % 2].count_ones();
    }
}

/// The corners and the triangles of an avatar's solid inside; see `shaders/surface.vert`.
pub fn occluder(avatar: &Avatar, occluder: &Occluder, node_places: &[u16]) -> (Vec<[[u32; 4]; 2]>, Vec<[u16; 3]>) {
    let corner = |vertex: &Vertex| -> [[u32; 4]; 2] {
        let [x, y, z] = avatar.gaussians.bounds.encode(vertex.position);
        let words = [u32::from(x) | u32::from(y) << 16, u32::from(z)];
        let [a, b, c] = vertex.node.map(|node| u32::from(node_places.get(usize::from(node)).copied().unwrap_or_default()));
        let [first, second, _] = avatar.weights_of(vertex.position, vertex.node).map(|w| (w * 65535.0).round() as u32);
        [
            [words[0], words[1], u32::from_le_bytes(vertex.joint), u32::from_le_bytes(vertex.joint_weight)],
            [a | b << 16, c, first | second << 16, 0],
        ]
    };
    let corners: Vec<[[u32; 4]; 2]> = occluder.vertices.iter().map(corner).collect();
    // A corner that 16 bits don't reach is none that an avatar's coarse mesh has: its triangle hides nothing.
    let indices: Vec<[u16; 3]> = occluder
        .triangles
        .iter()
        .filter_map(|corners| {
            let [a, b, c] = corners.map(|corner| u16::try_from(corner).ok());
            Some([a?, b?, c?])
        })
        .collect();
    (corners, indices)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{avatar::pack::Quality, demo};

    #[test]
    fn arrays_are_as_long_as_said_before() {
        let whole = demo::avatar().expect("inside the program");
        let bare = Avatar { rotation_rows: Rows::default(), color_rows: Rows::default(), ..whole.clone() };
        for avatar in [&whole.packed(Quality::Small), &whole, &bare] {
            let (constants, (places, starts)) = (constants(avatar), node_places(avatar));
            let made = Sizes {
                networks: size_of_val(&networks(avatar, &constants)[..]) as u64,
                nodes: size_of_val(&nodes(avatar, &places)[..]) as u64,
                node_starts: size_of_val(&starts[..]) as u64,
                gaussians: size_of_val(&gaussians(avatar, &places)[..]) as u64,
                rows: size_of_val(&rows(avatar)[..]) as u64,
            };
            assert_eq!(Sizes::of(avatar), made);
        }
    }
}
