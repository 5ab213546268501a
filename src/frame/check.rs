//! What a frame may be made of: a pose and a camera go in, nothing comes out, or one sentence on the first number that can't be drawn.
//!
//! NaN and infinity are refused here, in one place, before anything reaches a device: a pose that a broken tracker made, or a camera
//! that looks from nowhere, is an error that says what was found and not a picture of noise.

use super::{Camera, Posed};

/// Largest number in a pose or a camera, metres or px: what follows from it still fits f32.
pub const LARGEST: f64 = 1e15;
/// Smallest focal length, px, and nearest near plane, metres.
pub const SMALLEST: f64 = 1e-6;

/// A number that no frame can be drawn with.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what} is {found}, expected {expected}")]
pub struct Unusable {
    pub what: String,
    pub found: String,
    pub expected: String,
}

/// Every number is within ±[`LARGEST`], which NaN is not.
fn within(what: impl Fn(usize) -> String, numbers: &[f64]) -> Result<(), Unusable> {
    match numbers.iter().enumerate().find(|(_, number)| number.abs().partial_cmp(&LARGEST).is_none_or(|order| order.is_gt())) {
        Some((at, found)) => Err(Unusable { what: what(at), found: found.to_string(), expected: format!("a number within ±{LARGEST:e}") }),
        None => Ok(()),
    }
}

fn between(what: &str, numbers: &[f64]) -> Result<(), Unusable> {
    match numbers.iter().find(|number| !(SMALLEST..=LARGEST).contains(*number)) {
        Some(found) => {
            Err(Unusable { what: what.into(), found: found.to_string(), expected: format!("a number from {SMALLEST:e} to {LARGEST:e}") })
        }
        None => Ok(()),
    }
}

impl Camera {
    /// Whether anything can be drawn through this camera.
    ///
    /// # Errors
    /// When a number is NaN, infinite or out of the range that f32 can work with, or the picture has no pixels.
    pub fn check(&self) -> Result<(), Unusable> {
        within(|_| "the camera's view".into(), &self.view.to_cols_array())?;
        within(|_| "the camera's principal point".into(), &self.center.to_array())?;
        between("the camera's focal length", &self.focal.to_array())?;
        between("the camera's near plane", &[self.near])?;
        match self.size {
            [0, _] | [_, 0] => Err(Unusable {
                what: "the camera's picture".into(),
                found: format!("{} × {} px", self.size[0], self.size[1]),
                expected: "at least one pixel".into(),
            }),
            _ => Ok(()),
        }
    }
}

impl Posed {
    /// Whether this pose can be drawn.
    ///
    /// # Errors
    /// When a joint's matrix or what the networks see has a number that is NaN, infinite or out of the range that f32 can work with.
    pub fn check(&self) -> Result<(), Unusable> {
        for (joint, matrix) in self.joints.iter().enumerate() {
            within(|_| format!("the matrix of joint {joint}"), &matrix.to_cols_array())?;
        }
        within(|at| format!("number {at} of what the networks see of the pose"), &self.input)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DAffine3, DVec3};

    #[test]
    fn what_is_not_a_number_is_named() {
        let mut posed = Posed { joints: vec![DAffine3::IDENTITY; 3], input: vec![0.0; 4], expression: 1 };
        assert_eq!(posed.check(), Ok(()));
        posed.input[2] = f64::NAN;
        assert_eq!(
            posed.check().map_err(|e| e.to_string()).unwrap_err(),
            "number 2 of what the networks see of the pose is NaN, expected a number within ±1e15"
        );
        posed.joints[1].translation.x = f64::NEG_INFINITY;
        assert!(posed.check().is_err_and(|e| e.to_string().starts_with("the matrix of joint 1 is -inf")));
    }

    #[test]
    fn cameras_that_see_nothing_are_refused() {
        let good = Camera::orbit(DVec3::ZERO, 0.0, 0.0, 2.0, 0.7, [8, 8]);
        assert_eq!(good.check(), Ok(()));
        let nowhere = Camera::orbit(DVec3::ZERO, f64::NAN, 0.0, 2.0, 0.7, [8, 8]);
        for bad in [nowhere, Camera { near: 0.0, ..good }, Camera { focal: -good.focal, ..good }, Camera { size: [0, 3], ..good }] {
            assert!(bad.check().is_err(), "{bad:?}");
        }
    }
}
