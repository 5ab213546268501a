//! What a command writes is whole or as it was before, whatever happens; what it reads stays; names
//! say what they hold.

use crate::common::{self, gpu};
use std::{
    collections::BTreeSet,
    fs,
    path::Path,
    process::{Command, Output, Stdio},
    time::Duration,
};

const SPLATS: &[u8] = include_bytes!("../data/splats/truth.ply");
const WALK: &[u8] = include_bytes!("../data/motion/mixamo.bvh");
const MODEL: &[u8] = include_bytes!("../data/webavatar/small.npz");
const POSES: &[u8] = include_bytes!("../data/webavatar/small_poses.json");
const REPORT: &[u8] = include_bytes!("../../docs/benchmarks/2026-11-27-nodes.json");
/// What was in a file before.
const OLD: &[u8] = b"what was there before";

/// Commands that write without a device, each with the files that it makes.
const COMMANDS: [(&str, &[&str]); 15] = [
    (
        "render small.avatar --motion small.motion --reference --size 24 --out i.png",
        &["i.png"],
    ),
    (
        "render scan.ply --reference --size 24 --out i.JPG",
        &["i.JPG"],
    ),
    (
        "render scan.ply --reference --size 24 --background none i.webp",
        &["i.webp"],
    ),
    (
        "render small.avatar --motion small.motion --reference --size 8 --frames 0..3 --out s.png",
        &["s-0000.png", "s-0001.png", "s-0002.png"],
    ),
    (
        "export-ply small.avatar --motion small.motion --out o.ply --cameras-out c.json",
        &["o.ply", "c.json"],
    ),
    ("convert scan.ply --out o.ply", &["o.ply"]),
    ("convert scan.ply o.spz", &["o.spz"]),
    ("convert scan.ply o.splat", &["o.splat"]),
    (
        "convert small.avatar --motion small.motion o.glb",
        &["o.glb"],
    ),
    (
        "pack small.avatar --motion small.motion --frames 0 --out o.avatar --json o.json",
        &["o.avatar", "o.json"],
    ),
    ("import scan.ply o.avatar", &["o.avatar"]),
    (
        "import walk.bvh --avatar small.avatar --out o.motion",
        &["o.motion"],
    ),
    ("export model.npz --npz o.npz", &["o.npz", "o_poses.json"]),
    ("inspect small.avatar --png o.png", &["o.png"]),
    (
        "inspect walk.bvh --avatar small.avatar --png o.webp",
        &["o.webp"],
    ),
];

/// Commands that work for long, most of them on a device, each with files that it makes. None gets so
/// far here: its folder has nothing that it could read.
const LONG_COMMANDS: [(&str, &[&str]); 11] = [
    (
        "bench --json o.json --csv o.csv --pareto o.png",
        &["o.json", "o.csv", "o.png"],
    ),
    ("bench --pareto o.svg --trace o.json", &["o.svg", "o.json"]),
    ("soak --out o", &["o.csv", "o.json"]),
    ("soak --out x --trace o.json", &["o.json"]),
    ("devices --json o.json", &["o.json"]),
    ("bake body --out o.avatar", &["o.avatar"]),
    ("bake motion 01_01.bvh --out o.motion", &["o.motion"]),
    ("prune small.avatar --rows 9 --out o.avatar", &["o.avatar"]),
    (
        "evaluate small.avatar none.capture --json o.json",
        &["o.json"],
    ),
    ("train none.capture --out o.avatar", &["o.avatar"]),
    ("view --trace o.json", &["o.json"]),
];

/// A folder with files to read.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    for (name, bytes) in [
        ("scan.ply", SPLATS),
        ("walk.bvh", WALK),
        ("model.npz", MODEL),
        ("model_poses.json", POSES),
        ("report.json", REPORT),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    folder
}

fn command(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(common::program());
    command
        .args(arguments.split_whitespace())
        .current_dir(folder);
    command
}

fn effigy(folder: &Path, arguments: &str) -> Output {
    command(folder, arguments).output().unwrap()
}

fn error_of(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn works(folder: &Path, arguments: &str) -> Output {
    let output = effigy(folder, arguments);
    assert!(
        output.status.success(),
        "effigy {arguments}: {}",
        error_of(&output)
    );
    output
}

fn fails(folder: &Path, arguments: &str, expected: &str) {
    let output = effigy(folder, arguments);
    let error = error_of(&output);
    assert!(
        !output.status.success() && error.contains(expected),
        "effigy {arguments}: expected {expected:?}: {error}"
    );
}

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

/// Puts the old content into files.
fn age(folder: &Path, files: &[&str]) {
    for file in files {
        fs::write(folder.join(file), OLD).unwrap();
    }
}

fn assert_old(folder: &Path, files: &[&str], what: &str) {
    for file in files {
        assert!(
            fs::read(folder.join(file)).unwrap() == OLD,
            "{what}: {file} has changed"
        );
    }
}

/// Without a byte of room, as a full disk has none; where there was nothing, nothing is.
fn on_a_full_disk_all_stays_as_it_was() {
    for (arguments, files) in COMMANDS {
        let folder = folder();
        let before = names(folder.path());
        for is_there in [false, true] {
            if is_there {
                age(folder.path(), files);
            }
            let output = Command::new("sh")
                .args(["-c", "trap '' XFSZ; ulimit -f 0; exec \"$@\"", "sh"])
                .arg(common::program())
                .args(arguments.split_whitespace())
                .current_dir(folder.path())
                .output()
                .unwrap();
            let error = error_of(&output);
            assert!(
                !output.status.success() && error.contains(files[0]) && error.contains("error: "),
                "effigy {arguments}: {error}"
            );
            if is_there {
                assert_old(folder.path(), files, arguments);
                continue;
            }
            assert_eq!(names(folder.path()), before, "{arguments}");
        }
    }
}

/// A file that is write-protected, a folder in its place, a folder that is missing or a file.
fn without_permission_nothing_is_begun() {
    for (arguments, files) in COMMANDS.into_iter().chain(LONG_COMMANDS) {
        let folder = folder();
        age(folder.path(), files);
        let last = folder.path().join(files[files.len() - 1]);
        let mut protected = last.metadata().unwrap().permissions();
        protected.set_readonly(true);
        fs::set_permissions(&last, protected).unwrap();
        fails(folder.path(), arguments, "it is write-protected");
        assert_old(folder.path(), files, arguments);
        fs::remove_file(&last).unwrap();
        fs::create_dir(&last).unwrap();
        fails(
            folder.path(),
            arguments,
            "is a folder: name a file to write",
        );
        fs::remove_dir(&last).unwrap();
        let stem = files[0].split(['.', '-']).next().unwrap();
        for (above, expected) in [
            ("none", "there is no folder none"),
            ("scan.ply", "is no folder"),
        ] {
            let mut moved = format!("{arguments} ");
            for end in [".", " "] {
                moved = moved.replace(&format!(" {stem}{end}"), &format!(" {above}/{stem}{end}"));
            }
            fails(folder.path(), &moved, expected);
        }
    }
}

/// Reports of a device, whose times differ from run to run.
fn reports_of_devices_are_whole_or_as_they_were() {
    gpu::gpu();
    for arguments in ["devices --json"] {
        let folder = folder();
        fails(
            folder.path(),
            &format!("{arguments} /dev/full"),
            "/dev/full can't be written",
        );
        for wait in [0, 30, 120, 400] {
            age(folder.path(), &["o.json"]);
            let mut child = command(folder.path(), &format!("{arguments} o.json"))
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            std::thread::sleep(Duration::from_millis(wait));
            child.kill().unwrap();
            child.wait().unwrap();
            let found = fs::read(folder.path().join("o.json")).unwrap();
            let is_report = serde_json::from_slice::<serde_json::Value>(&found).is_ok();
            assert!(found == OLD || is_report, "{arguments}, {wait} ms");
        }
    }
}

/// Killed at any time, each file is the old one or the new one, and the next run clears up.
fn what_is_killed_leaves_the_old_file_or_the_new() {
    for (arguments, files) in COMMANDS {
        let folder = folder();
        works(folder.path(), arguments);
        let read = |file: &&str| fs::read(folder.path().join(file)).unwrap();
        let new: Vec<Vec<u8>> = files.iter().map(read).collect();
        let all = names(folder.path());
        for wait in [0, 8, 30, 90] {
            age(folder.path(), files);
            let mut child = command(folder.path(), arguments)
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            std::thread::sleep(Duration::from_millis(wait));
            child.kill().unwrap();
            child.wait().unwrap();
            for (file, new) in files.iter().zip(&new) {
                let found = read(file);
                // Reports have times in them.
                let is_new = found == *new || file.ends_with(".json") && found.ends_with(b"\n");
                assert!(found == OLD || is_new, "{arguments}, {wait} ms: {file}");
            }
            // As a write that was killed leaves one.
            let part = folder.path().join(format!(".{}.part", files[0]));
            fs::write(part, &new[0][..new[0].len() / 2]).unwrap();
        }
        works(folder.path(), arguments);
        assert!(read(&files[0]) == new[0], "{arguments}");
        assert_eq!(names(folder.path()), all, "{arguments}");
    }
}

/// Under another spelling, through links and as a hard link too.
fn what_is_read_is_not_replaced() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    fs::hard_link(at("scan.ply"), at("hard.ply")).unwrap();
    fs::create_dir(at("below")).unwrap();
    fs::copy(at("scan.ply"), at("statue.ply")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("scan.ply", at("soft.ply")).unwrap();
    for (arguments, expected) in [
        ("convert scan.ply scan.ply", "is read by this command"),
        (
            "convert scan.ply --out ./below/../scan.ply",
            "is read by this command",
        ),
        ("convert soft.ply scan.ply", "is read by this command"),
        ("convert scan.ply soft.ply", "is read by this command"),
        ("convert scan.ply hard.ply", "is read by this command"),
        ("export-ply scan.ply scan.ply", "is read by this command"),
        ("pack small.avatar small.avatar", "is read by this command"),
        (
            "pack small.avatar --motion small.motion --frames 0 --out small.avatar",
            "--overwrite",
        ),
        (
            "import walk.bvh --avatar small.avatar --out small.avatar",
            "--overwrite",
        ),
        (
            "render scan.ply --cameras report.json --out report.json",
            "does not end in .png",
        ),
        (
            "compare report.json report.json --chart report.json",
            "does not end in .svg",
        ),
        (
            "pack small.avatar --frames 0 --out o.avatar --json report.json --motion report.json",
            "--overwrite",
        ),
        (
            "pack statue.ply --out statue.ply",
            "`statue.ply` does not end in .avatar",
        ),
        (
            "export-ply statue.ply --out same.ply --cameras-out same.ply",
            "does not end in .json",
        ),
        (
            "bench --json a.json --trace ./a.json",
            "would be written twice",
        ),
        (
            "bench --json a.json --trace A.json",
            "would be written twice",
        ),
        ("bench --json - --csv -", "would be written twice"),
        ("soak --out a --trace a.json", "would be written twice"),
        (
            "export model.npz --npz a.npz --motion a_poses.json",
            "--overwrite",
        ),
    ] {
        if arguments.contains("a_poses") {
            fs::write(at("a_poses.json"), "{}").unwrap();
        }
        fails(folder.path(), arguments, expected);
    }
    for name in ["scan.ply", "hard.ply", "statue.ply"] {
        assert!(fs::read(at(name)).unwrap() == SPLATS, "{name}");
    }
    works(folder.path(), "convert scan.ply scan.ply --overwrite");
    assert!(fs::read(at("scan.ply")).unwrap() != SPLATS);
    assert!(fs::read(at("hard.ply")).unwrap() == SPLATS);
    // A picture of a series that another file of the command is.
    fs::copy(at("report.json"), at("s-0001.png")).unwrap();
    let series = "render small.avatar --motion s-0001.png --frames 0..3 --out s.png";
    assert!(!effigy(folder.path(), series).status.success());
    assert!(fs::read(at("s-0001.png")).unwrap() == REPORT);
}

fn names_that_promise_something_else_are_refused() {
    let folder = folder();
    fs::create_dir_all(folder.path().join("shot.capture/images/cam01")).unwrap();
    let before = names(folder.path());
    for (arguments, expected) in [
        (
            "render --out a.gif",
            "with --frames and --out a.png, then `ffmpeg",
        ),
        ("render --out a.MP4", "is a moving picture"),
        ("render --out a.bmp", "write a.png or a.jpg"),
        (
            "render --out a",
            "`a` has no ending, which says what to write",
        ),
        ("render --out .png", "has no ending"),
        ("render --out shot.capture", "does not end in .png"),
        ("render --out .", "`.` is a folder"),
        (
            "render --out a.jpeg --background none",
            "a .jpg has no transparency",
        ),
        (
            "render --out - --frames 0..2",
            "takes one image, not a series",
        ),
        ("inspect --png a.mp4", "is a moving picture"),
        ("pack --out a.motion", "write a.avatar"),
        ("pack --out -", "`-` has no ending"),
        ("pack --out a.avatar --json a.txt", "write a.json"),
        ("convert scan.ply -", "`-` has no ending"),
        (
            "convert scan.ply a.obj",
            "write a.ply or a.spz or a.splat or a.glb",
        ),
        ("import scan.ply a.motion", "does not end in .avatar"),
        ("import walk.bvh a.avatar", "does not end in .motion"),
        ("export --npz a.avatar", "write a.npz"),
        ("bench --csv a.json", "write a.csv"),
        ("bench --pareto a.pdf", "write a.svg or a.png"),
        ("view --trace body.avatar", "write body.json"),
        ("bake motion 01_01.bvh a.bvh", "write a.motion"),
        ("devices --json a.avatar", "write a.json"),
        (
            "dataset small.motion --out shot.capture",
            "has a capture: name another folder",
        ),
        ("dataset small.motion --out scan.ply", "is a file"),
        ("evaluate small.avatar none --images scan.ply", "is a file"),
        (
            "train none --out a.avatar --folder scan.ply/below",
            "is a file",
        ),
        ("pack small.avatar", "--out <FILE>"),
    ] {
        fails(folder.path(), arguments, expected);
    }
    assert_eq!(names(folder.path()), before);
}

/// A picture, a report or splats, and nothing else.
fn the_standard_output_has_the_file_alone() {
    let folder = folder();
    let before = names(folder.path());
    let render = "render scan.ply --reference --size 24x16 --out -";
    let image = image::load_from_memory(&works(folder.path(), render).stdout).unwrap();
    assert_eq!([image.width(), image.height()], [24, 16]);
    let written = works(folder.path(), "export-ply scan.ply -");
    assert!(written.stdout.starts_with(b"ply\n") && error_of(&written).contains("wrote -"));
    assert_eq!(names(folder.path()), before);
    let pack = "pack small.avatar --motion small.motion --frames 0 --out o.avatar --json -";
    let table: serde_json::Value =
        serde_json::from_slice(&works(folder.path(), pack).stdout).unwrap();
    assert!(table.as_array().is_some_and(|steps| !steps.is_empty()));
}

/// Pixels and straight alpha of the same picture in each format.
fn endings_choose_the_format() {
    let folder = folder();
    let read = |name: &str| {
        let bytes = fs::read(folder.path().join(name)).unwrap();
        let start: [u8; 12] = bytes[..12].try_into().unwrap();
        (start, bytes)
    };
    let what = "render scan.ply --reference --size 40";
    for out in ["a.png", "a.WebP", "a.jpeg", "a.PNG"] {
        works(folder.path(), &format!("{what} --out {out}"));
    }
    for out in ["clear.png", "clear.webp"] {
        works(folder.path(), &format!("{what} --background none {out}"));
    }
    let png = |name| image::load_from_memory(&read(name).1).unwrap().to_rgba8();
    let webp = |name| {
        let (start, bytes) = read(name);
        assert!(start.starts_with(b"RIFF") && start.ends_with(b"WEBP"));
        let mut decoder = image_webp::WebPDecoder::new(std::io::Cursor::new(bytes)).unwrap();
        let mut pixels = vec![0; decoder.output_buffer_size().unwrap()];
        decoder.read_image(&mut pixels).unwrap();
        (pixels, decoder.has_alpha())
    };
    assert!(png("a.png") == png("a.PNG"));
    let (pixels, has_alpha) = webp("clear.webp");
    let clear = png("clear.png");
    assert!(has_alpha && pixels == *clear.as_raw());
    let alphas: BTreeSet<u8> = clear.pixels().map(|pixel| pixel.0[3]).collect();
    assert!(alphas.len() > 10, "{alphas:?}");
    let (pixels, has_alpha) = webp("a.WebP");
    let opaque = png("a.png");
    let channels = if has_alpha { 4 } else { 3 };
    assert!(
        pixels
            .chunks(channels)
            .zip(opaque.pixels())
            .all(|(a, b)| a[..3] == b.0[..3])
    );
    assert!(read("a.jpeg").0.starts_with(&[0xff, 0xd8, 0xff]));
    let jpeg = image::load_from_memory(&read("a.jpeg").1)
        .unwrap()
        .to_rgb8();
    let squared = jpeg.pixels().zip(opaque.pixels()).map(|(a, b)| {
        let channel = |k: usize| (f64::from(a.0[k]) - f64::from(b.0[k])).powi(2);
        (0..3).map(channel).sum::<f64>() / 3.0
    });
    let error = squared.sum::<f64>() / f64::from(jpeg.width() * jpeg.height());
    let decibels = 10.0 * (255.0 * 255.0 / error).log10();
    assert!(decibels > 30.0, "{decibels} dB");
}

/// Sizes, times and axes: a word where the answer is not what was asked for.
fn what_was_meant_is_taken_or_said() {
    let folder = folder();
    let render = "render small.avatar --motion small.motion --reference --size 20 --out a.png";
    assert!(!error_of(&works(folder.path(), render)).contains("outside"));
    for (time, shown) in [("99", "its last frame"), ("-1", "its first frame")] {
        let said = error_of(&works(folder.path(), &format!("{render} --time={time}")));
        assert!(
            said.contains("outside the clip") && said.contains(shown),
            "{said}"
        );
        assert_eq!(said.lines().count(), 1, "{said}");
    }
    let said = error_of(&works(folder.path(), "inspect scan.ply"));
    assert!(said.contains("--up y"), "{said}");
    works(folder.path(), "convert scan.ply told.ply");
    let still = "render told.ply --reference --size 20 --out a.png";
    assert!(!error_of(&works(folder.path(), still)).contains("--up"));
    let many = "bake body --gaussians 1000 --out a.avatar";
    fails(
        folder.path(),
        many,
        "found --nodes 10000 and --rows 20000 with --gaussians 1000",
    );
    let other = String::from_utf8_lossy(REPORT).replacen("\"psnr_db\": ", "\"psnr_db\": 9", 1);
    fs::write(folder.path().join("other.json"), other).unwrap();
    let table = works(folder.path(), "compare report.json other.json").stdout;
    let table = String::from_utf8_lossy(&table).into_owned();
    assert!(
        table.contains("second is") && table.contains("  better\n"),
        "{table}"
    );
}

tests! {
    on_a_full_disk_all_stays_as_it_was: no_device,
    without_permission_nothing_is_begun: no_device,
    what_is_killed_leaves_the_old_file_or_the_new: no_device,
    reports_of_devices_are_whole_or_as_they_were,
    what_is_read_is_not_replaced: no_device,
    names_that_promise_something_else_are_refused: no_device,
    the_standard_output_has_the_file_alone: no_device,
    endings_choose_the_format: no_device,
    what_was_meant_is_taken_or_said: no_device,
}
