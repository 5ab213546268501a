//! From where a Gaussian is drawn (docs/model.md, step 8): what never shows from behind is left out
//! there, before more of it is read than its place.

use crate::constants::{FACING_FADE, FACING_STEPS};
use glam::{DMat3, DVec3};

/// A cone of directions in three bytes: its axis by an octahedral map, 8 bits each, and its limit,
/// in [`FACING_STEPS`] from −1.125, where nothing fades, to 1, where nothing is drawn.
/// A Gaussian is drawn from where the cosine between the axis and the direction to the camera is
/// above the limit, and faded in over the [`FACING_FADE`] above it.
pub type FacingCode = [u8; 3];

/// The code of a Gaussian that is drawn from everywhere.
pub const EVERYWHERE: FacingCode = [0; 3];
/// The code of one that is drawn from nowhere.
pub const NOWHERE: FacingCode = [0, 0, 255];

/// Where a Gaussian faces, in the canonical pose or in a posed world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facing {
    /// The cone's axis. Its length is 1 in the canonical pose; skinning may change it.
    pub axis: DVec3,
    /// The cosine at which the Gaussian vanishes.
    pub limit: f64,
}

impl Facing {
    /// Drawn from everywhere.
    pub const EVERYWHERE: Self = Self {
        axis: DVec3::Z,
        limit: -1.0 - FACING_FADE,
    };

    /// What a code says, in the canonical pose.
    pub fn decode([u, v, limit]: FacingCode) -> Self {
        let [u, v] = [u, v].map(|code| f64::from(code) / 127.5 - 1.0);
        let z = 1.0 - u.abs() - v.abs();
        let below = (-z).max(0.0);
        let fold = |t: f64| if t >= 0.0 { t - below } else { t + below };
        Self {
            axis: DVec3::new(fold(u), fold(v), z).normalize(),
            limit: f64::from(limit) / FACING_STEPS - 1.0 - FACING_FADE,
        }
    }

    /// The nearest code whose Gaussian is drawn at least wherever this one is, but for the rounding
    /// of the axis: up to 1°.
    pub fn encode(self) -> FacingCode {
        let axis = self.axis.normalize_or(DVec3::Z);
        let [x, y, z] = (axis / (axis.x.abs() + axis.y.abs() + axis.z.abs())).to_array();
        let sign = |t: f64| if t >= 0.0 { 1.0 } else { -1.0 };
        let [u, v] = if z >= 0.0 {
            [x, y]
        } else {
            [(1.0 - y.abs()) * sign(x), (1.0 - x.abs()) * sign(y)]
        };
        let code = |t: f64| (127.5 * (t + 1.0)).round() as u8;
        let limit = (self.limit + 1.0 + FACING_FADE) * FACING_STEPS;
        [code(u), code(v), limit.floor() as u8]
    }

    /// This in the space that a matrix leads to.
    pub fn moved(self, matrix: &DMat3) -> Self {
        Self {
            axis: *matrix * self.axis,
            ..self
        }
    }

    /// How much of the opacity is left, 0 to 1, in the direction to the camera, of any length. Axis
    /// and direction are of one space.
    pub fn fade(self, to_camera: DVec3) -> f64 {
        let lengths = (self.axis.length_squared() * to_camera.length_squared()).sqrt();
        let cosine = self.axis.dot(to_camera) / lengths.max(f64::MIN_POSITIVE);
        ((cosine - self.limit) / FACING_FADE).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn codes_keep_the_axis_within_a_degree_and_round_limits_down() {
        let random = &mut Random::new(1, 0);
        for _ in 0..10_000 {
            let axis = DVec3::new(random.normal(), random.normal(), random.normal()).normalize();
            let facing = Facing {
                axis,
                limit: 2.0 * random.uniform() - 1.0,
            };
            let decoded = Facing::decode(facing.encode());
            assert!(decoded.axis.dot(axis) > 1f64.to_radians().cos(), "{axis}");
            let down = facing.limit - decoded.limit;
            assert!((0.0..1.0 / FACING_STEPS).contains(&down), "{facing:?}");
        }
    }

    #[test]
    fn the_extreme_codes_fade_nothing_and_all() {
        for axis in [DVec3::X, DVec3::NEG_Z, DVec3::new(1.0, -2.0, 0.5)] {
            assert_eq!(Facing::decode(EVERYWHERE).fade(axis), 1.0);
            assert_eq!(Facing::EVERYWHERE.fade(axis), 1.0);
            assert!(Facing::decode(NOWHERE).fade(axis) < 1e-12);
        }
        assert_eq!(Facing::EVERYWHERE.limit, Facing::decode(EVERYWHERE).limit);
    }
}
