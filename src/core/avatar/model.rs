//! The arrays of an avatar.

use super::{Bounds, FacingCode, Filter, Inputs, Matrix, Skeleton, harmonics::functions_of};
use glam::DVec3;
use half::f16;

/// A trained or baked avatar: what `NAME.avatar` holds. Lengths are metres, y is up, the avatar
/// faces +z.
#[derive(Clone, Debug, PartialEq)]
pub struct Avatar {
    /// Name of the avatar, for users.
    pub name: String,
    /// Where it comes from and on what terms it may be used; free text, may be empty.
    pub credit: String,
    /// The joints.
    pub skeleton: Skeleton,
    /// The neutral Gaussians.
    pub gaussians: Gaussians,
    /// The parts that the Gaussians belong to.
    pub parts: Parts,
    /// One network a part, from pose and expression to features.
    pub networks: Networks,
    /// Correctives of the quaternion, w x y z.
    pub rotation_rows: Rows<4>,
    /// Correctives of the log scale.
    pub scale_rows: Rows<3>,
    /// Correctives of the colour.
    pub color_rows: Rows<3>,
    /// The nodes that carry position correctives.
    pub nodes: Nodes,
    /// How a pose becomes the networks' input.
    pub inputs: Inputs,
    /// How colours change with the viewing direction; None where they don't. Baked and trained
    /// avatars have none.
    pub sh: Option<ShCoefficients>,
    /// The low-pass that it was learned with.
    pub filter: Filter,
    /// Smaller sets of Gaussians for small images, each with fewer than the one before. May be
    /// empty.
    pub levels: Vec<Level>,
}

/// The neutral attributes, one entry a Gaussian, in the canonical pose. Ordered by part.
#[derive(Clone, Debug, PartialEq)]
pub struct Gaussians {
    /// The box that `position` and [`Nodes::position`] are coordinates in.
    pub bounds: Bounds,
    /// Coordinates in `bounds`, canonical pose.
    pub position: Vec<[u16; 3]>,
    /// Quaternion w x y z, of any length but zero: normalised after its corrective is added.
    pub rotation: Vec<[f16; 4]>,
    /// Natural logarithm of the standard deviation along each axis, metres.
    pub log_scale: Vec<[f16; 3]>,
    /// Display-referred RGB (sRGB-encoded), 0 to 1. Blending happens in this space, as 3DGS
    /// training does.
    pub color: Vec<[f16; 3]>,
    /// 255 is opaque.
    pub opacity: Vec<u8>,
    /// The four joints that move a Gaussian.
    pub joint: Vec<[u8; 4]>,
    /// Their weights; the four sum to 255.
    pub joint_weight: Vec<[u8; 4]>,
    /// The three nearest nodes.
    pub node: Vec<[u16; 3]>,
    /// From where each is drawn; empty: from everywhere. The avatar's own have it if the levels'
    /// have.
    pub facing: Vec<FacingCode>,
}

impl Gaussians {
    /// Number of Gaussians, N_g.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// The Gaussians of these indices, in their order.
    ///
    /// # Panics
    /// When an index is not below their number.
    pub fn pick(&self, gaussians: &[usize]) -> Self {
        fn pick<T: Copy>(all: &[T], gaussians: &[usize]) -> Vec<T> {
            gaussians.iter().map(|&at| all[at]).collect()
        }
        Self {
            bounds: self.bounds,
            position: pick(&self.position, gaussians),
            rotation: pick(&self.rotation, gaussians),
            log_scale: pick(&self.log_scale, gaussians),
            color: pick(&self.color, gaussians),
            opacity: pick(&self.opacity, gaussians),
            joint: pick(&self.joint, gaussians),
            joint_weight: pick(&self.joint_weight, gaussians),
            node: pick(&self.node, gaussians),
            facing: if self.facing.is_empty() {
                vec![]
            } else {
                pick(&self.facing, gaussians)
            },
        }
    }
}

/// View-dependent colour of 3DGS: real spherical harmonics of the direction from the camera
/// to the Gaussian, in canonical space. They are added to the neutral colour before its corrective,
/// and the sum is clamped to 0 from below; like every colour it is clamped to 1 before blending,
/// which 3DGS does not do.
#[derive(Clone, Debug, PartialEq)]
pub struct ShCoefficients {
    /// 1, 2 or 3; the functions of degree 0 are [`Gaussians::color`].
    pub degree: usize,
    /// RGB of each function from degree 1 up, in 3DGS's order and with its signs; shape N_g,
    /// (degree + 1)² − 1.
    pub coefficients: Vec<[f16; 3]>,
}

impl ShCoefficients {
    /// The function of degree 0, √(1 / 4π): a colour is 0.5 + this · `f_dc`.
    pub const CONSTANT: f64 = 0.282_094_791_773_878_14;

    /// Those of the Gaussians of these indices, in their order.
    ///
    /// # Panics
    /// When an index is not below their number.
    pub fn pick(&self, gaussians: &[usize]) -> Self {
        let row = |&at: &usize| &self.coefficients[at * self.functions()..][..self.functions()];
        Self {
            degree: self.degree,
            coefficients: gaussians.iter().flat_map(row).copied().collect(),
        }
    }

    /// Functions from degree 1 up: coefficients of a Gaussian, each an RGB triple.
    pub fn functions(&self) -> usize {
        functions_of(self.degree)
    }
}

/// A level of detail: a smaller set of Gaussians that represents all of an avatar's where it is
/// small in the image.
///
/// Its Gaussians are merged from the avatar's own, within parts and in canonical space, and fitted
/// to supersampled images of the whole avatar. They move with the same skeleton, and either with
/// the same networks and nodes or without any.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// The Gaussians, ordered by part, in the avatar's bounds.
    pub gaussians: Gaussians,
    /// Part i is Gaussians `part_start[i]..part_start[i + 1]`, like [`Parts::start`]; as many parts
    /// as the avatar has, some of which may be empty.
    pub part_start: Vec<u32>,
    /// Whether networks move it: its Gaussians follow the nodes and may have rows. Where they
    /// don't, the mean of what the networks add is part of the Gaussians, there are no rows, and no
    /// network needs to run.
    pub correctives: bool,
    /// Correctives of the quaternion, w x y z; rows are of this level's Gaussians.
    pub rotation_rows: Rows<4>,
    /// Correctives of the log scale.
    pub scale_rows: Rows<3>,
    /// Correctives of the colour.
    pub color_rows: Rows<3>,
    /// How colours change with the viewing direction; None where the avatar's don't.
    pub sh: Option<ShCoefficients>,
    /// Errors of images of this level, by the avatar's size in them. Heights rise, and of equal
    /// heights samples do.
    pub measured: Vec<LevelError>,
}

/// The error of images that draw a level at one size, against images of the whole avatar drawn at
/// 8 times that size or more and averaged. Over several views, in poses that the level was not
/// fitted to.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct LevelError {
    /// Height of the avatar in its canonical pose in the image, px.
    pub height: f64,
    /// Samples a pixel along each axis: the level was drawn at this many times the size, and
    /// averaged.
    pub samples: u32,
    /// PSNR of premultiplied RGB and coverage over the pixels that the avatar covers, dB; the mean
    /// over images.
    pub psnr_db: f64,
    /// Relative error of the mean over all images of the channel where it is largest: above 0 where
    /// the level is too light.
    pub color: f64,
    /// Relative error of the mean coverage over all images: above 0 where the level covers too
    /// much.
    pub coverage: f64,
}

/// Which Gaussians belong to which part, and which parts see the expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Parts {
    /// Part i is Gaussians `start[i]..start[i + 1]`: N_G + 1 entries, from 0 to N_g, never falling.
    pub start: Vec<u32>,
    /// Parts before this one are head parts: the expression enters their networks, and is zero for
    /// the others.
    pub head: usize,
}

impl Parts {
    /// The part that a Gaussian belongs to: the last that starts at or before it.
    pub fn part_of(&self, gaussian: usize) -> usize {
        self.start
            .partition_point(|&start| start as usize <= gaussian)
            - 1
    }

    /// The Gaussians of a part.
    pub fn gaussians(&self, part: usize) -> std::ops::Range<usize> {
        self.start[part] as usize..self.start[part + 1] as usize
    }

    /// Number of parts, N_G.
    pub fn len(&self) -> usize {
        self.start.len() - 1
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The nonlinearity after every layer of a network except the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Activation {
    /// max(0, x)
    Relu,
    /// max(0.01 x, x): see [`crate::constants::LEAKY_SLOPE`].
    LeakyRelu,
}

/// One small network a part: pose and expression in, feature vector e out. All parts have the same
/// widths.
#[derive(Clone, Debug, PartialEq)]
pub struct Networks {
    /// The nonlinearity of the hidden layers.
    pub activation: Activation,
    /// The layers, from the input on.
    pub layers: Vec<NetworkLayer>,
}

impl Networks {
    /// Length of the feature vector e: N_B, or 2 N_B where nodes have features of their own.
    pub fn output(&self) -> usize {
        self.layers.last().map_or(0, |layer| layer.output)
    }

    /// Numbers that enter the first layer, then those that leave each layer.
    pub fn widths(&self) -> Vec<usize> {
        let first = self.layers.first().map(|layer| layer.input);
        let outputs = self.layers.iter().map(|layer| layer.output);
        first.into_iter().chain(outputs).collect()
    }

    /// Whether all weights are bytes.
    pub fn in_bytes(&self) -> bool {
        !self.layers.is_empty() && self.layers.iter().all(|layer| layer.weight.is_bytes())
    }
}

/// A linear layer of all N_G networks.
#[derive(Clone, Debug, PartialEq)]
pub struct NetworkLayer {
    /// Numbers that enter a neuron.
    pub input: usize,
    /// Neurons.
    pub output: usize,
    /// Shape N_G, output, input; where it is bytes, a neuron has a step.
    pub weight: Matrix,
    /// Shape N_G, output.
    pub bias: Vec<f16>,
}

/// Numbers a Gaussian of rotation, log scale and colour, the attributes that have [`Rows`].
pub const ROW_COMPONENTS: [usize; 3] = [4, 3, 3];

/// The basis rows of one attribute with C components, stored only for the Gaussians that pruning
/// retained.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows<const C: usize> {
    /// The Gaussian of each row, strictly rising.
    pub gaussian: Vec<u32>,
    /// Shape rows, C, N_B; where it is bytes, a row has a step.
    pub basis: Matrix,
}

/// Points that carry the position correctives; Gaussians interpolate the three nearest.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// In the canonical pose, coordinates in [`Gaussians::bounds`].
    pub position: Vec<[u16; 3]>,
    /// The part whose features move the node.
    pub part: Vec<u16>,
    /// Learned displacement that no pose changes, metres.
    pub offset: Vec<[f16; 3]>,
    /// Shape N_s, 3, N_B; metres a unit of feature. Where it is bytes, a node has a step.
    pub basis: Matrix,
}

impl Nodes {
    /// One node that moves nothing, since every Gaussian must name three: for avatars that have no
    /// position correctives.
    pub fn still() -> Self {
        Self {
            position: vec![[0; 3]],
            part: vec![0],
            offset: vec![[f16::ZERO; 3]],
            basis: Matrix::default(),
        }
    }

    /// Number of nodes, N_s.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }
}

impl Avatar {
    /// N_B. The feature vector is either this long or twice as long.
    pub fn basis_len(&self) -> usize {
        if self.nodes.is_empty() {
            0
        } else {
            self.nodes.basis.len() / (3 * self.nodes.len())
        }
    }

    /// Whether nothing moves inside it: it has one joint and no networks, like an import from a
    /// `.ply`.
    pub fn is_static(&self) -> bool {
        self.skeleton.len() == 1 && self.networks.layers.is_empty()
    }

    /// Where in e the nodes' features begin: 0 when attributes and nodes share them, N_B when each
    /// has its own half.
    pub fn node_feature_start(&self) -> usize {
        self.networks.output() - self.basis_len()
    }

    /// x₀ of a Gaussian: canonical pose, metres.
    pub fn position(&self, gaussian: usize) -> DVec3 {
        self.gaussians
            .bounds
            .decode(self.gaussians.position[gaussian])
    }

    /// x of a Gaussian where no network moves its nodes: x₀ and their static displacements.
    pub fn placed(&self, gaussian: usize) -> DVec3 {
        let nodes = self.gaussians.node[gaussian];
        let offset = |node: u16| DVec3::from(self.nodes.offset[usize::from(node)].map(f64::from));
        let moved = if nodes == [nodes[0]; 3] {
            offset(nodes[0])
        } else {
            let weights = self.node_weights(gaussian);
            nodes
                .iter()
                .zip(weights)
                .map(|(&node, weight)| weight * offset(node))
                .sum()
        };
        self.position(gaussian) + moved
    }

    /// x_s of a node: canonical pose, metres.
    pub fn node_position(&self, node: usize) -> DVec3 {
        self.gaussians.bounds.decode(self.nodes.position[node])
    }

    /// Weights of a Gaussian's three nodes: 1 / max(‖x₀ − x_s‖, 1e-6), scaled to a sum of 1.
    pub fn node_weights(&self, gaussian: usize) -> [f64; 3] {
        let position = self.position(gaussian);
        let alpha = self.gaussians.node[gaussian]
            .map(|s| 1.0 / position.distance(self.node_position(s as usize)).max(1e-6));
        alpha.map(|a| a / alpha.iter().sum::<f64>())
    }
}
