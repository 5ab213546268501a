//! How the avatar stands: clips and the time in them, or poses as they come, between which it moves smoothly.

use crate::avatar::{Avatar, Clip, Pose, limits, motion::Player};
use glam::DVec3;

/// Poses that come at some rate. A pose is shown fully once as much time has passed as lay between it and the one before.
struct Live {
    from: Pose,
    to: Pose,
    /// When `to` came, and how long it takes to get there, ms.
    since: f64,
    takes: f64,
}

/// Shortest and longest time that a pose takes to be shown, ms: of two that come at once neither jumps, and after a pause nothing lags.
const TAKES: [f64; 2] = [8.0, 250.0];

/// Why a pose is not taken.
#[derive(Debug, PartialEq)]
pub struct Refused(pub String);

/// Where poses come from.
enum Source {
    Clip { number: usize, seconds: f64 },
    Live(Live),
}

/// What moves an avatar.
pub struct Motion {
    players: Vec<Player>,
    source: Source,
    rest: Pose,
}

impl Motion {
    /// At rest, without a clip.
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

    /// In the order of their numbers.
    pub fn clips(&self) -> impl Iterator<Item = &Clip> {
        self.players.iter().map(Player::clip)
    }

    /// Shows a clip at a time, seconds; one that is no number is the start.
    pub fn seek(&mut self, number: usize, seconds: f64) {
        self.source = Source::Clip { number, seconds: if seconds.is_finite() { seconds } else { 0.0 } };
    }

    /// Takes a pose that came at `now`, ms.
    pub fn set(&mut self, now: f64, rotation: &[f32], translation: &[f32], expression: &[f32]) -> Result<(), Refused> {
        let joints = self.rest.rotation.len();
        if rotation.len() != 3 * joints || translation.len() != 3 || expression.len() > self.rest.expression.len() {
            let found = format!("{} rotations, {} translations, {} expressions", rotation.len(), translation.len(), expression.len());
            let expected = format!("{}, 3 and at most {}", 3 * joints, self.rest.expression.len());
            return Err(Refused(format!("a pose of {found} was found, expected {expected}")));
        }
        if let Some(number) = rotation.iter().chain(translation).chain(expression).find(|number| !number.is_finite()) {
            return Err(Refused(format!("a pose has the number {number}, expected finite ones")));
        }
        if let Some(metres) = translation.iter().find(|metres| f64::from(metres.abs()) > limits::LENGTH) {
            return Err(Refused(format!("a pose's translation is {metres} m, expected at most {}", limits::LENGTH)));
        }
        let vector = |v: &[f32]| DVec3::new(v[0].into(), v[1].into(), v[2].into());
        let to = Pose {
            rotation: rotation.chunks_exact(3).map(vector).collect(),
            translation: vector(translation),
            expression: (0..self.rest.expression.len()).map(|at| expression.get(at).copied().unwrap_or_default().into()).collect(),
        };
        let takes = match &self.source {
            Source::Live(live) => (now - live.since).clamp(TAKES[0], TAKES[1]),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo;

    fn motion() -> (Avatar, Motion) {
        let avatar = demo::avatar().unwrap();
        let motion = Motion::new(&avatar);
        (avatar, motion)
    }

    fn turned(motion: &mut Motion, now: f64, angle: f32) {
        let mut rotation = vec![0.0; 3 * motion.rest.rotation.len()];
        rotation[4] = angle;
        motion.set(now, &rotation, &[0.0; 3], &[]).unwrap();
    }

    #[test]
    fn poses_are_shown_smoothly_and_in_time() {
        let (_, mut motion) = motion();
        let angle = |motion: &Motion, now| motion.pose(now).rotation[1].y;
        turned(&mut motion, 1000.0, 0.2);
        assert!((angle(&motion, 1000.0) - 0.2).abs() < 1e-6, "there is nothing to come from");
        turned(&mut motion, 1100.0, 0.4);
        for (now, expected) in [(1100.0, 0.2), (1150.0, 0.3), (1200.0, 0.4), (5000.0, 0.4)] {
            assert!((angle(&motion, now) - expected).abs() < 1e-6, "{} at {now}", angle(&motion, now));
        }
        turned(&mut motion, 9000.0, 0.0);
        assert!((angle(&motion, 9000.0 + TAKES[1])).abs() < 1e-6, "a pause is not made up for");
    }

    #[test]
    fn two_poses_at_once_do_not_jump() {
        let (_, mut motion) = motion();
        turned(&mut motion, 0.0, 0.0);
        turned(&mut motion, 100.0, 0.4);
        turned(&mut motion, 100.0, 0.8);
        assert!(motion.pose(100.0).rotation[1].y.abs() < 1e-6);
        assert!((motion.pose(100.0 + TAKES[0]).rotation[1].y - 0.8).abs() < 1e-6);
    }

    #[test]
    fn what_no_frame_can_show_is_refused_and_changes_nothing() {
        let (avatar, mut motion) = motion();
        let rest = vec![0.0; 3 * avatar.skeleton.len()];
        turned(&mut motion, 0.0, 0.3);
        let mut told = |rotation: &[f32], translation: &[f32]| motion.set(1.0, rotation, translation, &[]).unwrap_err().0;
        assert!(told(&rest[1..], &[0.0; 3]).contains(&format!("expected {}, 3", rest.len())));
        assert!(told(&rest, &[0.0, f32::NAN, 0.0]).contains("NaN"));
        assert!(told(&rest, &[0.0, 1e16, 0.0]).contains("at most 10000"));
        assert!((motion.pose(500.0).rotation[1].y - 0.3).abs() < 1e-6);
        motion.seek(0, f64::NAN);
        assert_eq!(motion.pose(0.0), motion.rest, "there is no such clip");
    }

    #[test]
    fn clips_of_nobody_are_refused() {
        let (avatar, mut motion) = motion();
        assert_eq!(motion.add(demo::clip().unwrap(), &avatar), Ok(0));
        motion.seek(0, 0.5);
        assert_ne!(motion.pose(0.0), motion.rest);
        let stranger = Clip { joint: vec!["tail".into()], rotation: vec![[0.0; 3]], ..Clip::still(&avatar.skeleton) };
        assert!(motion.add(stranger, &avatar).unwrap_err().contains("none of the joints"));
        assert_eq!(motion.clips().count(), 1);
    }
}
