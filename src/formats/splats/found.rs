//! What a reader found.

use crate::assumption::Assumption;
use effigy_core::io::splats::Splats;

/// The splats of a file, and what could not be taken as it stands.
#[derive(Clone, Debug)]
pub struct Found {
    /// The splats.
    pub splats: Splats,
    /// What was assumed or left out.
    pub assumptions: Vec<Assumption>,
}

impl From<Splats> for Found {
    fn from(splats: Splats) -> Self {
        Self {
            splats,
            assumptions: vec![],
        }
    }
}
