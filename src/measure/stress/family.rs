//! The families of stress cases: what each is hard on, and how far its pictures may be from the reference's.
//!
//! The bounds are measured, not wished for: the worst of the 2,000 cases of seed 7 on lavapipe and of some hundred on SwiftShader, with room.

use super::case::Case;
use crate::{
    frame::{Extent, Skip},
    vulkan::{raster::ColorFormat, sort::KeyBits},
};
use serde::Serialize;

/// So many times its own size away, an avatar's depths have too few steps in f32 to keep any order among Gaussians that overlap.
const FAR: f64 = 2000.0;

/// What a case is hard on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    Poses,
    Placed,
    Distant,
    Quaternions,
    Needles,
    NearPlane,
    SubPixel,
    ScreenFilling,
    Opacity,
    Colors,
    Overflow,
    Inside,
    Sizes,
    Views,
    Mixed,
    Solid,
    Refused,
}

/// How far a picture may be from the reference's, over the covered pixels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bound {
    /// From that of the model as device memory holds it, which bounds the device's arithmetic: at least, dB.
    pub psnr_db: f64,
    /// From that of the model as the file has it, if the arithmetic does not leave less: at least, dB.
    pub model_db: f64,
    /// At most, of any channel, 0 to 1. 1 where Gaussians may change places within one step of their depth keys.
    pub max_error: f64,
}

impl Family {
    pub const ALL: [Self; 17] = [
        Self::Poses,
        Self::Placed,
        Self::Distant,
        Self::Quaternions,
        Self::Needles,
        Self::NearPlane,
        Self::SubPixel,
        Self::ScreenFilling,
        Self::Opacity,
        Self::Colors,
        Self::Overflow,
        Self::Inside,
        Self::Sizes,
        Self::Views,
        Self::Mixed,
        Self::Solid,
        Self::Refused,
    ];

    /// The family of a case: they take turns.
    pub fn of(number: u64) -> Self {
        Self::ALL[(number % Self::ALL.len() as u64) as usize]
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Poses => "poses",
            Self::Placed => "placed",
            Self::Distant => "distant",
            Self::Quaternions => "quaternions",
            Self::Needles => "needles",
            Self::NearPlane => "near plane",
            Self::SubPixel => "sub-pixel",
            Self::ScreenFilling => "screen-filling",
            Self::Opacity => "opacity",
            Self::Colors => "colours",
            Self::Overflow => "overflow",
            Self::Inside => "inside",
            Self::Sizes => "sizes",
            Self::Views => "views",
            Self::Mixed => "mixed",
            Self::Solid => "solid",
            Self::Refused => "refused",
        }
    }

    /// What its cases have in common.
    pub fn what(self) -> &'static str {
        match self {
            Self::Poses => "joint angles to π, beyond it, and to 10,000 turns",
            Self::Placed => "turned anywhere, scaled by 0.001 to 1000, up to 1 km from the origin",
            Self::Distant => "seen from up to 1 km away",
            Self::Quaternions => "rotations of nearly no length, that cancel out, that f16 can't hold",
            Self::Needles => "needles and sheets of 1:10,000",
            Self::NearPlane => "Gaussians on the near plane, before and behind it",
            Self::SubPixel => "Gaussians far smaller than a pixel, or without extent",
            Self::ScreenFilling => "Gaussians larger than the picture, up to those larger than f32 can square",
            Self::Opacity => "opacities 0, 1/255, 2/255 and 1",
            Self::Colors => "colours far out of range",
            Self::Overflow => "weights, biases and bases at f16's largest number",
            Self::Inside => "the camera inside the body",
            Self::Sizes => "pictures from 1 px to 8192 px a side",
            Self::Views => "fields of view from 1° to 170°",
            Self::Mixed => "several of these at once",
            Self::Solid => "a closed body, of which the depth surface leaves out what is inside and behind",
            Self::Refused => "NaN, infinity and other numbers that can't be drawn, in every input",
        }
    }

    /// With nothing left out, keys of 24 bits or more and floating-point pictures.
    fn exact(self) -> Bound {
        let [psnr_db, max_error] = match self {
            // Correctives of kilometres: most Gaussians share the few keys beyond the body's range, so this holds them to being finite.
            Self::Overflow => [0.0, 1.0],
            // Depths a kilometre away have too few steps in f32 to keep apart what nearly touches.
            Self::Distant => [44.0, 0.2],
            // Splats lie on a grid of 1/32 px in pictures of 8192 px, of which few pixels are covered.
            Self::Sizes => [44.0, 0.1],
            Self::Poses | Self::Mixed | Self::Quaternions => [46.0, 0.1],
            Self::Views => [48.0, 0.06],
            // Thousands of Gaussians on a hundred pixels: tens of layers each.
            Self::Solid => [43.0, 0.06],
            Self::SubPixel => [47.0, 0.06],
            Self::Placed | Self::Needles | Self::Opacity | Self::Colors | Self::Refused => [50.0, 0.06],
            Self::Inside | Self::ScreenFilling => [54.0, 0.03],
            Self::NearPlane => [65.0, 0.01],
        };
        // What the model's rounding (layout::compact) moves by micrometres shows most through a lens of 1°, and changes places in clouds;
        // expressions a thousand times too strong make centimetres of it.
        let model_db = match self {
            Self::Overflow => 0.0,
            Self::Poses => 9.0,
            Self::Views | Self::Mixed => 12.0,
            _ => 24.0,
        };
        Bound { psnr_db, model_db, max_error }
    }

    /// What a case's picture must keep.
    pub fn bound(self, case: &Case) -> Bound {
        let exact = if times_away(case) > FAR { Bound { psnr_db: 20.0, model_db: 18.0, max_error: 0.3 } } else { self.exact() };
        let mut psnr_db = exact.psnr_db;
        let options = &case.options;
        // Every faint layer is rounded, always the same way where it is fainter than a step.
        if options.color == Some(ColorFormat::Rgba8) {
            psnr_db = psnr_db.min(if matches!(self, Self::Sizes | Self::Views | Self::Mixed) { 26.0 } else { 34.0 });
        }
        // What is closer than a step of the keys changes places: micrometres to millimetres, by how deep the avatar is.
        if options.key_bits == KeyBits::Sixteen {
            psnr_db = psnr_db.min(32.0);
        }
        // What the surface hides may show through the shell a little, and at its edges. Clouds have none.
        if self == Self::Solid && options.skip.intersects(Skip::HIDDEN | Skip::DEPTH) {
            psnr_db = psnr_db.min(34.0);
        }
        let max_error = if psnr_db < exact.psnr_db { 1.0 } else { exact.max_error };
        Bound { psnr_db, max_error, ..exact }
    }
}

/// How many times its own size the avatar is away from the camera.
fn times_away(case: &Case) -> f64 {
    let [min, max] = Extent::new(&case.avatar).bounds(&case.posed.joints);
    case.camera.view.transform_point3((min + max) / 2.0).length() / (max - min).length()
}
