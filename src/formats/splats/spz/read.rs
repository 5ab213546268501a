//! Splats of an unpacked file.

use super::super::{bytes::array, logit};
use super::{codes, container};
use crate::assumption::Assumption;
use effigy_core::{
    avatar::Filter,
    io::{
        file::FormatError,
        splats::{Found, Splats, functions_of},
    },
};
use half::f16;

/// Highest degree that splats have.
const DEGREE: usize = 3;

/// Reads a file.
///
/// # Errors
/// When it is none, is cut off, or unpacks to something else than it says.
pub fn read(bytes: &[u8]) -> Result<Found, FormatError> {
    let file = container::unpack(bytes)?;
    let position = |k: usize| {
        if file.version == 1 {
            [0, 1, 2].map(|axis| {
                let at = 6 * k + 2 * axis;
                f16::from_le_bytes(array(&file.position, at)).to_f32()
            })
        } else {
            [0, 1, 2]
                .map(|axis| codes::fixed(array(&file.position, 9 * k + 3 * axis), file.fraction))
        }
    };
    let rotation = |k: usize| {
        if file.version < 3 {
            codes::rotation_of_bytes(array(&file.rotation, 3 * k))
        } else {
            codes::rotation(u32::from_le_bytes(array(&file.rotation, 4 * k)))
        }
    };
    let degree = file.degree.min(DEGREE);
    let stored = 3 * functions_of(file.degree);
    let kept = functions_of(degree);
    let mut harmonics = Vec::with_capacity(kept * file.count);
    if degree > 0 {
        for row in file.harmonics.chunks_exact(stored) {
            harmonics.extend((0..kept).map(|k| array::<3>(row, 3 * k).map(codes::harmonic)));
        }
    }
    let all = 0..file.count;
    let splats = Splats {
        position: all.clone().map(position).collect(),
        rotation: all.clone().map(rotation).collect(),
        log_scale: all
            .clone()
            .map(|k| array::<3>(&file.log_scale, 3 * k).map(codes::log_scale))
            .collect(),
        opacity: file
            .opacity
            .iter()
            .map(|&byte| logit::of_byte(byte))
            .collect(),
        color: all
            .map(|k| array::<3>(&file.color, 3 * k).map(codes::color))
            .collect(),
        degree,
        harmonics,
        up: file.up,
        filter: if file.antialiased {
            Filter::ANTIALIASED
        } else {
            Filter::DEFAULT
        },
    };
    let left_out = (file.degree > DEGREE).then(|| Assumption {
        what: "spherical harmonics",
        taken: format!("degrees 0 to {DEGREE}"),
        because: format!("those of degree {} are left out", file.degree),
    });
    Ok(Found {
        splats,
        assumptions: left_out.into_iter().collect(),
    })
}
