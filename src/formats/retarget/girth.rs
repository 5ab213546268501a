//! How thick a body is: its trunk, slice by slice, and its arms. Measured on an avatar's Gaussians.

use super::humanoid::Humanoid;
use effigy_core::avatar::{Avatar, Bounds, Pose, Skeleton};
use glam::{DAffine3, DVec3};

/// Height of a slice, metres.
const SLICE: f64 = 0.03;
/// Gaussians that are further above or below a joint of the trunk are not its flesh, metres.
const TALLEST: f64 = 1.5;
/// Gaussians that a slice has at least to count.
const FEWEST: usize = 12;
/// Share of a slice's Gaussians that are inside its outline: some stand off.
const INSIDE: f64 = 0.9;

/// A slice through the trunk, level in the rest pose: half an ellipse in front and half one behind
/// the joint that carries it. Metres; 0: nothing is there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct TrunkSlice {
    /// To either side.
    width: f64,
    front: f64,
    back: f64,
}

/// The part of the trunk that one joint carries.
#[derive(Clone, Debug, PartialEq)]
struct TrunkSection {
    joint: usize,
    /// Height of the first slice over the joint, metres.
    bottom: f64,
    /// From the bottom up.
    slices: Vec<TrunkSlice>,
}

/// The thickness of an avatar's trunk and arms.
#[derive(Clone, Debug, PartialEq)]
pub struct Girth {
    sections: Vec<TrunkSection>,
    /// Of forearms, metres.
    pub arm: f64,
}

/// What of an avatar its thickness is measured on, of N Gaussians.
#[derive(Clone, Copy, Debug)]
pub struct TrunkSkin<'a> {
    /// The avatar's.
    pub skeleton: &'a Skeleton,
    /// The box that positions are coordinates in.
    pub bounds: Bounds,
    /// Means in the canonical pose; shape N, 3.
    pub position: &'a [[u16; 3]],
    /// Four joints that move each Gaussian, all of the skeleton; shape N, 4.
    pub joint: &'a [[u8; 4]],
    /// Their weights, of 255; shape N, 4.
    pub joint_weight: &'a [[u8; 4]],
}

impl<'a> From<&'a Avatar> for TrunkSkin<'a> {
    fn from(avatar: &'a Avatar) -> Self {
        let gaussians = &avatar.gaussians;
        Self {
            skeleton: &avatar.skeleton,
            bounds: gaussians.bounds,
            position: &gaussians.position,
            joint: &gaussians.joint,
            joint_weight: &gaussians.joint_weight,
        }
    }
}

/// Points of a body, each in the axes of the joint that moves it most, from that joint, at rest.
struct Points {
    joint: Vec<usize>,
    at: Vec<DVec3>,
}

impl Points {
    fn of(skin: TrunkSkin) -> Self {
        let skeleton = skin.skeleton;
        let rest = Pose::rest(skeleton.len(), 0);
        let to_rest = skeleton.matrices(&rest);
        let mut points = Self {
            joint: vec![],
            at: vec![],
        };
        let gaussians = skin.position.iter().zip(skin.joint);
        for ((position, joints), weights) in gaussians.zip(skin.joint_weight) {
            let most = (0..4).max_by_key(|&k| weights[k]).unwrap_or(0);
            let joint = usize::from(joints[most]);
            let own = DVec3::from(skeleton.rest[joint].map(f64::from));
            let place = to_rest[joint].transform_point3(skin.bounds.decode(*position));
            points.joint.push(joint);
            points.at.push(place - own);
        }
        points
    }

    fn of_joint(&self, joint: usize) -> impl Iterator<Item = DVec3> {
        let all = self.joint.iter().zip(&self.at);
        all.filter_map(move |(own, at)| (*own == joint).then_some(*at))
    }
}

/// The value below which a share of all values are; 0 of none.
fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let last = values.len().saturating_sub(1) as f64;
    let at = (last * share) as usize;
    values.get(at).copied().unwrap_or(0.0)
}

impl Girth {
    /// Measures an avatar; None: it has no body.
    pub fn of(avatar: &Avatar) -> Option<Self> {
        Self::of_skin(avatar.into())
    }

    /// Measures the skin of an avatar; None: it has no body.
    pub fn of_skin(skin: TrunkSkin) -> Option<Self> {
        let tree = super::tree::Tree::of_skeleton(skin.skeleton);
        let body = Humanoid::find(&tree, None, &[]).ok()?;
        let points = Points::of(skin);
        let trunk = [body.hips].into_iter().chain(body.spine.iter().copied());
        let sections = trunk.filter_map(|joint| section(&points, joint)).collect();
        let forearm = body.arms[0].forearm;
        let along = (tree.rest[body.arms[0].hand] - tree.rest[forearm]).normalize_or(DVec3::X);
        let radii = points.of_joint(forearm);
        let radii = radii.map(|at| at.reject_from_normalized(along).length());
        Some(Self {
            sections,
            arm: quantile(radii.collect(), 0.5),
        })
    }

    /// How deep a point is inside the trunk, and the way out. `world`: the joints of this avatar, in
    /// metres. `wide`: how much wider than it the trunk is that is meant.
    pub fn depth(&self, world: &[DAffine3], point: DVec3, wide: f64) -> Depth {
        let inside = self.sections.iter().filter_map(|section| {
            let joint = &world[section.joint];
            let local = joint.inverse().transform_point3(point);
            let at = (local.y - section.bottom) / SLICE;
            let slice = section.slices.get(at.floor().max(0.0) as usize)?;
            if at < 0.0 || slice.width == 0.0 {
                return None;
            }
            let flat = local.with_y(0.0);
            let depth = if local.z < 0.0 {
                slice.back
            } else {
                slice.front
            };
            let scaled = flat / (wide * DVec3::new(slice.width, 1.0, depth.max(1e-3)));
            let share = scaled.length();
            let way = flat.try_normalize()?;
            Some(Depth {
                metres: flat.length() * (1.0 / share - 1.0),
                out: joint.transform_vector3(way),
            })
        });
        inside
            .max_by(|a, b| a.metres.total_cmp(&b.metres))
            .unwrap_or(Depth {
                metres: f64::NEG_INFINITY,
                out: DVec3::ZERO,
            })
    }
}

/// How deep a point is inside a body.
#[derive(Clone, Copy, Debug)]
pub struct Depth {
    /// To the surface; below 0 outside.
    pub metres: f64,
    /// The direction to the surface.
    pub out: DVec3,
}

fn section(points: &Points, joint: usize) -> Option<TrunkSection> {
    let mut own: Vec<DVec3> = points
        .of_joint(joint)
        .filter(|at| at.y.abs() < TALLEST)
        .collect();
    own.sort_by(|a, b| a.y.total_cmp(&b.y));
    let bottom = own.first()?.y;
    let count = ((own.last()?.y - bottom) / SLICE).floor() as usize + 1;
    let mut above = &own[..];
    let slices = (0..count).map(|at| {
        let top = bottom + (at + 1) as f64 * SLICE;
        let (of_slice, rest) = above.split_at(above.partition_point(|at| at.y < top));
        above = rest;
        slice(of_slice)
    });
    Some(TrunkSection {
        joint,
        bottom,
        slices: slices.collect(),
    })
}

/// The outline of the points of a slice.
fn slice(points: &[DVec3]) -> TrunkSlice {
    if points.len() < FEWEST {
        return TrunkSlice::default();
    }
    let reach = |part: &dyn Fn(&DVec3) -> f64| {
        let values = points.iter().map(part).filter(|part| *part > 0.0);
        quantile(values.collect(), INSIDE)
    };
    TrunkSlice {
        width: reach(&|at| at.x.abs()),
        front: reach(&|at| at.z),
        back: reach(&|at| -at.z),
    }
}
