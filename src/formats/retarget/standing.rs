//! Which axis of a file points up: what file, format or rest pose say, unless the bodies of its motion
//! stand along another.

use super::{
    humanoid::Humanoid,
    tree::positions,
    upright::{AXES, rest_up, spread},
};
use crate::{
    assumption::Assumption,
    capture::{Capture, UpAxis},
};
use glam::DVec3;

/// Cosine of how far a trunk that stands leans at most.
const LEAN: f64 = 0.75;
/// How far ankles are below the hips of somebody who stands, of the legs' length.
const FEET: f64 = 0.35;
/// Shares of frames.
const NEARLY_ALL: f64 = 0.9;
const MOST: f64 = 0.6;
const SOME: f64 = 0.1;
const HARDLY_ANY: f64 = 0.05;
/// How much further one floor moves than another before that tells, in lengths of the trunk.
const STEADY: f64 = 0.5;

/// An axis that points up.
pub struct Up {
    pub axis: DVec3,
    /// What the file leaves open, or says otherwise.
    pub assumption: Option<Assumption>,
}

/// The axis of a file that points up.
pub fn up_axis(capture: &Capture, humanoid: &Humanoid) -> Up {
    let standing = Standing::of(capture, humanoid);
    let rest = || {
        let poses = !capture.model_rest;
        poses.then(|| rest_up(capture, humanoid, DVec3::Y))?
    };
    match capture.up {
        UpAxis::Said(axis) if capture.model_rest => {
            let other = standing
                .travels(axis)
                .or_else(|| standing.upside_down(axis));
            standing.instead(axis, other, "files of its kind have")
        }
        // Somebody may lie or swim in all frames of an animation, but nobody rests so.
        UpAxis::Said(axis) => {
            let other = rest().filter(|&other| standing.mostly(other, axis));
            let other = other.or_else(|| standing.travels(axis));
            standing.instead(axis, other, "the file says")
        }
        UpAxis::Usual { axis, whose } => standing.usual(axis, whose),
        UpAxis::Open => match rest() {
            Some(axis) => standing.instead(axis, standing.travels(axis), "its rest pose has"),
            None => standing.open(),
        },
    }
}

/// How bodies stand along each of [`AXES`], in frames spread over a capture.
struct Standing {
    /// Share of the frames.
    share: [f64; 6],
    /// How far the lowest point of the body along the axis moves, but for a twentieth of the frames
    /// at either end and in lengths of the trunk: the ground stays where it is.
    floor: [f64; 6],
    /// Sum of the trunk's directions.
    trunks: DVec3,
}

fn place(axis: DVec3) -> usize {
    AXES.iter().position(|own| *own == axis).unwrap_or_default()
}

fn name(axis: DVec3) -> &'static str {
    ["x", "-x", "y", "-y", "z", "-z"][place(axis)]
}

impl Standing {
    fn of(capture: &Capture, humanoid: &Humanoid) -> Self {
        let body = body(humanoid);
        let mut count = [0.0; 6];
        let mut lowest: [Vec<f64>; 6] = Default::default();
        let mut lengths = 0.0;
        let mut trunks = DVec3::ZERO;
        let frames = spread(capture.frames());
        for frame in frames.clone() {
            let at = positions(&capture.world(frame));
            let hips = humanoid.middle_of_hips(&at);
            let trunk = at[humanoid.above_chest()] - hips;
            let along = trunk.normalize_or_zero();
            let legs = humanoid.middle_of_feet(&at).map(|feet| hips - feet);
            let length = humanoid.leg_length(&at).unwrap_or_default();
            trunks += along;
            lengths += trunk.length();
            for (place, axis) in AXES.into_iter().enumerate() {
                let legs_stand = legs.is_none_or(|legs| legs.dot(axis) > FEET * length);
                count[place] += f64::from(u8::from(along.dot(axis) > LEAN && legs_stand));
                let heights = body.iter().map(|&joint| at[joint].dot(axis));
                lowest[place].push(heights.fold(f64::INFINITY, f64::min));
            }
        }
        let frames = frames.count() as f64;
        let trunk = lengths / frames;
        Self {
            share: count.map(|count| count / frames),
            floor: lowest.map(|heights| range(heights) / trunk.max(f64::MIN_POSITIVE)),
            trunks,
        }
    }

    fn steadier(&self, axis: DVec3, other: DVec3) -> bool {
        self.floor[place(axis)] + STEADY < self.floor[place(other)]
    }

    /// The axis that bodies stand along: of those of some frames the one whose ground is steadiest,
    /// else that of the most frames.
    fn best(&self) -> Option<DVec3> {
        let often = AXES
            .into_iter()
            .filter(|axis| self.share[place(*axis)] >= SOME);
        let mut steadiest = often.clone().filter(|axis| {
            let mut others = often.clone().filter(|other| other != axis);
            others.all(|other| self.steadier(*axis, other))
        });
        let share = |axis: &DVec3| self.share[place(*axis)];
        steadiest
            .next()
            .or_else(|| often.clone().max_by(|a, b| share(a).total_cmp(&share(b))))
    }

    /// Whether most frames stand along one axis, and hardly any along another.
    fn mostly(&self, axis: DVec3, other: DVec3) -> bool {
        self.share[place(axis)] >= MOST && self.share[place(other)] < HARDLY_ANY
    }

    /// The axis that most frames stand along while they travel over its ground, which another's is
    /// not. Somebody who lies still in all frames does not.
    fn travels(&self, other: DVec3) -> Option<DVec3> {
        let travels = |axis: &DVec3| self.mostly(*axis, other) && self.steadier(*axis, other);
        self.best().filter(travels)
    }

    /// The opposite of an axis, if nearly all frames stand along it and hardly any the right way up.
    fn upside_down(&self, axis: DVec3) -> Option<DVec3> {
        let flipped = self.mostly(-axis, axis) && self.share[place(-axis)] >= NEARLY_ALL;
        flipped.then_some(-axis)
    }

    /// An axis, or another that goes before it. Says which, where bodies stand along another.
    fn instead(&self, axis: DVec3, other: Option<DVec3>, who: &str) -> Up {
        let taken = other.unwrap_or(axis);
        let stand = other.or_else(|| self.best().filter(|&best| self.mostly(best, axis)));
        let assumption = stand.map(|stand| Assumption {
            what: "up axis",
            taken: name(taken).into(),
            because: format!(
                "bodies stand along {} in {:.0} % of the frames; {who} {}",
                name(stand),
                100.0 * self.share[place(stand)],
                name(axis)
            ),
        });
        Up {
            axis: taken,
            assumption,
        }
    }

    /// The axis that files of a kind usually have: bodies that stand along another go before it.
    fn usual(&self, axis: DVec3, whose: &str) -> Up {
        let stand = self.share.iter().sum::<f64>() >= MOST;
        let elsewhere = stand && self.share[place(axis)] < HARDLY_ANY;
        let other = self
            .best()
            .filter(|&best| (elsewhere && !self.steadier(axis, best)) || self.steadier(best, axis));
        let who = format!("{whose} have");
        let mut up = self.instead(axis, other.filter(|&other| other != axis), &who);
        if up.axis == axis && self.share[place(axis)] < SOME {
            up.assumption = Some(Assumption {
                what: "up axis",
                taken: format!("{}, as {who}", name(axis)),
                because: "bodies stand along no axis long enough to tell".into(),
            });
        }
        up
    }

    /// The axis of a file that says nothing.
    fn open(&self) -> Up {
        if let Some(axis) = self.best() {
            return Up {
                axis,
                assumption: None,
            };
        }
        let along = |axis: &DVec3| self.trunks.dot(*axis);
        let nearest = AXES
            .into_iter()
            .max_by(|a, b| along(a).total_cmp(&along(b)));
        let axis = nearest.unwrap_or(DVec3::Y);
        Up {
            axis,
            assumption: Some(Assumption {
                what: "up axis",
                taken: format!("{}, along which trunks are on average", name(axis)),
                because: "bodies stand along no axis long enough to tell".into(),
            }),
        }
    }
}

/// Joints that may touch the ground.
fn body(humanoid: &Humanoid) -> Vec<usize> {
    let arms = humanoid.arms.iter();
    let arms = arms.flat_map(|arm| [arm.upper, arm.forearm, arm.hand]);
    let legs = humanoid.legs().iter();
    let legs = legs.flat_map(|leg| [leg.shin, leg.foot, leg.toe.unwrap_or(leg.foot)]);
    let trunk = [humanoid.hips, humanoid.head];
    trunk.into_iter().chain(arms).chain(legs).collect()
}

/// From the lowest value to the highest, but for a twentieth at either end.
fn range(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let few = values.len() / 20;
    let at = |place: usize| values.get(place).copied().unwrap_or_default();
    at(values.len().saturating_sub(1 + few)) - at(few)
}
