//! The GPU's data: structs and constants, the encoding of an avatar's numbers, tile sizes.

pub mod binning;
pub mod compact;
mod gpu;
mod macros;
pub mod pack;
pub mod sh;

pub use binning::{TILING, TILING_WEB};
pub use gpu::*;
pub use macros::{MACROS, MacroValue};
