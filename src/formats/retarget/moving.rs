//! Where limbs begin by how they move: a check of what names and users say, which the report measures
//! against. An upper arm or a thigh is the first bone from the trunk outwards that is long and turns.

use super::{
    chain::{Chain, LONG, LimbJoints},
    humanoid::Humanoid,
    tree::Tree,
};
use crate::{assumption::Assumption, capture::Capture};

/// The limbs of a body.
pub struct Limbs {
    /// Left and right arm, left and right leg, if there are any.
    pub joints: Vec<LimbJoints>,
    /// Those that other joints were taken for.
    pub doubts: Vec<Assumption>,
}

/// The limbs as the motion shows them, and as they were found where it shows nothing else.
pub fn limbs(tree: &Tree, body: &Humanoid, capture: &Capture) -> Limbs {
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
        let shown = other(&through(tree, capture, trunk, taken), taken);
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

/// Through a limb to what is furthest from its end.
fn through(tree: &Tree, capture: &Capture, trunk: usize, taken: LimbJoints) -> Chain {
    let last = taken[2];
    let far = |joint: &usize| tree.rest[*joint].distance(tree.rest[last]);
    let end = (0..tree.len())
        .filter(|&joint| tree.is_above(last, joint))
        .max_by(|a, b| far(a).total_cmp(&far(b)));
    Chain::new(capture, trunk, tree.path(trunk, end.unwrap_or(last)))
}

/// The joints of the limb where they are not those that were taken.
fn other(chain: &Chain, taken: LimbJoints) -> Option<LimbJoints> {
    let place = |joint: usize| chain.joints.iter().position(|own| *own == joint);
    let [upper, lower, end] = [place(taken[0])?, place(taken[1])?, place(taken[2])?];
    let own = chain.length(upper, lower);
    let second = chain.length(lower, end);
    let long = LONG * own.max(second);
    let last = chain.joints.len() - 1;
    // The end of a chain is of any length.
    let inner = last.saturating_sub(1);
    let line = |from: usize| chain.line(from).min(inner.max(from + 1));
    let begins = |from: usize| {
        let to = line(from);
        (chain.length(from, to) >= long && chain.turns(from, to)).then_some(from)
    };
    // What is above must be another bone, longer than the second of this limb; what is below counts
    // if this one is a collar bone.
    let above = (0..upper)
        .filter(|&from| line(from) <= upper && chain.length(from, line(from)) > second)
        .find_map(begins);
    let from = above.or_else(|| {
        let below = (lower..inner).find_map(begins)?;
        let length = chain.length(below, line(below));
        (own < LONG * length && !chain.turns(upper, lower)).then_some(below)
    })?;
    let middle = line(from);
    let end = if middle < last {
        chain.line(middle)
    } else {
        middle
    };
    Some([from, middle, end].map(|place| chain.joints[place]))
}
