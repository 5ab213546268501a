//! Whether cameras and poses are in metres: with millimetres everything is read, and nobody is seen.

use crate::{calibration::CaptureCamera, capture::Capture};
use effigy_core::io::file::FormatError;
use glam::DVec3;

/// Cameras further from the body are out of the ordinary, metres.
const FAR: f64 = 30.0;
/// A body that takes less of a picture's height is hardly seen.
const HARDLY_SEEN: f64 = 0.05;

/// What is not in metres.
pub struct UnitFault {
    /// Whether it is the poses' `transl` alone, and not the cameras' `T`.
    pub of_poses: bool,
    pub error: FormatError,
}

/// What one camera has of the body.
struct CameraSight {
    /// From the body's root, metres.
    distance: f64,
    /// Of the camera from the origin, metres.
    eye: f64,
    /// Of the root from the origin, metres.
    root: f64,
    /// Share of the picture's height that the body takes.
    share: f64,
}

/// What tells that lengths are not in metres: most cameras are far from the body and hardly see it.
pub fn fault(capture: &Capture) -> Option<UnitFault> {
    let vertices = &capture.template.vertices;
    let low = vertices.iter().fold(DVec3::INFINITY, |low, v| low.min(*v));
    let high = vertices
        .iter()
        .fold(DVec3::NEG_INFINITY, |high, v| high.max(*v));
    let height = (high - low).max_element();
    let sight = |(at, own): (usize, &CaptureCamera)| {
        let frame = (0..capture.frames.len()).find(|&frame| capture.has(at, frame))?;
        let joints = capture
            .template
            .skeleton
            .joints(&capture.frames[frame].pose);
        let root = joints.first()?.translation;
        let distance = own.camera.eye().distance(root);
        Some(CameraSight {
            distance,
            eye: own.camera.eye().length(),
            root: root.length(),
            share: own.camera.focal.y * height / distance / f64::from(own.camera.size[1]),
        })
    };
    let sights: Vec<CameraSight> = capture
        .cameras
        .iter()
        .enumerate()
        .filter_map(sight)
        .collect();
    let middle = |of: fn(&CameraSight) -> f64| {
        let mut all: Vec<f64> = sights.iter().map(of).collect();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied().unwrap_or(0.0)
    };
    let distance = middle(|own| own.distance);
    if distance < FAR || middle(|own| own.share) > HARDLY_SEEN {
        return None;
    }
    let of_poses = middle(|own| own.eye) < FAR;
    let what = match of_poses {
        true => "transl",
        false if middle(|own| own.root) < FAR => "T",
        false => "T and transl",
    };
    let usual = |per_metre: f64| (1.0..20.0).contains(&(distance / per_metre));
    let expected = if usual(1000.0) {
        format!("{what} in metres: as it seems it is in millimetres, to be divided by 1000")
    } else if usual(100.0) {
        format!("{what} in metres: as it seems it is in centimetres, to be divided by 100")
    } else {
        format!("{what} in metres")
    };
    let found =
        format!("cameras {distance:.0} m from the body, which is too small there to be seen");
    Some(UnitFault {
        of_poses,
        error: FormatError::container(found, expected),
    })
}
