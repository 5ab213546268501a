//! The keys that Gaussians are sorted by.

use crate::layout::SORT_CULLED;

/// Width of the keys: the sort takes a pass for every 8 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KeyBits {
    /// Two passes; two keys a word.
    Sixteen,
    /// Three passes. What is left of a key after the first shares a word with the index of one of
    /// 2¹⁸ Gaussians.
    #[default]
    TwentyTwo,
    /// Four passes.
    ThirtyTwo,
}

impl KeyBits {
    /// Bits of a key.
    pub fn bits(self) -> u32 {
        match self {
            Self::Sixteen => 16,
            Self::TwentyTwo => 22,
            Self::ThirtyTwo => 32,
        }
    }

    /// Passes of the sort.
    pub fn passes(self) -> u32 {
        self.bits().div_ceil(8)
    }

    /// Bits of a key that no pass before this one sorts by.
    pub fn bits_left(self, pass: u32) -> u32 {
        self.bits().saturating_sub(8 * pass)
    }

    /// Whether what is left of a key before a pass, which is not the first, shares a word with the
    /// index of one of so many.
    pub fn packs_before(self, pass: u32, count: u32) -> bool {
        u64::from(count) <= 1 << (32 - self.bits_left(pass))
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
            Self::TwentyTwo => 0x3f_ffff,
            Self::ThirtyTwo => 0xffff_ff00,
        }
    }
}
