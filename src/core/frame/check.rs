//! Checks of the numbers in poses and cameras.
//!
//! NaN, infinity and numbers out of range are rejected here, before anything reaches a device. A
//! broken tracker's pose or a degenerate camera gives an error that names the number instead of an
//! image of noise.

use crate::scene::{Camera, Posed};

/// Largest number in a pose or a camera, metres or px: numbers derived from it still fit f32.
pub const LARGEST: f64 = 1e15;
/// Smallest focal length, px, and nearest near plane, metres.
pub const SMALLEST: f64 = 1e-6;

/// A number that no frame can be drawn with, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what} is {found}, expected {expected}")]
pub struct Unusable {
    /// Which number, for example "the camera's near plane".
    pub what: String,
    /// The number that was found.
    pub found: String,
    /// The allowed values.
    pub expected: String,
}

/// Checks that every number is within ±[`LARGEST`], which NaN is not.
fn within(what: impl Fn(usize) -> String, numbers: &[f64]) -> Result<(), Unusable> {
    for (at, found) in numbers.iter().enumerate() {
        if !(-LARGEST..=LARGEST).contains(found) {
            return Err(Unusable {
                what: what(at),
                found: found.to_string(),
                expected: format!("a number within ±{LARGEST:e}"),
            });
        }
    }
    Ok(())
}

/// Checks that every number is from [`SMALLEST`] to [`LARGEST`].
fn between(what: &str, numbers: &[f64]) -> Result<(), Unusable> {
    for found in numbers {
        if !(SMALLEST..=LARGEST).contains(found) {
            return Err(Unusable {
                what: what.into(),
                found: found.to_string(),
                expected: format!("a number from {SMALLEST:e} to {LARGEST:e}"),
            });
        }
    }
    Ok(())
}

impl Camera {
    /// Checks that frames can be drawn through this camera.
    ///
    /// # Errors
    /// When a number is NaN, infinite or out of the range that f32 can work with, or the image has
    /// no pixels.
    pub fn check(&self) -> Result<(), Unusable> {
        within(|_| "the camera's view".into(), &self.view.to_cols_array())?;
        within(
            |_| "the camera's principal point".into(),
            &self.center.to_array(),
        )?;
        between("the camera's focal length", &self.focal.to_array())?;
        between("the camera's near plane", &[self.near])?;
        let [width, height] = self.size;
        if width == 0 || height == 0 {
            return Err(Unusable {
                what: "the camera's image".into(),
                found: format!("{width} × {height} px"),
                expected: "at least one pixel".into(),
            });
        }
        Ok(())
    }
}

impl Posed {
    /// Checks that this pose can be drawn.
    ///
    /// # Errors
    /// When a joint's matrix or the networks' input has a number that is NaN, infinite or out of
    /// the range that f32 can work with.
    pub fn check(&self) -> Result<(), Unusable> {
        for (joint, matrix) in self.joints.iter().enumerate() {
            within(
                |_| format!("the matrix of joint {joint}"),
                &matrix.to_cols_array(),
            )?;
        }
        within(
            |at| format!("number {at} of what the networks see of the pose"),
            &self.input,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DAffine3, DVec3};

    #[test]
    fn errors_name_the_number() {
        let mut posed = Posed {
            joints: vec![DAffine3::IDENTITY; 3],
            input: vec![0.0; 4],
            expression: 1,
        };
        assert_eq!(posed.check(), Ok(()));
        posed.input[2] = f64::NAN;
        assert_eq!(
            posed.check().map_err(|e| e.to_string()).unwrap_err(),
            "number 2 of what the networks see of the pose is NaN, expected a number within ±1e15"
        );
        posed.joints[1].translation.x = f64::NEG_INFINITY;
        assert!(
            posed
                .check()
                .is_err_and(|e| e.to_string().starts_with("the matrix of joint 1 is -inf"))
        );
    }

    #[test]
    fn degenerate_cameras_are_rejected() {
        let good = Camera::orbit(DVec3::ZERO, 0.0, 0.0, 2.0, 0.7, [8, 8]);
        assert_eq!(good.check(), Ok(()));
        let nowhere = Camera::orbit(DVec3::ZERO, f64::NAN, 0.0, 2.0, 0.7, [8, 8]);
        for bad in [
            nowhere,
            Camera { near: 0.0, ..good },
            Camera {
                focal: -good.focal,
                ..good
            },
            Camera {
                size: [0, 3],
                ..good
            },
        ] {
            assert!(bad.check().is_err(), "{bad:?}");
        }
    }
}
