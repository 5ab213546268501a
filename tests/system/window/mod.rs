//! The viewer in a real window: the program runs under Xvfb, gets real input, and what its window
//! shows is looked at.
//!
//! The driver is the one that the environment chooses. Without Xvfb the tests are ignored.

mod drag_source;
mod session;

use crate::{common::gpu, train};
use image::{RgbImage, imageops::FilterType::CatmullRom};
use session::{Session, covered};
use std::path::Path;

/// The background that the tests ask for, and its pixels in a window.
const BACKGROUND: [u8; 3] = [0, 0, 255];

fn start(arguments: &[&str]) -> Session {
    Session::start(&[&["--background", "0000ff"], arguments].concat())
}

/// Hides the panel and pauses, so that nothing but the avatar is in the window, and that stands
/// still.
fn still(arguments: &[&str]) -> Session {
    let mut session = start(arguments);
    session.key('h');
    session.key(' ');
    session.wait_for_rest();
    session
}

fn the_avatar_moves_and_nothing_is_drawn_while_it_is_paused() {
    let mut session = start(&["--size", "320x240"]);
    session.key('h');
    session.wait_for_frames(3);
    let before = session.read_image();
    assert!(
        covered(&before, BACKGROUND) > 1000,
        "{} pixels of the window show the avatar",
        covered(&before, BACKGROUND)
    );
    session.wait_for_frames(3);
    assert!(session.read_image() != before, "the avatar does not move");
    session.key(' ');
    session.wait_for_rest();
    let (frames, image) = (session.frames(), session.read_image());
    session.move_mouse([100, 100]);
    session.sleep(1.0);
    assert_eq!(
        session.frames(),
        frames,
        "frames were drawn while nothing changed"
    );
    session.key('n');
    session.wait_for_rest();
    assert!(session.frames() > frames, "a new clip was not drawn");
    assert!(
        session.read_image() != image,
        "the new clip looks like the one before"
    );
    session.quit();
}

fn the_image_follows_every_resize() {
    let mut session = still(&["--size", "400x300"]);
    for size in [[640, 480], [200, 500], [1, 1], [700, 100], [333, 217]] {
        session.resize(size);
        session.wait_for_size(size);
        session.wait_for_rest();
        let image = session.read_image();
        assert_eq!([image.width(), image.height()], size);
        if size != [1, 1] {
            let columns = |from: u32| {
                image::imageops::crop_imm(&image, from, 0, size[0] / 8, size[1]).to_image()
            };
            let edges = covered(&columns(0), BACKGROUND)
                + covered(&columns(size[0] - size[0] / 8), BACKGROUND);
            let (all, share) = (covered(&image, BACKGROUND), size[0] * size[1] / 100);
            assert!(
                all > share && edges < all / 10,
                "{size:?}: {all} pixels show the avatar, {edges} of them near the edges"
            );
        }
    }
    (0..40).for_each(|step| session.resize([300 + 7 * step, 500 - 9 * step]));
    session.resize([420, 310]);
    session.wait_for_size([420, 310]);
    session.wait_for_rest();
    assert!(
        covered(&session.read_image(), BACKGROUND) > 1000,
        "the avatar is gone after many resizes"
    );
    session.quit();
}

fn a_window_that_was_hidden_shows_the_avatar_again() {
    let mut session = still(&["--size", "320x240"]);
    let before = session.read_image();
    session.map(false);
    session.key('b');
    session.sleep(0.5);
    session.map(true);
    session.wait_for_rest();
    assert_eq!(
        covered(&session.read_image(), BACKGROUND),
        covered(&before, BACKGROUND)
    );
    session.quit();
}

fn a_drag_turns_the_avatar_the_wheel_zooms_and_a_key_resets() {
    let mut session = still(&["--size", "320x240"]);
    session.key('r');
    session.wait_for_rest();
    let first = session.read_image();
    session.drag([160, 120], [230, 100]);
    session.wait_for_rest();
    let turned = session.read_image();
    assert!(turned != first, "the drag did nothing");
    session.wheel(4);
    session.wait_for_rest();
    let (before, zoomed) = (
        covered(&turned, BACKGROUND),
        covered(&session.read_image(), BACKGROUND),
    );
    assert!(
        zoomed > before + before / 10,
        "zooming in took the avatar from {before} to {zoomed} pixels"
    );
    session.key('r');
    session.wait_for_rest();
    assert!(
        session.read_image() == first,
        "the view is not what it was at first"
    );
    session.quit();
}

fn keys_zoom_and_choose_views() {
    let mut session = still(&["--size", "320x240"]);
    let mut seen = |key: char| {
        session.key(key);
        session.wait_for_rest();
        session.read_image()
    };
    let [front, near, back, face] = ['1', '=', '3', '6'].map(&mut seen);
    let pixels = |image| covered(image, BACKGROUND);
    assert!(pixels(&near) > pixels(&front), "= does not zoom in");
    assert!(back != front, "3 shows the front");
    assert!(
        pixels(&face) > 2 * pixels(&front),
        "6 does not show the face"
    );
    assert!(pixels(&seen('-')) < pixels(&face), "- does not zoom out");
    session.quit();
}

fn a_screenshot_is_the_window_without_the_panel() {
    let mut session = still(&["--size", "320x240"]);
    let window = session.read_image();
    session.key('h');
    session.wait_for_rest();
    assert!(session.read_image() != window, "the panel is not shown");
    session.key('s');
    let path = session.wait_for_line("saved ");
    let saved = image::open(&path).unwrap().to_rgb8();
    assert_eq!(saved.dimensions(), window.dimensions());
    let off = saved
        .as_raw()
        .iter()
        .zip(window.as_raw())
        .map(|(a, b)| a.abs_diff(*b))
        .max();
    assert!(
        off <= Some(1),
        "{path}: the largest difference to the window is {off:?} of 255"
    );
    session.quit();
}

/// What `render` puts behind images is behind them in the window, and covers it after a resize;
/// colours come and go.
fn a_picture_is_behind_the_avatar() {
    let picture = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/images/training.png");
    let mut session = Session::start(&[
        "--size",
        "320x240",
        "--background",
        picture.to_str().unwrap(),
    ]);
    session.key('h');
    session.key(' ');
    let decoded = image::open(&picture).unwrap();
    for size in [[320, 240], [200, 300]] {
        session.resize(size);
        session.wait_for_size(size);
        session.wait_for_rest();
        let window = session.read_image();
        let fitted = decoded
            .resize_to_fill(size[0], size[1], CatmullRom)
            .to_rgb8();
        for at in [[0, 0], [size[0] - 1, 3], [5, size[1] - 1]] {
            let [a, b] = [&window, &fitted].map(|image| image.get_pixel(at[0], at[1]).0);
            assert!(
                a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1),
                "{at:?}: {a:?} {b:?}"
            );
        }
    }
    let window = session.read_image();
    session.key('s');
    let path = session.wait_for_line("saved ");
    let saved = image::open(&path).unwrap().to_rgb8();
    let off = saved.as_raw().iter().zip(window.as_raw());
    let off = off.map(|(a, b)| a.abs_diff(*b)).max();
    assert!(off <= Some(1), "{path}: {off:?} of 255");
    session.key('b');
    session.wait_for_rest();
    assert!(session.read_image() != window, "the picture stays");
    session.quit();
}

/// Moving quads go to the window in the render pass that draws them: over the picture, under the
/// panel, after a resize, and into a screenshot.
fn moving_quads_are_between_the_picture_and_the_panel() {
    gpu::drawing();
    let picture = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/images/training.png");
    let picture = picture.to_str().unwrap();
    let decoded = image::open(picture).unwrap();
    let arguments = [
        "--size",
        "320x240",
        "--raster",
        "quads",
        "--background",
        picture,
    ];
    let mut session = Session::start(&arguments);
    // Of an image in which the avatar moves, whether each of some pixels is the picture's.
    let is_picture = |image: &RgbImage, at: &[[u32; 2]]| -> Vec<bool> {
        let (width, height) = image.dimensions();
        let fitted = decoded.resize_to_fill(width, height, CatmullRom).to_rgb8();
        let same = |[x, y]: &[u32; 2]| {
            let [a, b] = [image, &fitted].map(|image| image.get_pixel(*x, *y).0);
            a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1)
        };
        at.iter().map(same).collect()
    };
    for [width, height] in [[320, 240], [201, 303]] {
        session.resize([width, height]);
        session.wait_for_size([width, height]);
        let edges = [[width - 1, 0], [width - 1, height - 1], [20, 20]];
        for has_panel in [true, false] {
            session.wait_for_frames(4);
            let image = session.read_image();
            assert_eq!(
                is_picture(&image, &edges),
                [true, true, !has_panel],
                "{width} × {height}"
            );
            session.key('h');
        }
    }
    session.wait_for_frames(4);
    session.key('s');
    let saved = image::open(session.wait_for_line("saved "))
        .unwrap()
        .to_rgb8();
    let [width, height] = [saved.width(), saved.height()];
    let at = [
        [width - 1, 0],
        [width - 1, height - 1],
        [20, 20],
        [width / 2, height / 2],
    ];
    assert_eq!(is_picture(&saved, &at), [true, true, true, false]);
    session.quit();
}

fn a_lost_surface_and_a_lost_device_are_made_anew() {
    let losses = ["surface@2", "device@4", "surface@6", "device@40"]
        .map(|loss| ["--rehearse", loss])
        .concat();
    let mut session = still(&[&["--size", "320x240"], losses.as_slice()].concat());
    session.key('n');
    session.key('p');
    for _ in 0..8 {
        // A device that is opened again draws nothing for longer than a rest takes.
        let drawn = session.frames();
        session.key('b');
        session.wait_for_frames_after(drawn);
        session.wait_for_rest();
    }
    // So long after the first one another loss is no longer the second in a row.
    session.sleep(5.0);
    while session.frames() < 45 {
        let drawn = session.frames();
        session.key('b');
        session.wait_for_frames_after(drawn);
    }
    session.wait_for_rest();
    assert!(
        covered(&session.read_image(), BACKGROUND) > 1000,
        "nothing is shown after the losses"
    );
    session.quit();
}

fn a_device_that_is_lost_twice_ends_the_program_with_a_clear_error() {
    let arguments = [
        "--size",
        "200x200",
        "--rehearse",
        "device@1",
        "--rehearse",
        "device@2",
    ];
    let session = start(&arguments);
    let (success, text) = session.wait_for_end();
    assert!(
        !success && text.contains("error: the device was lost for the second time"),
        "{text}"
    );
}

fn an_avatar_that_does_not_fit_leaves_the_one_that_is_shown() {
    let mut session = still(&[
        "--size",
        "320x240",
        "--also",
        "other.avatar",
        "--rehearse",
        "memory@1",
    ]);
    let before = session.read_image();
    session.key('a');
    session.wait_for_text("can't be shown: out of device memory");
    session.wait_for_rest();
    assert!(
        session.read_image() == before,
        "what was shown before is not what it was"
    );
    session.key('a');
    session.wait_for_other_image(&before);
    assert!(
        covered(&session.read_image(), BACKGROUND) > 1000,
        "the other avatar is not shown where there is room for it"
    );
    session.quit();
}

fn files_that_are_dropped_are_shown_and_the_ones_before_can_be_chosen_again() {
    let mut session = still(&["--size", "320x240"]);
    let title = session.title();
    let before = session.read_image();

    // Motion of another body plays on the avatar that is shown.
    session.write_file("walk.bvh", include_bytes!("../../data/motion/bandai.bvh"));
    let frames = session.frames();
    session.drop_files(&["walk.bvh"]);
    session.wait_for_frames_after(frames + 3);
    session.key(' ');
    session.wait_for_rest();
    let moved = session.read_image();
    assert!(moved != before, "the motion that was dropped is not shown");
    assert_eq!(session.title(), title);

    // An avatar takes the place of the one that is shown, with the motion dropped beside it.
    let frames = session.frames();
    session.drop_files(&["2.motion", "other.avatar"]);
    session.wait_for_title("test body 2 – Effigy");
    session.wait_for_frames_after(frames);
    // The first of them may still be of the avatar before, while kernels are compiled.
    session.wait_for_other_image(&moved);
    session.key(' ');
    session.wait_for_rest();
    let other = session.read_image();
    assert!(
        other != moved && covered(&other, BACKGROUND) > 1000,
        "the avatar that was dropped is not shown"
    );

    // What is no avatar leaves the picture, and says so in the panel.
    session.write_file("letter.txt", b"Dear reader,");
    session.drop_files(&["letter.txt"]);
    session.wait_for_text("letter.txt");
    session.wait_for_rest();
    assert!(session.read_image() != other, "the panel is not shown");
    session.key('h');
    session.wait_for_rest();
    assert!(session.read_image() == other, "the picture is another one");

    // Splats stand still.
    session.write_file("scan.spz", include_bytes!("../../data/splats/small-2.spz"));
    let frames = session.frames();
    session.drop_files(&["scan.spz"]);
    session.wait_for_title("scan – Effigy");
    session.wait_for_frames_after(frames);
    session.wait_for_rest();
    assert!(covered(&session.read_image(), BACKGROUND) > 100);

    session.key('a');
    session.wait_for_title(&title);
    session.quit();
}

fn a_window_that_another_program_destroys_ends_the_viewer() {
    let session = start(&["--size", "200x200"]);
    session.destroy();
    let (_, text) = session.wait_for_end();
    assert!(!text.contains("panicked"), "{text}");
}

fn a_number_of_frames_is_drawn_and_timed() {
    let session = start(&["--size", "200x200", "--frames", "5"]);
    let (success, text) = session.wait_for_end();
    assert!(success && text.contains("5 frames: median "), "{text}");
}

fn a_soak_in_the_window_writes_its_files_and_ends() {
    let arguments = [
        "--size",
        "200x200",
        "--soak",
        "0.08",
        "--fps",
        "1",
        "--governor",
        "--trace",
        "trace.json",
    ];
    let mut session = start(&arguments);
    let text = std::fs::read_to_string(session.wait_for_line("wrote ")).unwrap();
    let report = effigy_measure::soak::SoakReport::read(&text).unwrap();
    assert!(
        report.governed
            && report.rate == 1.0
            && report.frames > 2
            && report.size == [200, 200]
            && report.lasted_seconds >= 4.8
    );
    let still = report.redrawn.expect("the window is what it was");
    assert!(
        still.size == [200, 200] && still.error.psnr_db.is_none_or(|db| db > 50.0),
        "{still:?}"
    );
    let trace = session.wait_for_file("trace.json");
    let (success, said) = session.wait_for_end();
    assert!(success, "{said}");
    let trace: serde_json::Value = serde_json::from_str(&trace).unwrap();
    let slices = trace["traceEvents"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|event| event["ph"] == "X" && event["name"] == "present");
    assert!(
        slices.count() > 2
            || trace["otherData"]["alignment"]
                .as_str()
                .unwrap()
                .starts_with("none")
    );
}

fn a_soak_whose_window_is_closed_keeps_its_results() {
    let mut session = start(&["--size", "200x200", "--soak", "60", "--fps", "1"]);
    session.wait_for_text("soak: ");
    session.key('q');
    let text = session.wait_for_file("effigy-soak.json");
    session.wait_for_text("soak: interrupted after");
    let report = effigy_measure::soak::SoakReport::read(&text).unwrap();
    assert!(
        report.frames > 0
            && report.lasted_seconds < report.planned_seconds
            && report.redrawn.is_none(),
        "{report:?}"
    );
}

fn a_capture_without_renderdoc_says_how_to_attach_it() {
    let mut session = still(&["--size", "200x200"]);
    session.key('c');
    session.wait_for_text("RenderDoc is not attached: start the program from it");
    session.quit();
}

/// A training of a capture with a window, of seconds.
fn training(capture: &str) -> Vec<&str> {
    let words = ["train", capture, "--out", "live.avatar", "--view"];
    let recipe = train::TINY.split_whitespace();
    words.into_iter().chain(recipe).collect()
}

fn a_training_shows_what_it_has_learned_and_outlives_its_window() {
    let capture = train::capture();
    let long = ["--set", "schedule.iterations=1000000"];
    let mut session = Session::run(&[&training(&capture)[..], &long].concat());
    session.key('h');
    session.wait_for_text("a newer avatar");
    session.wait_for_rest();
    // It stands still, so that only what is learned changes the image.
    let before = session.read_image();
    session.wait_for_other_image(&before);
    session.key('q');
    session.wait_for_text("the training goes on");
    session.sleep(0.5);
    session.terminate();
    let (success, text) = session.wait_for_end();
    assert!(
        !success && text.contains("stopped after") && text.contains("exit status: 75"),
        "{text}"
    );
}

fn a_training_that_ends_closes_its_window() {
    let capture = train::capture();
    let session = Session::run(&training(&capture));
    let (success, text) = session.wait_for_end();
    assert!(
        success && text.contains("log and checkpoints in") && !text.contains("goes on"),
        "{text}"
    );
}

fn without_a_display_a_training_has_no_window() {
    gpu::gpu();
    let capture = train::capture();
    let (success, text) = session::without_display(&training(&capture));
    assert!(success && text.contains("training without it"), "{text}");
}

fn without_a_display_the_viewer_says_what_to_do() {
    let (success, text) = session::without_display(&["view"]);
    assert!(!success && text.contains("effigy render"), "{text}");
}

fn without_a_display_and_arguments_images_are_rendered() {
    let (success, text) = session::without_display(&[]);
    assert!(success && text.contains("effigy-turntable"), "{text}");
}

/// What it measures is in `tests/gpu/survey.rs`, its soak in the app's scripts.
fn a_survey_begins_and_ends_by_its_button() {
    let mut session = start(&["--size", "700x500"]);
    session.wait_for_frames(3);
    // Upwards to the lowest button of the panel: what is below shows times, and takes no clicks.
    let button = (150..300).rev().step_by(6).find(|&y| {
        session.click([60, y]);
        session.sleep(0.2);
        session.has_said("survey: ")
    });
    let button = [60, button.expect("the panel has no button for a survey")];
    session.wait_for_text("survey: rates: ");
    session.click(button);
    session.wait_for_text("survey: incomplete");
    let text = std::fs::read_to_string(session.wait_for_line("wrote ")).unwrap();
    let report = effigy_measure::survey::SurveyReport::read(&text).unwrap();
    assert!(report.over && !report.is_complete(), "{report:?}");
    assert!(report.rates.is_some() && report.soak.is_none());
    assert_eq!(report.steps.last().unwrap().note, "it was stopped");
    // The clip plays again.
    session.wait_for_frames(3);
    session.quit();
}

tests! {
    the_avatar_moves_and_nothing_is_drawn_while_it_is_paused,
    the_image_follows_every_resize,
    a_window_that_was_hidden_shows_the_avatar_again,
    a_drag_turns_the_avatar_the_wheel_zooms_and_a_key_resets,
    keys_zoom_and_choose_views,
    a_screenshot_is_the_window_without_the_panel,
    a_picture_is_behind_the_avatar,
    moving_quads_are_between_the_picture_and_the_panel,
    a_lost_surface_and_a_lost_device_are_made_anew,
    a_device_that_is_lost_twice_ends_the_program_with_a_clear_error,
    an_avatar_that_does_not_fit_leaves_the_one_that_is_shown,
    files_that_are_dropped_are_shown_and_the_ones_before_can_be_chosen_again,
    a_window_that_another_program_destroys_ends_the_viewer,
    a_number_of_frames_is_drawn_and_timed,
    a_soak_in_the_window_writes_its_files_and_ends,
    a_soak_whose_window_is_closed_keeps_its_results,
    a_survey_begins_and_ends_by_its_button,
    a_capture_without_renderdoc_says_how_to_attach_it,
    a_training_shows_what_it_has_learned_and_outlives_its_window,
    a_training_that_ends_closes_its_window,
    without_a_display_a_training_has_no_window,
    without_a_display_the_viewer_says_what_to_do: no_device,
    without_a_display_and_arguments_images_are_rendered,
}
