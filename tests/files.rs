//! The avatar and motion files: what is written reads back the same, and whatever else is read is refused in one sentence, without
//! panic and without memory that the file does not justify.

mod common;
#[path = "common/edit.rs"]
mod edit;
#[path = "common/memory.rs"]
mod memory;

use common::{Random, Sizes};
use edit::Edit;
use effigy::avatar::{Activation, Avatar, Clip};
use half::f16;
use proptest::prelude::*;
use serde_json::{Value, json};

#[global_allocator]
static ALLOCATOR: memory::Counting = memory::Counting;

/// A few kilobytes with a piece of everything.
const TINY: Sizes = Sizes {
    gaussians: 40,
    parts: 3,
    nodes: 7,
    basis: 4,
    joints: 9,
    rows: 5,
    expression: 2,
    split_features: true,
    activation: Activation::LeakyRelu,
    hidden: 8,
    subspace: 2,
};

fn tiny() -> Avatar {
    common::avatar(1, TINY)
}

fn tiny_bytes() -> Vec<u8> {
    tiny().to_bytes().unwrap()
}

fn clip_bytes() -> Vec<u8> {
    common::clip(1, &tiny(), 4).to_bytes().unwrap()
}

fn avatar_fault(bytes: &[u8]) -> String {
    Avatar::from_bytes(bytes).expect_err("the avatar should be refused").to_string()
}

fn clip_fault(bytes: &[u8]) -> String {
    Clip::from_bytes(bytes).expect_err("the clip should be refused").to_string()
}

#[test]
fn test_avatars_have_their_three_nearest_nodes() {
    let avatar = common::avatar(3, Sizes::default());
    for gaussian in 0..avatar.gaussians.len() {
        let distance = |node: usize| avatar.node_position(node).distance(avatar.position(gaussian));
        let mut all: Vec<f64> = (0..avatar.nodes.len()).map(distance).collect();
        all.sort_by(f64::total_cmp);
        let got = avatar.gaussians.node[gaussian].map(|node| distance(node.into()));
        assert_eq!(got[..], all[..3], "Gaussian {gaussian}");
    }
}

#[test]
fn avatars_of_every_size_read_back_the_same() {
    let sizes = [
        TINY,
        Sizes::default(),
        Sizes { gaussians: 1, parts: 1, nodes: 1, joints: 1, rows: 0, expression: 0, subspace: 0, ..TINY },
        Sizes { parts: 1024, gaussians: 2000, joints: 256, basis: 32, ..TINY },
        Sizes { nodes: 65_536, rows: 40, subspace: 64, ..TINY },
    ];
    for (seed, sizes) in sizes.into_iter().enumerate() {
        let avatar = common::avatar(seed as u64, sizes);
        assert!(Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap() == avatar, "{sizes:?}");
    }
}

#[test]
fn files_on_disk_read_back_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let (avatar, mut clip) = (tiny(), common::clip(2, &tiny(), 30));
    clip.rate = 1.0 / 0.008_333_3;
    avatar.write(&folder.path().join("a.avatar")).unwrap();
    clip.write(&folder.path().join("a.motion")).unwrap();
    assert_eq!(Avatar::read(&folder.path().join("a.avatar")).unwrap(), avatar);
    assert_eq!(Clip::read(&folder.path().join("a.motion")).unwrap(), clip);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "a temporary file was left");
}

#[test]
fn extreme_but_finite_numbers_read_back_the_same() {
    let mut avatar = tiny();
    avatar.gaussians.log_scale[3] = [f16::MAX, f16::MIN, f16::from_bits(1)];
    avatar.gaussians.rotation[0] = [f16::ZERO, f16::from_bits(1), f16::ZERO, f16::NEG_ZERO];
    avatar.gaussians.bounds.min = [0.1, 1.0e-40, -9999.999];
    avatar.gaussians.bounds.max[0] = 0.1;
    avatar.networks.layers[0].weight[1] = f16::MAX;
    assert_eq!(Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap(), avatar);
}

#[test]
fn a_file_at_an_odd_address_reads_the_same() {
    let mut bytes = vec![0];
    bytes.extend(tiny_bytes());
    assert_eq!(Avatar::from_bytes(&bytes[1..]).unwrap(), tiny());
}

#[test]
fn what_a_later_program_adds_is_ignored() {
    let mut edit = Edit::open(&tiny_bytes());
    edit.document["mood"] = json!({ "good": [1, 2] });
    edit.header["__metadata__"]["other"] = json!("something");
    edit.append("colour.of.shadow", "BF16", &[2], &[1, 2, 3, 4]);
    assert_eq!(Avatar::from_bytes(&edit.bytes()).unwrap(), tiny());
}

#[test]
fn a_missing_file_a_folder_and_an_empty_file_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let error = |name: &str| Avatar::read(&folder.path().join(name)).unwrap_err().to_string();
    assert!(error("none.avatar").starts_with("cannot read ") && error("none.avatar").contains("none.avatar: "), "{}", error("none.avatar"));
    assert!(error("").ends_with("found a folder or device, expected a file"), "{}", error(""));
    std::fs::write(folder.path().join("empty.avatar"), "").unwrap();
    assert!(error("empty.avatar").ends_with("empty.avatar: found a file of 0 bytes, expected at least 8"), "{}", error("empty.avatar"));
}

#[test]
fn a_failed_write_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.avatar");
    tiny().write(&path).unwrap();
    let mut broken = tiny();
    broken.gaussians.opacity.pop();
    let error = broken.write(&path).unwrap_err().to_string();
    assert!(error.ends_with("a.avatar: in tensor `opacity` found 39 bytes, expected U8 of shape [40]"), "{error}");
    assert_eq!(Avatar::read(&path).unwrap(), tiny());
    let inside = path.join("b.avatar");
    assert!(tiny().write(&inside).unwrap_err().to_string().starts_with("cannot write "));
    std::fs::create_dir(folder.path().join("folder")).unwrap();
    assert!(tiny().write(&folder.path().join("folder")).is_err());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "a temporary file was left");
}

#[test]
fn an_avatar_whose_layers_do_not_fit_is_not_written() {
    let mut avatar = tiny();
    avatar.networks.layers[1].input = 4;
    assert_eq!(
        avatar.to_bytes().unwrap_err().to_string(),
        "found arrays that contradict each other, expected lengths and widths that agree"
    );
}

#[test]
fn a_file_cut_at_any_length_is_refused() {
    for bytes in [tiny_bytes(), clip_bytes()] {
        for length in 0..bytes.len() {
            let (result, peak) = memory::peak(|| (Avatar::from_bytes(&bytes[..length]).err(), Clip::from_bytes(&bytes[..length]).err()));
            assert!(result.0.is_some() && result.1.is_some(), "cut to {length} of {}", bytes.len());
            assert!(peak < 100_000, "cut to {length} of {}: {peak} bytes of memory", bytes.len());
        }
    }
    let bytes = tiny_bytes();
    let sentence = avatar_fault(&bytes[..bytes.len() - 100]);
    assert!(sentence.starts_with("found ") && sentence.ends_with(" as the header says; the file is incomplete"), "{sentence}");
    assert!(avatar_fault(&[&bytes[..], &[0]].concat()).ends_with(" as the header says"));
}

#[test]
fn every_tensor_must_be_there_with_its_type_and_shape() {
    let avatar = tiny();
    let all = avatar.tensors().into_iter().map(|tensor| (tensor, true));
    let clip = common::clip(1, &avatar, 4);
    for (tensor, of_avatar) in all.chain(clip.tensors().into_iter().map(|tensor| (tensor, false))) {
        let refuse = |change: &dyn Fn(&mut Edit)| {
            let mut edit = Edit::open(&if of_avatar { tiny_bytes() } else { clip_bytes() });
            change(&mut edit);
            if of_avatar { avatar_fault(&edit.bytes()) } else { clip_fault(&edit.bytes()) }
        };
        let (name, shape, dtype) = (&tensor.name, &tensor.shape, &tensor.dtype);
        let missing = refuse(&|edit| edit.rename(name, "elsewhere"));
        assert_eq!(missing, format!("in tensor `{name}` found nothing, expected {dtype} of shape {shape:?}"));
        let other = if dtype.ends_with("16") {
            "BF16"
        } else if dtype == "U8" {
            "I8"
        } else {
            "I32"
        };
        let retyped = refuse(&|edit| edit.header[name]["dtype"] = json!(other));
        assert_eq!(retyped, format!("in tensor `{name}` found {other}, expected {dtype}"));
        let reshaped = refuse(&|edit| edit.header[name]["shape"] = json!([shape, &vec![1]].concat()));
        assert_eq!(reshaped, format!("in tensor `{name}` found shape {:?}, expected {shape:?}", [&shape[..], &[1]].concat()));
        if dtype.starts_with('F') {
            for (name, not_finite) in [(name, f32::NAN), (name, f32::NEG_INFINITY)] {
                let sentence = refuse(&|edit| match dtype.as_str() {
                    "F16" => edit.put(name, 1, &f16::from_f32(not_finite).to_le_bytes()),
                    _ => edit.put(name, 1, &not_finite.to_le_bytes()),
                });
                let found = if not_finite.is_nan() { "NaN" } else { "-inf" };
                assert!(sentence.starts_with(&format!("in tensor `{name}` found {found} at [")), "{name}: {sentence}");
            }
        }
    }
}

/// A change to a tensor of the tiny avatar and the sentence that answers it.
type Case = (&'static str, usize, &'static [u8], &'static str);

#[test]
fn numbers_that_break_a_rule_are_named() {
    let cases: &[Case] = &[
        ("rotation", 0, &[0; 8], "found a quaternion of length 0 at [0, 0], expected any other length"),
        ("joint", 22, &[9], "found 9 at [5, 2], expected numbers below 9"),
        ("joint_weight", 8, &[255, 255, 0, 0], "found weights that sum to 510 at [2, 0], expected a sum of 255"),
        ("node", 4, &[7, 0], "found 7 at [1, 1], expected numbers below 7"),
        ("node.part", 6, &[3, 0], "found 3 at [6], expected numbers below 3"),
        ("part_start", 0, &[1, 0, 0, 0], "found 1 at [0], expected numbers from 0 to 40 that never fall"),
        ("part_start", 1, &[41, 0, 0, 0], "found 41 at [1], expected numbers from 0 to 40 that never fall"),
        ("part_start", 1, &[40, 0, 0, 0, 39, 0, 0, 0], "found 39 at [2], expected numbers from 0 to 40 that never fall"),
        ("part_start", 3, &[39, 0, 0, 0], "found 39 at [3], expected numbers from 0 to 40 that never fall"),
        ("rotation.row", 4, &[40, 0, 0, 0], "found 40 at [4], expected numbers below 40"),
        ("scale.row", 0, &[9, 0, 0, 0, 9, 0, 0, 0], "found 9 after a number no smaller at [1], expected rising numbers"),
        ("color.row", 0, &[9, 0, 0, 0, 8, 0, 0, 0], "found 8 after a number no smaller at [1], expected rising numbers"),
        ("node.offset", 1, &[0xFF, 0x7B], "found 65504 at [0, 1], expected metres, at most 10000"),
        ("skeleton.rest", 4, &[0, 0, 0, 0x7F], "found 170141180000000000000000000000000000000 at [1, 1], expected metres, at most 10000"),
        ("pose_space.sigma", 1, &[0, 0, 0x80, 0xBF], "found -1 at [1], expected finite numbers from 0 up"),
        ("expression_space.component", 0, &[0, 0, 0, 0x40], "found rows 0 and 0 with the dot product"),
    ];
    for (tensor, at, bytes, sentence) in cases {
        let mut edit = Edit::open(&tiny_bytes());
        edit.put(tensor, *at, bytes);
        let got = avatar_fault(&edit.bytes());
        assert!(got.starts_with(&format!("in tensor `{tensor}` {sentence}")), "{got}");
    }
}

#[test]
fn metadata_that_breaks_a_rule_is_named() {
    let cases: &[(&str, Value, &str)] = &[
        ("/format", json!("effigy.motion"), "`format` found `effigy.motion`, expected `effigy.avatar`"),
        ("/version", json!(2), "`version` found 2, expected 1, the only one this program reads"),
        ("/units", json!("inch"), "`units` found \"inch\", expected \"metre\""),
        ("/up", json!("z"), "`up` found \"z\", expected \"y\""),
        ("/color_space", json!("linear"), "`color_space` found \"linear\", expected \"srgb\""),
        ("/gaussians", json!(0), "`gaussians` found 0, expected 1 to 2000000"),
        ("/gaussians", json!(2_000_001), "`gaussians` found 2000001, expected 1 to 2000000"),
        ("/gaussians", json!(41), "in tensor `position` found shape [40, 3], expected [41, 3]"),
        ("/gaussians", json!(-1), "`effigy` found invalid value: integer `-1`, expected usize"),
        ("/parts", json!(1025), "`parts` found 1025, expected 1 to 1024"),
        ("/head_parts", json!(4), "`head_parts` found 4, expected 0 to 3"),
        ("/nodes", json!(65_537), "`nodes` found 65537, expected 1 to 65536"),
        ("/basis", json!(36), "`basis` found 36, expected 4 to 32"),
        ("/basis", json!(6), "`basis` found 6, expected a multiple of 4"),
        ("/rotation_rows", json!(41), "`rotation_rows` found 41, expected 0 to 40"),
        ("/scale_rows", json!(u64::MAX), "`scale_rows` found 18446744073709551615, expected 0 to 40"),
        ("/color_rows", json!(41), "`color_rows` found 41, expected 0 to 40"),
        ("/bounds/0/1", json!(2), "`bounds` found [-1.0, 2.0, -0.3] to [1.0, 1.8, 0.3], expected a lower and an upper corner"),
        ("/bounds/1/1", json!(1e30), "`bounds` found"),
        ("/activation", json!("gelu"), "`effigy` found unknown variant `gelu`, expected `relu` or `leaky_relu`"),
        ("/widths", json!([8]), "`widths` found 1, expected 2 to 9"),
        ("/widths/0", json!(27), "`widths` found 27 inputs, expected 26, three a joint of `inputs` and the expression's length"),
        ("/widths/1", json!(132), "`widths` found 132, expected 4 to 128"),
        ("/widths/2", json!(6), "`widths` found 6, expected multiples of 4 in the hidden layers"),
        ("/widths/4", json!(12), "`widths` found 12 outputs, expected 4 or twice 4, as `basis` says"),
        ("/joints", json!([]), "`joints` found 0, expected 1 to 256"),
        ("/joints/3", json!("pelvis"), "`joints` found \"pelvis\" twice, expected names that differ"),
        ("/parents", json!([null]), "`parents` found 1 entries, expected 9, one a joint"),
        ("/parents/0", json!(0), "`parents` found 0 for joint 0, expected a parent that stands before its child, and null for joint 0"),
        ("/parents/4", json!(5), "`parents` found 5 for joint 4, expected a parent that stands before its child, and null for joint 0"),
        ("/parents/4", json!(null), "`parents` found null for joint 4, expected a parent for every joint but joint 0"),
        ("/inputs/2", json!(9), "`inputs` found joint 9, expected joints below 9"),
        ("/expression", json!(65), "`expression` found 65, expected 0 to 64"),
        ("/pose_components", json!(25), "`pose_components` found 25, expected 0 to 24"),
        ("/expression_components", json!(3), "`expression_components` found 3, expected 0 to 2"),
        ("/joints", json!({}), "`effigy` found invalid type: map, expected a sequence"),
    ];
    for (field, value, sentence) in cases {
        let mut edit = Edit::open(&tiny_bytes());
        *edit.document.pointer_mut(field).expect(field) = value.clone();
        let got = avatar_fault(&edit.bytes());
        assert!(got.strip_prefix("in metadata ").unwrap_or(&got).starts_with(sentence), "{field}: {got}");
    }
}

#[test]
fn motion_metadata_that_breaks_a_rule_is_named() {
    let cases: &[(&str, Value, &str)] = &[
        ("/format", json!("effigy.avatar"), "`format` found `effigy.avatar`, expected `effigy.motion`"),
        ("/version", json!(0), "`version` found 0, expected 1, the only one this program reads"),
        ("/units", json!("cm"), "`units` found \"cm\", expected \"metre\""),
        ("/up", json!("-y"), "`up` found \"-y\", expected \"y\""),
        ("/rate", json!(0), "`rate` found 0, expected 0.001 to 100000 frames a second"),
        ("/rate", json!(-30), "`rate` found -30, expected 0.001 to 100000 frames a second"),
        ("/rate", json!(null), "`effigy` found invalid type: null, expected f64"),
        ("/frames", json!(0), "`frames` found 0, expected at least 1"),
        ("/frames", json!(u64::MAX), "in tensor `rotation` found shape [4, 9, 3], expected [18446744073709551615, 9, 3]"),
        ("/joints", json!(vec!["a"; 257]), "`joints` found 257, expected 1 to 256"),
        ("/joints/8", json!("pelvis"), "`joints` found \"pelvis\" twice, expected names that differ"),
        ("/expression", json!(65), "`expression` found 65, expected 0 to 64"),
    ];
    for (field, value, sentence) in cases {
        let mut edit = Edit::open(&clip_bytes());
        *edit.document.pointer_mut(field).expect(field) = value.clone();
        let got = clip_fault(&edit.bytes());
        assert!(got.strip_prefix("in metadata ").unwrap_or(&got).starts_with(sentence), "{field}: {got}");
    }
}

#[test]
fn hostile_headers_are_refused_in_little_memory() {
    let deep = |n: usize| "[".repeat(n);
    let many = |item: &str| format!("{{\"a\":{{\"dtype\":\"U8\",\"data_offsets\":[0,0],\"shape\":[0{}]}}}}", item.repeat(120_000));
    let document = |text: &str| edit::raw(json!({ "__metadata__": { "effigy": text } }).to_string().as_bytes(), &[]);
    let tag = r#"{"format":"effigy.avatar","version":1,"#;
    let files = [
        vec![0xFF; 4096],
        [&(1u64 << 40).to_le_bytes()[..], &[b' '; 100]].concat(),
        edit::raw(&vec![b'{'; 300_000], &[]),
        edit::raw(b"{}", &[]),
        edit::raw(b"\xFF\xFE", &[]),
        edit::raw(deep(100_000).as_bytes(), &[]),
        edit::raw(many(",0").as_bytes(), &[]),
        edit::raw(br#"{"a":{"dtype":"F64","shape":[4294967296,4294967296,8],"data_offsets":[0,0]}}"#, &[]),
        edit::raw(br#"{"a":{"dtype":"U8","shape":[18446744073709551615],"data_offsets":[0,18446744073709551615]}}"#, &[]),
        edit::raw(br#"{"a":{"dtype":"U8","shape":[4],"data_offsets":[4,0]}}"#, &[0; 4]),
        document("null"),
        document(&deep(60_000)),
        document(&format!("{tag}\"joints\":{}", deep(60_000))),
        document(&format!("{tag}\"joints\":[{}\"\"]", "\"\",".repeat(60_000))),
        document(&format!("{tag}\"version\":1,\"name\":\"twice\"}}")),
        document(r#"{"format":"effigy.avatar","version":1e300}"#),
    ];
    for (k, file) in files.iter().enumerate() {
        let (sentence, peak) = memory::peak(|| avatar_fault(file));
        assert!(sentence.len() < 400 && !sentence.contains('\n'), "file {k}: {sentence}");
        assert!(peak <= 64 * file.len() + 10_000, "file {k} of {} bytes took {peak} bytes of memory", file.len());
    }
}

/// Whatever the bytes, reading ends with a model that can be written again or with one sentence, and takes little memory.
fn survives(bytes: &[u8]) {
    let (results, peak) = memory::peak(|| (Avatar::from_bytes(bytes), Clip::from_bytes(bytes)));
    assert!(peak <= 4 * bytes.len() + 100_000, "{} bytes took {peak} bytes of memory", bytes.len());
    if let Ok(avatar) = &results.0 {
        assert!(Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap() == *avatar);
    }
    if let Ok(clip) = &results.1 {
        assert!(Clip::from_bytes(&clip.to_bytes().unwrap()).unwrap() == *clip);
    }
    for sentence in [results.0.err().map(|e| e.to_string()), results.1.err().map(|e| e.to_string())].into_iter().flatten() {
        assert!(sentence.starts_with("found ") || sentence.starts_with("in "), "{sentence}");
        assert!(sentence.len() < 600 && !sentence.contains('\n'), "{sentence}");
    }
}

/// One random replacement somewhere in a JSON value.
fn scramble(value: &mut Value, random: &mut Random) {
    let children: Vec<&mut Value> = match value {
        Value::Array(items) => items.iter_mut().collect(),
        Value::Object(items) => items.values_mut().collect(),
        _ => vec![],
    };
    let count = children.len();
    if count > 0 && random.below(8) > 0 {
        let at = random.below(count);
        return children.into_iter().nth(at).into_iter().for_each(|child| scramble(child, random));
    }
    *value = match random.below(10) {
        0 => Value::Null,
        1 => json!(random.next()),
        2 => json!(-(random.below(1000) as i64)),
        3 => json!(random.normal() * 1e300),
        4 => json!("x".repeat(random.below(2000))),
        5 => json!([]),
        6 => json!({ "a": [0, null] }),
        7 => json!(vec![random.below(300); random.below(300)]),
        8 => json!("\u{0}\n\u{1F600}"),
        _ => json!(random.below(70)),
    };
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn flipped_bytes_do_no_harm(flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..20), motion: bool, head: bool) {
        let mut bytes = if motion { clip_bytes() } else { tiny_bytes() };
        let end = if head { 2000 } else { bytes.len() };
        flips.iter().for_each(|(at, value)| bytes[at.index(end)] = *value);
        survives(&bytes);
    }

    #[test]
    fn edited_headers_do_no_harm(seed: u64, edits in 1..4usize, motion: bool) {
        let (random, mut edit) = (&mut Random(seed), Edit::open(&if motion { clip_bytes() } else { tiny_bytes() }));
        for _ in 0..edits {
            scramble(if random.below(2) == 0 { &mut edit.header } else { &mut edit.document }, random);
        }
        if edit.header["__metadata__"].is_object() {
            survives(&edit.bytes());
        }
        survives(&edit::raw(edit.header.to_string().as_bytes(), &edit.data));
    }

    #[test]
    fn random_headers_do_no_harm(header in r#"[\[\]{}",:0-9a-z_.\\e-]{0,300}"#, data in prop::collection::vec(any::<u8>(), 0..100)) {
        survives(&edit::raw(header.as_bytes(), &data));
        survives(header.as_bytes());
    }
}
