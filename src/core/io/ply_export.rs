//! Writing of splats as a 3DGS `.ply`.

use super::{
    ply::UP_COMMENT,
    splats::{Splats, Up, functions_of},
};

/// Smallest logarithm of a standard deviation that is written: a nanometre, since a file that other
/// programs read has finite numbers.
const MIN_LOG_SCALE: f32 = -20.723_266;
/// Opacities stay this far from 0 and 1, whose logits are infinite: a quarter of a step of 8 bits,
/// so that they read back as the same 8 bits.
const MIN_OPACITY: f64 = 0.25 / 255.0;

/// The bytes of a file with the splats in their order, lengths in metres. A comment names the axis
/// that points up.
pub fn to_ply(splats: &Splats) -> Vec<u8> {
    let functions = functions_of(splats.degree);
    let mut names: Vec<String> = [
        "x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2",
    ]
    .map(String::from)
    .into();
    names.extend((0..3 * functions).map(|k| format!("f_rest_{k}")));
    names.extend(
        [
            "opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3",
        ]
        .map(String::from),
    );
    let properties: String = names
        .iter()
        .map(|name| format!("property float {name}\n"))
        .collect();
    let count = splats.len();
    let up = Up::ALL.iter().position(|&up| up == splats.up);
    let up = Up::NAMES[up.unwrap_or_default()];
    let header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment written by Effigy, lengths in metres\ncomment {UP_COMMENT} {up}\n\
         element vertex {count}\n{properties}end_header\n"
    );
    let mut bytes = header.into_bytes();
    bytes.reserve(4 * names.len() * count);
    let limit = ((1.0 - MIN_OPACITY) / MIN_OPACITY).ln() as f32;
    for vertex in 0..count {
        let rest = &splats.harmonics[functions * vertex..][..functions];
        // All reds come first, then all greens, then all blues.
        let rest = (0..3).flat_map(|channel| rest.iter().map(move |rgb| rgb[channel]));
        let numbers = splats.position[vertex]
            .into_iter()
            .chain([0.0; 3])
            .chain(splats.color[vertex])
            .chain(rest)
            .chain([finite_logit(splats.opacity[vertex], limit)])
            .chain(splats.log_scale[vertex].map(|s| s.max(MIN_LOG_SCALE)))
            .chain(splats.rotation[vertex]);
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
    }
    bytes
}

/// A logit as it is, but for the infinite ones of 0 and 1.
fn finite_logit(logit: f32, limit: f32) -> f32 {
    if logit.is_finite() {
        logit
    } else {
        logit.clamp(-limit, limit)
    }
}
