//! Sets of parts, and which networks a frame needs: an avatar goes in, for each part the parts whose nodes its Gaussians follow.

use crate::avatar::{Avatar, limits};
use std::ops::{BitAnd, BitOr, Sub};

const WORDS: usize = limits::PARTS / 32;

/// A set of parts, a bit for each that an avatar may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartSet([u32; WORDS]);

impl PartSet {
    pub const EMPTY: Self = Self([0; WORDS]);
    pub const ALL: Self = Self([u32::MAX; WORDS]);

    /// The first `count`.
    pub fn first(count: usize) -> Self {
        (0..count).fold(Self::EMPTY, |mut set, part| {
            set.insert(part);
            set
        })
    }

    pub fn insert(&mut self, part: usize) {
        self.0[part / 32] |= 1 << (part % 32);
    }

    pub fn contains(&self, part: usize) -> bool {
        self.0[part / 32] >> (part % 32) & 1 != 0
    }

    pub fn is_empty(&self) -> bool {
        *self == Self::EMPTY
    }

    pub fn len(&self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// One past the last.
    pub fn end(&self) -> usize {
        self.0.iter().enumerate().rev().find(|(_, word)| **word != 0).map_or(0, |(at, word)| 32 * at + 32 - word.leading_zeros() as usize)
    }

    /// All others.
    pub fn others(self) -> Self {
        Self::ALL - self
    }

    /// As the uniform block has it.
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

/// What each part needs to be drawn.
pub struct Needs {
    /// For each part those whose networks move it: its own, and those of the nodes that its Gaussians follow. None where it has none.
    of: Vec<PartSet>,
    /// Those that see the expression.
    pub head: PartSet,
}

impl Needs {
    pub fn new(avatar: &Avatar) -> Self {
        let of = avatar.parts.start.windows(2).enumerate().map(|(part, range)| {
            let mut needs = PartSet::EMPTY;
            if range[0] < range[1] {
                needs.insert(part);
            }
            let nodes = avatar.gaussians.node[range[0] as usize..range[1] as usize].iter().flatten();
            nodes.filter_map(|&node| avatar.nodes.part.get(usize::from(node))).for_each(|&part| needs.insert(usize::from(part)));
            needs
        });
        Self { of: of.collect(), head: PartSet::first(avatar.parts.head) }
    }

    pub fn all(&self) -> PartSet {
        PartSet::first(self.of.len())
    }

    /// The parts whose networks must have run to draw some.
    pub fn networks(&self, drawn: &PartSet) -> PartSet {
        self.of.iter().enumerate().filter(|(part, _)| drawn.contains(*part)).fold(PartSet::EMPTY, |all, (_, needs)| all | *needs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo;

    #[test]
    fn sets_do_what_sets_do() {
        let mut set = PartSet::first(33);
        set.insert(700);
        assert_eq!((set.len(), set.end(), set.contains(32), set.contains(33), set.contains(700)), (34, 701, true, false, true));
        assert_eq!((set - PartSet::first(33)).len(), 1);
        assert_eq!(((set & PartSet::first(40)).end(), PartSet::EMPTY.end()), (33, 0));
        assert_eq!((set | set.others(), set & set.others()), (PartSet::ALL, PartSet::EMPTY));
        assert_eq!(set.bits()[0], [u32::MAX, 1, 0, 0]);
    }

    #[test]
    fn a_part_needs_the_networks_of_its_nodes() {
        let avatar = demo::avatar().unwrap();
        let needs = Needs::new(&avatar);
        let all = needs.all();
        assert_eq!((all.len(), needs.networks(&all)), (avatar.parts.len(), all));
        for part in 0..avatar.parts.len() {
            let networks = needs.networks(&(PartSet::first(part + 1) - PartSet::first(part)));
            assert!(networks.contains(part) && networks.len() < avatar.parts.len());
            let range = avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize;
            let follows = |&node: &u16| networks.contains(usize::from(avatar.nodes.part[usize::from(node)]));
            assert!(avatar.gaussians.node[range].iter().flatten().all(follows), "part {part}");
        }
    }
}
