//! Animations of glTF: `tests/data/gltf/make.py`, which knows nothing of Effigy, wrote the files and
//! computed where their joints are.

pub mod hostile;

use effigy_core::io::file::FormatError;
use effigy_formats::{
    capture::{Capture, Captured, Rest, UpAxis},
    gltf_motion::{self, Options},
};
use glam::{DAffine3, DMat3, DVec3};
use serde::Deserialize;
use serde_json::{Value, json};

pub const GLB: &[u8] = include_bytes!("../../data/gltf/dance.glb");
pub const EMBEDDED: &[u8] = include_bytes!("../../data/gltf/dance.gltf");
const BESIDE: &[u8] = include_bytes!("../../data/gltf/dance_beside.gltf");
const BYTES: &[u8] = include_bytes!("../../data/gltf/dance bytes.bin");
const VRM_0: &[u8] = include_bytes!("../../data/gltf/vrm0.vrm");
const VRM_1: &[u8] = include_bytes!("../../data/gltf/vrm1.vrm");
pub const VRMA: &[u8] = include_bytes!("../../data/gltf/dance.vrma");

/// Joints in the world, by the order of the skin.
#[derive(Deserialize)]
struct Joints {
    /// Rows.
    rotation: Vec<[[f64; 3]; 3]>,
    translation: Vec<[f64; 3]>,
}

#[derive(Deserialize)]
struct Shown {
    frames: Vec<Joints>,
    nodes: Joints,
    bind: Joints,
}

fn shown() -> Shown {
    serde_json::from_str(include_str!("../../data/gltf/shown.json")).unwrap()
}

fn read(bytes: &[u8], options: &Options) -> Captured {
    gltf_motion::from_bytes(bytes, options, &mut |path| {
        (path == "dance bytes.bin").then(|| BYTES.to_vec())
    })
    .unwrap()
}

fn compare(what: &str, own: &[DAffine3], expected: &Joints) {
    for (joint, own) in own.iter().enumerate() {
        let rows = DMat3::from_cols_array_2d(&expected.rotation[joint]).transpose();
        let off = (own.matrix3 - rows).to_cols_array();
        let off = off
            .iter()
            .fold(0.0, |most: f64, number| most.max(number.abs()));
        assert!(off < 2e-6, "{what}: joint {joint} is turned {off} off");
        let off = own
            .translation
            .distance(DVec3::from(expected.translation[joint]));
        assert!(off < 2e-6, "{what}: joint {joint} is {off} m off");
    }
}

fn frames(what: &str, capture: &Capture) {
    let shown = shown();
    assert_eq!((capture.frames(), capture.rate), (7, 30.0), "{what}");
    for (at, frame) in shown.frames.iter().enumerate() {
        compare(&format!("{what}, frame {at}"), &capture.world(at), frame);
    }
}

fn joints_are_where_numpy_computes_them_from_the_specification() {
    for (what, bytes) in [
        ("glb", GLB),
        ("embedded", EMBEDDED),
        ("beside", BESIDE),
        ("vrm 0", VRM_0),
        ("vrm 1", VRM_1),
    ] {
        let capture = read(bytes, &Options::default()).capture;
        assert_eq!(capture.joints.len(), 5, "{what}");
        assert_eq!(
            (capture.unit, capture.up),
            (Some(1.0), UpAxis::Said(DVec3::Y))
        );
        frames(what, &capture);
    }
}

/// Where the skin was made, one joint is elsewhere than its node.
fn the_rest_pose_is_that_of_the_skin_or_of_the_nodes() {
    let shown = shown();
    let bind = read(GLB, &Options::default());
    compare("bind", &bind.capture.rest(), &shown.bind);
    let said = bind.assumptions.iter().find(|a| a.what == "rest pose");
    assert!(said.is_some_and(|a| a.because.starts_with("1 joints")));
    let nodes = Options {
        rest: Rest::Nodes,
        ..Options::default()
    };
    compare("nodes", &read(GLB, &nodes).capture.rest(), &shown.nodes);
    // VRM asks for a T-pose of the nodes.
    compare(
        "vrm",
        &read(VRM_1, &Options::default()).capture.rest(),
        &shown.nodes,
    );
}

fn joints_have_the_names_of_nodes_or_of_vrms_bones() {
    let names = |bytes: &[u8]| -> Vec<String> {
        let joints = read(bytes, &Options::default()).capture.joints;
        joints.into_iter().map(|joint| joint.name).collect()
    };
    assert_eq!(names(GLB), ["hips", "spine", "arm", "node 5", "unmoved"]);
    let bones = ["hips", "spine", "leftUpperArm", "leftThumbMetacarpal"];
    assert_eq!(names(VRM_0)[..4], bones);
    assert_eq!(names(VRM_1)[..4], bones);
    assert_eq!(names(VRMA), bones);
    let parents: Vec<_> = read(GLB, &Options::default())
        .capture
        .joints
        .iter()
        .map(|joint| joint.parent)
        .collect();
    assert_eq!(parents, [None, Some(0), Some(1), Some(0), Some(3)]);
}

fn animations_are_chosen_by_name_or_number() {
    let animation = |asked: &str| {
        let options = Options {
            animation: Some(asked.into()),
            ..Options::default()
        };
        gltf_motion::from_bytes(GLB, &options, &mut |_| None)
    };
    let first = read(GLB, &Options::default());
    let said = first.assumptions.iter().find(|a| a.what == "animation");
    assert_eq!(said.unwrap().taken, "`Dance`");
    assert_eq!(animation("Dance").unwrap().capture, first.capture);
    assert_eq!(animation("1").unwrap(), animation("Still").unwrap());
    let error = animation("Walk").unwrap_err().to_string();
    assert!(
        error.contains("no animation `Walk`, expected one of `Dance`, `Still`"),
        "{error}"
    );
}

fn keys_are_sampled_at_the_rate_that_is_asked_for() {
    let options = |rate| Options {
        rate: Some(rate),
        ..Options::default()
    };
    let sparse = read(GLB, &options(15.0)).capture;
    assert_eq!(sparse.frames(), 4);
    let usual = read(GLB, &Options::default()).capture;
    for frame in 0..4 {
        for (a, b) in sparse.world(frame).iter().zip(usual.world(2 * frame)) {
            assert!(a.abs_diff_eq(b, 1e-6));
        }
    }
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e12] {
        let read = gltf_motion::from_bytes(GLB, &options(rate), &mut |_| None);
        assert!(read.is_err(), "{rate}");
    }
}

/// Where the times of keys are in [`BYTES`]: of most channels, one a frame, and of three keys.
const DENSE: std::ops::Range<usize> = 320..348;
const SPARSE: std::ops::Range<usize> = 348..360;

/// The file beside whose bytes the times of keys are others.
fn with_times(
    change: impl Fn(&mut [f32]),
    places: &[std::ops::Range<usize>],
) -> Result<Captured, FormatError> {
    let mut bytes = BYTES.to_vec();
    for place in places {
        let own = bytes[place.clone()].as_chunks_mut::<4>().0;
        let mut times: Vec<f32> = own.iter().map(|time| f32::from_le_bytes(*time)).collect();
        change(&mut times);
        for (own, time) in own.iter_mut().zip(times) {
            *own = time.to_le_bytes();
        }
    }
    gltf_motion::from_bytes(BESIDE, &Options::default(), &mut |_| Some(bytes.clone()))
}

fn keys_before_second_0_are_played_from_the_first_on() {
    for start in [-0.5f32, -1.0 / 30.0, 2.0] {
        let shift = |times: &mut [f32]| times.iter_mut().for_each(|time| *time += start);
        let moved = with_times(shift, &[DENSE, SPARSE]).unwrap().capture;
        let shown = shown();
        assert_eq!(moved.frames(), 7, "{start}");
        for (at, frame) in shown.frames.iter().enumerate() {
            // Seconds are rounded to f32.
            for (own, expected) in moved.world(at).iter().zip(&frame.translation) {
                assert!(
                    own.translation.distance(DVec3::from(*expected)) < 1e-4,
                    "{start}"
                );
            }
        }
    }
}

fn the_last_of_keys_at_one_time_counts_from_then_on() {
    // Seconds that f32 has.
    let even = |times: &mut [f32]| {
        for (at, time) in times.iter_mut().enumerate() {
            *time = at as f32 / 32.0;
        }
    };
    let usual = with_times(even, &[DENSE]).unwrap().capture;
    let hips = |capture: &Capture, frame: usize| capture.local[frame * capture.joints.len()];
    for (again, frames) in [(3, 7), (6, 6), (1, 7)] {
        let twice = |times: &mut [f32]| {
            even(times);
            times[again] = times[again - 1];
        };
        let twice = with_times(twice, &[DENSE]).unwrap().capture;
        assert_eq!((twice.frames(), twice.rate), (frames, 32.0), "key {again}");
        // Where the key stood is what lies between its neighbours.
        for frame in (0..frames).filter(|&frame| frame != again) {
            let key = if frame == again - 1 { again } else { frame };
            let [own, expected] = [hips(&twice, frame), hips(&usual, key)];
            assert_eq!(own, expected, "key {again}, frame {frame}");
        }
    }
    let falls = with_times(|times| times[3] = 0.01, &[DENSE]);
    let falls = falls.unwrap_err().to_string();
    assert!(
        falls.contains("a key at 0.01 s after one at 0.06"),
        "{falls}"
    );
}

fn plain_bytes_beside_compressed_ones_are_read() {
    let mut document: Value = serde_json::from_slice(BESIDE).unwrap();
    for view in document["bufferViews"].as_array_mut().unwrap() {
        view["extensions"] = json!({"EXT_meshopt_compression": {"buffer": 1, "byteLength": 32}});
    }
    let read = |document: &Value| {
        let text = document.to_string();
        gltf_motion::from_bytes(text.as_bytes(), &Options::default(), &mut |_| {
            Some(BYTES.to_vec())
        })
    };
    frames("fallback", &read(&document).unwrap().capture);
    // gltfpack leaves the fallback without bytes.
    let length = BYTES.len();
    document["buffers"] = json!([{"byteLength": length, "extensions": {"EXT_meshopt_compression": {"fallback": true}}}]);
    let error = read(&document).unwrap_err().to_string();
    assert!(error.contains("found EXT_meshopt_compression"), "{error}");
}

tests! {
    keys_before_second_0_are_played_from_the_first_on,
    the_last_of_keys_at_one_time_counts_from_then_on,
    plain_bytes_beside_compressed_ones_are_read,
    joints_are_where_numpy_computes_them_from_the_specification,
    the_rest_pose_is_that_of_the_skin_or_of_the_nodes,
    joints_have_the_names_of_nodes_or_of_vrms_bones,
    animations_are_chosen_by_name_or_number,
    keys_are_sampled_at_the_rate_that_is_asked_for,
}
