//! How far a posed avatar reaches, from boxes around its parts: bounds that cost some thousand points a frame, not one a Gaussian.

use super::{Camera, LOG_SCALE_MAX, PartSet, detail};
use crate::avatar::Avatar;
use glam::{DAffine3, DVec2, DVec3, UVec2};

/// Room for what a pose moves nodes by, and in bounds for the Gaussians' own size; metres before the joints move, which may scale them.
const MARGIN: f64 = 0.05;
/// Room around what is in view, where the picture is drawn: several times what learned correctives move nodes by (the demo's by 5 cm in its own
/// clip, by 11 where every input is at its furthest), and so for their Gaussians' size. What a model's correctives move further is cut off.
const AREA_MARGIN: f64 = 0.15;
/// Joints that move no Gaussian of a part by at least this weight (of 255) do not count for how far an avatar reaches: they would mostly
/// widen it. For what is left out as outside the picture they do.
const WEIGHT: u8 = 8;

/// A part's box in canonical space, and the joints that move it.
#[derive(Clone, Debug)]
struct PartBox {
    part: usize,
    /// How far its Gaussians reach around their centres, metres: where they are an opaque one's least visible, with room for correctives
    /// and levels of detail.
    reach: f64,
    min: DVec3,
    max: DVec3,
    /// The longest displacement of the part's nodes in every pose, metres.
    displaced: f64,
    /// All that move it, those of some weight first.
    joints: Vec<u8>,
    /// How many of them are of some weight.
    weighty: usize,
}

/// What of an avatar may be in a picture.
#[derive(Clone, Debug)]
pub struct Visible {
    pub parts: PartSet,
    /// Lower and upper corner of a box around them in the picture, px, with more room than it takes to see them; [`NOWHERE`] where there are
    /// none.
    pub area: [UVec2; 2],
}

/// The box that is around nothing.
pub const NOWHERE: [UVec2; 2] = [UVec2::MAX, UVec2::ZERO];

/// The box around two.
pub fn around([low, high]: [UVec2; 2], [min, max]: [UVec2; 2]) -> [UVec2; 2] {
    [low.min(min), high.max(max)]
}

/// The boxes of all parts.
///
/// A skinned point is a weighted mean of G_j x over the joints that move it, so it lies within the hull of its part's box moved by each.
#[derive(Clone, Debug)]
pub struct Extent {
    parts: Vec<PartBox>,
    /// Of a pose: joints, inputs of the networks, and those of them that are the expression.
    pose: [usize; 3],
    gaussians: usize,
}

impl Extent {
    pub fn new(avatar: &Avatar) -> Self {
        let offset = |node: u16| DVec3::from(avatar.nodes.offset[usize::from(node)].map(f64::from)).length();
        let ranges = avatar.parts.start.windows(2).map(|pair| pair[0] as usize..pair[1] as usize);
        let parts = ranges.enumerate().filter(|(_, range)| !range.is_empty()).map(|(part, range)| {
            let scales = avatar.gaussians.log_scale[range.clone()].iter().flatten();
            let longest = scales.map(|s| s.to_f64()).fold(f64::NEG_INFINITY, f64::max).min(LOG_SCALE_MAX).exp();
            let reach = 1.2 * detail::spread(detail::COARSEST).sqrt() * longest * super::reach(255).unwrap_or_default();
            let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            let mut weight = [0u8; 256];
            let mut displaced = 0.0f64;
            for gaussian in range {
                let position = avatar.position(gaussian);
                (min, max) = (min.min(position), max.max(position));
                displaced = avatar.gaussians.node[gaussian].iter().map(|&node| offset(node)).fold(displaced, f64::max);
                for (&joint, &w) in avatar.gaussians.joint[gaussian].iter().zip(&avatar.gaussians.joint_weight[gaussian]) {
                    weight[joint as usize] = weight[joint as usize].max(w);
                }
            }
            let mut joints: Vec<u8> = (0..=255).filter(|&joint| weight[usize::from(joint)] > 0).collect();
            joints.sort_by_key(|&joint| weight[usize::from(joint)] < WEIGHT);
            let weighty = joints.iter().filter(|&&joint| weight[usize::from(joint)] >= WEIGHT).count();
            PartBox { part, reach, min, max, displaced, joints, weighty }
        });
        let inputs = 3 * avatar.inputs.joint.len() + avatar.inputs.expression;
        Self { parts: parts.collect(), pose: [avatar.skeleton.len(), inputs, avatar.inputs.expression], gaussians: avatar.gaussians.len() }
    }

    /// Of a pose of this avatar: joints, inputs of the networks, and those of them that are the expression.
    pub fn pose_shape(&self) -> [usize; 3] {
        self.pose
    }

    /// Gaussians of this avatar.
    pub fn gaussians(&self) -> usize {
        self.gaussians
    }

    fn corners<'a>(&'a self, joints: &'a [DAffine3]) -> impl Iterator<Item = DVec3> + 'a {
        self.parts.iter().flat_map(move |part| part.corners(joints, part.weighty))
    }

    /// The parts that may be in the picture, and where. A part is outside it when its box is, with room for its Gaussians' size, its nodes'
    /// static displacements and 5 cm of what poses add to them.
    pub fn visible(&self, joints: &[DAffine3], camera: &Camera) -> Visible {
        let scale = enlargement(joints) * enlargement(&[camera.view]);
        let size = UVec2::from(camera.size);
        let mut visible = Visible { parts: PartSet::EMPTY, area: NOWHERE };
        for part in &self.parts {
            let room = scale * (MARGIN + part.displaced + part.reach);
            let wide = scale * (AREA_MARGIN + part.displaced + 2.0 * part.reach);
            let [mut before, mut behind] = [false, true];
            let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            for corner in part.corners(joints, part.joints.len()) {
                let p = camera.view.transform_point3(corner);
                before |= p.z - room < camera.near;
                behind &= p.z + room < camera.near;
                let at = camera.project(p);
                let around = |room: f64| room * camera.focal / (p.z - room) * (1.0 + (p.truncate() / p.z).abs()) + 2.0;
                (min, max) = (min.min(at - around(room)), max.max(at + around(room)));
                // Nearer than the room is wide, it may be anywhere.
                let far = if p.z - wide < camera.near { DVec2::INFINITY } else { around(wide) };
                (low, high) = (low.min(at - far), high.max(at + far));
            }
            let outside = max.cmplt(DVec2::ZERO).any() || min.cmpgt(size.as_dvec2()).any();
            if if before { behind } else { outside } {
                continue;
            }
            visible.parts.insert(part.part);
            let clamp = |at: DVec2| at.clamp(DVec2::ZERO, size.as_dvec2()).as_uvec2();
            // What reaches through the near plane may be anywhere, and so may what no number tells.
            let known = !before && low.is_finite() && high.is_finite();
            let area = if known { [clamp(low.floor()), clamp(high.ceil())] } else { [UVec2::ZERO, size] };
            visible.area = around(visible.area, area);
        }
        visible
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
        let size = UVec2::from(camera.size);
        let Some([min, max]) = self.around(joints, camera, MARGIN) else { return [UVec2::ZERO, size] };
        let clamp = |at: DVec2| at.clamp(DVec2::ZERO, size.as_dvec2()).as_uvec2();
        let [min, max] = [clamp((min - 2.0).floor()), clamp((max + 2.0).ceil())];
        [min.min(max), max]
    }

    /// Pixels of a box around it that has no room to spare and may reach out of the picture. None where it reaches through the near plane.
    pub fn pixels(&self, joints: &[DAffine3], camera: &Camera) -> Option<f64> {
        let [min, max] = self.around(joints, camera, 0.0)?;
        let sides = (max - min).max(DVec2::ZERO);
        Some(sides.x * sides.y)
    }

    /// Lower and upper corner of a box around it in the plane of the picture, with so many metres to spare, px. None where it reaches through
    /// the near plane.
    fn around(&self, joints: &[DAffine3], camera: &Camera, spare: f64) -> Option<[DVec2; 2]> {
        let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for corner in self.corners(joints) {
            let p = camera.view.transform_point3(corner);
            if p.z - spare < camera.near {
                return None;
            }
            let room = spare * camera.focal / (p.z - spare) * (1.0 + (p.truncate() / p.z).abs());
            let at = camera.project(p);
            (min, max) = (min.min(at - room), max.max(at + room));
        }
        Some([min, max])
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
    /// Its corners as each of its first `count` joints moves them.
    fn corners<'a>(&'a self, joints: &'a [DAffine3], count: usize) -> impl Iterator<Item = DVec3> + 'a {
        let corner = |k: usize| {
            let choose = |axis: usize| if k >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
            DVec3::new(choose(0), choose(1), choose(2))
        };
        let corners: [DVec3; 8] = std::array::from_fn(corner);
        self.joints[..count].iter().flat_map(move |&joint| corners.map(|corner| joints[joint as usize].transform_point3(corner)))
    }
}

/// A box at least as high and wide as a person, so that pictures of one clip have the same scale whatever the pose.
pub fn upright([min, max]: [DVec3; 2]) -> [DVec3; 2] {
    let middle = (min + max) / 2.0;
    let half = ((max - min) / 2.0).max(DVec3::new(0.4, 0.92, 0.4));
    [middle - half, middle + half]
}

/// How much the joints enlarge lengths, at most.
pub fn enlargement(joints: &[DAffine3]) -> f64 {
    margin(joints) / MARGIN
}

/// [`MARGIN`] where the joints have moved it.
fn margin(joints: &[DAffine3]) -> f64 {
    let columns = joints.iter().flat_map(|joint| [joint.matrix3.x_axis, joint.matrix3.y_axis, joint.matrix3.z_axis]);
    MARGIN * columns.map(|column| column.length_squared()).fold(0.0, f64::max).sqrt()
}
