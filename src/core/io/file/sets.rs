//! The sets of Gaussians in an avatar's file: set 0 is the avatar's own, set k + 1 that of level k.
//! All have the same tensors, those of levels under names of their own.

use crate::avatar::{Avatar, Gaussians, Level, Rows, ShCoefficients};

/// Beginning of the names of a level's tensors.
pub const LEVEL_PREFIX: &str = "level.";

/// The beginning of the names of a set's tensors.
pub fn prefix(set: usize) -> String {
    match set.checked_sub(1) {
        None => String::new(),
        Some(level) => format!("{LEVEL_PREFIX}{level}."),
    }
}

/// The arrays of a set of Gaussians: the avatar's own, or a level's.
#[derive(Clone, Copy)]
pub struct SetArrays<'a> {
    /// The Gaussians.
    pub gaussians: &'a Gaussians,
    /// Their nodes; empty if no nodes move them.
    pub node: &'a [[u16; 3]],
    /// Where each part starts.
    pub part_start: &'a Vec<u32>,
    /// Correctives of the quaternion.
    pub rotation_rows: &'a Rows<4>,
    /// Correctives of the log scale.
    pub scale_rows: &'a Rows<3>,
    /// Correctives of the colour.
    pub color_rows: &'a Rows<3>,
    /// Spherical harmonics.
    pub sh: Option<&'a ShCoefficients>,
}

impl<'a> SetArrays<'a> {
    /// A set of an avatar.
    ///
    /// # Panics
    /// When there is no such set.
    pub fn new(avatar: &'a Avatar, set: usize) -> Self {
        match set.checked_sub(1) {
            None => Self {
                gaussians: &avatar.gaussians,
                node: &avatar.gaussians.node,
                part_start: &avatar.parts.start,
                rotation_rows: &avatar.rotation_rows,
                scale_rows: &avatar.scale_rows,
                color_rows: &avatar.color_rows,
                sh: avatar.sh.as_ref(),
            },
            Some(level) => Self::of_level(&avatar.levels[level]),
        }
    }

    fn of_level(level: &'a Level) -> Self {
        Self {
            gaussians: &level.gaussians,
            node: if level.correctives {
                &level.gaussians.node
            } else {
                &[]
            },
            part_start: &level.part_start,
            rotation_rows: &level.rotation_rows,
            scale_rows: &level.scale_rows,
            color_rows: &level.color_rows,
            sh: level.sh.as_ref(),
        }
    }

    /// All sets of an avatar.
    pub fn all(avatar: &'a Avatar) -> impl Iterator<Item = Self> {
        (0..=avatar.levels.len()).map(|set| Self::new(avatar, set))
    }
}
