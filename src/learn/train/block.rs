//! The numbers of one part's Gaussians over some frames as a matrix, and statistics over all
//! Gaussians: means and the weights of the attributes.

use crate::dataset::{Attribute, Dataset};
use effigy_core::avatar::Avatar;
use rayon::prelude::*;
use std::ops::Range;

/// The attributes that have basis rows, in the order of all arrays of three here.
pub const ATTRIBUTES: [Attribute; 3] = [Attribute::Rotation, Attribute::LogScale, Attribute::Color];
/// How much of the loss each attribute is. Colour is seen most.
pub const ATTRIBUTE_SHARES: [f64; 3] = [0.2, 0.2, 0.6];
/// How much of the loss the nodes' displacements are, beside the attributes.
pub const NODE_SHARE: f64 = 0.5;

/// Which Gaussians keep a corrective, after pruning or before.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum RetainedRows {
    /// Every Gaussian has a corrective of every attribute: nothing was pruned.
    #[default]
    All,
    /// For rotation, scale and colour the Gaussians that have a corrective, in rising order.
    Listed([Vec<u32>; 3]),
}

impl RetainedRows {
    /// Those of a range of Gaussians, for an attribute of [`ATTRIBUTES`].
    pub fn within(&self, attribute: usize, range: &Range<usize>) -> Vec<u32> {
        match self {
            Self::All => (range.start as u32..range.end as u32).collect(),
            Self::Listed(lists) => {
                let list = &lists[attribute];
                let first_from =
                    |gaussian: usize| list.partition_point(|&k| (k as usize) < gaussian);
                list[first_from(range.start)..first_from(range.end)].to_vec()
            }
        }
    }
}

/// Means over the training frames, and the weights that make the attributes' losses comparable.
#[derive(Clone, Debug)]
pub struct AttributeStatistics {
    /// Rotation, log scale, colour; each of shape N_g, width.
    pub mean: [Vec<f32>; 3],
    /// The factor of each attribute's numbers. 0 where nothing varies.
    pub weight: [f32; 3],
    /// The factor of the nodes' displacements.
    pub node_weight: f32,
}

/// The range of Gaussians of a part.
pub fn part_range(avatar: &Avatar, part: usize) -> Range<usize> {
    avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize
}

/// Means of a part's numbers over some frames, and their summed squares about these.
struct PartSpread {
    mean: Vec<f32>,
    spread: f64,
}

impl PartSpread {
    fn new(
        dataset: &Dataset,
        attribute: Attribute,
        range: &Range<usize>,
        frames: &[usize],
    ) -> Self {
        let count = frames.len().max(1) as f64;
        let width = range.len() * attribute.width();
        let mut sum = vec![0.0f64; width];
        let mut squares = 0.0;
        let mut numbers = Vec::with_capacity(width);
        for &frame in frames {
            numbers.clear();
            dataset.append_numbers(frame, attribute, range.clone(), &mut numbers);
            for (sum, &x) in sum.iter_mut().zip(&numbers) {
                *sum += f64::from(x);
            }
            squares += numbers.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>();
        }
        Self {
            spread: squares - sum.iter().map(|s| s * s).sum::<f64>() / count,
            mean: sum.iter().map(|s| (s / count) as f32).collect(),
        }
    }
}

impl AttributeStatistics {
    /// Over `frames`. `node_spread`: the squared displacements of all nodes over these frames about
    /// their means, see [`NodeDisplacements::spread`](super::nodes::NodeDisplacements::spread).
    pub fn new(dataset: &Dataset, frames: &[usize], node_spread: f64) -> Self {
        let count = frames.len().max(1) as f64;
        let parts: Vec<[PartSpread; 3]> = (0..dataset.avatar.parts.len())
            .into_par_iter()
            .map(|part| {
                let range = part_range(&dataset.avatar, part);
                ATTRIBUTES.map(|attribute| PartSpread::new(dataset, attribute, &range, frames))
            })
            .collect();
        let weight = |share: f64, spread: f64| {
            if spread > 1e-12 {
                (share / spread * count).sqrt() as f32
            } else {
                0.0
            }
        };
        Self {
            mean: std::array::from_fn(|a| {
                let means = parts.iter().map(|part| &part[a].mean);
                means.flatten().copied().collect()
            }),
            weight: std::array::from_fn(|a| {
                let spread = parts.iter().map(|part| part[a].spread).sum();
                weight(ATTRIBUTE_SHARES[a], spread)
            }),
            node_weight: weight(NODE_SHARE, node_spread),
        }
    }
}

/// The retained numbers of a part over some frames, each multiplied by its attribute's weight.
pub struct PartBlock {
    /// The retained Gaussians of each attribute.
    pub retained: [Vec<u32>; 3],
    /// Where each attribute's columns begin, and their number at the end.
    pub start: [usize; 4],
    /// Shape frames, columns.
    pub x: Vec<f32>,
}

impl PartBlock {
    /// Reads the part's numbers from the dataset.
    pub fn load(
        dataset: &Dataset,
        statistics: &AttributeStatistics,
        retained: &RetainedRows,
        part: usize,
        frames: &[usize],
    ) -> Self {
        let range = part_range(&dataset.avatar, part);
        let retained: [Vec<u32>; 3] = std::array::from_fn(|a| retained.within(a, &range));
        let mut start = [0; 4];
        for a in 0..3 {
            start[a + 1] = start[a] + retained[a].len() * ATTRIBUTES[a].width();
        }
        let mut x = Vec::with_capacity(frames.len() * start[3]);
        let mut numbers = Vec::new();
        for &frame in frames {
            for (a, attribute) in ATTRIBUTES.into_iter().enumerate() {
                if retained[a].is_empty() {
                    continue;
                }
                numbers.clear();
                dataset.append_numbers(frame, attribute, range.clone(), &mut numbers);
                let width = attribute.width();
                let weight = statistics.weight[a];
                for &k in &retained[a] {
                    let own = &numbers[(k as usize - range.start) * width..][..width];
                    x.extend(own.iter().map(|x| x * weight));
                }
            }
        }
        Self { retained, start, x }
    }

    /// Numbers a frame.
    pub fn columns(&self) -> usize {
        self.start[3]
    }
}

/// Subtracts the mean of some rows of a matrix from all of its rows. Returns the mean.
pub fn center(x: &mut [f32], columns: usize, rows: &[usize]) -> Vec<f32> {
    if columns == 0 {
        return Vec::new();
    }
    let mut sum = vec![0.0f64; columns];
    for &row in rows {
        for (sum, &x) in sum.iter_mut().zip(&x[row * columns..][..columns]) {
            *sum += f64::from(x);
        }
    }
    let mean: Vec<f32> = sum
        .iter()
        .map(|sum| (sum / rows.len().max(1) as f64) as f32)
        .collect();
    for row in x.chunks_exact_mut(columns) {
        for (x, mean) in row.iter_mut().zip(&mean) {
            *x -= mean;
        }
    }
    mean
}
