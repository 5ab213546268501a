//! PlayCanvas's SOG: numbers as the pixels of WebP images, which `meta.json` names. A `.sog` is a
//! zip of them; they may also lie in a folder. Axes are those of a 3DGS `.ply`.
//!
//! | image | pixel of a splat |
//! |---|---|
//! | `means`, two | low and high bytes of x y z, codes of sign(x) · ln(1 + |x|) between `mins` and `maxs` |
//! | `quats` | three of w x y z, from −√½ to √½; A is 252 and the index of the largest, which is left out |
//! | `scales` | version 2: codes of the codebook of logarithms; 1: between `mins` and `maxs` |
//! | `sh0` | RGB: coefficients, by codebook (2) or extremes (1). A: the opacity of 255 (2), its logit between extremes (1) |
//! | `shN`, two | a palette of harmonics, 64 entries a row, a pixel a function; and each splat's 16-bit index in R and G |

mod document;
mod lod;
mod read;
mod texture;
mod zipped;

pub use lod::{in_archive, read as streamed};
pub use read::in_folder;
pub use zipped::is_sog;

/// The document's name in an archive.
pub const META: &str = "meta.json";
/// That of a streamed SOG.
pub const LOD_META: &str = "lod-meta.json";
