//! Losses that see pictures as people do, with their gradients: ST-LPIPS, a perceptual distance
//! that forgives a pixel's shift and punishes blur, and D-SSIM, which needs no weights.
//!
//! ST-LPIPS compares what a convolutional network sees in two pictures. Its weights are frozen, so
//! that there is one gradient alone, with respect to the picture; everything is worked out here in
//! f32 on the CPU, with the same bits on every run and for any number of threads. It is never the
//! LPIPS of papers: its numbers can't be compared with those.

mod blur;
mod check;
mod convolution;
mod dssim;
mod error;
mod gemm;
mod head;
mod maps;
mod network;
mod perceptual;
mod planes;
mod pool;
mod reference;
mod synthetic;
mod weights;

pub use dssim::{dssim, dssim_and_gradient};
pub use error::PerceptualError;
pub use network::Network;
pub use perceptual::{Features, Perceptual};
pub use planes::{Graded, Planes};
pub use reference::Differential;
pub use synthetic::{direction, picture};
