//! The splats of a scene.

use super::{
    EXTENSION,
    buffers::Buffers,
    document::{Document, Primitive, entry},
    primitive,
    scene::{self, Placed},
};
use crate::{
    assumption::Assumption,
    glb,
    splats::{beside::Beside, plausible},
};
use effigy_core::{
    avatar::limits,
    glam::{DAffine3, DVec3},
    io::{
        file::FormatError,
        splats::{Found, Splats, Up, moved},
    },
};

/// Reads a `.glb`, or a `.gltf` whose buffers `beside` has.
///
/// # Errors
/// When the document or what it refers to breaks a rule, or the scene has no splats.
pub fn read(bytes: &[u8], beside: &mut dyn Beside) -> Result<Found, FormatError> {
    let file = glb::parts(bytes)?;
    let document = Document::parse(&file.document)?;
    let placed = scene::meshes(&document)?;
    let mut used = vec![false; document.buffers.len()];
    let mut parts: Vec<Part> = vec![];
    for Placed { mesh, place } in &placed {
        let mesh = entry(&document.meshes, *mesh, "mesh")?;
        for primitive in mesh.primitives.iter().filter(|p| primitive::is_splats(p)) {
            for view in primitive::views(&document, primitive) {
                let view = entry(&document.buffer_views, view, "buffer view")?;
                if let Some(used) = used.get_mut(view.buffer) {
                    *used = true;
                }
            }
            parts.push(Part { primitive, place });
        }
    }
    if parts.is_empty() {
        let count = document.meshes.len();
        return Err(FormatError::container(
            format!("a glTF scene without splats, of {count} meshes"),
            format!("points with the extension {EXTENSION}"),
        ));
    }
    let buffers = Buffers::read(&document, file.binary, &used, beside)?;
    let mut all: Option<Splats> = None;
    let mut assumptions: Vec<Assumption> = vec![];
    // Nodes put tiles of the globe at its centre's distance.
    let origin = parts.first().map(|part| part.place.translation.round());
    let is_far = |origin: &DVec3| origin.abs().max_element() > limits::LENGTH;
    let origin = origin.filter(is_far).unwrap_or_default();
    if origin != DVec3::ZERO {
        assumptions.push(moved(origin.to_array()));
    }
    for Part { primitive, place } in parts {
        let found = primitive::read(&document, &buffers, primitive)?;
        let place = DAffine3 {
            translation: place.translation - origin,
            ..*place
        };
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
        plausible::check(count as u64, buffers.total())?;
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

/// A primitive in the scene.
struct Part<'a> {
    primitive: &'a Primitive,
    place: &'a DAffine3,
}
