//! The training's stages on Vulkan: forward, backward and Adam, a kernel each.
//!
//! | stage | forward | backward |
//! |---|---|---|
//! | mlp | networks of all parts and views, results kept | sums of each layer |
//! | nodes | displacement of each node | each node sums over its followers |
//! | project | each Gaussian as a splat | sums of its pairs, to its attributes |
//! | sort, tiles | splats by depth, pairs by tile | – |
//! | raster | tiles, nearest first | a record a pair |
//! | loss | – | derivative of the image, and of a perceptual loss of a part of it |
//! | adam | – | every number's step; derivatives of bases and weights are never stored |

mod arrays;
mod block;
mod buffers;
pub mod image_loss;
mod kernels;
pub mod shaders;
mod state;
mod tiles;
mod tiling;
mod trainer;

pub use block::{StepOptions, ViewBlock};
pub use image_loss::{AskedPart, ImageLossMemory};
pub use state::TrainerState;
pub use tiling::TileShape;
pub use trainer::{StepLosses, Trainer, memory_bytes};
