//! MakeHuman's painted masks: grey JPEG images over the body's texture coordinates, which say how
//! much of a feature a point has.

use crate::bake::source::assets::Assets;
use crate::bake::source::text::SourceError;
use glam::DVec2;
use image::GrayImage;

/// One mask.
#[derive(Clone, Debug)]
pub struct SurfaceMask(GrayImage);

impl SurfaceMask {
    fn load(assets: &Assets, name: &str) -> Result<Self, SourceError> {
        let file = assets.path(&format!("masks/{name}.jpg"));
        let bytes = std::fs::read(&file).map_err(|source| SourceError::Io {
            file: file.clone(),
            source,
        })?;
        let image = image::load_from_memory_with_format(&bytes, image::ImageFormat::Jpeg);
        let image = image.map_err(|error| SourceError::Content {
            file,
            found: error.to_string(),
            expected: "a JPEG image".into(),
        })?;
        Ok(Self(image.into_luma8()))
    }

    /// The mask's value, 0 to 1, interpolated bilinearly. Texture coordinates start at the lower
    /// left corner.
    pub fn at(&self, uv: DVec2) -> f64 {
        let size = DVec2::new(f64::from(self.0.width()), f64::from(self.0.height()));
        let p = (DVec2::new(uv.x, 1.0 - uv.y) * size - 0.5)
            .clamp(DVec2::ZERO, (size - 1.0).max(DVec2::ZERO));
        let low = p.floor();
        let t = p.fract();
        let high = (low + 1.0).min(size - 1.0);
        let value = |x: f64, y: f64| f64::from(self.0.get_pixel(x as u32, y as u32).0[0]) / 255.0;
        let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
        mix(
            mix(value(low.x, low.y), value(high.x, low.y), t.x),
            mix(value(low.x, high.y), value(high.x, high.y), t.x),
            t.y,
        )
    }
}

/// The masks in use.
#[derive(Clone, Debug)]
pub struct SurfaceMasks {
    /// Lips.
    pub lips: SurfaceMask,
    /// Ears.
    pub ears: SurfaceMask,
    /// Fingernails.
    pub nails: SurfaceMask,
    /// Eyelids.
    pub eyelids: SurfaceMask,
    /// Inside of the mouth.
    pub mouth: SurfaceMask,
}

impl SurfaceMasks {
    /// Reads all masks.
    ///
    /// # Errors
    /// When a file is missing or damaged.
    pub fn load(assets: &Assets) -> Result<Self, SourceError> {
        Ok(Self {
            lips: SurfaceMask::load(assets, "lips")?,
            ears: SurfaceMask::load(assets, "ears")?,
            nails: SurfaceMask::load(assets, "fingernails")?,
            eyelids: SurfaceMask::load(assets, "eyelids")?,
            mouth: SurfaceMask::load(assets, "inside-mouth")?,
        })
    }
}
