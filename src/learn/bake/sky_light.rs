//! How much of the sky each point of the sheets sees. The model has no lights, so form comes from
//! light baked into the colours.
//!
//! The sky is a set of directions. A depth map for each says which points are lit; a point's light
//! is the sum over the directions that reach it, weighted by the cosine.

use crate::bake::sky::{direction, radiance};
use crate::bake::surface::Sheet;
use effigy_math::noise::smoothstep;
use glam::{DVec2, DVec3};
use rayon::prelude::*;

const DIRECTIONS: usize = 160;
/// Cells of a depth map a metre.
const CELLS: f64 = 400.0;
/// A point this far behind the first surface still counts as lit, metres: sheets lie a little over
/// one another.
const BIAS: f64 = 0.009;
/// Points are lit this far above their surface, metres.
const LIFT: f64 = 0.004;

/// The nearest surface seen from one direction of the sky.
struct DepthMap {
    /// Unit vector towards the light.
    direction: DVec3,
    radiance: DVec3,
    /// Of the map's plane.
    axes: [DVec3; 2],
    /// The map's lower corner, in cells along the axes.
    corner: [f64; 2],
    size: [usize; 2],
    /// The largest distance along the direction in each cell, row by row, metres.
    depths: Vec<f32>,
}

/// The light of the sky on a body in its rest pose.
pub struct BakedSky(Vec<DepthMap>);

impl BakedSky {
    /// `casts_shadow` says which triangles count, by the indices of sheet and triangle.
    pub fn new(sheets: &[Sheet], casts_shadow: impl Fn(usize, usize) -> bool + Sync) -> Self {
        let mut triangles: Vec<[DVec3; 3]> = Vec::new();
        for (s, sheet) in sheets.iter().enumerate() {
            for (t, triangle) in sheet.triangles.iter().enumerate() {
                if casts_shadow(s, t) {
                    triangles.push(triangle.map(|v| sheet.vertices[v as usize].position));
                }
            }
        }
        Self(
            (0..DIRECTIONS)
                .into_par_iter()
                .map(|i| DepthMap::new(direction(i, DIRECTIONS), &triangles))
                .collect(),
        )
    }

    /// Light at a point with a unit normal, linear RGB; about 1 where nothing is in the way.
    pub fn light(&self, p: DVec3, normal: DVec3) -> DVec3 {
        let mut sum = DVec3::ZERO;
        let mut cosines = 0.0;
        for map in &self.0 {
            let cosine = normal.dot(map.direction);
            cosines += map.direction.y.max(0.0);
            if cosine > 0.0 {
                sum += map.radiance * cosine * map.visibility(p + LIFT * normal);
            }
        }
        sum / cosines.max(1e-9)
    }
}

/// Twice the signed area of the triangle o, a, b.
fn doubled_area(o: DVec2, a: DVec2, b: DVec2) -> f64 {
    (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x)
}

impl DepthMap {
    fn new(direction: DVec3, triangles: &[[DVec3; 3]]) -> Self {
        let axes: [DVec3; 2] = direction.any_orthonormal_pair().into();
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for p in triangles.iter().flatten() {
            for k in 0..2 {
                let v = p.dot(axes[k]) * CELLS;
                low[k] = low[k].min(v);
                high[k] = high[k].max(v);
            }
        }
        let corner = low.map(|v| v.floor() - 2.0);
        let size: [usize; 2] = std::array::from_fn(|k| {
            if high[k] >= low[k] {
                (high[k] - corner[k]).ceil() as usize + 3
            } else {
                1
            }
        });
        let mut map = Self {
            direction,
            radiance: radiance(direction),
            axes,
            corner,
            size,
            depths: vec![f32::NEG_INFINITY; size[0] * size[1]],
        };
        for triangle in triangles {
            map.draw(triangle);
        }
        map
    }

    /// A point in the map's plane, in cells from its lower corner.
    fn project(&self, p: DVec3) -> DVec2 {
        DVec2::from_array(std::array::from_fn(|k| {
            p.dot(self.axes[k]) * CELLS - self.corner[k]
        }))
    }

    /// Every cell whose middle a triangle covers keeps the largest distance.
    fn draw(&mut self, triangle: &[DVec3; 3]) {
        let [a, b, c] = triangle.map(|p| self.project(p));
        let z = triangle.map(|p| p.dot(self.direction));
        let area = doubled_area(a, b, c);
        if area.abs() < 1e-9 {
            return;
        }
        let range = |k: usize| {
            let low = a[k].min(b[k]).min(c[k]).floor().max(0.0) as usize;
            let high = a[k].max(b[k]).max(c[k]).ceil() as usize;
            low..=high.min(self.size[k] - 1)
        };
        for y in range(1) {
            for x in range(0) {
                let p = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                // Barycentric coordinates of b and c.
                let u = doubled_area(a, p, c) / area;
                let v = doubled_area(a, b, p) / area;
                if u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
                    let depth = &mut self.depths[y * self.size[0] + x];
                    *depth = depth.max((z[0] + u * (z[1] - z[0]) + v * (z[2] - z[0])) as f32);
                }
            }
        }
    }

    /// 1 where nothing is in the way, 0 in shadow, smooth between: interpolated between the four
    /// nearest cells.
    fn visibility(&self, p: DVec3) -> f64 {
        let here = p.dot(self.direction);
        let at = self.project(p) - 0.5;
        let low = at.floor();
        let t = at - low;
        let lit = |x: f64, y: f64| {
            let inside =
                x >= 0.0 && y >= 0.0 && (x as usize) < self.size[0] && (y as usize) < self.size[1];
            let blocker = if inside {
                f64::from(self.depths[y as usize * self.size[0] + x as usize])
            } else {
                f64::NEG_INFINITY
            };
            smoothstep(2.0 * BIAS, BIAS, blocker - here)
        };
        let row = |y: f64| lit(low.x, y) * (1.0 - t.x) + lit(low.x + 1.0, y) * t.x;
        row(low.y) * (1.0 - t.y) + row(low.y + 1.0) * t.y
    }
}
