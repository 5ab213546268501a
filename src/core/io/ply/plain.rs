//! The vertices of a 3DGS `.ply`.

use super::table::{Column, Table};
use crate::{
    avatar::Filter,
    io::{
        file::FormatError,
        splats::{Splats, Up, functions_of},
    },
};

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
    fn new(rows: &Table) -> Result<Self, FormatError> {
        let column = |name: &str| {
            let expected = "one, as 3DGS writes it: a mesh or a point cloud has no splats";
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
        let degree = (0..=3).find(|&degree| 3 * functions_of(degree) == count);
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

/// The splats of all vertices.
///
/// # Errors
/// When a property is missing.
pub fn read(rows: &Table, up: Up) -> Result<Splats, FormatError> {
    let columns = Columns::new(rows)?;
    let vertices = 0..rows.len();
    let mut harmonics = Vec::with_capacity(columns.rest.len() * rows.len());
    for vertex in vertices.clone() {
        let row = columns.rest.iter();
        harmonics.extend(row.map(|&rgb| rows.values(vertex, rgb)));
    }
    let opacity = |vertex| rows.value(vertex, columns.opacity) as f32;
    Ok(Splats {
        position: rows.all(columns.position),
        rotation: rows.all(columns.rotation),
        log_scale: rows.all(columns.scale),
        opacity: vertices.map(opacity).collect(),
        color: rows.all(columns.color),
        degree: columns.degree,
        harmonics,
        up,
        filter: Filter::DEFAULT,
    })
}
