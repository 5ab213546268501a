//! `effigy train` as its users run it: begun, stopped, gone on with, refused.

use crate::common::{self, gpu};
use effigy_capture::{Capture, CaptureCamera, CaptureWriter};
use effigy_core::avatar::{Avatar, Clip};
use serde_json::Value;
use std::{
    fs,
    io::{BufRead, BufReader},
    path::Path,
    process::{Child, Command, Output, Stdio},
    time::{Duration, Instant},
};

/// A recipe that takes seconds, with every loss in it.
pub const TINY: &str = "--set sizes.gaussians=400 --set sizes.parts=4 --set sizes.nodes=40 --set sizes.hidden=16 \
                    --set schedule.iterations=150 --set schedule.fine_tune=50 --set perceptual.kind=dssim \
                    --set perceptual.every=8 --set perceptual.window=32 --set rates.pose=1e-4 \
                    --set rates.camera=1e-5 --set rates.bone=1e-5 --set rates.exposure=1e-4 --set prune.by=pictures";

pub fn capture() -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/capture");
    folder.canonicalize().unwrap().display().to_string()
}

fn train(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(common::program());
    command
        .arg("train")
        .arg(capture())
        .args(arguments.split_whitespace())
        .current_dir(folder);
    command
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn ends(mut command: Command) -> Output {
    let output = command.output().unwrap();
    assert!(
        !errors(&output).contains("validation:"),
        "{}",
        errors(&output)
    );
    output
}

/// The capture, but for a joint that no vertex follows and an expression that never moves.
fn stiff_capture(folder: &Path) {
    let mut capture = Capture::read(Path::new(&capture())).unwrap();
    let elbow = 18;
    for own in &mut capture.template.weights {
        own.retain(|influence| influence.joint != elbow);
        let sum: f32 = own.iter().map(|influence| influence.weight).sum();
        own.iter_mut().for_each(|influence| influence.weight /= sum);
    }
    let cameras: Vec<_> = capture
        .cameras
        .clone()
        .into_iter()
        .map(|camera| CaptureCamera {
            // Pictures are read without it.
            distortion: [0.0; 5],
            ..camera
        })
        .collect();
    let mut frames = capture.frames.clone();
    let writer = CaptureWriter::new(folder, &cameras, &capture.template).unwrap();
    for (at, frame) in frames.iter_mut().enumerate() {
        frame.pose.expression[7] = 0.5;
        for camera in 0..cameras.len() {
            if capture.has(camera, at) {
                let picture = capture.picture(camera, at).unwrap();
                writer.write(camera, frame.number, &picture).unwrap();
            }
        }
    }
    writer.finish(&frames).unwrap();
}

fn a_long_training_names_first_what_moves_nothing() {
    gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    stiff_capture(&here.join("stiff"));
    let mut command = Command::new(common::program());
    command
        .args(["train", "stiff", "--out", "stiff.avatar"])
        .args(TINY.split_whitespace())
        .args(["--set", "schedule.iterations=1000000"])
        .current_dir(here);
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    wait_for_a_step(&here.join("stiff.training"), &mut child);
    Command::new("kill")
        .arg(child.id().to_string())
        .status()
        .unwrap();
    let stopped = child.wait_with_output().unwrap();
    let said = errors(&stopped);
    assert_eq!(stopped.status.code(), Some(75), "{said}");
    let elbow = Capture::read(Path::new(&capture()))
        .unwrap()
        .template
        .skeleton
        .name[18]
        .clone();
    let names = |part: &str, name: &str| {
        said.lines()
            .any(|line| line.contains(part) && line.contains(name))
    };
    assert!(names("no vertex", &format!("`{elbow}`")), "{said}");
    assert!(names("never change", "expression 7"), "{said}");
    let printed = String::from_utf8_lossy(&stopped.stdout);
    assert!(printed.contains("checking first"), "{printed}");
}

/// Waits until a training has logged its first step.
fn wait_for_a_step(training: &Path, child: &mut Child) {
    let start = Instant::now();
    while !training.join("log.csv").exists() {
        assert!(child.try_wait().unwrap().is_none(), "it ended too early");
        assert!(start.elapsed() < Duration::from_secs(200), "no step");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Goes on with a training, and stops it before it takes a step, which loses none of those before.
fn stops_at_once_and_counts_steps(here: &Path, arguments: &str, said: &str) {
    let mut child = train(here, &format!("{arguments} --resume"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let printed = BufReader::new(child.stdout.take().unwrap()).lines();
    let going_on = |line: String| line.strip_prefix("going on after ").map(String::from);
    let steps = printed.map_while(Result::ok).find_map(going_on).unwrap();
    let begun = Instant::now();
    Command::new("kill")
        .arg(child.id().to_string())
        .status()
        .unwrap();
    let stopped = child.wait_with_output().unwrap();
    assert!(begun.elapsed() < Duration::from_secs(10));
    assert_eq!(stopped.status.code(), Some(75), "{}", errors(&stopped));
    let sentence = format!("stopped after {steps};");
    assert!(said.contains(&sentence), "{said}: {steps}");
    assert!(errors(&stopped).contains(&sentence), "{}", errors(&stopped));
    let lock = fs::read(here.join("parts.training/lock.json")).unwrap();
    assert!(lock.is_empty(), "the folder is given back");
}

fn a_stopped_training_goes_on_to_the_same_bits() {
    gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let whole = ends(train(here, &format!("--out whole.avatar {TINY}")));
    assert!(whole.status.success(), "{}", errors(&whole));
    let avatar = Avatar::read(&here.join("whole.avatar")).unwrap();
    assert_eq!(avatar.gaussians.len(), 400);
    let kept = avatar.rotation_rows.gaussian.len()
        + avatar.scale_rows.gaussian.len()
        + avatar.color_rows.gaussian.len();
    assert_eq!(kept, 300, "a quarter of the rows stays");
    let poses = Clip::read(&here.join("whole.training/poses.motion")).unwrap();
    assert_eq!(poses.joint, avatar.skeleton.name);
    assert!(avatar.filter.compensated && avatar.inputs.pose_space.is_some());
    for file in ["recipe.toml", "training.svg", "watched.csv", "log.csv"] {
        assert!(here.join("whole.training").join(file).exists(), "{file}");
    }
    let lock = fs::read(here.join("whole.training/lock.json")).unwrap();
    assert!(lock.is_empty(), "nobody trains there any more");

    let arguments = format!("--out parts.avatar {TINY}");
    let mut child = train(here, &arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let training = here.join("parts.training");
    wait_for_a_step(&training, &mut child);
    // Meanwhile the folder is taken.
    let second = ends(train(here, &arguments));
    assert!(
        !second.status.success() && errors(&second).contains("is training there"),
        "{}",
        errors(&second)
    );
    let killed = Command::new("kill")
        .arg(child.id().to_string())
        .status()
        .unwrap();
    assert!(killed.success());
    let stopped = child.wait_with_output().unwrap();
    assert_eq!(stopped.status.code(), Some(75), "{}", errors(&stopped));
    assert!(
        errors(&stopped).contains("--resume"),
        "{}",
        errors(&stopped)
    );
    assert!(!here.join("parts.avatar").exists());
    let again = ends(train(here, &arguments));
    assert!(
        errors(&again).contains("found a training after"),
        "{}",
        errors(&again)
    );
    let other = ends(train(here, &format!("{arguments} --resume --set seed=2")));
    assert!(
        errors(&other).contains("another recipe"),
        "{}",
        errors(&other)
    );
    stops_at_once_and_counts_steps(here, &arguments, &errors(&stopped));
    let resumed = ends(train(here, &format!("{arguments} --resume")));
    assert!(resumed.status.success(), "{}", errors(&resumed));
    // But for the name, which is the file's.
    let mut parts = Avatar::read(&here.join("parts.avatar")).unwrap();
    parts.name.clone_from(&avatar.name);
    assert!(parts == avatar, "it is another avatar");
}

fn without_its_weights_d_ssim_stands_in_for_st_lpips() {
    gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let short = TINY
        .replace("iterations=150", "iterations=3")
        .replace("fine_tune=50", "fine_tune=1")
        .replace("--set perceptual.kind=dssim", "");
    let train = |folder: &Path, arguments: &str| {
        let mut command = train(folder, arguments);
        command.env("EFFIGY_ASSETS", "nowhere");
        command
    };
    let output = ends(train(here, &format!("--out a.avatar {short}")));
    assert!(output.status.success(), "{}", errors(&output));
    let said = errors(&output);
    for expected in [
        "D-SSIM stands in for it",
        "nowhere has no alex_shift_tolerant.pth",
    ] {
        assert!(said.contains(expected), "{said}");
    }
    // Weights that came since don't make it another training.
    let weights = folder.path().join("nowhere");
    fs::create_dir(&weights).unwrap();
    fs::write(weights.join("alex_shift_tolerant.pth"), "").unwrap();
    let output = ends(train(here, &format!("--out a.avatar {short} --resume")));
    assert!(output.status.success(), "{}", errors(&output));
    fs::remove_dir_all(&weights).unwrap();
    for (kind, file) in [
        ("st-lpips-alex", "alex_shift_tolerant.pth"),
        ("lpips-alex", "lpips_alex.pth"),
    ] {
        let kind = format!("--set perceptual.kind={kind}");
        let output = ends(train(here, &format!("--out b.avatar {short} {kind}")));
        assert!(
            !output.status.success() && errors(&output).contains(file),
            "{}",
            errors(&output)
        );
    }
}

fn recipes_that_are_none_are_refused_before_anything_else() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for (arguments, expected) in [
        (
            "--out a.avatar --set sizes.gaussian=5",
            "--set sizes.gaussian=5",
        ),
        (
            "--out a.avatar --set schedule.batch=0",
            "schedule.batch is 0, expected 1 to 64",
        ),
        ("--out a.avatar --set rates.color=nan", "rates.color is NaN"),
        ("--out a.avatar --config r.toml", "missing field"),
    ] {
        fs::write(here.join("r.toml"), "seed = 1\n").unwrap();
        let output = ends(train(here, arguments));
        assert_eq!(output.status.code(), Some(2), "{}", errors(&output));
        assert!(errors(&output).contains(expected), "{}", errors(&output));
        assert!(!here.join("a.training").exists());
    }
    let shown = ends({
        let mut command = Command::new(common::program());
        command
            .args(["train", "--show-recipe", "paper"])
            .current_dir(here);
        command
    });
    assert!(String::from_utf8_lossy(&shown.stdout).contains("gaussians = 200000"));
}

/// The person of masks without anybody would vanish without a word.
fn masks_without_anybody_end_it_before_it_begins() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    stiff_capture(&here.join("blank"));
    let mut masks: Vec<_> = ["cam00", "cam01"]
        .into_iter()
        .flat_map(|camera| fs::read_dir(here.join("blank/masks").join(camera)).unwrap())
        .map(|entry| entry.unwrap().path())
        .collect();
    masks.sort();
    let train = |arguments: &str| {
        let mut command = Command::new(common::program());
        command
            .args(["train", "blank", "--out", "a.avatar"])
            .args(arguments.split_whitespace())
            .current_dir(here);
        let output = ends(command);
        assert_eq!(output.status.code(), Some(1));
        errors(&output)
    };
    let blank = |mask: &Path| image::GrayImage::new(96, 80).save(mask).unwrap();
    masks.iter().take(4).for_each(|mask| blank(mask));
    let said = train("");
    assert!(
        said.contains("6 looked at, 4 of no use") && said.contains("an empty mask"),
        "{said}"
    );
    masks.iter().for_each(|mask| blank(mask));
    let said = train("--check-pictures");
    assert!(
        said.contains("0 usable frames") && said.contains("6 with an empty mask"),
        "{said}"
    );
    assert!(!here.join("a.training").exists());
}

fn captures_that_are_none_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(common::program());
    command
        .args(["train", "nowhere", "--out", "a.avatar"])
        .current_dir(folder.path());
    let output = ends(command);
    assert_eq!(output.status.code(), Some(1));
    assert!(errors(&output).contains("nowhere"), "{}", errors(&output));
}

/// PSNR of an avatar at held-out cameras, dB.
fn held_out_db(here: &Path, avatar: &str) -> f64 {
    let mut command = Command::new(common::program());
    command
        .args(["evaluate", avatar, "person.capture", "--frames", "4"])
        .args(["--perceptual", "none", "--json", "scores.json"])
        .current_dir(here);
    let output = ends(command);
    assert!(output.status.success(), "{}", errors(&output));
    let text = fs::read_to_string(here.join("scores.json")).unwrap();
    let scores: Value = serde_json::from_str(&text).unwrap();
    let groups = scores["groups"].as_array().unwrap();
    let of_cameras = groups
        .iter()
        .find(|group| group["name"] == "held-out cameras")
        .unwrap();
    of_cameras["whole"]["psnr_db"].as_f64().unwrap()
}

/// From a body and a motion over pictures to an avatar that looks like the person where no camera
/// of the training stood.
fn a_person_is_learned_from_pictures() {
    gpu::gpu();
    let assets = common::assets();
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for arguments in [
        format!("bake motion 01_01.bvh --assets {assets} --rate 30 --out clip.motion"),
        format!(
            "dataset clip.motion --assets {assets} --cameras 8 --frames 16 --size 96 \
             --samples 1 --rays 16 --out person.capture"
        ),
        "train person.capture --out person.avatar --set sizes.gaussians=3000 --set sizes.parts=16 \
         --set sizes.nodes=300 --set sizes.hidden=32 --set schedule.iterations=700 \
         --set schedule.fine_tune=300 --set perceptual.kind=dssim --set perceptual.every=8"
            .into(),
    ] {
        let mut command = Command::new(common::program());
        command.args(arguments.split_whitespace()).current_dir(here);
        let output = ends(command);
        assert!(output.status.success(), "{}", errors(&output));
    }
    let first = held_out_db(here, "person.training/start.avatar");
    let last = held_out_db(here, "person.avatar");
    println!("held-out cameras: from {first:.1} to {last:.1} dB");
    assert!(last > first + 5.0, "{first} to {last} dB");
    assert!(last > 19.5, "{last} dB");
}

tests! {
    a_person_is_learned_from_pictures,
    a_long_training_names_first_what_moves_nothing,
    without_its_weights_d_ssim_stands_in_for_st_lpips,
    a_stopped_training_goes_on_to_the_same_bits,
    recipes_that_are_none_are_refused_before_anything_else,
    captures_that_are_none_are_named,
    masks_without_anybody_end_it_before_it_begins,
}
