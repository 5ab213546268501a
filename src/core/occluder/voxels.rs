//! Sets of voxels as bits, so that 64 neighbours along x are grown and flooded at once.

use glam::UVec3;

/// A set of voxels of a grid, which has at least one. A row along x is a whole number of words;
/// bits past its end are never set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Voxels {
    size: UVec3,
    /// Words of a row.
    words: usize,
    bits: Vec<u64>,
}

impl Voxels {
    /// The empty set of a grid with `size` voxels along each axis.
    pub fn none(size: UVec3) -> Self {
        let words = size.x.div_ceil(64) as usize;
        Self {
            size,
            words,
            bits: vec![0; words * size.y as usize * size.z as usize],
        }
    }

    /// Adds a voxel.
    pub fn insert(&mut self, at: UVec3) {
        let row = at.z as usize * self.size.y as usize + at.y as usize;
        self.bits[row * self.words + at.x as usize / 64] |= 1 << (at.x % 64);
    }

    /// The voxels of the set, along x first.
    pub fn iter(&self) -> impl Iterator<Item = UVec3> + '_ {
        let rows = self.bits.chunks(self.words).zip(0u32..);
        let height = self.size.y;
        rows.flat_map(move |(row, number)| {
            let bits = |&word: &u64| {
                std::iter::successors(Some(word), |left| Some(left & left.wrapping_sub(1)))
                    .take_while(|&left| left != 0)
            };
            let along = row.iter().zip(0u32..).flat_map(move |(word, w)| {
                bits(word).map(move |left| 64 * w + left.trailing_zeros())
            });
            along.map(move |x| UVec3::new(x, number % height, number / height))
        })
    }

    /// Mask of the bits of a row's last word that are voxels.
    fn last_mask(&self) -> u64 {
        u64::MAX >> (64 * self.words as u32 - self.size.x)
    }

    /// The voxels that are not in the set.
    pub fn complement(mut self) -> Self {
        let last = self.last_mask();
        for row in self.bits.chunks_mut(self.words) {
            for word in row.iter_mut() {
                *word = !*word;
            }
            row[self.words - 1] &= last;
        }
        self
    }

    /// The voxels of this set that are not in another.
    pub fn without(mut self, other: &Self) -> Self {
        for (word, other) in self.bits.iter_mut().zip(&other.bits) {
            *word &= !other;
        }
        self
    }

    /// The set with its voxels' neighbours across every face.
    pub fn grown(&self) -> Self {
        let mut grown = self.clone();
        for axis in 0..3 {
            self.add_neighbors(axis, &mut grown);
        }
        grown
    }

    /// The set with all 26 neighbours of its voxels.
    pub fn boxed(&self) -> Self {
        let mut set = self.clone();
        for axis in 0..3 {
            let before = set.clone();
            before.add_neighbors(axis, &mut set);
        }
        set
    }

    /// Adds the neighbours of this set's voxels along an axis to `into`.
    fn add_neighbors(&self, axis: usize, into: &mut Self) {
        let slab = self.words * self.size.y as usize;
        // Adds words that stand `by` words further on or back.
        let add_shifted = |from: &[u64], to: &mut [u64], by: usize| {
            for (to, from) in to.iter_mut().zip(from.iter().skip(by)) {
                *to |= from;
            }
            for (to, from) in to.iter_mut().skip(by).zip(from) {
                *to |= from;
            }
        };
        match axis {
            0 => {
                for (from, to) in self
                    .bits
                    .chunks(self.words)
                    .zip(into.bits.chunks_mut(self.words))
                {
                    for w in 0..self.words {
                        let before = if w > 0 { from[w - 1] >> 63 } else { 0 };
                        let after = from.get(w + 1).map_or(0, |word| word << 63);
                        to[w] |= from[w] << 1 | before | from[w] >> 1 | after;
                    }
                    to[self.words - 1] &= self.last_mask();
                }
            }
            1 => {
                for (from, to) in self.bits.chunks(slab).zip(into.bits.chunks_mut(slab)) {
                    add_shifted(from, to, self.words);
                }
            }
            _ => add_shifted(&self.bits, &mut into.bits, slab),
        }
    }

    /// The voxels that can be reached from the grid's first voxel, face by face, without entering
    /// this set.
    pub fn flooded(&self) -> Self {
        let free = self.clone().complement();
        let mut reached = Self::none(self.size);
        reached.bits[0] = free.bits[0] & 1;
        let rows = self.bits.len() / self.words;
        // Sweep from the first row to the last and back until nothing changes.
        loop {
            let mut changed = false;
            for row in (0..rows).chain((0..rows).rev()) {
                changed |= reached.flood_row(&free, row);
            }
            if !changed {
                return reached;
            }
        }
    }

    /// Spreads the reached voxels of neighbouring rows into a row where it is free, then along the
    /// row. Returns whether that added any.
    fn flood_row(&mut self, free: &Self, row: usize) -> bool {
        let words = self.words;
        let height = self.size.y as usize;
        let beside = [
            (!row.is_multiple_of(height)).then(|| row - 1),
            (row % height + 1 < height).then_some(row + 1),
            row.checked_sub(height),
            Some(row + height).filter(|&next| next * words < self.bits.len()),
        ];
        let from = row * words;
        let mut changed = false;
        let mut carry = false;
        for w in 0..words {
            let open = free.bits[from + w];
            let met = beside
                .iter()
                .flatten()
                .fold(self.bits[from + w], |met, &other| {
                    met | self.bits[other * words + w]
                })
                & open;
            let filled = filled_up(open, met | u64::from(carry) & open);
            carry = filled >> 63 != 0;
            changed |= filled != self.bits[from + w];
            self.bits[from + w] = filled;
        }
        let mut carry = false;
        for w in (0..words).rev() {
            let open = free.bits[from + w].reverse_bits();
            let met = self.bits[from + w].reverse_bits();
            let filled = filled_up(open, met | u64::from(carry) & open).reverse_bits();
            carry = filled & 1 != 0;
            changed |= filled != self.bits[from + w];
            self.bits[from + w] = filled;
        }
        changed
    }
}

/// Each run of `open` bits from its lowest bit of `met` up: adding that bit sends a carry through
/// the rest of the run.
fn filled_up(open: u64, met: u64) -> u64 {
    open & (met | (open.wrapping_add(met) ^ open))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::IVec3;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    type Naive = BTreeSet<[u32; 3]>;

    fn naive(set: &Voxels) -> Naive {
        set.iter().map(|at| at.to_array()).collect()
    }

    fn beside(at: [u32; 3], size: UVec3, distance: i32) -> impl Iterator<Item = [u32; 3]> {
        let steps = (0..27)
            .map(|k| IVec3::new(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1))
            .filter(move |step| step.abs().element_sum() <= distance);
        let next = steps.map(move |step| UVec3::from(at).as_ivec3() + step);
        next.filter(move |next| next.cmpge(IVec3::ZERO).all() && next.cmplt(size.as_ivec3()).all())
            .map(|next| next.as_uvec3().to_array())
    }

    fn wider(set: &Naive, size: UVec3, distance: i32) -> Naive {
        set.iter()
            .flat_map(|&at| beside(at, size, distance))
            .collect()
    }

    fn reached(walls: &Naive, size: UVec3) -> Naive {
        let mut reached: Naive = [[0; 3]]
            .into_iter()
            .filter(|at| !walls.contains(at))
            .collect();
        let mut stack: Vec<_> = reached.iter().copied().collect();
        while let Some(at) = stack.pop() {
            stack.extend(
                beside(at, size, 1)
                    .filter(|next| !walls.contains(next) && reached.insert(*next))
                    .collect::<Vec<_>>(),
            );
        }
        reached
    }

    /// A grid, and voxels of it: walls with holes as well as specks.
    fn sets() -> impl Strategy<Value = Voxels> {
        let sizes = (
            prop_oneof![1..9u32, 62..67u32, 126..131u32],
            1..7u32,
            1..7u32,
        );
        (
            sizes,
            proptest::collection::vec((0..1u32 << 30, 0..4u32), 0..60),
            0..1u32 << 30,
        )
            .prop_map(|((x, y, z), specks, hole)| {
                let size = UVec3::new(x, y, z);
                let mut set = Voxels::none(size);
                for (place, kind) in specks {
                    let at = UVec3::new(place % x, place / x % y, place / (x * y) % z);
                    match kind {
                        0 => {
                            for k in (0..y * z).filter(|k| k % (hole % 7 + 2) != 0) {
                                set.insert(UVec3::new(at.x, k % y, k / y));
                            }
                        }
                        _ => set.insert(at),
                    }
                }
                set
            })
    }

    proptest! {
        #[test]
        fn sets_equal_naive_ones(set in sets()) {
            let one_by_one = naive(&set);
            let size = set.size;
            prop_assert_eq!(naive(&set.grown()), wider(&one_by_one, size, 1));
            prop_assert_eq!(naive(&set.boxed()), wider(&one_by_one, size, 3));
            prop_assert_eq!(naive(&set.flooded()), reached(&one_by_one, size));
            let rest = naive(&set.clone().complement());
            prop_assert_eq!(rest.len() + one_by_one.len(), size.element_product() as usize);
            prop_assert!(rest.is_disjoint(&one_by_one));
            prop_assert_eq!(naive(&set.grown().without(&set)), &wider(&one_by_one, size, 1) - &one_by_one);
        }
    }
}
