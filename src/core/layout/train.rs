//! Numbers that the kernels of the training share with the host.

/// Invocations of a workgroup of kernels over Gaussians, nodes, pixels or tiles.
pub const TRAIN_WORKGROUP: u32 = 64;
/// Invocations of a workgroup of the networks, forward and backward.
pub const TRAIN_MLP_WORKGROUP: u32 = 64;
/// Invocations of a workgroup of the features' derivative: rows of [`TRAIN_BASIS`].
pub const TRAIN_FEATURES_WORKGROUP: u32 = 64;
/// Invocations of a workgroup that updates basis rows or weights.
pub const TRAIN_BASES_WORKGROUP: u32 = 256;
/// N_B: functions of a basis.
pub const TRAIN_BASIS: u32 = 16;
/// Most numbers that enter or leave a layer of a network.
pub const TRAIN_WIDTH_MAX: u32 = 128;
/// A Gaussian that has no basis row of an attribute.
pub const TRAIN_NO_ROW: u32 = u32::MAX;
/// Numbers of the derivative of a splat: colour (3), opacity, centre (2), Σ⁻¹ (3).
pub const TRAIN_RECORD: u32 = 9;
/// Sums of a workgroup of pixels: |difference|, its square, derivative of the gain (3).
pub const TRAIN_LOSS_SUMS: u32 = 5;
/// Splats whose pairs with tiles are counted together.
pub const TRAIN_BLOCK: u32 = 256;
/// A pixel that lets less light through is full: nothing behind it is blended.
pub const TRAIN_FULL: f64 = 1e-4;
