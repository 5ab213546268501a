//! A posed mesh in; the light that reaches each of its vertices, ray traced against it, out.
//!
//! The light is the bake's: a cool sky, a soft warm key from the front, a little from the ground, around the hips and turning with them
//! (the networks don't see how the hips are turned). Each vertex asks a fixed set of directions whether something is in the way, which
//! gives ambient occlusion and the key's cast shadows at once, and keeps what comes through as spherical harmonics of degree 2: enough for
//! the irradiance of any normal near the vertex (Ramamoorthi and Hanrahan 2001).

use super::mesh::Mesh;
use crate::bake::light::{direction, radiance};
use glam::{DVec3, Vec3A};
use obvhs::{BvhBuildParams, cwbvh::CwBvh, cwbvh::builder::build_cwbvh_from_tris, ray::Ray, triangle::Triangle};
use rayon::prelude::*;
use std::time::Duration;

/// What is nearer than this throws no shadow, metres: sheets lie a little over one another.
const BIAS: f32 = 0.009;
/// Rays begin this far above the surface, metres.
const LIFT: f64 = 0.002;
/// Functions of degrees 0 to 2.
const FUNCTIONS: usize = 9;

/// Radiance around a point as spherical harmonics, RGB.
pub type Around = [DVec3; FUNCTIONS];

/// The directions that rays take, with the radiance that comes from each.
pub struct Sky {
    directions: Vec<(DVec3, DVec3, [f64; FUNCTIONS])>,
    /// Scales the irradiance to about 1 where nothing is in the way.
    scale: f64,
}

/// The real spherical harmonics of a unit vector.
fn functions(d: DVec3) -> [f64; FUNCTIONS] {
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

/// Light at a surface of a normal: the cosine's convolution, band by band.
pub fn irradiance(around: &Around, normal: DVec3) -> DVec3 {
    const BAND: [f64; FUNCTIONS] = [1.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 0.25, 0.25, 0.25, 0.25, 0.25];
    let y = functions(normal);
    (0..FUNCTIONS).map(|k| around[k] * (BAND[k] * y[k])).sum::<DVec3>().max(DVec3::ZERO)
}

impl Sky {
    /// `rays` directions over the whole sphere; each vertex asks those above its surface.
    pub fn new(rays: usize) -> Self {
        let directions: Vec<_> = (0..rays).map(|i| direction(i, rays)).map(|d| (d, radiance(d), functions(d))).collect();
        let whole: f64 = directions.iter().map(|(d, ..)| d.y.max(0.0)).sum();
        // π of the first band, over the cosines' sum.
        Self { scale: std::f64::consts::PI / whole.max(1e-9), directions }
    }

    /// What reaches the vertices named in `lit`; the others stay dark.
    pub fn light(&self, mesh: &Mesh, positions: &[DVec3], normals: &[DVec3], lit: &[u32]) -> Vec<Around> {
        let point = |v: u32| positions[v as usize].as_vec3a();
        let triangle = |&t: &usize| {
            let [v0, v1, v2] = mesh.triangles[t].map(point);
            Triangle { v0, v1, v2 }
        };
        let triangles: Vec<Triangle> = mesh.shown.par_iter().map(triangle).collect();
        let tree = build_cwbvh_from_tris(&triangles, BvhBuildParams::fast_build(), &mut Duration::default());
        let found: Vec<Around> = lit
            .par_iter()
            .map(|&v| {
                let (p, n) = (positions[v as usize], normals[v as usize]);
                self.around(&tree, &triangles, p + n * LIFT, n)
            })
            .collect();
        let mut all = vec![[DVec3::ZERO; FUNCTIONS]; positions.len()];
        lit.iter().zip(found).for_each(|(&v, found)| all[v as usize] = found);
        all
    }

    fn around(&self, tree: &CwBvh, triangles: &[Triangle], from: DVec3, normal: DVec3) -> Around {
        let mut sum = [DVec3::ZERO; FUNCTIONS];
        for (direction, radiance, functions) in self.directions.iter().filter(|(d, ..)| d.dot(normal) > 0.0) {
            let along: Vec3A = direction.as_vec3a();
            let ray = Ray::new(from.as_vec3a() + along * BIAS, along, 0.0, f32::INFINITY);
            if tree.ray_traverse_miss(ray, |ray, id| triangles[tree.primitive_indices[id] as usize].intersect(ray)) {
                (0..FUNCTIONS).for_each(|k| sum[k] += *radiance * functions[k]);
            }
        }
        sum.map(|s| s * self.scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn open_light_is_the_sum_over_the_directions_by_the_cosine() {
        let sky = Sky::new(2000);
        let mut around = [DVec3::ZERO; FUNCTIONS];
        for (_, radiance, functions) in &sky.directions {
            (0..FUNCTIONS).for_each(|k| around[k] += *radiance * functions[k] * sky.scale);
        }
        let whole: f64 = sky.directions.iter().map(|(d, ..)| d.y.max(0.0)).sum();
        for normal in [DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::new(1.0, 2.0, -2.0) / 3.0] {
            let expected = sky.directions.iter().map(|(d, r, _)| *r * d.dot(normal).max(0.0)).sum::<DVec3>() / whole;
            let got = irradiance(&around, normal);
            assert!((got - expected).abs().max_element() < 0.03 * expected.max_element(), "{normal}: {got}, expected {expected}");
        }
    }
}
