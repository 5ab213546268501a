//! Spherical harmonics as functions of a direction.

use glam::DVec3;
use std::f64::consts::PI;

/// Functions of degree 1 to `degree`.
pub fn functions_of(degree: usize) -> usize {
    (degree + 1).pow(2) - 1
}

/// The real spherical harmonics of degree 0 to 3 of a direction of length 1, in 3DGS's order and
/// with its signs.
pub fn functions(d: DVec3) -> [f64; 16] {
    let DVec3 { x, y, z } = d;
    let norm = |numerator: f64, denominator: f64| (numerator / (denominator * PI)).sqrt();
    [
        norm(1.0, 4.0),
        -norm(3.0, 4.0) * y,
        norm(3.0, 4.0) * z,
        -norm(3.0, 4.0) * x,
        norm(15.0, 4.0) * x * y,
        -norm(15.0, 4.0) * y * z,
        norm(5.0, 16.0) * (2.0 * z * z - x * x - y * y),
        -norm(15.0, 4.0) * x * z,
        norm(15.0, 16.0) * (x * x - y * y),
        -norm(35.0, 32.0) * y * (3.0 * x * x - y * y),
        norm(105.0, 4.0) * x * y * z,
        -norm(21.0, 32.0) * y * (4.0 * z * z - x * x - y * y),
        norm(7.0, 16.0) * z * (2.0 * z * z - 3.0 * x * x - 3.0 * y * y),
        -norm(21.0, 32.0) * x * (4.0 * z * z - x * x - y * y),
        norm(105.0, 16.0) * z * (x * x - y * y),
        -norm(35.0, 32.0) * x * (x * x - 3.0 * y * y),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::avatar::ShCoefficients;

    /// The functions' products, integrated over the sphere, are 1 for equal and 0 for different
    /// ones.
    #[test]
    fn the_functions_are_orthonormal() {
        const STEPS: [usize; 2] = [64, 128];
        let mut product = [[0.0; 16]; 16];
        for row in 0..STEPS[0] {
            // Gauss would need fewer points; the midpoint rule in z is exact enough.
            let z = (row as f64 + 0.5) / STEPS[0] as f64 * 2.0 - 1.0;
            for column in 0..STEPS[1] {
                let angle = column as f64 / STEPS[1] as f64 * 2.0 * PI;
                let radius = (1.0 - z * z).sqrt();
                let f = functions(DVec3::new(radius * angle.cos(), radius * angle.sin(), z));
                let area = 4.0 * PI / (STEPS[0] * STEPS[1]) as f64;
                for a in 0..16 {
                    for b in 0..16 {
                        product[a][b] += area * f[a] * f[b];
                    }
                }
            }
        }
        for (a, row) in product.iter().enumerate() {
            for (b, value) in row.iter().enumerate() {
                let exact = f64::from(u8::from(a == b));
                assert!(
                    (value - exact).abs() < 5e-3,
                    "functions {a} and {b}: {value} instead of {exact}"
                );
            }
        }
        assert!((functions(DVec3::X)[0] - ShCoefficients::CONSTANT).abs() < 1e-15);
    }

    /// 3DGS's own signs: bands 1 to 3 at a direction where none vanishes, worked out by hand for
    /// (2, 3, 6) / 7.
    #[test]
    fn signs_are_those_of_3dgs() {
        let signs = functions(DVec3::new(2.0, 3.0, 6.0) / 7.0).map(f64::signum);
        assert_eq!(
            signs,
            [
                1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0, 1.0, -1.0, -1.0,
                1.0
            ]
        );
    }
}
