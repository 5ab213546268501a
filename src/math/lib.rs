//! What the packages that make avatars share: linear algebra, noise and colour, where Gaussians and
//! parts begin on a surface, poses to look at, a splatter with derivatives, and from where Gaussians
//! show. Knows neither files nor bodies.

pub mod color;
pub mod covariance;
pub mod facing;
pub mod matrix;
pub mod noise;
pub mod partition;
pub mod pca;
pub mod poses;
pub mod sampling;
pub mod spacing;
pub mod splatter;
pub mod weights;
