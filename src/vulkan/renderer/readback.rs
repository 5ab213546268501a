//! What a renderer has drawn, brought to the host.

use super::Renderer;
use crate::{
    frame::Picture,
    layout::Control,
    vulkan::{
        error::Result,
        picture::{self, Copied},
    },
};
use half::f16;

/// A stage's buffers read back, for tests.
pub struct Stages {
    /// The first avatar's; shape N_G, length of e.
    pub features: Vec<f32>,
    /// The first avatar's, one displacement a node, metres; the fourth number is unused.
    pub nodes: Vec<[f32; 4]>,
    /// RGB of every Gaussian before correctives; where harmonics make them, of those that are drawn.
    pub colors: Vec<[f32; 3]>,
    /// Those of the avatars in view, one after the other, as `keys` are.
    pub splats: Vec<[u32; 4]>,
    pub keys: Vec<u32>,
    pub order: Vec<u32>,
    pub control: Control,
}

impl Renderer {
    /// Waits, and copies the picture of the last frame to the host.
    pub fn picture(&mut self) -> Result<Picture> {
        Ok(self.copy()?.decode())
    }

    /// The same without the work of decoding it.
    pub fn copy(&mut self) -> Result<Copied> {
        self.finish()?;
        picture::download(&self.gpu, &self.raster)
    }

    /// Waits, and copies every stage's output of the last frame to the host.
    pub fn stages(&mut self) -> Result<Stages> {
        self.finish()?;
        let constants = &self.model.constants;
        let features = 16 * (constants.parts * constants.feature_quads) as usize;
        let pose = self.pose.download(features + 8 * constants.nodes as usize)?;
        let nodes: Vec<[f16; 4]> = bytemuck::pod_collect_to_vec(&pose[features..]);
        let control: Control = bytemuck::pod_read_unaligned(&self.control.download(size_of::<Control>())?);
        let (splats, keys) = self.splats.download(control.entering)?;
        Ok(Stages {
            features: bytemuck::pod_collect_to_vec(&pose[..features]),
            nodes: self.model.node_places.iter().map(|&place| nodes[usize::from(place)].map(f16::to_f32)).collect(),
            colors: self.model.colors()?,
            splats,
            keys,
            order: self.sort.download(control.survivors)?,
            control,
        })
    }
}
