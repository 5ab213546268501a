//! The window of `effigy train --view`: the avatar while it is learned.
//!
//! winit wants the main thread, so the training has another. The window ends with the training; the
//! training does not end with the window.

use crate::source::{CaptureArgs, check_joints, clip};
use effigy_app::{Display, ViewerOptions, live::LiveAvatar};
use effigy_capture::Capture;
use effigy_core::avatar::{Avatar, Clip};
use effigy_render::vulkan::{GpuOptions, RendererOptions};
use indicatif::ProgressBar;
use std::{
    panic::resume_unwind,
    path::PathBuf,
    sync::atomic::{AtomicBool, Ordering},
    thread,
};

/// Width and height of the window, px.
const SIZE: [u32; 2] = [800, 800];
/// Captures don't say how many frames they have a second.
const RATE: f64 = 30.0;

/// What the window begins with.
pub struct Window {
    pub display: Display,
    pub avatar: Avatar,
    pub clips: Vec<Clip>,
    /// The device that it draws with, beside the training.
    pub gpu: GpuOptions,
}

/// What the avatar can be seen doing: the clips of some files, then the capture's own frames.
pub fn clips(motion: &[PathBuf], capture: &Capture, avatar: &Avatar) -> anyhow::Result<Vec<Clip>> {
    let options = CaptureArgs::default().clip_options(None)?;
    let mut clips = Vec::new();
    for path in motion {
        let read = clip(path, avatar, &options)?;
        check_joints(&read, avatar)?;
        clips.push(read);
    }
    clips.push(frames(capture));
    Ok(clips)
}

/// A capture's frames, one after the other.
fn frames(capture: &Capture) -> Clip {
    let skeleton = &capture.template.skeleton;
    let length = capture.template.expression;
    let poses = || capture.frames.iter().map(|frame| &frame.pose);
    let rotation = poses().flat_map(|pose| {
        (0..skeleton.len()).map(|joint| {
            let turn = pose.rotation.get(joint).copied().unwrap_or_default();
            turn.as_vec3().to_array()
        })
    });
    let expression = poses().flat_map(|pose| {
        (0..length).map(|at| pose.expression.get(at).map_or(0.0, |&value| value as f32))
    });
    Clip {
        name: "the capture".into(),
        credit: String::new(),
        rate: RATE,
        joint: skeleton.name.clone(),
        rotation: rotation.collect(),
        translation: poses()
            .map(|pose| pose.translation.as_vec3().to_array())
            .collect(),
        expression: expression.collect(),
        expression_len: length,
    }
}

impl Window {
    /// Runs `train` on another thread, and shows what it hands over until it ends.
    pub fn beside<T: Send>(
        self,
        bar: &ProgressBar,
        train: impl FnOnce(&mut LiveAvatar) -> T + Send,
    ) -> T {
        let live = self.display.live();
        let over = AtomicBool::new(false);
        thread::scope(|scope| {
            let ends = &over;
            let training = scope.spawn(move || {
                let mut live = live;
                let trained = train(&mut live);
                // Before `live` closes the window.
                ends.store(true, Ordering::Release);
                trained
            });
            let options = ViewerOptions {
                gpu: self.gpu,
                live: true,
                message: Some("It is being learned, and shown anew every few seconds".into()),
                ..ViewerOptions::new(RendererOptions::new(SIZE))
            };
            let shown = self.display.show(self.avatar, self.clips, options);
            if !over.load(Ordering::Acquire) {
                bar.suspend(|| match shown {
                    Ok(()) => {
                        eprintln!("the window is closed; the training goes on (Ctrl-C stops it)")
                    }
                    Err(error) => eprintln!("the window ended: {error:#}; the training goes on"),
                });
            }
            training.join().unwrap_or_else(|panic| resume_unwind(panic))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::avatar::motion::Player;
    use std::path::Path;

    #[test]
    fn the_clip_of_a_capture_has_its_poses() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/capture");
        let capture = Capture::read(&folder).unwrap();
        let clip = frames(&capture);
        assert_eq!(clip.frames(), capture.frames.len());
        let player = Player::new(clip, &capture.template.skeleton);
        for (number, frame) in capture.frames.iter().enumerate() {
            let pose = player.pose(number as f64 / RATE);
            assert!(pose.translation.distance(frame.pose.translation) < 1e-6);
            for (found, expected) in pose.rotation.iter().zip(&frame.pose.rotation) {
                assert!(found.distance(*expected) < 1e-4, "frame {number}");
            }
            for (found, expected) in pose.expression.iter().zip(&frame.pose.expression) {
                assert!((found - expected).abs() < 1e-5, "frame {number}");
            }
        }
    }
}
