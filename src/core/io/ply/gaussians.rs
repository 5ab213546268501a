//! Conversion of 3DGS vertices into an avatar's Gaussians, in the order of a space-filling curve,
//! so that neighbours in memory are neighbours in space.

use super::vertices::{Column, VertexTable};
use crate::{
    avatar::{Bounds, Gaussians, ShCoefficients, limits},
    constants::F16_MAX,
    io::file::FormatError,
};
use glam::DVec3;
use half::f16;
use rayon::prelude::*;

/// Log scales are clamped to ±this: from nanometres to more than any scene.
const LOG_SCALE_LIMIT: f64 = 20.0;

/// The properties of a Gaussian.
struct Columns {
    position: [Column; 3],
    /// w x y z
    rotation: [Column; 4],
    scale: [Column; 3],
    opacity: Column,
    color: [Column; 3],
    degree: usize,
    /// RGB of each spherical harmonic above degree 0.
    rest: Vec<[Column; 3]>,
}

impl Columns {
    fn new(rows: &VertexTable) -> Result<Self, FormatError> {
        if rows.column("packed_position").is_some() {
            let expected = "a plain 3DGS .ply: convert the file, for instance with splat-transform";
            return Err(FormatError::container("a compressed .ply", expected));
        }
        let column = |name: &str| {
            let expected = "a property of that name, as 3DGS writes it";
            rows.column(name).ok_or_else(|| {
                FormatError::container(format!("no `{name}` among the properties"), expected)
            })
        };
        let position = [column("x")?, column("y")?, column("z")?];
        let three = |name: &str| {
            Ok([
                column(&format!("{name}_0"))?,
                column(&format!("{name}_1"))?,
                column(&format!("{name}_2"))?,
            ])
        };
        let count = rows.numbered("f_rest_");
        let degree = (0..=3usize).find(|degree| 3 * ((degree + 1).pow(2) - 1) == count);
        let degree = degree.ok_or_else(|| {
            FormatError::container(
                format!("{count} properties f_rest"),
                "0, 9, 24 or 45: harmonics of degree 0, 1, 2 or 3",
            )
        })?;
        // All reds come first, then all greens, then all blues.
        let plane = count / 3;
        let rest = |k: usize| {
            let channel = |channel: usize| column(&format!("f_rest_{}", channel * plane + k));
            Ok([channel(0)?, channel(1)?, channel(2)?])
        };
        Ok(Self {
            position,
            rotation: [
                column("rot_0")?,
                column("rot_1")?,
                column("rot_2")?,
                column("rot_3")?,
            ],
            scale: three("scale")?,
            opacity: column("opacity")?,
            color: three("f_dc")?,
            degree,
            rest: (0..plane).map(rest).collect::<Result<_, FormatError>>()?,
        })
    }
}

/// A converted Gaussian, except its position.
struct Converted {
    rotation: [f16; 4],
    log_scale: [f16; 3],
    color: [f16; 3],
    opacity: u8,
}

/// Converts all vertices; the spherical harmonics are None if there are none above degree 0.
///
/// # Errors
/// When a property is missing, or a number is not finite or out of bounds.
pub fn read(rows: &VertexTable) -> Result<(Gaussians, Option<ShCoefficients>), FormatError> {
    let columns = Columns::new(rows)?;
    let count = rows.len();
    let positions = (0..count)
        .into_par_iter()
        .map(|vertex| position(rows, &columns, vertex))
        .collect::<Result<Vec<_>, _>>()?;
    let bounds = bounds(&positions);
    let mut order: Vec<(u64, u32)> = positions
        .par_iter()
        .zip(0..count as u32)
        .map(|(p, k)| (morton(bounds.encode(*p)), k))
        .collect();
    order.par_sort_unstable();
    let converted = order
        .par_iter()
        .map(|&(_, vertex)| convert(rows, &columns, vertex as usize))
        .collect::<Result<Vec<_>, _>>()?;
    let gaussians = Gaussians {
        bounds,
        position: order
            .par_iter()
            .map(|&(_, vertex)| bounds.encode(positions[vertex as usize]))
            .collect(),
        rotation: converted.iter().map(|gaussian| gaussian.rotation).collect(),
        log_scale: converted
            .iter()
            .map(|gaussian| gaussian.log_scale)
            .collect(),
        color: converted.iter().map(|gaussian| gaussian.color).collect(),
        opacity: converted.iter().map(|gaussian| gaussian.opacity).collect(),
        joint: vec![[0; 4]; count],
        joint_weight: vec![[255, 0, 0, 0]; count],
        node: vec![[0; 3]; count],
    };
    warn_of_coarse_steps(&gaussians);
    let mut coefficients = vec![[f16::ZERO; 3]; columns.rest.len() * count];
    let each = coefficients
        .par_chunks_mut(columns.rest.len().max(1))
        .zip(&order);
    each.try_for_each(|(row, &(_, vertex))| read_sh(rows, &columns, vertex as usize, row))?;
    let sh = (columns.degree > 0).then_some(ShCoefficients {
        degree: columns.degree,
        coefficients,
    });
    Ok((gaussians, sh))
}

/// Reads properties of a vertex; NaN and infinity are errors. `what`: their name in errors.
fn finite<const N: usize>(
    rows: &VertexTable,
    columns: [Column; N],
    vertex: usize,
    what: &str,
) -> Result<[f64; N], FormatError> {
    let values = columns.map(|column| rows.value(vertex, column));
    if let Some(bad) = values.iter().find(|value| !value.is_finite()) {
        return Err(FormatError::container(
            format!("{bad} in the {what} of vertex {vertex}"),
            "finite numbers",
        ));
    }
    Ok(values)
}

/// Reads and checks a vertex's position.
fn position(rows: &VertexTable, columns: &Columns, vertex: usize) -> Result<DVec3, FormatError> {
    let at = DVec3::from(finite(rows, columns.position, vertex, "position")?);
    if at.abs().max_element() > limits::LENGTH {
        let expected = format!("at most {} along each axis", limits::LENGTH);
        return Err(FormatError::container(
            format!("the position {at} of vertex {vertex}"),
            expected,
        ));
    }
    Ok(at)
}

/// The box around all positions; there is at least one.
fn bounds(positions: &[DVec3]) -> Bounds {
    let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let [min, max] = positions
        .iter()
        .fold(none, |[min, max], &p| [min.min(p), max.max(p)]);
    Bounds {
        min: min.as_vec3().to_array(),
        max: max.as_vec3().to_array(),
    }
}

/// Index along a Morton curve: the interleaved bits of the three coordinates.
fn morton(q: [u16; 3]) -> u64 {
    (0..16)
        .flat_map(|bit| (0..3).map(move |axis| (bit, axis)))
        .fold(0, |code, (bit, axis)| {
            code | u64::from(q[axis] >> bit & 1) << (3 * bit + axis)
        })
}

/// Rounds to f16; numbers beyond its range are clamped.
fn half(value: f64) -> f16 {
    f16::from_f64(value.clamp(-F16_MAX, F16_MAX))
}

/// Converts a vertex.
fn convert(rows: &VertexTable, columns: &Columns, vertex: usize) -> Result<Converted, FormatError> {
    let rotation = finite(rows, columns.rotation, vertex, "rotation")?;
    let length = rotation.iter().map(|v| v * v).sum::<f64>().sqrt();
    if !(length > 0.0 && length.is_finite()) {
        return Err(FormatError::container(
            format!("a quaternion of length {length} at vertex {vertex}"),
            "any other length",
        ));
    }
    let color = finite(rows, columns.color, vertex, "colour")?;
    // A deviation of 0 and an opacity of exactly 0 or 1 are infinite as 3DGS stores them.
    let scale = columns.scale.map(|column| rows.value(vertex, column));
    let opacity = rows.value(vertex, columns.opacity);
    if opacity.is_nan() || scale.iter().any(|s| s.is_nan() || *s == f64::INFINITY) {
        return Err(FormatError::container(
            format!("scale {scale:?} and opacity {opacity} of vertex {vertex}"),
            "finite numbers",
        ));
    }
    Ok(Converted {
        rotation: rotation.map(|v| half(v / length)),
        log_scale: scale.map(|s| half(s.clamp(-LOG_SCALE_LIMIT, LOG_SCALE_LIMIT))),
        color: color.map(|c| half(0.5 + ShCoefficients::CONSTANT * c)),
        opacity: (255.0 / (1.0 + (-opacity).exp())).round() as u8,
    })
}

/// Reads a vertex's spherical harmonics above degree 0 into a row.
fn read_sh(
    rows: &VertexTable,
    columns: &Columns,
    vertex: usize,
    row: &mut [[f16; 3]],
) -> Result<(), FormatError> {
    for (coefficient, &columns) in row.iter_mut().zip(&columns.rest) {
        *coefficient = finite(rows, columns, vertex, "harmonics")?.map(half);
    }
    Ok(())
}

/// Warns if positions are rounded to more than half of most Gaussians' diameter.
fn warn_of_coarse_steps(gaussians: &Gaussians) {
    let step = gaussians.bounds.step().max_element();
    let mut thin: Vec<f16> = gaussians
        .log_scale
        .iter()
        .map(|s| s[0].min(s[1]).min(s[2]))
        .collect();
    let middle = thin.len() / 2;
    let (_, median, _) = thin.select_nth_unstable_by(middle, f16::total_cmp);
    let median = median.to_f64().exp();
    if step > 0.5 * median {
        tracing::warn!(
            "positions are rounded to {:.2} mm, while the median Gaussian's thinnest axis measures {:.2} mm: a few far-off Gaussians may \
             stretch the box that positions are kept in; cut them off for an exact image",
            1e3 * step,
            1e3 * median
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_of_the_coordinates_take_turns() {
        assert_eq!(morton([1, 0, 0]), 1);
        assert_eq!(morton([0, 0b11, 0]), 0b010_010);
        assert_eq!(morton([0, 0, 1 << 15]), 1 << 47);
        assert_eq!(morton([u16::MAX; 3]), (1 << 48) - 1);
    }
}
