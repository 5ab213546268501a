//! Sort keys, and the entries that they become between the passes of a sort.

use crate::layout::SORT_CULLED;

/// Width of the keys: the sort takes a pass for every 8 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeyBits {
    /// Two passes; two keys a word. For bins.
    Sixteen,
    /// Three passes. The bits left of a key after the first share a word with the index of one of
    /// 2¹⁸ Gaussians. For depths, steps under 1 µm for a person, and for tiles of training.
    TwentyTwo,
    /// Four passes. For training, whose keys are depths in f32.
    ThirtyTwo,
}

/// Form of the entries between passes; see `shaders/sort/pass.glsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryForm {
    /// A key a word, its value its index: before the first pass.
    Keys = 0,
    /// A key and a value in turn.
    Pairs = 1,
    /// The bits left of the key, and the value, in one word.
    Packed = 2,
    /// A value a word: after the last pass.
    Values = 3,
    /// Two keys of 16 bits a word, a key's value its index: before the first pass.
    Halves = 4,
}

impl EntryForm {
    /// Bytes of an entry after a pass.
    pub fn bytes(self) -> u64 {
        match self {
            Self::Pairs => 8,
            _ => 4,
        }
    }
}

/// Width of the depth keys.
pub const DEPTH_KEYS: KeyBits = KeyBits::TwentyTwo;

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

    /// The form of the entries of a sort of at most `capacity` keys before a pass; with the number
    /// of passes, that after the last one.
    pub fn form_before(self, pass: u32, capacity: u32) -> EntryForm {
        if pass == 0 {
            return if self.halves() {
                EntryForm::Halves
            } else {
                EntryForm::Keys
            };
        }
        if pass == self.passes() {
            EntryForm::Values
        } else if self.packs_before(pass, capacity) {
            EntryForm::Packed
        } else {
            EntryForm::Pairs
        }
    }

    /// Bits that the value, which is an index, has beside the bits left of the key in the packed
    /// form: all bits that are left when that form begins. 24 if it never begins.
    pub fn value_bits(self, capacity: u32) -> u32 {
        (1..self.passes())
            .find(|&pass| self.packs_before(pass, capacity))
            .map_or(24, |pass| 32 - self.bits_left(pass))
    }

    /// Bytes of the two buffers that the passes of a sort write in turn: the first pass the first,
    /// the last pass [`Self::last`].
    pub fn written_in_turn(self, capacity: u32) -> [u64; 2] {
        [0, 1].map(|first| {
            let passes = (first..self.passes()).step_by(2);
            let forms = passes.map(|pass| self.form_before(pass + 1, capacity));
            let entry = forms.map(EntryForm::bytes).max().unwrap_or_default();
            entry * u64::from(capacity)
        })
    }

    /// Which of those the last pass writes: the order is there.
    pub fn last(self) -> usize {
        (self.passes() as usize - 1) % 2
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
