//! The GPU's data: structs and constants, the encoding of an avatar's numbers, tile sizes.

mod balance;
pub mod binning;
mod bins;
mod centers;
pub mod compact;
mod gpu;
mod macros;
pub mod pack;
mod packed;
pub mod sh;
mod train;

pub use balance::Balance;
pub use binning::TILING;
pub use bins::{BinLayout, BinLists, bin_count, bin_side};
pub use centers::CenterGrids;
pub use gpu::*;
pub use macros::{MACROS, MacroValue};
pub use packed::{PackedModel, PackedSet};
pub use train::*;
