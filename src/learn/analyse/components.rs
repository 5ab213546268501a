//! How much of an attribute's changes a few principal components explain: of all Gaussians at once,
//! of each part's, and of as many random groups' (the paper's "Attribute PCA Analysis").

use crate::dataset::{Attribute, Dataset};
use crate::math::matrix::{LeadingEigenvectors, MatrixView, gram, leading_eigenvectors, multiply};
use crate::train::block::{center, part_range};
use effigy_core::random::hash;
use rayon::prelude::*;
use serde::Serialize;

/// How Gaussians are grouped, and how many components a group has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ComponentSetting {
    /// The name in tables.
    pub name: &'static str,
    /// Components of each group.
    pub components: usize,
    grouping: Grouping,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
enum Grouping {
    Global,
    Local,
    Random,
}

/// The columns of the paper's table.
pub const SETTINGS: [ComponentSetting; 4] = [
    ComponentSetting {
        name: "global 16",
        components: 16,
        grouping: Grouping::Global,
    },
    ComponentSetting {
        name: "global 64",
        components: 64,
        grouping: Grouping::Global,
    },
    ComponentSetting {
        name: "local 16",
        components: 16,
        grouping: Grouping::Local,
    },
    ComponentSetting {
        name: "local 16, random groups",
        components: 16,
        grouping: Grouping::Random,
    },
];

/// How well a setting's components rebuild an attribute.
#[derive(Clone, Debug, Serialize)]
pub struct ComponentResult {
    /// [`Attribute::name`].
    pub attribute: &'static str,
    /// [`ComponentSetting::name`].
    pub setting: &'static str,
    /// Mean absolute difference between the numbers and their reconstruction.
    pub l1: f64,
    /// The share of the variance that each component explains, the mean over the groups.
    pub explained: Vec<f64>,
}

/// An attribute of all Gaussians in all frames, about its means.
struct AttributeTable {
    /// Shape frames, columns.
    x: Vec<f32>,
    frames: usize,
    columns: usize,
    /// Numbers a Gaussian.
    width: usize,
}

impl AttributeTable {
    fn new(dataset: &Dataset, attribute: Attribute) -> Self {
        let count = dataset.avatar.gaussians.len();
        let frames = dataset.len();
        let mut x = Vec::with_capacity(frames * count * attribute.width());
        for frame in 0..frames {
            dataset.append_numbers(frame, attribute, 0..count, &mut x);
        }
        let columns = count * attribute.width();
        let all: Vec<usize> = (0..frames).collect();
        center(&mut x, columns, &all);
        Self {
            x,
            frames,
            columns,
            width: attribute.width(),
        }
    }

    /// The columns of some Gaussians, in their order.
    fn of_gaussians(&self, gaussians: &[u32]) -> Vec<f32> {
        let mut own = Vec::with_capacity(self.frames * gaussians.len() * self.width);
        for row in self.x.chunks_exact(self.columns.max(1)) {
            for &k in gaussians {
                own.extend_from_slice(&row[k as usize * self.width..][..self.width]);
            }
        }
        own
    }
}

/// How well one group's components rebuild its numbers.
struct GroupResult {
    /// The summed absolute error.
    error: f64,
    /// The share of the variance that each component explains.
    explained: Vec<f64>,
}

/// `x` has `frames` rows.
fn analyse_group(x: &[f32], frames: usize, components: usize) -> GroupResult {
    const BLOCK: usize = 4096;
    let gram = gram(x, frames);
    let LeadingEigenvectors { values, vectors } =
        leading_eigenvectors(&gram, frames, components.min(frames));
    let whole: f64 = (0..frames).map(|f| gram[f * frames + f]).sum();
    let count = vectors.len();
    let basis: Vec<f32> = vectors.iter().flatten().map(|&v| v as f32).collect();
    let basis = MatrixView::new(&basis, count, frames);
    let columns = x.len() / frames.max(1);
    let mut error = 0.0;
    for start in (0..columns).step_by(BLOCK) {
        let width = BLOCK.min(columns - start);
        let block = MatrixView::new(x, frames, columns).columns(start..start + width);
        let mut coefficients = vec![0.0; count * width];
        multiply(basis, block, 0.0, &mut coefficients);
        // The reconstruction minus the numbers.
        let mut difference = Vec::with_capacity(frames * width);
        for f in 0..frames {
            difference.extend(x[f * columns + start..][..width].iter().map(|x| -x));
        }
        multiply(
            basis.transposed(),
            MatrixView::new(&coefficients, count, width),
            1.0,
            &mut difference,
        );
        error += difference.iter().map(|e| f64::from(e.abs())).sum::<f64>();
    }
    let share = |value: &f64| if whole > 0.0 { value / whole } else { 0.0 };
    GroupResult {
        error,
        explained: values.iter().map(share).collect(),
    }
}

/// An attribute's row of the table: one result for each of [`SETTINGS`].
pub fn analyse_attribute(dataset: &Dataset, attribute: Attribute) -> Vec<ComponentResult> {
    let table = AttributeTable::new(dataset, attribute);
    SETTINGS
        .iter()
        .map(|setting| analyse_setting(dataset, &table, attribute, setting))
        .collect()
}

fn analyse_setting(
    dataset: &Dataset,
    table: &AttributeTable,
    attribute: Attribute,
    setting: &ComponentSetting,
) -> ComponentResult {
    let groups: Vec<GroupResult> = match setting.grouping {
        Grouping::Global => vec![analyse_group(&table.x, table.frames, setting.components)],
        Grouping::Local | Grouping::Random => groups(dataset, setting.grouping)
            .par_iter()
            .map(|group| {
                let x = table.of_gaussians(group);
                analyse_group(&x, table.frames, setting.components)
            })
            .collect(),
    };
    let mean_explained = |k: usize| {
        groups
            .iter()
            .map(|group| group.explained.get(k).copied().unwrap_or(0.0))
            .sum::<f64>()
            / groups.len() as f64
    };
    let error: f64 = groups.iter().map(|group| group.error).sum();
    ComponentResult {
        attribute: attribute.name(),
        setting: setting.name,
        l1: error / table.x.len().max(1) as f64,
        explained: (0..setting.components).map(mean_explained).collect(),
    }
}

/// Gaussians by part, or at random in groups as large as the parts. Empty groups are left out.
fn groups(dataset: &Dataset, grouping: Grouping) -> Vec<Vec<u32>> {
    let mut order: Vec<u32> = (0..dataset.avatar.gaussians.len() as u32).collect();
    if grouping == Grouping::Random {
        order.sort_by_key(|&k| (hash(u64::from(k)), k));
    }
    (0..dataset.avatar.parts.len())
        .map(|part| order[part_range(&dataset.avatar, part)].to_vec())
        .filter(|group| !group.is_empty())
        .collect()
}
