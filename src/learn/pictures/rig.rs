//! Cameras on rings around a person.

use effigy_capture::CaptureCamera;
use effigy_core::{random::Random, scene::Camera};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Heights of the rings, as angles that cameras look down by, radians.
const PITCHES: [f64; 4] = [0.06, 0.42, -0.08, 0.2];
/// Vertical field of view, radians.
const FOV: f64 = 0.6;
/// The share of the picture that is left free around the person.
const MARGIN: f64 = 0.06;
/// How much focal lengths differ, as a share.
const FOCAL_SPREAD: f64 = 0.02;
/// How far the optical axis is from the picture's middle, as a share of its size.
const CENTER_SPREAD: f64 = 0.015;
/// One in so many cameras is held out, at least one of two or more.
const HELD: usize = 8;

/// The cameras of a capture.
#[derive(Clone, Debug)]
pub struct RigOptions {
    /// The number in the first camera's name; those of the others follow.
    pub first: usize,
    /// Number of cameras.
    pub cameras: usize,
    /// Width and height of the pictures, px.
    pub size: [u32; 2],
    /// Decides small differences between the cameras.
    pub seed: u64,
}

/// Cameras all around, at several heights, each as near as it can be to see every point. `points`:
/// what the person's surface, or a part of it, touches in any frame, metres; at least one.
pub fn rig(points: &[DVec3], options: &RigOptions) -> Vec<CaptureCamera> {
    let low = points.iter().fold(DVec3::INFINITY, |low, p| low.min(*p));
    let high = points
        .iter()
        .fold(DVec3::NEG_INFINITY, |high, p| high.max(*p));
    let target = (low + high) / 2.0;
    let count = options.cameras;
    (0..count)
        .map(|at| {
            let yaw = TAU * at as f64 / count as f64;
            let pitch = PITCHES[at % PITCHES.len()];
            CaptureCamera {
                name: format!("cam{:02}", options.first + at),
                camera: one(points, target, yaw, pitch, options, options.first + at),
                distortion: [0.0; 5],
                // Not the first, and spread around.
                held: count > 1 && at % HELD == HELD.min(count) / 2,
            }
        })
        .collect()
}

fn one(
    points: &[DVec3],
    target: DVec3,
    yaw: f64,
    pitch: f64,
    options: &RigOptions,
    number: usize,
) -> Camera {
    let mut random = Random::new(options.seed, 0xCA0 + number as u64);
    let mut spread = |of: f64| random.range(-of, of);
    let size = DVec2::from(options.size.map(f64::from));
    let mut camera = Camera::orbit(target, yaw, pitch, 0.0, FOV, options.size);
    // At distance 0 there is no direction; any other will do.
    let far = Camera::orbit(target, yaw, pitch, 1.0, FOV, options.size);
    camera.view.matrix3 = far.view.matrix3;
    camera.focal *= 1.0 + spread(FOCAL_SPREAD);
    camera.center += size * DVec2::new(spread(CENTER_SPREAD), spread(CENTER_SPREAD));
    // A point at x to the side of the target and z behind it is inside where it is at most
    // slope (distance + z) from the axis. A step aside by `shift` makes both sides fit as well.
    let low = (camera.center - MARGIN * size) / camera.focal;
    let high = (size - camera.center - MARGIN * size) / camera.focal;
    let mut beyond = [DVec2::NEG_INFINITY; 2];
    let mut distance = camera.near;
    for point in points {
        let seen = camera.view.matrix3 * (*point - target);
        let side = seen.truncate();
        beyond[0] = beyond[0].max(-side / low - seen.z);
        beyond[1] = beyond[1].max(side / high - seen.z);
        distance = distance.max(2.0 * camera.near - seen.z);
    }
    let shift = (beyond[1] - beyond[0]) / (1.0 / high + 1.0 / low);
    distance = distance.max((beyond[1] - shift / high).max_element());
    camera.view.translation = camera.view.matrix3 * -target + distance * DVec3::Z;
    camera.view.translation -= shift.extend(0.0);
    camera
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_camera_frames_every_point() {
        let points: Vec<DVec3> = (0..200)
            .map(|at| {
                let mut random = Random::new(5, at);
                random.direction() * DVec3::new(0.7, 0.95, 0.4) + DVec3::Y
            })
            .collect();
        for size in [[256, 256], [300, 200], [100, 400]] {
            let options = RigOptions {
                first: 0,
                cameras: 16,
                size,
                seed: 3,
            };
            let cameras = rig(&points, &options);
            assert_eq!(cameras.iter().filter(|camera| camera.held).count(), 2);
            let size = DVec2::from(size.map(f64::from));
            for own in &cameras {
                let camera = &own.camera;
                let places: Vec<DVec2> = points
                    .iter()
                    .map(|p| camera.project(camera.view.transform_point3(*p)) / size)
                    .collect();
                let low = places.iter().fold(DVec2::ONE, |low, p| low.min(*p));
                let high = places.iter().fold(DVec2::ZERO, |high, p| high.max(*p));
                assert!(low.min_element() > 0.055 && high.max_element() < 0.945);
                // Two opposite sides are touched.
                let touched = low.max(1.0 - high).min_element();
                assert!((touched - MARGIN).abs() < 1e-6, "{touched}");
                assert!(camera.eye().y > 0.1, "{}", camera.eye());
            }
        }
    }
}
