//! The format of `NAME.avatar`, versions 1 to 5, and `NAME.motion`, version 1, in one place:
//! [`AvatarHeader`] and [`ClipHeader`] are the metadata, [`AVATAR`] and [`MOTION`] the tensors. The
//! writer, the reader's checks and `effigy inspect` all follow these tables.
//!
//! Both are [safetensors](https://github.com/huggingface/safetensors) files: the header's length as
//! a 64-bit number, the header as JSON, the tensors. All numbers are little-endian, tensors
//! row-major. Under the key `effigy` the header's metadata has one JSON document with names, counts
//! and scalars. Readers ignore metadata and tensors that they do not know, and reject any other
//! `version`. The header is at most 256 KiB long; [`limits`](crate::avatar::limits) holds for all
//! counts.
//!
//! Version 2 of an avatar file is version 1 with some numbers in fewer bits, which `coded` and
//! `log_scales` name and the tables below have as alternatives of one name, and with some tensors
//! deflated, which `deflated` names: such a tensor is of type U8, in the file of one dimension, and
//! holds a zlib stream of its bytes, arranged as [`ByteArrangement`] says. All tensors together are
//! at most `EXPANSION` times as long as what the file has of them.
//!
//! Version 3 is version 2 with a `filter`, the low-pass that the avatar was learned with, in which
//! a program that does not know the field would draw it wrongly.
//!
//! Version 4 is version 3 with `harmonics`, colours that depend on the view, or without networks: a
//! scene of splats has the first and lacks the second.
//!
//! Version 5 is version 4 with a `facing`, directions from which Gaussians are drawn.
//!
//! Symbols: N_g `gaussians`, N_G `parts`, N_s `nodes`, N_B `basis` (a multiple of 4), J the number
//! of `joints`, F `frames`.

use super::check::{self, TensorElement};
use super::coding::{self, StoredBytes, codes, halves, steps};
use super::document::TensorRow;
use super::sets::SetArrays;
use crate::avatar::{Avatar, Clip, Subspace};
use half::f16;

pub use super::coding::{Coded, HarmonicCodes, LogScaleCodes};
pub use super::deflate::ByteArrangement;
pub use super::document::METADATA_KEY;
pub use super::header::{AvatarHeader, ClipHeader, HarmonicsHeader, LevelHeader};

/// The version without codes and deflated tensors.
pub const VERSION: u64 = 1;
/// The version of avatar files with codes or deflated tensors.
pub const VERSION_PACKED: u64 = 2;
/// The version of avatar files that name a low-pass; codes and deflated tensors as in version 2.
pub const VERSION_FILTER: u64 = 3;
/// The version of avatar files with spherical harmonics or without networks; all else as in
/// version 3.
pub const VERSION_SPLATS: u64 = 4;
/// The version of avatar files with directions from which Gaussians are drawn; all else as in
/// version 4.
pub const VERSION_FACING: u64 = 5;
/// `format` in the document of an avatar file.
pub const AVATAR_FORMAT: &str = "effigy.avatar";
/// `format` in the document of a motion file.
pub const MOTION_FORMAT: &str = "effigy.motion";

/// The subspace of an avatar, or an empty one.
fn subspace(space: &Option<Subspace>) -> &Subspace {
    static NONE: Subspace = Subspace {
        mean: vec![],
        component: vec![],
        sigma: vec![],
    };
    space.as_ref().unwrap_or(&NONE)
}

/// Rows of the form `name: type [shape] rule(limits) = array, meaning;`, in groups headed by how
/// many of each there are.
macro_rules! table {
    ($h:ident: $header:ty, $m:ident: $model:ty, $k:ident;
     $($count:expr => { $($name:literal: $type:ty [$($dim:expr),*] $rule:ident($($limit:expr),*) = $data:expr, $what:literal;)* })*) => {
        &[$($(TensorRow {
            name: $name,
            dtype: <$type as TensorElement>::DTYPE,
            count: |$h: &$header| { let _ = $h; $count },
            shape: |$h: &$header, $k: usize| { let _ = ($h, $k); vec![$($dim),*] },
            rule: |$h: &$header, $k: usize, bytes: &[u8]| { let _ = ($h, $k); check::$rule::<$type>(bytes $(, $limit)*) },
            bytes: |$h: &$header, $m: &$model, $k: usize| { let _ = ($h, $k); StoredBytes::stored_bytes($data) },
            what: $what,
        },)*)*]
    };
}

/// A set of an avatar's Gaussians.
fn set(avatar: &Avatar, set: usize) -> SetArrays<'_> {
    SetArrays::new(avatar, set)
}

/// The tensors of an avatar file. Those whose names begin with `@` are of the avatar itself, under
/// the name without it, and of each level, under `level.K.` and the name. After `=` stands the
/// array that a tensor is read into, or what makes its codes of one.
pub const AVATAR: &[TensorRow<AvatarHeader, Avatar>] = table! { h: AvatarHeader, a: Avatar, k;
    h.sets() => {
        "@position":       u16 [h.set(k).gaussians, 3] any() = &set(a, k).gaussians.position, "coordinates in the bounds, canonical pose";
        "@opacity":        u8 [h.set(k).gaussians] any() = &set(a, k).gaussians.opacity, "255 is opaque";
        "@joint":          u8 [h.set(k).gaussians, 4] below(h.joints.len()) = &set(a, k).gaussians.joint, "the joints that move a Gaussian";
        "@node":           u16 [h.set(k).with_nodes, 3] below(h.nodes) = set(a, k).node, "the nearest nodes";
        "@part_start":     u32 [h.parts + 1] starts(h.set(k).gaussians) = set(a, k).part_start, "part i is Gaussians start[i] to start[i + 1]";
        "@rotation.row":   u32 [h.set(k).rotation_rows] rising(h.set(k).gaussians) = &set(a, k).rotation_rows.gaussian, "the Gaussian of each row";
        "@scale.row":      u32 [h.set(k).scale_rows] rising(h.set(k).gaussians) = &set(a, k).scale_rows.gaussian, "the Gaussian of each row";
        "@color.row":      u32 [h.set(k).color_rows] rising(h.set(k).gaussians) = &set(a, k).color_rows.gaussian, "the Gaussian of each row";
    }
    1 => {
        "node.position":  u16 [h.nodes, 3] any() = &a.nodes.position, "coordinates in the bounds, canonical pose";
        "node.part":      u16 [h.nodes] below(h.parts) = &a.nodes.part, "the part whose features move the node";
        "node.offset":    f16 [h.nodes, 3] length() = &a.nodes.offset, "displacement that no pose changes, metres";
        "skeleton.rest":  f32 [h.joints.len(), 3] length() = &a.skeleton.rest, "joints in the rest pose, metres";
        "skeleton.canonical": f32 [h.joints.len(), 3] finite() = &a.skeleton.canonical, "the canonical pose, axis-angle, radians";
    }
    h.sets() * usize::from(h.facing) => {
        "@facing": u8 [h.set(k).gaussians, 3] any() = &set(a, k).gaussians.facing, "the axis and the limit of the cone from which it is drawn";
    }
    h.sets() * h.plain(Coded::Rotation) => {
        "@rotation": f16 [h.set(k).gaussians, 4] quaternion() = &set(a, k).gaussians.rotation, "quaternion w x y z, any length but 0";
    }
    h.sets() * h.coded(Coded::Rotation) => {
        "@rotation": u32 [h.set(k).gaussians] any() = coding::rotations(set(a, k).gaussians), "quaternion of length 1: three components and which is left out";
    }
    h.sets() * usize::from(h.log_scales.is_none()) => {
        "@log_scale": f16 [h.set(k).gaussians, 3] finite() = &set(a, k).gaussians.log_scale, "ln of the standard deviations, metres";
    }
    h.sets() * h.log_scales_of(8) => {
        "@log_scale": u8 [h.set(k).gaussians, 3] any() = coding::log_scales::<u8>(set(a, k).gaussians, h.set(k).log_scales),
            "codes of ln of the standard deviations";
    }
    h.sets() * h.log_scales_of(16) => {
        "@log_scale": u16 [h.set(k).gaussians, 3] below(LogScaleCodes::MAX_CODE + 1)
            = coding::log_scales::<u16>(set(a, k).gaussians, h.set(k).log_scales), "codes of ln of the standard deviations";
    }
    h.sets() * h.plain_colors() => {
        "@color": f16 [h.set(k).gaussians, 3] finite() = &set(a, k).gaussians.color, "red, green, blue, 0 to 1";
    }
    h.sets() * h.coded(Coded::Color) => {
        "@color":      u8 [h.set(k).gaussians, 3] any() = coding::colors(set(a, k).gaussians), "red, green, blue, 0 to 255";
        "@color.kept": f16 [h.set(k).color_rows, 3] finite() = coding::row_colors(set(a, k)), "the same of those with a row, 0 to 1";
    }
    h.sets() * h.coded_harmonics() => {
        "@color": u16 [h.set(k).gaussians, 3] any() = coding::constant_harmonics(set(a, k).gaussians, h.harmonic_codes()),
            "codes of red, green, blue";
        "@sh": u16 [h.harmonic_functions(), 3, h.set(k).gaussians] any() = coding::harmonic_codes(set(a, k).sh, h.harmonic_codes()),
            "codes of the spherical harmonics from degree 1 up";
    }
    h.sets() * h.plain_harmonics() => {
        "@sh": f16 [h.harmonic_functions(), 3, h.set(k).gaussians] finite() = coding::harmonics(set(a, k).sh),
            "spherical harmonics from degree 1 up";
    }
    h.sets() * h.plain(Coded::JointWeight) => {
        "@joint_weight": u8 [h.set(k).gaussians, 4] weights() = &set(a, k).gaussians.joint_weight, "their weights, which sum to 255";
    }
    h.sets() * h.coded(Coded::JointWeight) => {
        "@joint_weight": u8 [h.set(k).gaussians, 3] weights_but_one() = coding::joint_weights(set(a, k).gaussians), "their weights but the last, of 255";
    }
    h.sets() * h.plain(Coded::RotationBasis) => {
        "@rotation.basis": f16 [h.set(k).rotation_rows, 4, h.basis] finite() = halves(&set(a, k).rotation_rows.basis), "quaternion a unit of feature";
    }
    h.sets() * h.coded(Coded::RotationBasis) => {
        "@rotation.basis": i8 [h.set(k).rotation_rows, 4, h.basis] code() = codes(&set(a, k).rotation_rows.basis), "steps of quaternion a unit of feature";
        "@rotation.step":  f16 [h.set(k).rotation_rows] step() = steps(&set(a, k).rotation_rows.basis), "the step of each row";
    }
    h.sets() * h.plain(Coded::ScaleBasis) => {
        "@scale.basis": f16 [h.set(k).scale_rows, 3, h.basis] finite() = halves(&set(a, k).scale_rows.basis), "log scale a unit of feature";
    }
    h.sets() * h.coded(Coded::ScaleBasis) => {
        "@scale.basis": i8 [h.set(k).scale_rows, 3, h.basis] code() = codes(&set(a, k).scale_rows.basis), "steps of log scale a unit of feature";
        "@scale.step":  f16 [h.set(k).scale_rows] step() = steps(&set(a, k).scale_rows.basis), "the step of each row";
    }
    h.sets() * h.plain(Coded::ColorBasis) => {
        "@color.basis": f16 [h.set(k).color_rows, 3, h.basis] finite() = halves(&set(a, k).color_rows.basis), "colour a unit of feature";
    }
    h.sets() * h.coded(Coded::ColorBasis) => {
        "@color.basis": i8 [h.set(k).color_rows, 3, h.basis] code() = codes(&set(a, k).color_rows.basis), "steps of colour a unit of feature";
        "@color.step":  f16 [h.set(k).color_rows] step() = steps(&set(a, k).color_rows.basis), "the step of each row";
    }
    h.plain(Coded::NodeBasis) => {
        "node.basis": f16 [h.nodes, 3, h.basis] finite() = halves(&a.nodes.basis), "metres a unit of feature";
    }
    h.coded(Coded::NodeBasis) => {
        "node.basis": i8 [h.nodes, 3, h.basis] code() = codes(&a.nodes.basis), "steps of metres a unit of feature";
        "node.step":  f16 [h.nodes] step() = steps(&a.nodes.basis), "the step of each node";
    }
    h.layers() * h.plain(Coded::Networks) => {
        "mlp.#.weight": f16 [h.parts, h.widths[k + 1], h.widths[k]] finite() = halves(&a.networks.layers[k].weight),
            "a layer of every part";
    }
    h.layers() * h.coded(Coded::Networks) => {
        "mlp.#.weight": i8 [h.parts, h.widths[k + 1], h.widths[k]] code() = codes(&a.networks.layers[k].weight),
            "steps of a layer of every part";
        "mlp.#.step":   f16 [h.parts, h.widths[k + 1]] step() = steps(&a.networks.layers[k].weight), "the step of each neuron";
    }
    h.layers() => {
        "mlp.#.bias": f16 [h.parts, h.widths[k + 1]] finite() = &a.networks.layers[k].bias, "its biases";
    }
    usize::from(h.pose_components.is_some()) => {
        "pose_space.mean":      f32 [h.pose_len()] finite() = &subspace(&a.inputs.pose_space).mean, "mean of the training poses";
        "pose_space.component": f32 [h.pose_components.unwrap_or(0), h.pose_len()] orthonormal(h.pose_len())
            = &subspace(&a.inputs.pose_space).component, "their principal components";
        "pose_space.sigma":     f32 [h.pose_components.unwrap_or(0)] deviation()
            = &subspace(&a.inputs.pose_space).sigma, "standard deviation along each";
    }
    usize::from(h.expression_components.is_some()) => {
        "expression_space.mean": f32 [h.expression] finite() = &subspace(&a.inputs.expression_space).mean, "mean of the expressions";
        "expression_space.component": f32 [h.expression_components.unwrap_or(0), h.expression] orthonormal(h.expression)
            = &subspace(&a.inputs.expression_space).component, "their principal components";
        "expression_space.sigma": f32 [h.expression_components.unwrap_or(0)] deviation()
            = &subspace(&a.inputs.expression_space).sigma, "standard deviation along each";
    }
};

/// The tensors of a motion file.
pub const MOTION: &[TensorRow<ClipHeader, Clip>] = table! { h: ClipHeader, c: Clip, k;
    1 => {
        "rotation":    f32 [h.frames, h.joints.len(), 3] finite() = &c.rotation, "axis-angle relative to the parent, radians";
        "translation": f32 [h.frames, 3] length() = &c.translation, "of the root from its rest position, metres";
        "expression":  f32 [h.frames, h.expression] finite() = &c.expression, "expression coefficients";
    }
};
