//! The parts of glTF's JSON that motion needs. Everything else is passed over: meshes, materials
//! and pictures may break any rule.

use crate::json::bounded;
use serde::{Deserialize, de::IgnoredAny};
use std::borrow::Cow;

#[derive(Deserialize)]
pub struct Document<'a> {
    #[serde(default, deserialize_with = "bounded")]
    pub nodes: Vec<Node>,
    #[serde(default, deserialize_with = "bounded")]
    pub skins: Vec<Skin>,
    #[serde(default, deserialize_with = "bounded")]
    pub animations: Vec<Animation>,
    #[serde(default, deserialize_with = "bounded")]
    pub accessors: Vec<Accessor>,
    #[serde(default, rename = "bufferViews", deserialize_with = "bounded")]
    pub views: Vec<View>,
    #[serde(default, borrow, deserialize_with = "bounded")]
    pub buffers: Vec<Buffer<'a>>,
    #[serde(default)]
    pub extensions: Extensions,
}

#[derive(Deserialize)]
pub struct Node {
    #[serde(default)]
    pub name: Option<String>,
    #[serde(default, deserialize_with = "bounded")]
    pub children: Vec<u32>,
    #[serde(default)]
    pub translation: Option<[f64; 3]>,
    /// x y z w.
    #[serde(default)]
    pub rotation: Option<[f64; 4]>,
    #[serde(default)]
    pub scale: Option<[f64; 3]>,
    /// Columns.
    #[serde(default)]
    pub matrix: Option<Box<[f64; 16]>>,
}

#[derive(Deserialize)]
pub struct Skin {
    #[serde(default, rename = "inverseBindMatrices")]
    pub inverse_bind: Option<u32>,
    #[serde(deserialize_with = "bounded")]
    pub joints: Vec<u32>,
}

#[derive(Deserialize)]
pub struct Animation {
    #[serde(default)]
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
    #[serde(default)]
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

#[derive(Deserialize)]
pub struct Accessor {
    #[serde(default, rename = "bufferView")]
    pub view: Option<u32>,
    #[serde(default, rename = "byteOffset")]
    pub offset: u64,
    #[serde(rename = "componentType")]
    pub component: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: u64,
    #[serde(rename = "type")]
    pub shape: Shape,
    #[serde(default)]
    pub sparse: Option<Box<Sparse>>,
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
    pub indices: SparseIndices,
    pub values: SparseValues,
}

#[derive(Deserialize)]
pub struct SparseIndices {
    #[serde(rename = "bufferView")]
    pub view: u32,
    #[serde(default, rename = "byteOffset")]
    pub offset: u64,
    #[serde(rename = "componentType")]
    pub component: u32,
}

#[derive(Deserialize)]
pub struct SparseValues {
    #[serde(rename = "bufferView")]
    pub view: u32,
    #[serde(default, rename = "byteOffset")]
    pub offset: u64,
}

#[derive(Deserialize)]
pub struct View {
    pub buffer: u32,
    #[serde(default, rename = "byteOffset")]
    pub offset: u64,
    #[serde(rename = "byteLength")]
    pub length: u64,
    #[serde(default, rename = "byteStride")]
    pub stride: Option<u64>,
    #[serde(default)]
    pub extensions: ViewExtensions,
}

#[derive(Default, Deserialize)]
pub struct ViewExtensions {
    #[serde(
        default,
        rename = "EXT_meshopt_compression",
        alias = "KHR_meshopt_compression"
    )]
    pub meshopt: Option<IgnoredAny>,
}

#[derive(Deserialize)]
pub struct Buffer<'a> {
    #[serde(default, borrow)]
    pub uri: Option<Cow<'a, str>>,
    #[serde(rename = "byteLength")]
    pub length: u64,
}

#[derive(Default, Deserialize)]
pub struct Extensions {
    /// VRM 0.x.
    #[serde(default, rename = "VRM")]
    pub vrm_0: Option<Vrm0>,
    /// VRM 1.0.
    #[serde(default, rename = "VRMC_vrm")]
    pub vrm_1: Option<Vrm1>,
    /// VRM's animations.
    #[serde(default, rename = "VRMC_vrm_animation")]
    pub animation: Option<Vrm1>,
}

#[derive(Deserialize)]
pub struct Vrm0 {
    #[serde(default)]
    pub humanoid: Option<Humanoid0>,
}

#[derive(Deserialize)]
pub struct Humanoid0 {
    #[serde(rename = "humanBones", deserialize_with = "bounded")]
    pub bones: Vec<Bone0>,
}

#[derive(Deserialize)]
pub struct Bone0 {
    pub bone: String,
    pub node: u32,
}

#[derive(Deserialize)]
pub struct Vrm1 {
    #[serde(default)]
    pub humanoid: Option<Humanoid1>,
}

#[derive(Deserialize)]
pub struct Humanoid1 {
    #[serde(rename = "humanBones")]
    pub bones: std::collections::BTreeMap<String, Bone1>,
}

#[derive(Deserialize)]
pub struct Bone1 {
    pub node: u32,
}
