//! Outputs of a frame's stages, read back to the host.

use super::shared::SharedStages;
use crate::vulkan::{device::error::Result, passes::model::Model};
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

/// Copies every stage's output of the last frame to the host. Every submitted frame must be done.
/// `model`: of the avatar that the renderer was made with.
pub(super) fn download(model: &Model, shared: &SharedStages) -> Result<Stages> {
    let constants = &model.own().constants;
    let features = 16 * (constants.parts * constants.feature_quads) as usize;
    let nodes_end = features + 8 * constants.nodes as usize;
    let pose = shared.pose.download(nodes_end)?;
    let nodes: Vec<[f16; 4]> = bytemuck::pod_collect_to_vec(&pose[features..]);
    let control: Control =
        bytemuck::pod_read_unaligned(&shared.control.download(size_of::<Control>())?);
    let (splats, keys) = shared.splats.download(control.key_count)?;
    Ok(Stages {
        features: bytemuck::pod_collect_to_vec(&pose[..features]),
        nodes: model
            .node_places
            .iter()
            .map(|&place| nodes[usize::from(place)].map(f16::to_f32))
            .collect(),
        colors: model.colors()?,
        splats,
        keys,
        order: shared.sort.download(control.visible_count)?,
        control,
    })
}
