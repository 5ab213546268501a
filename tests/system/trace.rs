//! `--trace`: the file that the program writes, looked at as a viewer of traces does.

use crate::common::{self, gpu};
use serde_json::Value;
use std::{collections::BTreeMap, fs, path::Path, process::Command};

/// Runs the program, and reads the trace that it writes.
fn trace(folder: &Path, arguments: &str) -> Value {
    common::small_files(folder);
    let output = Command::new(common::program())
        .args(arguments.split_whitespace())
        .args(["--trace", "trace.json"])
        .current_dir(folder)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && !said.contains("validation:"),
        "effigy {arguments}: {said}"
    );
    serde_json::from_str(&fs::read_to_string(folder.join("trace.json")).unwrap()).unwrap()
}

/// A slice: name, begin and end, µs.
type Slice = (String, f64, f64);

/// The slices of each track, as they come.
fn slices(trace: &Value) -> BTreeMap<u64, Vec<Slice>> {
    let mut tracks: BTreeMap<u64, Vec<Slice>> = BTreeMap::new();
    for event in trace["traceEvents"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|event| event["ph"] == "X")
    {
        let [ts, dur] = ["ts", "dur"].map(|key| event[key].as_f64().unwrap());
        assert!(ts >= 0.0 && dur >= 0.0, "{event}");
        tracks
            .entry(event["tid"].as_u64().unwrap())
            .or_default()
            .push((event["name"].as_str().unwrap().into(), ts, ts + dur));
    }
    tracks
}

/// A rounding of both ends, µs.
const ROUNDING: f64 = 0.002;

/// Every frame is a slice, its parts lie in it one after the other, and frames begin in order.
fn check_track(what: &str, slices: &[Slice]) -> Vec<Slice> {
    let mut frames: Vec<Slice> = Vec::new();
    let mut free = f64::NEG_INFINITY;
    for slice in slices {
        if slice.0.starts_with("frame ") {
            assert!(
                frames.last().is_none_or(|last| last.1 <= slice.1),
                "{what}: {slice:?} begins before the frame before it"
            );
            frames.push(slice.clone());
            free = slice.1;
            continue;
        }
        let frame = frames
            .last()
            .unwrap_or_else(|| panic!("{what}: {slice:?} is in no frame"));
        assert!(
            slice.1 >= free - ROUNDING && slice.2 <= frame.2 + ROUNDING,
            "{what}: {slice:?} sticks out of {frame:?}, or overlaps"
        );
        free = slice.2;
    }
    frames
}

/// The whole file: tracks, frames on both, and the device after the host.
fn check(trace: &Value, min_frames: usize) {
    let events = trace["traceEvents"].as_array().unwrap();
    let names: Vec<_> = events
        .iter()
        .filter(|event| event["ph"] == "M")
        .map(|event| event["args"]["name"].as_str().unwrap())
        .collect();
    assert!(
        names.len() == 2 && names[0] == "frames on the host",
        "{names:?}"
    );
    let tracks = slices(trace);
    let host = check_track("host", &tracks[&1]);
    assert!(host.len() >= min_frames, "{} frames", host.len());
    let said = &trace["otherData"];
    let Some(track) = tracks.get(&2) else {
        assert!(
            said["alignment"].as_str().unwrap().starts_with("none"),
            "{said}"
        );
        return;
    };
    let device = check_track("device", track);
    let within = said["alignment_within_us"].as_f64().unwrap();
    println!(
        "{}: within {within} us, {} frames",
        said["alignment"],
        device.len()
    );
    assert!(
        track.iter().any(|slice| slice.0 == "project")
            && track.iter().any(|slice| slice.0 == "raster")
    );
    // Calibrated clocks are read at once; others to what a submission takes on a busy machine.
    let bound = if said["alignment"] == "calibrated timestamps" {
        1000.0
    } else {
        50_000.0
    };
    assert!((0.0..bound).contains(&within), "{said}");
    let begins: BTreeMap<_, _> = host.iter().map(|frame| (&frame.0, frame)).collect();
    let submits: Vec<_> = tracks[&1]
        .iter()
        .filter(|slice| slice.0 == "submit")
        .collect();
    assert_eq!(submits.len(), host.len());
    for frame in &device {
        let at = host.iter().position(|host| host.0 == frame.0).unwrap();
        assert!(
            begins.contains_key(&frame.0) && frame.1 >= submits[at].1 - within - 1.0,
            "the device begins {frame:?} before {:?}",
            submits[at]
        );
    }
    let arrows = |phase: &str| {
        events
            .iter()
            .filter(|event| event["ph"] == phase)
            .map(|event| event["id"].clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(
        (arrows("s").len(), arrows("s")),
        (device.len(), arrows("f"))
    );
}

fn a_benchmarks_trace_has_every_frame_on_both_tracks() {
    let folder = tempfile::tempdir().unwrap();
    check(
        &trace(
            folder.path(),
            "bench small.avatar --motion small.motion --size 96x128 --frames 12 --check 0",
        ),
        12,
    );
}

fn a_soaks_trace_has_frames_and_the_governors_steps() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    let trace = trace(
        folder.path(),
        "soak small.avatar --motion small.motion --minutes 0.05 --fps 4 --late 100 --growth 1000 --no-check --size 64x80",
    );
    check(&trace, 5);
    let counters = trace["traceEvents"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|event| event["ph"] == "C" && event["name"] == "governor's step");
    assert!(counters.count() >= 2);
}

tests! {
    a_benchmarks_trace_has_every_frame_on_both_tracks,
    a_soaks_trace_has_frames_and_the_governors_steps,
}
