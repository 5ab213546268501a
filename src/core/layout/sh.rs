//! Packing of spherical harmonics for the shaders.

use crate::avatar::{Avatar, ShCoefficients, limits};
use half::f16;

/// Functions of a group, whose RGB coefficients fill three half quads.
const GROUP: usize = 4;
/// Groups in the first of the two buffers; the second has the others.
pub const SPLIT: usize = 2;

/// Bytes of a group's half quads.
const GROUP_BYTES: usize = 2 * 3 * GROUP;
const _: () = assert!(
    SPLIT * GROUP_BYTES * limits::GAUSSIANS <= 128 << 20,
    "128 MiB is the range of a storage buffer everywhere"
);

/// Groups of functions up to a degree, the constant function included.
pub fn groups(degree: usize) -> usize {
    (degree + 1).pow(2).div_ceil(GROUP)
}

/// Packs a range of groups into planes of half quads, one entry a Gaussian; see
/// `shaders/sh/sh.comp`.
pub fn planes(
    avatar: &Avatar,
    sh: &ShCoefficients,
    groups: std::ops::Range<usize>,
) -> Vec<[f16; 4]> {
    let count = avatar.gaussians.len();
    let functions = sh.functions();
    let mut data = vec![[f16::ZERO; 4]; 3 * groups.len() * count];
    for gaussian in 0..count {
        let neutral = std::iter::once(&avatar.gaussians.color[gaussian]);
        let all = neutral.chain(&sh.coefficients[gaussian * functions..][..functions]);
        let within = all.skip(GROUP * groups.start).take(GROUP * groups.len());
        for (at, &value) in within.flatten().enumerate() {
            data[at / 4 * count + gaussian][at % 4] = value;
        }
    }
    data
}

/// Device memory that an avatar's spherical harmonics take, bytes.
pub fn bytes(avatar: &Avatar) -> u64 {
    match &avatar.sh {
        Some(sh) => (GROUP_BYTES * groups(sh.degree) * avatar.gaussians.len()) as u64,
        None => 0,
    }
}
