//! The avatar of splats: static, with one joint, which rotates the file's axes to ours. Gaussians
//! come in the order of a space-filling curve, so that neighbours in memory are neighbours in space.

use super::{Splats, functions_of};
use crate::each;
use crate::{
    avatar::{
        Activation, Avatar, Bounds, Filter, Gaussians, Inputs, Networks, Nodes, Parts, Rows,
        ShCoefficients, Skeleton,
    },
    constants::F16_MAX,
    io::file::FormatError,
};
use glam::DVec3;
use half::f16;

/// Log scales are clamped to ±this: from nanometres to more than any scene.
const LOG_SCALE_LIMIT: f64 = 20.0;

/// A converted Gaussian, except its position.
struct Converted {
    rotation: [f16; 4],
    log_scale: [f16; 3],
    color: [f16; 3],
    opacity: u8,
}

impl Splats {
    /// Converts to an avatar of that name. The canonical space is the file's own, so that spherical
    /// harmonics keep their directions. Numbers are stored as in every avatar: positions as 16-bit
    /// coordinates in the Gaussians' box, opacity in 8 bits, all else in f16.
    ///
    /// # Errors
    /// When the splats break a rule of [`Self::check`].
    pub fn to_avatar(&self, name: &str) -> Result<Avatar, FormatError> {
        self.check()?;
        let (gaussians, sh) = self.gaussians();
        let canonical = self.up.rotation().inverse().to_scaled_axis();
        let canonical = canonical.as_vec3().to_array();
        Ok(scene(name, canonical, gaussians, sh, self.filter))
    }

    /// The Gaussians; the spherical harmonics are None if there are none above degree 0.
    fn gaussians(&self) -> (Gaussians, Option<ShCoefficients>) {
        let count = self.len();
        let bounds = bounds(&self.position);
        let code = |k: usize| Place {
            code: morton(bounds.encode(point(self.position[k]))),
            splat: k as u32,
        };
        let mut order = each::map(count, code);
        order.sort_unstable();
        let converted = each::map(count, |k| self.convert(order[k].splat as usize));
        let encode = |k: usize| bounds.encode(point(self.position[order[k].splat as usize]));
        let gaussians = Gaussians {
            bounds,
            position: each::map(count, encode),
            rotation: converted.iter().map(|gaussian| gaussian.rotation).collect(),
            log_scale: converted
                .iter()
                .map(|gaussian| gaussian.log_scale)
                .collect(),
            color: converted.iter().map(|gaussian| gaussian.color).collect(),
            opacity: converted.iter().map(|gaussian| gaussian.opacity).collect(),
            ..Gaussians::of_one_joint(count)
        };
        warn_of_coarse_steps(&gaussians);
        let functions = functions_of(self.degree);
        let coefficient = |k: usize| {
            let row = functions * order[k / functions].splat as usize;
            self.harmonics[row + k % functions].map(|c| half(c.into()))
        };
        let sh = (functions > 0).then(|| ShCoefficients {
            degree: self.degree,
            coefficients: each::map(functions * count, coefficient),
        });
        (gaussians, sh)
    }

    fn convert(&self, k: usize) -> Converted {
        let rotation = self.rotation[k].map(f64::from);
        let length = rotation.iter().map(|v| v * v).sum::<f64>().sqrt();
        let scale = self.log_scale[k].map(f64::from);
        let color = self.color[k].map(f64::from);
        Converted {
            rotation: rotation.map(|v| half(v / length)),
            log_scale: scale.map(|s| half(s.clamp(-LOG_SCALE_LIMIT, LOG_SCALE_LIMIT))),
            color: color.map(|c| half(0.5 + ShCoefficients::CONSTANT * c)),
            opacity: (255.0 / (1.0 + (-f64::from(self.opacity[k])).exp())).round() as u8,
        }
    }
}

/// A Gaussian's place on the curve, and its index in the file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    code: u64,
    splat: u32,
}

/// The avatar of splats. `canonical`: the axis-angle rotation of its canonical pose, radians.
pub fn scene(
    name: &str,
    canonical: [f32; 3],
    gaussians: Gaussians,
    sh: Option<ShCoefficients>,
    filter: Filter,
) -> Avatar {
    Avatar {
        name: name.into(),
        credit: String::new(),
        skeleton: Skeleton {
            name: vec!["root".into()],
            parent: vec![None],
            rest: vec![[0.0; 3]],
            canonical: vec![canonical],
        },
        parts: Parts {
            start: vec![0, gaussians.len() as u32],
            head: 0,
        },
        networks: Networks {
            activation: Activation::Relu,
            layers: vec![],
        },
        rotation_rows: Rows::default(),
        scale_rows: Rows::default(),
        color_rows: Rows::default(),
        nodes: Nodes::still(),
        inputs: Inputs::none(),
        gaussians,
        sh,
        filter,
        levels: vec![],
    }
}

impl Gaussians {
    /// Of `count` Gaussians what follows from a skeleton of one joint. The other arrays are empty.
    pub(super) fn of_one_joint(count: usize) -> Self {
        Self {
            bounds: Bounds {
                min: [0.0; 3],
                max: [0.0; 3],
            },
            position: vec![],
            rotation: vec![],
            log_scale: vec![],
            color: vec![],
            opacity: vec![],
            joint: vec![[0; 4]; count],
            joint_weight: vec![[255, 0, 0, 0]; count],
            node: vec![[0; 3]; count],
        }
    }
}

fn point(position: [f32; 3]) -> DVec3 {
    DVec3::from(position.map(f64::from))
}

/// The box around all positions; there is at least one.
fn bounds(positions: &[[f32; 3]]) -> Bounds {
    let mut bounds = Bounds {
        min: [f32::INFINITY; 3],
        max: [f32::NEG_INFINITY; 3],
    };
    for position in positions {
        for (axis, &value) in position.iter().enumerate() {
            bounds.min[axis] = bounds.min[axis].min(value);
            bounds.max[axis] = bounds.max[axis].max(value);
        }
    }
    bounds
}

/// Index along a Morton curve: the interleaved bits of the three coordinates.
fn morton(q: [u16; 3]) -> u64 {
    (0..16)
        .flat_map(|bit| (0..3).map(move |axis| (bit, axis)))
        .fold(0, |code, (bit, axis)| {
            code | u64::from(q[axis] >> bit & 1) << (3 * bit + axis)
        })
}

/// Rounds to f16; numbers beyond its range are clamped.
fn half(value: f64) -> f16 {
    f16::from_f64(value.clamp(-F16_MAX, F16_MAX))
}

/// Warns if positions are rounded to more than half of most Gaussians' diameter.
fn warn_of_coarse_steps(gaussians: &Gaussians) {
    let step = gaussians.bounds.step().max_element();
    let mut thin: Vec<f16> = gaussians
        .log_scale
        .iter()
        .map(|s| s[0].min(s[1]).min(s[2]))
        .collect();
    let middle = thin.len() / 2;
    let (_, median, _) = thin.select_nth_unstable_by(middle, f16::total_cmp);
    let median = median.to_f64().exp();
    if step > 0.5 * median {
        tracing::warn!(
            "positions are rounded to {:.2} mm, while the median Gaussian's thinnest axis measures {:.2} mm: a few far-off Gaussians may \
             stretch the box that positions are kept in; cut them off for an exact image",
            1e3 * step,
            1e3 * median
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_of_the_coordinates_take_turns() {
        assert_eq!(morton([1, 0, 0]), 1);
        assert_eq!(morton([0, 0b11, 0]), 0b010_010);
        assert_eq!(morton([0, 0, 1 << 15]), 1 << 47);
        assert_eq!(morton([u16::MAX; 3]), (1 << 48) - 1);
    }
}
