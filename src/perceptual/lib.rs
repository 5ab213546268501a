//! Losses that see pictures as people do, with their gradients: ST-LPIPS, a perceptual distance
//! that forgives a pixel's shift and punishes blur, LPIPS, the one of papers, for those who bring
//! its weights, and D-SSIM, which needs none.
//!
//! ST-LPIPS and LPIPS compare what a convolutional network sees in two pictures. Its weights are
//! frozen, so that there is one gradient alone, with respect to the picture; everything is worked
//! out here in f32 on the CPU, with the same bits on every run and for any number of threads. The
//! numbers of one can't be compared with those of the other. `effigy_train` has the steps of the
//! networks as kernels too, and holds them against these.

pub mod blur;
mod check;
pub mod convolution;
mod dssim;
mod error;
mod gemm;
pub mod head;
pub mod maps;
pub mod network;
mod perceptual;
mod planes;
pub mod pool;
mod reference;
mod synthetic;
pub mod thin;
mod weights;

pub use dssim::{dssim, dssim_and_gradient};
pub use error::PerceptualError;
pub use network::{Network, WeightFile};
pub use perceptual::{Perceptual, TargetFeatures};
pub use planes::{Graded, Planes};
pub use reference::Differential;
pub use synthetic::{direction, picture};
pub use weights::Weights;
