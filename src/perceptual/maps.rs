//! What a network sees of a picture at one depth.

use rayon::prelude::*;

/// Feature maps: a plane a channel.
#[derive(Clone, Debug)]
pub struct Maps {
    /// Channels.
    pub channels: usize,
    /// Width and height.
    pub size: [usize; 2],
    /// Shape: channels · height · width.
    pub data: Vec<f32>,
}

impl Maps {
    /// Zeros. `size`: width and height.
    pub fn zeros(channels: usize, size: [usize; 2]) -> Self {
        Self {
            channels,
            size,
            data: vec![0.0; channels * size[0] * size[1]],
        }
    }

    /// Maps of another size, a plane from each of these. `write` fills one, which is zeros, from
    /// the one that it is made of.
    pub fn mapped(&self, size: [usize; 2], write: impl Fn(&mut [f32], &[f32]) + Sync) -> Self {
        let mut new = Self::zeros(self.channels, size);
        let plane = new.plane();
        new.data
            .par_chunks_exact_mut(plane)
            .zip(self.data.par_chunks_exact(self.plane()))
            .for_each(|(into, own)| write(into, own));
        new
    }

    /// Numbers of a plane.
    pub fn plane(&self) -> usize {
        self.size[0] * self.size[1]
    }
}
