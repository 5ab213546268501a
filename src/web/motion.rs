//! How the avatar stands: clips and the time in them, or poses as they come, between which it moves smoothly.

use crate::avatar::{Avatar, Clip, Pose, motion::Player};
use glam::DVec3;

/// Poses that come at some rate. A pose is shown fully once as much time has passed as lay between it and the one before.
struct Live {
    from: Pose,
    to: Pose,
    /// When `to` came, and how long it takes to get there, ms.
    since: f64,
    takes: f64,
}

/// Longest time that a pose takes to be shown, ms: after a pause nothing lags.
const LONGEST: f64 = 250.0;

enum Source {
    Clip { number: usize, seconds: f64 },
    Live(Live),
}

pub struct Motion {
    players: Vec<Player>,
    source: Source,
    rest: Pose,
}

impl Motion {
    pub fn new(avatar: &Avatar) -> Self {
        let rest = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
        Self { players: Vec::new(), source: Source::Clip { number: 0, seconds: 0.0 }, rest }
    }

    /// Takes another clip; gives its number, or says why it is none for this avatar.
    pub fn add(&mut self, clip: Clip, avatar: &Avatar) -> Result<usize, String> {
        if clip.map_to(&avatar.skeleton).iter().flatten().next().is_none() {
            return Err(format!("the clip `{}` moves none of the joints of `{}`", clip.name, avatar.name));
        }
        self.players.push(Player::new(clip, &avatar.skeleton));
        Ok(self.players.len() - 1)
    }

    pub fn clips(&self) -> impl Iterator<Item = &Clip> {
        self.players.iter().map(Player::clip)
    }

    pub fn seek(&mut self, number: usize, seconds: f64) {
        self.source = Source::Clip { number, seconds: if seconds.is_finite() { seconds } else { 0.0 } };
    }

    /// Takes a pose that came at `now`, ms.
    pub fn set(&mut self, now: f64, rotation: &[f32], translation: &[f32], expression: &[f32]) -> Result<(), String> {
        let joints = self.rest.rotation.len();
        if rotation.len() != 3 * joints || translation.len() != 3 || expression.len() > self.rest.expression.len() {
            let found = format!("{} rotations, {} translations, {} expressions", rotation.len(), translation.len(), expression.len());
            return Err(format!("a pose of {found} was found, expected {}, 3 and at most {}", 3 * joints, self.rest.expression.len()));
        }
        if rotation.iter().chain(translation).chain(expression).any(|number| !number.is_finite()) {
            return Err("a pose has a number that is NaN or infinite".into());
        }
        let vector = |v: &[f32]| DVec3::new(v[0].into(), v[1].into(), v[2].into());
        let to = Pose {
            rotation: rotation.chunks_exact(3).map(vector).collect(),
            translation: vector(translation),
            expression: (0..self.rest.expression.len()).map(|at| expression.get(at).copied().unwrap_or_default().into()).collect(),
        };
        let takes = match &self.source {
            Source::Live(live) => (now - live.since).clamp(0.0, LONGEST),
            Source::Clip { .. } => 0.0,
        };
        self.source = Source::Live(Live { from: self.pose(now), to, since: now, takes });
        Ok(())
    }

    /// How it stands at `now`, ms.
    pub fn pose(&self, now: f64) -> Pose {
        match &self.source {
            Source::Clip { number, seconds } => self.players.get(*number).map_or_else(|| self.rest.clone(), |player| player.pose(*seconds)),
            Source::Live(Live { from, to, since, takes }) if now - since < *takes => from.between(to, ((now - since) / takes).max(0.0)),
            Source::Live(live) => live.to.clone(),
        }
    }
}
