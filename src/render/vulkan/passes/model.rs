//! An avatar on the device: an [`Avatar`] goes in, its buffers and the constant part of the uniform
//! block come out.

use super::coefficients::Coefficients;
use crate::vulkan::{
    device::{error::Result, gpu::Gpu},
    memory::{Buffer, Upload, upload_all},
};
use ash::vk;
use bytemuck::cast_slice;
use effigy_core::{
    avatar::Avatar,
    layout::{FrameBlock, GAUSSIAN_PAIRS, PackedModel, PackedSet},
};
use half::f16;
use std::sync::Arc;

/// Gaussians in device memory.
pub struct GaussianSet {
    /// In canonical pose.
    pub gaussians: Buffer,
    /// Basis rows of their correctives.
    pub rows: Buffer,
    /// Of their spherical harmonics; None without.
    pub coefficients: Option<Coefficients>,
    /// The uniform block with all that no frame changes.
    pub constants: Box<FrameBlock>,
}

impl GaussianSet {
    fn new(gpu: &Arc<Gpu>, packed: &PackedSet, coefficients: Option<Coefficients>) -> Result<Self> {
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER;
        Ok(Self {
            gaussians: Buffer::with_data(
                gpu,
                "gaussians",
                cast_slice(&packed.gaussians),
                storage | vk::BufferUsageFlags::TRANSFER_SRC,
            )?,
            rows: Buffer::with_data(gpu, "rows", cast_slice(&packed.rows), storage)?,
            coefficients,
            constants: packed.constants.clone(),
        })
    }

    fn uploads<'a>(&'a self, packed: &'a PackedSet) -> [Upload<'a>; 2] {
        [
            Upload {
                to: &self.gaussians,
                data: cast_slice(&packed.gaussians),
            },
            Upload {
                to: &self.rows,
                data: cast_slice(&packed.rows),
            },
        ]
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
    /// Whether the networks' weights are bytes.
    pub networks_in_bytes: bool,
}

impl Model {
    /// Uploads an avatar.
    pub(crate) fn new(gpu: &Arc<Gpu>, avatar: &Avatar, packed: &PackedModel) -> Result<Self> {
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER;
        let buffer = |name, words: &[u32]| Buffer::with_data(gpu, name, cast_slice(words), storage);
        let [own, levels @ ..] = &packed.sets[..] else {
            unreachable!("an avatar is a set of its own");
        };
        let mut sets = vec![GaussianSet::new(gpu, own, Coefficients::new(gpu, avatar)?)?];
        for (level, set) in avatar.levels.iter().zip(levels) {
            // A level as an avatar is a copy, which only harmonics need.
            let coefficients = match avatar.sh {
                Some(_) => Coefficients::new(gpu, &avatar.at_level(level))?,
                None => None,
            };
            sets.push(GaussianSet::new(gpu, set, coefficients)?);
        }
        Ok(Self {
            networks: buffer("networks", &packed.networks)?,
            nodes: buffer("nodes", &packed.nodes)?,
            node_starts: buffer("node starts", &packed.node_starts)?,
            sets,
            node_places: packed.node_places.clone(),
            networks_in_bytes: avatar.networks.in_bytes(),
        })
    }

    /// Fills the buffers with another avatar. False, and nothing has changed, where its arrays have
    /// other lengths; nor on an error that is not the device's loss. No submitted work may use
    /// them.
    pub(crate) fn replace(
        &mut self,
        gpu: &Arc<Gpu>,
        avatar: &Avatar,
        packed: &PackedModel,
    ) -> Result<bool> {
        let upload = |to, words| Upload {
            to,
            data: cast_slice(words),
        };
        let mut uploads = vec![
            upload(&self.networks, &packed.networks),
            upload(&self.nodes, &packed.nodes),
            upload(&self.node_starts, &packed.node_starts),
        ];
        for (set, packed) in self.sets.iter().zip(&packed.sets) {
            uploads.extend(set.uploads(packed));
        }
        let fits = self.networks_in_bytes == avatar.networks.in_bytes()
            && self.sets.len() == packed.sets.len()
            && uploads.iter().all(Upload::fills);
        if !fits {
            return Ok(false);
        }
        upload_all(gpu, &uploads)?;
        for (set, packed) in self.sets.iter_mut().zip(&packed.sets) {
            set.constants.clone_from(&packed.constants);
        }
        self.node_places.clone_from(&packed.node_places);
        Ok(true)
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
