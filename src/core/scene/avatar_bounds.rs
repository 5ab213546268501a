//! Where a posed avatar is, from boxes around its parts: bounds that cost some hundred boxes a
//! frame instead of a point a Gaussian.

use super::{
    AxisBox, BoxMover, Camera, Framing, LevelChoice, PartSet, PixelRect, PlaneBox, PlaneRect,
    SceneBoxes, detail, radius_in_sigmas,
};
use crate::avatar::{Avatar, Filter};
use crate::constants::{LOG_SCALE_MAX, LONGEST_MARGIN};
use crate::each;
use glam::{DAffine3, DVec2, DVec3, UVec2};
use std::ops::Range;

/// Margin for correctives (and in [`AvatarBounds::bounds`] for the Gaussians' size), metres before
/// skinning, which may scale it.
const MARGIN: f64 = 0.05;
/// Margin around visible parts for [`Visible::rect`], metres: several times what learned
/// correctives move nodes by (the demo's by 5 cm in its own clip, by 11 with every input at its
/// furthest). Splats that correctives move further are cut off, in every frame alike.
const RECT_MARGIN: f64 = 0.15;
/// Correctives are not trained beyond these inputs, and no margin bounds them there: joint angles
/// are up to π, expressions a few standard deviations.
const INPUT_MAX: f64 = 10.0;
/// Minimum skin weight (0–255) for a joint to widen the avatar's bounds. Culling of parts uses all
/// joints.
const MIN_WEIGHT: u8 = 8;
/// How far a Gaussian without extent reaches in the image by [`Filter::DEFAULT`], rounded up, px.
const FILTER_REACH: f64 = 2.0;

/// A part's box in canonical space, and the joints that move it.
#[derive(Clone, Debug)]
struct PartBox {
    part: usize,
    space: AxisBox,
    /// Largest radius of its Gaussians around their centres, metres: where an opaque one fades
    /// below visibility, enlarged for correctives and levels of detail.
    radius: f64,
    /// Longest static displacement of the part's nodes, metres; 0 where the box is around what
    /// they displace.
    displacement: f64,
    /// 1 where networks move the part, 0 where nothing does and no margin is needed for them.
    corrected: f64,
    /// Every joint that moves one of its Gaussians; those of at least [`MIN_WEIGHT`] first.
    joints: Vec<u8>,
    /// How many of `joints` have at least [`MIN_WEIGHT`].
    major_joints: usize,
}

/// Where a camera sees a posed avatar, and which of its parts: all that a frame asks, from one walk
/// over the parts.
#[derive(Clone, Debug)]
pub struct Visible {
    /// The parts that may be in view.
    pub parts: PartSet,
    /// A rectangle around them in the image, with a wider margin than visibility needs;
    /// [`PixelRect::EMPTY`] where there are none.
    pub rect: PixelRect,
    /// A rectangle around all of the avatar with that margin, inside the image and outside. None
    /// where it comes near the near plane.
    pub around: Option<PlaneRect>,
    /// Width and height of a rectangle around all of the avatar without a margin, px, which may
    /// extend beyond the image. None where the avatar crosses the near plane.
    pub sides: Option<DVec2>,
    /// Nearest and furthest distance along the camera's axis, metres, no nearer than the near
    /// plane. The first is always below the second.
    pub depth: [f64; 2],
}

impl Visible {
    /// The longer of [`Self::sides`], px; infinite where the avatar crosses the near plane.
    pub fn longest_side(&self) -> f64 {
        self.sides.map_or(f64::INFINITY, DVec2::max_element)
    }

    /// Area of the rectangle with these sides, px².
    pub fn pixels(&self) -> Option<f64> {
        self.sides.map(DVec2::element_product)
    }
}

/// The size of a pose's arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PoseShape {
    /// Joints of the skeleton.
    pub joints: usize,
    /// Inputs of the networks.
    pub inputs: usize,
    /// How many of the inputs, at the end, are the expression.
    pub expression: usize,
}

/// The boxes of all parts of an avatar.
///
/// A skinned point is a weighted mean of G_j x over the joints j that move it, so it lies within
/// the convex hull of its part's box as moved by each of them.
#[derive(Clone, Debug)]
pub struct AvatarBounds {
    parts: Vec<PartBox>,
    /// Each joint's, around all that it moves.
    joints: Vec<JointBox>,
    /// What the longest margin of a part is, metres before skinning.
    margin: f64,
    /// Where it is if nothing moves inside it.
    scene: Option<SceneBoxes>,
    pose_shape: PoseShape,
    gaussians: usize,
    /// The low-pass that it is drawn with.
    filter: Filter,
    levels: Vec<LevelChoice>,
}

impl AvatarBounds {
    /// The boxes of an avatar.
    ///
    /// # Panics
    /// Where [`Avatar::check`] finds a fault.
    pub fn new(avatar: &Avatar) -> Self {
        let parts = each::map(avatar.parts.len(), |part| {
            let range = avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize;
            (!range.is_empty()).then(|| PartBox::new(avatar, part, range))
        });
        let parts: Vec<PartBox> = parts.into_iter().flatten().collect();
        Self {
            joints: JointBox::of(&parts),
            margin: parts.iter().map(PartBox::margin).fold(0.0, f64::max),
            scene: avatar.is_static().then(|| {
                let spaces = parts.iter().map(|part| part.space);
                SceneBoxes::new(avatar, spaces.fold(AxisBox::EMPTY, AxisBox::union))
            }),
            parts,
            pose_shape: PoseShape {
                joints: avatar.skeleton.len(),
                inputs: 3 * avatar.inputs.joint.len() + avatar.inputs.expression,
                expression: avatar.inputs.expression,
            },
            gaussians: avatar.gaussians.len(),
            filter: avatar.filter,
            levels: LevelChoice::of(avatar),
        }
    }

    /// These bounds where the avatar is drawn with another low-pass. None: its own.
    #[must_use]
    pub fn filtered(self, filter: Option<Filter>) -> Self {
        Self {
            filter: filter.unwrap_or(self.filter),
            ..self
        }
    }

    /// The shape that a pose of this avatar must have.
    pub fn pose_shape(&self) -> PoseShape {
        self.pose_shape
    }

    /// The low-pass that it is drawn with where it is drawn as large as it is shown.
    pub fn filter(&self) -> Filter {
        self.filter
    }

    /// The avatar's levels, the finest first.
    pub fn levels(&self) -> &[LevelChoice] {
        &self.levels
    }

    /// Number of Gaussians of this avatar.
    pub fn gaussians(&self) -> usize {
        self.gaussians
    }

    /// Where the avatar is, and which of its parts may be in the image. A part is culled if its box
    /// is outside, with a margin for its Gaussians' size, its nodes' static displacements, and 5 cm
    /// of what poses add to them.
    ///
    /// Corners are projected only of parts that may widen a box or lie on the image's border; of
    /// the others a bound says enough.
    pub fn visible(&self, joints: &[DAffine3], camera: &Camera) -> Visible {
        let movers: Vec<BoxMover> = joints
            .iter()
            .map(|joint| BoxMover::new(camera.view * *joint))
            .collect();
        let margin = margin(joints);
        let scale = margin / MARGIN * enlargement(&[camera.view]);
        let reach = reach_of(self.filter);
        let size = UVec2::from(camera.size);
        let mut parts = PartSet::EMPTY;
        // With the wide margin, around the parts in view and around all.
        let mut drawn = PlaneBox::EMPTY;
        let mut around = PlaneBox::EMPTY;
        // Around all without a margin, in space and in the image.
        let mut body = AxisBox::EMPTY;
        let mut bare = PlaneBox::EMPTY;
        for part in &self.parts {
            let moved = MovedPart::new(part, &movers, camera);
            body = body.union(moved.major);
            let bare_bound = moved.major.projection_bound(camera, 0.0, 0.0);
            // Nearer there are no sides to tell.
            if body.min.z >= camera.near {
                bare.include(&bare_bound, || moved.project_major());
            }
            let wide = scale * part.wide_margin();
            let bound = moved.bound(wide, reach);
            if moved.is_outside(scale * part.margin(), reach, &bare_bound, size) {
                around.include(&bound, || moved.project(wide, reach));
            } else {
                parts.insert(part.part);
                drawn.include(&bound, || moved.project(wide, reach));
                around = around.union(drawn);
            }
        }
        Visible {
            parts,
            rect: if parts.is_empty() {
                PixelRect::EMPTY
            } else {
                drawn.within(size)
            },
            around: around.pixels(),
            sides: (body.min.z >= camera.near).then(|| (bare.max - bare.min).max(DVec2::ZERO)),
            depth: match &self.scene {
                Some(scene) => {
                    let dense = movers[0].around(&scene.dense);
                    let [near, far] = depth_range(&dense, 0.0, camera);
                    // What lies beyond keeps its order where little of it is before the camera.
                    [near, far.max(near + 0.1 * dense.min.distance(dense.max))]
                }
                None => depth_range(&body, margin, camera),
            },
        }
    }

    /// Whether [`Visible::rect`] has a margin for what networks make of these inputs.
    pub fn has_margin_for(&self, input: &[f64]) -> bool {
        input.iter().all(|number| number.abs() <= INPUT_MAX)
    }

    /// Whether nothing of the avatar can be in the image: a test of all of it, with a wider margin
    /// than that of its parts ([`Self::visible`]), at a tenth of the cost.
    pub fn is_outside(&self, joints: &[DAffine3], camera: &Camera) -> bool {
        let scale = enlargement(joints) * enlargement(&[camera.view]);
        let margin = scale * self.margin;
        let reach = reach_of(self.filter);
        let [width, height] = camera.size.map(f64::from);
        let DVec2 { x: fx, y: fy } = camera.focal;
        let DVec2 { x: cx, y: cy } = camera.center;
        // Each faces into what the image shows; the last is the near plane.
        let sides = [
            DVec3::new(fx, 0.0, cx + reach),
            DVec3::new(-fx, 0.0, width + reach - cx),
            DVec3::new(0.0, fy, cy + reach),
            DVec3::new(0.0, -fy, height + reach - cy),
        ]
        .map(|normal| normal / normal.length());
        let mut outside = [true; 5];
        for own in &self.joints {
            let moved = camera.view * joints[own.joint];
            for corner in own.space.corners() {
                let p = moved.transform_point3(corner);
                for (outside, side) in outside.iter_mut().zip(&sides) {
                    *outside &= side.dot(p) < -margin;
                }
                outside[4] &= p.z + margin < camera.near;
            }
            if !outside.contains(&true) {
                return false;
            }
        }
        outside.contains(&true)
    }

    /// [`Visible::longest_side`].
    pub fn longest_side(&self, joints: &[DAffine3], camera: &Camera) -> f64 {
        self.visible(joints, camera).longest_side()
    }

    /// [`Visible::pixels`].
    pub fn pixels(&self, joints: &[DAffine3], camera: &Camera) -> Option<f64> {
        self.visible(joints, camera).pixels()
    }

    /// [`Visible::sides`].
    pub fn sides(&self, joints: &[DAffine3], camera: &Camera) -> Option<DVec2> {
        self.visible(joints, camera).sides
    }

    /// [`Visible::depth`].
    pub fn depth(&self, joints: &[DAffine3], camera: &Camera) -> [f64; 2] {
        self.visible(joints, camera).depth
    }

    /// Whether [`Self::visible`] allows for a Gaussian of a part: one beyond may be cut off.
    /// `displaced`: how far nodes move it; `axis`: its longest axis; metres in canonical space.
    pub fn allows_for(&self, part: usize, displaced: f64, axis: f64) -> bool {
        let radius = axis * radius_in_sigmas(255.0).unwrap_or_default();
        self.parts
            .iter()
            .find(|own| own.part == part)
            .is_some_and(|own| {
                let near = self.scene.is_some() || displaced <= own.displacement + MARGIN;
                near && radius <= own.radius
            })
    }

    /// What a camera that has the posed avatar in its image is made from. A person has one scale in
    /// every pose; splats are framed by what they show, in whatever unit they are.
    pub fn framing(&self, joints: &[DAffine3]) -> Framing {
        match &self.scene {
            Some(scene) => {
                let shown = BoxMover::new(joints[0]).around(&scene.shown);
                Framing::scene([shown.min, shown.max])
            }
            None => Framing::person(self.bounds(joints)),
        }
    }

    /// [`Self::bounds`], of splats without a few far ones: for numbers that are exact inside.
    pub fn dense(&self, joints: &[DAffine3]) -> [DVec3; 2] {
        match &self.scene {
            Some(scene) => {
                let dense = BoxMover::new(joints[0]).around(&scene.dense);
                [dense.min, dense.max]
            }
            None => self.bounds(joints),
        }
    }

    /// Lower and upper corner of a box around the posed avatar, of splats around their centres, in
    /// the space that the joint matrices lead to.
    pub fn bounds(&self, joints: &[DAffine3]) -> [DVec3; 2] {
        let movers: Vec<BoxMover> = joints.iter().map(|&joint| BoxMover::new(joint)).collect();
        let body = self
            .parts
            .iter()
            .map(|part| part.around(part.major(), &movers))
            .fold(AxisBox::EMPTY, AxisBox::union);
        let margin = match self.scene {
            Some(_) => 0.0,
            None => margin(joints),
        };
        if body.min.cmple(body.max).all() {
            [body.min - margin, body.max + margin]
        } else {
            [DVec3::ZERO; 2]
        }
    }
}

/// The box around all that a joint moves, in canonical space.
#[derive(Clone, Debug)]
struct JointBox {
    joint: usize,
    space: AxisBox,
}

impl JointBox {
    /// The boxes of all joints that move some of these parts.
    fn of(parts: &[PartBox]) -> Vec<Self> {
        let mut boxes: Vec<Self> = Vec::new();
        for part in parts {
            for &joint in &part.joints {
                let joint = usize::from(joint);
                match boxes.iter_mut().find(|own| own.joint == joint) {
                    Some(own) => own.space = own.space.union(part.space),
                    None => boxes.push(Self {
                        joint,
                        space: part.space,
                    }),
                }
            }
        }
        boxes
    }
}

impl PartBox {
    /// What visibility allows for around the box, metres before skinning.
    fn margin(&self) -> f64 {
        self.corrected * MARGIN + self.displacement + self.radius
    }

    /// What [`Visible::rect`] allows for around the box, metres before skinning; never less.
    fn wide_margin(&self) -> f64 {
        self.corrected * RECT_MARGIN + self.displacement + 2.0 * self.radius
    }

    fn new(avatar: &Avatar, part: usize, range: Range<usize>) -> Self {
        let gaussians = &avatar.gaussians;
        let longest_axis = gaussians.log_scale[range.clone()]
            .iter()
            .flatten()
            .map(|log_scale| log_scale.to_f64())
            .fold(f64::NEG_INFINITY, f64::max)
            .min(LOG_SCALE_MAX)
            .exp();
        let radius = LONGEST_MARGIN
            * detail::covariance_scale(detail::COARSEST).sqrt()
            * longest_axis
            * radius_in_sigmas(255.0).unwrap_or_default();

        let is_static = avatar.is_static();
        let mut space = AxisBox::EMPTY;
        let mut displacement = 0.0f64;
        let mut weight = [0u8; 256];
        for gaussian in range {
            if is_static {
                space.add(avatar.placed(gaussian));
            } else {
                space.add(avatar.position(gaussian));
                for &node in &gaussians.node[gaussian] {
                    let offset = avatar.nodes.offset[usize::from(node)].map(f64::from);
                    displacement = displacement.max(DVec3::from(offset).length());
                }
            }
            let weights = gaussians.joint_weight[gaussian];
            for (&joint, w) in gaussians.joint[gaussian].iter().zip(weights) {
                let largest = &mut weight[usize::from(joint)];
                *largest = w.max(*largest);
            }
        }
        let is_major = |joint: &u8| weight[usize::from(*joint)] >= MIN_WEIGHT;
        let mut joints: Vec<u8> = (0..=255)
            .filter(|&joint| weight[usize::from(joint)] > 0)
            .collect();
        joints.sort_by_key(|joint| !is_major(joint));
        let major_joints = joints.iter().filter(|joint| is_major(joint)).count();
        Self {
            part,
            space,
            radius,
            displacement,
            corrected: if is_static { 0.0 } else { 1.0 },
            joints,
            major_joints,
        }
    }

    /// The joints of at least [`MIN_WEIGHT`].
    fn major(&self) -> &[u8] {
        &self.joints[..self.major_joints]
    }

    /// The others.
    fn minor(&self) -> &[u8] {
        &self.joints[self.major_joints..]
    }

    /// The smallest box around the part's as moved by each of these joints.
    fn around(&self, joints: &[u8], movers: &[BoxMover]) -> AxisBox {
        joints.iter().fold(AxisBox::EMPTY, |around, &joint| {
            around.union(movers[usize::from(joint)].around(&self.space))
        })
    }
}

/// A part as joints move it and a camera sees it.
struct MovedPart<'a> {
    part: &'a PartBox,
    /// Canonical space to the camera's, for each joint of the avatar.
    movers: &'a [BoxMover],
    camera: &'a Camera,
    /// Around the box as moved by the part's major joints, in camera coordinates.
    major: AxisBox,
    /// Around the box as moved by all of its joints, in camera coordinates.
    all: AxisBox,
}

impl<'a> MovedPart<'a> {
    fn new(part: &'a PartBox, movers: &'a [BoxMover], camera: &'a Camera) -> Self {
        let major = part.around(part.major(), movers);
        Self {
            part,
            movers,
            camera,
            major,
            all: major.union(part.around(part.minor(), movers)),
        }
    }

    /// Whether nothing of the part can be in an image of this size. `margin`: what visibility
    /// allows for around it, metres; `reach`: what the low-pass adds, px; `bare`: a bound of where
    /// its major joints move it.
    fn is_outside(&self, margin: f64, reach: f64, bare: &PlaneBox, size: UVec2) -> bool {
        if self.is_near(margin) {
            // The projection says nothing about points that near: only where all of them are.
            return self.all.max.z + margin < self.camera.near;
        }
        if bare.is_inside(size) {
            return false;
        }
        if self.bound(margin, reach).is_outside(size) {
            return true;
        }
        let mut projected = PlaneBox::EMPTY;
        for p in self.corners(&self.part.joints) {
            projected = projected.union(PlaneBox::around(p, self.camera, margin, reach));
            if !projected.is_outside(size) {
                return false;
            }
        }
        true
    }

    /// Whether some of the part, with a margin in metres, may be nearer than the near plane.
    fn is_near(&self, margin: f64) -> bool {
        self.all.min.z - margin < self.camera.near
    }

    /// A box around [`Self::project`].
    fn bound(&self, margin: f64, reach: f64) -> PlaneBox {
        if self.is_near(margin) {
            return PlaneBox::EVERYWHERE;
        }
        self.all.projection_bound(self.camera, margin, reach)
    }

    /// Encloses the part in the plane of the image, with a margin in metres and what the low-pass
    /// adds, px. What is nearer than its margin is wide may appear anywhere.
    fn project(&self, margin: f64, reach: f64) -> PlaneBox {
        if self.is_near(margin) {
            return PlaneBox::EVERYWHERE;
        }
        self.project_corners(&self.part.joints, margin, reach)
    }

    /// Encloses what major joints move, without a margin. None of it is nearer than the near plane.
    fn project_major(&self) -> PlaneBox {
        self.project_corners(self.part.major(), 0.0, 0.0)
    }

    /// Corners of the box as moved by each of these joints, in camera coordinates.
    fn corners(&self, joints: &[u8]) -> impl Iterator<Item = DVec3> {
        joints
            .iter()
            .flat_map(|&joint| self.movers[usize::from(joint)].corners(self.part.space))
    }

    fn project_corners(&self, joints: &[u8], margin: f64, reach: f64) -> PlaneBox {
        self.corners(joints).fold(PlaneBox::EMPTY, |projected, p| {
            projected.union(PlaneBox::around(p, self.camera, margin, reach))
        })
    }
}

/// [`Visible::depth`] of what is in a box in camera coordinates. `margin`: [`margin()`] of the
/// joints.
fn depth_range(body: &AxisBox, margin: f64, camera: &Camera) -> [f64; 2] {
    let margin = margin * camera.view.matrix3.row(2).length();
    let near = if body.min.z.is_finite() {
        (body.min.z - margin).max(camera.near)
    } else {
        camera.near
    };
    // At least a hundredth of the margin deep, and more than f32 can tell apart.
    let far = (body.max.z + margin)
        .max(near + 0.02 * margin)
        .max(near * (1.0 + 1e-6));
    [near, far]
}

/// How far a Gaussian without extent reaches in the image, px.
fn reach_of(filter: Filter) -> f64 {
    FILTER_REACH * (filter.variance / Filter::DEFAULT.variance).sqrt().max(1.0)
}

/// How much the joints enlarge lengths, at most.
pub fn enlargement(joints: &[DAffine3]) -> f64 {
    margin(joints) / MARGIN
}

/// [`MARGIN`] as the joints enlarge it, at most, metres.
fn margin(joints: &[DAffine3]) -> f64 {
    // The largest eigenvalue of MᵀM is at most the largest sum of a row of its magnitudes
    // (Gershgorin), and equal to it where the columns are orthogonal.
    let squares = joints.iter().flat_map(|joint| {
        let [x, y, z] = [
            joint.matrix3.x_axis,
            joint.matrix3.y_axis,
            joint.matrix3.z_axis,
        ];
        let [xy, yz, zx] = [x.dot(y).abs(), y.dot(z).abs(), z.dot(x).abs()];
        [
            x.length_squared() + xy + zx,
            y.length_squared() + xy + yz,
            z.length_squared() + yz + zx,
        ]
    });
    MARGIN * squares.fold(0.0, f64::max).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use glam::{DMat3, DQuat};

    /// What [`AvatarBounds::visible`] promises, from every corner of every box, step by step.
    struct Plain {
        visible: Visible,
        bounds: [DVec3; 2],
    }

    fn corners(part: &PartBox, joints: &[DAffine3], count: usize) -> Vec<DVec3> {
        let moved = |&joint: &u8| {
            let corners = part.space.corners();
            corners.map(move |corner| joints[usize::from(joint)].transform_point3(corner))
        };
        part.joints[..count].iter().flat_map(moved).collect()
    }

    /// [`PlaneBox::around`], nearer than the margin too.
    fn around(p: DVec3, camera: &Camera, margin: f64, reach: f64) -> PlaneBox {
        if p.z - margin < camera.near {
            return PlaneBox::EVERYWHERE;
        }
        let at = camera.project(p);
        let radius = margin * camera.focal / (p.z - margin) * (1.0 + (p.truncate() / p.z).abs());
        PlaneBox {
            min: at - radius - reach,
            max: at + radius + reach,
        }
    }

    impl Plain {
        fn new(of: &AvatarBounds, joints: &[DAffine3], camera: &Camera) -> Self {
            let size = UVec2::from(camera.size);
            let scale = enlargement(joints) * enlargement(&[camera.view]);
            let reach = reach_of(of.filter);
            let mut parts = PartSet::EMPTY;
            let mut rect = PixelRect::EMPTY;
            let mut all = PlaneBox::EMPTY;
            let mut bare = PlaneBox::EMPTY;
            let mut body = AxisBox::EMPTY;
            let mut bounds = AxisBox::EMPTY;
            for part in &of.parts {
                for corner in corners(part, joints, part.major_joints) {
                    let p = camera.view.transform_point3(corner);
                    bounds.add(corner);
                    body.add(p);
                    bare = bare.union(around(p, camera, 0.0, 0.0));
                }
                let mut tight = PlaneBox::EMPTY;
                let mut padded = PlaneBox::EMPTY;
                let mut crosses_near = false;
                let mut behind_near = true;
                let margin = scale * part.margin();
                for corner in corners(part, joints, part.joints.len()) {
                    let p = camera.view.transform_point3(corner);
                    crosses_near |= p.z - margin < camera.near;
                    behind_near &= p.z + margin < camera.near;
                    tight = tight.union(around(p, camera, margin, reach));
                    padded = padded.union(around(p, camera, scale * part.wide_margin(), reach));
                }
                all = all.union(padded);
                let outside = if crosses_near {
                    behind_near
                } else {
                    tight.is_outside(size)
                };
                if !outside {
                    parts.insert(part.part);
                    rect = rect.union(padded.within(size));
                }
            }
            let margin = margin(joints);
            Self {
                visible: Visible {
                    parts,
                    rect,
                    around: all.pixels(),
                    sides: (body.min.z >= camera.near).then(|| bare.max - bare.min),
                    depth: depth_range(&body, margin, camera),
                },
                bounds: [bounds.min - margin, bounds.max + margin],
            }
        }
    }

    fn point(random: &mut Random, within: f64) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| random.range(-within, within)))
    }

    /// Boxes of a body about as large as a person, each moved by one to four of so many joints.
    fn body(random: &mut Random, joints: usize) -> AvatarBounds {
        let mut part = |part| {
            let min = point(random, 0.8);
            let mut pick = || (random.uniform() * joints as f64) as u8;
            let mut joints = vec![pick(), pick(), pick(), pick()];
            joints.truncate(1 + part % 4);
            PartBox {
                part,
                space: AxisBox {
                    min,
                    max: min + random.range(0.0, 0.2) * point(random, 1.0).abs(),
                },
                radius: random.range(0.0, 0.05),
                displacement: random.range(0.0, 0.02),
                corrected: 1.0,
                major_joints: joints.len().min(3),
                joints,
            }
        };
        let parts: Vec<PartBox> = (0..60).map(&mut part).collect();
        AvatarBounds {
            joints: JointBox::of(&parts),
            margin: parts.iter().map(PartBox::margin).fold(0.0, f64::max),
            scene: None,
            parts,
            pose_shape: PoseShape {
                joints,
                inputs: 0,
                expression: 0,
            },
            gaussians: 0,
            filter: Filter::DEFAULT,
            levels: vec![],
        }
    }

    /// Joints that turn and stretch what they move, `stretch` times at most.
    fn pose(random: &mut Random, joints: usize, stretch: f64) -> Vec<DAffine3> {
        let mut joint = || {
            let turn = DQuat::from_scaled_axis(random.range(0.0, 1.0) * random.direction());
            let stretch = DVec3::splat(stretch) - stretch * point(random, 0.2).abs();
            let linear = DMat3::from_quat(turn) * DMat3::from_diagonal(stretch);
            DAffine3::from_mat3_translation(linear, stretch * point(random, 0.1))
        };
        (0..joints).map(|_| joint()).collect()
    }

    /// A camera somewhere inside or outside the body, which may look past it.
    fn camera(random: &mut Random, stretch: f64) -> Camera {
        let distance = stretch.max(1e-3) * (10.0 * random.uniform().powi(2));
        let eye = distance * random.direction();
        let fov = random.range(0.1, 2.0);
        let target = stretch * point(random, 1.0);
        let mut camera = Camera::look_at(eye, target, fov, [640, 360]);
        camera.center += DVec2::new(random.range(-200.0, 200.0), random.range(-200.0, 200.0));
        camera.focal.x *= random.range(0.5, 2.0);
        camera.view.matrix3 *= random.range(0.5, 1.5);
        camera.near = stretch.max(1e-3) * random.range(1e-6, 0.3);
        camera
    }

    #[test]
    fn the_walk_says_what_every_corner_says() {
        // Of how many scenes the numbers are: none, some and all parts in view, across the near
        // plane, bounded in the plane.
        let mut seen = [0; 5];
        for seed in 0..6000 {
            let random = &mut Random::new(1, seed);
            let stretch = [1.0, 1.0, 1.0, 1e5, 1e-4, 0.0][seed as usize % 6];
            let bounds = body(random, 12);
            let joints = pose(random, 12, stretch);
            let camera = camera(random, stretch);
            let plain = Plain::new(&bounds, &joints, &camera);
            let visible = bounds.visible(&joints, &camera);
            let expected = &plain.visible;
            assert_eq!(visible.parts, expected.parts, "seed {seed}");
            assert_eq!(visible.rect, expected.rect, "seed {seed}");
            assert_eq!(visible.around, expected.around, "seed {seed}");
            assert_eq!(visible.sides.is_some(), expected.sides.is_some());
            let largest = expected.sides.unwrap_or_default().max_element();
            let off = visible.sides.unwrap_or_default() - expected.sides.unwrap_or_default();
            assert!(
                off.abs().max_element() <= 1e-12 * largest,
                "seed {seed}: {off} of {largest}"
            );
            for (own, expected) in visible.depth.iter().zip(expected.depth) {
                assert!((own - expected).abs() <= 1e-12 * expected, "seed {seed}");
            }
            for (own, expected) in bounds.bounds(&joints).iter().zip(plain.bounds) {
                let off = (own - expected).abs().max_element();
                assert!(off <= 1e-12 * stretch, "seed {seed}: {off} m");
            }
            let parts = visible.parts.len();
            let kinds = [
                parts == 0,
                (1..60).contains(&parts),
                parts == 60,
                visible.sides.is_none(),
                visible.around.is_some(),
            ];
            for (seen, kind) in seen.iter_mut().zip(kinds) {
                *seen += usize::from(kind);
            }
        }
        assert!(seen.iter().all(|&scenes| scenes > 200), "{seen:?}");
    }

    #[test]
    fn no_direction_is_enlarged_by_more_than_is_said() {
        let random = &mut Random::new(11, 0);
        for _ in 0..200 {
            let mut column = || point(random, 1.0);
            let sheared = DMat3::from_cols(column(), column(), column());
            let said = enlargement(&[DAffine3::from_mat3(sheared)]);
            let most = (0..200)
                .map(|_| (sheared * point(random, 1.0).normalize()).length())
                .fold(0.0, f64::max);
            assert!(most <= said * (1.0 + 1e-12), "{most} of {said}");
        }
        let turned = DMat3::from_quat(DQuat::from_rotation_x(0.7) * DQuat::from_rotation_z(2.0));
        let scaled = turned * DMat3::from_diagonal(DVec3::new(0.5, 2.0, 1.0));
        let said = enlargement(&[DAffine3::from_mat3(scaled)]);
        assert!(
            (said - 2.0).abs() < 1e-9,
            "{said} where columns are orthogonal"
        );
    }
}
