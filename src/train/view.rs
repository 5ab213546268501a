//! A view that a step learns from: a pose, a camera, and the picture that it took.

use effigy_core::scene::Camera;
use glam::{DAffine3, DVec3};
use std::sync::Arc;

/// What a pixel of a picture shows, as a picture's alpha has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Shows {
    /// Nothing that is known: it counts for nothing.
    Unknown = 0,
    /// What is behind the person, in whose place the picture has another colour.
    Background = 85,
    /// The mask's edge: some of the person, before what is behind in the picture itself.
    Edge = 170,
    /// The person.
    Person = 255,
}

/// A picture of a person, or a part of one, and what it is compared over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ViewPicture {
    /// Width and height, px.
    pub size: [u32; 2],
    /// RGB, and what the pixel shows: a [`Shows`]. Rows from the top.
    pub pixels: Vec<[u8; 4]>,
    /// RGB behind the avatar at each pixel. Alpha is not used.
    pub behind: Vec<[u8; 4]>,
}

impl ViewPicture {
    /// What a pixel shows.
    pub fn shows(&self, pixel: usize) -> Shows {
        match self.pixels[pixel][3] {
            0..43 => Shows::Unknown,
            43..128 => Shows::Background,
            128..213 => Shows::Edge,
            _ => Shows::Person,
        }
    }

    /// A pixel's colour, 0 to 1.
    pub fn color(&self, pixel: usize) -> DVec3 {
        unit(self.pixels[pixel])
    }

    /// The colour behind the avatar at a pixel, 0 to 1.
    pub fn background(&self, pixel: usize) -> DVec3 {
        unit(self.behind[pixel])
    }
}

fn unit([r, g, b, _]: [u8; 4]) -> DVec3 {
    DVec3::from([r, g, b].map(|v| f64::from(v) / 255.0))
}

/// A view: a pose, a camera, and the picture that it took.
#[derive(Clone, Debug)]
pub struct TrainingView {
    /// G_j: canonical space to world, one a joint.
    pub joints: Vec<DAffine3>,
    /// θ_p ⊕ θ_e.
    pub input: Vec<f64>,
    /// Its image has the picture's size.
    pub camera: Camera,
    /// What the camera multiplies the avatar's light by, RGB: its exposure and white balance. 1
    /// where nothing is known of it.
    pub gain: DVec3,
    /// Pixels of the whole picture that this is a part of: losses are means over those, so that
    /// cutting away what is empty does not change their balance.
    pub whole: u64,
    /// The picture.
    pub picture: Arc<ViewPicture>,
}
