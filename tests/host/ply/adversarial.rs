//! What is wrong with a file is named; nothing in it makes the program panic or take memory that
//! the file does not justify.

use super::table::{Encoding, Table, read};
use crate::memory;
use effigy_core::{
    avatar::{Avatar, ShCoefficients, limits},
    io::ply,
};
use glam::DVec3;
use proptest::prelude::*;

fn numbers_beyond_what_is_stored_stay_finite() {
    let table = Table::new(2, 9, 1)
        .set(0, "opacity", f32::INFINITY)
        .set(1, "opacity", f32::NEG_INFINITY)
        .set(2, "scale_1", f32::NEG_INFINITY)
        .set(3, "scale_1", 1e30)
        .set(4, "f_dc_0", 1e30)
        .set(5, "f_rest_3", -1e30);
    let avatar = table.read(Encoding::Little).unwrap();
    assert!(avatar.gaussians.opacity.contains(&0) && avatar.gaussians.opacity.contains(&255));
    assert!(
        avatar
            .gaussians
            .log_scale
            .iter()
            .chain(&avatar.gaussians.color)
            .flatten()
            .all(|v| v.is_finite())
    );
    assert!(
        avatar
            .sh
            .unwrap()
            .coefficients
            .iter()
            .flatten()
            .all(|v| v.is_finite())
    );
    let images = Table::new(2, 1, 0)
        .set(0, "x", 5.0)
        .read(Encoding::Ascii)
        .unwrap();
    assert!(
        images
            .position(0)
            .distance(DVec3::new(5.0, images.position(0).y, images.position(0).z))
            < 1e-6,
        "a box without width"
    );
}

fn each_fault_is_named() {
    let table = || Table::new(5, 4, 1);
    let found = |table: Table| table.read(Encoding::Little).unwrap_err();
    let cases = [
        (
            found(table().without("opacity")),
            "found no `opacity` among the properties x, y, z, nx, ny, nz, f_dc_0 to f_dc_2, f_rest_0 to f_rest_8, scale_0 to scale_2, rot_0 to rot_3, expected x y z, scale_0",
        ),
        (
            found(table().without("f_rest_8")),
            "found 8 properties f_rest, expected 0, 9, 24 or 45",
        ),
        (
            found(Table {
                rows: vec![],
                ..table()
            }),
            "found 0 Gaussians, expected 1 to 2000000",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.starts_with(expected), "{found}");
    }
    let mesh = ["opacity", "scale_0", "rot_0", "f_dc_0"];
    let mesh = found(mesh.iter().fold(table(), |table, name| table.without(name)));
    assert!(
        mesh.ends_with("a mesh or a point cloud has no splats"),
        "{mesh}"
    );
    assert!(!found(table().without("rot_2")).contains("mesh"));
    let compressed = "ply\nformat binary_little_endian 1.0\nelement chunk 1\nproperty float min_x\nelement vertex 1\n\
                      property uint packed_position\nend_header\n";
    assert!(
        read(&[compressed.as_bytes(), &[0; 8]].concat())
            .unwrap_err()
            .starts_with("found chunks without all their extremes, expected min_x to max_z")
    );
}

/// A few bad rows among many are left out, wherever they stand; all bad rows are an error.
fn bad_rows_are_left_out() {
    let table = || Table::new(5, 60, 1);
    let zero = |table: Table, row| {
        let names = table.names.clone();
        names
            .iter()
            .fold(table, |table, name| table.set(row, name, 0.0))
    };
    let no_rotation = (0..4).fold(table(), |table, k| table.set(1, &format!("rot_{k}"), 0.0));
    let cases = [
        (table().set(2, "y", f32::NAN), 2, "NaN in the position"),
        (table().set(2, "y", 2e4), 2, "the position ["),
        (
            table().set(3, "f_dc_1", f32::INFINITY),
            3,
            "inf in the colour",
        ),
        (
            table().set(1, "f_rest_5", f32::NAN),
            1,
            "NaN in the harmonics",
        ),
        (
            table().set(59, "rot_3", f32::NEG_INFINITY),
            59,
            "-inf in the rotation",
        ),
        (
            table().set(0, "scale_0", f32::INFINITY),
            0,
            "inf in the scale",
        ),
        (table().set(0, "opacity", f32::NAN), 0, "NaN in the opacity"),
        (no_rotation, 1, "a quaternion of length 0"),
        (zero(table(), 7), 7, "a quaternion of length 0"),
    ];
    for (table, row, why) in cases {
        let bytes = table.bytes(Encoding::Little);
        let found = ply::read(&bytes).and_then(|found| found.sound()).unwrap();
        let said = found.assumptions.last().unwrap().to_string();
        let expected =
            format!("splats that can't be drawn: 1 of 60 left out (number {row} has {why}");
        assert!(said.starts_with(&expected), "{said}");
        let mut sound = table.clone();
        sound.rows.remove(row);
        let sound = ply::read(&sound.bytes(Encoding::Little)).unwrap().splats;
        assert_eq!(found.splats, sound);
    }
    let all = ["x", "y", "z"].iter().fold(table(), |table, name| {
        (0..60).fold(table, |table, row| table.set(row, name, f32::NAN))
    });
    let refused = all.read(Encoding::Little).unwrap_err();
    assert!(
        refused.contains("none of 60 that can be drawn"),
        "{refused}"
    );
}

fn a_file_that_ends_too_soon_is_refused_wherever_it_ends() {
    let table = Table::new(5, 3, 0);
    for encoding in [Encoding::Ascii, Encoding::Little, Encoding::Big] {
        let bytes = table.bytes(encoding);
        // The last line's end may be missing.
        for end in 0..bytes.len() - usize::from(encoding == Encoding::Ascii) {
            let cut = read(&bytes[..end]);
            // Cut inside its last number, a text is a shorter number.
            let last = encoding == Encoding::Ascii && !bytes[end..].contains(&b' ');
            assert!(cut.is_err() || last, "{end} bytes of {}", bytes.len());
        }
        assert!(read(&bytes).is_ok());
    }
    let short = [table.header(Encoding::Little, 3).as_bytes(), &[0; 100]].concat();
    assert!(
        read(&short)
            .unwrap_err()
            .starts_with("found 1 vertices, expected 3 as the header says; the file is incomplete")
    );
}

fn text_that_is_no_number_is_named() {
    let table = Table::new(5, 2, 0);
    let text = |line: &str| {
        read(format!("{}{line}\n{line}\n", table.header(Encoding::Ascii, 2)).as_bytes())
            .unwrap_err()
    };
    assert_eq!(
        text(&"1 ".repeat(16)),
        "found `` in the line of vertex 0, expected 17 numbers"
    );
    assert_eq!(
        text(&"1 ".repeat(18)),
        "found `1` at the end of the line of vertex 0, expected 17 numbers"
    );
    assert_eq!(
        text(&format!("one {}", "1 ".repeat(16))),
        "found `one` in the line of vertex 0, expected 17 numbers"
    );
}

/// Vertices that the file does not hold cost no memory, and those it holds cost a small multiple of
/// its size.
fn memory_follows_from_the_file_not_from_its_word() {
    let table = Table::new(5, 1, 0);
    for encoding in [Encoding::Ascii, Encoding::Little, Encoding::Big] {
        for count in [
            3,
            1000,
            limits::GAUSSIANS,
            limits::GAUSSIANS + 1,
            u32::MAX as usize,
            usize::MAX,
        ] {
            let bytes = [table.header(encoding, count).as_bytes(), &[b'1'; 200]].concat();
            let (result, peak) = memory::peak(|| read(&bytes));
            assert!(
                result.is_err() && peak < 100_000,
                "{count} vertices: {peak} bytes"
            );
        }
    }
    let bytes = Table::new(6, 5000, 3).bytes(Encoding::Ascii);
    let (result, peak) = memory::peak(|| read(&bytes));
    assert!(
        result.is_ok() && peak < 3 * bytes.len(),
        "{peak} bytes for a file of {}",
        bytes.len()
    );
}

/// What is read keeps the rules that drawing relies on.
fn keeps_the_rules(avatar: &Avatar) {
    let g = &avatar.gaussians;
    let finite = |v: &half::f16| v.is_finite();
    assert!(
        g.rotation.as_flattened().iter().all(finite)
            && g.rotation
                .iter()
                .all(|q| q.iter().any(|v| v.to_f64() != 0.0))
    );
    assert!(
        g.log_scale
            .as_flattened()
            .iter()
            .chain(g.color.as_flattened())
            .all(finite)
    );
    assert!((0..3).all(|k| g.bounds.min[k] <= g.bounds.max[k]));
    assert_eq!(avatar.parts.start, [0, g.len() as u32]);
    if let Some(ShCoefficients {
        degree,
        coefficients,
    }) = &avatar.sh
    {
        assert_eq!(coefficients.len(), g.len() * ((degree + 1).pow(2) - 1));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    fn changed_bytes_never_panic(
        encoding in prop_oneof![Just(Encoding::Ascii), Just(Encoding::Little), Just(Encoding::Big)],
        degree in 0usize..4,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..12),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = Table::new(9, 3, degree).bytes(encoding);
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        if let Ok(avatar) = read(&bytes) {
            keeps_the_rules(&avatar);
        }
    }

    fn headers_of_nonsense_never_panic(lines in prop::collection::vec(
        prop_oneof!["format (ascii|binary_little_endian) 1\\.0", "element (vertex|face|a) [0-9]{1,20}",
            "property (float|double|uchar|list uchar int) (x|y|z|opacity|rot_0|f_rest_[0-9]{1,3})", "[ -~]{0,30}", "end_header"], 0..30)) {
        let bytes = format!("ply\n{}\nend_header\n1 2 3 4 5 6 7 8 9\n", lines.join("\n"));
        prop_assert!(read(bytes.as_bytes()).is_err());
    }
}

tests! {
    numbers_beyond_what_is_stored_stay_finite,
    each_fault_is_named,
    bad_rows_are_left_out,
    a_file_that_ends_too_soon_is_refused_wherever_it_ends,
    text_that_is_no_number_is_named,
    memory_follows_from_the_file_not_from_its_word,
    changed_bytes_never_panic,
    headers_of_nonsense_never_panic,
}
