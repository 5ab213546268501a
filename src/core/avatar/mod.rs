//! The avatar as plain arrays that hold the numbers as its file stores them.
//!
//! Everything that draws reads these arrays: the f64 reference decodes them one by one, the GPU
//! backends upload them. Both therefore start from the same bits, and they differ by arithmetic
//! alone. Symbols are the paper's: N_g Gaussians, N_G parts, N_B basis functions a part,
//! N_s position nodes, J joints.

pub mod bounds;
pub mod facing;
pub mod filter;
pub mod harmonics;
pub mod inputs;
pub mod levels;
pub mod limits;
pub mod matrix;
pub mod model;
pub mod motion;
pub mod pose;
pub mod prune;
pub mod skeleton;

pub use bounds::Bounds;
pub use facing::{Facing, FacingCode};
pub use filter::{Filter, LowPass};
pub use inputs::{Inputs, Subspace};
pub use matrix::Matrix;
pub use model::{
    Activation, Avatar, Gaussians, Level, LevelError, NetworkLayer, Networks, Nodes, Parts,
    ROW_COMPONENTS, Rows, ShCoefficients,
};
pub use motion::Clip;
pub use pose::Pose;
pub use skeleton::{PoseGradient, Skeleton};
