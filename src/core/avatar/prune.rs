//! Pruning of correctives by their norm. The number of retained basis rows, N_P, trades bytes for
//! error.

use super::{Avatar, Rows};

impl Avatar {
    /// Retains `share` (0 to 1) of the basis rows of each attribute: those with the largest norm,
    /// whose Gaussians can change most. Gaussians that lose their row keep their neutral value.
    /// Rows stay in the order of their Gaussians; of equal rows the first are retained.
    ///
    /// The norm depends on the model alone. How much a row contributes over training poses is known
    /// only from those poses.
    pub fn retain_rows(&self, share: f64) -> Self {
        let basis = self.basis_len();
        Self {
            rotation_rows: self.rotation_rows.largest(share, basis),
            scale_rows: self.scale_rows.largest(share, basis),
            color_rows: self.color_rows.largest(share, basis),
            ..self.clone()
        }
    }
}

impl<const C: usize> Rows<C> {
    fn largest(&self, share: f64, basis: usize) -> Self {
        let length = C * basis;
        let squares: Vec<f64> = self
            .basis
            .rows(length)
            .map(|row| row.iter().map(|v| v.powi(2)).sum())
            .collect();
        let mut retained: Vec<usize> = (0..squares.len()).collect();
        retained.sort_by(|&a, &b| squares[b].total_cmp(&squares[a]));
        retained.truncate((share.clamp(0.0, 1.0) * squares.len() as f64).round() as usize);
        retained.sort_unstable();
        Self {
            gaussian: retained.iter().map(|&at| self.gaussian[at]).collect(),
            basis: self.basis.pick(&retained, length),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::avatar::Matrix;
    use half::f16;

    fn rows(norms: &[f32]) -> Rows<3> {
        let basis = norms
            .iter()
            .flat_map(|&norm| [norm, 0.0, 0.0, 0.0, -norm, 0.0].map(f16::from_f32));
        Rows {
            gaussian: (0..norms.len() as u32).map(|at| 10 * at).collect(),
            basis: basis.collect(),
        }
    }

    #[test]
    fn the_largest_rows_stay_in_order() {
        let all = rows(&[0.5, 2.0, 0.1, 1.0]);
        assert_eq!(all.largest(1.0, 2), all);
        let half = all.largest(0.5, 2);
        assert_eq!(half.gaussian, [10, 30]);
        assert_eq!(half.basis, rows(&[2.0, 1.0]).basis);
        assert_eq!(rows(&[1.0, 1.0]).largest(0.5, 2).gaussian, [0]);
        assert_eq!(
            all.largest(0.0, 2),
            Rows {
                gaussian: vec![],
                basis: Matrix::default()
            }
        );
    }

    #[test]
    fn a_pruned_avatar_is_a_valid_one() {
        let avatar = crate::demo::avatar().expect("inside the program");
        for share in [0.0, 0.3, 1.0] {
            let pruned = avatar.retain_rows(share);
            let read = Avatar::from_bytes(&pruned.to_bytes().expect("it can be written"))
                .expect("it can be read");
            assert_eq!(read, pruned);
            let expected = (share * avatar.color_rows.gaussian.len() as f64).round() as usize;
            assert_eq!(pruned.color_rows.gaussian.len(), expected);
        }
        assert_eq!(avatar.retain_rows(1.0), avatar);
    }
}
