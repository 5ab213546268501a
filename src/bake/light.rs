//! Sheets in; how much of a fixed sky each point sees, out. The model has no lights, so form comes from light baked into the colours.
//!
//! The sky is a set of directions with a colour each. One depth picture a direction says what is lit; a point's light is the sum of
//! what reaches it, by the cosine.

use super::math::step;
use super::surface::Sheet;
use glam::DVec3;
use rayon::prelude::*;

const DIRECTIONS: usize = 160;
/// Cells of a depth picture a metre.
const CELLS: f64 = 400.0;
/// A point this far behind what a direction sees first still counts as lit, metres: sheets lie a little over one another.
const BIAS: f64 = 0.009;

struct Depth {
    direction: DVec3,
    radiance: DVec3,
    axes: [DVec3; 2],
    corner: [f64; 2],
    size: [usize; 2],
    /// Largest distance along the direction in each cell.
    far: Vec<f32>,
}

/// The baked sky.
pub struct Sky(Vec<Depth>);

/// Cool from above, a warm key from the front and the avatar's upper right, a little from the ground.
pub fn radiance(d: DVec3) -> DVec3 {
    let sky = DVec3::new(0.86, 0.93, 1.0) * (0.30 + 0.62 * step(-0.25, 0.95, d.y));
    let ground = DVec3::new(1.0, 0.93, 0.85) * 0.16 * step(0.1, -0.8, d.y);
    let key = DVec3::new(-0.45, 0.62, 0.64).normalize();
    sky + ground
        + DVec3::new(1.0, 0.93, 0.83) * 2.9 * step(0.55, 1.0, d.dot(key))
        + DVec3::new(0.85, 0.93, 1.0) * 0.5 * step(0.5, 1.0, d.dot(DVec3::new(0.8, 0.35, -0.5).normalize()))
}

/// The i-th of `count` directions spread evenly over the sphere: a Fibonacci spiral.
pub fn direction(i: usize, count: usize) -> DVec3 {
    let y = 1.0 - 2.0 * (i as f64 + 0.5) / count as f64;
    let turn = i as f64 * std::f64::consts::PI * (3.0 - 5f64.sqrt());
    let radius = (1.0 - y * y).sqrt();
    DVec3::new(radius * turn.cos(), y, radius * turn.sin())
}

impl Sky {
    /// `shown` says which triangles of a sheet cast shadows.
    pub fn new(sheets: &[Sheet], shown: impl Fn(usize, usize) -> bool + Sync) -> Self {
        let triangles: Vec<[DVec3; 3]> = sheets
            .iter()
            .enumerate()
            .flat_map(|(s, sheet)| {
                let shown = &shown;
                (0..sheet.triangles.len())
                    .filter(move |t| shown(s, *t))
                    .map(|t| sheet.triangles[t].map(|v| sheet.vertices[v as usize].position))
            })
            .collect();
        Self((0..DIRECTIONS).into_par_iter().map(|i| Depth::new(direction(i, DIRECTIONS), &triangles)).collect())
    }

    /// Light at a point, linear; about 1 where nothing is in the way.
    pub fn light(&self, p: DVec3, normal: DVec3) -> DVec3 {
        let mut sum = DVec3::ZERO;
        let mut whole = 0.0;
        for depth in &self.0 {
            let cosine = normal.dot(depth.direction);
            whole += depth.direction.y.max(0.0);
            if cosine > 0.0 {
                sum += depth.radiance * cosine * depth.open(p + 0.004 * normal);
            }
        }
        sum / whole.max(1e-9)
    }
}

impl Depth {
    fn new(direction: DVec3, triangles: &[[DVec3; 3]]) -> Self {
        let axes = super::math::frame(direction);
        let flat = |p: DVec3| axes.map(|axis| p.dot(axis) * CELLS);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in triangles.iter().flatten() {
            for (k, v) in flat(*p).into_iter().enumerate() {
                (low[k], high[k]) = (low[k].min(v), high[k].max(v));
            }
        }
        let corner = low.map(|v| v.floor() - 2.0);
        let size: [usize; 2] = std::array::from_fn(|k| if high[k] >= low[k] { (high[k] - corner[k]).ceil() as usize + 3 } else { 1 });
        let mut depth =
            Self { direction, radiance: radiance(direction), axes, corner, size, far: vec![f32::NEG_INFINITY; size[0] * size[1]] };
        triangles.iter().for_each(|triangle| depth.draw(*triangle));
        depth
    }

    fn flat(&self, p: DVec3) -> [f64; 2] {
        std::array::from_fn(|k| p.dot(self.axes[k]) * CELLS - self.corner[k])
    }

    /// Every cell whose middle a triangle covers keeps the largest distance.
    fn draw(&mut self, triangle: [DVec3; 3]) {
        let [a, b, c] = triangle.map(|p| self.flat(p));
        let z = triangle.map(|p| p.dot(self.direction));
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area.abs() < 1e-9 {
            return;
        }
        let range = |k: usize| {
            let (low, high) = (a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]));
            (low.floor().max(0.0) as usize)..=(high.ceil() as usize).min(self.size[k] - 1)
        };
        for y in range(1) {
            for x in range(0) {
                let p = [x as f64 + 0.5, y as f64 + 0.5];
                let u = ((p[0] - a[0]) * (c[1] - a[1]) - (p[1] - a[1]) * (c[0] - a[0])) / area;
                let v = ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / area;
                if u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
                    let cell = &mut self.far[y * self.size[0] + x];
                    *cell = cell.max((z[0] + u * (z[1] - z[0]) + v * (z[2] - z[0])) as f32);
                }
            }
        }
    }

    /// 1 where nothing is in the way, 0 in shadow, smooth between: the mean over the four nearest cells.
    fn open(&self, p: DVec3) -> f64 {
        let [x, y] = self.flat(p);
        let (x, y) = (x - 0.5, y - 0.5);
        let (fx, fy) = (x - x.floor(), y - y.floor());
        let here = p.dot(self.direction);
        let lit = |x: f64, y: f64| {
            let inside = x >= 0.0 && y >= 0.0 && (x as usize) < self.size[0] && (y as usize) < self.size[1];
            let blocker = if inside { f64::from(self.far[y as usize * self.size[0] + x as usize]) } else { f64::NEG_INFINITY };
            step(2.0 * BIAS, BIAS, blocker - here)
        };
        let row = |y: f64| lit(x.floor(), y) * (1.0 - fx) + lit(x.floor() + 1.0, y) * fx;
        row(y.floor()) * (1.0 - fy) + row(y.floor() + 1.0) * fy
    }
}
