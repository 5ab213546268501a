//! What a step looks at: a pose, a camera, and the picture that it took.

use effigy_core::scene::Camera;
use glam::{DAffine3, DVec3};
use std::sync::Arc;

/// What a pixel of a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// What is behind the person: the background stands in its place.
    Background,
    /// Neither for sure: it counts for nothing.
    Unsure,
    /// The person.
    Person,
}

/// A picture of a person, or a part of one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width and height, px.
    pub size: [u32; 2],
    /// RGB, and what the pixel shows: 0 background, 128 unsure, 255 the person. Rows from the top.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// What a pixel shows.
    pub fn shows(&self, pixel: usize) -> Shows {
        match self.pixels[pixel][3] {
            0..64 => Shows::Background,
            64..192 => Shows::Unsure,
            _ => Shows::Person,
        }
    }
}

/// A view: a pose, a camera, and the picture that it took.
#[derive(Clone, Debug)]
pub struct View {
    /// G_j: canonical space to world, one a joint.
    pub joints: Vec<DAffine3>,
    /// θ_p ⊕ θ_e.
    pub input: Vec<f64>,
    /// Its image has the picture's size.
    pub camera: Camera,
    /// RGB behind the avatar, 0 to 1.
    pub background: DVec3,
    /// What the camera multiplies the avatar's light by, RGB: its exposure and white balance. 1
    /// where nothing is known of it.
    pub gain: DVec3,
    /// Pixels of the whole picture that this is a part of: losses are means over those, so that
    /// cutting away what is empty does not change their balance.
    pub whole: u64,
    /// The picture.
    pub picture: Arc<Picture>,
}
