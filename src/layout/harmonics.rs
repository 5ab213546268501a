//! The coefficients of view-dependent colours as the shaders read them.

use crate::avatar::{Avatar, Harmonics as Coefficients, limits};
use half::f16;

/// Functions that three half quads hold the RGB of.
const GROUP: usize = 4;
/// Groups in the first of the two buffers.
pub const SPLIT: usize = 2;

/// Bytes of a group's half quads.
const GROUP_BYTES: usize = 2 * 3 * GROUP;
const _: () = assert!(SPLIT * GROUP_BYTES * limits::GAUSSIANS <= 128 << 20, "128 MiB is the range of a storage buffer everywhere");

/// Groups of functions up to a degree, the constant one among them.
pub fn groups(degree: usize) -> usize {
    (degree + 1).pow(2).div_ceil(GROUP)
}

/// Planes of half quads, one entry a Gaussian; see `shaders/harmonics.comp`.
pub fn planes(avatar: &Avatar, harmonics: &Coefficients, groups: std::ops::Range<usize>) -> Vec<[f16; 4]> {
    let (count, functions) = (avatar.gaussians.len(), harmonics.functions());
    let mut data = vec![[f16::ZERO; 4]; 3 * groups.len() * count];
    for gaussian in 0..count {
        let neutral = std::iter::once(&avatar.gaussians.color[gaussian]);
        let all = neutral.chain(&harmonics.coefficients[gaussian * functions..][..functions]);
        let within = all.skip(GROUP * groups.start).take(GROUP * groups.len());
        for (at, &value) in within.flatten().enumerate() {
            data[at / 4 * count + gaussian][at % 4] = value;
        }
    }
    data
}

/// Device memory that an avatar's harmonics take, bytes.
pub fn bytes(avatar: &Avatar) -> u64 {
    avatar.harmonics.as_ref().map_or(0, |harmonics| (GROUP_BYTES * groups(harmonics.degree) * avatar.gaussians.len()) as u64)
}
