//! MakeHuman's painted masks (grey JPEG pictures over the body's texture coordinates) in; how much of a feature a point has, out.

use super::body::Assets;
use super::text::Error;
use glam::DVec2;
use image::GrayImage;

/// One mask.
#[derive(Clone, Debug)]
pub struct Mask(GrayImage);

impl Mask {
    fn load(assets: &Assets, name: &str) -> Result<Self, Error> {
        let file = assets.path(&format!("masks/{name}.jpg"));
        let bytes = std::fs::read(&file).map_err(|source| Error::Io { file: file.clone(), source })?;
        let picture = image::load_from_memory_with_format(&bytes, image::ImageFormat::Jpeg);
        let picture = picture.map_err(|error| Error::Content { file, found: error.to_string(), expected: "a JPEG picture".into() })?;
        Ok(Self(picture.into_luma8()))
    }

    /// 0 to 1, bilinear; texture coordinates start at the lower left corner.
    pub fn at(&self, uv: DVec2) -> f64 {
        let size = DVec2::new(f64::from(self.0.width()), f64::from(self.0.height()));
        let p = (DVec2::new(uv.x, 1.0 - uv.y) * size - 0.5).clamp(DVec2::ZERO, (size - 1.0).max(DVec2::ZERO));
        let (low, t) = (p.floor(), p.fract());
        let high = (low + 1.0).min(size - 1.0);
        let value = |x: f64, y: f64| f64::from(self.0.get_pixel(x as u32, y as u32).0[0]) / 255.0;
        let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
        mix(mix(value(low.x, low.y), value(high.x, low.y), t.x), mix(value(low.x, high.y), value(high.x, high.y), t.x), t.y)
    }
}

/// The masks in use.
#[derive(Clone, Debug)]
pub struct Masks {
    pub lips: Mask,
    pub ears: Mask,
    pub nails: Mask,
    pub eyelids: Mask,
    /// Inside of the mouth.
    pub mouth: Mask,
}

impl Masks {
    pub fn load(assets: &Assets) -> Result<Self, Error> {
        Ok(Self {
            lips: Mask::load(assets, "lips")?,
            ears: Mask::load(assets, "ears")?,
            nails: Mask::load(assets, "fingernails")?,
            eyelids: Mask::load(assets, "eyelids")?,
            mouth: Mask::load(assets, "inside-mouth")?,
        })
    }
}
