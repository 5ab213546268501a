//! What is read of the document.

use super::EXTENSION;
use crate::glb;
use effigy_core::io::file::{FormatError, excerpt};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Objects and values in a document, at most: each takes more memory than its text.
const OBJECTS: usize = 50_000;
const VALUES: usize = 500_000;

/// Extensions that files may require: what they change is read here.
const UNDERSTOOD: [&str; 5] = [
    EXTENSION,
    "KHR_gaussian_splatting_compression_spz_2",
    "KHR_gaussian_splatting_compression_spz",
    "KHR_spz_gaussian_splats_compression",
    "KHR_mesh_quantization",
];

/// Whether splats are read rightly without more knowledge of an extension: those of materials,
/// textures and lights do not touch them.
fn is_understood(name: &str) -> bool {
    let elsewhere = ["KHR_materials_", "KHR_texture_", "KHR_lights_"];
    UNDERSTOOD.contains(&name) || elsewhere.iter().any(|start| name.starts_with(start))
}

/// A glTF document, as far as splats are concerned.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
#[derive(Default)]
pub struct Document {
    extensions_required: Vec<String>,
    pub scene: Option<usize>,
    pub scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<Mesh>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<View>,
    pub buffers: Vec<Buffer>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub struct Scene {
    pub nodes: Vec<usize>,
}

/// A node: a matrix by columns, or translation, rotation x y z w and scale.
#[derive(Deserialize, Default)]
#[serde(default)]
pub struct Node {
    pub children: Vec<usize>,
    pub mesh: Option<usize>,
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub struct Mesh {
    pub primitives: Vec<Primitive>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub struct Primitive {
    /// Indices of accessors by name.
    pub attributes: BTreeMap<String, usize>,
    pub extensions: PrimitiveExtensions,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub struct PrimitiveExtensions {
    #[serde(rename = "KHR_gaussian_splatting")]
    pub splatting: Option<Splatting>,
    /// A draft of 2025 that stood for the whole.
    #[serde(rename = "KHR_spz_gaussian_splats_compression")]
    pub draft: Option<Packed>,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub struct Splatting {
    pub kernel: Option<String>,
    pub color_space: Option<String>,
    pub extensions: Compression,
}

#[derive(Deserialize, Default)]
#[serde(default)]
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
    pub buffer_view: usize,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Accessor {
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: u64,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: u64,
    #[serde(rename = "type")]
    pub shape: String,
    #[serde(default)]
    pub sparse: Option<Empty>,
}

/// Something whose content is not read.
#[derive(Deserialize)]
pub struct Empty {}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct View {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: u64,
    pub byte_length: u64,
    pub byte_stride: Option<u64>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Buffer {
    pub uri: Option<String>,
    pub byte_length: u64,
}

impl Document {
    pub fn parse(bytes: &[u8]) -> Result<Self, FormatError> {
        let count = |sign: u8| bytes.iter().filter(|byte| **byte == sign).count();
        let (objects, values) = (count(b'{'), count(b','));
        if objects > OBJECTS || values > VALUES {
            return Err(FormatError::container(
                format!("a glTF document of {objects} objects and {values} values"),
                format!("at most {OBJECTS} and {VALUES}"),
            ));
        }
        let document: Self =
            serde_json::from_slice(bytes).map_err(|error| glb::unreadable(bytes, &error))?;
        let mut required = document.extensions_required.iter();
        match required.find(|name| !is_understood(name)) {
            None => Ok(document),
            Some(name) => Err(FormatError::container(
                format!("the required extension `{}`", excerpt(name)),
                UNDERSTOOD.join(", "),
            )),
        }
    }
}

/// An entry of one of the document's arrays. `what`: the array's name in errors.
///
/// # Errors
/// When there are fewer.
pub fn entry<'a, T>(entries: &'a [T], index: usize, what: &str) -> Result<&'a T, FormatError> {
    entries.get(index).ok_or_else(|| {
        FormatError::container(
            format!("{what} {index}"),
            format!("one of {}", entries.len()),
        )
    })
}
