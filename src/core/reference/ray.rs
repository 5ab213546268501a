//! Where a Gaussian is densest along a ray of the camera: the depth by which each pixel can sort
//! for itself, and the point of the surface that the pixel shows of it.

use super::project::Gaussian;
use crate::{avatar::LowPass, scene::Camera};
use glam::{DMat3, DVec3};

/// A Gaussian of the posed world in camera coordinates, as wide as it is drawn: with the low-pass
/// as a variance in space, so that one much thinner than a pixel is densest near itself for every
/// ray that it is drawn for.
#[derive(Clone, Copy, Debug)]
pub struct RayGaussian {
    /// Σ⁻¹, 1/m².
    precision: DMat3,
    /// Σ⁻¹ t, 1/m; t is the mean.
    toward: DVec3,
    /// The mean's depth, metres.
    center: f64,
}

impl RayGaussian {
    /// A Gaussian as a camera sees it with a low-pass.
    pub fn new(gaussian: &Gaussian, camera: &Camera, low_pass: LowPass) -> Self {
        let mean = camera.view.transform_point3(gaussian.mean);
        let axes = camera.view.matrix3 * gaussian.axes;
        let pixel = mean.z / camera.focal;
        let low_pass =
            low_pass.variance * DVec3::new(pixel.x * pixel.x, pixel.y * pixel.y, pixel.x * pixel.y);
        let covariance = axes * axes.transpose() + DMat3::from_diagonal(low_pass);
        let precision = covariance.inverse();
        Self {
            precision,
            toward: precision * mean,
            center: mean.z,
        }
    }

    /// The depth at which it is densest along a ray ([`Camera::ray`]), metres; that of its centre
    /// where it has no such depth, since its covariance has no inverse.
    pub fn peak(&self, ray: DVec3) -> f64 {
        let depth = self.toward.dot(ray) / ray.dot(self.precision * ray);
        if depth.is_finite() {
            depth
        } else {
            self.center
        }
    }
}

/// Each Gaussian as a camera sees it with a low-pass, in their order.
pub fn rays(gaussians: &[Gaussian], camera: &Camera, low_pass: LowPass) -> Vec<RayGaussian> {
    gaussians
        .iter()
        .map(|gaussian| RayGaussian::new(gaussian, camera, low_pass))
        .collect()
}
