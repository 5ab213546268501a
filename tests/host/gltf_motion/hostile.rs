//! What is wrong with a glTF is named; nothing in it makes the program panic, take memory that the
//! file does not justify, or run without end.

use super::{EMBEDDED, GLB, VRMA};
use crate::memory;
use effigy_formats::gltf_motion::{self, Options};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::time::Instant;

fn fault(bytes: &[u8]) -> String {
    match gltf_motion::from_bytes(bytes, &Options::default(), &mut |_| None) {
        Ok(_) => "none".into(),
        Err(error) => error.to_string(),
    }
}

fn document() -> Value {
    serde_json::from_slice(EMBEDDED).unwrap()
}

/// The fault of the file in which one value is another.
fn with(pointer: &str, value: Value) -> String {
    let mut document = document();
    let (outer, last) = pointer.rsplit_once('/').unwrap();
    let outer = document.pointer_mut(outer).unwrap();
    match last.parse::<usize>() {
        Ok(at) if outer.is_array() => outer[at] = value,
        _ => outer[last] = value,
    }
    fault(document.to_string().as_bytes())
}

fn each_fault_is_named() {
    let cases = [
        (fault(b""), "glTF 2.0"),
        (fault(b"nothing"), "glTF 2.0"),
        (fault(b"glTF\x01\0\0\0"), "found version 1"),
        (fault(&GLB[..GLB.len() - 1]), "the file is incomplete"),
        (fault(b"{}"), "no animation"),
        (with("/nodes/1/children", json!([0])), "its own ancestor"),
        (with("/nodes/1/children", json!([99])), "a child 99"),
        (with("/nodes/1/children", json!([5, 5])), "a child 5"),
        (with("/nodes/0/rotation", json!([0, 0, 0, 0])), "`nodes[0]`"),
        (
            with("/nodes/0/scale", json!([1e300, 1e300, 1e300])),
            "`nodes[0]`",
        ),
        (
            with("/skins/0/joints", json!([1, 99])),
            "a joint that is not there",
        ),
        (with("/skins/0/joints", json!([1, 2])), "expected 2 of Mat4"),
        (
            with("/animations/0/channels/0/target/node", json!(77)),
            "a node that is not there",
        ),
        (
            with("/animations/0/channels/0/sampler", json!(77)),
            "one that is not there",
        ),
        (
            with("/animations/0/samplers/0/input", json!(77)),
            "number 77 of",
        ),
        (with("/accessors/1/count", json!(0)), "expected 1 of Scalar"),
        (
            with("/accessors/1/count", json!(u64::MAX)),
            "at most 50000000",
        ),
        (with("/accessors/1/count", json!(9999)), "beyond its end"),
        (
            with("/accessors/1/byteOffset", json!(u64::MAX)),
            "beyond its end",
        ),
        (
            with("/accessors/1/componentType", json!(5123)),
            "the type 5123",
        ),
        (with("/accessors/1/type", json!("VEC2")), "of Vec2"),
        (
            with("/bufferViews/1/byteOffset", json!(u64::MAX)),
            "beyond its end",
        ),
        (
            with("/bufferViews/1/byteStride", json!(1)),
            "beyond its end",
        ),
        (
            with("/bufferViews/1/byteStride", json!(u64::MAX)),
            "beyond its end",
        ),
        (with("/bufferViews/1/buffer", json!(3)), "beyond its end"),
        (
            with(
                "/bufferViews/1",
                json!({"buffer": 9, "byteLength": 28, "extensions": {"EXT_meshopt_compression": {}}}),
            ),
            "EXT_meshopt_compression",
        ),
        (with("/buffers/0/uri", json!("../a.bin")), "beside this one"),
        (with("/buffers/0/uri", json!("a.bin")), "no file `a.bin`"),
        (
            with("/buffers/0/uri", json!("data:;base64,*")),
            "data in base64",
        ),
        (
            with("/buffers/0/uri", json!("data:;base64,AAAA")),
            "found 3 bytes",
        ),
        (with("/animations/0/channels", json!([])), "moves no joint"),
        (
            with("/animations/0/samplers/0/interpolation", json!("CURVY")),
            "glTF 2.0",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.contains(expected), "{found}, expected {expected}");
    }
}

/// A tree as deep as it is large, lists without end, hours between two keys, a thousand channels
/// of the same keys.
fn time_and_memory_follow_from_the_file() {
    let deep = json!({
        "nodes": (0..60_000).map(|k| json!({"children": [k + 1]})).chain([json!({})]).collect::<Vec<_>>(),
        "animations": [{"channels": [], "samplers": []}],
    });
    let lists = |entry: &str, name: &str| {
        let entries = vec![entry; 2_000_000].join(",");
        format!(r#"{{"{name}":[{entries}]}}"#).into_bytes()
    };
    let mut far = document();
    // Two keys that are most of a day apart.
    let days = [0f32, 65_000.0].map(f32::to_le_bytes).concat();
    let rest = [[0f32; 4]; 2]
        .map(|_| [0f32, 0.0, 0.0, 1.0].map(f32::to_le_bytes).concat())
        .concat();
    let hex = |bytes: &[u8]| -> String {
        let letters = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        bytes
            .chunks(3)
            .flat_map(|chunk| {
                let word = chunk
                    .iter()
                    .fold(0u32, |word, &byte| word << 8 | u32::from(byte))
                    << (8 * (3 - chunk.len()));
                (0..=chunk.len())
                    .map(move |k| char::from(letters[(word >> (18 - 6 * k)) as usize & 63]))
            })
            .collect()
    };
    far["buffers"] =
        json!([{"byteLength": 40, "uri": format!("data:;base64,{}", hex(&[days, rest].concat()))}]);
    far["bufferViews"] =
        json!([{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 8, "byteLength": 32}]);
    far["accessors"] = json!([
        {"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
        {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC4"},
    ]);
    far["skins"] = json!([]);
    far["animations"] = json!([{
        "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}],
        "samplers": [{"input": 0, "output": 1}],
    }]);
    // Millions of keys that no byte says.
    let mut zeros = far.clone();
    for accessor in zeros["accessors"].as_array_mut().unwrap() {
        accessor["count"] = json!(40_000_000);
        accessor["bufferView"] = json!(null);
        accessor["sparse"] = json!({
            "count": 1,
            "indices": {"bufferView": 0, "componentType": 5121},
            "values": {"bufferView": 1},
        });
    }
    let cases = [
        (deep.to_string().into_bytes(), "moves no joint"),
        (lists("{}", "nodes"), "at most 65536 entries"),
        (
            lists("{\"children\":[0,0,0,0]}", "nodes"),
            "at most 65536 entries",
        ),
        (
            lists("{\"buffer\":0,\"byteLength\":1}", "bufferViews"),
            "at most 65536 entries",
        ),
        (
            format!("{{\"x\":{}", "[".repeat(4_000_000)).into_bytes(),
            "EOF",
        ),
        (far.to_string().into_bytes(), "fewer frames a second"),
        (zeros.to_string().into_bytes(), "rows without bytes"),
    ];
    for (case, (bytes, expected)) in cases.iter().enumerate() {
        let start = Instant::now();
        let (found, peak) = memory::peak(|| fault(bytes));
        assert!(found.contains(expected), "case {case}: {found}");
        assert!(
            peak < 4 * bytes.len() + (64 << 20),
            "case {case}: {peak} of {}",
            bytes.len()
        );
        let seconds = start.elapsed().as_secs_f64();
        assert!(seconds < 5.0, "case {case}: {seconds} s");
    }
}

fn a_file_that_ends_too_soon_is_refused_wherever_it_ends() {
    for bytes in [GLB, EMBEDDED, VRMA] {
        for end in 0..bytes.len() {
            assert_ne!(fault(&bytes[..end]), "none", "{end} bytes");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    fn changed_bytes_never_panic(
        file in 0usize..3,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let mut bytes = [GLB, EMBEDDED, VRMA][file].to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let read = gltf_motion::from_bytes(&bytes, &Options::default(), &mut |_| None);
        if let Ok(captured) = read {
            let capture = captured.capture;
            prop_assert_eq!(capture.local.len(), capture.frames() * capture.joints.len());
            let turned = capture.local.iter().all(|pose| pose.rotation.is_normalized());
            prop_assert!(turned);
        }
    }

    /// Numbers of the document, which random bytes seldom leave readable.
    fn changed_numbers_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..4),
    ) {
        fn numbers<'a>(value: &'a mut Value, found: &mut Vec<&'a mut Value>) {
            match value {
                Value::Number(_) => found.push(value),
                Value::Array(list) => list.iter_mut().for_each(|value| numbers(value, found)),
                Value::Object(map) => map.values_mut().for_each(|value| numbers(value, found)),
                _ => {}
            }
        }
        let odd = [
            json!(0), json!(1), json!(2), json!(-1), json!(0.5), json!(1e308), json!(u32::MAX),
            json!(u64::MAX), json!(i64::MAX), json!(5121), json!(5126), json!(null),
        ];
        let mut document = document();
        for (at, with) in changes {
            let mut found = vec![];
            numbers(&mut document, &mut found);
            let at = at.index(found.len());
            *found[at] = with.get(&odd).clone();
        }
        let _ = fault(document.to_string().as_bytes());
    }
}

tests! {
    each_fault_is_named,
    time_and_memory_follow_from_the_file,
    a_file_that_ends_too_soon_is_refused_wherever_it_ends,
    changed_bytes_never_panic,
    changed_numbers_never_panic,
}
