//! Which Gaussians keep their correctives.

mod avatar;
mod contribution;
mod select;
mod subject;

pub use avatar::prune;
pub use select::{RowBudget, select_rows};
pub use subject::RowSubject;
