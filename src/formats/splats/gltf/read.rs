//! The splats of a scene.

use super::{
    EXTENSION, primitive,
    scene::{self, PlacedMesh},
};
use crate::{
    assumption::Assumption,
    gltf::{
        self, Document, GltfFile,
        document::{Primitive, Scenes},
        entry,
    },
    splats::{beside::Beside, plausible},
};
use effigy_core::{
    avatar::limits,
    glam::{DAffine3, DVec3},
    io::{
        file::{FormatError, excerpt},
        splats::{Found, Splats, Up, moved},
    },
};
use std::collections::BTreeSet;

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
/// How the names of extensions begin that do not touch splats: of materials, textures and lights.
const ELSEWHERE: [&str; 3] = ["KHR_materials_", "KHR_texture_", "KHR_lights_"];

/// Reads a `.glb`, or a `.gltf` whose buffers `beside` has.
///
/// # Errors
/// When the document or what it refers to breaks a rule, or the scene has no splats.
pub fn read(bytes: &[u8], beside: &mut dyn Beside) -> Result<Found, FormatError> {
    let file = gltf::parts(bytes)?;
    check_length(&file.document)?;
    let document: Document = gltf::parse(&file.document)?;
    let scenes: Scenes = gltf::parse(&file.document)?;
    check_extensions(&scenes.extensions_required)?;
    let mut used = BTreeSet::new();
    let mut parts: Vec<(&Primitive, DAffine3)> = vec![];
    for PlacedMesh { mesh, place } in scene::meshes(&document, &scenes)? {
        let mesh = entry(&scenes.meshes, mesh, "mesh")?;
        for primitive in mesh.primitives.iter().filter(|p| primitive::is_splats(p)) {
            for view in primitive::views(&document, primitive) {
                used.insert(entry(&document.buffer_views, view, "buffer view")?.buffer);
            }
            parts.push((primitive, place));
        }
    }
    if parts.is_empty() {
        let count = scenes.meshes.len();
        return Err(FormatError::container(
            format!("a glTF scene without splats, of {count} meshes"),
            format!("points with the extension {EXTENSION}"),
        ));
    }
    let is_used = |buffer| used.contains(&buffer);
    let mut beside = |name: &str, most: u64| beside.file(name, most);
    let source = GltfFile::read(document, file.binary, is_used, &mut beside)?;
    let mut all: Option<Splats> = None;
    let mut assumptions: Vec<Assumption> = vec![];
    // Nodes put tiles of the globe at its centre's distance.
    let origin = parts.first().map(|(_, place)| place.translation.round());
    let is_far = |origin: &DVec3| origin.abs().max_element() > limits::LENGTH;
    let origin = origin.filter(is_far).unwrap_or_default();
    if origin != DVec3::ZERO {
        assumptions.push(moved(origin.to_array()));
    }
    for (primitive, mut place) in parts {
        let found = primitive::read(&source, primitive)?;
        place.translation -= origin;
        // A node's transform is meant for y up.
        let splats = found.splats.with_up(Up::Y).transformed(&place);
        let splats = splats.ok_or_else(|| {
            FormatError::container(
                "a node that mirrors or flattens its splats",
                "a positive scale",
            )
        })?;
        for assumption in found.assumptions {
            if !assumptions.contains(&assumption) {
                assumptions.push(assumption);
            }
        }
        let count = all.as_ref().map_or(0, Splats::len) + splats.len();
        plausible::check(count as u64, source.size() as u64)?;
        all = Some(match all {
            None => splats,
            Some(before) => before.joined(splats),
        });
    }
    let splats = all.ok_or_else(|| FormatError::container("no splats", "some"))?;
    Ok(Found {
        splats,
        assumptions,
    })
}

fn check_length(document: &[u8]) -> Result<(), FormatError> {
    let count = |sign: u8| document.iter().filter(|byte| **byte == sign).count();
    let (objects, values) = (count(b'{'), count(b','));
    if objects <= OBJECTS && values <= VALUES {
        return Ok(());
    }
    Err(FormatError::container(
        format!("a glTF document of {objects} objects and {values} values"),
        format!("at most {OBJECTS} and {VALUES}"),
    ))
}

fn check_extensions(required: &[String]) -> Result<(), FormatError> {
    let is_read = |name: &str| {
        UNDERSTOOD.contains(&name) || ELSEWHERE.iter().any(|start| name.starts_with(start))
    };
    match required.iter().find(|name| !is_read(name)) {
        None => Ok(()),
        Some(name) => Err(FormatError::container(
            format!("the required extension `{}`", excerpt(name)),
            UNDERSTOOD.join(", "),
        )),
    }
}
