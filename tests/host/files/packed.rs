//! Packed files: what is written reads back the same in fewer bytes, and what is damaged, untrue or
//! too good to be true is refused.

use super::edit::{self, Edit};
use super::{TINY, avatar_fault, sizes, tiny};
use crate::common::{self, Sizes};
use crate::memory;
use effigy_core::{
    avatar::{Avatar, Matrix},
    io::{
        file::{self, Neutral},
        pack::PackQuality,
    },
};
use half::f16;
use serde_json::{Value, json};

pub fn packed_bytes() -> Vec<u8> {
    tiny().packed(PackQuality::Small).to_packed_bytes().unwrap()
}

fn packed_avatars_of_every_size_read_back_the_same() {
    for (seed, sizes) in sizes().into_iter().enumerate() {
        let plain = common::with_levels(common::avatar(seed as u64, sizes));
        let mut length = plain.to_bytes().unwrap().len();
        assert!(
            Avatar::from_bytes(&plain.to_packed_bytes().unwrap()).unwrap() == plain,
            "{sizes:?}"
        );
        for quality in PackQuality::ALL {
            let packed = plain.packed(quality);
            let bytes = packed.to_packed_bytes().unwrap();
            assert!(
                Avatar::from_bytes(&bytes).unwrap() == packed,
                "{sizes:?} {quality:?}"
            );
            // The header tells more, which counts for something in a file of a kilobyte.
            assert!(
                bytes.len() < length + 1500,
                "{sizes:?} {quality:?}: {} bytes after {length}",
                bytes.len()
            );
            length = bytes.len();
        }
    }
}

/// The avatar that no code fits: extreme numbers, quaternions of any length, and everything the
/// same, which deflates to next to nothing.
fn what_fits_no_code_reads_back_the_same() {
    let mut extreme = tiny();
    extreme.gaussians.log_scale[3] = [f16::MAX, f16::MIN, f16::from_bits(1)];
    extreme.gaussians.rotation[0] = [f16::ZERO, f16::from_bits(1), f16::ZERO, f16::NEG_ZERO];
    extreme.gaussians.color[7] = [f16::MIN, f16::MAX, f16::NEG_ZERO];
    extreme.networks.layers[0].weight.halves_mut()[1] = f16::MAX;
    extreme.rotation_rows.basis.halves_mut().fill(f16::MAX);
    for quality in PackQuality::ALL {
        let packed = extreme.packed(quality);
        assert!(
            Avatar::from_bytes(&packed.to_packed_bytes().unwrap()).unwrap() == packed,
            "{quality:?}"
        );
    }
    let mut same = common::avatar(
        1,
        Sizes {
            gaussians: 30_000,
            ..TINY
        },
    );
    let g = &mut same.gaussians;
    g.position.fill([7; 3]);
    g.rotation.fill([f16::ONE, f16::ZERO, f16::ZERO, f16::ZERO]);
    g.log_scale.fill([f16::NEG_ONE; 3]);
    g.color.fill([f16::ONE; 3]);
    g.opacity.fill(9);
    g.joint.fill([0; 4]);
    g.joint_weight.fill([255, 0, 0, 0]);
    g.node.fill([0; 3]);
    let bytes = same.to_packed_bytes().unwrap();
    assert!(Avatar::from_bytes(&bytes).unwrap() == same);
}

fn packed_files_are_read_in_little_memory() {
    let packed = common::avatar(
        1,
        Sizes {
            gaussians: 20_000,
            ..Sizes::default()
        },
    )
    .packed(PackQuality::Small);
    let bytes = packed.to_packed_bytes().unwrap();
    let raw: usize = file::tensors_of(&bytes)
        .unwrap()
        .iter()
        .map(|tensor| tensor.bytes)
        .sum();
    let (read, peak) = memory::peak(|| Avatar::from_bytes(&bytes).unwrap());
    assert!(read == packed && raw < 4 * bytes.len());
    // What is expanded and what is made of it, which has some numbers in f16.
    assert!(
        peak < 3 * raw,
        "{} bytes in the file, {raw} expanded, took {peak} bytes of memory",
        bytes.len()
    );
}

fn every_damaged_stream_is_named() {
    let bytes = packed_bytes();
    let deflated: Vec<_> = file::tensors_of(&bytes)
        .unwrap()
        .into_iter()
        .filter(|tensor| tensor.deflated.is_some())
        .collect();
    assert!(deflated.len() > 5, "{deflated:?}");
    for tensor in deflated {
        let refuse = |change: &dyn Fn(&mut Vec<u8>)| {
            let mut edit = Edit::open(&bytes);
            let mut stream = edit.stored(&tensor.name);
            change(&mut stream);
            edit.replace(&tensor.name, "U8", &[stream.len()], &stream);
            avatar_fault(&edit.bytes())
        };
        let expected = format!(
            "expected {} of shape {:?}, {} bytes",
            tensor.dtype, tensor.shape, tensor.bytes
        );
        let name = format!("in tensor `{}` found ", tensor.name);
        for (sentence, found) in [
            (
                refuse(&|stream| *stream.last_mut().unwrap() ^= 1),
                "deflated bytes damaged after ",
            ),
            (
                refuse(&|stream| stream[0] ^= 0xff),
                "deflated bytes damaged after 0",
            ),
            (
                refuse(&|stream| stream.truncate(stream.len() - 5)),
                "deflated bytes cut off after ",
            ),
            (
                refuse(&|stream| stream.clear()),
                "deflated bytes cut off after 0",
            ),
            (
                refuse(&|stream| stream.push(0)),
                "1 bytes after the deflated ones",
            ),
        ] {
            assert!(
                sentence.starts_with(&(name.clone() + found)) && sentence.ends_with(&expected),
                "{sentence}"
            );
        }
        let mut plain = Edit::open(&bytes);
        plain.document["deflated"]
            .as_object_mut()
            .unwrap()
            .remove(&tensor.name);
        let sentence = avatar_fault(&plain.bytes());
        assert!(
            sentence.starts_with(&name) && sentence.contains(", expected "),
            "{sentence}"
        );
    }
}

fn files_that_would_expand_without_bound_are_refused_before_they_do() {
    let mut edit = Edit::open(&packed_bytes());
    edit.document["gaussians"] = json!(2_000_000);
    edit.document["deflated"]["opacity"] = json!("planes");
    edit.replace("opacity", "U8", &[3], &[1, 2, 3]);
    for name in [
        "position",
        "rotation",
        "log_scale",
        "color",
        "joint",
        "joint_weight",
        "node",
    ] {
        edit.document["deflated"][name] = json!("planes");
        edit.replace(name, "U8", &[3], &[1, 2, 3]);
    }
    let bytes = edit.bytes();
    let (sentence, peak) = memory::peak(|| avatar_fault(&bytes));
    assert!(
        sentence.contains("found the largest of deflated tensors of ")
            && sentence.ends_with(" bytes at most in all"),
        "{sentence}"
    );
    assert!(peak < 100_000, "{peak} bytes of memory");
}

/// A change to a tensor and the sentence that answers it.
type Case = (&'static str, usize, &'static [u8], &'static str);

fn codes_that_break_a_rule_are_named() {
    let cases: &[Case] = &[
        (
            "color.basis",
            17,
            &[0x80],
            "found -128 at [1, 1, 1], expected codes from -127 to 127",
        ),
        (
            "mlp.1.weight",
            9,
            &[0x80],
            "found -128 at [0, 1, 1], expected codes from -127 to 127",
        ),
        (
            "node.step",
            3,
            &[0, 0x7c],
            "found inf at [3], expected steps from 0 to 512",
        ),
        (
            "mlp.0.step",
            1,
            &[0, 0xbc],
            "found -1 at [0, 1], expected steps from 0 to 512",
        ),
        (
            "scale.step",
            2,
            &[1, 0x60],
            "found 512.5 at [2], expected steps from 0 to 512",
        ),
    ];
    for (tensor, at, bytes, sentence) in cases {
        // Not deflated.
        let mut edit = Edit::open(&tiny().packed(PackQuality::Small).to_bytes().unwrap());
        edit.put(tensor, *at, bytes);
        assert_eq!(
            avatar_fault(&edit.bytes()),
            format!("in tensor `{tensor}` {sentence}")
        );
    }
    let plain = |tensor: &str, dtype: &str, shape: &[usize], bytes: &[u8]| {
        let mut edit = Edit::open(&packed_bytes());
        edit.document["deflated"]
            .as_object_mut()
            .unwrap()
            .remove(tensor);
        edit.replace(tensor, dtype, shape, bytes);
        avatar_fault(&edit.bytes())
    };
    let weights = [100, 100, 56].repeat(40);
    let sentence = plain("joint_weight", "U8", &[40, 3], &weights);
    assert_eq!(
        sentence,
        "in tensor `joint_weight` found three weights that sum to 256 at [0, 0], expected a sum of 255 at most"
    );
}

fn metadata_of_codes_that_breaks_a_rule_is_named() {
    let cases: &[(&str, Value, &str)] = &[
        (
            "/version",
            json!(1),
            "`version` found 1, expected 2 or more, as there are codes",
        ),
        (
            "/coded/0",
            json!("rotations"),
            "`effigy` found unknown variant `rotations`, expected one of `rotation`",
        ),
        ("/log_scales/bits", json!(9), "`log_scales` found min "),
        ("/log_scales/step", json!(0.0), "`log_scales` found min "),
        ("/log_scales/min", json!(1e300), "`log_scales` found min "),
        (
            "/levels/0/log_scales",
            json!(null),
            "`level.0.log_scales` found 0 bits, expected 16, as the avatar has",
        ),
        (
            "/levels/1/log_scales/step",
            json!(-1.0),
            "`level.1.log_scales` found min ",
        ),
        (
            "/deflated/node",
            json!("runs"),
            "`effigy` found unknown variant `runs`, expected `planes` or `deltas`",
        ),
        ("/coded", json!([]), "in tensor `"),
    ];
    for (field, value, sentence) in cases {
        let mut edit = Edit::open(&packed_bytes());
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

fn a_matrix_without_its_steps_is_not_written() {
    let mut avatar = tiny().packed(PackQuality::Small);
    if let Matrix::Bytes { steps, .. } = &mut avatar.nodes.basis {
        steps.pop();
    }
    assert_eq!(
        avatar.to_bytes().unwrap_err().to_string(),
        "in tensor `node.step` found 12 bytes, expected F16 of shape [7]"
    );
}

fn a_later_programs_packed_tensors_are_ignored() {
    let mut edit = Edit::open(&packed_bytes());
    edit.document["deflated"]["colour.of.shadow"] = json!("planes");
    edit.append("colour.of.shadow", "U8", &[3], &[1, 2, 3]);
    assert!(Avatar::from_bytes(&edit.bytes()).unwrap() == tiny().packed(PackQuality::Small));
    assert!(
        avatar_fault(&edit::raw(edit.header.to_string().as_bytes(), &[]))
            .ends_with("the file is incomplete")
    );
}

/// Levels add tensors and a field: a program that ignores them draws all Gaussians, so a file with
/// levels has the version that it would have without.
fn what_does_not_know_levels_reads_the_rest() {
    for quality in PackQuality::ALL {
        let avatar = tiny().packed(quality);
        for bytes in [
            avatar.to_bytes().unwrap(),
            avatar.to_packed_bytes().unwrap(),
        ] {
            let mut edit = Edit::open(&bytes);
            let levels = edit.document.as_object_mut().unwrap().remove("levels");
            assert_eq!(levels.unwrap().as_array().unwrap().len(), 2);
            let without = Avatar {
                levels: vec![],
                ..avatar.clone()
            };
            assert!(Avatar::from_bytes(&edit.bytes()).unwrap() == without);
            let plain = Edit::open(&without.to_packed_bytes().unwrap());
            assert!(
                edit.document["version"] == plain.document["version"]
                    || quality == PackQuality::Lossless
            );
        }
    }
}

/// A page that has the beginning of a file shows the avatar without levels; they come last.
fn levels_come_last() {
    let bytes = tiny().packed(PackQuality::High).to_packed_bytes().unwrap();
    let whole = Avatar::from_bytes(&bytes).unwrap();
    let needed = Avatar::neutral_needs(&bytes).unwrap();
    let Neutral::Avatar(neutral) = Avatar::neutral(&bytes[..needed], bytes.len()).unwrap() else {
        panic!("{needed} bytes are not enough");
    };
    assert!(neutral.levels.is_empty() && neutral.gaussians == whole.gaussians);
    let edit = Edit::open(&bytes);
    let places = |of_level: bool| {
        let all = edit.header.as_object().unwrap().iter();
        all.filter(move |(name, _)| {
            *name != "__metadata__" && name.starts_with("level.") == of_level
        })
        .map(|(_, info)| info["data_offsets"].clone())
    };
    let last = places(false).map(|place| place[1].as_u64()).max();
    let first = places(true).map(|place| place[0].as_u64()).min();
    assert!(last.is_some() && last <= first, "{last:?}, {first:?}");
}

tests! {
    packed_avatars_of_every_size_read_back_the_same,
    what_fits_no_code_reads_back_the_same,
    packed_files_are_read_in_little_memory,
    every_damaged_stream_is_named,
    files_that_would_expand_without_bound_are_refused_before_they_do,
    codes_that_break_a_rule_are_named,
    metadata_of_codes_that_breaks_a_rule_is_named,
    a_matrix_without_its_steps_is_not_written,
    a_later_programs_packed_tensors_are_ignored,
    levels_come_last,
    what_does_not_know_levels_reads_the_rest,
}
