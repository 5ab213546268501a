//! The light that reaches each vertex of a posed mesh, ray traced against it.
//!
//! The light is the bake's: a cool sky, a soft warm key light from the front, a little from the
//! ground. It stands around the hips and turns with them, since the networks don't see how the hips
//! are turned. Rays from each vertex in a fixed set of directions give ambient occlusion and the
//! key light's cast shadows at once. The light that comes through is stored as spherical harmonics
//! of degree 2, enough for the irradiance of any normal near the vertex (Ramamoorthi and Hanrahan
//! 2001).

use crate::bake::sky::{direction, radiance};
use crate::ground_truth::mesh::SheetMesh;
use glam::{DVec3, Vec3A};
use obvhs::{
    BvhBuildParams, cwbvh::CwBvh, cwbvh::builder::build_cwbvh_from_tris, ray::Ray,
    triangle::Triangle,
};
use rayon::prelude::*;
use std::time::Duration;

/// Surfaces nearer than this cast no shadow, metres: sheets lie a little over one another.
const BIAS: f32 = 0.009;
/// Rays begin this far above the surface, metres.
const LIFT: f64 = 0.002;
/// Spherical harmonics of degrees 0 to 2.
const FUNCTIONS: usize = 9;

/// Radiance around a point as spherical harmonics, RGB.
pub type RadianceSh = [DVec3; FUNCTIONS];

/// A direction that rays take.
struct SkyDirection {
    /// Unit vector.
    direction: DVec3,
    /// Light from there if nothing is in the way, linear RGB.
    radiance: DVec3,
    harmonics: [f64; FUNCTIONS],
}

/// The directions that rays take, with the light from each.
pub struct TracedSky {
    directions: Vec<SkyDirection>,
    /// Scales the irradiance to about 1 where nothing is in the way.
    scale: f64,
}

/// The real spherical harmonics of a unit vector.
fn harmonics(d: DVec3) -> [f64; FUNCTIONS] {
    let DVec3 { x, y, z } = d;
    [
        0.282_095,
        0.488_603 * y,
        0.488_603 * z,
        0.488_603 * x,
        1.092_548 * x * y,
        1.092_548 * y * z,
        0.315_392 * (3.0 * z * z - 1.0),
        1.092_548 * x * z,
        0.546_274 * (x * x - y * y),
    ]
}

/// Light at a surface with a unit normal: the convolution with a cosine, degree by degree.
pub fn irradiance(radiance: &RadianceSh, normal: DVec3) -> DVec3 {
    const DEGREE_1: f64 = 2.0 / 3.0;
    const DEGREE_2: f64 = 0.25;
    const FACTORS: [f64; FUNCTIONS] = [
        1.0, DEGREE_1, DEGREE_1, DEGREE_1, DEGREE_2, DEGREE_2, DEGREE_2, DEGREE_2, DEGREE_2,
    ];
    let harmonics = harmonics(normal);
    (0..FUNCTIONS)
        .map(|k| radiance[k] * (FACTORS[k] * harmonics[k]))
        .sum::<DVec3>()
        .max(DVec3::ZERO)
}

impl TracedSky {
    /// `rays` directions over the whole sphere. Each vertex uses those above its surface.
    pub fn new(rays: usize) -> Self {
        let directions: Vec<SkyDirection> = (0..rays)
            .map(|i| direction(i, rays))
            .map(|direction| SkyDirection {
                direction,
                radiance: radiance(direction),
                harmonics: harmonics(direction),
            })
            .collect();
        let cosines: f64 = directions.iter().map(|sky| sky.direction.y.max(0.0)).sum();
        Self {
            // π of degree 0's convolution, over the sum of the cosines.
            scale: std::f64::consts::PI / cosines.max(1e-9),
            directions,
        }
    }

    /// The light at the vertices listed in `lit`; the others stay dark.
    pub fn light(
        &self,
        mesh: &SheetMesh,
        positions: &[DVec3],
        normals: &[DVec3],
        lit: &[u32],
    ) -> Vec<RadianceSh> {
        let point = |v: u32| positions[v as usize].as_vec3a();
        let triangle = |&t: &usize| {
            let [v0, v1, v2] = mesh.triangles[t].map(point);
            Triangle { v0, v1, v2 }
        };
        let triangles: Vec<Triangle> = mesh.visible.par_iter().map(triangle).collect();
        let tree = build_cwbvh_from_tris(
            &triangles,
            BvhBuildParams::fast_build(),
            &mut Duration::default(),
        );
        let found: Vec<RadianceSh> = lit
            .par_iter()
            .map(|&v| {
                let normal = normals[v as usize];
                let from = positions[v as usize] + normal * LIFT;
                self.radiance_at(from, normal, &tree, &triangles)
            })
            .collect();
        let mut all = vec![[DVec3::ZERO; FUNCTIONS]; positions.len()];
        for (&v, found) in lit.iter().zip(found) {
            all[v as usize] = found;
        }
        all
    }

    fn radiance_at(
        &self,
        from: DVec3,
        normal: DVec3,
        tree: &CwBvh,
        triangles: &[Triangle],
    ) -> RadianceSh {
        let mut sum = [DVec3::ZERO; FUNCTIONS];
        for sky in &self.directions {
            if sky.direction.dot(normal) <= 0.0 {
                continue;
            }
            let along: Vec3A = sky.direction.as_vec3a();
            let ray = Ray::new(from.as_vec3a() + along * BIAS, along, 0.0, f32::INFINITY);
            let is_open = tree.ray_traverse_miss(ray, |ray, id| {
                triangles[tree.primitive_indices[id] as usize].intersect(ray)
            });
            if is_open {
                for (sum, harmonic) in sum.iter_mut().zip(sky.harmonics) {
                    *sum += sky.radiance * harmonic;
                }
            }
        }
        sum.map(|s| s * self.scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn open_sky_irradiance_is_the_cosine_weighted_sum() {
        let sky = TracedSky::new(2000);
        let mut radiance = [DVec3::ZERO; FUNCTIONS];
        for direction in &sky.directions {
            for (sum, harmonic) in radiance.iter_mut().zip(direction.harmonics) {
                *sum += direction.radiance * harmonic * sky.scale;
            }
        }
        let cosines: f64 = sky
            .directions
            .iter()
            .map(|sky| sky.direction.y.max(0.0))
            .sum();
        for normal in [
            DVec3::Y,
            DVec3::Z,
            DVec3::NEG_X,
            DVec3::new(1.0, 2.0, -2.0) / 3.0,
        ] {
            let expected = sky
                .directions
                .iter()
                .map(|sky| sky.radiance * sky.direction.dot(normal).max(0.0))
                .sum::<DVec3>()
                / cosines;
            let got = irradiance(&radiance, normal);
            assert!(
                (got - expected).abs().max_element() < 0.03 * expected.max_element(),
                "{normal}: {got}, expected {expected}"
            );
        }
    }
}
