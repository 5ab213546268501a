//! Pictures in linear light, before a camera has made numbers of them.

use effigy_capture::Picture;
use effigy_math::color::encode_srgb;
use glam::DVec3;

/// What stands behind the person: grey paper, linear RGB. sRGB 118, 120, 122.
pub const BACKDROP: DVec3 = DVec3::new(0.1812, 0.1878, 0.1946);

/// A picture in rows from the upper left.
#[derive(Clone, Debug)]
pub struct LinearImage {
    /// Width and height, px.
    pub size: [u32; 2],
    /// Linear RGB, over the backdrop.
    pub light: Vec<DVec3>,
    /// The share of each pixel that is the person, 0 to 1.
    pub coverage: Vec<f32>,
}

impl LinearImage {
    /// The backdrop alone.
    pub fn empty(size: [u32; 2]) -> Self {
        let pixels = size[0] as usize * size[1] as usize;
        Self {
            size,
            light: vec![BACKDROP; pixels],
            coverage: vec![0.0; pixels],
        }
    }

    /// The picture as files have it. `noise`: what a sensor adds to each encoded channel, 0 to 1.
    pub fn encode(&self, mut noise: impl FnMut() -> f64) -> Picture {
        let byte = |v: f64| (255.0 * v).round().clamp(0.0, 255.0) as u8;
        let color = self.light.iter().map(|light| {
            encode_srgb(*light)
                .to_array()
                .map(|channel| byte(channel + noise()))
        });
        Picture {
            size: self.size,
            color: color.collect(),
            mask: self.coverage.iter().map(|&c| byte(f64::from(c))).collect(),
        }
    }
}
