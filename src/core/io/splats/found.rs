//! The result of reading a file.

use super::{
    Splats,
    far::{far_middle, moved},
};
use crate::io::{assumption::Assumption, file::FormatError};

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

impl Found {
    /// The splats that keep the rules of [`Splats::check`], and how many were left out. A scene
    /// that is far from the origin is moved there.
    ///
    /// # Errors
    /// When no splat keeps the rules, or there are too many.
    pub fn sound(mut self) -> Result<Self, FormatError> {
        let splats = &mut self.splats;
        let at = |k: usize| splats.position[k].map(f64::from);
        if let Some(middle) = far_middle(splats.len(), at) {
            for position in &mut splats.position {
                *position = std::array::from_fn(|k| (f64::from(position[k]) - middle[k]) as f32);
            }
            self.assumptions.push(moved(middle));
        }
        let count = splats.len();
        if let Some(left_out) = splats.leave_out_bad()? {
            self.assumptions.push(Assumption {
                what: "splats that can't be drawn",
                taken: format!("{} of {count} left out", left_out.count),
                because: format!("number {} has {}", left_out.first, left_out.why),
            });
        }
        Ok(self)
    }
}
