//! SuperSplat's compressed `.ply`: the numbers of 256 vertices each are codes between the extremes
//! that an entry of the element `chunk` has.
//!
//! | property | bits from the top | codes of |
//! |---|---|---|
//! | `packed_position` | 11, 10, 11 | x, y, z between the chunk's `min_x`… and `max_x`… |
//! | `packed_rotation` | 2, 10, 10, 10 | the index of the largest of w x y z; the others, in order, from −√½ to √½ |
//! | `packed_scale` | 11, 10, 11 | logarithms between `min_scale_x`… and `max_scale_x`… |
//! | `packed_color` | 8, 8, 8, 8 | RGB between `min_r`… and `max_r`…, or 0 and 1 in older files; opacity from 0 to 1 |
//!
//! Harmonics, in the element `sh`, are bytes, a 256th of −4 to 4 each.

use super::{
    header::PlyHeader,
    table::{Column, ElementTable},
};
use crate::{
    avatar::{Filter, ShCoefficients},
    io::{
        file::FormatError,
        splats::{Found, Splats, Up, functions_of},
    },
};
use std::f32::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Vertices that share a chunk.
const CHUNK: usize = 256;

/// Whether a file's vertices are codes.
pub fn is_compressed(header: &PlyHeader) -> bool {
    let mut names = header.vertices.properties.iter();
    names.any(|property| property.name == "packed_position")
}

/// The smallest and largest numbers of a chunk, from code 0 to the highest.
#[derive(Clone, Copy)]
struct CodeRange {
    min: [f32; 3],
    max: [f32; 3],
}

impl CodeRange {
    const UNIT: Self = Self {
        min: [0.0; 3],
        max: [1.0; 3],
    };

    fn at(&self, part: [f32; 3]) -> [f32; 3] {
        std::array::from_fn(|k| self.min[k] * (1.0 - part[k]) + self.max[k] * part[k])
    }
}

/// The ranges of the numbers in a chunk.
struct ChunkRanges {
    position: CodeRange,
    scale: CodeRange,
    color: CodeRange,
}

/// Reads the splats. Opacities of code 0 and 255 have infinite logits.
///
/// # Errors
/// When an element or property is missing, or the elements' lengths do not fit each other.
pub fn read(bytes: &[u8], header: &PlyHeader, up: Up) -> Result<Found, FormatError> {
    let vertices = ElementTable::new(bytes, header, &header.vertices)?;
    let count = vertices.len();
    let chunks = header
        .chunks
        .as_ref()
        .ok_or_else(|| FormatError::container("no element `chunk`", "that of a compressed .ply"))?;
    if chunks.count != count.div_ceil(CHUNK) as u64 {
        return Err(FormatError::container(
            format!("{} chunks for {count} vertices", chunks.count),
            format!("one for each {CHUNK}"),
        ));
    }
    let chunks = read_chunks(&ElementTable::new(bytes, header, chunks)?)?;
    let [position, rotation, scale, color] = [
        packed(&vertices, "packed_position")?,
        packed(&vertices, "packed_rotation")?,
        packed(&vertices, "packed_scale")?,
        packed(&vertices, "packed_color")?,
    ];
    let code = |vertex, column| vertices.value(vertex, column) as u32;
    let chunk = |vertex| &chunks[vertex / CHUNK];
    let harmonics = read_harmonics(bytes, header, count)?;
    let all = 0..count;
    let splats = Splats {
        position: all
            .clone()
            .map(|k| chunk(k).position.at(three(code(k, position))))
            .collect(),
        rotation: all.clone().map(|k| quaternion(code(k, rotation))).collect(),
        log_scale: all
            .clone()
            .map(|k| chunk(k).scale.at(three(code(k, scale))))
            .collect(),
        opacity: all.clone().map(|k| logit(code(k, color) & 0xff)).collect(),
        color: all
            .map(|k| {
                let code = code(k, color);
                let bytes = [code >> 24, code >> 16 & 0xff, code >> 8 & 0xff];
                let rgb = chunk(k).color.at(bytes.map(|byte| byte as f32 / 255.0));
                rgb.map(|c| (c - 0.5) / ShCoefficients::CONSTANT as f32)
            })
            .collect(),
        degree: harmonics.degree,
        harmonics: harmonics.rows,
        up,
        filter: Filter::DEFAULT,
    };
    Ok(Found {
        splats,
        assumptions: vertices.passed_over().into_iter().collect(),
    })
}

fn read_chunks(rows: &ElementTable) -> Result<Vec<ChunkRanges>, FormatError> {
    let range = |names: [&str; 3]| {
        let ends = ["min", "max"].map(|end| {
            let [a, b, c] = names.map(|name| rows.column(&format!("{end}_{name}")));
            Some([a?, b?, c?])
        });
        let [min, max] = [ends[0]?, ends[1]?];
        let (min, max) = (rows.all(min), rows.all(max));
        let ranges = min.into_iter().zip(max);
        Some(ranges.map(|(min, max)| CodeRange { min, max }).collect())
    };
    let missing = || {
        FormatError::container(
            "chunks without all their extremes",
            "min_x to max_z and min_scale_x to max_scale_z",
        )
    };
    let position: Vec<CodeRange> = range(["x", "y", "z"]).ok_or_else(missing)?;
    let scale: Vec<CodeRange> = range(["scale_x", "scale_y", "scale_z"]).ok_or_else(missing)?;
    let color = range(["r", "g", "b"]).unwrap_or_else(|| vec![CodeRange::UNIT; rows.len()]);
    let chunks = position.into_iter().zip(scale).zip(color);
    Ok(chunks
        .map(|((position, scale), color)| ChunkRanges {
            position,
            scale,
            color,
        })
        .collect())
}

/// A property whose numbers are codes of 32 bits.
fn packed(vertices: &ElementTable, name: &str) -> Result<Column, FormatError> {
    vertices.column(name).ok_or_else(|| {
        FormatError::container(
            format!("no `{name}` among the properties"),
            "those of a compressed .ply",
        )
    })
}

/// Codes of 11, 10 and 11 bits, from 0 to 1.
fn three(code: u32) -> [f32; 3] {
    [
        (code >> 21) as f32 / 2047.0,
        (code >> 11 & 1023) as f32 / 1023.0,
        (code & 2047) as f32 / 2047.0,
    ]
}

fn quaternion(code: u32) -> [f32; 4] {
    let small = [code >> 20, code >> 10, code]
        .map(|bits| ((bits & 1023) as f32 / 1023.0 - 0.5) * SQRT_2)
        .map(|v| v.clamp(-FRAC_1_SQRT_2, FRAC_1_SQRT_2));
    let largest = (code >> 30) as usize;
    let rest = 1.0 - small.iter().map(|v| v * v).sum::<f32>();
    let mut small = small.into_iter();
    std::array::from_fn(|k| {
        if k == largest {
            rest.max(0.0).sqrt()
        } else {
            small.next().unwrap_or_default()
        }
    })
}

fn logit(byte: u32) -> f32 {
    let byte = byte as f32;
    (byte / (255.0 - byte)).ln()
}

/// Spherical harmonics above degree 0, a row each.
struct ShRows {
    degree: usize,
    rows: Vec<[f32; 3]>,
}

fn read_harmonics(bytes: &[u8], header: &PlyHeader, count: usize) -> Result<ShRows, FormatError> {
    let Some(element) = &header.harmonics else {
        return Ok(ShRows {
            degree: 0,
            rows: vec![],
        });
    };
    let rows = ElementTable::new(bytes, header, element)?;
    let properties = rows.numbered("f_rest_");
    let degree = (1..=3).find(|&degree| 3 * functions_of(degree) == properties);
    let columns: Option<Vec<Column>> = (0..properties)
        .map(|k| rows.column(&format!("f_rest_{k}")))
        .collect();
    let (Some(degree), Some(columns), true) = (degree, columns, rows.len() == count) else {
        return Err(FormatError::container(
            format!("{} harmonics of {properties} numbers", rows.len()),
            format!("{count} of 9, 24 or 45"),
        ));
    };
    let functions = functions_of(degree);
    let value = |vertex, column| {
        // The codes' ends are the range's; the others are the middles of their 256ths.
        let part = match rows.value(vertex, column) as f32 {
            0.0 => 0.0,
            255.0 => 1.0,
            code => (code + 0.5) / 256.0,
        };
        8.0 * (part - 0.5)
    };
    let mut values = Vec::with_capacity(functions * count);
    for vertex in 0..count {
        values.extend(
            (0..functions)
                .map(|k| [0, 1, 2].map(|channel| value(vertex, columns[channel * functions + k]))),
        );
    }
    Ok(ShRows {
        degree,
        rows: values,
    })
}
