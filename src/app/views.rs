//! Views that the number keys choose: sides of the avatar as it stands, and its face.

use effigy_core::{
    avatar::{Avatar, Pose},
    scene::Posed,
};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, PI};

/// A standard view of the avatar, relative to the way that it faces now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandardView {
    /// Key 1.
    Front,
    /// Key 2: the avatar's left.
    Left,
    /// Key 3.
    Back,
    /// Key 4: the avatar's right.
    Right,
    /// Key 5: from above.
    Top,
    /// Key 6: the head from the front.
    Face,
}

/// The box that a view shows, and the direction that it looks from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewTarget {
    /// Lower and upper corner of what it shows, metres.
    pub bounds: [DVec3; 2],
    /// Around the vertical axis, radians; 0 looks from +z.
    pub yaw: f64,
    /// Above the horizon, radians.
    pub pitch: f64,
}

/// Half the side of the box around a head, and how far its middle is above the head's joint, of the
/// height of the skeleton.
const HEAD: f64 = 0.1;
const HEAD_RISE: f64 = 0.07;

impl StandardView {
    /// In the order of their keys, from 1.
    pub const ALL: [Self; 6] = [
        Self::Front,
        Self::Left,
        Self::Back,
        Self::Right,
        Self::Top,
        Self::Face,
    ];

    /// The view of a posed avatar. `bounds`: the box around all of it, metres.
    pub fn of(self, avatar: &Avatar, posed: &Posed, bounds: [DVec3; 2]) -> ViewTarget {
        let head = head(avatar).filter(|_| self == Self::Face);
        let front = facing(avatar, posed, head.unwrap_or(0));
        let [turn, pitch] = match self {
            Self::Front | Self::Face => [0.0, 0.0],
            Self::Left => [FRAC_PI_2, 0.0],
            Self::Back => [PI, 0.0],
            Self::Right => [-FRAC_PI_2, 0.0],
            Self::Top => [0.0, FRAC_PI_2],
        };
        let bounds = match (self, head) {
            (Self::Face, Some(joint)) => head_box(avatar, posed, joint),
            (Self::Face, None) => top_of(bounds),
            _ => bounds,
        };
        ViewTarget {
            bounds,
            yaw: front + turn,
            pitch,
        }
    }
}

/// The head's joint, by its name.
fn head(avatar: &Avatar) -> Option<usize> {
    let names = &avatar.skeleton.name;
    names
        .iter()
        .position(|name| name.to_lowercase().ends_with("head"))
}

/// Where a joint faces, as a yaw; 0 as at rest.
fn facing(avatar: &Avatar, posed: &Posed, joint: usize) -> f64 {
    let rest = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
    let rest = avatar.skeleton.matrices(&rest);
    let (Some(now), Some(rest)) = (posed.joints.get(joint), rest.get(joint)) else {
        return 0.0;
    };
    let front = now.matrix3 * rest.matrix3.inverse() * DVec3::Z;
    front.x.atan2(front.z)
}

fn head_box(avatar: &Avatar, posed: &Posed, joint: usize) -> [DVec3; 2] {
    let rest = &avatar.skeleton.rest;
    let heights = rest.iter().map(|at| f64::from(at[1]));
    let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| {
        [low.min(y), high.max(y)]
    });
    let height = high - low;
    let at = DVec3::from(rest[joint].map(f64::from)) + HEAD_RISE * height * DVec3::Y;
    let middle = posed.joints[joint].transform_point3(at);
    [middle - HEAD * height, middle + HEAD * height]
}

/// The upper seventh of a box.
fn top_of([min, max]: [DVec3; 2]) -> [DVec3; 2] {
    let low = max.y - (max.y - min.y) / 7.0;
    [DVec3::new(min.x, low, min.z), max]
}
