//! Outputs of a frame's stages, read back to the host.

use crate::vulkan::{
    device::error::Result,
    memory::Buffer,
    passes::{model::Model, project::Project},
    sort::Sort,
};
use effigy_core::layout::Control;
use half::f16;

/// A stage's buffers read back, for tests.
pub struct Stages {
    /// The first avatar's; shape N_G, length of e.
    pub features: Vec<f32>,
    /// The first avatar's, one displacement a node, metres; the fourth number is unused.
    pub nodes: Vec<[f32; 4]>,
    /// RGB of every Gaussian before correctives; where spherical harmonics make them, of those that
    /// are drawn.
    pub colors: Vec<[f32; 3]>,
    /// Those of the avatars in view, one after the other, as `keys` are.
    pub splats: Vec<[u32; 4]>,
    /// A depth key for each Gaussian, larger is nearer.
    pub keys: Vec<u32>,
    /// Indices of the visible splats in drawing order.
    pub order: Vec<u32>,
    /// Counts and arguments that the sort wrote.
    pub control: Control,
}

/// The buffers of a renderer that hold them. Every submitted frame must be done.
pub(super) struct StageSources<'a> {
    pub model: &'a Model,
    pub pose: &'a Buffer,
    pub control: &'a Buffer,
    pub splats: &'a Project,
    pub sort: &'a Sort,
}

impl StageSources<'_> {
    /// Waits, and copies every stage's output of the last frame to the host.
    pub fn download(&self) -> Result<Stages> {
        let constants = &self.model.own().constants;
        let features = 16 * (constants.parts * constants.feature_quads) as usize;
        let nodes_end = features + 8 * constants.nodes as usize;
        let pose = self.pose.download(nodes_end)?;
        let nodes: Vec<[f16; 4]> = bytemuck::pod_collect_to_vec(&pose[features..]);
        let control: Control =
            bytemuck::pod_read_unaligned(&self.control.download(size_of::<Control>())?);
        let (splats, keys) = self.splats.download(control.key_count)?;
        Ok(Stages {
            features: bytemuck::pod_collect_to_vec(&pose[..features]),
            nodes: self
                .model
                .node_places
                .iter()
                .map(|&place| nodes[usize::from(place)].map(f16::to_f32))
                .collect(),
            colors: self.model.colors()?,
            splats,
            keys,
            order: self.sort.download(control.visible_count)?,
            control,
        })
    }
}
