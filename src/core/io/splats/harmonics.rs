//! Splats in other axes: positions, rotations and spherical harmonics turn together.

use super::{Splats, Up};
use crate::avatar::harmonics::{functions, functions_of};
use crate::each;
use glam::{DMat3, DQuat, DVec3};
use std::f64::consts::PI;

/// The matrix of a rotation of the coefficients of degree 1 to 3: row i has the share of each old
/// coefficient in new coefficient i; 0 between degrees.
type ShRotation = [[f64; 15]; 15];

/// Zeros and weights of the Legendre polynomial of degree 4, for exact integrals of polynomials of
/// degree 7 over −1 to 1.
const LEGENDRE: [[f64; 2]; 4] = [
    [-0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
    [-0.339_981_043_584_856_26, 0.652_145_154_862_546_1],
    [0.339_981_043_584_856_26, 0.652_145_154_862_546_1],
    [0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
];
/// Meridians of the quadrature: exact for trigonometric polynomials below this degree.
const MERIDIANS: usize = 8;

/// The coefficients' rotation: the function of new coefficients at R d is the old one at d. Its
/// entries are integrals of products of two harmonics, which the quadrature gives exactly.
fn turn(rotation: DQuat) -> ShRotation {
    let mut turn = [[0.0; 15]; 15];
    for [z, weight] in LEGENDRE {
        let radius = (1.0 - z * z).sqrt();
        for meridian in 0..MERIDIANS {
            let angle = 2.0 * PI * meridian as f64 / MERIDIANS as f64;
            let d = DVec3::new(radius * angle.cos(), radius * angle.sin(), z);
            let old = functions(d);
            let new = functions(rotation * d);
            let area = weight * 2.0 * PI / MERIDIANS as f64;
            for (row, new) in turn.iter_mut().zip(&new[1..]) {
                for (entry, old) in row.iter_mut().zip(&old[1..]) {
                    *entry += area * new * old;
                }
            }
        }
    }
    turn
}

impl Splats {
    /// The same scene with another axis up: it stands as before.
    pub fn with_up(self, up: Up) -> Self {
        if self.up == up {
            return self;
        }
        let rotation = up.rotation().inverse() * self.up.rotation();
        Self {
            up,
            ..self.turned(rotation, 1.0, DVec3::ZERO)
        }
    }

    /// The scene scaled, then rotated, then moved by `offset`, metres; `up` stays.
    pub fn turned(mut self, rotation: DQuat, scale: f64, offset: DVec3) -> Self {
        let matrix = DMat3::from_quat(rotation) * scale;
        let count = self.len();
        let position = &self.position;
        let position = each::map(count, |k| {
            let at = DVec3::from(position[k].map(f64::from));
            (matrix * at + offset).as_vec3().to_array()
        });
        let old = &self.rotation;
        let quaternion = each::map(count, |k| {
            let [w, x, y, z] = old[k].map(f64::from);
            let q = rotation * DQuat::from_xyzw(x, y, z, w);
            [q.w, q.x, q.y, q.z].map(|v| v as f32)
        });
        if scale != 1.0 {
            let more = scale.ln() as f32;
            for row in &mut self.log_scale {
                *row = row.map(|s| s + more);
            }
        }
        if self.degree > 0 {
            self.turn_harmonics(&turn(rotation));
        }
        Self {
            position,
            rotation: quaternion,
            ..self
        }
    }

    fn turn_harmonics(&mut self, turn: &ShRotation) {
        for row in self.harmonics.chunks_exact_mut(functions_of(self.degree)) {
            let mut old = [[0.0; 3]; 15];
            for (old, new) in old.iter_mut().zip(row.iter()) {
                *old = new.map(f64::from);
            }
            for (new, factors) in row.iter_mut().zip(turn) {
                *new = std::array::from_fn(|channel| {
                    let parts = factors.iter().zip(&old);
                    parts
                        .map(|(factor, old)| factor * old[channel])
                        .sum::<f64>() as f32
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn splats() -> Splats {
        Splats {
            position: vec![[1.0, 2.0, 3.0]],
            rotation: vec![[0.5, 0.5, -0.5, 0.5]],
            log_scale: vec![[-3.0, -4.0, -5.0]],
            opacity: vec![1.0],
            color: vec![[0.1, 0.2, 0.3]],
            degree: 3,
            harmonics: (0..15).map(|k| [0.1 * k as f32 - 0.7; 3]).collect(),
            up: Up::MinusY,
            filter: crate::avatar::Filter::DEFAULT,
        }
    }

    fn look(splats: &Splats, d: DVec3) -> f64 {
        let functions = functions(d);
        let terms = functions[1..].iter().zip(&splats.harmonics);
        terms.map(|(f, c)| f * f64::from(c[0])).sum()
    }

    #[test]
    fn a_turned_scene_looks_the_same_from_turned_directions() {
        let rotation = DQuat::from_euler(glam::EulerRot::XYZ, 0.4, -1.3, 2.2);
        let before = splats();
        let after = before
            .clone()
            .turned(rotation, 2.0, DVec3::new(1.0, 0.0, 0.0));
        for d in [
            DVec3::X,
            DVec3::new(1.0, -2.0, 0.5),
            DVec3::new(-0.3, 0.2, 1.0),
        ] {
            let d = d.normalize();
            let [old, new] = [look(&before, d), look(&after, rotation * d)];
            assert!((old - new).abs() < 1e-6, "{old} {new}");
        }
        let expected = rotation * DVec3::new(2.0, 4.0, 6.0) + DVec3::X;
        assert!(DVec3::from(after.position[0].map(f64::from)).distance(expected) < 1e-6);
        assert!((after.log_scale[0][0] + 3.0 - 2f32.ln()).abs() < 1e-6);
    }

    #[test]
    fn from_y_down_to_y_up_signs_change() {
        let before = splats();
        let after = before.clone().with_up(Up::Y);
        assert_eq!(after.up, Up::Y);
        for (old, new) in before.harmonics.iter().zip(&after.harmonics) {
            assert!(
                (old[0].abs() - new[0].abs()).abs() < 1e-6,
                "{old:?} {new:?}"
            );
        }
        let at = after.position[0];
        assert!((at[0] - 1.0).abs() + (at[1] + 2.0).abs() + (at[2] + 3.0).abs() < 1e-6);
        let back = after.with_up(Up::MinusY);
        for (old, new) in before.harmonics.iter().zip(&back.harmonics) {
            assert!((old[0] - new[0]).abs() < 1e-6);
        }
    }
}
