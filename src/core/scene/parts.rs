//! Sets of parts, and which parts' networks each part depends on.

use crate::avatar::{Avatar, limits};
use std::ops::{BitAnd, BitOr, Sub};

const WORDS: usize = limits::PARTS / 32;

/// A set of parts, a bit for each that an avatar may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartSet([u32; WORDS]);

impl PartSet {
    /// No part.
    pub const EMPTY: Self = Self([0; WORDS]);
    /// Every part that any avatar may have.
    pub const ALL: Self = Self([u32::MAX; WORDS]);

    /// Parts 0 to `count` − 1.
    pub fn first(count: usize) -> Self {
        (0..count).fold(Self::EMPTY, |mut set, part| {
            set.insert(part);
            set
        })
    }

    /// Adds a part.
    pub fn insert(&mut self, part: usize) {
        self.0[part / 32] |= 1 << (part % 32);
    }

    /// Whether a part is in the set.
    pub fn contains(&self, part: usize) -> bool {
        self.0[part / 32] >> (part % 32) & 1 != 0
    }

    /// Whether no part is in the set.
    pub fn is_empty(&self) -> bool {
        *self == Self::EMPTY
    }

    /// Number of parts in the set.
    pub fn len(&self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// One past the last part of the set; 0 if it is empty.
    pub fn end(&self) -> usize {
        self.0
            .iter()
            .enumerate()
            .rev()
            .find(|(_, word)| **word != 0)
            .map_or(0, |(at, word)| 32 * at + 32 - word.leading_zeros() as usize)
    }

    /// The parts that are not in the set.
    pub fn complement(self) -> Self {
        Self::ALL - self
    }

    /// The bits in the order of the frame block.
    pub fn bits(&self) -> [[u32; 4]; WORDS / 4] {
        std::array::from_fn(|at| std::array::from_fn(|k| self.0[4 * at + k]))
    }

    fn zip(self, other: Self, op: impl Fn(u32, u32) -> u32) -> Self {
        Self(std::array::from_fn(|at| op(self.0[at], other.0[at])))
    }
}

impl BitOr for PartSet {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        self.zip(other, |a, b| a | b)
    }
}

impl BitAnd for PartSet {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        self.zip(other, |a, b| a & b)
    }
}

impl Sub for PartSet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a & !b)
    }
}

/// The parts whose networks each part of an avatar depends on.
#[derive(Clone, Debug)]
pub struct PartDependencies {
    /// For each part: itself, and the parts of the nodes that its Gaussians follow. Empty for a
    /// part without Gaussians.
    by_part: Vec<PartSet>,
    /// The parts whose networks see the expression.
    pub head: PartSet,
}

impl PartDependencies {
    /// The dependencies of an avatar's parts.
    ///
    /// # Panics
    /// Where [`Avatar::check`] finds a fault.
    pub fn new(avatar: &Avatar) -> Self {
        let mut by_part = vec![PartSet::EMPTY; avatar.parts.len()];
        for (part, needed) in by_part.iter_mut().enumerate() {
            let start = avatar.parts.start[part] as usize;
            let end = avatar.parts.start[part + 1] as usize;
            if start < end {
                needed.insert(part);
            }
            for &node in avatar.gaussians.node[start..end].iter().flatten() {
                if let Some(&part) = avatar.nodes.part.get(usize::from(node)) {
                    needed.insert(usize::from(part));
                }
            }
        }
        Self {
            by_part,
            head: PartSet::first(avatar.parts.head),
        }
    }

    /// Every part of the avatar.
    pub fn all(&self) -> PartSet {
        PartSet::first(self.by_part.len())
    }

    /// The parts whose networks must have run to draw the parts of `drawn`.
    pub fn networks(&self, drawn: &PartSet) -> PartSet {
        self.by_part
            .iter()
            .enumerate()
            .filter(|(part, _)| drawn.contains(*part))
            .fold(PartSet::EMPTY, |all, (_, needs)| all | *needs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn set_operations_are_correct() {
        let mut set = PartSet::first(33);
        set.insert(700);
        assert_eq!(
            (
                set.len(),
                set.end(),
                set.contains(32),
                set.contains(33),
                set.contains(700)
            ),
            (34, 701, true, false, true)
        );
        assert_eq!((set - PartSet::first(33)).len(), 1);
        assert_eq!(
            ((set & PartSet::first(40)).end(), PartSet::EMPTY.end()),
            (33, 0)
        );
        assert_eq!(
            (set | set.complement(), set & set.complement()),
            (PartSet::ALL, PartSet::EMPTY)
        );
        assert_eq!(set.bits()[0], [u32::MAX, 1, 0, 0]);
    }

    #[test]
    fn a_part_depends_on_the_networks_of_its_nodes() {
        let avatar = crate::demo::avatar().unwrap();
        let needs = PartDependencies::new(&avatar);
        let all = needs.all();
        assert_eq!((all.len(), needs.networks(&all)), (avatar.parts.len(), all));
        for part in 0..avatar.parts.len() {
            let networks = needs.networks(&(PartSet::first(part + 1) - PartSet::first(part)));
            assert!(networks.contains(part) && networks.len() < avatar.parts.len());
            let range = avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize;
            let follows =
                |&node: &u16| networks.contains(usize::from(avatar.nodes.part[usize::from(node)]));
            assert!(
                avatar.gaussians.node[range].iter().flatten().all(follows),
                "part {part}"
            );
        }
    }
}
