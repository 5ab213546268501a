//! Which pictures of a capture are compared: those of cameras and frames that were held out, and
//! some that were not.

use effigy_capture::Capture;
use effigy_math::sampling::evenly_spaced;

/// A camera's picture of a frame, by index into the capture's lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureIndex {
    /// Index of the camera.
    pub camera: usize,
    /// Index of the frame.
    pub frame: usize,
}

/// How many views to choose.
#[derive(Clone, Copy, Debug)]
pub struct ViewChoice {
    /// Cameras of each kind, at most.
    pub cameras: usize,
    /// Frames of each kind, at most.
    pub frames: usize,
    /// Pictures that training saw, too.
    pub training: bool,
}

/// The names of a view's group: whether its camera, and whether its frame was held out.
pub fn group(capture: &Capture, view: PictureIndex) -> &'static str {
    let camera = capture.cameras[view.camera].held;
    match (camera, capture.frames[view.frame].held) {
        (false, false) => "training",
        (true, false) => "held-out cameras",
        (false, true) => "held-out poses",
        (true, true) => "held-out cameras and poses",
    }
}

/// Views of every group, evenly spaced over its cameras and frames.
pub fn choose(capture: &Capture, choice: &ViewChoice) -> Vec<PictureIndex> {
    let mut views = Vec::new();
    for camera_held in [false, true] {
        let all = 0..capture.cameras.len();
        let cameras: Vec<usize> = all
            .filter(|&camera| capture.cameras[camera].held == camera_held)
            .collect();
        for frame_held in [false, true] {
            if !camera_held && !frame_held && !choice.training {
                continue;
            }
            let all = 0..capture.frames.len();
            let frames: Vec<usize> = all
                .filter(|&frame| capture.frames[frame].held == frame_held)
                .collect();
            for camera in evenly_spaced(&cameras, choice.cameras) {
                for frame in evenly_spaced(&frames, choice.frames) {
                    if capture.has(camera, frame) {
                        views.push(PictureIndex { camera, frame });
                    }
                }
            }
        }
    }
    views
}
