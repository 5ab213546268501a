//! Poses that fit pictures best with the avatar as it is: what a comparison needs where a capture's
//! poses are off.

use crate::adam::Adam;
use crate::data::{DataOptions, TrainingViews, random_color, shots};
use crate::error::TrainError;
use crate::gpu::{StepOptions, Trainer, TrainerState};
use crate::parameters::{ParameterLayout, Parameters};
use crate::refine::Refinement;
use crate::topology::{CorrectiveRows, Topology};
use crate::view::TrainingView;
use effigy_capture::Capture;
use effigy_core::avatar::{Avatar, Pose};
use effigy_core::random::Random;
use effigy_render::vulkan::Gpu;
use std::sync::Arc;

/// Steps of a frame's pose.
const STEPS: u32 = 60;
/// Pictures of a step, at most.
const PICTURES: usize = 4;
/// How far the first step goes, radians and metres.
const RATE: f64 = 8e-3;
/// What is left of it at the end.
const END: f64 = 0.05;

/// Fits the poses of some frames to the pictures that cameras took of them which are not held out,
/// by the same loss as training's. The avatar stays as it is. None for a frame without such
/// pictures. `done` gets the number of frames done.
///
/// # Errors
/// When the device is lost or not for training, or pictures can't be read.
pub fn refit(
    gpu: &Arc<Gpu>,
    avatar: &Avatar,
    capture: &Arc<Capture>,
    frames: &[usize],
    data: &DataOptions,
    mut done: impl FnMut(usize),
) -> Result<Vec<Option<Pose>>, TrainError> {
    let options = StepOptions {
        joints: true,
        ..StepOptions::LOOK
    };
    let mut refinement = Refinement::new(capture);
    let mut seen = shots(capture, |camera, _| !camera);
    seen.retain(|shot| frames.contains(&shot.frame));
    if !seen.is_empty() {
        let views = TrainingViews::new(capture, avatar, seen, data, 1, None);
        let topology = Topology::new(avatar);
        let rows = CorrectiveRows::of(avatar);
        let layout = ParameterLayout::new(&topology, &rows);
        let state = TrainerState::new(&layout, Parameters::of(avatar, &layout));
        let mut trainer = Trainer::new(gpu, &topology, &rows, &state, views.size(), PICTURES)?;
        for (at, &frame) in frames.iter().enumerate() {
            let of_frame: Vec<usize> = (0..views.len())
                .filter(|&shot| views.shots()[shot].frame == frame)
                .collect();
            let mut random = Random::new(1, frame as u64);
            for step in 0..STEPS {
                let chosen = some(&of_frame, &mut random);
                let pose = refinement.pose(frame, &capture.frames[frame].pose);
                let joints = avatar.skeleton.matrices(&pose);
                let input = avatar.inputs.from_pose(&pose);
                let mut looked = Vec::new();
                for shot in chosen {
                    let found = views.steady(shot, random_color(&mut random))?;
                    // Another stands in for a picture that can't be read: not of this frame.
                    if found.shot.frame == frame {
                        looked.push(TrainingView {
                            joints: joints.clone(),
                            input: input.clone(),
                            ..found.view
                        });
                    }
                }
                if looked.is_empty() {
                    continue;
                }
                trainer.look(&looked, &options)?;
                let mut of = |view| {
                    let joints = trainer.joints_gradient(view);
                    avatar.skeleton.matrices_backward(&pose, &joints)
                };
                let mut gradient = of(0);
                for view in 1..looked.len() {
                    gradient.add(&of(view));
                }
                let rate = RATE * END.powf(f64::from(step) / f64::from(STEPS));
                refinement.learn_pose(frame, &gradient, rate, &Adam::DEFAULT);
            }
            done(at + 1);
        }
    }
    Ok(frames
        .iter()
        .map(|&frame| {
            let is_fitted = refinement.poses.moments.updates(frame) > 0;
            is_fitted.then(|| refinement.pose(frame, &capture.frames[frame].pose))
        })
        .collect())
}

/// A few of some, none twice.
fn some(all: &[usize], random: &mut Random) -> Vec<usize> {
    let mut rest = all.to_vec();
    let count = PICTURES.min(rest.len());
    (0..count)
        .map(|_| rest.swap_remove((random.uniform() * rest.len() as f64) as usize))
        .collect()
}

/// Which pictures [`refit`] may look at for a frame, for what says how numbers were found.
pub const REFITTED: &str = "fitted to the frame's pictures of cameras that are not held out, with \
                            the avatar as it is";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn some_are_chosen_and_none_twice() {
        let mut random = Random::new(4, 0);
        for count in 0..7 {
            let all: Vec<usize> = (0..count).map(|k| 10 * k).collect();
            let mut chosen = some(&all, &mut random);
            chosen.sort_unstable();
            chosen.dedup();
            assert_eq!(chosen.len(), count.min(PICTURES));
            assert!(chosen.iter().all(|shot| all.contains(shot)));
        }
    }
}
