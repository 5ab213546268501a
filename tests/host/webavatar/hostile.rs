//! What is wrong with a model's file is named; nothing in it makes the program panic or take memory
//! that the file does not justify.

use super::SMALL;
use crate::memory;
use effigy_formats::webavatar::{self, Options};
use half::f16;
use proptest::prelude::*;
use std::io::{Cursor, Read, Write};
use zip::{CompressionMethod, ZipArchive, ZipWriter, write::SimpleFileOptions};

/// An array of an archive as it is stored: a whole `.npy` file.
#[derive(Clone)]
struct Member {
    name: String,
    bytes: Vec<u8>,
}

fn members() -> Vec<Member> {
    let mut archive = ZipArchive::new(Cursor::new(SMALL)).unwrap();
    let read = |index: usize| {
        let mut entry = archive.by_index(index).unwrap();
        let name = entry.name().unwrap().into_owned();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).unwrap();
        Member { name, bytes }
    };
    let count = ZipArchive::new(Cursor::new(SMALL)).unwrap().len();
    (0..count).map(read).collect()
}

fn archive(members: &[Member], method: CompressionMethod) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(method);
    for member in members {
        writer.start_file(member.name.clone(), options).unwrap();
        writer.write_all(&member.bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

fn fault(bytes: &[u8]) -> String {
    match webavatar::from_bytes(bytes, "a", &Options::default()) {
        Ok(_) => "none".into(),
        Err(error) => error.to_string(),
    }
}

fn npy(descr: &str, shape: &str, numbers: &[u8]) -> Vec<u8> {
    let text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.bytes());
    bytes.extend(numbers);
    bytes
}

/// The fault of a file in which one array is another.
fn with(name: &str, bytes: Vec<u8>) -> String {
    let mut members = members();
    let member = members.iter_mut().find(|m| m.name == format!("{name}.npy"));
    member.unwrap().bytes = bytes;
    fault(&archive(&members, CompressionMethod::Stored))
}

fn each_fault_is_named() {
    let count = 160;
    let halves = |value: f32, count: usize| f16::from_f32(value).to_le_bytes().repeat(count);
    let words = |value: u16, count: usize| value.to_le_bytes().repeat(count);
    let mut without = members();
    without.retain(|member| member.name != "opacity.npy");
    let cases = [
        (fault(b"nothing"), "a NumPy .npz"),
        (fault(&SMALL[..SMALL.len() / 2]), "a NumPy .npz"),
        (
            fault(&archive(&without, CompressionMethod::Stored)),
            "in tensor `opacity` found nothing",
        ),
        (
            with("_xyz", npy("<f2", "(160, 2)", &halves(0.0, 320))),
            "in tensor `_xyz` found the shape [160, 2], expected [160, 3]",
        ),
        (
            with("_xyz", npy("<f2", "(0, 3)", &[])),
            "in tensor `_xyz` found 0, expected 1 to",
        ),
        (
            with("_scaling", npy("<f2", "(160, 3)", &halves(f32::NAN, 480))),
            "in tensor `_scaling` found NaN at 0",
        ),
        (
            with(
                "_xyz",
                npy("<f4", "(160, 3)", &1e9f32.to_le_bytes().repeat(480)),
            ),
            "corner within ±10000 metres",
        ),
        (
            with("gs_feat_knn", npy("<u2", "(160,)", &words(4, count))),
            "in tensor `gs_feat_knn` found 4 at 0, expected integers below 4",
        ),
        (
            with("gs_ctrl_knn", npy("<u2", "(160, 3)", &words(14, 3 * count))),
            "in tensor `gs_ctrl_knn` found node 14",
        ),
        (
            with(
                "gs_ctrl_knn_weights",
                npy("<f2", "(160, 3)", &halves(0.0, 480)),
            ),
            "weights from 0 that sum to 1",
        ),
        (
            with("weights_val", npy("|u1", "(160, 4)", &[0; 640])),
            "in tensor `weights_val` found [0, 0, 0, 0] at row",
        ),
        (
            with("weights_idx", npy("|u1", "(160, 4)", &[55; 640])),
            "in tensor `weights_idx` found 55 at 0",
        ),
        (
            with(
                "rot_idxs",
                npy("<u4", "(24,)", &7u32.to_le_bytes().repeat(24)),
            ),
            "in tensor `rot_idxs` found Gaussian 7 twice",
        ),
        (
            with("t_joints", npy("<f2", "(24, 3)", &halves(0.0, 72))),
            "in tensor `t_joints` found the shape [24, 3], expected [55, 3]",
        ),
        (
            with("opacity", npy("|O", "(160,)", b"\x80\x04cos\nsystem\n.")),
            "floats of 2, 4 or 8 bytes",
        ),
        (
            with("num_xyz_ft_head", npy("<u4", "()", &5u32.to_le_bytes())),
            "in tensor `num_xyz_ft_head` found 5",
        ),
        (
            with("_rotation", npy("<f2", "(160, 4)", &halves(0.0, 640))),
            "a quaternion of length 0",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.contains(expected), "{found}, expected {expected}");
    }
}

/// Neither a shape nor what a zip unpacks to costs more than the file allows.
fn memory_follows_from_the_file_not_from_its_word() {
    for shape in [
        format!("({0}, {0}, {0})", usize::MAX),
        format!("({}, 3)", u32::MAX),
        "(2000001, 3)".into(),
    ] {
        let mut members = members();
        members[0].bytes = npy("<f2", &shape, &[0; 64]);
        let bytes = archive(&members, CompressionMethod::Stored);
        let (found, peak) = memory::peak(|| fault(&bytes));
        assert!(found.contains("bytes of numbers"), "{found}");
        assert!(peak < 4 * bytes.len() + (1 << 20), "{shape}: {peak} bytes");
    }
    let bomb = Member {
        name: "_xyz.npy".into(),
        bytes: npy("<f2", "(33554432, 3)", &vec![0; 6 << 25]),
    };
    let bytes = archive(&[bomb], CompressionMethod::Deflated);
    let (found, peak) = memory::peak(|| fault(&bytes));
    assert!(found.contains("unpacks to more than"), "{found}");
    assert!(peak < 4 * bytes.len() + (64 << 20), "{peak} bytes");
}

fn a_file_that_ends_too_soon_is_refused_wherever_it_ends() {
    for end in (0..SMALL.len()).step_by(97) {
        assert_ne!(fault(&SMALL[..end]), "none", "{end} bytes");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Changes inside the arrays, which the zip's checksums would hide from the reader.
    fn changed_arrays_never_panic(
        changes in prop::collection::vec(
            (any::<prop::sample::Index>(), any::<prop::sample::Index>(), any::<u8>()), 1..6),
        in_header in any::<bool>(),
    ) {
        let mut members = members();
        for (member, at, byte) in changes {
            let bytes = &mut member.get_mut(&mut members).bytes;
            let end = if in_header { bytes.len().min(128) } else { bytes.len() };
            bytes[at.index(end)] = byte;
        }
        let bytes = archive(&members, CompressionMethod::Stored);
        if let Ok(imported) = webavatar::from_bytes(&bytes, "a", &Options::default()) {
            prop_assert!(imported.avatar.check().is_ok());
        }
    }

    fn changed_bytes_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let mut bytes = SMALL.to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let _ = fault(&bytes);
    }
}

tests! {
    each_fault_is_named,
    memory_follows_from_the_file_not_from_its_word,
    a_file_that_ends_too_soon_is_refused_wherever_it_ends,
    changed_arrays_never_panic,
    changed_bytes_never_panic,
}
