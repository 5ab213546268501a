//! The poses at which the teacher is asked.
//!
//! Of some training poses each gives two rows: one projected onto the principal components, as an
//! avatar's networks see poses, and one as it is. Rows between two training poses are added, since
//! the teacher can be asked anywhere. Every tenth stretch of the training sequence is held out.

use crate::distil::inputs::{NetworkInputs, fit_subspaces};
use effigy_core::avatar::{Inputs, Pose};
use effigy_core::random::Random;
use effigy_math::sampling::evenly_spaced;

/// Stretches of the training sequence: neighbouring frames are nearly the same pose, so that single
/// frames would be no test.
const STRETCHES: usize = 40;
/// One of so many stretches is held out.
const HELD: usize = 10;
/// Other uses of the seed draw from other streams.
const STREAM: u64 = 9000;

/// How many poses to ask the teacher for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampleOptions {
    /// Training poses, evenly spaced, at most.
    pub poses: usize,
    /// Poses between two training poses.
    pub between: usize,
    /// Decides which.
    pub seed: u64,
}

/// Rows of inputs, and which are learned.
pub struct InputSamples {
    /// The avatar's inputs, with the principal components of the training poses.
    pub inputs: Inputs,
    /// Training poses. Row 2 k is pose k projected, row 2 k + 1 as it is.
    pub poses: Vec<Pose>,
    /// Poses to learn from, indices.
    pub learned: Vec<usize>,
    /// Poses that are held out, indices.
    pub held: Vec<usize>,
    /// All rows, as the learner has them.
    pub rows: NetworkInputs,
    /// Rows to learn.
    pub training: Vec<usize>,
    /// Rows of held-out poses.
    pub held_rows: Vec<usize>,
}

impl InputSamples {
    /// Chooses poses of a training sequence. `plain`: the avatar's inputs without components.
    pub fn new(plain: &Inputs, sequence: &[Pose], options: &SampleOptions) -> Self {
        let all: Vec<usize> = (0..sequence.len()).collect();
        let chosen = evenly_spaced(&all, options.poses);
        let poses: Vec<Pose> = chosen.iter().map(|&at| sequence[at].clone()).collect();
        let stretch = |pose: usize| pose * STRETCHES / poses.len().max(1);
        let is_held = |pose: &usize| stretch(*pose) % HELD == HELD / 2;
        let (held, learned): (Vec<usize>, Vec<usize>) = (0..poses.len()).partition(is_held);
        let training_poses: Vec<&Pose> = learned.iter().map(|&pose| &poses[pose]).collect();
        let inputs = fit_subspaces(plain, &training_poses);
        let mut rows: Vec<f32> = Vec::new();
        let mut push = |row: Vec<f64>| rows.extend(row.iter().map(|&x| x as f32));
        for pose in &poses {
            push(inputs.from_pose(pose));
            push(inputs.unprojected(pose));
        }
        let mut random = Random::new(options.seed, STREAM);
        let count = if learned.is_empty() {
            0
        } else {
            options.between
        };
        for _ in 0..count {
            let mut draw = || training_poses[(random.bits() % learned.len() as u64) as usize];
            let (from, to) = (draw(), draw());
            push(inputs.from_pose(&from.between(to, random.uniform())));
        }
        let both = |poses: &[usize]| poses.iter().flat_map(|&k| [2 * k, 2 * k + 1]).collect();
        let mut training: Vec<usize> = both(&learned);
        training.extend((0..count).map(|at| 2 * poses.len() + at));
        let held_rows = both(&held);
        Self {
            rows: NetworkInputs::new(&inputs, rows.clone(), rows, &training),
            inputs,
            poses,
            learned,
            held,
            training,
            held_rows,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn held_out_poses_are_in_stretches_and_no_row_of_them_is_learned() {
        let plain = Inputs {
            joint: vec![1],
            expression: 0,
            pose_space: None,
            expression_space: None,
        };
        let pose = |at: usize| Pose {
            rotation: vec![DVec3::ZERO, DVec3::splat(0.001 * at as f64)],
            ..Pose::rest(0, 0)
        };
        let sequence: Vec<Pose> = (0..400).map(pose).collect();
        let options = SampleOptions {
            poses: 200,
            between: 7,
            seed: 1,
        };
        let samples = InputSamples::new(&plain, &sequence, &options);
        assert_eq!(
            samples.held,
            [
                25, 26, 27, 28, 29, 75, 76, 77, 78, 79, 125, 126, 127, 128, 129, 175, 176, 177,
                178, 179
            ]
        );
        assert_eq!(samples.training.len(), 2 * 180 + 7);
        assert!(
            samples
                .held_rows
                .iter()
                .all(|row| !samples.training.contains(row))
        );
        assert_eq!(samples.rows.raw.len(), 3 * (2 * 200 + 7));
    }
}
