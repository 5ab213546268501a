//! glTF 2.0 with the extension `KHR_gaussian_splatting`: points whose attributes are positions,
//! rotations x y z w, standard deviations, opacities and coefficients of spherical harmonics; or an
//! SPZ file in place of the attributes (`KHR_gaussian_splatting_compression_spz_2` and its drafts).
//! y is up. The splats of every node of the scene come together.

mod primitive;
mod read;
mod scene;
mod write;

pub use read::read;
pub use write::write;

/// The extension, which is also the start of its attributes' names.
pub const EXTENSION: &str = "KHR_gaussian_splatting";
