//! SMPL's parameters in the files of programs that write them: `tests/data/smpl/make.py` and
//! `make_torch.py`, which know nothing of Effigy, wrote the files and say what they hold.

pub mod hostile;

use effigy_formats::{
    capture::{Captured, UpAxis},
    smpl::{self, Options},
};
use glam::{DMat3, DVec3};
use serde::Deserialize;
use std::collections::BTreeMap;

/// A file, by the name that the scripts gave it.
pub struct File {
    pub name: &'static str,
    pub bytes: &'static [u8],
}

macro_rules! files {
    ($($name:literal),+ $(,)?) => {
        &[$(File {
            name: $name,
            bytes: include_bytes!(concat!("../../data/smpl/", $name)),
        }),+]
    };
}

pub const FILES: &[File] = files![
    "amass_h.npz",
    "amass_x.npz",
    "smpl_params.npz",
    "aist_2.pkl",
    "aist_5.pkl",
    "wham_output.pkl",
    "romp_video.npz",
    "romp_frames.npz",
    "romp_picture.npz",
    "demo_gymnasts.pkl",
    "hmr4d_results.pt",
    "hmr4d_results_legacy.pt",
    "hps_track_0.npy",
    "vibe_output.pkl",
    "stage3_results.npz",
    "world_results.npz",
];

/// A frame as NumPy computed it.
#[derive(Deserialize)]
struct Shown {
    /// In the world, rows; joints in the file's order.
    rotation: Vec<[[f64; 3]; 3]>,
    translation: [f64; 3],
}

fn shown() -> BTreeMap<String, Vec<Shown>> {
    serde_json::from_str(include_str!("../../data/smpl/shown.json")).unwrap()
}

fn file(name: &str) -> &'static [u8] {
    FILES.iter().find(|file| file.name == name).unwrap().bytes
}

fn read(name: &str, options: &Options) -> Captured {
    smpl::from_bytes(file(name), options).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn taken(captured: &Captured, what: &str) -> Option<String> {
    let asked = captured.assumptions.iter().find(|a| a.what == what);
    asked.map(|assumption| assumption.taken.clone())
}

/// WHAM's longer person lacks the fourth frame of five, which is filled in.
const FILLED: usize = 3;

fn rotations_in_the_world_are_those_that_numpy_computes() {
    let shown = shown();
    assert_eq!(shown.len(), FILES.len());
    for (name, frames) in &shown {
        let capture = read(name, &Options::default()).capture;
        let wham = name == "wham_output.pkl";
        assert_eq!(capture.frames(), frames.len() + usize::from(wham), "{name}");
        for (at, frame) in frames.iter().enumerate() {
            let at = at + usize::from(wham && at >= FILLED);
            let world = capture.world(at);
            assert_eq!(world.len(), frame.rotation.len(), "{name}");
            for (joint, rows) in frame.rotation.iter().enumerate() {
                let expected = DMat3::from_cols_array_2d(rows).transpose();
                let off = world[joint].matrix3 - expected;
                let off = off
                    .to_cols_array()
                    .map(f64::abs)
                    .into_iter()
                    .fold(0.0, f64::max);
                let joint = &capture.joints[joint].name;
                assert!(off < 2e-6, "{name}: {joint} of frame {at} is {off} off");
            }
            // Where a translation is of the middle of the hips, that is where they are.
            let place = if wham {
                (world[1].translation + world[2].translation) / 2.0
            } else {
                world[0].translation - capture.joints[0].offset
            };
            let off = place.distance(DVec3::from(frame.translation));
            assert!(off < 2e-6, "{name}: frame {at} is {off} m off");
        }
    }
}

fn joints_make_an_upright_person_whose_left_is_at_x() {
    for file in FILES {
        let capture = read(file.name, &Options::default()).capture;
        let rest = capture.rest();
        let place = |name: &str| {
            let joint = capture.joints.iter().position(|joint| joint.name == name);
            rest[joint.unwrap()].translation
        };
        assert_eq!(capture.joints[0].name, "Hips");
        assert!(place("Head").y - place("LeftFoot").y > 1.3, "{}", file.name);
        assert!(place("LeftHand").x > 0.6 && place("RightHand").x < -0.6);
        assert!(place("LeftToeBase").z > place("LeftFoot").z);
        assert_eq!(capture.unit, Some(1.0));
    }
}

fn what_files_say_is_taken_and_what_they_leave_open_is_said() {
    let usual = |axis, whose| UpAxis::Usual { axis, whose };
    let rates = [
        ("amass_h.npz", 120.0, usual(DVec3::Z, "AMASS's files")),
        ("amass_x.npz", 60.0, usual(DVec3::Z, "AMASS's files")),
        ("smpl_params.npz", 30.0, UpAxis::Open),
        ("aist_5.pkl", 60.0, usual(DVec3::Y, "AIST++'s files")),
        ("wham_output.pkl", 30.0, UpAxis::Said(DVec3::Y)),
        ("romp_video.npz", 30.0, UpAxis::Said(DVec3::NEG_Y)),
        ("hmr4d_results.pt", 30.0, UpAxis::Said(DVec3::Y)),
        ("hps_track_0.npy", 30.0, UpAxis::Said(DVec3::NEG_Y)),
        ("vibe_output.pkl", 30.0, UpAxis::Said(DVec3::NEG_Y)),
        ("stage3_results.npz", 30.0, UpAxis::Open),
    ];
    for (name, rate, up) in rates {
        let captured = read(name, &Options::default());
        assert_eq!(captured.capture.rate, rate, "{name}");
        assert_eq!(captured.capture.up, up, "{name}");
        let said = taken(&captured, "frames a second").is_some();
        assert_eq!(said, rate == 30.0, "{name}");
    }
    let options = Options {
        rate: Some(25.0),
        ..Options::default()
    };
    assert_eq!(read("amass_h.npz", &options).capture.rate, 120.0);
    let captured = read("smpl_params.npz", &options);
    assert_eq!(captured.capture.rate, 25.0);
    assert_eq!(taken(&captured, "frames a second"), None);
    let fingers = taken(&captured, "fingers");
    assert_eq!(fingers.as_deref(), Some("turned from a flat hand"));
    assert_eq!(captured.capture.expression_len, 10);
    assert_eq!(captured.capture.expression[33], 33.0 / 8.0);
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let options = Options {
            rate: Some(rate),
            ..Options::default()
        };
        assert!(smpl::from_bytes(file("smpl_params.npz"), &options).is_err());
    }
}

fn one_person_of_several_is_taken() {
    let other = Options {
        person: 1,
        ..Options::default()
    };
    let [first, second] = [Options::default(), other].map(|o| read("wham_output.pkl", &o));
    assert_eq!(first.capture.frames(), 5);
    assert_eq!(second.capture.frames(), 2);
    assert_eq!(taken(&second, "person").as_deref(), Some("2 of 2"));
    let filled = taken(&first, "frames without the person");
    assert!(filled.unwrap().starts_with("1 filled in"));
    let slahmr = read("world_results.npz", &other);
    let alone = read("stage3_results.npz", &Options::default());
    assert_eq!(slahmr.capture, alone.capture);
    assert_eq!(taken(&slahmr, "person").as_deref(), Some("2 of 2"));
    let humans = read("demo_gymnasts.pkl", &Options::default());
    assert_eq!(taken(&humans, "person").as_deref(), Some("1 of 2"));
    assert_eq!(read("demo_gymnasts.pkl", &other).capture.frames(), 2);
    let none = Options {
        person: 2,
        ..Options::default()
    };
    for name in [
        "wham_output.pkl",
        "demo_gymnasts.pkl",
        "romp_frames.npz",
        "world_results.npz",
    ] {
        assert!(smpl::from_bytes(file(name), &none).is_err(), "{name}");
    }
}

fn a_file_without_a_place_stays_in_one() {
    let vibe = read("vibe_output.pkl", &Options::default());
    let place = taken(&vibe, "place");
    assert_eq!(place.as_deref(), Some("the same in each frame"));
    let count = vibe.capture.joints.len();
    let mut roots = vibe.capture.local.iter().step_by(count);
    assert!(roots.all(|root| root.offset == vibe.capture.local[0].offset));
    for name in ["amass_h.npz", "world_results.npz", "wham_output.pkl"] {
        assert_eq!(taken(&read(name, &Options::default()), "place"), None);
    }
}

tests! {
    a_file_without_a_place_stays_in_one,
    rotations_in_the_world_are_those_that_numpy_computes,
    joints_make_an_upright_person_whose_left_is_at_x,
    what_files_say_is_taken_and_what_they_leave_open_is_said,
    one_person_of_several_is_taken,
}
