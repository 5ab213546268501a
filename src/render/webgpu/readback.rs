//! Functions that wait for the device, for programs outside of browsers: they finish frames, and
//! read back images and the stages' buffers.

use super::shared::SharedStages;
use super::{
    buffer, download, error::Result, frame_in_flight::FRAMES_IN_FLIGHT, renderer::Renderer,
};
use effigy_core::{
    frame::AvatarId,
    layout::{BinLists, Control},
    scene::FrameImage,
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
    /// A depth key for each Gaussian, larger is nearer.
    pub keys: Vec<u32>,
    /// Indices of the visible splats in drawing order.
    pub order: Vec<u32>,
    /// Counts and arguments that the sort wrote.
    pub control: Control,
}

impl Renderer {
    /// Waits for every submitted frame.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn finish(&mut self) -> Result<()> {
        self.gpu.wait(None, "the last frame")?;
        for offset in 0..FRAMES_IN_FLIGHT {
            if let Some(report) =
                self.frames_in_flight[(self.next + offset) % FRAMES_IN_FLIGHT].finish()
            {
                self.report = report;
            }
        }
        Ok(())
    }

    /// Waits, and copies the image of the last frame to the host.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn read_image(&mut self) -> Result<FrameImage> {
        self.finish()?;
        download::read_image(&self.gpu, &self.shared.raster)
    }

    /// Waits, and copies the saturation depth of each sample of the last frame and the colour there
    /// to the host, row by row: words of `shaders/common/saturation.glsl`. None where quads are not
    /// tested against it.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn saturation_samples(&mut self) -> Result<Option<Vec<u32>>> {
        self.finish()?;
        let read = |samples| download::texels(&self.gpu, samples, 4);
        let bytes = self.shared.raster.samples().map(read).transpose()?;
        Ok(bytes.map(|bytes| bytemuck::pod_collect_to_vec(&bytes)))
    }

    /// Waits, and copies the lists of bins of the last frame to the host. None where there are
    /// none.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn bin_lists(&mut self) -> Result<Option<BinLists>> {
        self.finish()?;
        self.shared.raster.bin_lists(&self.gpu)
    }

    /// Waits, and copies every stage's output of the last frame to the host.
    ///
    /// # Errors
    /// When the device is lost or hangs.
    pub fn stages(&mut self) -> Result<Stages> {
        self.finish()?;
        let download = |slice| buffer::download(&self.gpu, slice);
        let held = self.avatars.get(AvatarId::FIRST);
        let model = &held
            .expect("tests keep the avatar that it was made with")
            .model;
        let SharedStages {
            splats,
            sort,
            pose,
            control,
            ..
        } = &self.shared;
        let constants = model.constants(0);
        let features = 16 * (constants.parts * constants.feature_quads) as usize;
        let pose = download(pose.into())?;
        let nodes: Vec<[f16; 4]> =
            bytemuck::pod_collect_to_vec(&pose[features..][..8 * constants.nodes as usize]);
        let control: Control =
            bytemuck::pod_read_unaligned(&download(control.into())?[..size_of::<Control>()]);
        let count = control.key_count as usize;
        let keys = download(splats.keys())?;
        let splats = download(splats.all())?;
        let order = download(sort.order())?;
        Ok(Stages {
            features: bytemuck::pod_collect_to_vec(&pose[..features]),
            nodes: model
                .node_places
                .iter()
                .map(|&place| nodes[usize::from(place)].map(f16::to_f32))
                .collect(),
            splats: bytemuck::pod_collect_to_vec(&splats[..16 * count]),
            keys: bytemuck::pod_collect_to_vec(&keys[..4 * count]),
            order: bytemuck::pod_collect_to_vec(&order[..4 * control.visible_count as usize]),
            control,
        })
    }
}
