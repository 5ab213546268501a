//! The largest avatars that any part of the program accepts. The file reader enforces these limits,
//! and the GPU layouts rely on them.

/// Gaussians of an avatar.
pub const GAUSSIANS: usize = 2_000_000;
/// Levels of detail of an avatar.
pub const LEVELS: usize = 8;
/// Samples a pixel along each axis with which a level was measured.
pub const SAMPLES: u32 = 16;
/// Degree of spherical harmonics.
pub const HARMONICS: usize = 3;
/// Parts of an avatar.
pub const PARTS: usize = 1024;
/// Basis functions of a part, N_B.
pub const BASIS: usize = 32;
/// Node indices are 16-bit.
pub const NODES: usize = 65_536;
/// Joint indices are 8-bit.
pub const JOINTS: usize = 256;
/// Numbers of an expression.
pub const EXPRESSION: usize = 64;
/// Numbers that enter a part's network: pose and expression.
pub const MLP_INPUT: usize = 256;
/// Neurons in a hidden layer.
pub const MLP_WIDTH: usize = 128;
/// Layers of a network, the linear output layer among them.
pub const MLP_LAYERS: usize = 8;
/// Components of a [`super::Subspace`].
pub const SUBSPACE: usize = 64;
/// Metres; larger numbers are in some other unit.
pub const LENGTH: f64 = 10_000.0;
