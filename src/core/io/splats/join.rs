//! Splats of several files or parts of files as one scene.

use super::{Splats, functions_of};
use std::ops::Range;

impl Splats {
    /// Both, with harmonics up to the higher degree, and the axes and low-pass of the first.
    pub fn joined(mut self, mut other: Self) -> Self {
        let degree = self.degree.max(other.degree);
        self.widen(degree);
        other.widen(degree);
        self.position.extend(other.position);
        self.rotation.extend(other.rotation);
        self.log_scale.extend(other.log_scale);
        self.opacity.extend(other.opacity);
        self.color.extend(other.color);
        self.harmonics.extend(other.harmonics);
        self
    }

    /// Some in a row. `range`: within those that there are.
    pub fn part(&self, range: Range<usize>) -> Self {
        let functions = functions_of(self.degree);
        let harmonics = functions * range.start..functions * range.end;
        Self {
            position: self.position[range.clone()].to_vec(),
            rotation: self.rotation[range.clone()].to_vec(),
            log_scale: self.log_scale[range.clone()].to_vec(),
            opacity: self.opacity[range.clone()].to_vec(),
            color: self.color[range].to_vec(),
            harmonics: self.harmonics[harmonics].to_vec(),
            ..*self
        }
    }

    /// Adds harmonics of 0 up to a degree.
    fn widen(&mut self, degree: usize) {
        let (own, wanted) = (functions_of(self.degree), functions_of(degree));
        if own < wanted {
            let mut harmonics = Vec::with_capacity(wanted * self.len());
            for k in 0..self.len() {
                harmonics.extend(&self.harmonics[own * k..][..own]);
                harmonics.extend(std::iter::repeat_n([0.0; 3], wanted - own));
            }
            self.harmonics = harmonics;
        }
        self.degree = degree;
    }
}
