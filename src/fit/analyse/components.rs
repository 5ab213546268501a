//! How much of an attribute's changes a few principal components carry: of all Gaussians at once, of each part's, of as many random groups'
//! (the paper's "Attribute PCA Analysis"). In: a dataset. Out: mean absolute errors and explained variances.

use crate::bake::math::hash;
use crate::fit::block::{center, range};
use crate::fit::dataset::{Attribute, Dataset};
use crate::fit::matrix::{View, gram, leading, product};
use rayon::prelude::*;
use serde::Serialize;

/// How Gaussians are grouped, and how many components a group has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Setting {
    pub name: &'static str,
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
pub const SETTINGS: [Setting; 4] = [
    Setting { name: "global 16", components: 16, grouping: Grouping::Global },
    Setting { name: "global 64", components: 64, grouping: Grouping::Global },
    Setting { name: "local 16", components: 16, grouping: Grouping::Local },
    Setting { name: "local 16, random groups", components: 16, grouping: Grouping::Random },
];

/// What a setting makes of an attribute.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    pub attribute: &'static str,
    pub setting: &'static str,
    /// Mean absolute difference between the numbers and what the components rebuild of them.
    pub l1: f64,
    /// Share of the variance that each component carries, the mean over the groups.
    pub explained: Vec<f64>,
}

/// An attribute of all Gaussians over all frames, about its means.
struct Table {
    x: Vec<f32>,
    frames: usize,
    columns: usize,
    width: usize,
}

impl Table {
    fn new(dataset: &Dataset, attribute: Attribute) -> Self {
        let (count, frames) = (dataset.avatar.gaussians.len(), dataset.len());
        let mut x = Vec::with_capacity(frames * count * attribute.width());
        (0..frames).for_each(|frame| dataset.numbers(frame, attribute, 0..count, &mut x));
        let columns = count * attribute.width();
        center(&mut x, columns, &(0..frames).collect::<Vec<_>>());
        Self { x, frames, columns, width: attribute.width() }
    }

    /// Of some Gaussians.
    fn of(&self, gaussians: &[u32]) -> Vec<f32> {
        let row = |f: usize| {
            let row = &self.x[f * self.columns..][..self.columns];
            gaussians.iter().flat_map(move |&k| row[k as usize * self.width..][..self.width].iter().copied())
        };
        (0..self.frames).flat_map(row).collect()
    }
}

/// What one group's components leave: the summed absolute error, and the explained variances.
fn group(x: &[f32], frames: usize, components: usize) -> (f64, Vec<f64>) {
    let all = gram(x, frames);
    let (values, vectors) = leading(&all, frames, components.min(frames));
    let whole: f64 = (0..frames).map(|f| all[f * frames + f]).sum();
    let basis: Vec<f32> = vectors.iter().flatten().map(|&v| v as f32).collect();
    let (count, columns) = (vectors.len(), x.len() / frames.max(1));
    let mut error = 0.0;
    for start in (0..columns).step_by(4096) {
        let width = 4096.min(columns - start);
        let block = View::new(x, frames, columns).columns(start..start + width);
        let (mut along, mut left) = (vec![0.0; count * width], Vec::with_capacity(frames * width));
        (0..frames).for_each(|f| left.extend(x[f * columns + start..][..width].iter().map(|x| -x)));
        product(View::new(&basis, count, frames), block, 0.0, &mut along);
        product(View::new(&basis, count, frames).transposed(), View::new(&along, count, width), 1.0, &mut left);
        error += left.iter().map(|e| f64::from(e.abs())).sum::<f64>();
    }
    (error, values.iter().map(|value| if whole > 0.0 { value / whole } else { 0.0 }).collect())
}

/// The table's row of an attribute, and its curves: as many components as there are in the largest setting.
pub fn outcomes(dataset: &Dataset, attribute: Attribute) -> Vec<Outcome> {
    let table = Table::new(dataset, attribute);
    SETTINGS.iter().map(|setting| outcome(dataset, &table, attribute, setting)).collect()
}

fn outcome(dataset: &Dataset, table: &Table, attribute: Attribute, setting: &Setting) -> Outcome {
    let count = dataset.avatar.gaussians.len() as u32;
    let parts: Vec<Vec<u32>> = match setting.grouping {
        Grouping::Global => vec![(0..count).collect()],
        _ => {
            let mut order: Vec<u32> = (0..count).collect();
            if setting.grouping == Grouping::Random {
                order.sort_by_key(|&k| (hash(u64::from(k)), k));
            }
            (0..dataset.avatar.parts.len())
                .map(|part| order[range(&dataset.avatar, part)].to_vec())
                .filter(|part| !part.is_empty())
                .collect()
        }
    };
    let found: Vec<(f64, Vec<f64>)> = match setting.grouping {
        Grouping::Global => vec![group(&table.x, table.frames, setting.components)],
        _ => parts.par_iter().map(|part| group(&table.of(part), table.frames, setting.components)).collect(),
    };
    let mean = |k: usize| found.iter().map(|(_, explained)| explained.get(k).copied().unwrap_or(0.0)).sum::<f64>() / found.len() as f64;
    Outcome {
        attribute: attribute.name(),
        setting: setting.name,
        l1: found.iter().map(|(error, _)| error).sum::<f64>() / table.x.len().max(1) as f64,
        explained: (0..setting.components).map(mean).collect(),
    }
}
