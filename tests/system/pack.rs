//! `effigy pack` as its users run it, and what is drawn of its files.

use crate::common;
use effigy_core::{avatar::Avatar, io::file};
use effigy_measure::error;
use std::{
    path::Path,
    process::{Command, Output},
};

const SPLATS: &[u8] = include_bytes!("../data/splats/truth.ply");

fn effigy(folder: &Path, arguments: &str) -> Output {
    Command::new(common::program())
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()
        .unwrap()
}

/// What a command that must work prints.
fn works(folder: &Path, arguments: &str) -> String {
    let output = effigy(folder, arguments);
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && !err.contains("validation:"),
        "effigy {arguments}: {err}"
    );
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// The one sentence of a command that must fail.
fn fails(folder: &Path, arguments: &str) -> String {
    let output = effigy(folder, arguments);
    let err = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    assert!(
        !output.status.success() && err.starts_with("error: ") && err.lines().count() == 1,
        "effigy {arguments}: {err}"
    );
    err
}

fn read_image(path: &Path) -> effigy_core::scene::FrameImage {
    let image = image::open(path).unwrap().to_rgba32f();
    effigy_core::scene::FrameImage {
        size: [image.width(), image.height()],
        pixels: image.pixels().map(|p| p.0).collect(),
    }
}

fn pack_writes_smaller_files_and_says_what_they_cost() {
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let at = |name: &str| folder.path().join(name);
    let mut length = std::fs::metadata(at("small.avatar")).unwrap().len();
    for (quality, lines) in [("lossless", 3), ("high", 7), ("medium", 8), ("small", 8)] {
        let what = format!(
            "pack small.avatar --motion small.motion --quality {quality} --frames 1 --size 80x100"
        );
        let table = works(
            folder.path(),
            &format!("{what} --out packed.avatar --json table.json"),
        );
        let json: serde_json::Value =
            serde_json::from_str(&std::fs::read_to_string(at("table.json")).unwrap()).unwrap();
        assert_eq!(json.as_array().unwrap().len(), lines, "{table}");
        let written = std::fs::metadata(at("packed.avatar")).unwrap().len();
        assert_eq!(json[lines - 1]["file"], written);
        assert!(
            written < length && table.contains("reading it takes "),
            "{quality}: {written} bytes after {length}: {table}"
        );
        length = written;
        assert!(works(folder.path(), "inspect packed.avatar").contains("deflated"));
    }
    let read = Avatar::read(&at("packed.avatar")).unwrap();
    assert!(read.networks.in_bytes() && read.nodes.basis.is_bytes());
    assert!(works(folder.path(), "inspect packed.avatar").contains(", in bytes;"));
    // Once more changes nothing.
    works(
        folder.path(),
        "pack packed.avatar --motion small.motion --quality small --frames 0 --out again.avatar",
    );
    assert!(Avatar::read(&at("again.avatar")).unwrap() == read);
}

fn what_can_not_be_packed_or_read_is_said_in_one_sentence() {
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "pack small.avatar --motion small.motion --frames 0";
    assert!(
        fails(folder.path(), &format!("{what} --out none/a.avatar"))
            .contains("none/a.avatar can't be written: there is no folder none")
    );
    std::fs::write(folder.path().join("a.ply"), "ply\n").unwrap();
    assert!(fails(folder.path(), "pack a.ply --out a.avatar").contains("without `end_header`"));
    let motion = fails(folder.path(), "pack small.motion --out a.avatar");
    assert!(motion.contains("small.motion is motion, expected an avatar"));
    works(folder.path(), &format!("{what} --out packed.avatar"));
    let path = folder.path().join("packed.avatar");
    let mut bytes = std::fs::read(&path).unwrap();
    let deflated = file::tensors(&path)
        .unwrap()
        .iter()
        .any(|tensor| tensor.deflated.is_some());
    let middle = bytes.len() * 2 / 3;
    bytes[middle] ^= 0x55;
    std::fs::write(&path, &bytes).unwrap();
    let sentence = fails(folder.path(), "inspect packed.avatar");
    assert!(
        deflated
            && sentence.contains("packed.avatar: in tensor `")
            && sentence.contains(", expected "),
        "{sentence}"
    );
    std::fs::write(&path, &bytes[..middle]).unwrap();
    assert!(fails(folder.path(), "inspect packed.avatar").ends_with("the file is incomplete"));
}

fn packed_files_are_drawn_as_the_reference_draws_them() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    works(
        folder.path(),
        "pack --quality small --frames 0 --out packed.avatar",
    );
    // As large as it is shown: a device that draws no triangles supersamples nothing.
    let what = "render packed.avatar --size 200x260 --time 1.5 --supersample 1";
    for name in ["gpu.png", "exact.png --reference"] {
        works(folder.path(), &format!("{what} --out {name}"));
    }
    let error = error::between(&read_image(&at("gpu.png")), &read_image(&at("exact.png")));
    assert!(error.whole.psnr_db > 45.0, "{error:?}");
}

fn the_projection_can_be_switched_off() {
    let folder = tempfile::tempdir().unwrap();
    for (name, project) in [
        ("default", ""),
        ("on", "--project on"),
        ("off", "--project off"),
    ] {
        works(
            folder.path(),
            &format!("render --reference --size 120x150 --time 1.5 --out {name}.png {project}"),
        );
    }
    let [default, on, off] =
        ["default", "on", "off"].map(|name| read_image(&folder.path().join(format!("{name}.png"))));
    assert!(
        default == on && on != off,
        "the projection changes nothing of the demo"
    );
}

fn facing_is_found_written_and_drawn() {
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "pack small.avatar --motion small.motion --facing --frames 2 --size 80x100";
    let table = works(folder.path(), &format!("{what} --out faced.avatar"));
    assert!(
        table.contains("\nfacing") && table.contains("% of the Gaussians face away"),
        "{table}"
    );
    let faced = Avatar::read(&folder.path().join("faced.avatar")).unwrap();
    assert_eq!(faced.gaussians.facing.len(), faced.gaussians.len());
    let said = works(folder.path(), "inspect faced.avatar");
    assert!(said.contains("facing"), "{said}");
    // Levels that are made later face too.
    let what = "pack faced.avatar --motion small.motion --levels --frames 0";
    works(folder.path(), &format!("{what} --out levels.avatar"));
    let levels = Avatar::read(&folder.path().join("levels.avatar")).unwrap();
    assert!(
        levels
            .levels
            .iter()
            .all(|level| !level.gaussians.facing.is_empty())
    );
    std::fs::write(folder.path().join("truth.ply"), SPLATS).unwrap();
    let refused = effigy(folder.path(), "pack truth.ply --facing --out s.avatar");
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        !refused.status.success() && said.contains("--facing is for avatars that move"),
        "{said}"
    );
}

tests! {
    facing_is_found_written_and_drawn: no_device,
    pack_writes_smaller_files_and_says_what_they_cost: no_device,
    what_can_not_be_packed_or_read_is_said_in_one_sentence: no_device,
    packed_files_are_drawn_as_the_reference_draws_them,
    the_projection_can_be_switched_off: no_device,
}
