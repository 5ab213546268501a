//! The avatar of splats: static, with one joint, which rotates the file's axes to ours. Gaussians
//! come in the order of a space-filling curve, so that neighbours in memory are neighbours in
//! space.

use super::{
    Splats,
    cells::{CellPosition, Cells},
    functions_of,
};
use crate::each;
use crate::{
    avatar::{
        Activation, Avatar, Bounds, Filter, Gaussians, Inputs, Matrix, Networks, Nodes, Parts,
        Rows, ShCoefficients, Skeleton,
    },
    constants::F16_MAX,
    io::file::FormatError,
};
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
    /// coordinates in a box, which nodes displace where one box would be too coarse for all;
    /// opacity in 8 bits, all else in f16.
    ///
    /// # Errors
    /// When the splats break a rule of [`Self::check`].
    pub fn to_avatar(&self, name: &str) -> Result<Avatar, FormatError> {
        self.check()?;
        let (gaussians, nodes, sh) = self.gaussians();
        let canonical = self.up.rotation().inverse().to_scaled_axis();
        let canonical = canonical.as_vec3().to_array();
        Ok(scene(name, canonical, gaussians, nodes, sh, self.filter))
    }

    /// The Gaussians and the nodes that displace them; the spherical harmonics are None if there
    /// are none above degree 0.
    fn gaussians(&self) -> (Gaussians, Nodes, Option<ShCoefficients>) {
        let count = self.len();
        let cells = Cells::new(self);
        let mut order: Vec<CurvePlace> = each::map(count, |k| {
            let place = cells.place(self.position[k]);
            CurvePlace {
                cell: morton(place.cell()),
                code: morton(place.code),
                splat: k as u32,
                place,
            }
        });
        order.sort_unstable_by_key(|own| (own.cell, own.code, own.splat));
        let mut offset = vec![];
        let mut node = Vec::with_capacity(count);
        for (k, own) in order.iter().enumerate() {
            if k == 0 || order[k - 1].cell != own.cell {
                offset.push(own.place.offset);
            }
            node.push([(offset.len() - 1) as u16; 3]);
        }
        let splat = |k: usize| order[k].splat as usize;
        let converted = each::map(count, |k| self.convert(splat(k)));
        let gaussians = Gaussians {
            bounds: cells.bounds(),
            position: order.iter().map(|own| own.place.code).collect(),
            rotation: converted.iter().map(|gaussian| gaussian.rotation).collect(),
            log_scale: converted
                .iter()
                .map(|gaussian| gaussian.log_scale)
                .collect(),
            color: converted.iter().map(|gaussian| gaussian.color).collect(),
            opacity: converted.iter().map(|gaussian| gaussian.opacity).collect(),
            node,
            ..Gaussians::of_one_joint(count)
        };
        let functions = functions_of(self.degree);
        let coefficient = |k: usize| {
            let row = functions * splat(k / functions);
            self.harmonics[row + k % functions].map(|c| half(c.into()))
        };
        let sh = (functions > 0).then(|| ShCoefficients {
            degree: self.degree,
            coefficients: each::map(functions * count, coefficient),
        });
        (gaussians, nodes(offset), sh)
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

/// A Gaussian's position along the curve, that of its cell first, and its index in the file.
struct CurvePlace {
    cell: u64,
    code: u64,
    splat: u32,
    place: CellPosition,
}

/// Nodes that displace what follows them, and that nothing moves.
pub fn nodes(offset: Vec<[f16; 3]>) -> Nodes {
    Nodes {
        position: vec![[0; 3]; offset.len()],
        part: vec![0; offset.len()],
        offset,
        basis: Matrix::default(),
    }
}

/// The avatar of splats. `canonical`: the axis-angle rotation of its canonical pose, radians.
pub fn scene(
    name: &str,
    canonical: [f32; 3],
    gaussians: Gaussians,
    nodes: Nodes,
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
        nodes,
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
            facing: vec![],
        }
    }
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
