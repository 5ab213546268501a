//! An avatar on the device: its buffers, empty at first and then filled, and the constant part of
//! the uniform blocks.

use super::{
    buffer::{STORAGE, empty},
    device::Gpu,
    error::Result,
    owned::Buffer,
    stacked::Stacked,
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
    /// The Gaussians in canonical pose: the avatar's own, then those of its levels.
    pub gaussians: Stacked,
    /// Basis rows of their correctives.
    pub rows: Stacked,
    /// The sizes that the buffers were made for: the avatar's, then its levels'.
    sizes: Vec<ModelSizes>,
    /// Where each of the avatar's nodes is among those of the device, which are in the order of
    /// their parts.
    pub node_places: Vec<u16>,
    /// The uniform blocks with all that no frame changes: the avatar's, then its levels'.
    constants: Vec<Box<FrameBlock>>,
    /// Whether the networks' weights are bytes.
    pub networks_in_bytes: bool,
}

/// An avatar's levels, as the avatars that they are drawn as.
pub fn levels(avatar: &Avatar) -> Vec<Avatar> {
    let levels = avatar.levels.iter();
    levels.map(|level| avatar.at_level(level)).collect()
}

impl Model {
    /// Empty buffers for an avatar. Kernels can be bound to them, and compiled, before they are
    /// filled.
    pub fn empty(gpu: &Gpu, avatar: &Avatar, levels: &[Avatar]) -> Result<Self> {
        let all = || std::iter::once(avatar).chain(levels);
        let sizes: Vec<_> = all().map(ModelSizes::from_avatar).collect();
        let own = sizes[0];
        let [gaussians, rows] = stacks(gpu, &sizes)?;
        Ok(Self {
            networks: empty(gpu, "networks", own.networks, STORAGE)?,
            nodes: empty(gpu, "nodes", own.nodes, STORAGE)?,
            node_starts: empty(gpu, "node starts", own.node_starts, STORAGE)?,
            gaussians,
            rows,
            sizes,
            node_places: pack::node_places(avatar).0,
            constants: all().map(|set| Box::new(pack::constants(set))).collect(),
            networks_in_bytes: avatar.networks.in_bytes(),
        })
    }

    /// Sets of Gaussians: the avatar's own and its levels'.
    pub fn sets(&self) -> usize {
        self.sizes.len()
    }

    /// The uniform block with all that no frame changes, of a set; 0 is the avatar's own.
    pub fn constants(&self, set: usize) -> &FrameBlock {
        &self.constants[set]
    }

    /// Whether an avatar's arrays have the lengths of the one that this was made for, its levels
    /// aside.
    pub fn fits(&self, avatar: &Avatar) -> bool {
        let shape = |of: &FrameBlock| {
            [
                of.gaussians,
                of.nodes,
                of.parts,
                of.basis_quads,
                of.feature_quads,
            ]
        };
        shape(&pack::constants(avatar)) == shape(self.constants(0))
            && avatar.networks.in_bytes() == self.networks_in_bytes
            && ModelSizes::from_avatar(avatar) == self.sizes[0]
    }

    /// Whether levels' arrays have the lengths of those that this was made for.
    pub fn fits_levels(&self, levels: &[Avatar]) -> bool {
        let sizes = levels.iter().map(ModelSizes::from_avatar);
        sizes.eq(self.sizes[1..].iter().copied())
    }

    /// Makes room for these levels in place of those before, and keeps the avatar's own Gaussians.
    /// Whatever is bound to [`Self::gaussians`] and [`Self::rows`] must be bound again. A device
    /// that has no memory for them says so with [`Gpu::check`]: then nothing more can be drawn with
    /// this.
    pub fn make_room(&mut self, gpu: &Gpu, levels: &[Avatar]) -> Result<()> {
        let own = self.sizes[0];
        let mut sizes = vec![own];
        sizes.extend(levels.iter().map(ModelSizes::from_avatar));
        let [gaussians, rows] = stacks(gpu, &sizes)?;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        gaussians.copy_first(&mut encoder, &self.gaussians, own.gaussians);
        rows.copy_first(&mut encoder, &self.rows, own.rows);
        gpu.queue.submit([encoder.finish()]);
        self.gaussians = gaussians;
        self.rows = rows;
        self.sizes = sizes;
        self.constants.truncate(1);
        for level in levels {
            self.constants.push(Box::new(pack::constants(level)));
        }
        Ok(())
    }

    /// Uploads an avatar that fits, without its levels.
    pub fn fill(&mut self, gpu: &Gpu, avatar: &Avatar) {
        *self.constants[0] = pack::constants(avatar);
        let (places, starts) = pack::node_places(avatar);
        self.node_places = places;
        let write = |buffer: &wgpu::Buffer, data: &[u8]| gpu.queue.write_buffer(buffer, 0, data);
        write(
            &self.networks,
            cast_slice(&pack::networks(avatar, &self.constants[0])),
        );
        write(
            &self.nodes,
            cast_slice(&pack::nodes(avatar, &self.node_places)),
        );
        write(&self.node_starts, cast_slice(&starts));
        self.write_set(gpu, 0, avatar, &self.node_places);
    }

    /// Uploads levels that fit, of the avatar that was uploaded.
    pub fn fill_levels(&mut self, gpu: &Gpu, avatar: &Avatar, levels: &[Avatar]) {
        for (index, (level, drawn)) in avatar.levels.iter().zip(levels).enumerate() {
            *self.constants[index + 1] = pack::constants(drawn);
            // Without correctives there is one node, which stays in its place.
            let places: &[u16] = if level.correctives {
                &self.node_places
            } else {
                &[0]
            };
            self.write_set(gpu, index + 1, drawn, places);
        }
    }

    fn write_set(&self, gpu: &Gpu, set: usize, avatar: &Avatar, node_places: &[u16]) {
        let gaussians = pack::gaussians(avatar, node_places);
        self.gaussians.write(gpu, set, cast_slice(&gaussians));
        self.rows.write(gpu, set, cast_slice(&pack::rows(avatar)));
    }
}

/// Room for Gaussians, and for rows, of sets of these sizes.
fn stacks(gpu: &Gpu, sizes: &[ModelSizes]) -> Result<[Stacked; 2]> {
    let stack = |name, size: fn(&ModelSizes) -> u64| {
        let sizes: Vec<u64> = sizes.iter().map(size).collect();
        Stacked::empty(gpu, name, &sizes)
    };
    Ok([
        stack("gaussians", |sizes| sizes.gaussians)?,
        stack("rows", |sizes| sizes.rows)?,
    ])
}
