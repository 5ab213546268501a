//! Sizes of bins, and the memory of their lists: `shaders/common/bins.glsl`.

use super::{BIN_BLOCK, BIN_SIDES, Control};

/// Side of the smallest bin, px: the region that a workgroup of the saturation stage takes. A
/// region lies in one bin.
const BIN_SIDE: u32 = super::SATURATION_REGION;
const _: () = assert!(BIN_SIDE.is_multiple_of(super::SHARED_REGION));
/// Maximum number of bins of an image. Their numbers are keys of 16 bits, of which the largest is
/// no bin.
const BINS_MAX: u32 = 1 << 14;

/// Word of the bins' buffer that says how often the finest side is doubled. A [`Control`] comes
/// before it.
const BIN_SHIFT_AT: usize = size_of::<Control>() / 4;

/// Side of the finest bins of an image of a size, px: the smallest power of two with which there
/// are at most `BINS_MAX`.
pub fn bin_side(size: [u32; 2]) -> u32 {
    let mut side = BIN_SIDE;
    while bins_of(size, side) > BINS_MAX {
        side *= 2;
    }
    side
}

/// Number of the finest bins of an image of a size, px.
pub fn bin_count(size: [u32; 2]) -> u32 {
    bins_of(size, bin_side(size))
}

fn bins_of(size: [u32; 2], side: u32) -> u32 {
    size[0].div_ceil(side) * size[1].div_ceil(side)
}

/// Where the parts of the bins' buffer are, in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BinLayout {
    /// Maximum number of pairs.
    pub pairs: u32,
    /// Maximum number of blocks of splats.
    pub blocks: u32,
    /// Counts of pairs, a row of [`BIN_SIDES`] a block.
    pub counts_start: u32,
    /// Where each bin's pairs begin, and where the last bin's end.
    pub starts_start: u32,
    /// The splat of each pair.
    pub pairs_start: u32,
    /// The bin of each pair, two a word.
    pub keys_start: u32,
    /// A bit a splat.
    pub marks_start: u32,
    /// Words in all.
    pub words: u32,
}

impl BinLayout {
    /// For so many splats. There are two and a half times as many pairs: a 200K body of which
    /// 140,000 Gaussians are visible makes 330,000 at 2048 × 2048 px.
    pub fn new(splats: u32) -> Self {
        let blocks = splats.div_ceil(BIN_BLOCK).max(1);
        // With the largest bins each splat is a pair, and each block may add one that is none.
        let pairs = (splats + splats.div_ceil(2) + splats + blocks).next_multiple_of(2);
        // A storage buffer may start at any multiple of 64 words.
        let align = |word: u32| word.next_multiple_of(64);
        let counts_start = align((size_of::<Control>() / 4) as u32 + 1);
        let starts_start = align(counts_start + BIN_SIDES * blocks);
        let pairs_start = align(starts_start + BINS_MAX + 1);
        let keys_start = align(pairs_start + pairs);
        let marks_start = align(keys_start + pairs / 2);
        Self {
            pairs,
            blocks,
            counts_start,
            starts_start,
            pairs_start,
            keys_start,
            marks_start,
            words: marks_start + BIN_BLOCK / 32 * blocks,
        }
    }
}

/// The lists of bins, read back from a device.
pub struct BinLists {
    /// Side of a bin, px.
    pub side: u32,
    /// Bins in a row.
    pub columns: u32,
    /// Of each bin, row by row from the top left, the indices of its splats, nearest first.
    pub lists: Vec<Vec<u32>>,
}

impl BinLists {
    /// Those of an image of a size, px. `words`: of the bins' buffer; `sorted`: the pairs in the
    /// order of bins.
    pub fn new(layout: &BinLayout, size: [u32; 2], words: &[u32], sorted: &[u32]) -> Self {
        let side = bin_side(size) << words[BIN_SHIFT_AT];
        let columns = size[0].div_ceil(side);
        let start = layout.starts_start as usize;
        let list = |bin: usize| {
            let places = words[start + bin] as usize..words[start + bin + 1] as usize;
            let splat = |&pair: &u32| words[(layout.pairs_start + pair) as usize];
            sorted[places].iter().map(splat).collect()
        };
        Self {
            side,
            columns,
            lists: (0..bins_of(size, side) as usize).map(list).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_are_as_small_as_their_number_allows() {
        let sides = [
            [1, 1],
            [2048, 2048],
            [4096, 4096],
            [4128, 4096],
            [16384, 32],
        ]
        .map(bin_side);
        assert_eq!(sides, [32, 32, 32, 64, 32]);
        assert_eq!(bin_side([16384, 16384]), 128);
    }

    #[test]
    fn with_the_largest_bins_an_image_is_one() {
        for size in [[16384, 1], [1, 16384], [16384, 16384], [5000, 3000]] {
            let largest = bin_side(size) << (BIN_SIDES - 1);
            assert!(size.iter().all(|&side| side <= largest), "{size:?}");
        }
    }

    #[test]
    fn every_splat_has_room_for_a_pair() {
        for splats in [0, 1, 255, 256, 257, 200_000] {
            let layout = BinLayout::new(splats);
            assert!(layout.pairs >= splats + layout.blocks, "{layout:?}");
            assert_eq!(layout.keys_start % 64, 0);
        }
    }
}
