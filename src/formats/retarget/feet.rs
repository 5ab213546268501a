//! Feet on the ground: where the capture's feet stand still, the avatar's do too, and no sole is
//! under the ground.
//!
//! Bodies have other proportions than the capture's, so limbs that point where its limbs point put
//! feet elsewhere. A foot's *contact* is found in the capture; the avatar's ball is held where it is
//! on average during the contact, corrections fade from one contact to the next, hips sink where a
//! leg would be too short, and the knee is bent to suit.

use super::{humanoid::Leg, legs::bend, tree::positions, window::smooth};
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DAffine3, DVec3};
use std::ops::Range;

/// A ball that moves slower than this, metres a second, and is lower than [`LOW`] begins a contact.
const SLOW: f64 = 0.2;
/// One that moves faster ends it.
const FAST: f64 = 0.35;
/// Speeds are measured over so many seconds before and after.
const STEP: f64 = 1.0 / 60.0;
/// Metres above the ground, beyond where the ball is when it stands.
const LOW: f64 = 0.05;
/// Seconds that a contact lasts at least.
const SHORTEST: f64 = 0.08;
/// Seconds in which a correction fades before the first contact and after the last.
const FADE: f64 = 0.25;
/// Share of a leg's length beyond which it is not stretched.
const REACH: f64 = 0.998;
/// Sinking hips are smoothed over so many seconds before and after.
const SMOOTH: f64 = 0.1;

/// A way of a foot over the ground, a position each frame, metres and y up.
pub struct FootPath {
    /// The ball; the ankle, where there is none.
    pub ball: Vec<DVec3>,
}

impl FootPath {
    /// Lowest height of the ball in all but a twentieth of the frames.
    pub fn ground(&self) -> f64 {
        low(self.ball.iter().map(|ball| ball.y))
    }

    /// Frames in which the foot stands. `rate`: frames a second.
    pub fn contacts(&self, rate: f64, ground: f64) -> Vec<Range<usize>> {
        // Between two frames of a high rate there is more noise than way.
        let step = (rate * STEP).round().max(1.0) as usize;
        let speed = |frame: usize| {
            let last = self.ball.len() - 1;
            let [before, after] = [frame.saturating_sub(step), (frame + step).min(last)];
            let seconds = (after - before).max(1) as f64 / rate;
            self.ball[after].distance(self.ball[before]) / seconds
        };
        let mut contacts: Vec<Range<usize>> = vec![];
        let mut start = None;
        for frame in 0..=self.ball.len() {
            let stands = frame < self.ball.len()
                && self.ball[frame].y < ground + LOW
                && speed(frame) < if start.is_some() { FAST } else { SLOW };
            match (start, stands) {
                (None, true) => start = Some(frame),
                (Some(begin), false) => {
                    if (frame - begin) as f64 >= SHORTEST * rate {
                        contacts.push(begin..frame);
                    }
                    start = None;
                }
                _ => {}
            }
        }
        contacts
    }
}

/// The lowest value but for the deepest twentieth.
pub fn low(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 20).copied().unwrap_or(0.0)
}

/// A point under a foot.
#[derive(Clone, Copy, Debug)]
struct Sole {
    joint: usize,
    /// From the joint in the rest pose, metres.
    offset: DVec3,
}

/// Heels, balls and toes of each foot.
pub struct Soles {
    feet: [Vec<Sole>; 2],
}

/// Highest that a ball's joint may be above the floor of a rest pose that stands on y = 0, metres.
const HIGHEST_BALL: f64 = 0.15;
/// Height of a ball's joint over the sole where the rest pose does not stand on y = 0, metres.
const BALL: f64 = 0.03;

impl Soles {
    /// The soles of an avatar.
    pub fn new(skeleton: &Skeleton, legs: &[Leg; 2]) -> Self {
        let rest = |joint: usize| DVec3::from(skeleton.rest[joint].map(f64::from));
        let feet = legs.each_ref().map(|leg| {
            let ball = leg.toe.unwrap_or(leg.foot);
            let height = rest(ball).y;
            let floor = if (0.0..HIGHEST_BALL).contains(&height) {
                0.0
            } else {
                height - BALL
            };
            let sole = |joint: usize, forward: f64| Sole {
                joint,
                offset: DVec3::new(0.0, floor - rest(joint).y, forward),
            };
            vec![sole(leg.foot, -0.05), sole(ball, 0.0), sole(ball, 0.07)]
        });
        Self { feet }
    }

    /// The lowest point of a foot, metres.
    pub fn lowest(&self, foot: usize, joints: &[DAffine3]) -> f64 {
        let height = |sole: &Sole| joints[sole.joint].transform_point3(sole.offset).y;
        self.feet[foot]
            .iter()
            .map(height)
            .fold(f64::INFINITY, f64::min)
    }

    /// Where the ball touches the ground.
    pub fn ball(&self, foot: usize, joints: &[DAffine3]) -> DVec3 {
        let sole = self.feet[foot][1];
        joints[sole.joint].transform_point3(sole.offset)
    }
}

/// Moves all poses by one height, so that soles touch y = 0 in all but the deepest twentieth of the
/// frames.
pub fn stand(skeleton: &Skeleton, legs: &[Leg; 2], poses: &mut [Pose]) {
    let soles = Soles::new(skeleton, legs);
    let ground = low(poses.iter().map(|pose| {
        let joints = skeleton.joints(pose);
        soles.lowest(0, &joints).min(soles.lowest(1, &joints))
    }));
    for pose in poses {
        pose.translation.y -= ground;
    }
}

/// Puts poses' feet on the ground y = 0. `contacts`: frames in which each foot stands; `rate`:
/// frames a second.
pub fn place(
    skeleton: &Skeleton,
    body: &[Leg; 2],
    poses: &mut [Pose],
    contacts: &[Vec<Range<usize>>; 2],
    rate: f64,
) {
    let soles = Soles::new(skeleton, body);
    let mut legs: Vec<[LegFrame; 2]> = poses
        .iter()
        .map(|pose| LegFrame::both(skeleton, body, &soles, pose))
        .collect();
    let ground = low(legs.iter().map(|[a, b]| a.lowest.min(b.lowest)));
    for leg in legs.iter_mut().flatten() {
        leg.lower(ground);
    }
    for foot in [0, 1] {
        let balls: Vec<DVec3> = legs.iter().map(|legs| legs[foot].ball).collect();
        let moves = corrections(&balls, &contacts[foot], rate);
        for (legs, mut way) in legs.iter_mut().zip(moves) {
            let leg = &mut legs[foot];
            way.y += (-leg.lowest - way.y).max(0.0);
            leg.ankle += way;
        }
    }
    let drop = |leg: &LegFrame| drop_to_reach(leg.hip, leg.ankle, REACH * leg.length);
    let drops: Vec<f64> = legs
        .iter()
        .map(|[left, right]| drop(left).max(drop(right)))
        .collect();
    let drops = smooth(&drops, (SMOOTH * rate) as usize, |drop| drop);
    for ((pose, legs), drop) in poses.iter_mut().zip(&legs).zip(drops) {
        pose.translation.y -= ground + drop;
        for (leg, own) in body.iter().zip(legs) {
            bend(skeleton, pose, leg, own.ankle);
        }
    }
}

/// A leg in a frame, metres.
struct LegFrame {
    /// The hip joint.
    hip: DVec3,
    /// Where the ankle is, and then where it shall be.
    ankle: DVec3,
    /// Of thigh and shin.
    length: f64,
    /// Where the ball touches the ground.
    ball: DVec3,
    /// Height of the lowest point of the sole.
    lowest: f64,
}

impl LegFrame {
    fn both(skeleton: &Skeleton, body: &[Leg; 2], soles: &Soles, pose: &Pose) -> [Self; 2] {
        let joints = skeleton.joints(pose);
        let at = positions(&joints);
        [0, 1].map(|foot| {
            let leg = &body[foot];
            let [hip, knee, ankle] = [leg.thigh, leg.shin, leg.foot].map(|joint| at[joint]);
            Self {
                hip,
                ankle,
                length: hip.distance(knee) + knee.distance(ankle),
                ball: soles.ball(foot, &joints),
                lowest: soles.lowest(foot, &joints),
            }
        })
    }

    /// Moves all of it down.
    fn lower(&mut self, height: f64) {
        for place in [&mut self.hip, &mut self.ankle, &mut self.ball] {
            place.y -= height;
        }
        self.lowest -= height;
    }
}

/// How far to move a ball in each frame so that it stands still on y = 0 during its contacts.
fn corrections(balls: &[DVec3], contacts: &[Range<usize>], rate: f64) -> Vec<DVec3> {
    let mut moves = vec![DVec3::ZERO; balls.len()];
    for contact in contacts {
        let frames = &balls[contact.clone()];
        let middle = frames.iter().sum::<DVec3>() / frames.len() as f64;
        for frame in contact.clone() {
            moves[frame] = middle.with_y(0.0) - balls[frame];
        }
    }
    let fade = (FADE * rate).max(1.0);
    let mut before: Option<usize> = None;
    // The contact that a frame is in, or the next one.
    let mut ahead = contacts.iter().peekable();
    for frame in 0..balls.len() {
        while let Some(past) = ahead.next_if(|contact| contact.end <= frame) {
            before = Some(past.end - 1);
        }
        let next = ahead.peek().map(|contact| contact.start);
        if next.is_some_and(|start| start <= frame) {
            continue;
        }
        moves[frame] = match (before, next) {
            (Some(before), Some(next)) => {
                let share = (frame - before) as f64 / (next - before) as f64;
                moves[before].lerp(moves[next], ease(share))
            }
            (Some(before), None) => moves[before] * ease(1.0 - (frame - before) as f64 / fade),
            (None, Some(next)) => moves[next] * ease(1.0 - (next - frame) as f64 / fade),
            (None, None) => DVec3::ZERO,
        };
    }
    moves
}

/// From 0 to 1 without a jump of speed at either end.
fn ease(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// How far a hip joint sinks until a goal is not further away than a length; 0 if it never is.
fn drop_to_reach(hip: DVec3, goal: DVec3, length: f64) -> f64 {
    let way = hip - goal;
    let flat = way.with_y(0.0).length();
    if way.length() <= length || flat >= length {
        return 0.0;
    }
    (way.y - (length * length - flat * flat).sqrt()).max(0.0)
}
