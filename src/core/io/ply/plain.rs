//! The vertices of a 3DGS `.ply`, and of programs that grew from 3DGS.

use super::{
    header::Scalar,
    table::{Column, ElementTable},
};
use crate::{
    avatar::{Filter, ShCoefficients},
    io::{
        assumption::Assumption,
        file::FormatError,
        splats::{Found, Splats, Up, far_middle, functions_of, moved},
    },
};

/// The logarithm of the third deviation of a disc, 1e-6 m.
const FLAT: f32 = -13.815_511;
/// The names of a Gaussian's properties.
const EXPECTED: &str =
    "x y z, scale_0 to scale_2, rot_0 to rot_3, opacity and f_dc_0 to f_dc_2, as 3DGS writes them";

/// The columns of a Gaussian's properties.
struct GaussianColumns {
    position: [Column; 3],
    /// w x y z
    rotation: [Column; 4],
    /// Three; two of discs, one of balls.
    scale: Vec<Column>,
    opacity: Column,
    color: Color,
    degree: usize,
    /// RGB of each spherical harmonic above degree 0.
    rest: Vec<[Column; 3]>,
    /// The deviation of a ball that each Gaussian is blurred by, metres: Mip-Splatting's.
    filter: Option<Column>,
}

/// What colours are.
enum Color {
    /// Coefficients of degree 0.
    Coefficients([Column; 3]),
    /// RGB.
    Plain([Column; 3]),
}

/// A property that every Gaussian has.
fn need(rows: &ElementTable, name: &str) -> Result<Column, FormatError> {
    rows.column(name).ok_or_else(|| {
        let has = |name: &&str| rows.has(name);
        let is_mesh = !["opacity", "scale_0", "rot_0", "f_dc_0"].iter().any(has);
        let mesh = if is_mesh {
            "; a mesh or a point cloud has no splats"
        } else {
            ""
        };
        FormatError::container(
            format!("no `{name}` among the properties {}", rows.names()),
            format!("{EXPECTED}{mesh}"),
        )
    })
}

impl GaussianColumns {
    fn new(rows: &ElementTable) -> Result<Self, FormatError> {
        let column = |name: &str| need(rows, name);
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
        let scales = rows.numbered("scale_").clamp(1, 3);
        let scale = (0..scales).map(|k| column(&format!("scale_{k}")));
        Ok(Self {
            position: [column("x")?, column("y")?, column("z")?],
            rotation: [
                column("rot_0")?,
                column("rot_1")?,
                column("rot_2")?,
                column("rot_3")?,
            ],
            scale: scale.collect::<Result<_, FormatError>>()?,
            opacity: column("opacity")?,
            color: Color::find(rows)?,
            degree,
            rest: (0..plane).map(rest).collect::<Result<_, FormatError>>()?,
            filter: rows.column("filter_3D"),
        })
    }

    fn position(&self, rows: &ElementTable, assumptions: &mut Vec<Assumption>) -> Vec<[f32; 3]> {
        // f32 has no place for centimetres that far out.
        let exact = |vertex| self.position.map(|column| rows.value(vertex, column));
        match far_middle(rows.len(), exact) {
            None => rows.all(self.position),
            Some(middle) => {
                assumptions.push(moved(middle));
                let near = |k| {
                    let at = exact(k);
                    [0, 1, 2].map(|axis| (at[axis] - middle[axis]) as f32)
                };
                (0..rows.len()).map(near).collect()
            }
        }
    }

    fn log_scale(&self, rows: &ElementTable, assumptions: &mut Vec<Assumption>) -> Vec<[f32; 3]> {
        let mut shape = |taken: &str, columns: &str| {
            assumptions.push(Assumption {
                what: "shape",
                taken: taken.into(),
                because: format!("of scales the file has {columns} alone"),
            });
        };
        match self.scale[..] {
            [x, y, z] => rows.all([x, y, z]),
            [x, y] => {
                shape("discs, 1e-6 m thick", "scale_0 and scale_1");
                let discs = rows.all([x, y]).into_iter();
                discs.map(|[x, y]| [x, y, FLAT]).collect()
            }
            _ => {
                shape("balls", "scale_0");
                rows.all([self.scale[0]; 3])
            }
        }
    }
}

impl Color {
    fn find(rows: &ElementTable) -> Result<Self, FormatError> {
        for names in [["red", "green", "blue"], ["r", "g", "b"]] {
            let has = |name: &&str| rows.has(name);
            if !rows.has("f_dc_0") && names.iter().all(has) {
                let [r, g, b] = names;
                return Ok(Self::Plain([
                    need(rows, r)?,
                    need(rows, g)?,
                    need(rows, b)?,
                ]));
            }
        }
        let [r, g, b] = ["f_dc_0", "f_dc_1", "f_dc_2"];
        Ok(Self::Coefficients([
            need(rows, r)?,
            need(rows, g)?,
            need(rows, b)?,
        ]))
    }

    fn coefficients(
        &self,
        rows: &ElementTable,
        assumptions: &mut Vec<Assumption>,
    ) -> Vec<[f32; 3]> {
        let columns = match *self {
            Self::Coefficients(columns) => return rows.all(columns),
            Self::Plain(columns) => columns,
        };
        let colors: Vec<[f32; 3]> = rows.all(columns);
        let most = most_of(colors.as_flattened());
        let full = match columns[0].declared {
            Scalar::I16 if most > 255.0 => 32_767.0,
            Scalar::U16 if most > 255.0 => 65_535.0,
            Scalar::F32 | Scalar::F64 if most <= 1.0 => 1.0,
            _ => 255.0,
        };
        assumptions.push(Assumption {
            what: "colour",
            taken: format!("red, green and blue from 0 to {full}"),
            because: "the file has no f_dc".into(),
        });
        let coefficient = |c: f32| ((f64::from(c) / full - 0.5) / ShCoefficients::CONSTANT) as f32;
        colors.into_iter().map(|rgb| rgb.map(coefficient)).collect()
    }
}

/// What 95 % of some numbers are at most, so that a few broken ones don't count.
fn most_of(numbers: &[f32]) -> f32 {
    let mut numbers: Vec<f32> = numbers.iter().copied().filter(|c| c.is_finite()).collect();
    let at = (numbers.len() * 95 / 100).min(numbers.len().saturating_sub(1));
    match numbers.is_empty() {
        true => 0.0,
        false => *numbers.select_nth_unstable_by(at, f32::total_cmp).1,
    }
}

/// Blurs Gaussians by balls, so that each keeps its mass: variances add up, and opacities fall as
/// the volume grows.
fn fuse(splats: &mut Splats, rows: &ElementTable, filter: Column, scales: usize) {
    // A ball has one scale for all of its axes.
    let axes = if scales == 2 { 2 } else { 3 };
    for k in 0..splats.len() {
        let square = rows.value(k, filter).powi(2);
        let mut part = 1.0;
        // A disc's thickness is none of the file's.
        for log_scale in &mut splats.log_scale[k][..axes] {
            let variance = (2.0 * f64::from(*log_scale)).exp();
            let fused = variance + square;
            if fused > 0.0 {
                part *= (variance / fused).sqrt();
            }
            *log_scale = (0.5 * fused.ln()) as f32;
        }
        let opacity = part / (1.0 + (-f64::from(splats.opacity[k])).exp());
        splats.opacity[k] = (opacity / (1.0 - opacity)).ln() as f32;
    }
}

/// The splats of all vertices.
///
/// # Errors
/// When a property is missing.
pub fn read(rows: &ElementTable, up: Up) -> Result<Found, FormatError> {
    let columns = GaussianColumns::new(rows)?;
    let vertices = 0..rows.len();
    let mut harmonics = Vec::with_capacity(columns.rest.len() * rows.len());
    for vertex in vertices.clone() {
        let row = columns.rest.iter();
        harmonics.extend(row.map(|&rgb| rows.values(vertex, rgb)));
    }
    let mut assumptions = vec![];
    let opacity = |vertex| rows.value(vertex, columns.opacity) as f32;
    let mut splats = Splats {
        position: columns.position(rows, &mut assumptions),
        rotation: rows.all(columns.rotation),
        log_scale: columns.log_scale(rows, &mut assumptions),
        opacity: vertices.map(opacity).collect(),
        color: columns.color.coefficients(rows, &mut assumptions),
        degree: columns.degree,
        harmonics,
        up,
        filter: Filter::DEFAULT,
    };
    if let Some(filter) = columns.filter {
        fuse(&mut splats, rows, filter, columns.scale.len());
        assumptions.push(Assumption {
            what: "column filter_3D",
            taken: "in scales and opacities".into(),
            because: "Mip-Splatting keeps it beside them".into(),
        });
    }
    assumptions.extend(rows.passed_over());
    Ok(Found {
        splats,
        assumptions,
    })
}

#[cfg(test)]
mod tests {
    use super::most_of;

    #[test]
    fn a_few_broken_numbers_decide_nothing() {
        let mut numbers = vec![0.9; 100];
        numbers[..4].copy_from_slice(&[1.02, 1e30, f32::INFINITY, f32::NAN]);
        assert_eq!(most_of(&numbers), 0.9);
        assert_eq!(most_of(&[0.3, 200.0]), 200.0);
        assert_eq!(most_of(&[f32::NAN]), 0.0);
        assert_eq!(most_of(&[]), 0.0);
    }
}
