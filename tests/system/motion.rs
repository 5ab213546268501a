//! Motion of other bodies as users play it, and what `inspect` says of any file.

use crate::common;
use effigy_core::avatar::Clip;
use serde_json::Value;
use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output},
};

fn data(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data");
    folder.join(name).display().to_string()
}

fn effigy(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(common::program())
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

/// What a command that must work prints, and what it says beside it.
fn works(folder: &Path, arguments: &[&str]) -> Said {
    let output = effigy(folder, arguments);
    let said = Said::of(&output);
    assert!(
        output.status.success() && !said.beside.contains("validation:"),
        "effigy {arguments:?}: {}",
        said.beside
    );
    said
}

fn fails(folder: &Path, arguments: &[&str]) -> String {
    let output = effigy(folder, arguments);
    let said = Said::of(&output);
    assert!(!output.status.success(), "effigy {arguments:?} works");
    said.beside
}

struct Said {
    out: String,
    beside: String,
}

impl Said {
    fn of(output: &Output) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Self {
            out: text(&output.stdout),
            beside: text(&output.stderr),
        }
    }

    fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap()
    }
}

fn pixels(path: PathBuf) -> Vec<u8> {
    image::open(path).unwrap().to_rgb8().into_raw()
}

fn motion_of_any_body_moves_the_demo() {
    let folder = tempfile::tempdir().unwrap();
    let walk = data("motion/mixamo.bvh");
    let render = |name: &str, arguments: &[&str]| {
        let common = ["render", "--size", "96x128", "--out", name];
        let said = works(folder.path(), &[&common, arguments].concat());
        assert!(
            said.beside.contains("moves 22 of 52 joints"),
            "{}",
            said.beside
        );
        pixels(folder.path().join(name))
    };
    let first = render("first.png", &[&walk]);
    let later = render("later.png", &["--motion", &walk, "--time", "1"]);
    assert_ne!(first, later);
    // Two rigs show one walk: at this size hardly a pixel is another.
    let other = render(
        "other.png",
        &["--motion", &data("motion/poser_wild.bvh"), "--time", "1"],
    );
    let off = later
        .iter()
        .zip(&other)
        .filter(|(a, b)| a.abs_diff(**b) > 32);
    assert!(off.count() < later.len() / 200);
}

fn an_imported_clip_follows_its_capture() {
    let folder = tempfile::tempdir().unwrap();
    let walk = data("motion/nameless.bvh");
    let said = works(
        folder.path(),
        &["import", &walk, "--out", "walk.motion", "--fps", "25"],
    );
    assert!(
        said.out.contains("54 frames at 25.0000 per second"),
        "{}",
        said.out
    );
    let clip = Clip::read(&folder.path().join("walk.motion")).unwrap();
    assert_eq!((clip.frames(), clip.rate), (54, 25.0));
    let against = ["inspect", "walk.motion", "--against", &walk, "--json"];
    let compared = works(folder.path(), &against).json();
    assert_eq!(compared["contacts"], 4);
    assert!(compared["slide_mm_per_second"]["max"].as_f64().unwrap() < 2.0);
    assert!(compared["bones_degrees"]["mean"].as_f64().unwrap() < 1.0);
    // Feet that are kept slide, and are not held.
    works(
        folder.path(),
        &["import", &walk, "--out", "walk.motion", "--keep-feet"],
    );
    let kept = works(folder.path(), &against).json();
    let slide = |json: &Value| json["slide_mm_per_second"]["max"].as_f64().unwrap();
    assert!(slide(&kept) > slide(&compared));
}

fn joints_can_be_corrected() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let walk = data("motion/mixamo.bvh");
    let parts = |arguments: &[&str]| {
        let all = [&["inspect", walk.as_str(), "--json"], arguments].concat();
        works(folder.path(), &all).json()["parts"].clone()
    };
    assert_eq!(parts(&[])["Head"], "mixamorig:Head");
    fs::write(at("joints.json"), r#"{"Head": "mixamorig:Neck"}"#).unwrap();
    assert_eq!(
        parts(&["--joints", "joints.json"])["Head"],
        "mixamorig:Neck"
    );
    fs::write(at("joints.json"), r#"{"Head": 3}"#).unwrap();
    let said = fails(
        folder.path(),
        &["inspect", &walk, "--joints", "joints.json"],
    );
    assert!(said.contains("joints.json is no list of joints"), "{said}");
}

fn inspect_says_what_any_file_is() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    for name in [
        "smpl/amass_h.npz",
        "gltf/dance.vrma",
        "fbx/walk.fbx",
        "splats/small.sog",
    ] {
        fs::copy(data(name), at(name.rsplit('/').next().unwrap())).unwrap();
    }
    fs::create_dir(at("inner")).unwrap();
    fs::copy(data("motion/lafan.bvh"), at("inner/lafan.bvh")).unwrap();
    fs::write(at("cut.avatar"), [9; 20]).unwrap();
    fs::write(at("notes.txt"), "nothing").unwrap();
    let list = works(folder.path(), &["inspect", ".", "--json"]).json();
    let kinds: Vec<&str> = list["files"]
        .as_array()
        .unwrap()
        .iter()
        .map(|file| file["kind"].as_str().unwrap())
        .collect();
    let expected = [
        "motion, SMPL",
        "avatar",
        "motion, glTF",
        "motion, BVH",
        "splats, SOG",
        "motion, FBX",
    ];
    assert_eq!(kinds, expected);
    assert_eq!(
        (
            list["files"][1]["broken"].as_bool(),
            list["others"].as_u64()
        ),
        (Some(true), Some(1))
    );
    for (name, kind) in [("inner/lafan.bvh", "capture"), ("small.sog", "splats")] {
        let summary = works(
            folder.path(),
            &["inspect", name, "--json", "--png", "a.png"],
        )
        .json();
        assert_eq!(summary["kind"], kind);
        let picture = pixels(at("a.png"));
        assert!(picture.iter().any(|value| *value < 100));
    }
    let said = fails(folder.path(), &["inspect", "notes.txt"]);
    assert!(
        said.contains("found text of no known kind, expected an avatar"),
        "{said}"
    );
    let said = fails(folder.path(), &["render", "a.png"]);
    assert!(said.contains("found a PNG picture"), "{said}");
    let said = fails(folder.path(), &["render", "--motion", "small.sog"]);
    assert!(said.starts_with("error: small.sog: found "), "{said}");
}

tests! {
    motion_of_any_body_moves_the_demo,
    an_imported_clip_follows_its_capture,
    joints_can_be_corrected,
    inspect_says_what_any_file_is,
}
