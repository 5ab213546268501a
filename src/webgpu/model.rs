//! An avatar on the device: its buffers, empty at first and then filled, and the constant part of
//! the uniform block.

use super::{
    buffer::{STORAGE, empty},
    device::Gpu,
    error::Result,
    owned::Buffer,
};
use bytemuck::cast_slice;
use effigy_core::{
    avatar::Avatar,
    layout::{
        FrameBlock,
        pack::{self, ModelSizes},
    },
};

/// The model in device memory, read-only.
pub struct Model {
    /// Words; see `shaders/mlp/mlp.glsl`.
    pub networks: Buffer,
    pub nodes: Buffer,
    /// Each part's first node, and their number.
    pub node_starts: Buffer,
    /// The Gaussians in canonical pose.
    pub gaussians: Buffer,
    /// Basis rows of the correctives.
    pub rows: Buffer,
    /// The sizes that the buffers were made for.
    sizes: ModelSizes,
    /// Where each of the avatar's nodes is among those of the device, which are in the order of
    /// their parts.
    pub node_places: Vec<u16>,
    /// The uniform block with all that no frame changes.
    pub constants: Box<FrameBlock>,
    /// Whether the networks' weights are bytes.
    pub networks_in_bytes: bool,
}

impl Model {
    /// Empty buffers for an avatar. Kernels can be bound to them, and compiled, before they are
    /// filled.
    pub fn empty(gpu: &Gpu, avatar: &Avatar) -> Result<Self> {
        let sizes = ModelSizes::from_avatar(avatar);
        Ok(Self {
            networks: empty(gpu, "networks", sizes.networks, STORAGE)?,
            nodes: empty(gpu, "nodes", sizes.nodes, STORAGE)?,
            node_starts: empty(gpu, "node starts", sizes.node_starts, STORAGE)?,
            gaussians: empty(gpu, "gaussians", sizes.gaussians, STORAGE)?,
            rows: empty(gpu, "rows", sizes.rows, STORAGE)?,
            sizes,
            node_places: pack::node_places(avatar).0,
            constants: Box::new(pack::constants(avatar)),
            networks_in_bytes: avatar.networks.in_bytes(),
        })
    }

    /// Uploads an avatar; false, and nothing has changed, where its arrays have other lengths.
    pub fn fill(&mut self, gpu: &Gpu, avatar: &Avatar) -> bool {
        let constants = pack::constants(avatar);
        let shape = |of: &FrameBlock| {
            [
                of.gaussians,
                of.nodes,
                of.parts,
                of.basis_quads,
                of.feature_quads,
            ]
        };
        let same = shape(&constants) == shape(&self.constants)
            && avatar.networks.in_bytes() == self.networks_in_bytes;
        if !same || ModelSizes::from_avatar(avatar) != self.sizes {
            return false;
        }
        *self.constants = constants;
        let (places, starts) = pack::node_places(avatar);
        self.node_places = places;
        let write = |buffer: &wgpu::Buffer, data: &[u8]| gpu.queue.write_buffer(buffer, 0, data);
        write(
            &self.networks,
            cast_slice(&pack::networks(avatar, &self.constants)),
        );
        write(
            &self.nodes,
            cast_slice(&pack::nodes(avatar, &self.node_places)),
        );
        write(&self.node_starts, cast_slice(&starts));
        write(
            &self.gaussians,
            cast_slice(&pack::gaussians(avatar, &self.node_places)),
        );
        write(&self.rows, cast_slice(&pack::rows(avatar)));
        true
    }
}
