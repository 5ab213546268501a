//! Which Gaussians keep their correctives.

mod contribution;
mod select;

pub use select::{Budget, select_rows};
