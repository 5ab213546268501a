//! The space that the pose cache is stored in: that of the camera that filled it, within a box
//! around the posed avatar.

use super::block::matrix_rows;
use crate::layout::FrameBlock;
use crate::scene::{AvatarBounds, Camera, Posed, avatar_bounds::enlargement};
use glam::{DAffine3, DVec3, Vec4};

/// How one avatar's pose cache was stored, which is what frames need to read it.
#[derive(Clone, Copy, Debug)]
pub struct PoseCache {
    /// World to the camera that filled the cache.
    pub view: DAffine3,
    /// Lower and upper corner of a box around the posed avatar, or around most of a scene, in that
    /// camera's space, metres.
    pub bounds: [DVec3; 2],
    /// Length that stored lengths are relative to.
    pub unit: f64,
}

impl Default for PoseCache {
    /// A cache that holds nothing yet.
    fn default() -> Self {
        Self {
            view: DAffine3::IDENTITY,
            bounds: [DVec3::ZERO, DVec3::ONE],
            unit: 1.0,
        }
    }
}

impl PoseCache {
    /// The space for a frame that fills the cache.
    pub fn new(bounds: &AvatarBounds, posed: &Posed, camera: &Camera) -> Self {
        let joints: Vec<DAffine3> = posed
            .joints
            .iter()
            .map(|joint| camera.view * *joint)
            .collect();
        let unit = enlargement(&joints);
        Self {
            view: camera.view,
            bounds: bounds.dense(&joints),
            unit: if unit > 0.0 { unit } else { 1.0 },
        }
    }

    /// Writes to a frame's block how to read the cache for a camera.
    pub fn write_to(&self, block: &mut FrameBlock, camera: &Camera) {
        let [min, max] = self.bounds.map(|corner| corner.as_vec3().extend(0.0));
        block.cache_min = min.to_array();
        block.cache_size = (max - min).max(Vec4::splat(f32::MIN_POSITIVE)).to_array();
        block.cache_unit = self.unit as f32;
        block.camera_from_cache = matrix_rows(camera.view * self.view.inverse());
    }
}
