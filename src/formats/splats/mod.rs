//! Splat files of other programs: Gaussians of a static scene. Readers give
//! [`Splats`](effigy_core::io::splats::Splats) in the file's own order and axes, writers take them.
//!
//! | format | [`SplatFormat`] | read | written |
//! |---|---|---|---|
//! | 3DGS `.ply`, SuperSplat's compressed `.ply` | `Ply` | both | plain |
//! | antimatter15's `.splat` | `Splat` | yes | yes |
//! | Niantic's `.spz` | `Spz` | versions 1 to 4 | version 3 |
//! | PlayCanvas's `.sog`, or its `meta.json` in a folder | `Sog`, `SogMeta` | versions 1 and 2 | no |
//! | the same streamed, `lod-meta.json` | `SogLod` | the finest level | no |
//! | mkkellogg's `.ksplat` | `Ksplat` | version 0.1, compression 0 to 2 | no |
//! | glTF with `KHR_gaussian_splatting`, plain or as SPZ | `Glb`, `Gltf` | yes | plain `.glb` |
//!
//! Files that unpack are held to [`BYTES_PER_SPLAT`]: memory follows from a file's size.

mod antimatter;
mod beside;
mod bytes;
mod gltf;
mod ksplat;
mod logit;
mod plausible;
mod read;
mod recognise;
mod sog;
mod spz;
mod write;

pub(crate) use beside::Archive;
pub use beside::{Beside, Folder, Nothing};
pub use effigy_core::io::splats::Found;
pub use plausible::{BYTES_PER_SPLAT, SMALL};
pub use read::read;
pub use recognise::{SplatFormat, is_text_from};
pub(crate) use sog::is_sog;
pub(crate) use spz::{is_packed as is_packed_spz, unpacked_size as unpacked_spz};
pub use write::{WRITTEN, write};
