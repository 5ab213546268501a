//! The avatar's pose: a time of a clip, or live poses, between which it moves smoothly.

use effigy_core::avatar::{Avatar, Clip, Pose, limits, motion::Player};
use glam::DVec3;

/// A movement from one live pose to the next. It takes as long as it was from the arrival of the
/// pose before to the arrival of this one.
struct LivePose {
    from: Pose,
    to: Pose,
    /// When `to` arrived, ms.
    since: f64,
    /// How long the movement takes, ms.
    duration: f64,
}

/// Shortest movement to a live pose, ms: two that arrive at once do not jump.
const DURATION_MIN: f64 = 8.0;
/// Longest movement to a live pose, ms: the first one after a pause does not lag.
const DURATION_MAX: f64 = 250.0;

/// Why a pose is invalid.
#[derive(Debug, PartialEq)]
pub struct InvalidPose(pub String);

/// The source of the pose.
enum PoseSource {
    Clip { index: usize, seconds: f64 },
    Live(LivePose),
}

/// The motion of an avatar.
pub struct AvatarMotion {
    players: Vec<Player>,
    source: PoseSource,
    rest: Pose,
}

impl AvatarMotion {
    /// At rest, without a clip.
    pub fn new(avatar: &Avatar) -> Self {
        let rest = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
        Self {
            players: Vec::new(),
            source: PoseSource::Clip {
                index: 0,
                seconds: 0.0,
            },
            rest,
        }
    }

    /// Adds a clip. Returns its index.
    ///
    /// # Errors
    /// If it moves no joint of the avatar: a sentence that says so.
    pub fn add(&mut self, clip: Clip, avatar: &Avatar) -> Result<usize, String> {
        let moves_any_joint = clip.map_to(&avatar.skeleton).iter().any(Option::is_some);
        if !moves_any_joint {
            return Err(format!(
                "the clip `{}` moves none of the joints of `{}`",
                clip.name, avatar.name
            ));
        }
        self.players.push(Player::new(clip, &avatar.skeleton));
        Ok(self.players.len() - 1)
    }

    /// The clips, by index.
    pub fn clips(&self) -> impl Iterator<Item = &Clip> {
        self.players.iter().map(Player::clip)
    }

    /// Shows a clip at a time, seconds. NaN and infinities are the start.
    pub fn seek(&mut self, index: usize, seconds: f64) {
        self.source = PoseSource::Clip {
            index,
            seconds: if seconds.is_finite() { seconds } else { 0.0 },
        };
    }

    /// Moves to a live pose that arrives at `now`, ms. `rotation`: axis-angle, radians, three
    /// numbers a joint. `translation`: of the root, metres, three numbers. `expression`: missing
    /// numbers are 0.
    ///
    /// # Errors
    /// If the pose has the wrong number of numbers, or some that can't be drawn. Then nothing
    /// changes.
    pub fn set_pose(
        &mut self,
        now: f64,
        rotation: &[f32],
        translation: &[f32],
        expression: &[f32],
    ) -> Result<(), InvalidPose> {
        self.check(rotation, translation, expression)?;
        let vector = |v: &[f32]| DVec3::new(v[0].into(), v[1].into(), v[2].into());
        let to = Pose {
            rotation: rotation.chunks_exact(3).map(vector).collect(),
            translation: vector(translation),
            expression: (0..self.rest.expression.len())
                .map(|index| expression.get(index).copied().unwrap_or_default().into())
                .collect(),
        };
        let duration = match &self.source {
            PoseSource::Live(live) => (now - live.since).clamp(DURATION_MIN, DURATION_MAX),
            PoseSource::Clip { .. } => 0.0,
        };
        self.source = PoseSource::Live(LivePose {
            from: self.pose(now),
            to,
            since: now,
            duration,
        });
        Ok(())
    }

    fn check(
        &self,
        rotation: &[f32],
        translation: &[f32],
        expression: &[f32],
    ) -> Result<(), InvalidPose> {
        let joints = self.rest.rotation.len();
        if rotation.len() != 3 * joints
            || translation.len() != 3
            || expression.len() > self.rest.expression.len()
        {
            let found = format!(
                "{} rotations, {} translations, {} expressions",
                rotation.len(),
                translation.len(),
                expression.len()
            );
            let expected = format!(
                "{}, 3 and at most {}",
                3 * joints,
                self.rest.expression.len()
            );
            return Err(InvalidPose(format!(
                "a pose of {found} was found, expected {expected}"
            )));
        }
        if let Some(number) = rotation
            .iter()
            .chain(translation)
            .chain(expression)
            .find(|number| !number.is_finite())
        {
            return Err(InvalidPose(format!(
                "a pose has the number {number}, expected finite ones"
            )));
        }
        if let Some(metres) = translation
            .iter()
            .find(|metres| f64::from(metres.abs()) > limits::LENGTH)
        {
            return Err(InvalidPose(format!(
                "a pose's translation is {metres} m, expected at most {}",
                limits::LENGTH
            )));
        }
        Ok(())
    }

    /// The pose at `now`, ms.
    pub fn pose(&self, now: f64) -> Pose {
        match &self.source {
            PoseSource::Clip { index, seconds } => match self.players.get(*index) {
                Some(player) => player.pose(*seconds),
                None => self.rest.clone(),
            },
            PoseSource::Live(live) => {
                let elapsed = now - live.since;
                if elapsed < live.duration {
                    live.from
                        .between(&live.to, (elapsed / live.duration).max(0.0))
                } else {
                    live.to.clone()
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion() -> (Avatar, AvatarMotion) {
        let avatar = effigy_demo::avatar().unwrap();
        let motion = AvatarMotion::new(&avatar);
        (avatar, motion)
    }

    fn turn(motion: &mut AvatarMotion, now: f64, angle: f32) {
        let mut rotation = vec![0.0; 3 * motion.rest.rotation.len()];
        rotation[4] = angle;
        motion.set_pose(now, &rotation, &[0.0; 3], &[]).unwrap();
    }

    #[test]
    fn live_poses_are_interpolated() {
        let (_, mut motion) = motion();
        let angle = |motion: &AvatarMotion, now| motion.pose(now).rotation[1].y;
        turn(&mut motion, 1000.0, 0.2);
        assert!(
            (angle(&motion, 1000.0) - 0.2).abs() < 1e-6,
            "the first pose is shown at once"
        );
        turn(&mut motion, 1100.0, 0.4);
        for (now, expected) in [(1100.0, 0.2), (1150.0, 0.3), (1200.0, 0.4), (5000.0, 0.4)] {
            assert!(
                (angle(&motion, now) - expected).abs() < 1e-6,
                "{} at {now}",
                angle(&motion, now)
            );
        }
        turn(&mut motion, 9000.0, 0.0);
        assert!(
            (angle(&motion, 9000.0 + DURATION_MAX)).abs() < 1e-6,
            "a pause is not part of the movement"
        );
    }

    #[test]
    fn two_poses_at_once_do_not_jump() {
        let (_, mut motion) = motion();
        turn(&mut motion, 0.0, 0.0);
        turn(&mut motion, 100.0, 0.4);
        turn(&mut motion, 100.0, 0.8);
        assert!(motion.pose(100.0).rotation[1].y.abs() < 1e-6);
        assert!((motion.pose(100.0 + DURATION_MIN).rotation[1].y - 0.8).abs() < 1e-6);
    }

    #[test]
    fn an_invalid_pose_is_refused_and_changes_nothing() {
        let (avatar, mut motion) = motion();
        let rest = vec![0.0; 3 * avatar.skeleton.len()];
        turn(&mut motion, 0.0, 0.3);
        let mut refusal = |rotation: &[f32], translation: &[f32]| {
            motion
                .set_pose(1.0, rotation, translation, &[])
                .unwrap_err()
                .0
        };
        assert!(refusal(&rest[1..], &[0.0; 3]).contains(&format!("expected {}, 3", rest.len())));
        assert!(refusal(&rest, &[0.0, f32::NAN, 0.0]).contains("NaN"));
        assert!(refusal(&rest, &[0.0, 1e16, 0.0]).contains("at most 10000"));
        assert!((motion.pose(500.0).rotation[1].y - 0.3).abs() < 1e-6);
        motion.seek(0, f64::NAN);
        assert_eq!(motion.pose(0.0), motion.rest, "there is no such clip");
    }

    #[test]
    fn a_clip_that_moves_no_joint_is_refused() {
        let (avatar, mut motion) = motion();
        assert_eq!(motion.add(effigy_demo::clip().unwrap(), &avatar), Ok(0));
        motion.seek(0, 0.5);
        assert_ne!(motion.pose(0.0), motion.rest);
        let stranger = Clip {
            joint: vec!["tail".into()],
            rotation: vec![[0.0; 3]],
            ..Clip::still(&avatar.skeleton)
        };
        assert!(
            motion
                .add(stranger, &avatar)
                .unwrap_err()
                .contains("none of the joints")
        );
        assert_eq!(motion.clips().count(), 1);
    }
}
