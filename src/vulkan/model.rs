//! An avatar's arrays as the GPU holds them: an [`Avatar`] goes in, four buffers and the constant part of the uniform block come out.
//!
//! Halves keep the bits that the file has, but for rotation rows: the quaternion is stored with length 1, so its correctives are
//! divided by the length that it had, which changes nothing after normalisation.

use super::{device::Gpu, error::Result, memory::Buffer};
use crate::{
    avatar::{Activation, Avatar, Layer, Occluder, Rows, occluder::Vertex},
    layout::{self, Frame, GAUSSIAN_PLANES},
};
use ash::vk;
use bytemuck::{Zeroable, cast_slice};
use half::f16;
use std::sync::Arc;

/// An [`Occluder`] in device memory; see `shaders/surface.vert`.
pub struct OccluderMesh {
    pub corners: Buffer,
    pub indices: Buffer,
    /// Of the mesh: three a triangle.
    pub index_count: u32,
}

impl OccluderMesh {
    fn new(gpu: &Arc<Gpu>, avatar: &Avatar, occluder: &Occluder) -> Result<Self> {
        let corner = |vertex: &Vertex| -> [[u32; 4]; 2] {
            let [x, y, z] = avatar.gaussians.bounds.encode(vertex.position);
            let words = [u32::from(x) | u32::from(y) << 16, u32::from(z)];
            let [a, b, c] = vertex.node.map(u32::from);
            let [first, second, _] = avatar.weights_of(vertex.position, vertex.node).map(|w| (w * 65535.0).round() as u32);
            [
                [words[0], words[1], u32::from_le_bytes(vertex.joint), u32::from_le_bytes(vertex.joint_weight)],
                [a | b << 16, c, first | second << 16, 0],
            ]
        };
        let corners: Vec<[[u32; 4]; 2]> = occluder.vertices.iter().map(corner).collect();
        Ok(Self {
            corners: Buffer::with_data(gpu, "surface corners", cast_slice(&corners), vk::BufferUsageFlags::STORAGE_BUFFER)?,
            indices: Buffer::with_data(gpu, "surface indices", cast_slice(&occluder.triangles), vk::BufferUsageFlags::INDEX_BUFFER)?,
            index_count: 3 * occluder.triangles.len() as u32,
        })
    }
}

/// The model in device memory, read-only.
pub struct Model {
    pub networks: Buffer,
    pub nodes: Buffer,
    pub gaussians: Buffer,
    pub rows: Buffer,
    /// The avatar's solid inside.
    pub occluder: OccluderMesh,
    /// The uniform block with all that no frame changes.
    pub constants: Box<Frame>,
}

impl Model {
    /// `occluder`: whether frames will ask for what no one can see.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, occluder: bool) -> Result<Self> {
        let mut constants = Box::new(constants(avatar));
        let networks = networks(avatar, &mut constants);
        let rows = rows(avatar, &mut constants);
        let occluder = if occluder { Occluder::new(avatar) } else { Occluder::default() };
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER;
        Ok(Self {
            networks: Buffer::with_data(gpu, "networks", cast_slice(&networks), storage)?,
            nodes: Buffer::with_data(gpu, "nodes", cast_slice(&nodes(avatar)), storage)?,
            gaussians: Buffer::with_data(gpu, "gaussians", cast_slice(&gaussians(avatar)), storage | vk::BufferUsageFlags::TRANSFER_SRC)?,
            rows: Buffer::with_data(gpu, "rows", cast_slice(&rows), storage)?,
            occluder: OccluderMesh::new(gpu, avatar, &occluder)?,
            constants,
        })
    }

    /// RGB of every Gaussian as the last frame left them, for tests.
    pub fn colors(&self) -> Result<Vec<[f32; 3]>> {
        let count = self.constants.gaussians as usize;
        let words: Vec<[u32; 4]> = bytemuck::pod_collect_to_vec(&self.gaussians.download(16 * GAUSSIAN_PLANES as usize * count)?);
        let half = |word: u32| f16::from_bits(word as u16).to_f32();
        Ok(words[2 * count..].iter().map(|c| [half(c[0]), half(c[0] >> 16), half(c[1])]).collect())
    }
}

fn constants(avatar: &Avatar) -> Frame {
    let bounds = &avatar.gaussians.bounds;
    let [x, y, z] = bounds.min;
    let step: [f32; 3] = std::array::from_fn(|k| ((f64::from(bounds.max[k]) - f64::from(bounds.min[k])) / 65535.0) as f32);
    let features = avatar.networks.output() / 4;
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
        layers: avatar.networks.layers.len() as u32,
        slope: match avatar.networks.activation {
            Activation::Relu => 0.0,
            Activation::LeakyRelu => 0.01,
        },
        ..Frame::zeroed()
    }
}

/// Weights and biases, a block a part; inside it each layer's weights by quad of inputs, then by neuron, so that neighbouring
/// invocations read neighbouring quads.
fn networks(avatar: &Avatar, constants: &mut Frame) -> Vec<f16> {
    let mut quads = 0;
    for (layer, place) in avatar.networks.layers.iter().zip(&mut constants.layer) {
        let input_quads = layer.input.div_ceil(4);
        let weight = quads;
        let bias = weight + input_quads * layer.output;
        quads = bias + layer.output.div_ceil(4);
        *place = layout::Layer { input_quads: input_quads as u32, output: layer.output as u32, weight: weight as u32, bias: bias as u32 };
    }
    constants.network_quads = quads as u32;
    let mut data = vec![f16::ZERO; avatar.parts.len() * quads * 4];
    for (part, block) in data.chunks_exact_mut((quads * 4).max(1)).enumerate() {
        for (layer, place) in avatar.networks.layers.iter().zip(&constants.layer) {
            network_layer(layer, place, part, block);
        }
    }
    data
}

fn network_layer(layer: &Layer, place: &layout::Layer, part: usize, block: &mut [f16]) {
    for neuron in 0..layer.output {
        let row = &layer.weight[(part * layer.output + neuron) * layer.input..][..layer.input];
        for (k, &weight) in row.iter().enumerate() {
            block[(place.weight as usize + k / 4 * layer.output + neuron) * 4 + k % 4] = weight;
        }
        block[place.bias as usize * 4 + neuron] = layer.bias[part * layer.output + neuron];
    }
}

/// Planes of half quads, one entry a node; see `shaders/nodes.comp`. The part is a whole number below 1024, which f16 holds exactly.
fn nodes(avatar: &Avatar) -> Vec<f16> {
    let (count, basis) = (avatar.nodes.len(), avatar.basis_len());
    let mut data = vec![f16::ZERO; (3 * basis + 4) * count];
    for node in 0..count {
        let row = &avatar.nodes.basis[node * 3 * basis..][..3 * basis];
        for (k, &value) in row.iter().enumerate() {
            data[(k / 4 * count + node) * 4 + k % 4] = value;
        }
        let [x, y, z] = avatar.nodes.offset[node];
        let last = [x, y, z, f16::from_f32(f32::from(avatar.nodes.part[node]))];
        data[(3 * basis / 4 * count + node) * 4..][..4].copy_from_slice(&last);
    }
    data
}

/// Basis rows of rotation, scale and colour, one after the other.
fn rows(avatar: &Avatar, constants: &mut Frame) -> Vec<f16> {
    let basis = avatar.basis_len();
    let mut data = Vec::with_capacity(avatar.rotation_rows.basis.len() + avatar.scale_rows.basis.len() + avatar.color_rows.basis.len());
    for (&gaussian, row) in avatar.rotation_rows.gaussian.iter().zip(avatar.rotation_rows.basis.chunks_exact((4 * basis).max(1))) {
        let length = quaternion_length(avatar, gaussian as usize);
        // Against a quaternion of nearly no length a corrective may be more than f16 holds. Shrunk as a whole it keeps its direction.
        let largest = row.iter().fold(0.0, |largest: f64, value| largest.max(value.to_f64().abs()));
        let length = length.max(largest / f16::MAX.to_f64());
        data.extend(row.iter().map(|value| f16::from_f64(value.to_f64() / length)));
    }
    constants.scale_start = (data.len() / 4) as u32;
    data.extend_from_slice(&avatar.scale_rows.basis);
    constants.color_start = (data.len() / 4) as u32;
    data.extend_from_slice(&avatar.color_rows.basis);
    data
}

fn quaternion_length(avatar: &Avatar, gaussian: usize) -> f64 {
    avatar.gaussians.rotation[gaussian].iter().map(|v| v.to_f64() * v.to_f64()).sum::<f64>().sqrt()
}

/// Three planes of a vector a Gaussian, then two vectors for every 32; see `shaders/splats.comp`.
fn gaussians(avatar: &Avatar) -> Vec<[u32; 4]> {
    let g = &avatar.gaussians;
    let count = g.len();
    let mut data = vec![[0; 4]; GAUSSIAN_PLANES as usize * count + 2 * count.div_ceil(32)];
    let pair = |low: u16, high: u16| u32::from(low) | u32::from(high) << 16;
    for part in 0..avatar.parts.len() {
        for i in avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize {
            let [x, y, z] = g.position[i];
            data[i] = [
                pair(x, y),
                pair(z, u16::from_le_bytes([g.opacity[i], radius(g.log_scale[i])])),
                u32::from_le_bytes(g.joint[i]),
                u32::from_le_bytes(g.joint_weight[i]),
            ];
            let length = quaternion_length(avatar, i);
            let q = g.rotation[i].map(|v| ((v.to_f64() / length * 32767.0).round() as i16).cast_unsigned());
            let s = g.log_scale[i].map(f16::to_bits);
            data[count + i] = [pair(q[0], q[1]), pair(q[2], q[3]), pair(s[0], s[1]), pair(s[2], part as u16)];
            let c = g.color[i].map(f16::to_bits);
            let n = g.node[i];
            let weight = avatar.node_weights(i).map(|w| (w * 65535.0).round() as u16);
            data[2 * count + i] = [pair(c[0], c[1]), pair(c[2], n[0]), pair(n[1], n[2]), pair(weight[0], weight[1])];
        }
    }
    let blocks = &mut data[GAUSSIAN_PLANES as usize * count..];
    mark(blocks, &avatar.rotation_rows, 0, 3);
    mark(blocks, &avatar.scale_rows, 1, 4);
    mark(blocks, &avatar.color_rows, 2, 5);
    data
}

/// The longest axis as `shaders/splats.comp` reads it, rounded up, with room for what skinning and correctives add.
fn radius(log_scale: [f16; 3]) -> u8 {
    /// A fifth.
    const ROOM: f64 = 1.2;
    let longest = log_scale.iter().map(|s| s.to_f64()).fold(f64::NEG_INFINITY, f64::max).exp();
    (16.0 * (ROOM * longest).log2() + 256.0).ceil().clamp(0.0, 255.0) as u8
}

/// Sets the bit of every Gaussian that keeps a row, in word `mask` of its block, and in word `base` how many rows come before the block.
fn mark<const C: usize>(blocks: &mut [[u32; 4]], rows: &Rows<C>, mask: usize, base: usize) {
    for &gaussian in &rows.gaussian {
        blocks[2 * (gaussian as usize / 32) + mask / 4][mask % 4] |= 1 << (gaussian % 32);
    }
    let mut before = 0;
    for block in blocks.chunks_exact_mut(2) {
        block[base / 4][base % 4] = before;
        before += block[mask / 4][mask % 4].count_ones();
    }
}
