//! The axis of a splat file that points up.

use crate::io::assumption::Assumption;
use glam::DQuat;
use std::f64::consts::FRAC_PI_2;

/// The axis of a file that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// +y.
    Y,
    /// −y.
    MinusY,
    /// +z.
    Z,
    /// −z.
    MinusZ,
}

impl Up {
    /// The axis of 3DGS: its world is that of COLMAP's first camera, whose y points down.
    pub const TRAINED: Self = Self::MinusY;

    /// The name of an assumption about it.
    pub const QUESTION: &str = "axis that points up";

    /// That [`Self::TRAINED`] was taken, since a file names no axis.
    pub fn assumed() -> Assumption {
        Assumption {
            what: Self::QUESTION,
            taken: "-y".into(),
            because: "the file names none, and 3DGS trains so; if it lies or stands on its head: \
                      --up y, --up z or --up -z"
                .into(),
        }
    }

    /// The names that files and command lines give the axes, in the order of [`Self::ALL`].
    pub const NAMES: [&str; 4] = ["y", "-y", "z", "-z"];
    /// Every axis.
    pub const ALL: [Self; 4] = [Self::Y, Self::MinusY, Self::Z, Self::MinusZ];

    /// The axis of a name in [`Self::NAMES`].
    pub fn from_name(name: &str) -> Option<Self> {
        let index = Self::NAMES.iter().position(|known| *known == name)?;
        Some(Self::ALL[index])
    }

    /// The rotation about x that makes y point up. A person in front of COLMAP's first camera then
    /// faces +z.
    pub fn rotation(self) -> DQuat {
        let quarters = match self {
            Self::Y => 0.0,
            Self::MinusY => 2.0,
            Self::Z => -1.0,
            Self::MinusZ => 1.0,
        };
        DQuat::from_rotation_x(quarters * FRAC_PI_2)
    }
}
