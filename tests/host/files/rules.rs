//! A file that breaks any one rule of the format is refused, and the sentence names what breaks it.

use super::edit::Edit;
use super::{avatar_fault, bare, clip_bytes, clip_fault, common, tiny, tiny_bytes};
use effigy_core::avatar::{Avatar, Filter};
use half::f16;
use serde_json::{Value, json};

fn every_tensor_must_be_there_with_its_type_and_shape() {
    let avatar = tiny();
    let all = avatar.tensors().into_iter().map(|tensor| (tensor, true));
    let clip = common::clip(1, &avatar, 4);
    for (tensor, of_avatar) in all.chain(clip.tensors().into_iter().map(|tensor| (tensor, false))) {
        let refuse = |change: &dyn Fn(&mut Edit)| {
            let mut edit = Edit::open(&if of_avatar {
                tiny_bytes()
            } else {
                clip_bytes()
            });
            change(&mut edit);
            if of_avatar {
                avatar_fault(&edit.bytes())
            } else {
                clip_fault(&edit.bytes())
            }
        };
        let (name, shape, dtype) = (&tensor.name, &tensor.shape, &tensor.dtype);
        let missing = refuse(&|edit| edit.rename(name, "elsewhere"));
        assert_eq!(
            missing,
            format!("in tensor `{name}` found nothing, expected {dtype} of shape {shape:?}")
        );
        let other = if dtype.ends_with("16") {
            "BF16"
        } else if dtype == "U8" {
            "I8"
        } else {
            "I32"
        };
        let retyped = refuse(&|edit| edit.header[name]["dtype"] = json!(other));
        assert_eq!(
            retyped,
            format!("in tensor `{name}` found {other}, expected {dtype}")
        );
        let reshaped =
            refuse(&|edit| edit.header[name]["shape"] = json!([&shape[..], &[1]].concat()));
        assert_eq!(
            reshaped,
            format!(
                "in tensor `{name}` found shape {:?}, expected {shape:?}",
                [&shape[..], &[1]].concat()
            )
        );
        if dtype.starts_with('F') && !shape.contains(&0) {
            for (name, not_finite) in [(name, f32::NAN), (name, f32::NEG_INFINITY)] {
                let sentence = refuse(&|edit| match dtype.as_str() {
                    "F16" => edit.put(name, 1, &f16::from_f32(not_finite).to_le_bytes()),
                    _ => edit.put(name, 1, &not_finite.to_le_bytes()),
                });
                let found = if not_finite.is_nan() { "NaN" } else { "-inf" };
                assert!(
                    sentence.starts_with(&format!("in tensor `{name}` found {found} at [")),
                    "{name}: {sentence}"
                );
            }
        }
    }
}

/// A change to a tensor of the tiny avatar and the sentence that answers it.
type Case = (&'static str, usize, &'static [u8], &'static str);

fn numbers_that_break_a_rule_are_named() {
    let cases: &[Case] = &[
        (
            "rotation",
            0,
            &[0; 8],
            "found a quaternion of length 0 at [0, 0], expected any other length",
        ),
        (
            "joint",
            22,
            &[9],
            "found 9 at [5, 2], expected numbers below 9",
        ),
        (
            "joint_weight",
            8,
            &[255, 255, 0, 0],
            "found weights that sum to 510 at [2, 0], expected a sum of 255",
        ),
        (
            "node",
            4,
            &[7, 0],
            "found 7 at [1, 1], expected numbers below 7",
        ),
        (
            "node.part",
            6,
            &[3, 0],
            "found 3 at [6], expected numbers below 3",
        ),
        (
            "part_start",
            0,
            &[1, 0, 0, 0],
            "found 1 at [0], expected numbers from 0 to 40 that never fall",
        ),
        (
            "part_start",
            1,
            &[41, 0, 0, 0],
            "found 41 at [1], expected numbers from 0 to 40 that never fall",
        ),
        (
            "part_start",
            1,
            &[40, 0, 0, 0, 39, 0, 0, 0],
            "found 39 at [2], expected numbers from 0 to 40 that never fall",
        ),
        (
            "part_start",
            3,
            &[39, 0, 0, 0],
            "found 39 at [3], expected numbers from 0 to 40 that never fall",
        ),
        (
            "rotation.row",
            4,
            &[40, 0, 0, 0],
            "found 40 at [4], expected numbers below 40",
        ),
        (
            "scale.row",
            0,
            &[9, 0, 0, 0, 9, 0, 0, 0],
            "found 9 after a number no smaller at [1], expected rising numbers",
        ),
        (
            "color.row",
            0,
            &[9, 0, 0, 0, 8, 0, 0, 0],
            "found 8 after a number no smaller at [1], expected rising numbers",
        ),
        (
            "node.offset",
            1,
            &[0xFF, 0x7B],
            "found 65504 at [0, 1], expected metres, at most 10000",
        ),
        (
            "skeleton.rest",
            4,
            &[0, 0, 0, 0x7F],
            "found 170141180000000000000000000000000000000 at [1, 1], expected metres, at most 10000",
        ),
        (
            "pose_space.sigma",
            1,
            &[0, 0, 0x80, 0xBF],
            "found -1 at [1], expected finite numbers from 0 up",
        ),
        (
            "expression_space.component",
            0,
            &[0, 0, 0, 0x40],
            "found rows 0 and 0 with the dot product",
        ),
        (
            "level.0.part_start",
            3,
            &[19, 0, 0, 0],
            "found 19 at [3], expected numbers from 0 to 20 that never fall",
        ),
        (
            "level.1.part_start",
            1,
            &[11, 0, 0, 0],
            "found 11 at [1], expected numbers from 0 to 10 that never fall",
        ),
        (
            "level.0.node",
            4,
            &[7, 0],
            "found 7 at [1, 1], expected numbers below 7",
        ),
        (
            "level.1.joint",
            5,
            &[9],
            "found 9 at [1, 1], expected numbers below 9",
        ),
        (
            "level.1.log_scale",
            5,
            &[0, 0x7E],
            "found NaN at [1, 2], expected finite numbers",
        ),
        (
            "level.1.joint_weight",
            8,
            &[255, 1, 0, 0],
            "found weights that sum to 256 at [2, 0], expected a sum of 255",
        ),
    ];
    for (tensor, at, bytes, sentence) in cases {
        let mut edit = Edit::open(&tiny_bytes());
        edit.put(tensor, *at, bytes);
        let got = avatar_fault(&edit.bytes());
        assert!(
            got.starts_with(&format!("in tensor `{tensor}` {sentence}")),
            "{got}"
        );
    }
}

fn metadata_that_breaks_a_rule_is_named() {
    let cases: &[(&str, Value, &str)] = &[
        (
            "/format",
            json!("effigy.motion"),
            "`format` found `effigy.motion`, expected `effigy.avatar`",
        ),
        (
            "/version",
            json!(6),
            "`version` found 6, expected 1 to 5, the only ones this program reads",
        ),
        (
            "/units",
            json!("inch"),
            "`units` found \"inch\", expected \"metre\"",
        ),
        ("/up", json!("z"), "`up` found \"z\", expected \"y\""),
        (
            "/color_space",
            json!("linear"),
            "`color_space` found \"linear\", expected \"srgb\"",
        ),
        (
            "/gaussians",
            json!(0),
            "`gaussians` found 0, expected 1 to 2000000",
        ),
        (
            "/gaussians",
            json!(2_000_001),
            "`gaussians` found 2000001, expected 1 to 2000000",
        ),
        (
            "/gaussians",
            json!(41),
            "in tensor `position` found shape [40, 3], expected [41, 3]",
        ),
        (
            "/gaussians",
            json!(-1),
            "`effigy` found invalid value: integer `-1`, expected usize",
        ),
        (
            "/parts",
            json!(1025),
            "`parts` found 1025, expected 1 to 1024",
        ),
        (
            "/head_parts",
            json!(4),
            "`head_parts` found 4, expected 0 to 3",
        ),
        (
            "/nodes",
            json!(65_537),
            "`nodes` found 65537, expected 1 to 65536",
        ),
        ("/basis", json!(36), "`basis` found 36, expected 4 to 32"),
        (
            "/basis",
            json!(6),
            "`basis` found 6, expected a multiple of 4",
        ),
        (
            "/rotation_rows",
            json!(41),
            "`rotation_rows` found 41, expected 0 to 40",
        ),
        (
            "/scale_rows",
            json!(u64::MAX),
            "`scale_rows` found 18446744073709551615, expected 0 to 40",
        ),
        (
            "/color_rows",
            json!(41),
            "`color_rows` found 41, expected 0 to 40",
        ),
        (
            "/bounds/0/1",
            json!(2),
            "`bounds` found [-1.0, 2.0, -0.3] to [1.0, 1.8, 0.3], expected a lower and an upper corner",
        ),
        ("/bounds/1/1", json!(1e30), "`bounds` found"),
        (
            "/activation",
            json!("gelu"),
            "`effigy` found unknown variant `gelu`, expected `relu` or `leaky_relu`",
        ),
        (
            "/widths",
            json!([8]),
            "`widths` found 0 layers, expected 1 to 8: one width more than layers",
        ),
        (
            "/widths/0",
            json!(27),
            "`widths` found 27 inputs, expected 26, three a joint of `inputs` and the expression's length",
        ),
        (
            "/widths/1",
            json!(132),
            "`widths` found 132, expected 4 to 128",
        ),
        (
            "/widths/2",
            json!(6),
            "`widths` found 6, expected multiples of 4 in the hidden layers",
        ),
        (
            "/widths/4",
            json!(12),
            "`widths` found 12 outputs, expected 4 or twice 4, as `basis` says",
        ),
        (
            "/joints",
            json!([]),
            "`joints` found 0 names, expected 1 to 256",
        ),
        (
            "/joints/3",
            json!("pelvis"),
            "`joints` found \"pelvis\" twice, expected names that differ",
        ),
        (
            "/parents",
            json!([null]),
            "`parents` found 1 entries, expected 9, one a joint",
        ),
        (
            "/parents/0",
            json!(0),
            "`parents` found 0 for joint 0, expected a parent that stands before its child, and null for joint 0",
        ),
        (
            "/parents/4",
            json!(5),
            "`parents` found 5 for joint 4, expected a parent that stands before its child, and null for joint 0",
        ),
        (
            "/parents/4",
            json!(null),
            "`parents` found null for joint 4, expected a parent for every joint but joint 0",
        ),
        (
            "/inputs/2",
            json!(9),
            "`inputs` found joint 9, expected joints below 9",
        ),
        (
            "/expression",
            json!(65),
            "`expression` found 65, expected 0 to 64",
        ),
        (
            "/pose_components",
            json!(25),
            "`pose_components` found 25, expected 0 to 24",
        ),
        (
            "/expression_components",
            json!(3),
            "`expression_components` found 3, expected 0 to 2",
        ),
        (
            "/levels",
            json!(vec![json!({ "gaussians": 3, "correctives": false }); 9]),
            "`levels` found 9, expected 0 to 8",
        ),
        (
            "/levels/0/gaussians",
            json!(0),
            "`level.0.gaussians` found 0, expected 1 to 39",
        ),
        (
            "/levels/0/gaussians",
            json!(40),
            "`level.0.gaussians` found 40, expected 1 to 39",
        ),
        (
            "/levels/1/gaussians",
            json!(20),
            "`level.1.gaussians` found 20, expected 1 to 19",
        ),
        (
            "/levels/1/gaussians",
            json!(11),
            "in tensor `level.1.position` found shape [10, 3], expected [11, 3]",
        ),
        (
            "/levels/1/correctives",
            json!(true),
            "in tensor `level.1.node` found shape [0, 3], expected [10, 3]",
        ),
        (
            "/levels/1/color_rows",
            json!(1),
            "`level.1.color_rows` found 1, expected 0 to 0",
        ),
        (
            "/levels/0/measured/0/height",
            json!(-60),
            "`level.0.measured` found 32 dB, 0.004 and 0.0025 at -60 px with 2 samples, expected finite numbers",
        ),
        (
            "/levels/0/measured/1/samples",
            json!(2),
            "`level.0.measured` found 120 px with 2 samples after 120 px with 2, expected rising heights",
        ),
        (
            "/levels/0/measured/0/psnr_db",
            json!(null),
            "`effigy` found invalid type: null, expected f64",
        ),
        (
            "/levels/0/correctives",
            json!("some"),
            "`effigy` found invalid type: string \"some\", expected a boolean",
        ),
        (
            "/joints",
            json!({}),
            "`effigy` found invalid type: map, expected a sequence",
        ),
    ];
    for (field, value, sentence) in cases {
        let mut edit = Edit::open(&tiny_bytes());
        *edit.document.pointer_mut(field).expect(field) = value.clone();
        let got = avatar_fault(&edit.bytes());
        assert!(
            got.strip_prefix("in metadata ")
                .unwrap_or(&got)
                .starts_with(sentence),
            "{field}: {got}"
        );
    }
}

fn filters_that_break_a_rule_are_named() {
    let written = tiny_filtered();
    let cases: &[(&str, Value, &str)] = &[
        (
            "/version",
            json!(2),
            "`version` found 2, expected 3 or more, as there is a filter",
        ),
        (
            "/filter/variance",
            json!(0.0999),
            "`filter` found a variance of 0.0999 px², expected one from 0.1 to 10 px²",
        ),
        (
            "/filter/variance",
            json!(10.5),
            "`filter` found a variance of 10.5 px², expected one",
        ),
        (
            "/filter/variance",
            json!("wide"),
            "`effigy` found invalid type: string",
        ),
        (
            "/filter/compensated",
            json!(1),
            "`effigy` found invalid type: integer `1`, expected a boolean",
        ),
        (
            "/filter",
            json!({ "variance": 0.3 }),
            "`effigy` found missing field `compensated`",
        ),
    ];
    for (field, value, sentence) in cases {
        let mut edit = Edit::open(&written.to_bytes().unwrap());
        *edit.document.pointer_mut(field).expect(field) = value.clone();
        let got = avatar_fault(&edit.bytes());
        assert!(
            got.strip_prefix("in metadata ")
                .unwrap_or(&got)
                .starts_with(sentence),
            "{field}: {got}"
        );
    }
    let drawn = |variance| {
        let mut avatar = tiny_filtered();
        avatar.filter.variance = variance;
        avatar.check().map_err(|fault| fault.to_string())
    };
    assert_eq!(drawn(10.0), Ok(()));
    for variance in [0.0, -0.3, f64::NAN, f64::INFINITY] {
        let fault = drawn(variance).expect_err("no filter");
        assert!(fault.contains(&format!("{variance} px²")), "{fault}");
    }
}

fn a_facing_needs_its_version_and_every_set() {
    let faced = common::with_levels(common::faced(bare()));
    let mut edit = Edit::open(&faced.to_bytes().unwrap());
    assert_eq!(edit.document["version"], json!(5));
    edit.document["version"] = json!(4);
    let fault = avatar_fault(&edit.bytes());
    assert!(
        fault.contains("`version` found 4, expected 5, as there is a facing"),
        "{fault}"
    );
    let mut partly = faced.clone();
    partly.levels[0].gaussians.facing.clear();
    let fault = partly.check().expect_err("a level has none").to_string();
    assert!(fault.contains("`level.0.facing` found"), "{fault}");
}

/// Files are of the lowest version that can hold them.
fn a_filter_is_written_where_it_is_not_that_of_3dgs() {
    let document = |bytes: Vec<u8>| Edit::open(&bytes).document;
    let plain = document(tiny().to_bytes().unwrap());
    assert_eq!(plain["version"], json!(1));
    assert_eq!(plain.get("filter"), None);
    let filtered = tiny_filtered();
    for bytes in [filtered.to_bytes(), filtered.to_packed_bytes()] {
        let bytes = bytes.unwrap();
        assert_eq!(Avatar::from_bytes(&bytes).unwrap(), filtered);
        let written = document(bytes);
        assert_eq!(written["version"], json!(3));
        assert_eq!(
            written["filter"],
            json!({ "variance": 0.1, "compensated": true })
        );
    }
    // Said, though it need not be.
    let mut edit = Edit::open(&tiny_filtered().to_bytes().unwrap());
    edit.document["filter"] = json!({ "variance": 0.3, "compensated": false });
    assert_eq!(Avatar::from_bytes(&edit.bytes()).unwrap(), tiny());
}

fn tiny_filtered() -> Avatar {
    Avatar {
        filter: Filter {
            variance: 0.1,
            compensated: true,
        },
        ..tiny()
    }
}

fn motion_metadata_that_breaks_a_rule_is_named() {
    let cases: &[(&str, Value, &str)] = &[
        (
            "/format",
            json!("effigy.avatar"),
            "`format` found `effigy.avatar`, expected `effigy.motion`",
        ),
        (
            "/version",
            json!(0),
            "`version` found 0, expected 1, the only one this program reads",
        ),
        (
            "/units",
            json!("cm"),
            "`units` found \"cm\", expected \"metre\"",
        ),
        ("/up", json!("-y"), "`up` found \"-y\", expected \"y\""),
        (
            "/rate",
            json!(0),
            "`rate` found 0, expected 0.001 to 100000 frames a second",
        ),
        (
            "/rate",
            json!(-30),
            "`rate` found -30, expected 0.001 to 100000 frames a second",
        ),
        (
            "/rate",
            json!(null),
            "`effigy` found invalid type: null, expected f64",
        ),
        ("/frames", json!(0), "`frames` found 0, expected at least 1"),
        (
            "/frames",
            json!(u64::MAX),
            "in tensor `rotation` found shape [4, 9, 3], expected [18446744073709551615, 9, 3]",
        ),
        (
            "/joints",
            json!(vec!["a"; 257]),
            "`joints` found 257 names, expected 1 to 256",
        ),
        (
            "/joints/8",
            json!("pelvis"),
            "`joints` found \"pelvis\" twice, expected names that differ",
        ),
        (
            "/expression",
            json!(65),
            "`expression` found 65, expected 0 to 64",
        ),
    ];
    for (field, value, sentence) in cases {
        let mut edit = Edit::open(&clip_bytes());
        *edit.document.pointer_mut(field).expect(field) = value.clone();
        let got = clip_fault(&edit.bytes());
        assert!(
            got.strip_prefix("in metadata ")
                .unwrap_or(&got)
                .starts_with(sentence),
            "{field}: {got}"
        );
    }
}

tests! {
    every_tensor_must_be_there_with_its_type_and_shape,
    numbers_that_break_a_rule_are_named,
    metadata_that_breaks_a_rule_is_named,
    filters_that_break_a_rule_are_named,
    a_facing_needs_its_version_and_every_set,
    a_filter_is_written_where_it_is_not_that_of_3dgs,
    motion_metadata_that_breaks_a_rule_is_named,
}
