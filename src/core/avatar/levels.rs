//! Levels of detail, drawn as avatars are.

use super::{Avatar, Filter, Inputs, Level, Networks, Nodes, Parts};

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
    /// ([`LevelError::samples`](super::LevelError::samples)). Copies the networks and nodes if the
    /// level has correctives; if not, it has one node, which moves nothing.
    pub fn at_level(&self, level: &Level) -> Self {
        let mut drawn = Self {
            name: self.name.clone(),
            credit: self.credit.clone(),
            skeleton: self.skeleton.clone(),
            gaussians: level.gaussians.clone(),
            parts: Parts {
                start: level.part_start.clone(),
                head: self.parts.head,
            },
            networks: Networks {
                activation: self.networks.activation,
                layers: vec![],
            },
            rotation_rows: level.rotation_rows.clone(),
            scale_rows: level.scale_rows.clone(),
            color_rows: level.color_rows.clone(),
            nodes: Nodes::still(),
            inputs: Inputs::none(),
            sh: level.sh.clone(),
            filter: Level::FILTER,
            levels: vec![],
        };
        if level.correctives {
            drawn.networks = self.networks.clone();
            drawn.nodes = self.nodes.clone();
            drawn.inputs = self.inputs.clone();
        }
        drawn
    }
}
