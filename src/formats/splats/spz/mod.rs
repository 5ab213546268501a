//! Niantic's `.spz`: every number as a code of a few bits, attribute by attribute, y up (right, up,
//! back).
//!
//! | attribute | code |
//! |---|---|
//! | position | 24 bits, two's complement, with a number of bits after the point that the header says; version 1: f16 |
//! | opacity | 8 bits, of 255 |
//! | colour of degree 0 | 8 bits: 127.5 + 0.15 · 255 times the coefficient |
//! | log scale | 8 bits, 16 a unit from −10 |
//! | rotation | versions 1, 2: x y z, each 127.5 + 127.5 times it, w is positive; since 3: 32 bits |
//! | harmonics | 8 bits each, 128 + 128 times it, RGB of a function together |
//!
//! Since version 3 a rotation's two highest bits are the index of the largest of x y z w; the other
//! three follow, each a sign and 9 bits, 511 for √½. Versions 1 to 3 are one gzip, or lack it; version 4 is a
//! plain header, a table of lengths and one zstd frame an attribute.

mod codes;
mod container;
mod read;
mod write;

pub use container::{MAGIC, is_packed, unpacked_size};
pub use read::read;
pub use write::write;
