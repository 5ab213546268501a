//! Which basis rows stay: those whose correctives vary most over the training's poses.

use crate::parameters::{BASIS, COMPONENTS, Layout, Parameters};
use crate::topology::{Rows, Topology};
use rayon::prelude::*;

/// How the features of each part vary over poses: the covariance of the attributes' half; shape
/// N_G, N_B, N_B.
pub fn feature_covariance(features: &[Vec<f64>], parts: usize, width: usize) -> Vec<f64> {
    let count = features.len().max(1) as f64;
    (0..parts)
        .into_par_iter()
        .flat_map_iter(|part| {
            let own = |pose: &'_ Vec<f64>| pose[part * width..][..BASIS].to_vec();
            let rows: Vec<Vec<f64>> = features.iter().map(own).collect();
            let mean: Vec<f64> = (0..BASIS)
                .map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / count)
                .collect();
            let mut covariance = vec![0.0; BASIS * BASIS];
            for row in &rows {
                for i in 0..BASIS {
                    for j in 0..BASIS {
                        covariance[i * BASIS + j] +=
                            (row[i] - mean[i]) * (row[j] - mean[j]) / count;
                    }
                }
            }
            covariance
        })
        .collect()
}

/// The rows that stay: `share` of the Gaussians, for each attribute those whose corrective B e
/// varies most, Σ_c b_c C b_cᵀ with the covariance C of their part's features.
pub fn select(
    parameters: &Parameters<f32>,
    topology: &Topology,
    layout: &Layout,
    rows: &Rows,
    covariance: &[f64],
    share: f64,
) -> Rows {
    let keep = (share * layout.gaussians as f64).round() as usize;
    let gaussian = std::array::from_fn(|attribute| {
        let variance = |(row, &gaussian): (usize, &u32)| {
            let part = usize::from(topology.gaussians[gaussian as usize].part);
            let c = &covariance[part * BASIS * BASIS..][..BASIS * BASIS];
            let basis = &parameters.bases[layout.row(attribute, row)];
            let sum: f64 = basis.chunks_exact(BASIS).map(|b| quadratic(b, c)).sum();
            (sum, gaussian)
        };
        let own = &rows.gaussian[attribute];
        let mut ranked: Vec<(f64, u32)> = own.par_iter().enumerate().map(variance).collect();
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut kept: Vec<u32> = ranked.into_iter().take(keep).map(|(_, k)| k).collect();
        kept.sort_unstable();
        kept
    });
    Rows { gaussian }
}

/// b C bᵀ.
fn quadratic(b: &[f32], c: &[f64]) -> f64 {
    let of_row = |i: usize| -> f64 {
        (0..BASIS)
            .map(|j| c[i * BASIS + j] * f64::from(b[j]))
            .sum::<f64>()
            * f64::from(b[i])
    };
    (0..BASIS).map(of_row).sum()
}

/// The numbers of the rows that stay; everything else as it is.
pub fn keep_rows(
    numbers: &Parameters<f32>,
    layout: &Layout,
    rows: &Rows,
    kept: &Rows,
) -> Parameters<f32> {
    let mut bases = Vec::new();
    for (attribute, components) in COMPONENTS.into_iter().enumerate() {
        for &gaussian in &kept.gaussian[attribute] {
            match rows.row(attribute, gaussian as usize) {
                Some(row) => bases.extend(&numbers.bases[layout.row(attribute, row)]),
                None => bases.extend(std::iter::repeat_n(0.0, components * BASIS)),
            }
        }
    }
    Parameters {
        bases,
        ..numbers.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn covariance_is_that_of_the_attributes_half() {
        let pose = |a: f64| {
            let mut features = vec![0.0; 2 * 2 * BASIS];
            features[0] = a;
            features[1] = -2.0 * a;
            features[BASIS] = 100.0 * a;
            features
        };
        let covariance = feature_covariance(&[pose(1.0), pose(-1.0)], 2, 2 * BASIS);
        assert_eq!(covariance.len(), 2 * BASIS * BASIS);
        assert_eq!(covariance[..2], [1.0, -2.0]);
        assert_eq!(covariance[BASIS..BASIS + 2], [-2.0, 4.0]);
        assert!(covariance[BASIS * BASIS..].iter().all(|&v| v == 0.0));
    }

    #[test]
    fn what_varies_most_is_not_what_is_largest() {
        // The second feature never moves: large weights on it vary nothing.
        let mut c = vec![0.0; BASIS * BASIS];
        c[0] = 4.0;
        let mut still = vec![0.0f32; BASIS];
        still[1] = 10.0;
        let mut moving = vec![0.0f32; BASIS];
        moving[0] = 0.5;
        assert_eq!((quadratic(&still, &c), quadratic(&moving, &c)), (0.0, 1.0));
    }
}
