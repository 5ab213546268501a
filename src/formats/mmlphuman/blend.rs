//! What blends what: of each Gaussian or node a few nearest others, with weights.

use super::fields::CheckpointFields;
use crate::fault::tensor;
use effigy_core::io::file::FormatError;

/// Others that each row may blend.
const MAX_WIDTH: usize = 8;

/// A few others of each row, with weights that sum to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Blend {
    /// Others of a row; 3 in mmlphuman.
    pub width: usize,
    /// Shape rows, width.
    pub index: Vec<u32>,
    /// Shape rows, width; not negative.
    pub weight: Vec<f32>,
}

/// One of a row's others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Which one.
    pub index: usize,
    /// Its weight.
    pub weight: f32,
}

impl Blend {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.index.len() / self.width.max(1)
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.index.is_empty()
    }

    /// The others of a row.
    pub fn of(&self, row: usize) -> impl Iterator<Item = Share> {
        let range = row * self.width..(row + 1) * self.width;
        let pairs = self.index[range.clone()].iter().zip(&self.weight[range]);
        pairs.map(|(&index, &weight)| Share {
            index: index as usize,
            weight,
        })
    }

    /// The other of a row that has the largest weight; the first of equal ones.
    pub fn nearest(&self, row: usize) -> usize {
        let none = Share {
            index: 0,
            weight: f32::NEG_INFINITY,
        };
        let larger = |best: Share, own: Share| if own.weight > best.weight { own } else { best };
        self.of(row).fold(none, larger).index
    }

    /// Reads the others of `rows` rows, of which there are `others`, and weights in proportion.
    pub(super) fn read(
        fields: CheckpointFields,
        index: &str,
        weight: &str,
        rows: usize,
        others: usize,
    ) -> Result<Self, FormatError> {
        let width = fields.shape(index, &[Some(rows), None])?[1];
        if width == 0 || width > MAX_WIDTH {
            return Err(tensor(
                index,
                format!("{width} a row"),
                format!("1 to {MAX_WIDTH}"),
            ));
        }
        let shape = [rows, width];
        let mut weights = fields.floats(weight, &shape)?;
        for (row, own) in weights.chunks_exact_mut(width).enumerate() {
            let sum: f32 = own.iter().sum();
            if own.iter().any(|&w| w < 0.0) || !(sum > 0.0 && sum.is_finite()) {
                let found = format!("{own:?} at row {row}");
                return Err(tensor(
                    weight,
                    found,
                    "weights from 0 with a finite sum above 0",
                ));
            }
            for w in own {
                *w /= sum;
            }
        }
        Ok(Self {
            width,
            index: fields.indices(index, &shape, others)?,
            weight: weights,
        })
    }
}
