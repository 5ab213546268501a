//! `convert`, and splats as every command opens them.

use crate::common::{self, harness};
use effigy_core::io::splats::Up;
use effigy_formats::open;
use std::{
    path::{Path, PathBuf},
    process::{Command, Output},
};

fn data() -> PathBuf {
    Path::new(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/data/splats"
    ))
    .to_owned()
}

fn effigy(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(common::program());
    command
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn works(folder: &Path, arguments: &[&str]) -> String {
    let output = effigy(folder, arguments);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "effigy {arguments:?}: {error}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn fails(folder: &Path, arguments: &[&str]) -> String {
    let output = effigy(folder, arguments);
    assert!(!output.status.success(), "effigy {arguments:?} should fail");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The demo in a pose is the same body in every format, upright in each.
fn a_pose_is_written_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    let demo = effigy_demo::avatar().unwrap();
    demo.write(&folder.path().join("demo.avatar")).unwrap();
    let mut first: Option<Vec<[f32; 3]>> = None;
    for name in ["a.ply", "a.glb", "a.spz", "a.splat"] {
        let said = works(
            folder.path(),
            &["convert", "demo.avatar", name, "--at", "1.5"],
        );
        assert!(said.contains("Gaussians"), "{said}");
        let found = open::splats(&folder.path().join(name), None).unwrap();
        let position = found.splats.with_up(Up::Y).position;
        assert_eq!(position.len(), demo.gaussians.len());
        let first = first.get_or_insert_with(|| position.clone());
        let pairs = first.as_flattened().iter().zip(position.as_flattened());
        let off = pairs.fold(0f32, |off, (a, b)| off.max((a - b).abs()));
        assert!(off < 5e-5, "{name}: {off} m");
    }
}

/// From every format that is read to every one that is written, and what `inspect` says of it.
fn every_format_is_converted_and_inspected() {
    let folder = tempfile::tempdir().unwrap();
    for name in [
        "truth.ply",
        "small.compressed.ply",
        "small.splat",
        "small-4.spz",
        "small.sog",
        "small-1.ksplat",
        "small.glb",
        "small.gltf",
    ] {
        let path = data().join(name);
        let path = path.to_str().unwrap();
        for out in ["a.ply", "a.glb", "a.spz", "a.splat"] {
            works(folder.path(), &["convert", path, out]);
            let said = works(folder.path(), &["inspect", out]);
            assert!(
                said.contains("splats      a\n") && said.contains("harmonics"),
                "{said}"
            );
        }
    }
}

fn what_can_not_be_converted_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let truth = data().join("truth.ply");
    let truth = truth.to_str().unwrap();
    let error = fails(folder.path(), &["convert", truth, "a.sog"]);
    assert!(
        error.contains("`a.sog` does not end in .ply, .spz, .splat, .glb"),
        "{error}"
    );
    let error = fails(
        folder.path(),
        &["convert", truth, "a.spz", "--motion", "a.motion"],
    );
    assert!(error.contains("--motion is for avatars"), "{error}");
    let error = fails(folder.path(), &["convert", "none.spz", "a.ply"]);
    assert!(error.contains("cannot read none.spz"), "{error}");
    std::fs::write(folder.path().join("a.ksplat"), [0; 64]).unwrap();
    let error = fails(folder.path(), &["convert", "a.ksplat", "a.ply"]);
    assert!(error.contains("a.ksplat: found"), "{error}");
}

/// See `tests/data/splats/check.py`.
fn the_written_files_are_read_by_other_programs() {
    let Some(programs) = std::env::var_os("SPLATS") else {
        harness::not_run("SPLATS names no folder with the programs of tests/data/splats/make.py");
    };
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(Path::new(&programs).join("bin/python"))
        .arg(data().join("check.py"))
        .arg(common::program())
        .arg(folder.path())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}{error}");
}

tests! {
    a_pose_is_written_in_every_format: no_device,
    every_format_is_converted_and_inspected: no_device,
    what_can_not_be_converted_is_said: no_device,
    the_written_files_are_read_by_other_programs: no_device,
}
