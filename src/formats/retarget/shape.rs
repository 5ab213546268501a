//! The parts of a body by the shape of a tree: which joints are legs, arms and head where names say
//! nothing.
//!
//! Two limbs are a pair if their longest chains have as many bones, of the same lengths. The longest pair at the lowest fork
//! are the legs; the longest pair above it, beside a third branch, are the arms, and that branch is
//! neck and head. A limb's bones are those that bend and turn (`chain`), else its two longest. Feet
//! point forward, which tells left from right.

use super::{
    chain::Chain,
    part::{Bone, Part, Side},
    tree::Tree,
};
use crate::capture::Capture;
use glam::DVec3;

/// Difference of two bones of a pair, beside the length of the limb.
const PAIR: f64 = 0.05;
/// The end of a chain is at most this much of the bone before it: programs write any length.
const END: f64 = 0.8;
/// What is nearer to an ankle than this much of the leg is no toe of it.
const NEAR: f64 = 0.01;

/// Forks that may be the hips.
const LIKELY: usize = 4;

/// For each joint the part that it is; None: the tree is no body's. `motion`: how the tree moves,
/// where that is known.
pub fn parts(tree: &Tree, motion: Option<&Capture>) -> Option<Vec<Option<Part>>> {
    let shape = MeasuredTree::new(tree, motion);
    let pairs: Vec<Option<LimbPair>> = (0..tree.len()).map(|joint| shape.pair(joint)).collect();
    // The hips: the fork with the longest pair of limbs and something that reaches up beside them.
    let mut hips: Vec<usize> = (0..tree.len())
        .filter(|&joint| shape.children[joint].len() >= 3)
        .collect();
    hips.sort_by(|&a, &b| length_of(&pairs[b]).total_cmp(&length_of(&pairs[a])));
    // Arms may be longer than legs, but nothing of a body is above them.
    let mut likely = hips.into_iter().take(LIKELY);
    likely.find_map(|hips| shape.parts(hips, &pairs))
}

fn side(is_left: bool) -> Side {
    if is_left { Side::Left } else { Side::Right }
}

/// Two limbs of the same length at one joint.
#[derive(Clone, Copy, Debug)]
struct LimbPair {
    limbs: [usize; 2],
    length: f64,
}

fn length_of(pair: &Option<LimbPair>) -> f64 {
    pair.map_or(0.0, |pair| pair.length)
}

/// A tree and the lengths in it.
struct MeasuredTree<'a> {
    tree: &'a Tree,
    motion: Option<&'a Capture>,
    children: Vec<Vec<usize>>,
    /// Of the bone that ends at each joint.
    length: Vec<f64>,
    /// How far each joint's longest chain goes, from the joint on.
    reach: Vec<f64>,
}

impl<'a> MeasuredTree<'a> {
    fn new(tree: &'a Tree, motion: Option<&'a Capture>) -> Self {
        let children = tree.children();
        let mut length: Vec<f64> = tree.offsets.iter().map(|offset| offset.length()).collect();
        for joint in 0..tree.len() {
            if let Some(parent) = tree.parents[joint].filter(|_| children[joint].is_empty()) {
                length[joint] = length[joint].min(END * length[parent]);
            }
        }
        let mut reach = vec![0.0_f64; tree.len()];
        for joint in (0..tree.len()).rev() {
            let below = children[joint].iter();
            reach[joint] = below
                .map(|&child| length[child] + reach[child])
                .fold(0.0, f64::max);
        }
        Self {
            tree,
            motion,
            children,
            length,
            reach,
        }
    }

    /// The parts of a body with these hips.
    fn parts(&self, hips: usize, pairs: &[Option<LimbPair>]) -> Option<Vec<Option<Part>>> {
        let Self { tree, reach, .. } = self;
        let furthest = |of: usize, but: &[usize]| {
            let others = self.children[of].iter().copied();
            others
                .filter(|child| !but.contains(child))
                .max_by(|&a, &b| reach[a].total_cmp(&reach[b]))
        };
        let legs = pairs[hips]?;
        let mut trunk = furthest(hips, &legs.limbs)?;
        let arms = loop {
            // Arms are about as long as legs; a pair of eyes or breasts is not.
            if let Some(pair) = pairs[trunk]
                && pair.length > 0.4 * legs.length
            {
                break pair;
            }
            trunk = furthest(trunk, &[])?;
        };
        let neck = furthest(trunk, &arms.limbs)?;
        let mut parts = vec![None; tree.len()];
        parts[hips] = Some(Part::Hips);
        let up: Vec<usize> = self.chain(neck);
        // The last joint of a chain is its end.
        let head = up[up.len().saturating_sub(2).min(1)];
        parts[head] = Some(Part::Head);
        let leg_chains = legs.limbs.map(|limb| self.chain(limb));
        let leg_joints = self.long_bones(hips, &leg_chains);
        let left = left_of(tree, &leg_chains, &leg_joints, hips, trunk)?;
        let arm_chains = arms.limbs.map(|limb| self.chain(limb));
        let arm_left = same_side(tree, &arm_chains, &leg_chains[left], hips, trunk)?;
        let mut take = |bones: &[Bone], joints: &[usize], is_left: bool| {
            let side = side(is_left);
            for (&bone, &joint) in bones.iter().zip(joints) {
                parts[joint] = Some(Part::Bone { side, bone });
            }
        };
        for (at, joints) in leg_joints.iter().enumerate() {
            let bones = [Bone::Thigh, Bone::Shin, Bone::Foot, Bone::Toe];
            take(&bones, joints, at == left);
        }
        let arm_joints = self.long_bones(trunk, &arm_chains);
        for (at, joints) in arm_joints.iter().enumerate() {
            take(&[Bone::Clavicle], &arm_chains[at][..1], at == arm_left);
            let bones = [Bone::UpperArm, Bone::Forearm, Bone::Hand];
            take(&bones, joints, at == arm_left);
        }
        Some(parts)
    }

    /// The longest chain from a joint on.
    fn chain(&self, joint: usize) -> Vec<usize> {
        let far = |joint: usize| self.length[joint] + self.reach[joint];
        let next = |&joint: &usize| {
            let below = self.children[joint].iter().copied();
            below.max_by(|&a, &b| far(a).total_cmp(&far(b)))
        };
        std::iter::successors(Some(joint), next).collect()
    }

    /// Whether two limbs are alike, bone by bone but for their ends.
    fn alike(&self, limbs: [usize; 2]) -> bool {
        let [first, second] = limbs.map(|limb| self.chain(limb));
        let most = PAIR * self.reach[limbs[0]].max(self.reach[limbs[1]]);
        let inner = first.len().saturating_sub(1);
        let mut bones = first[..inner].iter().zip(&second);
        first.len() == second.len()
            && bones.all(|(&a, &b)| (self.length[a] - self.length[b]).abs() <= most)
    }

    /// The longest pair among a joint's children.
    fn pair(&self, joint: usize) -> Option<LimbPair> {
        let children = &self.children[joint];
        let pairs = children.iter().enumerate().flat_map(|(at, &a)| {
            let others = children[at + 1..].iter();
            others.map(move |&b| [a, b])
        });
        pairs
            .filter(|limbs| self.alike(*limbs))
            .map(|limbs| LimbPair {
                limbs,
                length: self.reach[limbs[0]],
            })
            .max_by(|a, b| a.length.total_cmp(&b.length))
    }

    /// The joints of a pair of limbs: the beginnings of the two long bones, their end and what follows
    /// it. As they move, or as the other of the pair does, else by their lengths.
    fn long_bones(&self, trunk: usize, chains: &[Vec<usize>; 2]) -> [Vec<usize>; 2] {
        let first = chains.each_ref().map(|chain| self.first_long(chain));
        let shown = [0, 1].map(|at| {
            let chain = Chain::new(self.motion?, trunk, chains[at].clone());
            chain.shown(first[at])
        });
        [0, 1].map(|at| {
            let chain = &chains[at];
            let [first, middle, end] = match shown[at].or(shown[1 - at]) {
                Some(places) => places,
                None => [0, 1, 2].map(|next| first[at] + next),
            };
            let places = [first, middle, end, end + 1].into_iter();
            places.filter_map(|at| chain.get(at)).copied().collect()
        })
    }

    /// Where the two bones of a chain begin that are longer together than any other two that follow
    /// each other: a collar bone, a hand or a foot may be more than half as long as one of them.
    fn first_long(&self, chain: &[usize]) -> usize {
        let bones = chain
            .windows(3)
            .map(|of| self.length[of[1]] + self.length[of[2]]);
        // Of equal ones the first: what follows may be the end of a chain.
        let longest = bones.enumerate().rev().max_by(|a, b| a.1.total_cmp(&b.1));
        longest.map_or(0, |(at, _)| at)
    }
}

/// Which of two legs is the left one: feet point forward. `joints`: hip, knee and ankle of each.
fn left_of(
    tree: &Tree,
    legs: &[Vec<usize>; 2],
    joints: &[Vec<usize>; 2],
    hips: usize,
    trunk: usize,
) -> Option<usize> {
    let up = (tree.rest[trunk] - tree.rest[hips]).try_normalize()?;
    let forward: DVec3 = legs
        .iter()
        .zip(joints)
        .map(|(leg, joints)| {
            let Some(&foot) = joints.get(2) else {
                return DVec3::ZERO;
            };
            // A toe may be where the ankle is, and then its end is not.
            let below = leg.iter().rev().take_while(|&&joint| joint != foot);
            let ways =
                below.map(|&toe| (tree.rest[toe] - tree.rest[foot]).reject_from_normalized(up));
            ways.filter(|way| way.length() > NEAR * tree.rest[leg[0]].distance(tree.rest[foot]))
                .last()
                .unwrap_or_default()
        })
        .sum();
    let forward = forward.try_normalize()?;
    let across = tree.rest[legs[0][0]] - tree.rest[legs[1][0]];
    let left = up.cross(forward);
    Some(usize::from(across.dot(left) < 0.0))
}

/// Which of two arms is on a leg's side.
fn same_side(
    tree: &Tree,
    arms: &[Vec<usize>; 2],
    leg: &[usize],
    hips: usize,
    trunk: usize,
) -> Option<usize> {
    let out = tree.rest[*leg.first()?] - tree.rest[hips];
    let far = |arm: &Vec<usize>| {
        let last = arm.last().copied().unwrap_or(trunk);
        (tree.rest[last] - tree.rest[trunk]).dot(out)
    };
    Some(usize::from(far(&arms[0]) < far(&arms[1])))
}
