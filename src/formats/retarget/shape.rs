//! The parts of a body by the shape of a tree alone: which joints are legs, arms and head where
//! names say nothing.
//!
//! Two limbs are a pair if their longest chains have as many bones, of the same lengths. The longest pair at the lowest fork
//! are the legs; the longest pair above it, beside a third branch, are the arms, and that branch is
//! neck and head. Feet point forward, which tells left from right.

use super::{
    part::{Bone, Part, Side},
    tree::Tree,
};
use glam::DVec3;

/// Difference of two bones of a pair, beside the length of the limb.
const PAIR: f64 = 0.05;

/// For each joint the part that it is; None: the tree is no body's.
pub fn parts(tree: &Tree) -> Option<Vec<Option<Part>>> {
    let shape = Shape::new(tree);
    let Shape {
        children, reach, ..
    } = &shape;
    let pairs: Vec<Option<Pair>> = (0..tree.len()).map(|joint| shape.pair(joint)).collect();
    let longest = |joint: usize| shape.chain(joint);
    // The hips: the fork with the longest pair of limbs and something that reaches up beside them.
    let hips = (0..tree.len())
        .filter(|&joint| children[joint].len() >= 3)
        .max_by(|&a, &b| length_of(&pairs[a]).total_cmp(&length_of(&pairs[b])))?;
    let legs = pairs[hips]?;
    let mut trunk = children[hips]
        .iter()
        .copied()
        .filter(|child| !legs.limbs.contains(child))
        .max_by(|&a, &b| reach[a].total_cmp(&reach[b]))?;
    let arms = loop {
        let pair = pairs[trunk];
        // Arms are about as long as legs; a pair of eyes or breasts is not.
        if let Some(pair) = pair
            && pair.length > 0.4 * legs.length
        {
            break pair;
        }
        trunk = children[trunk]
            .iter()
            .copied()
            .max_by(|&a, &b| reach[a].total_cmp(&reach[b]))?;
    };
    let neck = children[trunk]
        .iter()
        .copied()
        .filter(|child| !arms.limbs.contains(child))
        .max_by(|&a, &b| reach[a].total_cmp(&reach[b]))?;
    let mut parts = vec![None; tree.len()];
    parts[hips] = Some(Part::Hips);
    let up: Vec<usize> = longest(neck);
    // The last joint of a chain is its end.
    let head = up[up.len().saturating_sub(2).min(1)];
    parts[head] = Some(Part::Head);
    let leg_chains = legs.limbs.map(longest);
    let left = left_of(tree, &leg_chains, hips, trunk)?;
    let arm_chains = arms.limbs.map(longest);
    let arm_left = same_side(tree, &arm_chains, &leg_chains[left], hips, trunk)?;
    for (at, chain) in leg_chains.iter().enumerate() {
        let side = side(at == left);
        let bones = [Bone::Thigh, Bone::Shin, Bone::Foot, Bone::Toe];
        let joints = long_bones(tree, chain);
        for (bone, joint) in bones.into_iter().zip(joints) {
            parts[joint] = Some(Part::Bone { side, bone });
        }
    }
    for (at, chain) in arm_chains.iter().enumerate() {
        let side = side(at == arm_left);
        let bones = [Bone::UpperArm, Bone::Forearm, Bone::Hand];
        let joints = long_bones(tree, chain);
        let clavicle = chain
            .first()
            .filter(|first| Some(first) != joints.first().as_ref());
        if let Some(&joint) = clavicle {
            let bone = Bone::Clavicle;
            parts[joint] = Some(Part::Bone { side, bone });
        }
        for (bone, joint) in bones.into_iter().zip(joints) {
            parts[joint] = Some(Part::Bone { side, bone });
        }
    }
    Some(parts)
}

fn side(is_left: bool) -> Side {
    if is_left { Side::Left } else { Side::Right }
}

/// The length of the bone that ends at a joint.
fn length(tree: &Tree, joint: usize) -> f64 {
    tree.offsets[joint].length()
}

/// Two limbs of the same length at one joint.
#[derive(Clone, Copy, Debug)]
struct Pair {
    limbs: [usize; 2],
    length: f64,
}

fn length_of(pair: &Option<Pair>) -> f64 {
    pair.map_or(0.0, |pair| pair.length)
}

/// A tree and the lengths in it.
struct Shape<'a> {
    tree: &'a Tree,
    children: Vec<Vec<usize>>,
    /// How far each joint's longest chain goes, from the joint on.
    reach: Vec<f64>,
}

impl<'a> Shape<'a> {
    fn new(tree: &'a Tree) -> Self {
        let children = tree.children();
        let mut reach = vec![0.0_f64; tree.len()];
        for joint in (0..tree.len()).rev() {
            let below = children[joint].iter();
            reach[joint] = below
                .map(|&child| length(tree, child) + reach[child])
                .fold(0.0, f64::max);
        }
        Self {
            tree,
            children,
            reach,
        }
    }

    /// The longest chain from a joint on.
    fn chain(&self, joint: usize) -> Vec<usize> {
        let far = |joint: usize| length(self.tree, joint) + self.reach[joint];
        let next = |&joint: &usize| {
            let below = self.children[joint].iter().copied();
            below.max_by(|&a, &b| far(a).total_cmp(&far(b)))
        };
        std::iter::successors(Some(joint), next).collect()
    }

    /// Whether two limbs are alike, bone by bone.
    fn alike(&self, limbs: [usize; 2]) -> bool {
        let [first, second] = limbs.map(|limb| self.chain(limb));
        let most = PAIR * self.reach[limbs[0]].max(self.reach[limbs[1]]);
        let mut bones = first.iter().zip(&second);
        first.len() == second.len()
            && bones.all(|(&a, &b)| (length(self.tree, a) - length(self.tree, b)).abs() <= most)
    }

    /// The longest pair among a joint's children.
    fn pair(&self, joint: usize) -> Option<Pair> {
        let children = &self.children[joint];
        let pairs = children.iter().enumerate().flat_map(|(at, &a)| {
            let others = children[at + 1..].iter();
            others.map(move |&b| [a, b])
        });
        pairs
            .filter(|limbs| self.alike(*limbs))
            .map(|limbs| Pair {
                limbs,
                length: self.reach[limbs[0]],
            })
            .max_by(|a, b| a.length.total_cmp(&b.length))
    }
}

/// The joints of a limb from its two long bones on, which are longer together than any other two that
/// follow each other: a collar bone, a hand or a foot may be more than half as long as one of them.
fn long_bones(tree: &Tree, chain: &[usize]) -> Vec<usize> {
    let bones = chain
        .windows(3)
        .map(|of| length(tree, of[1]) + length(tree, of[2]));
    // Of equal ones the first: what follows may be the end of a chain.
    let longest = bones.enumerate().rev().max_by(|a, b| a.1.total_cmp(&b.1));
    let first = longest.map_or(0, |(at, _)| at);
    chain[first..].iter().copied().take(4).collect()
}

/// Which of two legs is the left one: feet point forward.
fn left_of(tree: &Tree, legs: &[Vec<usize>; 2], hips: usize, trunk: usize) -> Option<usize> {
    let up = (tree.rest[trunk] - tree.rest[hips]).try_normalize()?;
    let forward: DVec3 = legs
        .iter()
        .map(|leg| {
            let joints = long_bones(tree, leg);
            match joints.as_slice() {
                [_, _, foot, toe, ..] => tree.rest[*toe] - tree.rest[*foot],
                _ => DVec3::ZERO,
            }
        })
        .sum();
    let forward = forward.reject_from_normalized(up).try_normalize()?;
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
