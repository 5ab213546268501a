//! What is wrong with a motion file is named; nothing in it makes the program panic or take memory
//! that the file does not justify.

use super::WILD;
use crate::memory;
use effigy_formats::{
    bvh,
    retarget::{self, RetargetOptions},
};
use proptest::prelude::*;

/// Bytes that any file may take.
const ALWAYS: usize = 64 << 20;

fn fault(text: &str) -> String {
    bvh::from_bytes(text.as_bytes()).map_or_else(|error| error.to_string(), |_| "none".into())
}

/// The sound part of a file, and what follows.
fn with(motion: &str) -> String {
    let joint = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n";
    fault(&format!("{joint}}}\n{motion}"))
}

fn each_fault_is_named_with_its_line() {
    let cases = [
        (fault(""), "without a MOTION section"),
        (fault("HIERARCHY\nMOTION\n"), "no joint with channels"),
        (fault("HIERARCHY\n}\nMOTION\n"), "`}` in line 2"),
        (fault("HIERARCHY\nROOT\n"), "no name in line 2"),
        (fault("HIERARCHY\nROOT a\nROOT b\n"), "`ROOT b` in line 3"),
        (fault("HIERARCHY\nROOT a\nMOTION\n"), "`a` without its end"),
        (fault("HIERARCHY\nOFFSET 0 0 0\n"), "OFFSET in line 2"),
        (
            fault("HIERARCHY\nROOT a {\nOFFSET 0 nan 0\n"),
            "`nan` in line 3",
        ),
        (
            fault("HIERARCHY\nROOT a {\nOFFSET 0 0\n"),
            "the end in line 3",
        ),
        (
            fault("HIERARCHY\nROOT a {\nCHANNELS 2 Xrotation\n"),
            "1 channels in line 3, expected 2",
        ),
        (
            fault("HIERARCHY\nROOT a {\nCHANNELS 1 Wrotation\n"),
            "`Wrotation` in line 3",
        ),
        (
            fault("HIERARCHY\nROOT a {\nEnd Site {\nJOINT b\n"),
            "`JOINT b` in line 4",
        ),
        (
            fault("HIERARCHY\nROOT a {\nSCALE 1\n"),
            "`SCALE 1` in line 3",
        ),
        (
            with("MOTION\n"),
            "found the end of the file, expected `Frames:`",
        ),
        (with("MOTION\nFrames: x\n"), "`x` in line 8"),
        (
            with("MOTION\nFrames: 1\nFrame Time: 0\n0 0 0\n"),
            "a frame time of 0 s",
        ),
        (
            with("MOTION\nFrames: 1\nFrame Time: 1e7\n0 0 0\n"),
            "expected a millionth to a thousand",
        ),
        (
            // Braces anywhere, and lines that end as on old machines.
            fault(
                "HIERARCHY\rROOT a { OFFSET 0 0 0\rCHANNELS 3 Xrotation Yrotation Zrotation\rEnd Site { OFFSET 0 1 0 } }\rMOTION\rFrames: 1\rFrame Time: 1\r0 0 0\r",
            ),
            "none",
        ),
        (
            with("MOTION\nFrames: 1\nFrame Time: 1\n0 0\n"),
            "2 numbers in the motion, expected a frame of 3",
        ),
        (
            with("MOTION\nFrames: 1\nFrame Time: 1\n0 0 1e999\n"),
            "`1e999` in line 10",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.contains(expected), "\"{found}\" lacks \"{expected}\"");
    }
}

fn deep_and_wide_trees_are_refused() {
    let joint = "JOINT j {\n";
    let deep = format!("HIERARCHY\nROOT a {{\n{}", joint.repeat(100_000));
    assert!(fault(&deep).contains("more than 4096 joints"));
    let wide = format!("HIERARCHY\nROOT a {{\n{}", "JOINT j {\n}\n".repeat(100_000));
    assert!(fault(&wide).contains("more than 4096 joints"));
    // The widest that is read is searched for a body in reasonable time.
    let leaf = "JOINT j {\nOFFSET 1 0 0\n}\n".repeat(4095);
    let text = format!(
        "HIERARCHY\nROOT a {{\nCHANNELS 1 Xrotation\n{leaf}}}\nMOTION\nFrames: 1\nFrame Time: 1\n0\n"
    );
    retargeted(text.as_bytes());
}

fn skeleton() -> effigy_core::avatar::Skeleton {
    effigy_demo::avatar().unwrap().skeleton
}

/// Reads a file and moves the demo by it, if it can be.
fn retargeted(bytes: &[u8]) {
    let (captured, peak) = memory::peak(|| bvh::from_bytes(bytes));
    assert!(peak <= 4 * bytes.len() + ALWAYS, "{peak} bytes");
    if let Ok(captured) = captured {
        let options = RetargetOptions::default();
        if let Ok(made) = retarget::retarget(&captured.capture, &skeleton(), "x", &options) {
            assert!(made.clip.frames() > 0);
        }
    }
}

fn no_prefix_panics() {
    for end in (0..WILD.len()).step_by(7) {
        let _ = bvh::from_bytes(&WILD[..end]);
    }
    for end in (0..WILD.len()).step_by(511) {
        retargeted(&WILD[..end]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    fn no_edit_panics(edits in proptest::collection::vec((0..WILD.len(), any::<u8>()), 1..6)) {
        let mut bytes = WILD.to_vec();
        for (at, byte) in edits {
            bytes[at] = byte;
        }
        retargeted(&bytes);
    }
}

fn a_large_file_takes_memory_in_proportion() {
    let start = WILD
        .windows(11)
        .position(|window| window == b"Frame Time:")
        .unwrap();
    let line = start
        + WILD[start..]
            .iter()
            .position(|byte| *byte == b'\n')
            .unwrap()
        + 1;
    let mut bytes = WILD[..line].to_vec();
    while bytes.len() < 8 << 20 {
        bytes.extend(&WILD[line..]);
        bytes.push(b'\n');
    }
    let (captured, peak) = memory::peak(|| bvh::from_bytes(&bytes));
    assert!(captured.unwrap().capture.frames() > 10_000);
    assert!(peak <= 4 * bytes.len(), "{peak} bytes for {}", bytes.len());
}

tests! {
    each_fault_is_named_with_its_line,
    deep_and_wide_trees_are_refused,
    no_prefix_panics,
    no_edit_panics,
    a_large_file_takes_memory_in_proportion,
}
