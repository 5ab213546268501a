//! Where limbs begin by how they move: a check of what names and the tree's shape say, which the report
//! measures against.
//!
//! An upper arm or a thigh is the first bone from the trunk outwards that is long and turns against the
//! trunk. Collar bones are short and hardly turn.

use super::{
    humanoid::Humanoid,
    tree::{Tree, positions},
    upright::{Upright, spread},
};
use crate::assumption::Assumption;
use glam::DVec3;

/// Length of a limb's bones beside the longer of the two.
const LONG: f64 = 0.7;
/// How far a bone turns in a tenth of the frames at least, radians.
const TURNS: f64 = 0.26;
/// How far two bones in a line bend against each other in all but a tenth of the frames, radians.
const STRAIGHT: f64 = 0.14;

/// The joints of a limb: shoulder, elbow and wrist, or hip, knee and ankle.
pub type Joints = [usize; 3];

/// The limbs of a body.
pub struct Limbs {
    /// Left and right arm, left and right leg, if there are any.
    pub joints: Vec<Joints>,
    /// Those that other joints were taken for.
    pub doubts: Vec<Assumption>,
}

/// The limbs as the motion shows them, and as they were found where it shows nothing else.
pub fn limbs(tree: &Tree, body: &Humanoid, upright: &Upright) -> Limbs {
    let arms = body.arms.iter();
    let arms = arms.map(|arm| (body.chest(), [arm.upper, arm.forearm, arm.hand]));
    let legs = body.legs().iter();
    let legs = legs.map(|leg| (body.hips, [leg.thigh, leg.shin, leg.foot]));
    let names = ["left arm", "right arm", "left leg", "right leg"];
    let mut limbs = Limbs {
        joints: vec![],
        doubts: vec![],
    };
    for (what, (trunk, taken)) in names.into_iter().zip(arms.chain(legs)) {
        let shown = Chain::new(tree, upright, trunk, taken).and_then(|chain| chain.other(taken));
        if let Some(shown) = shown {
            let [taken, shown] = [taken[0], shown[0]].map(|joint| &tree.names[joint]);
            limbs.doubts.push(Assumption {
                what,
                taken: format!("to begin at `{taken}`"),
                because: format!("but the bone that begins at `{shown}` turns against the trunk"),
            });
        }
        limbs.joints.push(shown.unwrap_or(taken));
    }
    limbs
}

/// Joints from a trunk to the end of a limb, and where they are.
struct Chain {
    joints: Vec<usize>,
    /// A list for each frame, in the trunk's axes.
    at: Vec<Vec<DVec3>>,
}

impl Chain {
    fn new(tree: &Tree, upright: &Upright, trunk: usize, taken: Joints) -> Option<Self> {
        let last = taken[2];
        let far = |joint: &usize| tree.rest[*joint].distance(tree.rest[last]);
        let end = (0..tree.len())
            .filter(|&joint| tree.is_above(last, joint))
            .max_by(|a, b| far(a).total_cmp(&far(b)))?;
        let joints = tree.path(trunk, end);
        let frames = spread(upright.capture().frames()).map(|frame| {
            let world = upright.world(frame);
            let inner = world[trunk].inverse();
            let at = positions(&world);
            let place = |&joint: &usize| inner.transform_point3(at[joint]);
            joints.iter().map(place).collect()
        });
        let at = frames.collect();
        Some(Self { joints, at })
    }

    /// From one joint to another in each frame.
    fn ways(&self, from: usize, to: usize) -> impl Iterator<Item = DVec3> + Clone {
        self.at.iter().map(move |at| at[to] - at[from])
    }

    fn length(&self, from: usize, to: usize) -> f64 {
        self.ways(from, to).map(DVec3::length).sum::<f64>() / self.at.len().max(1) as f64
    }

    /// Whether what is between two joints turns against the trunk.
    fn turns(&self, from: usize, to: usize) -> bool {
        let ways = self.ways(from, to).filter_map(DVec3::try_normalize);
        let Some(mean) = ways.clone().sum::<DVec3>().try_normalize() else {
            return false;
        };
        nine_tenths(ways.map(|way| way.angle_between(mean)).collect()) > TURNS
    }

    /// The last joint of those that are in a line with a bone that begins at a joint.
    fn line(&self, from: usize) -> usize {
        let mut end = from + 1;
        while end + 1 < self.joints.len() {
            let bends = self.ways(from, end).zip(self.ways(end, end + 1));
            let bends = bends
                .map(|(a, b)| a.angle_between(b))
                .filter(|bend| bend.is_finite());
            if nine_tenths(bends.collect()) > STRAIGHT {
                break;
            }
            end += 1;
        }
        end
    }

    /// The joints of the limb where they are not those that were taken.
    fn other(&self, taken: Joints) -> Option<Joints> {
        let place = |joint: usize| self.joints.iter().position(|own| *own == joint);
        let [upper, lower, end] = [place(taken[0])?, place(taken[1])?, place(taken[2])?];
        let own = self.length(upper, lower);
        let long = LONG * own.max(self.length(lower, end));
        let begins = |from: usize| {
            let to = self.line(from);
            (self.length(from, to) >= long && self.turns(from, to)).then_some(from)
        };
        let last = self.joints.len() - 1;
        // What is above must be another bone; what is below counts if this one is a collar bone.
        let above = (0..upper)
            .filter(|&from| self.line(from) <= upper)
            .find_map(begins);
        let from = above.or_else(|| {
            let below = (lower..last).find_map(begins)?;
            let length = self.length(below, self.line(below));
            (own < LONG * length && !self.turns(upper, lower)).then_some(below)
        })?;
        let middle = self.line(from);
        let end = if middle < last {
            self.line(middle)
        } else {
            middle
        };
        Some([from, middle, end].map(|place| self.joints[place]))
    }
}

/// What all but a tenth of some numbers are under.
fn nine_tenths(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let at = values.len() * 9 / 10;
    values
        .get(at.min(values.len().saturating_sub(1)))
        .copied()
        .unwrap_or_default()
}
