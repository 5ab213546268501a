//! What a network sees of a picture at one depth.

/// Feature maps: a plane a channel.
#[derive(Clone, Debug)]
pub struct Maps {
    pub channels: usize,
    /// Width and height.
    pub size: [usize; 2],
    /// Shape: channels · height · width.
    pub data: Vec<f32>,
}

impl Maps {
    pub fn zeros(channels: usize, size: [usize; 2]) -> Self {
        Self {
            channels,
            size,
            data: vec![0.0; channels * size[0] * size[1]],
        }
    }

    /// Numbers of a plane.
    pub fn plane(&self) -> usize {
        self.size[0] * self.size[1]
    }
}
