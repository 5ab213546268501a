//! Cut, adversarial and random files do no harm: no panic, and no more memory than the file justifies.

use super::edit::{self, Edit};
use super::packed::packed_bytes;
use super::scans::packed_scan_bytes;
use super::{avatar_fault, clip_bytes, tiny_bytes};
use crate::common::{self, Random, Sizes};
use crate::memory;
use effigy_core::avatar::{Avatar, Clip};
use proptest::prelude::*;
use serde_json::{Value, json};

fn a_file_cut_at_any_length_is_refused() {
    for bytes in [
        tiny_bytes(),
        clip_bytes(),
        packed_bytes(),
        packed_scan_bytes(),
    ] {
        for length in 0..bytes.len() {
            let (result, peak) = memory::peak(|| {
                (
                    Avatar::from_bytes(&bytes[..length]).err(),
                    Clip::from_bytes(&bytes[..length]).err(),
                )
            });
            assert!(
                result.0.is_some() && result.1.is_some(),
                "cut to {length} of {}",
                bytes.len()
            );
            assert!(
                peak < 100_000,
                "cut to {length} of {}: {peak} bytes of memory",
                bytes.len()
            );
        }
    }
    let bytes = tiny_bytes();
    let sentence = avatar_fault(&bytes[..bytes.len() - 100]);
    assert!(
        sentence.starts_with("found ")
            && sentence.ends_with(" as the header says; the file is incomplete"),
        "{sentence}"
    );
    assert!(avatar_fault(&[&bytes[..], &[0]].concat()).ends_with(" as the header says"));
}

fn adversarial_headers_are_refused_in_little_memory() {
    let deep = |n: usize| "[".repeat(n);
    let many = |item: &str| {
        format!(
            "{{\"a\":{{\"dtype\":\"U8\",\"data_offsets\":[0,0],\"shape\":[0{}]}}}}",
            item.repeat(120_000)
        )
    };
    let document = |text: &str| {
        edit::raw(
            json!({ "__metadata__": { "effigy": text } })
                .to_string()
                .as_bytes(),
            &[],
        )
    };
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
        assert!(
            sentence.len() < 400 && !sentence.contains('\n'),
            "file {k}: {sentence}"
        );
        assert!(
            peak <= 64 * file.len() + 10_000,
            "file {k} of {} bytes took {peak} bytes of memory",
            file.len()
        );
    }
}

fn a_header_too_long_is_refused_before_it_is_parsed() {
    let file = edit::raw(&[b'['; 300_000], &[]);
    let (sentence, peak) = memory::peak(|| avatar_fault(&file));
    assert_eq!(
        sentence,
        "found a header of 300000 bytes, expected at most 262144; this is no avatar or motion file"
    );
    assert!(peak < 10_000, "{peak} bytes of memory");
}

fn reading_takes_no_more_memory_than_the_file_is_long() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.avatar");
    common::avatar(
        1,
        Sizes {
            gaussians: 20_000,
            ..Sizes::default()
        },
    )
    .write(&path)
    .unwrap();
    let length = std::fs::metadata(&path).unwrap().len() as usize;
    let (avatar, peak) = memory::peak(|| Avatar::read(&path).unwrap());
    assert_eq!(avatar.gaussians.len(), 20_000);
    assert!(
        peak <= length + 50_000,
        "a file of {length} bytes took {peak} bytes of memory"
    );
}

/// Whatever the bytes, reading ends with a model that can be written again or with one sentence,
/// and takes little memory.
fn survives(bytes: &[u8]) {
    let (results, peak) = memory::peak(|| (Avatar::from_bytes(bytes), Clip::from_bytes(bytes)));
    // What is deflated may be 16 times as long in memory, and is there twice for a moment; what it
    // is expanded from is 64 KiB more.
    assert!(
        peak <= 40 * bytes.len() + 250_000,
        "{} bytes took {peak} bytes of memory",
        bytes.len()
    );
    if let Ok(avatar) = &results.0 {
        assert!(Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap() == *avatar);
    }
    if let Ok(clip) = &results.1 {
        assert!(Clip::from_bytes(&clip.to_bytes().unwrap()).unwrap() == *clip);
    }
    for sentence in [
        results.0.err().map(|e| e.to_string()),
        results.1.err().map(|e| e.to_string()),
    ]
    .into_iter()
    .flatten()
    {
        assert!(
            sentence.starts_with("found ") || sentence.starts_with("in "),
            "{sentence}"
        );
        assert!(
            sentence.len() < 600 && !sentence.contains('\n'),
            "{sentence}"
        );
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
        return children
            .into_iter()
            .nth(at)
            .into_iter()
            .for_each(|child| scramble(child, random));
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

/// A file of each kind.
fn file(kind: i32) -> Vec<u8> {
    match kind {
        0 => tiny_bytes(),
        1 => clip_bytes(),
        2 => packed_bytes(),
        _ => packed_scan_bytes(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    fn flipped_bytes_do_no_harm(flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..20), kind in 0..4, head: bool) {
        let mut bytes = file(kind);
        let end = if head { 1000 } else { bytes.len() };
        flips.iter().for_each(|(at, value)| bytes[at.index(end)] = *value);
        survives(&bytes);
    }

    fn edited_headers_do_no_harm(seed: u64, edits in 1..4usize, kind in 0..4) {
        let (random, mut edit) = (&mut Random(seed), Edit::open(&file(kind)));
        for _ in 0..edits {
            scramble(if random.below(2) == 0 { &mut edit.header } else { &mut edit.document }, random);
        }
        if edit.header["__metadata__"].is_object() {
            survives(&edit.bytes());
        }
        survives(&edit::raw(edit.header.to_string().as_bytes(), &edit.data));
    }

    fn random_headers_do_no_harm(header in r#"[\[\]{}",:0-9a-z_.\\e-]{0,300}"#, data in prop::collection::vec(any::<u8>(), 0..100)) {
        survives(&edit::raw(header.as_bytes(), &data));
        survives(header.as_bytes());
    }
}

tests! {
    a_file_cut_at_any_length_is_refused,
    adversarial_headers_are_refused_in_little_memory,
    a_header_too_long_is_refused_before_it_is_parsed,
    reading_takes_no_more_memory_than_the_file_is_long,
    flipped_bytes_do_no_harm,
    edited_headers_do_no_harm,
    random_headers_do_no_harm,
}
