//! The splats of a primitive, in its node's space.

use super::{
    EXTENSION, accessor,
    buffers::Buffers,
    document::{Document, Packed, Primitive, Splatting, entry},
};
use crate::{
    assumption::Assumption,
    splats::{found::Found, logit, plausible, spz},
};
use effigy_core::{
    avatar::Filter,
    io::{
        file::{FormatError, excerpt},
        splats::{Splats, Up, functions_of},
    },
};

/// Whether a primitive consists of splats.
pub fn is_splats(primitive: &Primitive) -> bool {
    primitive.extensions.splatting.is_some() || primitive.extensions.draft.is_some()
}

/// The SPZ file of a primitive, if it has one.
fn packed(primitive: &Primitive) -> Option<&Packed> {
    let extensions = &primitive.extensions;
    let compression = extensions.splatting.as_ref().map(|s| &s.extensions);
    compression
        .and_then(|c| c.spz_2.as_ref().or(c.spz.as_ref()))
        .or(extensions.draft.as_ref())
}

/// The buffer views that a primitive's splats use.
pub fn views(document: &Document, primitive: &Primitive) -> Vec<usize> {
    match packed(primitive) {
        Some(packed) => vec![packed.buffer_view],
        None => {
            let accessors = primitive.attributes.values();
            let accessors = accessors.filter_map(|&index| document.accessors.get(index));
            accessors
                .filter_map(|accessor| accessor.buffer_view)
                .collect()
        }
    }
}

/// Reads a primitive.
///
/// # Errors
/// When an attribute is missing or is not what the extension says.
pub fn read(
    document: &Document,
    buffers: &Buffers,
    primitive: &Primitive,
) -> Result<Found, FormatError> {
    let mut assumptions = vec![];
    if let Some(splatting) = &primitive.extensions.splatting {
        assumptions = check(splatting)?;
    }
    let mut found = match packed(primitive) {
        Some(packed) => spz::read(buffers.view(packed.buffer_view)?.bytes)?,
        None => plain(document, buffers, primitive)?.into(),
    };
    found.assumptions.splice(0..0, assumptions);
    Ok(found)
}

/// What the extension leaves to others: kernels and colours.
fn check(splatting: &Splatting) -> Result<Vec<Assumption>, FormatError> {
    if let Some(kernel) = splatting.kernel.as_deref().filter(|k| *k != "ellipse") {
        return Err(FormatError::container(
            format!("the kernel `{}`", excerpt(kernel)),
            "ellipse",
        ));
    }
    let space = splatting.color_space.as_deref();
    let linear = space.is_some_and(|space| space != "srgb_rec709_display");
    Ok(linear
        .then(|| Assumption {
            what: "colour space",
            taken: "sRGB, as displays have it".into(),
            because: format!(
                "colours of `{}` are not converted",
                excerpt(space.unwrap_or_default())
            ),
        })
        .into_iter()
        .collect())
}

fn plain(
    document: &Document,
    buffers: &Buffers,
    primitive: &Primitive,
) -> Result<Splats, FormatError> {
    let find = |name: &str| {
        let index = primitive.attributes.get(name).copied();
        index.ok_or_else(|| {
            FormatError::container(
                format!("no attribute `{name}`"),
                format!("those of {EXTENSION}"),
            )
        })
    };
    let position = find("POSITION")?;
    let count = entry(&document.accessors, position, "accessor")?.count;
    plausible::check(count, buffers.total())?;
    let three = |index, what: &str| accessor::rows::<3>(document, buffers, index, count, what);
    let of = |name: &str| format!("{EXTENSION}:{name}");
    let [rotation, scale, opacity] = [of("ROTATION"), of("SCALE"), of("OPACITY")];
    let color = of("SH_DEGREE_0_COEF_0");
    let rotation = accessor::rows::<4>(document, buffers, find(&rotation)?, count, &rotation)?;
    let part = accessor::rows::<1>(document, buffers, find(&opacity)?, count, &opacity)?;
    if let Some([bad]) = part.iter().find(|[part]| !(0.0..=1.0).contains(part)) {
        return Err(FormatError::container(
            format!("an opacity of {bad}"),
            "0 to 1",
        ));
    }
    let mut degree = 0;
    let mut columns = vec![];
    for next in 1..=3 {
        let names: Vec<String> = (0..2 * next + 1)
            .map(|k| of(&format!("SH_DEGREE_{next}_COEF_{k}")))
            .collect();
        if !primitive.attributes.contains_key(&names[0]) {
            break;
        }
        for name in &names {
            columns.push(three(find(name)?, name)?);
        }
        degree = next;
    }
    let mut harmonics = Vec::with_capacity(functions_of(degree) * count as usize);
    for k in 0..count as usize {
        harmonics.extend(columns.iter().map(|column| column[k]));
    }
    Ok(Splats {
        position: three(position, "POSITION")?,
        rotation: rotation
            .into_iter()
            .map(|[x, y, z, w]| [w, x, y, z])
            .collect(),
        log_scale: three(find(&scale)?, &scale)?
            .into_iter()
            .map(|row| row.map(f32::ln))
            .collect(),
        opacity: part
            .into_iter()
            .map(|[part]| logit::of_part(part))
            .collect(),
        color: three(find(&color)?, &color)?,
        degree,
        harmonics,
        up: Up::Y,
        filter: Filter::DEFAULT,
    })
}
