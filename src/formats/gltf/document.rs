//! What is read of a document. Both readers parse a [`Document`], and then the lists that they alone
//! need, [`Scenes`] or [`Motion`]: what the other one reads, materials and pictures may break any
//! rule.

use super::glb::unreadable;
use crate::json::bounded;
use effigy_core::io::file::FormatError;
use serde::{Deserialize, de::IgnoredAny};
use std::{borrow::Cow, collections::BTreeMap};

/// What both readers need.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Document<'a> {
    #[serde(default, deserialize_with = "bounded")]
    pub nodes: Vec<Node>,
    #[serde(default, deserialize_with = "bounded")]
    pub accessors: Vec<Accessor>,
    #[serde(default, deserialize_with = "bounded")]
    pub buffer_views: Vec<View>,
    #[serde(default, borrow, deserialize_with = "bounded")]
    pub buffers: Vec<BufferFile<'a>>,
}

/// A node: a matrix by columns, or translation, rotation x y z w and scale.
#[derive(Deserialize)]
pub struct Node {
    pub name: Option<String>,
    #[serde(default, deserialize_with = "bounded")]
    pub children: Vec<u32>,
    pub mesh: Option<u32>,
    pub matrix: Option<Box<[f64; 16]>>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Accessor {
    pub buffer_view: Option<u32>,
    #[serde(default)]
    pub byte_offset: u64,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: u64,
    #[serde(rename = "type")]
    pub shape: Shape,
    pub sparse: Option<Box<Sparse>>,
}

impl Accessor {
    /// The views that its numbers are in.
    pub fn views(&self) -> impl Iterator<Item = u32> {
        let sparse = self.sparse.as_ref();
        let sparse = sparse.map(|own| [own.indices.buffer_view, own.values.buffer_view]);
        self.buffer_view
            .into_iter()
            .chain(sparse.into_iter().flatten())
    }
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "UPPERCASE")]
pub enum Shape {
    Scalar,
    Vec2,
    Vec3,
    Vec4,
    Mat2,
    Mat3,
    Mat4,
}

#[derive(Deserialize)]
pub struct Sparse {
    pub count: u64,
    pub indices: SparsePart,
    pub values: SparsePart,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct SparsePart {
    pub buffer_view: u32,
    #[serde(default)]
    pub byte_offset: u64,
    /// Of indices; values have their accessor's.
    pub component_type: Option<u32>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct View {
    pub buffer: u32,
    #[serde(default)]
    pub byte_offset: u64,
    pub byte_length: u64,
    pub byte_stride: Option<u64>,
    #[serde(default)]
    pub extensions: ViewExtensions,
}

#[derive(Default, Deserialize)]
pub struct ViewExtensions {
    #[serde(rename = "EXT_meshopt_compression", alias = "KHR_meshopt_compression")]
    pub meshopt: Option<IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct BufferFile<'a> {
    #[serde(borrow)]
    pub uri: Option<Cow<'a, str>>,
    pub byte_length: u64,
}

/// What splats need beside a [`Document`].
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Scenes {
    pub extensions_required: Vec<String>,
    pub scene: Option<usize>,
    pub scenes: Vec<Scene>,
    pub meshes: Vec<Mesh>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Scene {
    pub nodes: Vec<u32>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Mesh {
    pub primitives: Vec<Primitive>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Primitive {
    /// Indices of accessors by name.
    pub attributes: BTreeMap<String, u32>,
    pub extensions: PrimitiveExtensions,
}

#[derive(Default, Deserialize)]
pub struct PrimitiveExtensions {
    #[serde(rename = "KHR_gaussian_splatting")]
    pub splatting: Option<Splatting>,
    /// A draft of 2025 that stood for the whole.
    #[serde(rename = "KHR_spz_gaussian_splats_compression")]
    pub draft: Option<Packed>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Splatting {
    pub kernel: Option<String>,
    pub color_space: Option<String>,
    #[serde(default)]
    pub extensions: Compression,
}

#[derive(Default, Deserialize)]
pub struct Compression {
    #[serde(rename = "KHR_gaussian_splatting_compression_spz_2")]
    pub spz_2: Option<Packed>,
    #[serde(rename = "KHR_gaussian_splatting_compression_spz")]
    pub spz: Option<Packed>,
}

/// An SPZ file.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Packed {
    pub buffer_view: u32,
}

/// What motion needs beside a [`Document`].
#[derive(Deserialize)]
pub struct Motion {
    #[serde(default, deserialize_with = "bounded")]
    pub skins: Vec<Skin>,
    #[serde(default, deserialize_with = "bounded")]
    pub animations: Vec<Animation>,
    #[serde(default)]
    pub extensions: Extensions,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Skin {
    pub inverse_bind_matrices: Option<u32>,
    #[serde(deserialize_with = "bounded")]
    pub joints: Vec<u32>,
}

#[derive(Deserialize)]
pub struct Animation {
    pub name: Option<String>,
    #[serde(deserialize_with = "bounded")]
    pub channels: Vec<Channel>,
    #[serde(deserialize_with = "bounded")]
    pub samplers: Vec<Sampler>,
}

#[derive(Deserialize)]
pub struct Channel {
    pub sampler: u32,
    pub target: Target,
}

#[derive(Deserialize)]
pub struct Target {
    pub node: Option<u32>,
    pub path: Path,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Path {
    Translation,
    Rotation,
    Scale,
    /// Weights of shapes, or what an extension points to.
    #[serde(other)]
    Other,
}

#[derive(Deserialize)]
pub struct Sampler {
    pub input: u32,
    pub output: u32,
    #[serde(default)]
    pub interpolation: Interpolation,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "UPPERCASE")]
pub enum Interpolation {
    #[default]
    Linear,
    Step,
    CubicSpline,
}

#[derive(Default, Deserialize)]
pub struct Extensions {
    /// VRM 0.x.
    #[serde(rename = "VRM")]
    pub vrm_0: Option<Vrm<BoneList>>,
    /// VRM 1.0.
    #[serde(rename = "VRMC_vrm")]
    pub vrm_1: Option<Vrm<BTreeMap<String, HumanBone>>>,
    /// VRM's animations.
    #[serde(rename = "VRMC_vrm_animation")]
    pub animation: Option<Vrm<BTreeMap<String, HumanBone>>>,
}

#[derive(Deserialize)]
pub struct Vrm<Bones> {
    pub humanoid: Option<VrmHumanoid<Bones>>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct VrmHumanoid<Bones> {
    pub human_bones: Bones,
}

#[derive(Deserialize)]
#[serde(transparent)]
pub struct BoneList(#[serde(deserialize_with = "bounded")] pub Vec<NamedBone>);

#[derive(Deserialize)]
pub struct NamedBone {
    pub bone: String,
    pub node: u32,
}

#[derive(Deserialize)]
pub struct HumanBone {
    pub node: u32,
}

/// Reads a part of a document.
///
/// # Errors
/// When it is no JSON, breaks a rule of glTF 2.0 in what is read, or is of another version.
pub fn parse<'a, T: Deserialize<'a>>(document: &'a [u8]) -> Result<T, FormatError> {
    serde_json::from_slice(document).map_err(|error| unreadable(document, &error))
}

/// An entry of one of the document's lists. `what`: of which, in errors.
///
/// # Errors
/// When there are fewer.
pub fn entry<'a, T>(entries: &'a [T], index: u32, what: &str) -> Result<&'a T, FormatError> {
    entries.get(index as usize).ok_or_else(|| {
        let count = entries.len();
        FormatError::container(format!("{what} {index}"), format!("one of {count}"))
    })
}
