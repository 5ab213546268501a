//! The splats of a scene.

use super::{
    EXTENSION,
    buffers::{Buffers, chunks},
    document::{Document, Primitive, entry},
    primitive,
    scene::{self, Placed},
};
use crate::{
    assumption::Assumption,
    splats::{beside::Beside, found::Found, plausible},
};
use effigy_core::io::{
    file::FormatError,
    splats::{Splats, Up, functions_of},
};

/// Reads a `.glb`, or a `.gltf` whose buffers `beside` has.
///
/// # Errors
/// When the document or what it refers to breaks a rule, or the scene has no splats.
pub fn read(bytes: &[u8], beside: &mut dyn Beside) -> Result<Found, FormatError> {
    let chunks = chunks(bytes)?;
    let document = Document::parse(chunks.document)?;
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
        return Err(FormatError::container(
            "a glTF scene without splats",
            format!("points with the extension {EXTENSION}"),
        ));
    }
    let buffers = Buffers::read(&document, chunks.binary, &used, beside)?;
    let mut all: Option<Splats> = None;
    let mut assumptions: Vec<Assumption> = vec![];
    for Part { primitive, place } in parts {
        let found = primitive::read(&document, &buffers, primitive)?;
        // A node's transform is meant for y up.
        found.splats.check()?;
        let splats = found.splats.with_up(Up::Y).transformed(place);
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
            Some(before) => joined(before, splats),
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
    place: &'a effigy_core::glam::DAffine3,
}

/// Both, with harmonics up to the higher degree, and the low-pass of the first.
fn joined(mut first: Splats, second: Splats) -> Splats {
    let degree = first.degree.max(second.degree);
    let mut harmonics = widened(&first, degree);
    harmonics.extend(widened(&second, degree));
    first.position.extend(second.position);
    first.rotation.extend(second.rotation);
    first.log_scale.extend(second.log_scale);
    first.opacity.extend(second.opacity);
    first.color.extend(second.color);
    Splats {
        degree,
        harmonics,
        ..first
    }
}

/// The harmonics with zeros up to a degree.
fn widened(splats: &Splats, degree: usize) -> Vec<[f32; 3]> {
    let (own, wanted) = (functions_of(splats.degree), functions_of(degree));
    let mut harmonics = Vec::with_capacity(wanted * splats.len());
    for k in 0..splats.len() {
        harmonics.extend(&splats.harmonics[own * k..][..own]);
        harmonics.extend(std::iter::repeat_n([0.0; 3], wanted - own));
    }
    harmonics
}
