//! The box that quantised positions are relative to.

use glam::DVec3;

/// An axis-aligned box whose edges 16-bit coordinates divide into 65,535 steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower corner, metres.
    pub min: [f32; 3],
    /// Upper corner, metres; no component is below `min`'s.
    pub max: [f32; 3],
}

impl Bounds {
    /// The smallest box around points, a thousandth of a millimetre larger on each side so that
    /// rounding to f32 leaves none outside. A box of no size around the origin where there is none.
    pub fn around<'a>(points: impl Iterator<Item = &'a DVec3>) -> Self {
        let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [min, max] = points.fold(empty, |[min, max], &p| [min.min(p), max.max(p)]);
        if !min.is_finite() {
            return Self {
                min: [0.0; 3],
                max: [0.0; 3],
            };
        }
        let outwards = DVec3::splat(1e-6);
        Self {
            min: (min - outwards).as_vec3().to_array(),
            max: (max + outwards).as_vec3().to_array(),
        }
    }

    /// The point that three 16-bit coordinates stand for: `min + q / 65535 · (max − min)`.
    pub fn decode(&self, q: [u16; 3]) -> DVec3 {
        let min = DVec3::from(self.min.map(f64::from));
        let max = DVec3::from(self.max.map(f64::from));
        min + DVec3::from(q.map(f64::from)) / 65535.0 * (max - min)
    }

    /// Distance of neighbouring coordinates along each axis, metres.
    pub fn step(&self) -> DVec3 {
        (DVec3::from(self.max.map(f64::from)) - DVec3::from(self.min.map(f64::from))) / 65535.0
    }

    /// The nearest coordinates to a point; points outside are clamped to the box.
    pub fn encode(&self, p: DVec3) -> [u16; 3] {
        std::array::from_fn(|k| {
            let min = f64::from(self.min[k]);
            let max = f64::from(self.max[k]);
            let t = if max > min {
                (p[k] - min) / (max - min)
            } else {
                0.0
            };
            (t * 65535.0).round().clamp(0.0, 65535.0) as u16
        })
    }
}
