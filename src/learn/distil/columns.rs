//! The numbers of a part as a linear map of its anchors' features: one *column* a number that an
//! avatar's basis row will drive. All Gaussians of a part blend features of some ten anchors; those
//! stand here one after the other, m numbers a row of inputs.

use crate::distil::teacher::AnchorFeatures;
use effigy_formats::mmlphuman::{Blend, Share};
use effigy_math::matrix::{MatrixView, multiply};
use std::ops::Range;

/// Columns of a Gaussian or a node, which blend the same anchors.
pub struct SharedColumns {
    /// Where its columns are.
    pub columns: Range<usize>,
    /// The anchors that it blends, as indices into [`ColumnSet::anchors`].
    pub shares: Vec<Share>,
}

/// The numbers of a part.
pub struct ColumnSet {
    /// Anchors that any item blends, in rising order.
    pub anchors: Vec<usize>,
    /// The features of each anchor that count; B of them.
    pub features: Range<usize>,
    /// Gaussians or nodes, in order.
    pub items: Vec<SharedColumns>,
    /// What a unit of each feature adds, shape columns, B.
    pub matrix: Vec<f32>,
    /// At the anchors' mean features, length columns.
    pub mean: Vec<f32>,
}

/// What an item's columns are before their mean is known.
pub struct Attribute<'a> {
    /// Without features, length C.
    pub neutral: &'a [f32],
    /// Shape B, C. None: nothing is added.
    pub basis: Option<&'a [f32]>,
    /// Factor of all of it.
    pub scale: f32,
}

impl ColumnSet {
    /// None yet, of items whose features are these of each anchor's.
    pub fn new(features: Range<usize>) -> Self {
        Self {
            anchors: vec![],
            features,
            items: vec![],
            matrix: vec![],
            mean: vec![],
        }
    }

    /// Features of an anchor, B.
    pub fn basis(&self) -> usize {
        self.features.len()
    }

    /// Number of columns.
    pub fn len(&self) -> usize {
        self.mean.len()
    }

    /// Numbers of a row of inputs, m.
    pub fn width(&self) -> usize {
        self.anchors.len() * self.basis()
    }

    /// Adds an item that blends a row's others. `means`: the mean features of each anchor.
    pub fn add(&mut self, blend: &Blend, row: usize, attributes: &[Attribute], means: &[Vec<f32>]) {
        let basis = self.basis();
        let start = self.mean.len();
        let mut mean = vec![0.0f32; basis];
        for share in blend.of(row) {
            let own = &means[share.index][self.features.clone()];
            for (mean, e) in mean.iter_mut().zip(own) {
                *mean += share.weight * e;
            }
        }
        for attribute in attributes {
            let width = attribute.neutral.len();
            for (c, neutral) in attribute.neutral.iter().enumerate() {
                let along = |b: usize| {
                    let entry = attribute.basis.map_or(0.0, |basis| basis[b * width + c]);
                    attribute.scale * entry
                };
                let column = self.matrix.len();
                self.matrix.extend((0..basis).map(along));
                self.mean
                    .push(attribute.scale * neutral + dot(&self.matrix[column..], &mean));
            }
        }
        let used = || blend.of(row).filter(|share| share.weight > 0.0);
        for share in used() {
            if let Err(at) = self.anchors.binary_search(&share.index) {
                self.make_room(at, share.index);
            }
        }
        let shares = used().map(|share| Share {
            index: self.anchors.partition_point(|&anchor| anchor < share.index),
            ..share
        });
        let shares = shares.collect();
        self.items.push(SharedColumns {
            columns: start..self.mean.len(),
            shares,
        });
    }

    /// Inserts an anchor.
    fn make_room(&mut self, at: usize, anchor: usize) {
        self.anchors.insert(at, anchor);
        for share in self.items.iter_mut().flat_map(|item| &mut item.shares) {
            share.index += usize::from(share.index >= at);
        }
    }

    /// A column's basis, length B.
    pub fn column(&self, column: usize) -> &[f32] {
        &self.matrix[column * self.basis()..][..self.basis()]
    }

    /// The anchors' features less their means, shape rows, m.
    pub fn deviations(&self, features: &AnchorFeatures, means: &[Vec<f32>]) -> Vec<f32> {
        let mut all = Vec::with_capacity(features.rows * self.width());
        for row in 0..features.rows {
            for &anchor in &self.anchors {
                let own = &features.of(anchor, row)[self.features.clone()];
                let mean = &means[anchor][self.features.clone()];
                all.extend(own.iter().zip(mean).map(|(e, mean)| e - mean));
            }
        }
        all
    }

    /// Cᵀ C of the map C from features to columns, shape m, m.
    pub fn quadratic(&self) -> Vec<f64> {
        let (basis, width) = (self.basis(), self.width());
        let mut sum = vec![0.0f64; width * width];
        let mut own = vec![0.0f32; basis * basis];
        for item in &self.items {
            let rows = item.columns.len();
            let matrix = &self.matrix[item.columns.start * basis..item.columns.end * basis];
            let matrix = MatrixView::new(matrix, rows, basis);
            multiply(matrix.transposed(), matrix, 0.0, &mut own);
            for a in &item.shares {
                for b in &item.shares {
                    let weight = f64::from(a.weight * b.weight);
                    for i in 0..basis {
                        let at = (a.index * basis + i) * width + b.index * basis;
                        let out = &mut sum[at..at + basis];
                        for (out, own) in out.iter_mut().zip(&own[i * basis..]) {
                            *out += weight * f64::from(*own);
                        }
                    }
                }
            }
        }
        sum
    }
}

fn dot(a: &[f32], b: &[f32]) -> f32 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
