//! The flicker of a run of frames, as reports hold it.

use super::residual::{Residual, WeighedResidual};
use crate::report::ErrorReport;
use serde::{Deserialize, Serialize};

/// The flicker of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlickerReport {
    /// The means of all pairs, for each distance between frames.
    pub steps: Vec<StepReport>,
    /// Every pair of frames that was compared.
    pub pairs: Vec<PairReport>,
    /// The worst error of the reference's images, which sort by the depth of centres, against the
    /// same with every pixel sorted for itself. Null if that was not measured.
    pub sorting: Option<ErrorReport>,
}

/// The flicker over so many frames.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StepReport {
    /// How many frames apart.
    pub step: usize,
    /// Pairs compared.
    pub pairs: usize,
    /// Share of the covered pixels that show the same in both frames and are compared.
    pub compared: f64,
    /// What changes in the images drawn: means over the pairs, and the worst of them.
    pub drawn: Residual,
    /// What changes in the reference's.
    pub reference: Residual,
    /// What changes in the difference between the two.
    pub added: Residual,
    /// The reference's order, by the depth of centres, against an order of each pixel's own. Null
    /// if that was not measured.
    pub sorting: Option<SortingResidual>,
}

/// What sorting by the depth of centres changes from frame to frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SortingResidual {
    /// What changes in the reference's images with every pixel sorted for itself.
    pub per_pixel: Residual,
    /// What changes in the difference of the reference's images to those.
    pub added: Residual,
}

impl StepReport {
    /// How much more than the reference's changes on average, as a share of that.
    pub fn excess(&self) -> f64 {
        excess(&self.drawn, &self.reference)
    }
}

/// How much more one mean residual is than another, as a share of that; 0 where there is none.
pub fn excess(drawn: &Residual, reference: &Residual) -> f64 {
    if reference.mean > 0.0 {
        drawn.mean / reference.mean - 1.0
    } else {
        0.0
    }
}

/// Two frames compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PairReport {
    /// Index of the earlier frame.
    pub from: usize,
    /// Index of the later one.
    pub to: usize,
    /// For how many pairs of the run it stands.
    pub weight: f64,
    /// Longest side of the box around the avatar in the earlier frame, px. Null where it has none.
    pub side: Option<f64>,
    /// How the avatar is drawn in the earlier and the later frame.
    pub shown: [Shown; 2],
    /// How many times its size the reference draws both, before it averages.
    pub truth: u32,
    /// Share of the covered pixels that are compared.
    pub compared: f64,
    /// What changes in the images drawn.
    pub drawn: Residual,
    /// What changes in the reference's.
    pub reference: Residual,
    /// What changes in the difference between the two.
    pub added: Residual,
    /// The reference's order, by the depth of centres, against an order of each pixel's own. Null
    /// if that was not measured.
    pub sorting: Option<SortingResidual>,
}

impl PairReport {
    /// Whether the avatar is drawn in another way in the later frame.
    pub fn switches(&self) -> bool {
        self.shown[0].switches_to(&self.shown[1])
    }

    /// How many frames apart they are.
    pub fn step(&self) -> usize {
        self.to - self.from
    }
}

/// How an avatar is drawn: at so many times its size, from so many Gaussians.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shown {
    /// Samples a pixel along each axis, at least 1.
    pub samples: f64,
    /// Gaussians of the level that is drawn.
    pub gaussians: u32,
}

impl Shown {
    /// Whether something may be seen to change between an avatar that is drawn so and the same one
    /// drawn otherwise: another level, or the first samples beyond one. More or less of them are no
    /// switch: they change as the avatar's size does.
    pub fn switches_to(&self, other: &Self) -> bool {
        self.gaussians != other.gaussians || (self.samples > 1.0) != (other.samples > 1.0)
    }
}

impl FlickerReport {
    /// The report of compared pairs. `distances`: how many frames apart they may be.
    pub fn new(distances: &[usize], pairs: Vec<PairReport>, sorting: Option<ErrorReport>) -> Self {
        let steps = distances
            .iter()
            .filter_map(|&step| step_report(step, &pairs))
            .collect();
        Self {
            steps,
            pairs,
            sorting,
        }
    }
}

/// The means of the pairs that are so many frames apart. None without any.
fn step_report(step: usize, pairs: &[PairReport]) -> Option<StepReport> {
    let own: Vec<&PairReport> = pairs.iter().filter(|pair| pair.step() == step).collect();
    let weight: f64 = own.iter().map(|pair| pair.weight).sum();
    if weight == 0.0 {
        return None;
    }
    let pooled = |of: fn(&PairReport) -> Residual| {
        Residual::pooled(own.iter().map(|pair| WeighedResidual {
            weight: pair.weight,
            residual: of(pair),
        }))
    };
    let compared: f64 = own.iter().map(|pair| pair.weight * pair.compared).sum();
    Some(StepReport {
        step,
        pairs: own.len(),
        compared: compared / weight,
        drawn: pooled(|pair| pair.drawn),
        reference: pooled(|pair| pair.reference),
        added: pooled(|pair| pair.added),
        sorting: own
            .iter()
            .all(|pair| pair.sorting.is_some())
            .then(|| SortingResidual {
                per_pixel: pooled(|pair| pair.sorting.unwrap_or_default().per_pixel),
                added: pooled(|pair| pair.sorting.unwrap_or_default().added),
            }),
    })
}
