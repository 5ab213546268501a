//! Files of other programs that commands open as they are: a checkpoint, and a folder's pictures.

use crate::common::{self, gpu};
use std::{
    fs,
    path::Path,
    process::{Command, Output},
    time::{Duration, SystemTime},
};

const CHECKPOINT: &[u8] = include_bytes!("../data/mmlphuman/chkpnt800000.pth");
const SPLATS: &[u8] = include_bytes!("../data/splats/truth.ply");
const WALK: &[u8] = include_bytes!("../data/motion/mixamo.bvh");

fn effigy(folder: &Path, arguments: &[&str]) -> Output {
    let output = Command::new(common::program())
        .args(arguments)
        .current_dir(folder)
        .env("XDG_CACHE_HOME", folder.join("cache"))
        .output()
        .unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "effigy {arguments:?}: {error}");
    output
}

/// Whether drawing a checkpoint fits an avatar to it first.
fn fits(folder: &Path, image: &str) -> bool {
    let arguments = ["render", "a.pth", "--size", "96x128", "--out", image];
    let output = effigy(folder, &arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    // Also when the avatar is there already.
    assert!(
        said.contains("canonical pose: hips turned outwards"),
        "{said}"
    );
    said.contains("an avatar is fitted to it, once")
}

fn a_checkpoint_is_drawn_and_fitted_once() {
    // A device, or the test is not run.
    drop(gpu::gpu());
    let folder = tempfile::tempdir().unwrap();
    let (folder, file) = (folder.path(), folder.path().join("a.pth"));
    fs::write(&file, CHECKPOINT).unwrap();
    assert!(fits(folder, "1.png"));
    assert!(!fits(folder, "2.png"));
    let picture = |name: &str| fs::read(folder.join(name)).unwrap();
    assert_eq!(picture("1.png"), picture("2.png"));
    // Another file at its path has an avatar of its own, and the one before is gone.
    let later = SystemTime::now() + Duration::from_secs(100);
    let opened = fs::File::options().write(true).open(&file).unwrap();
    opened.set_modified(later).unwrap();
    assert!(fits(folder, "3.png"));
    let kept = fs::read_dir(folder.join("cache/effigy/distilled")).unwrap();
    let kept: Vec<_> = kept.map(|entry| entry.unwrap().path()).collect();
    assert_eq!(kept.len(), 1);
    // One that was cut is made again.
    fs::write(&kept[0], b"cut").unwrap();
    assert!(fits(folder, "4.png"));
    assert_eq!(picture("1.png"), picture("4.png"));
}

fn a_folder_has_a_picture_of_each_file() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let files = folder.join("files");
    fs::create_dir(&files).unwrap();
    for (name, bytes) in [
        ("a.pth", CHECKPOINT),
        ("b.ply", SPLATS),
        ("c.bvh", WALK),
        ("d.txt", b"text"),
        ("e.avatar", b"broken"),
    ] {
        fs::write(files.join(name), bytes).unwrap();
    }
    let output = effigy(folder, &["inspect", "files", "--png", "all.png"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        said.contains("e.avatar"),
        "what can't be drawn is said to: {said}"
    );
    let sheet = image::open(folder.join("all.png")).unwrap().to_rgb8();
    let side = sheet.height();
    assert_eq!(
        sheet.width(),
        4 * side,
        "three files that are drawn, and a broken one"
    );
    let is_plain = |at: u32| {
        let corner = *sheet.get_pixel(at * side, 0);
        let mut cell = (0..side * side).map(|k| sheet.get_pixel(at * side + k % side, k / side));
        cell.all(|pixel| *pixel == corner)
    };
    assert_eq!([0, 1, 2, 3].map(is_plain), [false, false, false, true]);
}

tests! {
    a_checkpoint_is_drawn_and_fitted_once,
    a_folder_has_a_picture_of_each_file,
}
