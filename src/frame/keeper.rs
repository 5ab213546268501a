//! The space in which `splats` keeps what no camera changes: that of the camera that saw it, within a box around the posed avatar.

use super::{Camera, Extent, Posed, block::matrix_rows, extent::enlargement};
use crate::layout::Frame;
use glam::{DAffine3, DVec3};

/// What is needed to read what a frame kept.
pub struct Keeper {
    view: DAffine3,
    /// In that camera's space.
    bounds: [DVec3; 2],
    unit: f64,
}

impl Default for Keeper {
    /// Of nothing.
    fn default() -> Self {
        Self { view: DAffine3::IDENTITY, bounds: [DVec3::ZERO, DVec3::ONE], unit: 1.0 }
    }
}

impl Keeper {
    /// For a frame that keeps.
    pub fn new(extent: &Extent, posed: &Posed, camera: &Camera) -> Self {
        let seen: Vec<DAffine3> = posed.joints.iter().map(|joint| camera.view * *joint).collect();
        let unit = enlargement(&seen);
        Self { view: camera.view, bounds: extent.bounds(&seen), unit: if unit > 0.0 { unit } else { 1.0 } }
    }

    /// Writes to a frame's block how to read what was kept, as another camera sees it.
    pub fn fill(&self, block: &mut Frame, camera: &Camera) {
        let [min, max] = self.bounds.map(|corner| corner.as_vec3().extend(0.0));
        block.posed_min = min.to_array();
        block.posed_size = (max - min).max(glam::Vec4::splat(f32::MIN_POSITIVE)).to_array();
        block.posed_unit = self.unit as f32;
        block.turn = matrix_rows(camera.view * self.view.inverse());
    }
}
