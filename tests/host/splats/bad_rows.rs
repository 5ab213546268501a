//! A splat that can't be drawn is left out and counted, in every format that can hold one.

use super::{
    COMPRESSED, File, GLB, KSPLAT_0, MANY, SPLAT, SPZ_1, TRUTH,
    hostile::{gunzip, gzip},
};
use effigy_formats::splats::{self, Nothing, SplatFormat};

/// Reads a file, and checks that it lacks one splat of those that the file had.
fn lacks(bytes: &[u8], whole: &File, number: usize, why: &str) {
    let found = splats::read(bytes, whole.format, &mut Nothing).expect(whole.name);
    let all = whole.read();
    let mut expected = all.part(0..number);
    if number + 1 < all.len() {
        expected = expected.joined(all.part(number + 1..all.len()));
    }
    assert_eq!(found.splats, expected, "{}", whole.name);
    let lines: Vec<String> = found.assumptions.iter().map(ToString::to_string).collect();
    let expected = format!("1 of {} left out (number {number} has {why}", all.len());
    assert!(
        lines.iter().any(|line| line.contains(&expected)),
        "{}: {lines:?}",
        whole.name
    );
}

fn with(bytes: &[u8], at: usize, new: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[at..][..new.len()].copy_from_slice(new);
    bytes
}

fn rows_of_every_format_are_left_out() {
    let nan = f32::NAN.to_le_bytes();
    let negative = (-1f32).to_le_bytes();
    lacks(
        &with(SPLAT.bytes, 32 * 5, &nan),
        &SPLAT,
        5,
        "NaN in the position",
    );
    lacks(
        &with(SPLAT.bytes, 32 * 63 + 16, &negative),
        &SPLAT,
        63,
        "NaN in the scale",
    );
    // 44 bytes a splat and 96 of its harmonics, behind two headers.
    let row = |k: usize| 4096 + 1024 + (44 + 96) * k;
    lacks(
        &with(KSPLAT_0.bytes, row(9) + 4, &nan),
        &KSPLAT_0,
        9,
        "NaN in the position",
    );
    lacks(
        &with(KSPLAT_0.bytes, row(0) + 24, &[0; 16]),
        &KSPLAT_0,
        0,
        "a quaternion of length 0",
    );
    lacks(
        &with(KSPLAT_0.bytes, row(3) + 44 + 92, &nan),
        &KSPLAT_0,
        3,
        "NaN in the harmonics",
    );
    let infinite = half::f16::INFINITY.to_le_bytes();
    let spz = with(&gunzip(SPZ_1.bytes), 16 + 6 * 7, &infinite);
    lacks(&gzip(&spz), &SPZ_1, 7, "inf in the position");
    let end = TRUTH.bytes.len();
    lacks(
        &with(TRUTH.bytes, end - 16, &[0; 16]),
        &TRUTH,
        63,
        "a quaternion of length 0",
    );
}

fn rows_of_gltf_are_left_out() {
    let place = GLB.read().position[11].map(f32::to_le_bytes).concat();
    let at = GLB.bytes.windows(12).position(|bytes| bytes == place);
    let bytes = with(
        GLB.bytes,
        at.expect("a node that moves nothing") + 4,
        &f32::NAN.to_le_bytes(),
    );
    lacks(&bytes, &GLB, 11, "NaN in the position");
}

fn whole_chunks_may_be_bad_and_a_whole_file_may_not() {
    let min_x = COMPRESSED
        .bytes
        .windows(11)
        .position(|w| w == b"end_header\n")
        .unwrap()
        + 11;
    let bytes = with(COMPRESSED.bytes, min_x, &f32::NAN.to_le_bytes());
    let refused = splats::read(&bytes, SplatFormat::Ply, &mut Nothing).unwrap_err();
    assert!(
        refused.to_string().contains("none of 64 that can be drawn"),
        "{refused}"
    );
    let min_x = MANY
        .bytes
        .windows(11)
        .position(|w| w == b"end_header\n")
        .unwrap()
        + 11;
    let bytes = with(MANY.bytes, min_x, &f32::NAN.to_le_bytes());
    let found = splats::read(&bytes, SplatFormat::Ply, &mut Nothing).unwrap();
    assert_eq!(found.splats.len() + 256, MANY.read().len());
}

tests! {
    rows_of_every_format_are_left_out,
    rows_of_gltf_are_left_out,
    whole_chunks_may_be_bad_and_a_whole_file_may_not,
}
