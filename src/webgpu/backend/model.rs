//! An avatar on the device: an [`Avatar`] goes in, its buffers and the constant part of the uniform block come out.

use super::{
    buffer::{STORAGE, filled},
    device::Gpu,
    error::Result,
    owned::Buffer,
};
use crate::{
    avatar::{Avatar, Occluder},
    layout::{Frame, pack},
};
use bytemuck::cast_slice;
use wgpu::BufferUsages;

/// The avatar's solid inside; see `shaders/surface.vert`.
pub struct OccluderMesh {
    pub corners: Buffer,
    pub indices: Buffer,
    /// Three a triangle.
    pub index_count: u32,
    /// Corners and triangles.
    pub size: [u64; 2],
}

/// The model in device memory, read-only.
pub struct Model {
    /// Words; see `shaders/features.glsl`.
    pub networks: Buffer,
    pub nodes: Buffer,
    /// Each part's first node, and their number.
    pub node_starts: Buffer,
    /// Where each of the avatar's nodes is among those of the device, which are in the order of their parts.
    #[cfg(not(target_arch = "wasm32"))]
    pub node_places: Vec<u16>,
    pub gaussians: Buffer,
    pub rows: Buffer,
    pub occluder: OccluderMesh,
    /// The uniform block with all that no frame changes.
    pub constants: Box<Frame>,
    /// Whether the networks' weights are bytes.
    pub networks_in_bytes: bool,
}

impl Model {
    /// `occluder`: whether frames will ask for what no one can see.
    pub fn new(gpu: &Gpu, avatar: &Avatar, occluder: bool) -> Result<Self> {
        let mut constants = Box::new(pack::constants(avatar));
        let networks = pack::networks(avatar, &mut constants);
        let rows = pack::rows(avatar, &mut constants);
        let (node_places, node_starts) = pack::node_places(avatar);
        let gaussians = pack::gaussians(avatar, &node_places);
        let occluder = if occluder { Occluder::new(avatar) } else { Occluder::default() };
        let (corners, indices) = pack::occluder(avatar, &occluder, &node_places);
        Ok(Self {
            networks: filled(gpu, "networks", cast_slice(&networks), STORAGE)?,
            nodes: filled(gpu, "nodes", cast_slice(&pack::nodes(avatar, &node_places)), STORAGE)?,
            node_starts: filled(gpu, "node starts", cast_slice(&node_starts), STORAGE)?,
            gaussians: filled(gpu, "gaussians", cast_slice(&gaussians), STORAGE)?,
            rows: filled(gpu, "rows", cast_slice(&rows), STORAGE)?,
            occluder: OccluderMesh {
                corners: filled(gpu, "surface corners", cast_slice(&corners), STORAGE)?,
                indices: filled(gpu, "surface indices", cast_slice(&indices), BufferUsages::INDEX)?,
                index_count: 3 * indices.len() as u32,
                size: [corners.len() as u64, indices.len() as u64],
            },
            #[cfg(not(target_arch = "wasm32"))]
            node_places,
            constants,
            networks_in_bytes: avatar.networks.in_bytes(),
        })
    }
}
