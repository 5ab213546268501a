//! Pictures as losses take them, and what they give back.

/// A picture, a plane a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Planes {
    /// Width and height, px.
    pub size: [usize; 2],
    /// Red, green and blue, 0 to 1, each row by row from the top. Shape: 3 · height · width.
    pub data: Vec<f32>,
}

impl Planes {
    /// A black picture. `size`: width and height, px.
    pub fn black(size: [usize; 2]) -> Self {
        Self {
            size,
            data: vec![0.0; 3 * size[0] * size[1]],
        }
    }

    /// Whether there are as many numbers as the size says.
    pub(crate) fn is_whole(&self) -> bool {
        self.data.len() == 3 * self.size[0] * self.size[1]
    }
}

/// A distance from a target and its gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct Graded {
    /// 0 for equal pictures; never negative.
    pub value: f64,
    /// Its derivative with respect to each number of the picture.
    pub gradient: Planes,
}
