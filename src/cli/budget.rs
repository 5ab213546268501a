//! How many correctives stay, as arguments.

use crate::options::{self, count};
use effigy_core::avatar::limits;
use effigy_learn::prune::RowBudget;

/// How many correctives stay.
#[derive(clap::Args, Clone, Copy, Debug, Default, PartialEq)]
pub struct BudgetArgs {
    /// Corrective rows to keep, of rotation, scale and colour together, 0 or more: those without
    /// which images would lose most [default: a tenth of all]
    #[arg(long, value_name = "N", value_parser = count(0, 3 * limits::GAUSSIANS))]
    keep: Option<usize>,
    /// Keep instead the correctives of this many Gaussians, 0 or more, for each of rotation, scale
    /// and colour: those that vary most, as in the paper
    #[arg(long, value_name = "N", value_parser = count(0, limits::GAUSSIANS), conflicts_with = "keep")]
    rows: Option<usize>,
    /// Keep instead as many of each as hold this share of the correctives' variance, 0 to 1
    #[arg(long, value_name = "SHARE", value_parser = options::share, conflicts_with_all = ["keep", "rows"])]
    variance: Option<f64>,
}

impl BudgetArgs {
    /// The budget for an avatar of so many Gaussians.
    pub fn budget(&self, gaussians: usize) -> RowBudget {
        match (self.rows, self.variance) {
            (Some(rows), _) => RowBudget::Rows(rows),
            (None, Some(share)) => RowBudget::Variance(share),
            (None, None) => RowBudget::Contribution(self.keep.unwrap_or(3 * gaussians / 10)),
        }
    }
}
