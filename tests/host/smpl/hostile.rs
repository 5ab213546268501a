//! Nothing in a file of motion is called, makes the program panic, or takes memory that the file
//! does not justify.

use super::FILES;
use crate::memory;
use effigy_formats::{
    pickle::Pickle,
    smpl::{self, Options},
};
use proptest::prelude::*;
use std::{
    io::{Cursor, Write},
    time::Instant,
};
use zip::{CompressionMethod, ZipWriter, write::SimpleFileOptions};

fn fault(bytes: &[u8]) -> String {
    match smpl::from_bytes(bytes, &Options::default()) {
        Ok(_) => "none".into(),
        Err(error) => error.to_string(),
    }
}

/// Bytes that joined pieces make.
fn joined(pieces: &[&[u8]]) -> Vec<u8> {
    pieces.concat()
}

fn npy(descr: &str, shape: &str, content: &[u8]) -> Vec<u8> {
    let text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.bytes());
    bytes.extend(content);
    bytes
}

fn archive(members: &[(&str, Vec<u8>)], method: CompressionMethod) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(method);
    for (name, content) in members {
        writer.start_file(*name, options).unwrap();
        writer.write_all(content).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// A pickle that asks for a command names it in its error, wherever it stands.
fn calls_are_refused_by_name() {
    let command = b"\x80\x02cos\nsystem\nX\x07\0\0\0echo hi\x85R.";
    let by_stack = b"\x80\x04\x8c\x05posix\x8c\x06system\x93\x8c\x02ls\x85R.";
    let evaluated = b"\x80\x02c__builtin__\neval\nX\x01\0\0\x001\x85R.";
    let opened = b"\x80\x02c__builtin__\nopen\n.";
    let from_torch = b"\x80\x02ctorch\nload\n.";
    let stored = archive(
        &[("a/data.pkl", command.to_vec())],
        CompressionMethod::Stored,
    );
    let object = archive(
        &[("results.npy", npy("|O", "()", command))],
        CompressionMethod::Deflated,
    );
    let cases: [(&[u8], &str); 8] = [
        (command, "`os.system`"),
        (by_stack, "`posix.system`"),
        (evaluated, "`__builtin__.eval`"),
        (opened, "`__builtin__.open`"),
        (from_torch, "`torch.load`"),
        (&stored, "`os.system`"),
        (&object, "`os.system`"),
        (&npy("|O", "()", command), "`os.system`"),
    ];
    for (bytes, expected) in cases {
        let found = fault(bytes);
        assert!(found.contains(expected), "{found}, expected {expected}");
    }
}

fn each_fault_is_named() {
    let poses = |shape: &str, numbers: &[u8]| {
        let members = [("poses.npy", npy("<f4", shape, numbers))];
        fault(&archive(&members, CompressionMethod::Stored))
    };
    let zeros = [0; 4 * 150];
    let without = archive(
        &[("betas.npy", npy("<f4", "(10,)", &[0; 40]))],
        CompressionMethod::Stored,
    );
    let cases = [
        (fault(b"nothing"), "the opcode 0x6e in a pickle"),
        (fault(b""), "an end inside a value"),
        (fault(b"\x78\x9c\x03\0\0"), "a compressed pickle"),
        (fault(b"\x80\x04."), "an empty stack"),
        (fault(b"\x80\x04N."), "None"),
        (fault(b"\x80\x04}."), "a dictionary of"),
        (fault(&without), "SMPL's parameters"),
        (poses("(2, 75)", &zeros), "found the shape [2, 75]"),
        (poses("(0, 72)", &[]), "found the shape [0, 72]"),
        (
            poses("(1, 72)", &f32::NAN.to_le_bytes().repeat(72)),
            "NaN at 0",
        ),
        (
            fault(&npy("<f4", "(1,)", &[0; 4])),
            "found an array of numbers",
        ),
        (
            fault(&include_bytes!("../../data/smpl/amass_h.npz")[..2000]),
            "found a zip without its end: the file is incomplete",
        ),
        (
            fault(b"\x80\x02}q\0X\x05\0\0\0posesK\x01s."),
            "`poses` found a number",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.contains(expected), "{found}, expected {expected}");
    }
}

/// Lists of lists that name themselves, calls of calls, memos of billions, text that is decoded
/// again and again: all end, soon and with little memory.
fn pickles_take_what_their_size_allows() {
    let nested = joined(&[b"\x80\x04", &[b'('; 4_000_000], b"."]);
    let laughs = {
        let mut bytes = b"\x80\x02]q\0".to_vec();
        for _ in 0..500_000 {
            bytes.extend(b"]q\x01(h\0h\0h\0h\0h\0h\0h\0h\0eq\0");
        }
        bytes.push(b'.');
        bytes
    };
    let decoded = {
        let text = "x".repeat(1 << 20);
        let length = (text.len() as u32).to_le_bytes();
        let mut bytes = joined(&[
            b"\x80\x02c_codecs\nencode\nq\0X",
            &length,
            text.as_bytes(),
            b"X\x06\0\0\0latin1\x86q\x01",
        ]);
        bytes.extend(b"h\0h\x01R".repeat(100_000));
        bytes.push(b'.');
        bytes
    };
    let own = b"\x80\x02]q\0h\0a.".to_vec();
    let arrays = joined(&[
        b"\x80\x02cnumpy.core.multiarray\n_reconstruct\nq\0cnumpy\nndarray\nK\0\x85U\x01b\x87q\x01",
        b"cnumpy\ndtype\nU\x02f4K\0K\x01\x87Rq\x02",
        b"(K\x01(",
        &b"K\x01".repeat(60),
        b"th\x02\x89U\0tq\x03",
        &b"h\0h\x01Rh\x03b".repeat(500_000),
        b".",
    ]);
    let cases = [
        nested,
        laughs,
        decoded,
        own,
        arrays,
        joined(&[b"\x80\x02", &b"Nr\xff\xff\xff\xff".repeat(1000), b"."]),
        joined(&[b"\x80\x04", &b"N\x94".repeat(4_000_000), b"."]),
        joined(&[b"\x80\x04", &b"]".repeat(4_000_000), b"."]),
        joined(&[b"\x80\x04", &b"K\x01".repeat(4_000_000), b"."]),
        joined(&[b"\x80\x04B\xff\xff\xff\xff", &[0; 64]]),
        joined(&[b"\x80\x04\x8e\xff\xff\xff\xff\xff\xff\xff\xff", &[0; 64]]),
        joined(&[b"\x80\x04\x8b\xff\xff\xff\x7f", &[0; 64]]),
    ];
    for (case, bytes) in cases.iter().enumerate() {
        let start = Instant::now();
        let (_, peak) =
            memory::peak(|| Pickle::from_bytes(bytes).map(|pickle| pickle.root().describe()));
        let allowed = 4 * bytes.len() + (64 << 20);
        assert!(
            peak < allowed,
            "case {case}: {peak} bytes of {}",
            bytes.len()
        );
        let seconds = start.elapsed().as_secs_f64();
        assert!(seconds < 5.0, "case {case}: {seconds} s");
    }
}

fn memory_follows_from_the_file_not_from_its_word() {
    for shape in [
        format!("({0}, {0}, 72)", usize::MAX),
        format!("({}, 72)", u32::MAX),
        "(2000001, 72)".into(),
    ] {
        let members = [("poses.npy", npy("<f4", &shape, &[0; 64]))];
        let bytes = archive(&members, CompressionMethod::Stored);
        let (found, peak) = memory::peak(|| fault(&bytes));
        assert!(found.contains("bytes of numbers"), "{found}");
        assert!(peak < 4 * bytes.len() + (1 << 20), "{shape}: {peak} bytes");
    }
    let members = [(
        "poses.npy",
        npy("<f4", "(500000, 72)", &vec![0; 144_000_000]),
    )];
    let bytes = archive(&members, CompressionMethod::Deflated);
    let (found, peak) = memory::peak(|| fault(&bytes));
    assert!(found.contains("unpacks to more than"), "{found}");
    assert!(peak < 4 * bytes.len() + (64 << 20), "{peak} bytes");
    // The most that a small file may unpack to takes no more as a capture.
    let members = [("poses.npy", npy("<f2", "(55000, 72)", &vec![0; 7_920_000]))];
    let bytes = archive(&members, CompressionMethod::Deflated);
    let (found, peak) = memory::peak(|| fault(&bytes));
    assert_eq!(found, "none");
    assert!(peak < 4 * bytes.len() + (64 << 20), "{peak} bytes");
}

/// f64 that were f32 and hands at rest deflate to a fourth: what the file unpacks to counts.
fn compressed_motion_is_that_of_the_plain_file() {
    let frames = 9000;
    let mut state = 1u32;
    let mut numbers = Vec::with_capacity(frames * 156 * 8);
    for _ in 0..frames {
        for column in 0..156 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let turn = if column < 66 {
                (state >> 8) as f32 / 1e8
            } else {
                0.0
            };
            numbers.extend(f64::from(turn).to_le_bytes());
        }
    }
    let members = [
        ("README.txt", b"made by hand".to_vec()),
        (
            "poses.npy",
            npy("<f8", &format!("({frames}, 156)"), &numbers),
        ),
        ("__MACOSX/._poses.npy", vec![0; 40]),
    ];
    let [plain, compressed] = [CompressionMethod::Stored, CompressionMethod::Deflated]
        .map(|method| archive(&members, method));
    assert!(3 * compressed.len() < plain.len(), "{}", compressed.len());
    let read = |bytes| {
        smpl::from_bytes(bytes, &Options::default())
            .unwrap()
            .capture
    };
    let (capture, peak) = memory::peak(|| read(&compressed));
    assert_eq!(capture, read(&plain));
    assert!(peak < 4 * plain.len() + (64 << 20), "{peak} bytes");
}

/// Arrays of other shapes than their neighbours', where a person is asked for.
fn arrays_of_other_shapes_are_refused() {
    let zeros = |count: usize| vec![0; 4 * count];
    let poses = |shape: &str, count| ("poses.npy", npy("<f4", shape, &zeros(count)));
    let people = archive(
        &[
            poses("(3, 10, 72)", 3 * 10 * 72),
            ("trans.npy", npy("<f4", "(2, 10, 3)", &zeros(2 * 10 * 3))),
        ],
        CompressionMethod::Stored,
    );
    let scalar = archive(
        &[
            poses("(10, 72)", 720),
            ("expression.npy", npy("<f4", "()", &zeros(1))),
        ],
        CompressionMethod::Stored,
    );
    for (bytes, person, expected) in [
        (&people, 2, "an array of 2 people beside one of 3"),
        (&people, 3, "3 people"),
        (&scalar, 0, "the shape []"),
        (
            &archive(&[poses("(10, 72)", 720)], CompressionMethod::Stored),
            4,
            "1 people",
        ),
    ] {
        let options = Options { rate: None, person };
        let refused = smpl::from_bytes(bytes, &options).expect_err(expected);
        assert!(refused.to_string().contains(expected), "{refused}");
    }
}

fn a_file_that_ends_too_soon_is_refused_wherever_it_ends() {
    for file in FILES {
        for end in 0..file.bytes.len() {
            let found = fault(&file.bytes[..end]);
            assert_ne!(found, "none", "{}: {end} bytes", file.name);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    fn changed_bytes_never_panic(
        file in any::<prop::sample::Index>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        person in 0usize..3,
    ) {
        let mut bytes = file.get(FILES).bytes.to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let options = Options { rate: None, person };
        if let Ok(captured) = smpl::from_bytes(&bytes, &options) {
            let capture = captured.capture;
            prop_assert_eq!(capture.local.len(), capture.frames() * capture.joints.len());
            let finite = |pose: &effigy_formats::capture::LocalPose| {
                pose.rotation.is_finite() && pose.offset.is_finite()
            };
            prop_assert!(capture.local.iter().all(finite));
        }
    }
}

tests! {
    calls_are_refused_by_name,
    each_fault_is_named,
    pickles_take_what_their_size_allows,
    memory_follows_from_the_file_not_from_its_word,
    compressed_motion_is_that_of_the_plain_file,
    arrays_of_other_shapes_are_refused,
    a_file_that_ends_too_soon_is_refused_wherever_it_ends,
    changed_bytes_never_panic,
}
