//! `render` with cameras, frames and backgrounds: which image is taken from where, and its name.

use crate::common;
use image::RgbaImage;
use std::{
    fs,
    path::Path,
    process::{Command, Output},
};

/// Draws the demo small, without a device.
fn render(folder: &Path, arguments: &str) -> Output {
    Command::new(common::program())
        .args(["render", "--reference"])
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()
        .unwrap()
}

fn works(folder: &Path, arguments: &str) -> String {
    let output = render(folder, arguments);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "effigy {arguments}: {error}");
    error
}

fn fails(folder: &Path, arguments: &str) -> String {
    let output = render(folder, arguments);
    assert!(!output.status.success(), "effigy {arguments} should fail");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn picture(folder: &Path, name: &str) -> RgbaImage {
    image::open(folder.join(name)).unwrap().to_rgba8()
}

/// A camera in front of the demo and one at its side, 48 × 64, as 3DGS and as nerfstudio write them.
const CAMERAS: &str = r#"[
    {"id": "front", "width": 48.0, "height": 64, "fx": 90, "fy": 90, "position": [0, 1, 3],
     "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]]},
    {"id": "side", "width": 48.0, "height": 64, "fx": 90, "fy": 90, "position": [3, 1, 0],
     "rotation": [[0, 0, -1], [0, -1, 0], [-1, 0, 0]]}]"#;
const TRANSFORMS: &str = r#"{"w": 48, "h": 64, "fl_x": 90, "frames": [
    {"transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 1], [0, 0, 1, 3], [0, 0, 0, 1]]},
    {"transform_matrix": [[0, 0, 1, 3], [0, 1, 0, 1], [-1, 0, 0, 0], [0, 0, 0, 1]]}]}"#;

fn cameras_of_two_layouts_draw_the_same_and_with_frames_too() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("cameras.json"), CAMERAS).unwrap();
    fs::write(folder.join("transforms.json"), TRANSFORMS).unwrap();
    let rate = effigy_demo::clip().unwrap().rate;
    let time = format!("--time {}", 20.0 / rate);
    works(
        folder,
        &format!("{time} --cameras cameras.json --out a.png"),
    );
    works(
        folder,
        &format!("{time} --cameras transforms.json --out b.png"),
    );
    works(
        folder,
        "--frames 19..21 --cameras transforms.json --out c.png",
    );
    for camera in ["0000", "0001"] {
        let own = picture(folder, &format!("a-{camera}.png"));
        assert_eq!(own.dimensions(), (48, 64));
        assert_eq!(own, picture(folder, &format!("b-{camera}.png")));
        assert_eq!(own, picture(folder, &format!("c-{camera}-0020.png")));
        assert_ne!(own, picture(folder, &format!("c-{camera}-0019.png")));
    }
    assert_ne!(picture(folder, "a-0000.png"), picture(folder, "a-0001.png"));
    assert!(fails(folder, "--frames all --follow --cameras a.json").contains("--follow"));
}

fn frames_are_counted_at_the_rate_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let clip = effigy_demo::clip().unwrap();
    let small = "--size 36x48 --out f.png";
    works(folder, &format!("{small} --fps 2 --frames 3.."));
    let last = (2.0 * clip.duration()).floor() as usize;
    let name = |frame: usize| format!("f-{frame:04}.png");
    for (frame, is_there) in [(2, false), (3, true), (last, true), (last + 1, false)] {
        assert_eq!(folder.join(name(frame)).exists(), is_there, "{frame}");
    }
    works(folder, "--size 36x48 --fps 2 --frames 3..4 --out one.png");
    works(folder, "--size 36x48 --time 1.5 --out time.png");
    assert_eq!(picture(folder, "one-0003.png"), picture(folder, "time.png"));
    let message = fails(folder, "--fps 2 --frames 0..9999");
    assert!(
        message.contains(&format!("0..{} at 2 a second", last + 1)),
        "{message}"
    );
    assert!(fails(folder, "--fps 2").contains("--frames"));
    assert!(fails(folder, "--follow").contains("--frames"));
}

/// Rows in which something is drawn, of an image without a background.
fn rows(image: &RgbaImage) -> [u32; 2] {
    let drawn = |row: &u32| (0..image.width()).any(|x| image.get_pixel(x, *row).0[3] > 64);
    let mut all = (0..image.height()).filter(drawn);
    let first = all.next().unwrap();
    [first, all.next_back().unwrap()]
}

/// The demo crouches and jumps: where a camera aims anew, it stays in the middle.
fn one_camera_holds_a_jump_and_a_crouch() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (name, option) in [
        ("held", "--size 72x96"),
        ("above", "--size 144x96 --pitch 40"),
        ("followed", "--size 72x96 --follow"),
    ] {
        let common = "--background none --fps 2 --frames all";
        works(folder, &format!("{common} {option} --out {name}.png"));
        let names = (0..).map(|frame| format!("{name}-{frame:04}.png"));
        let rows: Vec<[u32; 2]> = names
            .take_while(|name| folder.join(name).exists())
            .map(|name| rows(&picture(folder, &name)))
            .collect();
        let [heads, feet] = [0, 1].map(|side| rows.iter().map(move |rows| rows[side]));
        let inside = |row: u32| (1..95).contains(&row);
        assert!(
            heads.clone().chain(feet.clone()).all(inside),
            "{name}: {rows:?}"
        );
        let moved = |rows: &mut dyn Iterator<Item = u32>| {
            let [low, high] = rows.fold([u32::MAX, 0], |[low, high], row| {
                [low.min(row), high.max(row)]
            });
            high - low
        };
        let moved = [moved(&mut heads.clone()), moved(&mut feet.clone())];
        assert!(
            name == "above" || moved[0] > 12 && moved[1] > 6,
            "{name}: {moved:?} of {rows:?}"
        );
    }
}

fn a_picture_is_behind_the_avatar() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let sky = RgbaImage::from_pixel(64, 30, image::Rgba([10, 120, 240, 255]));
    sky.save(folder.join("sky.png")).unwrap();
    works(folder, "--size 48x64 --background sky.png --out a.png");
    works(folder, "--size 48x64 --background 0a78f0 --out b.png");
    assert_eq!(picture(folder, "a.png"), picture(folder, "b.png"));
    assert!(fails(folder, "--background blue").contains("FILE.png"));
    assert!(fails(folder, "--background none.jpg").contains("none.jpg can't be read"));
}

tests! {
    cameras_of_two_layouts_draw_the_same_and_with_frames_too: no_device,
    frames_are_counted_at_the_rate_that_is_asked_for: no_device,
    one_camera_holds_a_jump_and_a_crouch: no_device,
    a_picture_is_behind_the_avatar: no_device,
}
