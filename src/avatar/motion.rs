//! Clips of motion: poses at a fixed rate, sampled at any time.

use super::{Pose, Skeleton};
use glam::DVec3;

/// A clip of a skeleton with J joints and F frames, at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    pub name: String,
    /// Where it comes from and on what terms it may be used; free text, may be empty.
    pub credit: String,
    /// Frames a second, above 0.
    pub rate: f64,
    /// The joints that `rotation` is of.
    pub joint: Vec<String>,
    /// Axis-angle, radians; shape F, J.
    pub rotation: Vec<[f32; 3]>,
    /// Of the root, metres; length F.
    pub translation: Vec<[f32; 3]>,
    /// Shape F, `expression_len`.
    pub expression: Vec<f32>,
    pub expression_len: usize,
}

impl Clip {
    /// A single pose of a skeleton, with no rotation anywhere.
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

    /// F.
    pub fn frames(&self) -> usize {
        self.translation.len()
    }

    /// Seconds from the first frame to the last.
    pub fn duration(&self) -> f64 {
        (self.frames() - 1) as f64 / self.rate
    }

    /// A frame's pose in the clip's own joint order.
    pub fn frame(&self, frame: usize) -> Pose {
        let joints = self.joint.len();
        Pose {
            rotation: self.rotation[frame * joints..][..joints].iter().map(|r| DVec3::from(r.map(f64::from))).collect(),
            translation: DVec3::from(self.translation[frame].map(f64::from)),
            expression: self.expression[frame * self.expression_len..][..self.expression_len].iter().map(|&e| f64::from(e)).collect(),
        }
    }

    /// The pose at a time, between frames the shortest turn of each joint; before the start and after the end the nearest frame.
    /// A time that is no number is the start.
    pub fn sample(&self, seconds: f64) -> Pose {
        let at = (seconds * self.rate).max(0.0).min((self.frames() - 1) as f64);
        let (first, t) = (at.floor() as usize, at.fract());
        let (a, b) = (self.frame(first), self.frame((first + 1).min(self.frames() - 1)));
        if t == 0.0 {
            return a;
        }
        a.between(&b, t)
    }

    /// Where in [`Clip::joint`] each joint of a skeleton is, by name; joints that the clip lacks stay at rest.
    pub fn map_to(&self, skeleton: &Skeleton) -> Vec<Option<usize>> {
        skeleton.name.iter().map(|name| self.joint.iter().position(|joint| joint == name)).collect()
    }
}

/// A clip fitted to an avatar's skeleton.
#[derive(Clone, Debug)]
pub struct Player {
    clip: Clip,
    map: Vec<Option<usize>>,
}

impl Player {
    pub fn new(clip: Clip, skeleton: &Skeleton) -> Self {
        let map = clip.map_to(skeleton);
        Self { clip, map }
    }

    pub fn clip(&self) -> &Clip {
        &self.clip
    }

    /// Joints of the skeleton that the clip moves.
    pub fn mapped(&self) -> usize {
        self.map.iter().flatten().count()
    }

    /// The skeleton's pose at a time, held at both ends.
    pub fn pose(&self, seconds: f64) -> Pose {
        let pose = self.clip.sample(seconds);
        Pose { rotation: self.map.iter().map(|joint| joint.map_or(DVec3::ZERO, |joint| pose.rotation[joint])).collect(), ..pose }
    }
}
