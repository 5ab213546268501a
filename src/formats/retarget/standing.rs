//! Which axis of a file points up: what file, format or rest pose say, unless the bodies of its motion
//! stand along another.

use super::{
    humanoid::Humanoid,
    tree::{positions, spread},
    upright::{AXES, rest_up},
};
use crate::{
    assumption::Assumption,
    capture::{Capture, UpAxis},
};
use glam::DVec3;

/// Cosine of how far a trunk that stands leans at most.
const LEAN: f64 = 0.75;
/// Cosine of how far bodies that stand lean on average at most, from feet to neck: who lies across two
/// axes leans further.
const MEAN_LEAN: f64 = 0.87;
/// How far ankles are below the hips of somebody who stands, of the legs' length.
const FEET: f64 = 0.35;
/// Shares of frames.
const NEARLY_ALL: f64 = 0.9;
const MOST: f64 = 0.6;
const OFTEN: f64 = 0.3;
const SOME: f64 = 0.1;
const HARDLY_ANY: f64 = 0.05;
/// The axes that files of SMPL's family may have up: y of the model, y down of cameras, z of AMASS.
const LIKELY: [DVec3; 3] = [DVec3::Y, DVec3::Z, DVec3::NEG_Y];
/// How much further one floor moves than another before that tells, in lengths of the trunk.
const STEADY: f64 = 0.5;

/// An axis that points up.
pub struct UpDirection {
    pub axis: DVec3,
    /// What the file leaves open, or says otherwise.
    pub assumption: Option<Assumption>,
}

/// The axis of a file that points up.
pub fn up_axis(capture: &Capture, humanoid: &Humanoid) -> UpDirection {
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
            Some(axis) => {
                let other = standing.travels(axis).or_else(|| standing.walks(axis));
                standing.instead(axis, other, "its rest pose has")
            }
            None => standing.open(),
        },
    }
}

/// How bodies stand along each of [`AXES`], in frames spread over a capture.
struct Standing {
    /// Share of the frames.
    share: [f64; 6],
    /// Whether bodies are upright on average in these frames.
    upright: [bool; 6],
    /// How far the lowest point of the body along the axis moves, but for a twentieth of the frames
    /// at either end and in lengths of the trunk: the ground stays where it is.
    floor: [f64; 6],
    /// The same along each axis while bodies stand along another, which is first.
    floors: [[f64; 6]; 6],
    /// Sum of the trunk's directions.
    trunks: DVec3,
}

fn place(axis: DVec3) -> usize {
    AXES.iter().position(|own| *own == axis).unwrap_or_default()
}

fn name(axis: DVec3) -> &'static str {
    ["y", "z", "-y", "-z", "x", "-x"][place(axis)]
}

impl Standing {
    fn of(capture: &Capture, humanoid: &Humanoid) -> Self {
        let body = body(humanoid);
        let mut lowest: [Vec<f64>; 6] = Default::default();
        // Of the frames that stand along each axis, the lowest points along all.
        let mut while_standing: [[Vec<f64>; 6]; 6] = Default::default();
        let mut toward = [DVec3::ZERO; 6];
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
            let low = AXES.map(|axis| {
                let heights = body.iter().map(|&joint| at[joint].dot(axis));
                heights.fold(f64::INFINITY, f64::min)
            });
            push(&mut lowest, low);
            for (place, axis) in AXES.into_iter().enumerate() {
                let legs_stand = legs.is_none_or(|legs| legs.dot(axis) > FEET * length);
                if along.dot(axis) > LEAN && legs_stand {
                    toward[place] += trunk + legs.unwrap_or_default();
                    push(&mut while_standing[place], low);
                }
            }
        }
        let frames = frames.count() as f64;
        let trunk = (lengths / frames).max(f64::MIN_POSITIVE);
        let leans = |place: usize| toward[place].normalize_or_zero().dot(AXES[place]);
        let share = |place: usize| while_standing[place][place].len() as f64 / frames;
        let share = std::array::from_fn(share);
        let floor = |heights| range(heights) / trunk;
        Self {
            share,
            upright: std::array::from_fn(|place| leans(place) > MEAN_LEAN),
            floor: lowest.map(floor),
            floors: while_standing.map(|lowest| lowest.map(floor)),
            trunks,
        }
    }

    fn steadier(&self, axis: DVec3, other: DVec3) -> bool {
        self.floor[place(axis)] + STEADY < self.floor[place(other)]
    }

    /// The axis of these that bodies stand along: of those of some frames the one whose ground is
    /// steadiest, else that of the most frames; of as many the first.
    fn best(&self, axes: &[DVec3]) -> Option<DVec3> {
        let share = |axis: &DVec3| self.share[place(*axis)];
        let often = axes.iter().copied().filter(|axis| share(axis) >= SOME);
        let mut steadiest = often.clone().filter(|axis| {
            let mut others = often.clone().filter(|other| other != axis);
            others.all(|other| self.steadier(*axis, other))
        });
        let more = |best, axis| {
            let more = share(&axis) > share(&best) + HARDLY_ANY;
            if more { axis } else { best }
        };
        steadiest.next().or_else(|| often.clone().reduce(more))
    }

    /// Whether most frames stand along one axis, and hardly any along another.
    fn mostly(&self, axis: DVec3, other: DVec3) -> bool {
        self.share[place(axis)] >= MOST && self.share[place(other)] < HARDLY_ANY
    }

    /// The axis that most frames stand along while they travel over its ground, which another's is
    /// not. Somebody who lies still in all frames does not.
    fn travels(&self, other: DVec3) -> Option<DVec3> {
        let travels = |axis: &DVec3| self.mostly(*axis, other) && self.steadier(*axis, other);
        self.best(&AXES).filter(travels)
    }

    /// An axis whose ground bodies walk over while they stand along it, which is not that of another
    /// axis. Somebody who lies down does not.
    fn walks(&self, other: DVec3) -> Option<DVec3> {
        AXES.into_iter().find(|&axis| {
            let floors = &self.floors[place(axis)];
            self.share[place(axis)] >= OFTEN && floors[place(axis)] + STEADY < floors[place(other)]
        })
    }

    /// The opposite of an axis, if nearly all frames stand along it and hardly any the right way up.
    fn upside_down(&self, axis: DVec3) -> Option<DVec3> {
        let flipped = self.mostly(-axis, axis) && self.share[place(-axis)] >= NEARLY_ALL;
        flipped.then_some(-axis)
    }

    /// An axis, or another that goes before it. Says which, where bodies stand along another.
    fn instead(&self, axis: DVec3, other: Option<DVec3>, who: &str) -> UpDirection {
        let taken = other.unwrap_or(axis);
        let stand = other.or_else(|| self.best(&AXES).filter(|&best| self.mostly(best, axis)));
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
        UpDirection {
            axis: taken,
            assumption,
        }
    }

    /// The axis that files of a kind usually have: bodies that stand along another likely one go
    /// before it, along others only if they travel; who stands so in place lies.
    fn usual(&self, axis: DVec3, whose: &str) -> UpDirection {
        let upright = |axis: DVec3| self.upright[place(axis)];
        let stand = self.share.iter().sum::<f64>() >= MOST;
        let usually = upright(axis) && self.share[place(axis)] >= HARDLY_ANY;
        let elsewhere = |other: DVec3| stand && !usually && !self.steadier(axis, other);
        let mut likely = LIKELY.to_vec();
        likely.retain(|&other| upright(other) || self.steadier(other, axis));
        let other = self.best(&likely).or_else(|| self.best(&AXES));
        let is_likely = |other: DVec3| likely.contains(&other);
        let other = other
            .filter(|&other| self.steadier(other, axis) || (is_likely(other) && elsewhere(other)));
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
    fn open(&self) -> UpDirection {
        if let Some(axis) = self.best(&AXES) {
            return UpDirection {
                axis,
                assumption: None,
            };
        }
        let along = |axis: &DVec3| self.trunks.dot(*axis);
        let nearest = AXES
            .into_iter()
            .max_by(|a, b| along(a).total_cmp(&along(b)));
        let axis = nearest.unwrap_or(DVec3::Y);
        UpDirection {
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

/// A value to each of some lists.
fn push(lists: &mut [Vec<f64>; 6], values: [f64; 6]) {
    for (list, value) in lists.iter_mut().zip(values) {
        list.push(value);
    }
}

/// From the lowest value to the highest, but for a twentieth at either end.
fn range(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let few = values.len() / 20;
    let at = |place: usize| values.get(place).copied().unwrap_or_default();
    at(values.len().saturating_sub(1 + few)) - at(few)
}
