//! Arithmetic that the bake, the training and the analysis share. Knows nothing of avatars' files,
//! datasets or bodies.

pub mod color;
pub mod covariance;
pub mod matrix;
pub mod noise;
pub mod pca;
pub mod sampling;
pub mod weights;
