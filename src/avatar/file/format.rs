//! The format of `NAME.avatar` and `NAME.motion`, version 1, in one place: [`AvatarHeader`] and [`ClipHeader`] are the metadata,
//! [`AVATAR`] and [`MOTION`] the tensors. The writer, the reader's checks and `effigy inspect` all follow these tables.
//!
//! Both are [safetensors](https://github.com/huggingface/safetensors) files: the header's length as a 64-bit number, the header as
//! JSON, the tensors. All numbers are little-endian, tensors row-major. Under the key `effigy` the header's metadata has one JSON
//! document with names, counts and scalars. Readers ignore metadata and tensors that they do not know, and reject any other
//! `version`. The header is at most 256 KiB long; [`limits`](crate::avatar::limits) holds for all counts.
//!
//! Symbols: N_g `gaussians`, N_G `parts`, N_s `nodes`, N_B `basis` (a multiple of 4), J the number of `joints`, F `frames`.

use super::check::{self, Bad, Element};
use super::container::Container;
use super::{Fault, header::subspace};
use crate::avatar::{Activation, Avatar, Clip};
use half::f16;
use safetensors::Dtype;
use serde::{Deserialize, Serialize, de::DeserializeOwned};

/// Where in the header's metadata the document is.
pub const METADATA_KEY: &str = "effigy";
/// The version that is written, and the only one read.
pub const VERSION: u64 = 1;
/// `format` of an avatar file.
pub const AVATAR_FORMAT: &str = "effigy.avatar";
/// `format` of a motion file.
pub const MOTION_FORMAT: &str = "effigy.motion";

/// The document of an avatar file.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AvatarHeader {
    /// "effigy.avatar"
    pub format: String,
    pub version: u64,
    pub name: String,
    /// Source and licence, free text.
    #[serde(default)]
    pub credit: String,
    /// "metre": of every length.
    pub units: String,
    /// "y": the axis that points up; the avatar faces +z.
    pub up: String,
    /// "srgb": colours are display-referred, sRGB-encoded, and blended so.
    pub color_space: String,
    pub gaussians: usize,
    pub parts: usize,
    /// The first this many parts see the expression.
    pub head_parts: usize,
    pub nodes: usize,
    pub basis: usize,
    /// Gaussians that keep a corrective of their rotation, scale and colour.
    pub rotation_rows: usize,
    pub scale_rows: usize,
    pub color_rows: usize,
    /// Lower and upper corner of the box that positions are coordinates in: `min + q / 65535 · (max − min)`.
    pub bounds: [[f32; 3]; 2],
    /// "relu" or "leaky_relu" (slope 0.01), after every layer but the last.
    pub activation: Activation,
    /// Widths of the networks: input, hidden layers (multiples of 4), output (N_B or 2 N_B).
    pub widths: Vec<usize>,
    /// Names of the joints, all different.
    pub joints: Vec<String>,
    /// Parent of each joint, which stands before it; null for joint 0 alone.
    pub parents: Vec<Option<u8>>,
    /// Joints whose rotations enter the networks, in this order; 3 numbers each.
    pub inputs: Vec<u8>,
    /// Length of the expression, which enters after them.
    pub expression: usize,
    /// Principal components of the pose and of the expression; absent or null without such a space.
    pub pose_components: Option<usize>,
    pub expression_components: Option<usize>,
}

/// The document of a motion file.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ClipHeader {
    /// "effigy.motion"
    pub format: String,
    pub version: u64,
    pub name: String,
    /// Source and licence, free text.
    #[serde(default)]
    pub credit: String,
    /// "metre": of the translation.
    pub units: String,
    /// "y"
    pub up: String,
    /// Frames a second.
    pub rate: f64,
    pub frames: usize,
    /// Names of the joints, all different.
    pub joints: Vec<String>,
    /// Length of the expression.
    pub expression: usize,
}

/// A kind of file: the document in its header, and what it says of the tensors.
pub trait Document: Serialize + DeserializeOwned + 'static {
    type Model;
    const FORMAT: &'static str;
    const TENSORS: &'static [Tensor<Self, Self::Model>];
    /// The document of a model.
    fn of(model: &Self::Model) -> Self;
    /// Holds the document itself against the format; the tensors' shapes follow from what passes.
    fn check(&self) -> Result<(), Fault>;
    /// The model, from tensors that passed their checks.
    fn build(self, tensors: &Container) -> Self::Model;
}

/// A row of a table: a tensor, or several of a kind.
pub struct Tensor<H, M> {
    /// `#` stands for the number of a layer.
    pub name: &'static str,
    pub dtype: Dtype,
    /// How many there are: 1, one a layer, or none where the avatar has no such thing.
    pub count: fn(&H) -> usize,
    pub shape: fn(&H, usize) -> Vec<usize>,
    /// Checks the numbers.
    pub rule: fn(&H, &[u8]) -> Result<(), Bad>,
    pub bytes: fn(&M, usize) -> &[u8],
    /// What the numbers are.
    pub what: &'static str,
}

impl<H, M> Tensor<H, M> {
    /// The k-th tensor's name.
    pub fn name(&self, k: usize) -> String {
        self.name.replace('#', &k.to_string())
    }
}

/// Rows of the form `name: type [shape] rule(limits) = array, meaning;`, in groups headed by how many of each there are.
macro_rules! table {
    ($h:ident: $header:ty, $m:ident: $model:ty, $k:ident;
     $($count:expr => { $($name:literal: $type:ty [$($dim:expr),*] $rule:ident($($limit:expr),*) = $data:expr, $what:literal;)* })*) => {
        &[$($(Tensor {
            name: $name,
            dtype: <$type as Element>::DTYPE,
            count: |$h: &$header| { let _ = $h; $count },
            shape: |$h: &$header, $k: usize| { let _ = ($h, $k); vec![$($dim),*] },
            rule: |$h: &$header, bytes: &[u8]| { let _ = $h; check::$rule::<$type>(bytes $(, $limit)*) },
            bytes: |$m: &$model, $k: usize| { let _ = $k; bytemuck::cast_slice(&$data[..]) },
            what: $what,
        },)*)*]
    };
}

/// The tensors of an avatar file. After `=` stands the array that a tensor is read into.
pub const AVATAR: &[Tensor<AvatarHeader, Avatar>] = table! { h: AvatarHeader, a: Avatar, k;
    1 => {
        "position":       u16 [h.gaussians, 3] any() = a.gaussians.position, "coordinates in the bounds, canonical pose";
        "rotation":       f16 [h.gaussians, 4] quaternion() = a.gaussians.rotation, "quaternion w x y z, any length but 0";
        "log_scale":      f16 [h.gaussians, 3] finite() = a.gaussians.log_scale, "ln of the standard deviations, metres";
        "color":          f16 [h.gaussians, 3] finite() = a.gaussians.color, "red, green, blue, 0 to 1";
        "opacity":        u8 [h.gaussians] any() = a.gaussians.opacity, "255 is opaque";
        "joint":          u8 [h.gaussians, 4] below(h.joints.len()) = a.gaussians.joint, "the joints that move a Gaussian";
        "joint_weight":   u8 [h.gaussians, 4] weights() = a.gaussians.joint_weight, "their weights, which sum to 255";
        "node":           u16 [h.gaussians, 3] below(h.nodes) = a.gaussians.node, "the nearest nodes";
        "part_start":     u32 [h.parts + 1] starts(h.gaussians) = a.parts.start, "part i is Gaussians start[i] to start[i + 1]";
        "rotation.row":   u32 [h.rotation_rows] rising(h.gaussians) = a.rotation_rows.gaussian, "the Gaussian of each row";
        "rotation.basis": f16 [h.rotation_rows, 4, h.basis] finite() = a.rotation_rows.basis, "quaternion a unit of feature";
        "scale.row":      u32 [h.scale_rows] rising(h.gaussians) = a.scale_rows.gaussian, "the Gaussian of each row";
        "scale.basis":    f16 [h.scale_rows, 3, h.basis] finite() = a.scale_rows.basis, "log scale a unit of feature";
        "color.row":      u32 [h.color_rows] rising(h.gaussians) = a.color_rows.gaussian, "the Gaussian of each row";
        "color.basis":    f16 [h.color_rows, 3, h.basis] finite() = a.color_rows.basis, "colour a unit of feature";
        "node.position":  u16 [h.nodes, 3] any() = a.nodes.position, "coordinates in the bounds, canonical pose";
        "node.part":      u16 [h.nodes] below(h.parts) = a.nodes.part, "the part whose features move the node";
        "node.offset":    f16 [h.nodes, 3] length() = a.nodes.offset, "displacement that no pose changes, metres";
        "node.basis":     f16 [h.nodes, 3, h.basis] finite() = a.nodes.basis, "metres a unit of feature";
        "skeleton.rest":  f32 [h.joints.len(), 3] length() = a.skeleton.rest, "joints in the rest pose, metres";
        "skeleton.canonical": f32 [h.joints.len(), 3] finite() = a.skeleton.canonical, "the canonical pose, axis-angle, radians";
    }
    h.widths.len().saturating_sub(1) => {
        "mlp.#.weight": f16 [h.parts, h.widths[k + 1], h.widths[k]] finite() = a.networks.layers[k].weight, "a layer of every part";
        "mlp.#.bias":   f16 [h.parts, h.widths[k + 1]] finite() = a.networks.layers[k].bias, "its biases";
    }
    usize::from(h.pose_components.is_some()) => {
        "pose_space.mean":      f32 [h.pose_len()] finite() = subspace(&a.inputs.pose_space).mean, "mean of the training poses";
        "pose_space.component": f32 [h.pose_components.unwrap_or(0), h.pose_len()] orthonormal(h.pose_len())
            = subspace(&a.inputs.pose_space).component, "their principal components";
        "pose_space.sigma":     f32 [h.pose_components.unwrap_or(0)] deviation()
            = subspace(&a.inputs.pose_space).sigma, "standard deviation along each";
    }
    usize::from(h.expression_components.is_some()) => {
        "expression_space.mean": f32 [h.expression] finite() = subspace(&a.inputs.expression_space).mean, "mean of the expressions";
        "expression_space.component": f32 [h.expression_components.unwrap_or(0), h.expression] orthonormal(h.expression)
            = subspace(&a.inputs.expression_space).component, "their principal components";
        "expression_space.sigma": f32 [h.expression_components.unwrap_or(0)] deviation()
            = subspace(&a.inputs.expression_space).sigma, "standard deviation along each";
    }
};

/// The tensors of a motion file.
pub const MOTION: &[Tensor<ClipHeader, Clip>] = table! { h: ClipHeader, c: Clip, k;
    1 => {
        "rotation":    f32 [h.frames, h.joints.len(), 3] finite() = c.rotation, "axis-angle relative to the parent, radians";
        "translation": f32 [h.frames, 3] length() = c.translation, "of the root from its rest position, metres";
        "expression":  f32 [h.frames, h.expression] finite() = c.expression, "expression coefficients";
    }
};
