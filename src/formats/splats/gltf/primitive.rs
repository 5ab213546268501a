//! The splats of a primitive, in its node's space.

use super::EXTENSION;
use crate::{
    assumption::Assumption,
    gltf::{
        Document, GltfFile,
        document::{Accessor, Packed, Primitive, Shape, Splatting},
    },
    splats::{logit, plausible, spz},
};
use effigy_core::{
    avatar::Filter,
    io::{
        file::{FormatError, excerpt},
        splats::{Found, Splats, Up, functions_of},
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
pub fn views(document: &Document, primitive: &Primitive) -> Vec<u32> {
    if let Some(packed) = packed(primitive) {
        return vec![packed.buffer_view];
    }
    let indices = primitive.attributes.values();
    let accessors = indices.filter_map(|&index| document.accessors.get(index as usize));
    accessors.flat_map(Accessor::views).collect()
}

/// Reads a primitive.
///
/// # Errors
/// When an attribute is missing or is not what the extension says.
pub fn read(source: &GltfFile, primitive: &Primitive) -> Result<Found, FormatError> {
    let mut assumptions = vec![];
    if let Some(splatting) = &primitive.extensions.splatting {
        assumptions = check(splatting)?;
    }
    let mut found = match packed(primitive) {
        Some(packed) => spz::read(source.view(packed.buffer_view)?)?,
        None => plain(source, primitive)?,
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

/// The names that attributes have in a version of the extension.
struct AttributeNames {
    rotation: String,
    scale: String,
    /// None: opacities and colours are in `COLOR_0`, as in the draft of 2025.
    opacity: Option<String>,
    /// Before the names of harmonics.
    harmonics: String,
}

impl AttributeNames {
    fn of(primitive: &Primitive) -> Self {
        let has = |name: &str| primitive.attributes.contains_key(name);
        let prefix = format!("{EXTENSION}:");
        let is_draft = has("_ROTATION") && !has(&format!("{prefix}ROTATION"));
        let start = if is_draft { "_" } else { &prefix };
        Self {
            rotation: format!("{start}ROTATION"),
            scale: format!("{start}SCALE"),
            opacity: (!is_draft).then(|| format!("{prefix}OPACITY")),
            harmonics: if has(&format!("{start}SH_DEGREE_1_COEF_0")) {
                start.into()
            } else {
                prefix
            },
        }
    }
}

/// The attributes of a primitive.
struct Attributes<'a> {
    source: &'a GltfFile<'a>,
    primitive: &'a Primitive,
    count: u64,
}

impl Attributes<'_> {
    fn rows<const N: usize>(&self, name: &str) -> Result<Vec<[f32; N]>, FormatError> {
        let index = find(self.primitive, name)?;
        let accessor = self.source.accessor(index)?;
        let shape = [Shape::Scalar, Shape::Vec2, Shape::Vec3, Shape::Vec4][N - 1];
        if (accessor.count, accessor.shape) != (self.count, shape) {
            let said = |shape: Shape| format!("{shape:?}").to_uppercase();
            return Err(FormatError::container(
                format!(
                    "{} {} of the attribute {name}",
                    accessor.count,
                    said(accessor.shape)
                ),
                format!("{} {}", self.count, said(shape)),
            ));
        }
        self.source.rows(index)
    }

    /// RGB or RGBA from 0 to 1, as RGBA.
    fn colors(&self) -> Result<Vec<[f32; 4]>, FormatError> {
        let index = find(self.primitive, COLOR)?;
        if self.source.accessor(index)?.shape == Shape::Vec3 {
            let opaque = |[r, g, b]: [f32; 3]| [r, g, b, 1.0];
            return Ok(self.rows(COLOR)?.into_iter().map(opaque).collect());
        }
        self.rows(COLOR)
    }

    /// The coefficients of every whole degree from 1 on. `prefix`: begins the attributes' names.
    fn harmonics(&self, prefix: &str) -> Result<Harmonics, FormatError> {
        let mut degree = 0;
        let mut columns = vec![];
        for next in 1..=3 {
            let names: Vec<String> = (0..2 * next + 1)
                .map(|k| format!("{prefix}SH_DEGREE_{next}_COEF_{k}"))
                .collect();
            if !self.primitive.attributes.contains_key(&names[0]) {
                break;
            }
            for name in &names {
                columns.push(self.rows::<3>(name)?);
            }
            degree = next;
        }
        let count = self.count as usize;
        let mut coefficient = Vec::with_capacity(functions_of(degree) * count);
        for k in 0..count {
            coefficient.extend(columns.iter().map(|column| column[k]));
        }
        Ok(Harmonics {
            degree,
            coefficient,
        })
    }
}

/// Spherical harmonics of colours.
struct Harmonics {
    degree: usize,
    /// Those of a splat follow each other.
    coefficient: Vec<[f32; 3]>,
}

/// The attribute of colours that points have without the extension.
const COLOR: &str = "COLOR_0";

fn find(primitive: &Primitive, name: &str) -> Result<u32, FormatError> {
    let index = primitive.attributes.get(name).copied();
    index.ok_or_else(|| {
        let names: Vec<String> = primitive
            .attributes
            .keys()
            .map(|name| excerpt(name))
            .collect();
        FormatError::container(
            format!("no attribute `{name}` among {}", names.join(", ")),
            format!("those of {EXTENSION}"),
        )
    })
}

fn plain(source: &GltfFile, primitive: &Primitive) -> Result<Found, FormatError> {
    let names = AttributeNames::of(primitive);
    let position = find(primitive, "POSITION")?;
    let count = source.accessor(position)?.count;
    plausible::check(count, source.size() as u64)?;
    let all = Attributes {
        source,
        primitive,
        count,
    };
    let rotation = all.rows::<4>(&names.rotation)?;
    let (opacity, color): (Vec<f32>, Vec<[f32; 3]>) = match &names.opacity {
        Some(opacity) => {
            let part = all.rows::<1>(opacity)?;
            let is_odd = |part: &f32| part.is_finite() && !(0.0..=1.0).contains(part);
            if let Some(bad) = part.as_flattened().iter().find(|part| is_odd(part)) {
                return Err(FormatError::container(
                    format!("an opacity of {bad}"),
                    "0 to 1",
                ));
            }
            let name = format!("{EXTENSION}:SH_DEGREE_0_COEF_0");
            let opacity = part.into_iter().map(|[part]| logit::of_part(part));
            (opacity.collect(), all.rows(&name)?)
        }
        None => {
            let split = |[r, g, b, a]: [f32; 4]| {
                let color = [r, g, b].map(logit::color_of_part);
                (logit::of_part(a.clamp(0.0, 1.0)), color)
            };
            all.colors()?.into_iter().map(split).unzip()
        }
    };
    let Harmonics {
        degree,
        coefficient,
    } = all.harmonics(&names.harmonics)?;
    let splats = Splats {
        position: all.rows("POSITION")?,
        rotation: rotation
            .into_iter()
            .map(|[x, y, z, w]| [w, x, y, z])
            .collect(),
        log_scale: all
            .rows::<3>(&names.scale)?
            .into_iter()
            .map(|row| row.map(f32::ln))
            .collect(),
        opacity,
        color,
        degree,
        harmonics: coefficient,
        up: Up::Y,
        filter: Filter::DEFAULT,
    };
    let draft = names.opacity.is_none().then(|| Assumption {
        what: "attributes",
        taken: format!("{COLOR}, _ROTATION and _SCALE"),
        because: format!("the file is of a draft of {EXTENSION}"),
    });
    Ok(Found {
        splats,
        assumptions: draft
            .into_iter()
            .chain(passed_over(primitive, degree))
            .collect(),
    })
}

/// Says which attributes are none of splats'. `degree`: of the harmonics that were read.
fn passed_over(primitive: &Primitive, degree: usize) -> Option<Assumption> {
    let is_read = |name: &str| {
        let own = name
            .strip_prefix(EXTENSION)
            .map(|rest| rest.trim_start_matches(':'));
        let own = own.or(name.strip_prefix('_')).unwrap_or(name);
        match own.strip_prefix("SH_DEGREE_") {
            Some(band) => (0..=degree).any(|known| band.starts_with(&known.to_string())),
            // Beside splats' own what points have where the extension is not known.
            None => [
                "POSITION", "ROTATION", "SCALE", "OPACITY", COLOR, "NORMAL", "TANGENT",
            ]
            .contains(&own),
        }
    };
    let others = primitive.attributes.keys().filter(|name| !is_read(name));
    let others: Vec<String> = others.map(|name| excerpt(name)).collect();
    (!others.is_empty()).then(|| Assumption {
        what: "attributes",
        taken: format!("{} left out", others.join(", ")),
        because: format!("they are none of {EXTENSION} up to degree 3"),
    })
}
