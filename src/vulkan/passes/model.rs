//! An avatar on the device: an [`Avatar`] goes in, its buffers and the constant part of the uniform
//! block come out.

use crate::vulkan::{
    device::{error::Result, gpu::Gpu},
    memory::Buffer,
};
use ash::vk;
use bytemuck::cast_slice;
use effigy_core::{
    avatar::Avatar,
    layout::{FrameBlock, GAUSSIAN_PAIRS, pack},
    occluder::Occluder,
};
use half::f16;
use std::sync::Arc;

/// An [`Occluder`] in device memory; see `shaders/occluder/depth.vert`.
pub struct OccluderMesh {
    /// Storage buffer: an [`OccluderCorner`](effigy_core::layout::OccluderCorner) a vertex.
    pub corners: Buffer,
    /// Index buffer: 16 bits an index.
    pub indices: Buffer,
    /// Of the mesh: three a triangle.
    pub index_count: u32,
}

impl OccluderMesh {
    fn new(
        gpu: &Arc<Gpu>,
        avatar: &Avatar,
        occluder: &Occluder,
        node_places: &[u16],
    ) -> Result<Self> {
        let (corners, indices) = pack::occluder(avatar, occluder, node_places);
        Ok(Self {
            corners: Buffer::with_data(
                gpu,
                "occluder corners",
                cast_slice(&corners),
                vk::BufferUsageFlags::STORAGE_BUFFER,
            )?,
            indices: Buffer::with_data(
                gpu,
                "occluder indices",
                cast_slice(&indices),
                vk::BufferUsageFlags::INDEX_BUFFER,
            )?,
            index_count: 3 * indices.len() as u32,
        })
    }
}

/// Gaussians in device memory.
pub struct GaussianSet {
    /// In canonical pose.
    pub gaussians: Buffer,
    /// Basis rows of their correctives.
    pub rows: Buffer,
    /// The uniform block with all that no frame changes.
    pub constants: Box<FrameBlock>,
}

impl GaussianSet {
    fn new(gpu: &Arc<Gpu>, avatar: &Avatar, node_places: &[u16]) -> Result<Self> {
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER;
        Ok(Self {
            gaussians: Buffer::with_data(
                gpu,
                "gaussians",
                cast_slice(&pack::gaussians(avatar, node_places)),
                storage | vk::BufferUsageFlags::TRANSFER_SRC,
            )?,
            rows: Buffer::with_data(gpu, "rows", cast_slice(&pack::rows(avatar)), storage)?,
            constants: Box::new(pack::constants(avatar)),
        })
    }
}

/// The model in device memory, read-only.
pub struct Model {
    /// Words; see `shaders/mlp/mlp.glsl`.
    pub networks: Buffer,
    /// Offsets and bases of the position nodes; see `shaders/mlp/mlp.glsl`.
    pub nodes: Buffer,
    /// Each part's first node, and their number.
    pub node_starts: Buffer,
    /// Where each of the avatar's nodes is among those of the device, which are in the order of
    /// their parts.
    pub node_places: Vec<u16>,
    /// The Gaussians of the avatar, then those of its levels, the finest first.
    pub sets: Vec<GaussianSet>,
    /// The occluder mesh of the avatar.
    pub occluder: OccluderMesh,
    /// Whether the networks' weights are bytes.
    pub networks_in_bytes: bool,
}

impl Model {
    /// `occluder`: whether frames use the occluder mesh.
    pub(crate) fn new(gpu: &Arc<Gpu>, avatar: &Avatar, occluder: bool) -> Result<Self> {
        let (node_places, node_starts) = pack::node_places(avatar);
        let own = GaussianSet::new(gpu, avatar, &node_places)?;
        let networks = pack::networks(avatar, &own.constants);
        let mut sets = vec![own];
        for level in &avatar.levels {
            let places: &[u16] = if level.correctives {
                &node_places
            } else {
                &[0]
            };
            sets.push(GaussianSet::new(gpu, &avatar.at_level(level), places)?);
        }
        let occluder = if occluder {
            Occluder::new(avatar)
        } else {
            Occluder::default()
        };
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER;
        Ok(Self {
            networks: Buffer::with_data(gpu, "networks", cast_slice(&networks), storage)?,
            nodes: Buffer::with_data(
                gpu,
                "nodes",
                cast_slice(&pack::nodes(avatar, &node_places)),
                storage,
            )?,
            node_starts: Buffer::with_data(gpu, "node starts", cast_slice(&node_starts), storage)?,
            sets,
            occluder: OccluderMesh::new(gpu, avatar, &occluder, &node_places)?,
            node_places,
            networks_in_bytes: avatar.networks.in_bytes(),
        })
    }

    /// The avatar's own Gaussians.
    pub fn own(&self) -> &GaussianSet {
        &self.sets[0]
    }

    /// RGB of every Gaussian before correctives, as the last frame saw them, for tests.
    pub fn colors(&self) -> Result<Vec<[f32; 3]>> {
        let count = self.own().constants.gaussians as usize;
        let lit = self.own().constants.sh_color_start as usize;
        let pairs = if lit > 0 {
            lit + count
        } else {
            GAUSSIAN_PAIRS as usize * count
        };
        let pairs: Vec<[u32; 2]> =
            bytemuck::pod_collect_to_vec(&self.own().gaussians.download(8 * pairs)?);
        let half = |word: u32| f16::from_bits(word as u16).to_f32();
        let byte = |word: u32| (word & 0xff) as f32 / 255.0;
        Ok(if lit > 0 {
            pairs[lit..]
                .iter()
                .map(|c| [half(c[0]), half(c[0] >> 16), half(c[1])])
                .collect()
        } else {
            pairs[3 * count..]
                .iter()
                .map(|c| [byte(c[1]), byte(c[1] >> 8), byte(c[1] >> 16)])
                .collect()
        })
    }
}
