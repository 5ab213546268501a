//! Which way is up in a capture, and how long its unit is.

use super::{humanoid::Humanoid, tree::positions};
use crate::capture::Capture;
use glam::{DAffine3, DQuat, DVec3};

/// From between the feet to the head; without legs, from the hips.
fn feet_to_head(humanoid: &Humanoid, at: &[DVec3]) -> DVec3 {
    let feet = humanoid.middle_of_feet(at);
    at[humanoid.head] - feet.unwrap_or(at[humanoid.hips])
}

/// Whether joints stand as a body does: feet under knees under hips under the head.
fn stands(humanoid: &Humanoid, at: &[DVec3], up: DVec3) -> bool {
    let feet_to_head = feet_to_head(humanoid, at);
    let height = feet_to_head.dot(up);
    let higher = |a: usize, b: usize, share: f64| (at[a] - at[b]).dot(up) > share * height;
    height > 0.7 * feet_to_head.length()
        && higher(humanoid.head, humanoid.chest(), 0.05)
        && humanoid.legs().iter().all(|leg| {
            higher(leg.thigh, leg.shin, 0.12)
                && higher(leg.shin, leg.foot, 0.12)
                && higher(humanoid.head, leg.thigh, 0.3)
        })
}

/// The axes of a file, either way, those first that more files have up.
pub const AXES: [DVec3; 6] = [
    DVec3::Y,
    DVec3::Z,
    DVec3::NEG_Y,
    DVec3::NEG_Z,
    DVec3::X,
    DVec3::NEG_X,
];

/// The axis along which the rest pose stands, which need not be the motion's: SMPL rests with y up
/// whatever its motion does. None: it does not stand.
pub fn rest_up(capture: &Capture, humanoid: &Humanoid, motion: DVec3) -> Option<DVec3> {
    let rest = positions(&capture.rest());
    let mut either = [motion].into_iter().chain(AXES);
    either.find(|up| stands(humanoid, &rest, *up))
}

/// Turns a file's axes so that +y points up, and as little as possible.
pub fn to_y_up(up: DVec3) -> DAffine3 {
    DAffine3::from_quat(if up == -DVec3::Y {
        DQuat::from_rotation_x(std::f64::consts::PI)
    } else {
        DQuat::from_rotation_arc(up, DVec3::Y)
    })
}

/// A capture in axes whose y points up, looked at joint by joint.
pub struct Upright<'a> {
    capture: &'a Capture,
    up: DVec3,
    to_y_up: DAffine3,
}

impl<'a> Upright<'a> {
    /// `up`: the capture's axis that points up.
    pub fn new(capture: &'a Capture, up: DVec3) -> Self {
        Self {
            capture,
            up,
            to_y_up: to_y_up(up),
        }
    }

    /// The capture as in its file.
    pub fn capture(&self) -> &'a Capture {
        self.capture
    }

    /// The capture's axis that points up.
    pub fn up(&self) -> DVec3 {
        self.up
    }

    /// Joints to world in the rest pose; the file's unit.
    pub fn rest(&self) -> Vec<DAffine3> {
        self.turn(self.capture.rest())
    }

    /// Joints to world in a frame; the file's unit.
    pub fn world(&self, frame: usize) -> Vec<DAffine3> {
        self.turn(self.capture.world(frame))
    }

    /// Joints to world at a moment, seconds; the file's unit.
    pub fn world_at(&self, seconds: f64) -> Vec<DAffine3> {
        self.turn(self.capture.world_at(seconds))
    }

    fn turn(&self, mut world: Vec<DAffine3>) -> Vec<DAffine3> {
        for joint in &mut world {
            *joint = self.to_y_up * *joint;
        }
        world
    }
}

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Its name.
    pub name: &'static str,
    /// Metres.
    pub metres: f64,
}

/// Units of captures.
const UNITS: [Unit; 6] = [
    Unit {
        name: "metres",
        metres: 1.0,
    },
    Unit {
        name: "centimetres",
        metres: 0.01,
    },
    Unit {
        name: "millimetres",
        metres: 0.001,
    },
    Unit {
        name: "inches",
        metres: 0.0254,
    },
    Unit {
        name: "CMU's units of 1/0.45 inch",
        metres: 0.0254 / 0.45,
    },
    Unit {
        name: "decimetres",
        metres: 0.1,
    },
];
/// Length of thigh and shin of most people, metres.
const LEG: f64 = 0.82;

/// The unit in which these legs, thigh and shin, are most like a person's.
pub fn unit(leg: f64) -> Unit {
    let far = |unit: &Unit| (leg * unit.metres / LEG).ln().abs();
    UNITS
        .into_iter()
        .min_by(|a, b| far(a).total_cmp(&far(b)))
        .unwrap_or(UNITS[0])
}

/// A unit that a file says.
pub fn said_unit(metres: f64) -> Unit {
    let same = |unit: &Unit| (unit.metres / metres - 1.0).abs() < 1e-3;
    UNITS.into_iter().find(same).unwrap_or(Unit {
        name: "its own units",
        metres,
    })
}
