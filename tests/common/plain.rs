//! An image by the rules of 3DGS' own rasterizer alone, written from its paper: what lies behind the
//! near plane is blended, nothing is culled by where it is, and no box or tile bounds a Gaussian.
//! It shares no code with the reference, so that what the reference leaves out is seen.

use effigy_core::{
    reference::Gaussian,
    scene::{Camera, FrameImage},
};
use glam::{DMat2, DMat3, DVec2, DVec3};

/// A Gaussian in the image.
struct Footprint {
    depth: f64,
    center: DVec2,
    inverse: DMat2,
    opacity: f64,
    color: DVec3,
}

/// The image of Gaussians by a camera whose axis meets the image's middle. `low_pass`: px².
pub fn render(gaussians: &[Gaussian], camera: &Camera, low_pass: f64) -> FrameImage {
    let mut footprints: Vec<Footprint> = gaussians
        .iter()
        .filter_map(|gaussian| footprint(gaussian, camera, low_pass))
        .collect();
    footprints.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    let [width, height] = camera.size;
    let pixel = |at: u32| {
        let place = DVec2::new(f64::from(at % width) + 0.5, f64::from(at / width) + 0.5);
        blend(&footprints, place)
    };
    FrameImage {
        size: camera.size,
        pixels: (0..width * height).map(pixel).collect(),
    }
}

/// Σ' = J W Σ Wᵀ Jᵀ + k I.
fn footprint(gaussian: &Gaussian, camera: &Camera, low_pass: f64) -> Option<Footprint> {
    let rotation = camera.view.matrix3;
    let mean = rotation * gaussian.mean + camera.view.translation;
    if mean.z <= camera.near {
        return None;
    }
    let size = DVec2::new(f64::from(camera.size[0]), f64::from(camera.size[1]));
    // x/z and y/z end at 1.3 times the tangent of half the field of view.
    let limit = 1.3 * 0.5 * size / camera.focal;
    let x = mean.z * (mean.x / mean.z).clamp(-limit.x, limit.x);
    let y = mean.z * (mean.y / mean.z).clamp(-limit.y, limit.y);
    let z = mean.z;
    let jacobian = DMat3::from_cols(
        DVec3::new(camera.focal.x / z, 0.0, 0.0),
        DVec3::new(0.0, camera.focal.y / z, 0.0),
        DVec3::new(
            -camera.focal.x * x / (z * z),
            -camera.focal.y * y / (z * z),
            0.0,
        ),
    );
    let to_image = jacobian * rotation;
    let covariance = to_image * gaussian.covariance() * to_image.transpose();
    let covariance = DMat2::from_cols(
        DVec2::new(covariance.x_axis.x + low_pass, covariance.x_axis.y),
        DVec2::new(covariance.y_axis.x, covariance.y_axis.y + low_pass),
    );
    Some(Footprint {
        depth: z,
        center: DVec2::new(
            camera.focal.x * mean.x / z + 0.5 * size.x,
            camera.focal.y * mean.y / z + 0.5 * size.y,
        ),
        inverse: covariance.inverse(),
        opacity: f64::from(gaussian.opacity) / 255.0,
        color: gaussian.color,
    })
}

/// Near to far; contributions under 1/255 are left out.
fn blend(footprints: &[Footprint], place: DVec2) -> [f32; 4] {
    let mut color = DVec3::ZERO;
    let mut transmittance = 1.0;
    for footprint in footprints {
        let d = place - footprint.center;
        let alpha = footprint.opacity * (-0.5 * d.dot(footprint.inverse * d)).exp();
        if alpha >= 1.0 / 255.0 {
            let alpha = alpha.min(0.99);
            color += transmittance * alpha * footprint.color;
            transmittance *= 1.0 - alpha;
        }
    }
    [color.x, color.y, color.z, 1.0 - transmittance].map(|channel| channel as f32)
}
