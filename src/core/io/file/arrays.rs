//! Builds an avatar's arrays from tensors that passed their checks.

use super::coding::{self, Coded};
use super::header::AvatarHeader;
use super::tensors::Tensors;
use crate::avatar::{Bounds, Gaussians, Inputs, Layer, Matrix, Networks, Rows, Skeleton, Subspace};
use half::f16;

impl AvatarHeader {
    /// The skeleton.
    pub fn skeleton(&self, tensors: &Tensors) -> Skeleton {
        Skeleton {
            name: self.joints.clone(),
            parent: self.parents.clone(),
            rest: tensors.values("skeleton.rest"),
            canonical: tensors.values("skeleton.canonical"),
        }
    }

    /// The Gaussians, decoded where they are stored as codes.
    pub fn gaussians(&self, tensors: &Tensors) -> Gaussians {
        Gaussians {
            bounds: Bounds {
                min: self.bounds[0],
                max: self.bounds[1],
            },
            position: tensors.values("position"),
            rotation: self.rotations(tensors),
            log_scale: self.log_scales(tensors),
            color: self.colors(tensors),
            opacity: tensors.values("opacity"),
            joint: tensors.values("joint"),
            joint_weight: self.joint_weights(tensors),
            node: tensors.values("node"),
        }
    }

    fn rotations(&self, tensors: &Tensors) -> Vec<[f16; 4]> {
        if !self.coded.contains(&Coded::Rotation) {
            return tensors.values("rotation");
        }
        tensors
            .values("rotation")
            .into_iter()
            .map(coding::rotation)
            .collect()
    }

    fn log_scales(&self, tensors: &Tensors) -> Vec<[f16; 3]> {
        match self.log_scales {
            None => tensors.values("log_scale"),
            Some(codes) if codes.bits == 8 => tensors
                .values("log_scale")
                .into_iter()
                .map(|s: [u8; 3]| s.map(|s| codes.decode(s.into())))
                .collect(),
            Some(codes) => tensors
                .values("log_scale")
                .into_iter()
                .map(|s: [u16; 3]| s.map(|s| codes.decode(s)))
                .collect(),
        }
    }

    fn colors(&self, tensors: &Tensors) -> Vec<[f16; 3]> {
        if !self.coded.contains(&Coded::Color) {
            return tensors.values("color");
        }
        let mut colors: Vec<[f16; 3]> = tensors
            .values("color")
            .into_iter()
            .map(|c: [u8; 3]| c.map(coding::color))
            .collect();
        for (gaussian, color) in tensors
            .values::<u32>("color.row")
            .into_iter()
            .zip(tensors.values("color.kept"))
        {
            colors[gaussian as usize] = color;
        }
        colors
    }

    fn joint_weights(&self, tensors: &Tensors) -> Vec<[u8; 4]> {
        if !self.coded.contains(&Coded::JointWeight) {
            return tensors.values("joint_weight");
        }
        tensors
            .values("joint_weight")
            .into_iter()
            .map(|[a, b, c]: [u8; 3]| [a, b, c, 255 - a - b - c])
            .collect()
    }

    /// The networks.
    pub fn networks(&self, tensors: &Tensors) -> Networks {
        let bytes = self.coded.contains(&Coded::Networks);
        let layer = |k: usize| Layer {
            input: self.widths[k],
            output: self.widths[k + 1],
            weight: matrix(
                &format!("mlp.{k}.weight"),
                &format!("mlp.{k}.step"),
                bytes,
                tensors,
            ),
            bias: tensors.values(&format!("mlp.{k}.bias")),
        };
        Networks {
            activation: self.activation,
            layers: (0..self.layers()).map(layer).collect(),
        }
    }

    /// The networks' inputs.
    pub fn inputs(&self, tensors: &Tensors) -> Inputs {
        let space = |name: &str, components: Option<usize>| {
            components.map(|_| Subspace {
                mean: tensors.values(&format!("{name}.mean")),
                component: tensors.values(&format!("{name}.component")),
                sigma: tensors.values(&format!("{name}.sigma")),
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

/// The basis rows of an attribute; `bytes`: whether they are stored as codes.
pub fn rows<const C: usize>(name: &str, bytes: bool, tensors: &Tensors) -> Rows<C> {
    Rows {
        gaussian: tensors.values(&format!("{name}.row")),
        basis: basis(name, bytes, tensors),
    }
}

/// The basis of an attribute or of nodes; `bytes`: whether it is stored as codes.
pub fn basis(name: &str, bytes: bool, tensors: &Tensors) -> Matrix {
    matrix(
        &format!("{name}.basis"),
        &format!("{name}.step"),
        bytes,
        tensors,
    )
}

fn matrix(numbers: &str, steps: &str, bytes: bool, tensors: &Tensors) -> Matrix {
    if bytes {
        Matrix::Bytes {
            codes: tensors.values(numbers),
            steps: tensors.values(steps),
        }
    } else {
        Matrix::Halves(tensors.values(numbers))
    }
}
