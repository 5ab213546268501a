//! Device memory of the training.

use crate::parameters::{BASIS, ParameterLayout, Parameters};
use crate::topology::{CorrectiveRows, Follower, PlacedGaussian, Topology};
use bytemuck::{Pod, cast_slice};
use effigy_core::layout::TRAIN_NO_ROW;
use effigy_render::vulkan::Gpu;
use effigy_render::vulkan::Result;
use effigy_render::vulkan::compute::{Buffer, BufferUsageFlags, MemoryLocation, Slice};
use std::sync::Arc;

/// Storage that kernels and copies use.
const STORAGE: BufferUsageFlags = BufferUsageFlags::from_raw(
    BufferUsageFlags::STORAGE_BUFFER.as_raw()
        | BufferUsageFlags::TRANSFER_SRC.as_raw()
        | BufferUsageFlags::TRANSFER_DST.as_raw(),
);

/// A storage buffer of the device's own, of so many words.
pub(super) fn words(gpu: &Arc<Gpu>, name: &'static str, words: usize) -> Result<Buffer> {
    Buffer::new(
        gpu,
        name,
        4 * words as u64,
        STORAGE,
        MemoryLocation::GpuOnly,
    )
}

/// A storage buffer of the device's own with data.
pub(super) fn filled<T: Pod>(gpu: &Arc<Gpu>, name: &'static str, data: &[T]) -> Result<Buffer> {
    Buffer::with_data(gpu, name, cast_slice(data), STORAGE)
}

/// A storage buffer that the host writes for each step.
pub(super) fn written(gpu: &Arc<Gpu>, name: &'static str, words: usize) -> Result<Buffer> {
    Buffer::new(
        gpu,
        name,
        4 * words as u64,
        STORAGE,
        MemoryLocation::CpuToGpu,
    )
}

/// A storage buffer that the host reads after each step.
pub(super) fn read(gpu: &Arc<Gpu>, name: &'static str, words: usize) -> Result<Buffer> {
    Buffer::new(
        gpu,
        name,
        4 * words as u64,
        STORAGE,
        MemoryLocation::GpuToCpu,
    )
}

/// What is learned, or a number for each of it, on the device.
pub(super) struct Learned {
    pub gaussians: Buffer,
    pub nodes: Buffer,
    pub networks: Buffer,
    pub bases: Buffer,
    layout: ParameterLayout,
}

impl Learned {
    pub fn new(
        gpu: &Arc<Gpu>,
        name: &'static str,
        layout: &ParameterLayout,
        numbers: &Parameters<f32>,
    ) -> Result<Self> {
        Ok(Self {
            gaussians: filled(gpu, name, &numbers.gaussians)?,
            nodes: filled(gpu, name, &numbers.nodes)?,
            networks: filled(gpu, name, &numbers.networks)?,
            bases: filled(gpu, name, &numbers.bases)?,
            layout: layout.clone(),
        })
    }

    /// The nodes' offsets.
    pub fn node_offsets(&self) -> Slice {
        Slice::from(&self.nodes).part(0, 4 * self.layout.node_bases as u64)
    }

    /// The nodes' bases.
    pub fn node_bases(&self) -> Slice {
        let bases = 4 * (self.layout.nodes * 3 * BASIS) as u64;
        Slice::from(&self.nodes).part(4 * self.layout.node_bases as u64, bases)
    }

    /// Copies all of it back, and waits.
    pub fn download(&self) -> Result<Parameters<f32>> {
        let [gaussians, nodes, networks, bases] = self.layout.lengths();
        let get = |buffer: &Buffer, length: usize| -> Result<Vec<f32>> {
            Ok(bytemuck::pod_collect_to_vec(&buffer.download(4 * length)?))
        };
        Ok(Parameters {
            gaussians: get(&self.gaussians, gaussians)?,
            nodes: get(&self.nodes, nodes)?,
            networks: get(&self.networks, networks)?,
            bases: get(&self.bases, bases)?,
        })
    }
}

/// The topology, on the device.
pub(super) struct Fixed {
    /// Three vectors a Gaussian (`shaders/train/gaussian.glsl`).
    pub gaussians: Buffer,
    /// Row of rotation, scale and colour of each Gaussian, and its part.
    pub rows: Buffer,
    /// The part of each node.
    pub node_part: Buffer,
    /// Where each node's followers begin.
    pub node_starts: Buffer,
    /// The Gaussians that follow each node, and their weights.
    pub followers: Buffer,
    /// Gaussians and nodes of each part.
    pub members: Buffer,
    /// Where each joint's Gaussians begin.
    pub joint_starts: Buffer,
    /// The Gaussians that each joint moves, and their weights.
    pub moved: Buffer,
}

impl Fixed {
    pub fn new(gpu: &Arc<Gpu>, topology: &Topology, rows: &CorrectiveRows) -> Result<Self> {
        let row = |attribute, k| {
            let row = rows.row(attribute, k);
            row.map_or(TRAIN_NO_ROW, |row| row as u32)
        };
        let row_words: Vec<u32> = topology
            .gaussians
            .iter()
            .enumerate()
            .flat_map(|(k, placed)| [row(0, k), row(1, k), row(2, k), u32::from(placed.part)])
            .collect();
        let node_part: Vec<u32> = topology.node_part.iter().map(|&p| u32::from(p)).collect();
        let node_starts = starts(topology.followers.iter().map(Vec::len));
        let followers = follower_words(&topology.followers);
        let moved = topology.moved();
        let joint_starts = starts(moved.iter().map(Vec::len));
        // A buffer has at least one word.
        let mut moved = follower_words(&moved);
        moved.extend([0, 0]);
        let mut members = topology.part_start.clone();
        members.extend(starts(topology.part_nodes.iter().map(Vec::len)));
        members.extend(topology.part_nodes.iter().flatten());
        Ok(Self {
            gaussians: filled(gpu, "placed Gaussians", &placed_words(topology))?,
            rows: filled(gpu, "rows", &row_words)?,
            node_part: filled(gpu, "node parts", &node_part)?,
            node_starts: filled(gpu, "node starts", &node_starts)?,
            followers: filled(gpu, "followers", &followers)?,
            members: filled(gpu, "members", &members)?,
            joint_starts: filled(gpu, "joint starts", &joint_starts)?,
            moved: filled(gpu, "moved Gaussians", &moved)?,
        })
    }
}

/// Three vectors a Gaussian (`shaders/train/gaussian.glsl`).
pub(super) fn placed_words(topology: &Topology) -> Vec<u32> {
    let words = |placed: &PlacedGaussian| -> [u32; 12] {
        let [x, y, z] = placed.position.as_vec3().to_array().map(f32::to_bits);
        let [a, b, c] = placed.node.map(u32::from);
        let [of_a, of_b, of_c] = placed.node_weight.map(|weight| (weight as f32).to_bits());
        let [u, v, limit] = placed.facing;
        [
            x,
            y,
            z,
            a | b << 16,
            of_a,
            of_b,
            of_c,
            c | u32::from(placed.part) << 16,
            u32::from_le_bytes(placed.joint),
            u32::from_le_bytes(placed.joint_weight),
            u32::from_le_bytes([u, v, limit, 0]),
            0,
        ]
    };
    topology.gaussians.iter().flat_map(words).collect()
}

/// Two words each, list after list.
fn follower_words(lists: &[Vec<Follower>]) -> Vec<u32> {
    lists
        .iter()
        .flatten()
        .flat_map(|follower| [follower.gaussian, (follower.weight as f32).to_bits()])
        .collect()
}

/// Where each of some lists begins in all of them, and where the last ends.
fn starts(lengths: impl Iterator<Item = usize>) -> Vec<u32> {
    let mut all = vec![0];
    let mut end = 0;
    for length in lengths {
        end += length as u32;
        all.push(end);
    }
    all
}
