//! Splat files of other programs: Gaussians of a static scene. Readers give
//! [`Splats`](effigy_core::io::splats::Splats) in the file's own order and axes, writers take them.
//!
//! | format | [`SplatFormat`] | read | written |
//! |---|---|---|---|
//! | 3DGS `.ply`, SuperSplat's compressed `.ply` | `Ply` | both | plain |
//! | antimatter15's `.splat` | `Splat` | yes | yes |
//! | Niantic's `.spz` | `Spz` | versions 1 to 4 | version 3 |
//! | PlayCanvas's `.sog`, or its `meta.json` in a folder | `Sog`, `SogMeta` | versions 1 and 2 | no |
//! | mkkellogg's `.ksplat` | `Ksplat` | version 0.1, compression 0 to 2 | no |
//! | glTF with `KHR_gaussian_splatting`, plain or as SPZ | `Glb`, `Gltf` | yes | plain `.glb` |
//!
//! Files that unpack are held to [`BYTES_PER_SPLAT`]: memory follows from a file's size.

mod antimatter;
mod beside;
mod bytes;
mod found;
mod gltf;
mod ksplat;
mod logit;
mod plausible;
mod read;
mod recognise;
mod sog;
mod spz;
mod write;

pub use beside::{Beside, Folder, Nothing};
pub use found::Found;
pub use plausible::{BYTES_PER_SPLAT, SMALL};
pub use read::read;
pub use recognise::SplatFormat;
pub use sog::is_sog;
pub use write::{WRITTEN, write};
