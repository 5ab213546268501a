//! Where a posed avatar is, from boxes around its parts: bounds that cost some thousand points a
//! frame instead of one a Gaussian.

use super::{Camera, LevelChoice, PartSet, PixelRect, PlaneRect, detail, radius_in_sigmas};
use crate::avatar::{Avatar, Filter};
use crate::constants::{LOG_SCALE_MAX, LONGEST_MARGIN};
use crate::each;
use glam::{DAffine3, DVec2, DVec3, UVec2};
use std::ops::Range;

/// Margin for correctives (and in [`AvatarBounds::bounds`] for the Gaussians' size), metres before
/// skinning, which may scale it.
const MARGIN: f64 = 0.05;
/// Margin around visible parts for [`Visible::rect`], metres: several times what learned
/// correctives move nodes by (the demo's by 5 cm in its own clip, by 11 where every input is at its
/// furthest). What a model's correctives move further is cut off, in every frame alike.
const RECT_MARGIN: f64 = 0.15;
/// Larger inputs are none that correctives are learned for: joint angles are up to π, expressions a
/// few standard deviations. Of how far they move nodes no margin says anything.
const INPUT_MAX: f64 = 10.0;
/// Coordinates in the plane of the image beyond this, px, belong to nothing that is drawn.
const PLANE_MAX: f64 = 1e6;
/// Minimum skin weight (0–255) for a joint to widen the avatar's bounds. Culling of parts uses all
/// joints.
const MIN_WEIGHT: u8 = 8;
/// How far a Gaussian without extent reaches in the image by [`Filter::DEFAULT`], rounded up, px.
const FILTER_REACH: f64 = 2.0;

/// A part's box in canonical space, and the joints that move it.
#[derive(Clone, Debug)]
struct PartBox {
    part: usize,
    min: DVec3,
    max: DVec3,
    /// Largest radius of its Gaussians around their centres, metres: where an opaque one fades
    /// below visibility, enlarged for correctives and levels of detail.
    radius: f64,
    /// Longest static displacement of the part's nodes, metres.
    displacement: f64,
    /// Every joint that moves one of its Gaussians; those of at least [`MIN_WEIGHT`] first.
    joints: Vec<u8>,
    /// How many of `joints` have at least [`MIN_WEIGHT`].
    major_joints: usize,
}

/// The parts of an avatar that may be in an image, and where.
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
}

/// A box in the plane of the image, px; it may lie outside the image.
#[derive(Clone, Copy)]
struct PlaneBox {
    min: DVec2,
    max: DVec2,
}

impl PlaneBox {
    const EMPTY: Self = Self {
        min: DVec2::INFINITY,
        max: DVec2::NEG_INFINITY,
    };

    /// Widens the box by a point and a radius around it.
    fn add(&mut self, center: DVec2, radius: DVec2) {
        self.min = self.min.min(center - radius);
        self.max = self.max.max(center + radius);
    }

    /// The pixels of an image that it touches.
    fn clamp(&self, size: UVec2) -> PixelRect {
        let clamp = |at: DVec2| at.clamp(DVec2::ZERO, size.as_dvec2()).as_uvec2();
        PixelRect {
            min: clamp(self.min.floor()),
            max: clamp(self.max.ceil()),
        }
    }

    /// The smallest box around both.
    fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The pixels of the plane that it touches. None where it is empty, or too large to be drawn.
    fn pixels(&self) -> Option<PlaneRect> {
        let drawn = |at: DVec2| at.abs().max_element() < PLANE_MAX;
        (drawn(self.min) && drawn(self.max)).then(|| PlaneRect {
            min: self.min.floor().as_ivec2(),
            max: self.max.ceil().as_ivec2(),
        })
    }
}

/// A part's box as a camera sees it.
struct ProjectedBox {
    /// Encloses the part with a margin that decides visibility.
    tight: PlaneBox,
    /// Encloses the part with a margin wide enough to clear and draw within.
    padded: PlaneBox,
    /// Some of the part, with its margin, may be nearer than the near plane.
    crosses_near: bool,
    /// All of it is.
    behind_near: bool,
}

impl ProjectedBox {
    /// Whether nothing of the part can be in an image of this size.
    fn is_outside(&self, size: UVec2) -> bool {
        if self.crosses_near {
            // The projection says nothing about points that near.
            return self.behind_near;
        }
        self.tight.max.cmplt(DVec2::ZERO).any() || self.tight.min.cmpgt(size.as_dvec2()).any()
    }

    /// The pixels that may show the part: the whole image where the projection does not bound it.
    fn drawn_rect(&self, size: UVec2) -> PixelRect {
        let bounded =
            !self.crosses_near && self.padded.min.is_finite() && self.padded.max.is_finite();
        if bounded {
            self.padded.clamp(size)
        } else {
            PixelRect::whole(size.into())
        }
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

    /// Corners of all parts' boxes as moved by their major joints.
    fn corners<'a>(&'a self, joints: &'a [DAffine3]) -> impl Iterator<Item = DVec3> + 'a {
        self.parts
            .iter()
            .flat_map(move |part| part.corners(joints, part.major_joints))
    }

    /// The parts that may be in the image, and where. A part is culled if its box is outside, with
    /// a margin for its Gaussians' size, its nodes' static displacements, and 5 cm of what poses
    /// add to them.
    pub fn visible(&self, joints: &[DAffine3], camera: &Camera) -> Visible {
        let scale = enlargement(joints) * enlargement(&[camera.view]);
        let size = UVec2::from(camera.size);
        let mut visible = Visible {
            parts: PartSet::EMPTY,
            rect: PixelRect::EMPTY,
            around: None,
        };
        let mut around = PlaneBox::EMPTY;
        for part in &self.parts {
            let projected = part.project(joints, camera, scale, reach_of(self.filter));
            around = around.union(projected.padded);
            if projected.is_outside(size) {
                continue;
            }
            visible.parts.insert(part.part);
            visible.rect = visible.rect.union(projected.drawn_rect(size));
        }
        visible.around = around.pixels();
        visible
    }

    /// Whether [`Visible::rect`] has a margin for what networks make of these inputs.
    pub fn has_margin_for(&self, input: &[f64]) -> bool {
        input.iter().all(|number| number.abs() <= INPUT_MAX)
    }

    /// Whether nothing of the avatar can be in the image: a test of all of it, with a wider margin
    /// than that of its parts ([`Self::visible`]), at a twentieth of the cost.
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
            for corner in corners_of(own.min, own.max) {
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

    /// Longest side of a rectangle around the avatar without a margin, px; infinite where it
    /// crosses the near plane.
    pub fn longest_side(&self, joints: &[DAffine3], camera: &Camera) -> f64 {
        let sides = self.sides(joints, camera);
        sides.map_or(f64::INFINITY, DVec2::max_element)
    }

    /// Whether [`Self::visible`] allows for a Gaussian of a part: one beyond may be cut off.
    /// `displaced`: how far nodes move it; `axis`: its longest axis; metres in canonical space.
    pub fn allows_for(&self, part: usize, displaced: f64, axis: f64) -> bool {
        let radius = axis * radius_in_sigmas(255.0).unwrap_or_default();
        self.parts
            .iter()
            .find(|own| own.part == part)
            .is_some_and(|own| displaced <= own.displacement + MARGIN && radius <= own.radius)
    }

    /// Lower and upper corner of a box around the posed avatar, in the space that the joint
    /// matrices lead to.
    pub fn bounds(&self, joints: &[DAffine3]) -> [DVec3; 2] {
        let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [min, max] = self.corners(joints).fold(none, |[min, max], corner| {
            [min.min(corner), max.max(corner)]
        });
        let margin = margin(joints);
        if min.cmple(max).all() {
            [min - margin, max + margin]
        } else {
            [DVec3::ZERO; 2]
        }
    }

    /// Area of a rectangle around the avatar without a margin, px², which may extend beyond the
    /// image. None where the avatar crosses the near plane.
    pub fn pixels(&self, joints: &[DAffine3], camera: &Camera) -> Option<f64> {
        let sides = self.sides(joints, camera)?;
        Some(sides.x * sides.y)
    }

    /// Width and height of that rectangle, px. None where the avatar crosses the near plane.
    pub fn sides(&self, joints: &[DAffine3], camera: &Camera) -> Option<DVec2> {
        let projected = self.project(joints, camera, 0.0)?;
        Some((projected.max - projected.min).max(DVec2::ZERO))
    }

    /// A box around the avatar in the plane of the image, with a margin in metres. None where it
    /// crosses the near plane.
    fn project(&self, joints: &[DAffine3], camera: &Camera, margin: f64) -> Option<PlaneBox> {
        let mut projected = PlaneBox::EMPTY;
        for corner in self.corners(joints) {
            let p = camera.view.transform_point3(corner);
            if p.z - margin < camera.near {
                return None;
            }
            projected.add(camera.project(p), projected_radius(camera, p, margin));
        }
        Some(projected)
    }

    /// Nearest and furthest distance along the camera's axis, metres, no nearer than the near
    /// plane. The first is always below the second.
    pub fn depth(&self, joints: &[DAffine3], camera: &Camera) -> [f64; 2] {
        let axis = camera.view.matrix3.transpose().z_axis;
        let along = |point: DVec3| axis.dot(point) + camera.view.translation.z;
        let (min, max) = self
            .corners(joints)
            .map(along)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(min, max), z| {
                (min.min(z), max.max(z))
            });
        let margin = margin(joints) * axis.length();
        let near = if min.is_finite() {
            (min - margin).max(camera.near)
        } else {
            camera.near
        };
        // At least a hundredth of the margin deep, and more than f32 can tell apart.
        let far = (max + margin)
            .max(near + 0.02 * margin)
            .max(near * (1.0 + 1e-6));
        [near, far]
    }
}

/// The box around all that a joint moves, in canonical space.
#[derive(Clone, Debug)]
struct JointBox {
    joint: usize,
    min: DVec3,
    max: DVec3,
}

impl JointBox {
    /// The boxes of all joints that move some of these parts.
    fn of(parts: &[PartBox]) -> Vec<Self> {
        let mut boxes: Vec<Self> = Vec::new();
        for part in parts {
            for &joint in &part.joints {
                let joint = usize::from(joint);
                match boxes.iter_mut().find(|own| own.joint == joint) {
                    Some(own) => {
                        own.min = own.min.min(part.min);
                        own.max = own.max.max(part.max);
                    }
                    None => boxes.push(Self {
                        joint,
                        min: part.min,
                        max: part.max,
                    }),
                }
            }
        }
        boxes
    }
}

/// The corners of a box.
fn corners_of(min: DVec3, max: DVec3) -> [DVec3; 8] {
    std::array::from_fn(|k| {
        let choose = |axis: usize| {
            if k >> axis & 1 == 0 {
                min[axis]
            } else {
                max[axis]
            }
        };
        DVec3::new(choose(0), choose(1), choose(2))
    })
}

impl PartBox {
    /// What visibility allows for around the box, metres before skinning.
    fn margin(&self) -> f64 {
        MARGIN + self.displacement + self.radius
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

        let mut min = DVec3::INFINITY;
        let mut max = DVec3::NEG_INFINITY;
        let mut displacement = 0.0f64;
        let mut weight = [0u8; 256];
        for gaussian in range {
            let position = avatar.position(gaussian);
            min = min.min(position);
            max = max.max(position);
            for &node in &gaussians.node[gaussian] {
                let offset = avatar.nodes.offset[usize::from(node)].map(f64::from);
                displacement = displacement.max(DVec3::from(offset).length());
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
            min,
            max,
            radius,
            displacement,
            joints,
            major_joints,
        }
    }

    /// Corners of the box as moved by each of the part's first `count` joints.
    fn corners<'a>(
        &'a self,
        joints: &'a [DAffine3],
        count: usize,
    ) -> impl Iterator<Item = DVec3> + 'a {
        let corners = corners_of(self.min, self.max);
        self.joints[..count].iter().flat_map(move |&joint| {
            corners.map(|corner| joints[usize::from(joint)].transform_point3(corner))
        })
    }

    /// The box as a camera sees it. `scale`: how much joints and camera enlarge lengths, at most;
    /// `reach`: what the low-pass adds in the image, px.
    fn project(
        &self,
        joints: &[DAffine3],
        camera: &Camera,
        scale: f64,
        reach: f64,
    ) -> ProjectedBox {
        let margin = scale * self.margin();
        let wide_margin = scale * (RECT_MARGIN + self.displacement + 2.0 * self.radius);
        let mut projected = ProjectedBox {
            tight: PlaneBox::EMPTY,
            padded: PlaneBox::EMPTY,
            crosses_near: false,
            behind_near: true,
        };
        for corner in self.corners(joints, self.joints.len()) {
            let p = camera.view.transform_point3(corner);
            projected.crosses_near |= p.z - margin < camera.near;
            projected.behind_near &= p.z + margin < camera.near;
            let at = camera.project(p);
            let radius = |margin| projected_radius(camera, p, margin) + reach;
            projected.tight.add(at, radius(margin));
            // A point nearer than its margin is wide may appear anywhere.
            let wide_radius = if p.z - wide_margin < camera.near {
                DVec2::INFINITY
            } else {
                radius(wide_margin)
            };
            projected.padded.add(at, wide_radius);
        }
        projected
    }
}

/// How far a Gaussian without extent reaches in the image, px.
fn reach_of(filter: Filter) -> f64 {
    FILTER_REACH * (filter.variance / Filter::DEFAULT.variance).sqrt().max(1.0)
}

/// How far from a point's projection anything within `margin` metres of the point may appear, px.
/// `p`: in camera coordinates, further than `margin` from the camera.
fn projected_radius(camera: &Camera, p: DVec3, margin: f64) -> DVec2 {
    margin * camera.focal / (p.z - margin) * (1.0 + (p.truncate() / p.z).abs())
}

/// Widens a box to at least the size of a standing person, so that images of one clip have one
/// scale, whatever the pose.
pub fn upright(bounds: [DVec3; 2]) -> [DVec3; 2] {
    let [min, max] = bounds;
    let middle = (min + max) / 2.0;
    let half = ((max - min) / 2.0).max(DVec3::new(0.4, 0.92, 0.4));
    [middle - half, middle + half]
}

/// How much the joints enlarge lengths, at most.
pub fn enlargement(joints: &[DAffine3]) -> f64 {
    margin(joints) / MARGIN
}

/// [`MARGIN`] as the joints enlarge it, at most, metres.
fn margin(joints: &[DAffine3]) -> f64 {
    let columns = joints.iter().flat_map(|joint| {
        [
            joint.matrix3.x_axis,
            joint.matrix3.y_axis,
            joint.matrix3.z_axis,
        ]
    });
    MARGIN
        * columns
            .map(|column| column.length_squared())
            .fold(0.0, f64::max)
            .sqrt()
}
