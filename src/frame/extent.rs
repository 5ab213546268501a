//! How far a posed avatar reaches, from boxes around its parts: bounds that cost some thousand points a frame, not one a Gaussian.

use super::{Camera, reach};
use crate::avatar::Avatar;
use glam::{DAffine3, DVec2, DVec3, UVec2};

/// Room for position correctives, for the Gaussians' own size, and for the joints that count too little to be looked at; metres before
/// the joints move, which may scale them.
const MARGIN: f64 = 0.05;
/// Joints that move no Gaussian of a part by at least this weight (of 255) are left out: they could only widen the bounds.
const WEIGHT: u8 = 8;
/// What scale correctives may add to a Gaussian's size: a half.
const GROWTH: f64 = 1.5;

/// A part's box in canonical space, and the joints that move it.
#[derive(Clone, Debug)]
struct PartBox {
    min: DVec3,
    max: DVec3,
    joints: Vec<u8>,
    /// How far its Gaussians reach from their centres, metres.
    reach: f64,
}

/// The boxes of all parts.
///
/// A skinned point is a weighted mean of G_j x over the joints that move it, so it lies within the hull of its part's box moved by each.
#[derive(Clone, Debug)]
pub struct Extent {
    parts: Vec<PartBox>,
}

impl Extent {
    pub fn new(avatar: &Avatar) -> Self {
        let ranges = avatar.parts.start.windows(2).map(|pair| pair[0] as usize..pair[1] as usize);
        let parts = ranges.filter(|range| !range.is_empty()).map(|range| {
            let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            let mut weight = [0u8; 256];
            let mut reaches = 0f64;
            for gaussian in range {
                let position = avatar.position(gaussian);
                (min, max) = (min.min(position), max.max(position));
                let longest = avatar.gaussians.log_scale[gaussian].iter().map(|s| s.to_f64()).fold(f64::NEG_INFINITY, f64::max);
                reaches = reaches.max(reach(avatar.gaussians.opacity[gaussian]).unwrap_or(0.0) * longest.exp());
                for (&joint, &w) in avatar.gaussians.joint[gaussian].iter().zip(&avatar.gaussians.joint_weight[gaussian]) {
                    weight[joint as usize] = weight[joint as usize].max(w);
                }
            }
            let joints = (0..=255).filter(|&joint| weight[joint as usize] >= WEIGHT).collect();
            PartBox { min, max, joints, reach: GROWTH * reaches }
        });
        Self { parts: parts.collect() }
    }

    /// How many joint matrices a pose must have.
    pub fn joints(&self) -> usize {
        self.parts.iter().flat_map(|part| &part.joints).max().map_or(0, |&joint| usize::from(joint) + 1)
    }

    fn corners<'a>(&'a self, joints: &'a [DAffine3]) -> impl Iterator<Item = DVec3> + 'a {
        self.parts.iter().flat_map(|part| part.corners(joints))
    }

    /// Whether anything of the posed avatar may be in the picture.
    pub fn in_view(&self, joints: &[DAffine3], camera: &Camera) -> bool {
        let stretch = stretch(joints) * camera.view.matrix3.transpose().z_axis.length();
        self.parts.iter().any(|part| part.in_view(joints, camera, stretch * (MARGIN + part.reach)))
    }

    /// Lower and upper corner of a box around the posed avatar, in the space the joint matrices lead to.
    pub fn bounds(&self, joints: &[DAffine3]) -> [DVec3; 2] {
        let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [min, max] = self.corners(joints).fold(none, |[min, max], corner| [min.min(corner), max.max(corner)]);
        let margin = margin(joints);
        if min.cmple(max).all() { [min - margin, max + margin] } else { [DVec3::ZERO; 2] }
    }

    /// Lower and upper corner of a box in the picture outside which nothing of the avatar is drawn, px. Empty where it is all outside.
    pub fn screen(&self, joints: &[DAffine3], camera: &Camera) -> [UVec2; 2] {
        let size = UVec2::from(camera.size).as_dvec2();
        let (mut min, mut max) = (size, DVec2::ZERO);
        for corner in self.corners(joints) {
            let p = camera.view.transform_point3(corner);
            if p.z - MARGIN < camera.near {
                return [UVec2::ZERO, camera.size.into()];
            }
            let room = MARGIN * camera.focal / (p.z - MARGIN) * (1.0 + (p.truncate() / p.z).abs()) + 2.0;
            let at = camera.project(p);
            (min, max) = (min.min(at - room), max.max(at + room));
        }
        let clamp = |at: DVec2| at.clamp(DVec2::ZERO, size).as_uvec2();
        let [min, max] = [clamp(min.floor()), clamp(max.ceil())];
        [min.min(max), max]
    }

    /// Nearest and furthest distance along the camera's axis, from the near plane on; the first is always below the second.
    pub fn depth(&self, joints: &[DAffine3], camera: &Camera) -> [f64; 2] {
        let axis = camera.view.matrix3.transpose().z_axis;
        let along = |point: DVec3| axis.dot(point) + camera.view.translation.z;
        let (min, max) = self.corners(joints).map(along).fold((f64::INFINITY, f64::NEG_INFINITY), |(min, max), z| (min.min(z), max.max(z)));
        let margin = margin(joints) * axis.length();
        let near = if min.is_finite() { (min - margin).max(camera.near) } else { camera.near };
        // At least a hundredth of the margin deep, and more than f32 can tell.
        [near, (max + margin).max(near + 0.02 * margin).max(near * (1.0 + 1e-6))]
    }
}

impl PartBox {
    fn corners<'a>(&'a self, joints: &'a [DAffine3]) -> impl Iterator<Item = DVec3> + 'a {
        let corner = |k: usize| {
            let choose = |axis: usize| if k >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
            DVec3::new(choose(0), choose(1), choose(2))
        };
        let corners: [DVec3; 8] = std::array::from_fn(corner);
        self.joints.iter().flat_map(move |&joint| corners.map(|corner| joints[joint as usize].transform_point3(corner)))
    }

    /// Whether a ball of radius `room`, metres, around any point between the corners may be in the picture.
    fn in_view(&self, joints: &[DAffine3], camera: &Camera, room: f64) -> bool {
        let seen = || self.corners(joints).map(|corner| camera.view.transform_point3(corner));
        let [near, far] = seen().fold([f64::INFINITY, f64::NEG_INFINITY], |[near, far], p| [near.min(p.z), far.max(p.z)]);
        if far + room < camera.near {
            return false;
        }
        if near - room < camera.near {
            return true;
        }
        let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for p in seen() {
            // Two pixels more than the low-pass adds.
            let around = room * camera.focal / (p.z - room) * (1.0 + (p.truncate() / p.z).abs()) + 4.0;
            let at = camera.project(p);
            (min, max) = (min.min(at - around), max.max(at + around));
        }
        max.cmpgt(DVec2::ZERO).all() && min.cmplt(UVec2::from(camera.size).as_dvec2()).all()
    }
}

/// The most that any joint stretches a length.
fn stretch(joints: &[DAffine3]) -> f64 {
    let columns = joints.iter().flat_map(|joint| [joint.matrix3.x_axis, joint.matrix3.y_axis, joint.matrix3.z_axis]);
    columns.map(|column| column.length_squared()).fold(0.0, f64::max).sqrt()
}

/// [`MARGIN`] where the joints have moved it.
fn margin(joints: &[DAffine3]) -> f64 {
    MARGIN * stretch(joints)
}
