//! The demo avatar for unit tests: the package `effigy-demo` depends on this one.

use crate::avatar::{Avatar, Level, Rows};
use crate::io::file::FormatError;

pub fn avatar() -> Result<Avatar, FormatError> {
    Avatar::from_bytes(include_bytes!("../demo/demo.avatar"))
}

/// The demo with a level of a quarter, which networks move, and one of a 16th, which they don't;
/// neither was measured.
pub fn with_levels() -> Avatar {
    let mut avatar = avatar().expect("inside the program");
    let count = avatar.gaussians.len();
    avatar.levels = [4, 16]
        .map(|share| {
            let kept: Vec<usize> = (0..count / share).collect();
            Level {
                gaussians: avatar.gaussians.pick(&kept),
                part_start: vec![],
                correctives: share == 4,
                rotation_rows: Rows::default(),
                scale_rows: Rows::default(),
                color_rows: Rows::default(),
                sh: None,
                measured: vec![],
            }
        })
        .into();
    avatar
}
