//! Which Gaussians keep their correctives.

mod contribution;
mod select;
mod subject;

pub use select::{Budget, select_rows};
pub use subject::RowSubject;
