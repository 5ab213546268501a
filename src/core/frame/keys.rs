//! The keys that Gaussians are sorted by.

use crate::layout::SORT_CULLED;

/// Width of the keys: the sort takes a pass for every 8 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KeyBits {
    /// Two passes; two keys a word.
    Sixteen,
    /// Three passes.
    #[default]
    TwentyFour,
    /// Four passes.
    ThirtyTwo,
}

impl KeyBits {
    /// Passes of the sort.
    pub fn passes(self) -> u32 {
        match self {
            Self::Sixteen => 2,
            Self::TwentyFour => 3,
            Self::ThirtyTwo => 4,
        }
    }

    /// Whether two keys share a word, the first in its low half. The largest 16-bit key then means
    /// [`SORT_CULLED`].
    pub fn halves(self) -> bool {
        self == Self::Sixteen
    }

    /// Bytes that this many keys take, in whole words.
    pub fn bytes(self, keys: u64) -> u64 {
        if self.halves() {
            (2 * keys).next_multiple_of(4)
        } else {
            4 * keys
        }
    }

    /// Packs keys into the words that the sort reads.
    pub fn pack(self, keys: &[u32]) -> Vec<u32> {
        if !self.halves() {
            return keys.to_vec();
        }
        let half = |key: u32| key & 0xffff;
        keys.chunks(2)
            .map(|pair| half(pair[0]) | pair.get(1).map_or(0, |&key| half(key) << 16))
            .collect()
    }

    /// Whether the sort discards a key: it marks a Gaussian that is not drawn.
    pub fn drops(self, key: u32) -> bool {
        if self.halves() {
            key & 0xffff == 0xffff
        } else {
            key == SORT_CULLED
        }
    }

    /// The largest key of a depth: exact in f32, below [`SORT_CULLED`].
    pub fn largest(self) -> u32 {
        match self {
            Self::Sixteen => 0xfffe,
            Self::TwentyFour => 0xff_ffff,
            Self::ThirtyTwo => 0xffff_ff00,
        }
    }
}
