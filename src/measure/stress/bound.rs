//! How far the image of a case may be from the reference's.
//!
//! The bounds are measured: the worst of the 2,000 cases of seed 7 on lavapipe and of some hundred
//! on SwiftShader, with a tolerance.

use super::{case::StressCase, category::Category};
use effigy::vulkan::{raster::ColorFormat, sort::KeyBits};
use effigy_core::{frame::Skip, scene::AvatarBounds};
use serde::Serialize;

/// At more than this many times its own size away, an avatar's depths have too few steps in f32 to
/// keep Gaussians that overlap in any order.
const FAR: f64 = 2000.0;

/// The largest error of an image, over the covered pixels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ErrorBound {
    /// Lowest PSNR against the model as device memory holds it, dB: a bound of the device's
    /// arithmetic.
    pub psnr_db: f64,
    /// Lowest PSNR against the model as the file has it, dB, if that of the arithmetic is not
    /// lower.
    pub model_db: f64,
    /// Largest error of any channel, 0 to 1. 1 if Gaussians may change places within one step of
    /// their depth keys.
    pub max_error: f64,
}

impl ErrorBound {
    /// The bound of a case.
    pub fn for_case(case: &StressCase) -> Self {
        let category = case.category;
        let options = &case.options;
        let exact = if relative_distance(case) > FAR {
            Self {
                psnr_db: 20.0,
                model_db: 18.0,
                max_error: 0.3,
            }
        } else {
            Self::with_exact_options(category)
        };
        let mut psnr_db = exact.psnr_db;
        // Every faint layer is rounded; one fainter than a step always the same way.
        if options.color == Some(ColorFormat::Rgba8) {
            let has_faint_layers = matches!(
                category,
                Category::Sizes | Category::Views | Category::Mixed | Category::Torn
            );
            psnr_db = psnr_db.min(if has_faint_layers { 26.0 } else { 34.0 });
        }
        // Gaussians closer together than a step of the keys change places. A step is micrometres to
        // millimetres, depending on the avatar's depth.
        if options.keys() == KeyBits::Sixteen {
            psnr_db = psnr_db.min(32.0);
        }
        // Gaussians behind the occluder may show a little through the shell and at its edges. Only
        // solid bodies have an occluder.
        let is_solid = matches!(category, Category::Solid | Category::Torn);
        if is_solid && options.skip.intersects(Skip::HIDDEN | Skip::DEPTH) {
            psnr_db = psnr_db.min(34.0);
        }
        let max_error = if psnr_db < exact.psnr_db {
            1.0
        } else {
            exact.max_error
        };
        Self {
            psnr_db,
            max_error,
            ..exact
        }
    }

    /// The bound with nothing skipped, keys of 24 bits or more and floating-point images.
    fn with_exact_options(category: Category) -> Self {
        let [psnr_db, max_error] = match category {
            // Correctives of kilometres: most Gaussians share the few keys beyond the body's range,
            // so all that is checked is that the image is finite.
            Category::Overflow => [0.0, 1.0],
            // Depths a kilometre away have too few steps in f32 to separate Gaussians that nearly
            // touch.
            Category::Distant => [44.0, 0.2],
            // Splats lie on a grid of 1/32 px in images of 8192 px, and few pixels are covered.
            Category::Sizes => [44.0, 0.1],
            Category::Poses | Category::Mixed | Category::Quaternions => [46.0, 0.1],
            Category::Views => [48.0, 0.06],
            // Thousands of Gaussians on a hundred pixels: tens of layers each.
            Category::Solid | Category::Torn => [43.0, 0.06],
            Category::SubPixel => [47.0, 0.06],
            Category::Placed
            | Category::Needles
            | Category::Opacity
            | Category::Colors
            | Category::Refused => [50.0, 0.06],
            Category::Inside | Category::ScreenFilling => [54.0, 0.03],
            Category::NearPlane => [65.0, 0.01],
        };
        // The model's rounding (layout::compact) moves Gaussians by micrometres. That shows most
        // through a lens of 1°, and changes the order in clouds. Expressions a thousand times too
        // strong turn it into centimetres.
        let model_db = match category {
            Category::Overflow => 0.0,
            Category::Poses => 9.0,
            Category::Views | Category::Mixed => 12.0,
            _ => 24.0,
        };
        Self {
            psnr_db,
            model_db,
            max_error,
        }
    }
}

/// Distance of the avatar from the camera, as a multiple of its own size.
fn relative_distance(case: &StressCase) -> f64 {
    let [min, max] = AvatarBounds::new(&case.avatar).bounds(&case.posed.joints);
    case.camera
        .view
        .transform_point3((min + max) / 2.0)
        .length()
        / (max - min).length()
}
