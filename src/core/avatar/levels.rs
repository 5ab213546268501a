//! Levels of detail, drawn as avatars are.

use super::{Avatar, Filter, Level, Parts};

impl Level {
    /// The low-pass that levels are fitted for: at several samples a pixel, nothing needs more, and
    /// a Gaussian smaller than a sample must not gain mass.
    pub const FILTER: Filter = Filter {
        variance: 0.1,
        compensated: true,
    };
}

impl Avatar {
    /// The avatar with the Gaussians of one of its levels in place of its own, and without levels.
    /// All that draws an avatar draws it; it is meant to be drawn at several samples a pixel
    /// ([`LevelError::samples`](super::LevelError::samples)). Copies the networks and nodes.
    pub fn at_level(&self, level: &Level) -> Self {
        Self {
            name: self.name.clone(),
            credit: self.credit.clone(),
            skeleton: self.skeleton.clone(),
            gaussians: level.gaussians.clone(),
            parts: Parts {
                start: level.part_start.clone(),
                head: self.parts.head,
            },
            networks: self.networks.clone(),
            rotation_rows: level.rotation_rows.clone(),
            scale_rows: level.scale_rows.clone(),
            color_rows: level.color_rows.clone(),
            nodes: self.nodes.clone(),
            inputs: self.inputs.clone(),
            sh: level.sh.clone(),
            filter: Level::FILTER,
            levels: vec![],
        }
    }
}
