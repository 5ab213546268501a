//! What waits: the end of frames, pictures and stages' buffers, outside of browsers.

use super::{Renderer, buffer, error::Result, picture, slot::SLOTS};
use crate::{
    frame::Picture,
    layout::{Control, SORT_DROPPED},
};
use half::f16;

/// Stages' buffers read back, for tests.
pub struct Stages {
    /// The first avatar's; shape N_G, length of e.
    pub features: Vec<f32>,
    /// The first avatar's, one displacement a node, metres; the fourth number is unused.
    pub nodes: Vec<[f32; 4]>,
    /// Those of the avatars in view, one after the other, as `keys` are.
    pub splats: Vec<[u32; 4]>,
    pub keys: Vec<u32>,
    pub order: Vec<u32>,
    pub control: Control,
}

impl Renderer {
    /// Waits for every submitted frame.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn finish(&mut self) -> Result<()> {
        self.gpu.wait(None, "the last frame")?;
        for offset in 0..SLOTS {
            if let Some(report) = self.slots[(self.next + offset) % SLOTS].finish() {
                self.report = report;
            }
        }
        Ok(())
    }

    /// Waits, and copies the picture of the last frame to the host.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn picture(&mut self) -> Result<Picture> {
        self.finish()?;
        picture::download(&self.gpu, &self.raster)
    }

    /// Waits, and copies every stage's output of the last frame to the host.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn stages(&mut self) -> Result<Stages> {
        self.finish()?;
        let download = |slice| buffer::download(&self.gpu, slice);
        let constants = &self.model.constants;
        let features = 16 * (constants.parts * constants.feature_quads) as usize;
        let pose = download((&self.pose).into())?;
        let nodes: Vec<[f16; 4]> = bytemuck::pod_collect_to_vec(&pose[features..][..8 * constants.nodes as usize]);
        let control: Control = bytemuck::pod_read_unaligned(&download((&self.control).into())?[..size_of::<Control>()]);
        let count = control.entering as usize;
        let splats = download(self.splats.all())?;
        let keys: Vec<u16> = bytemuck::pod_collect_to_vec(&download(self.splats.keys())?);
        let order = download(self.sort.order())?;
        Ok(Stages {
            features: bytemuck::pod_collect_to_vec(&pose[..features]),
            nodes: self.model.node_places.iter().map(|&place| nodes[usize::from(place)].map(f16::to_f32)).collect(),
            splats: bytemuck::pod_collect_to_vec(&splats[..16 * count]),
            keys: keys[..count].iter().map(|&key| if key == u16::MAX { SORT_DROPPED } else { u32::from(key) }).collect(),
            order: bytemuck::pod_collect_to_vec(&order[..4 * control.survivors as usize]),
            control,
        })
    }
}
