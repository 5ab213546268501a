//! An avatar's arrays, from tensors that passed their checks.

use super::coding::{self, Coded};
use super::container::Container;
use super::format::AvatarHeader;
use crate::avatar::{Bounds, Gaussians, Inputs, Layer, Matrix, Networks, Rows, Skeleton, Subspace};
use half::f16;

impl AvatarHeader {
    pub fn skeleton(&self, tensors: &Container) -> Skeleton {
        Skeleton {
            name: self.joints.clone(),
            parent: self.parents.clone(),
            rest: tensors.take("skeleton.rest"),
            canonical: tensors.take("skeleton.canonical"),
        }
    }

    pub fn gaussians(&self, tensors: &Container) -> Gaussians {
        Gaussians {
            bounds: Bounds { min: self.bounds[0], max: self.bounds[1] },
            position: tensors.take("position"),
            rotation: self.rotations(tensors),
            log_scale: self.log_scales(tensors),
            color: self.colors(tensors),
            opacity: tensors.take("opacity"),
            joint: tensors.take("joint"),
            joint_weight: self.joint_weights(tensors),
            node: tensors.take("node"),
        }
    }

    fn rotations(&self, tensors: &Container) -> Vec<[f16; 4]> {
        if !self.coded.contains(&Coded::Rotation) {
            return tensors.take("rotation");
        }
        tensors.take("rotation").into_iter().map(coding::rotation).collect()
    }

    fn log_scales(&self, tensors: &Container) -> Vec<[f16; 3]> {
        match self.log_scales {
            None => tensors.take("log_scale"),
            Some(codes) if codes.bits == 8 => {
                tensors.take("log_scale").into_iter().map(|s: [u8; 3]| s.map(|s| codes.decode(s.into()))).collect()
            }
            Some(codes) => tensors.take("log_scale").into_iter().map(|s: [u16; 3]| s.map(|s| codes.decode(s))).collect(),
        }
    }

    fn colors(&self, tensors: &Container) -> Vec<[f16; 3]> {
        if !self.coded.contains(&Coded::Color) {
            return tensors.take("color");
        }
        let mut colors: Vec<[f16; 3]> = tensors.take("color").into_iter().map(|c: [u8; 3]| c.map(coding::color)).collect();
        for (gaussian, color) in tensors.take::<u32>("color.row").into_iter().zip(tensors.take("color.kept")) {
            colors[gaussian as usize] = color;
        }
        colors
    }

    fn joint_weights(&self, tensors: &Container) -> Vec<[u8; 4]> {
        if !self.coded.contains(&Coded::JointWeight) {
            return tensors.take("joint_weight");
        }
        tensors.take("joint_weight").into_iter().map(|[a, b, c]: [u8; 3]| [a, b, c, 255 - a - b - c]).collect()
    }

    pub fn networks(&self, tensors: &Container) -> Networks {
        let bytes = self.coded.contains(&Coded::Networks);
        let layer = |(k, width): (usize, &[usize])| Layer {
            input: width[0],
            output: width[1],
            weight: matrix(&format!("mlp.{k}.weight"), &format!("mlp.{k}.step"), bytes, tensors),
            bias: tensors.take(&format!("mlp.{k}.bias")),
        };
        Networks { activation: self.activation, layers: self.widths.windows(2).enumerate().map(layer).collect() }
    }

    pub fn inputs(&self, tensors: &Container) -> Inputs {
        let space = |name: &str, components: Option<usize>| {
            components.map(|_| Subspace {
                mean: tensors.take(&format!("{name}.mean")),
                component: tensors.take(&format!("{name}.component")),
                sigma: tensors.take(&format!("{name}.sigma")),
            })
        };
        Inputs {
            joint: self.inputs.clone(),
            expression: self.expression,
            pose_space: space("pose_space", self.pose_components),
            expression_space: space("expression_space", self.expression_components),
        }
    }
}

pub fn rows<const C: usize>(name: &str, bytes: bool, tensors: &Container) -> Rows<C> {
    Rows { gaussian: tensors.take(&format!("{name}.row")), basis: basis(name, bytes, tensors) }
}

pub fn basis(name: &str, bytes: bool, tensors: &Container) -> Matrix {
    matrix(&format!("{name}.basis"), &format!("{name}.step"), bytes, tensors)
}

fn matrix(numbers: &str, steps: &str, bytes: bool, tensors: &Container) -> Matrix {
    match bytes {
        true => Matrix::Bytes { codes: tensors.take(numbers), steps: tensors.take(steps) },
        false => Matrix::Halves(tensors.take(numbers)),
    }
}
