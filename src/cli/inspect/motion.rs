//! The contents of a clip, in numbers.

use super::text::{Distribution, line, stated, table, thousands};
use effigy_core::avatar::Clip;
use effigy_core::io::file::TensorInfo;
use serde::Serialize;
use std::fmt;

/// Joints that the text names, those that move furthest; JSON names all.
const SHOWN: usize = 12;

/// A clip's counts and ranges.
#[derive(Serialize)]
pub struct MotionSummary {
    kind: &'static str,
    name: String,
    credit: String,
    frames: usize,
    /// Frames a second.
    rate: f64,
    /// Seconds.
    duration: f64,
    joints: Vec<JointRange>,
    /// Of the root along x, y, z, metres.
    translation: [Distribution; 3],
    expression: usize,
    /// Over all coefficients and frames.
    expression_range: Distribution,
    tensors: Vec<TensorInfo>,
    bytes: usize,
}

#[derive(Serialize)]
struct JointRange {
    name: String,
    /// Angle away from rest, degrees.
    angle: Distribution,
}

impl MotionSummary {
    pub fn new(clip: &Clip) -> Self {
        let joints = clip.joint.len();
        let angle = |r: &[f32; 3]| {
            r.map(f64::from)
                .iter()
                .map(|v| v * v)
                .sum::<f64>()
                .sqrt()
                .to_degrees()
        };
        let joint = |joint: usize| {
            let frames = clip.rotation.iter().skip(joint).step_by(joints);
            JointRange {
                name: clip.joint[joint].clone(),
                angle: Distribution::new(frames.map(angle)),
            }
        };
        let tensors = clip.tensors();
        Self {
            kind: "motion",
            name: clip.name.clone(),
            credit: clip.credit.clone(),
            frames: clip.frames(),
            rate: clip.rate,
            duration: clip.duration(),
            joints: (0..joints).map(joint).collect(),
            translation: [0, 1, 2]
                .map(|k| Distribution::new(clip.translation.iter().map(|t| f64::from(t[k])))),
            expression: clip.expression_len,
            expression_range: Distribution::new(clip.expression.iter().map(|&e| f64::from(e))),
            bytes: tensors.iter().map(|tensor| tensor.bytes).sum(),
            tensors,
        }
    }
}

impl fmt::Display for MotionSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        line(f, "motion", &self.name)?;
        line(f, "credit", stated(&self.credit))?;
        line(
            f,
            "frames",
            format_args!(
                "{} at {:.4} per second, {:.3} s",
                thousands(self.frames),
                self.rate,
                self.duration
            ),
        )?;
        for (name, axis) in ["root x", "root y", "root z"].iter().zip(&self.translation) {
            let Distribution { min, median, max } = axis;
            line(
                f,
                name,
                format_args!("{min:.3} to {max:.3} m, median {median:.3}"),
            )?;
        }
        match self.expression {
            0 => line(f, "expression", "none")?,
            n => line(
                f,
                "expression",
                format_args!(
                    "{n}, {:.3} to {:.3}",
                    self.expression_range.min, self.expression_range.max
                ),
            )?,
        }
        let mut moved: Vec<&JointRange> = self
            .joints
            .iter()
            .filter(|joint| joint.angle.max - joint.angle.min > 1e-3)
            .collect();
        moved.sort_by(|a, b| b.angle.max.total_cmp(&a.angle.max));
        line(
            f,
            "joints",
            format_args!(
                "{}, of which {} move; furthest from rest, degrees:",
                self.joints.len(),
                moved.len()
            ),
        )?;
        for JointRange { name, angle } in moved.iter().take(SHOWN) {
            writeln!(
                f,
                "{:12}{name:<24} {:>6.1} to {:>6.1}, median {:>6.1}",
                "", angle.min, angle.max, angle.median
            )?;
        }
        table(f, &self.tensors)
    }
}
