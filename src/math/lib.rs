//! Arithmetic of the packages that make avatars: linear algebra, noise and colour, and where Gaussians
//! and parts begin on a surface. Knows neither files nor bodies.

pub mod color;
pub mod covariance;
pub mod matrix;
pub mod noise;
pub mod partition;
pub mod pca;
pub mod sampling;
pub mod spacing;
pub mod weights;
