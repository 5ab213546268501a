//! How far a posed avatar reaches, from boxes around what each joint moves: bounds that cost a few hundred points a frame, not one a Gaussian.

use super::Camera;
use crate::avatar::Avatar;
use glam::{DAffine3, DVec3};

/// Room for position correctives and for the Gaussians' own size, metres.
const MARGIN: f64 = 0.05;

/// For each joint, the box in canonical space around the Gaussians that it moves.
///
/// A skinned point is a weighted mean of G_j x over the joints that move it, so it lies within the hull of the moved boxes.
#[derive(Clone, Debug)]
pub struct Extent {
    boxes: Vec<Option<[DVec3; 2]>>,
}

impl Extent {
    pub fn new(avatar: &Avatar) -> Self {
        let mut boxes: Vec<Option<[DVec3; 2]>> = vec![None; avatar.skeleton.len()];
        for (i, (joints, weights)) in avatar.gaussians.joint.iter().zip(&avatar.gaussians.joint_weight).enumerate() {
            let position = avatar.position(i);
            for (&joint, _) in joints.iter().zip(weights).filter(|(_, weight)| **weight > 0) {
                let [min, max] = boxes[joint as usize].get_or_insert([position; 2]);
                *min = min.min(position);
                *max = max.max(position);
            }
        }
        Self { boxes }
    }

    fn corners<'a>(&'a self, joints: &'a [DAffine3]) -> impl Iterator<Item = DVec3> + 'a {
        self.boxes.iter().zip(joints).filter_map(|(bounds, joint)| bounds.map(|bounds| (bounds, joint))).flat_map(|(bounds, joint)| {
            (0..8).map(move |corner: usize| {
                let corner = DVec3::new(bounds[corner & 1].x, bounds[corner >> 1 & 1].y, bounds[corner >> 2].z);
                joint.transform_point3(corner)
            })
        })
    }

    /// Lower and upper corner of a box around the posed avatar, in the space the joint matrices lead to.
    pub fn bounds(&self, joints: &[DAffine3]) -> [DVec3; 2] {
        let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [min, max] = self.corners(joints).fold(none, |[min, max], corner| [min.min(corner), max.max(corner)]);
        if min.cmple(max).all() { [min - MARGIN, max + MARGIN] } else { [DVec3::ZERO; 2] }
    }

    /// Nearest and furthest distance along the camera's axis, from the near plane on; the first is always below the second.
    pub fn depth(&self, joints: &[DAffine3], camera: &Camera) -> [f64; 2] {
        let view: Vec<DAffine3> = joints.iter().map(|joint| camera.view * *joint).collect();
        let [min, max] = self.bounds(&view);
        let near = min.z.max(camera.near);
        [near, max.z.max(near + 1e-3)]
    }
}
