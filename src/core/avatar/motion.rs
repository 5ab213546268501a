//! Clips of motion: poses at a fixed rate, sampled at any time.

use super::{Pose, Skeleton};
use glam::DVec3;

/// A clip of a skeleton with J joints and F frames, at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// Name of the clip.
    pub name: String,
    /// Where it comes from and on what terms it may be used; free text, may be empty.
    pub credit: String,
    /// Frames a second, above 0.
    pub rate: f64,
    /// Names of the joints, in the order of `rotation`.
    pub joint: Vec<String>,
    /// Axis-angle, radians; shape F, J.
    pub rotation: Vec<[f32; 3]>,
    /// Of the root relative to its rest position, metres; length F.
    pub translation: Vec<[f32; 3]>,
    /// Shape F, `expression_len`.
    pub expression: Vec<f32>,
    /// Length of θ_e.
    pub expression_len: usize,
}

impl Clip {
    /// The rest pose of a skeleton as a clip of one frame.
    pub fn still(skeleton: &Skeleton) -> Self {
        Self {
            name: "still".into(),
            credit: String::new(),
            rate: 1.0,
            joint: skeleton.name.clone(),
            rotation: vec![[0.0; 3]; skeleton.len()],
            translation: vec![[0.0; 3]],
            expression: vec![],
            expression_len: 0,
        }
    }

    /// Number of frames, F.
    pub fn frames(&self) -> usize {
        self.translation.len()
    }

    /// Index of the last frame; 0 for a clip without frames, which is none.
    fn last(&self) -> usize {
        self.frames().saturating_sub(1)
    }

    /// Seconds from the first frame to the last.
    pub fn duration(&self) -> f64 {
        self.last() as f64 / self.rate
    }

    /// A frame's pose in the clip's own joint order.
    ///
    /// # Panics
    /// When there is no such frame, or the arrays have other lengths than the fields say.
    pub fn frame(&self, frame: usize) -> Pose {
        let joints = self.joint.len();
        Pose {
            rotation: self.rotation[frame * joints..][..joints]
                .iter()
                .map(|r| DVec3::from(r.map(f64::from)))
                .collect(),
            translation: DVec3::from(self.translation[frame].map(f64::from)),
            expression: self.expression[frame * self.expression_len..][..self.expression_len]
                .iter()
                .map(|&e| f64::from(e))
                .collect(),
        }
    }

    /// The pose at a time, seconds: interpolated between frames, each joint the shortest way;
    /// before the start and after the end the nearest frame. NaN is the start.
    ///
    /// # Panics
    /// When the clip has no frames, or its arrays have other lengths than the fields say.
    pub fn sample(&self, seconds: f64) -> Pose {
        let at = (seconds * self.rate).max(0.0).min(self.last() as f64);
        let first = at.floor() as usize;
        let share = at.fract();
        let pose = self.frame(first);
        if share == 0.0 {
            return pose;
        }
        let next = self.frame((first + 1).min(self.last()));
        pose.between(&next, share)
    }

    /// Index in [`Clip::joint`] of each joint of a skeleton, by name. None: the clip does not have
    /// the joint, which stays at rest.
    pub fn map_to(&self, skeleton: &Skeleton) -> Vec<Option<usize>> {
        skeleton
            .name
            .iter()
            .map(|name| self.joint.iter().position(|joint| joint == name))
            .collect()
    }
}

/// A clip mapped to an avatar's skeleton.
#[derive(Clone, Debug)]
pub struct Player {
    clip: Clip,
    map: Vec<Option<usize>>,
}

impl Player {
    /// Maps a clip to a skeleton by the names of joints.
    pub fn new(clip: Clip, skeleton: &Skeleton) -> Self {
        let map = clip.map_to(skeleton);
        Self { clip, map }
    }

    /// The clip in its own joint order.
    pub fn clip(&self) -> &Clip {
        &self.clip
    }

    /// Number of the skeleton's joints that the clip moves.
    pub fn mapped(&self) -> usize {
        self.map.iter().flatten().count()
    }

    /// The skeleton's pose at a time, seconds; held before the start and after the end.
    ///
    /// # Panics
    /// Where [`Clip::sample`] does.
    pub fn pose(&self, seconds: f64) -> Pose {
        let pose = self.clip.sample(seconds);
        Pose {
            rotation: self
                .map
                .iter()
                .map(|joint| joint.map_or(DVec3::ZERO, |joint| pose.rotation[joint]))
                .collect(),
            ..pose
        }
    }
}
