//! Builds an avatar's arrays from tensors that passed their checks.

use super::coding::{self, Coded, LogScaleCodes};
use super::header::AvatarHeader;
use super::sets;
use super::tensors::Tensors;
use crate::avatar::{
    Bounds, Gaussians, Inputs, Level, Matrix, NetworkLayer, Networks, Rows, ShCoefficients,
    Skeleton, Subspace,
};
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

    /// The Gaussians of a set, decoded where they are stored as codes.
    pub fn gaussians(&self, set: usize, tensors: &Tensors) -> Gaussians {
        let name = |name: &str| sets::prefix(set) + name;
        let node = if self.set(set).with_nodes == 0 {
            vec![[0; 3]; self.set(set).gaussians]
        } else {
            tensors.values(&name("node"))
        };
        Gaussians {
            bounds: Bounds {
                min: self.bounds[0],
                max: self.bounds[1],
            },
            position: tensors.values(&name("position")),
            rotation: self.rotations(&name("rotation"), tensors),
            log_scale: log_scales(self.set(set).log_scales, &name("log_scale"), tensors),
            color: self.colors(&name("color"), tensors),
            opacity: tensors.values(&name("opacity")),
            joint: tensors.values(&name("joint")),
            joint_weight: self.joint_weights(&name("joint_weight"), tensors),
            node,
            facing: tensors.values(&name("facing")),
        }
    }

    fn rotations(&self, name: &str, tensors: &Tensors) -> Vec<[f16; 4]> {
        if !self.coded.contains(&Coded::Rotation) {
            return tensors.values(name);
        }
        tensors
            .values(name)
            .into_iter()
            .map(coding::rotation)
            .collect()
    }

    fn colors(&self, name: &str, tensors: &Tensors) -> Vec<[f16; 3]> {
        if let Some(codes) = self.harmonic_codes() {
            return tensors
                .values(name)
                .into_iter()
                .map(|c: [u16; 3]| c.map(|c| codes.decode(c)))
                .collect();
        }
        if !self.coded.contains(&Coded::Color) {
            return tensors.values(name);
        }
        let mut colors: Vec<[f16; 3]> = tensors
            .values(name)
            .into_iter()
            .map(|c: [u8; 3]| c.map(coding::color))
            .collect();
        for (gaussian, color) in tensors
            .values::<u32>(&format!("{name}.row"))
            .into_iter()
            .zip(tensors.values(&format!("{name}.kept")))
        {
            colors[gaussian as usize] = color;
        }
        colors
    }

    fn joint_weights(&self, name: &str, tensors: &Tensors) -> Vec<[u8; 4]> {
        if !self.coded.contains(&Coded::JointWeight) {
            return tensors.values(name);
        }
        tensors
            .values(name)
            .into_iter()
            .map(|[a, b, c]: [u8; 3]| [a, b, c, 255 - a - b - c])
            .collect()
    }

    /// The spherical harmonics of a set.
    pub fn harmonics(&self, set: usize, tensors: &Tensors) -> Option<ShCoefficients> {
        let degree = self.harmonics?.degree;
        let name = sets::prefix(set) + "sh";
        // One by one: they may be most of the file.
        let bytes = tensors.bytes(&name);
        let code = |at: usize| bytemuck::pod_read_unaligned::<u16>(&bytes[2 * at..][..2]);
        let codes = self.harmonic_codes();
        let coefficient = |at| match codes {
            None => f16::from_bits(code(at)),
            Some(codes) => codes.decode(code(at)),
        };
        let gaussians = self.set(set).gaussians;
        Some(coding::from_planes(degree, gaussians, coefficient))
    }

    /// The level of a set that is not the avatar's own.
    pub fn level(&self, set: usize, tensors: &Tensors) -> Level {
        let name = |name: &str| sets::prefix(set) + name;
        let bytes = |what| self.coded.contains(&what);
        let header = &self.levels[set - 1];
        Level {
            gaussians: self.gaussians(set, tensors),
            part_start: tensors.values(&name("part_start")),
            correctives: header.correctives,
            rotation_rows: rows(&name("rotation"), bytes(Coded::RotationBasis), tensors),
            scale_rows: rows(&name("scale"), bytes(Coded::ScaleBasis), tensors),
            color_rows: rows(&name("color"), bytes(Coded::ColorBasis), tensors),
            sh: self.harmonics(set, tensors),
            measured: header.measured.clone(),
        }
    }

    /// The networks.
    pub fn networks(&self, tensors: &Tensors) -> Networks {
        let bytes = self.coded.contains(&Coded::Networks);
        let layer = |k: usize| NetworkLayer {
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

fn log_scales(codes: Option<LogScaleCodes>, name: &str, tensors: &Tensors) -> Vec<[f16; 3]> {
    match codes {
        None => tensors.values(name),
        Some(codes) if codes.bits == 8 => tensors
            .values(name)
            .into_iter()
            .map(|s: [u8; 3]| s.map(|s| codes.decode(s.into())))
            .collect(),
        Some(codes) => tensors
            .values(name)
            .into_iter()
            .map(|s: [u16; 3]| s.map(|s| codes.decode(s)))
            .collect(),
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
