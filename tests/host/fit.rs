//! Datasets, fits and pruning, on a dataset that an avatar of the model itself makes.

use crate::common::{self, Sizes};
use effigy_core::avatar::{Avatar, Clip, Rows};
use effigy_core::reference::{self, nodes::displacement};
use effigy_core::scene::Posed;
use effigy_learn::dataset::{Dataset, DatasetWriter, FrameAttributes, Shot, frame_name};
use effigy_learn::evaluate::{EvaluationPlan, Rendition, evaluate};
use effigy_learn::{Budget, FitOptions, fit, prune};
use glam::DQuat;
use half::f16;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// An avatar all of whose Gaussians have correctives, and a clip of it.
fn model() -> (Avatar, Clip) {
    let sizes = Sizes {
        gaussians: 600,
        parts: 6,
        nodes: 60,
        rows: 600,
        joints: 24,
        split_features: true,
        ..Sizes::default()
    };
    let avatar = common::avatar(11, sizes);
    let clip = common::clip(12, &avatar, 48);
    (avatar, clip)
}

/// What the model looks like in a pose, as a dataset holds it.
fn frame(avatar: &Avatar, posed: &Posed) -> FrameAttributes {
    let features = reference::mlp::features(avatar, &posed.input);
    let nodes = reference::nodes::nodes(avatar, &features);
    let part = |k: usize| {
        avatar
            .parts
            .start
            .partition_point(|&start| start as usize <= k)
            - 1
    };
    fn changed<const C: usize>(
        avatar: &Avatar,
        rows: &Rows<C>,
        neutral: [f16; C],
        k: usize,
        e: &[f64],
    ) -> [f64; C] {
        let n = avatar.basis_len();
        let row = rows.basis.row(
            rows.gaussian
                .binary_search(&(k as u32))
                .expect("all have a row"),
            C * n,
        );
        let along = |c: usize| row.piece(c * n, n).dot(e);
        std::array::from_fn(|c| neutral[c].to_f64() + along(c))
    }
    let half = |v: [f64; 3]| v.map(f16::from_f64);
    let mut frame = FrameAttributes {
        rotation: vec![],
        log_scale: vec![],
        color: vec![],
        offset: vec![],
    };
    for k in 0..avatar.gaussians.len() {
        let e = &features[part(k) * avatar.networks.output()..][..avatar.basis_len()];
        let [w, x, y, z] = changed(
            avatar,
            &avatar.rotation_rows,
            avatar.gaussians.rotation[k],
            k,
            e,
        );
        let q = DQuat::from_xyzw(x, y, z, w).normalize();
        frame.rotation.push([q.w, q.x, q.y, q.z].map(f16::from_f64));
        frame.log_scale.push(half(changed(
            avatar,
            &avatar.scale_rows,
            avatar.gaussians.log_scale[k],
            k,
            e,
        )));
        frame.color.push(half(changed(
            avatar,
            &avatar.color_rows,
            avatar.gaussians.color[k],
            k,
            e,
        )));
        let moved = displacement(avatar.node_weights(k), avatar.gaussians.node[k], &nodes);
        frame.offset.push(half(moved.to_array()));
    }
    frame
}

/// Writes the model's dataset, every fourth run of four frames held out.
fn write_dataset(folder: &Path) -> PathBuf {
    let (avatar, clip) = model();
    let shots = (0..clip.frames())
        .map(|f| Shot {
            clip: "waves".into(),
            seconds: f as f64 / 30.0,
            held: f / 4 % 4 == 1,
        })
        .collect();
    let path = folder.join("model.dataset");
    let writer =
        DatasetWriter::new(&path, &avatar, &clip, shots).expect("the folder can be written");
    for f in 0..clip.frames() {
        writer
            .write_frame(f, &frame(&avatar, &Posed::new(&avatar, &clip.frame(f))))
            .expect("a frame can be written");
    }
    writer.finish().expect("the header can be written");
    path
}

fn quiet(_: usize, _: &str) {}

fn effigy(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(common::program());
    command
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    command
}

fn works(folder: &Path, arguments: &str) {
    let output = effigy(folder, arguments)
        .output()
        .expect("the program is built");
    assert!(
        output.status.success(),
        "effigy {arguments}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
}

/// The one sentence that a command fails with.
fn fails(folder: &Path, arguments: &str) -> String {
    let output = effigy(folder, arguments)
        .output()
        .expect("the program is built");
    let text = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    assert!(
        !output.status.success() && text.starts_with("error: ") && text.lines().count() == 1,
        "effigy {arguments}: {text}"
    );
    text
}

fn a_fit_learns_what_made_the_data_and_pruning_keeps_what_varies_most() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let dataset = Dataset::open(&write_dataset(folder.path())).expect("the dataset is sound");
    let (truth, _) = model();
    let options = FitOptions {
        epochs: 240,
        budget: None,
        constraint: 0.0,
        ..FitOptions::default()
    };
    let fitted = fit(&dataset, &options, &quiet).expect("the fit runs");
    let avatar = &fitted.avatar;
    assert_eq!(
        Avatar::from_bytes(&avatar.to_bytes().expect("it keeps the file's rules")).as_ref(),
        Ok(avatar)
    );
    let last = fitted.curve.last().expect("a curve");
    assert!(
        last.training < 0.05,
        "{:.1} % of the training frames' spread is left",
        100.0 * last.training
    );
    let plan = EvaluationPlan {
        frames: dataset.training(&[]).into_iter().step_by(6).collect(),
        yaws: vec![20.0],
        size: [96, 128],
    };
    let psnr = |avatar: &Avatar| {
        evaluate(
            &dataset,
            avatar,
            &[Rendition::Neutral, Rendition::Learned],
            &plan,
            &|_| (),
        )
        .iter()
        .map(|s| s.mean.psnr_db)
        .collect::<Vec<_>>()
    };
    let [neutral, learned] = psnr(avatar)[..] else {
        panic!("two ways")
    };
    assert!(
        learned > neutral + 6.0,
        "{learned:.1} dB with correctives, {neutral:.1} dB without"
    );

    let pruned = prune(
        &dataset,
        avatar,
        &FitOptions {
            budget: Some(Budget::Rows(150)),
            ..options.clone()
        },
        &quiet,
    )
    .expect("it can be pruned")
    .avatar;
    let rows = |a: &Avatar| {
        [
            a.rotation_rows.gaussian.len(),
            a.scale_rows.gaussian.len(),
            a.color_rows.gaussian.len(),
        ]
    };
    assert_eq!(rows(&pruned), [150; 3]);
    assert_ne!(
        pruned.rotation_rows.gaussian, pruned.color_rows.gaussian,
        "attributes are pruned independently"
    );
    let spread = |k: u32| -> f64 {
        let colors: Vec<Vec<f64>> = (0..dataset.len())
            .map(|f| {
                frame(&truth, &Posed::new(&truth, &dataset.poses[f])).color[k as usize]
                    .map(f16::to_f64)
                    .to_vec()
            })
            .collect();
        (0..3)
            .map(|c| {
                colors
                    .iter()
                    .map(|v| v[c])
                    .fold([1e9, -1e9], |[l, h]: [f64; 2], v| [l.min(v), h.max(v)])
            })
            .map(|[l, h]| h - l)
            .sum()
    };
    let mean = |list: Vec<u32>| list.iter().map(|&k| spread(k)).sum::<f64>() / list.len() as f64;
    let removed: Vec<u32> = (0..600)
        .filter(|k| pruned.color_rows.gaussian.binary_search(k).is_err())
        .step_by(30)
        .collect();
    let retained: Vec<u32> = pruned
        .color_rows
        .gaussian
        .iter()
        .copied()
        .step_by(10)
        .collect();
    let (retained, removed) = (mean(retained), mean(removed));
    assert!(
        retained > 1.3 * removed,
        "retained colours range over {retained:.3}, removed ones over {removed:.3}"
    );
    let after = psnr(&pruned)[1];
    assert!(
        after > neutral + 1.0 && after < learned,
        "{after:.1} dB pruned, {learned:.1} dB whole, {neutral:.1} dB without"
    );
    let shown = prune(
        &dataset,
        avatar,
        &FitOptions {
            budget: Some(Budget::Contribution(450)),
            ..options.clone()
        },
        &quiet,
    )
    .expect("it can be pruned")
    .avatar;
    assert_eq!(
        rows(&shown).iter().sum::<usize>(),
        450,
        "{:?}",
        rows(&shown)
    );
    let best = psnr(&shown)[1];
    assert!(
        best > after && best < learned,
        "{best:.1} dB with the rows that images show most, {after:.1} dB with as many of each"
    );
    let budget = prune(
        &dataset,
        avatar,
        &FitOptions {
            budget: Some(Budget::Variance(0.9)),
            ..options
        },
        &quiet,
    )
    .expect("it can be pruned")
    .avatar;
    assert!(
        (150..600).contains(&budget.color_rows.gaussian.len()),
        "{} rows hold 90 % of the variance",
        budget.color_rows.gaussian.len()
    );
}

fn the_constraint_makes_correctives_smaller() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let dataset = Dataset::open(&write_dataset(folder.path())).expect("the dataset is sound");
    let size = |constraint: f32| {
        let avatar = fit(
            &dataset,
            &FitOptions {
                epochs: 40,
                budget: None,
                constraint,
                ..FitOptions::default()
            },
            &quiet,
        )
        .expect("the fit runs")
        .avatar;
        avatar
            .color_rows
            .basis
            .halves()
            .iter()
            .map(|b| b.to_f64().abs())
            .sum::<f64>()
    };
    let (free, held) = (size(0.0), size(40.0));
    assert!(
        held < 0.8 * free,
        "{held} with the constraint, {free} without"
    );
}

fn an_interrupted_fit_goes_on_and_ends_with_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    write_dataset(folder.path());
    let at = |name: &str| std::fs::read(folder.path().join(name)).expect("the file was written");
    works(
        folder.path(),
        "fit model.dataset --out whole.avatar --epochs 160 --keep 600 --checkpoint 0",
    );
    let arguments = "fit model.dataset --out cut.avatar --epochs 160 --keep 600 --checkpoint 0";
    let mut cuts = 0;
    // Once in every stage: the last has rows that were pruned.
    for stage in 0..3 {
        let mut child = effigy(folder.path(), arguments)
            .env("RAYON_NUM_THREADS", "1")
            .spawn()
            .expect("the program is built");
        let checkpoint = folder.path().join("cut.checkpoint");
        let reached = || {
            std::fs::read(&checkpoint).is_ok_and(|file| {
                String::from_utf8_lossy(&file).contains(&format!("stage\\\":{stage}"))
            })
        };
        let before = std::fs::metadata(&checkpoint)
            .and_then(|file| file.modified())
            .ok();
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(60)
            && child.try_wait().expect("the child is ours").is_none()
        {
            let now = std::fs::metadata(&checkpoint)
                .and_then(|file| file.modified())
                .ok();
            if now.is_some() && now != before && reached() {
                child.kill().expect("the child is ours");
                cuts += 1;
                break;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        child.wait().expect("the child is ours");
    }
    println!("{cuts} of 3 fits were cut short");
    assert!(cuts > 0, "no fit was cut short");
    if folder.path().join("cut.checkpoint").exists() {
        let other = fails(
            folder.path(),
            "fit model.dataset --out cut.avatar --epochs 161 --keep 600",
        );
        assert!(
            other.contains("cut.checkpoint") && other.contains("another fit"),
            "{other}"
        );
    }
    works(folder.path(), arguments);
    assert!(
        !folder.path().join("cut.checkpoint").exists(),
        "a checkpoint is left behind"
    );
    assert!(at("cut.avatar") == at("whole.avatar"), "the avatars differ");
    assert!(
        at("cut.loss.csv") == at("whole.loss.csv"),
        "the curves differ"
    );
    works(
        folder.path(),
        "fit model.dataset --out other.avatar --epochs 160 --keep 600 --seed 2",
    );
    assert!(
        at("other.avatar") != at("whole.avatar"),
        "the seed changes nothing"
    );
}

#[cfg(target_os = "linux")]
fn a_full_disk_is_said_and_leaves_the_last_good_file() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    write_dataset(folder.path());
    std::fs::write(folder.path().join("out.avatar"), "the last good file")
        .expect("the folder can be written");
    // No file may grow beyond 64 KiB: what a full disk does to a write.
    let script =
        "trap '' XFSZ; ulimit -f 64; exec \"$0\" fit model.dataset --out out.avatar --epochs 8";
    let output = Command::new("bash")
        .args(["-c", script])
        .arg(common::program())
        .current_dir(folder.path())
        .output();
    let output = output.expect("there is a shell");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(
        !output.status.success() && text.contains("cannot write") && text.contains("out."),
        "{text}"
    );
    assert_eq!(
        std::fs::read_to_string(folder.path().join("out.avatar")).expect("it is still there"),
        "the last good file"
    );
    let left: Vec<_> = std::fs::read_dir(folder.path())
        .expect("the folder")
        .flatten()
        .map(|entry| entry.file_name())
        .collect();
    assert!(
        !left
            .iter()
            .any(|name| name.to_string_lossy().ends_with(".part")),
        "{left:?}"
    );
}

/// A dataset that something was done to is refused, and the sentence says what it must.
fn refused(what: impl Fn(&Path), words: &[&str]) {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let path = write_dataset(folder.path());
    what(&path);
    let text = fails(folder.path(), "fit model.dataset --out out.avatar");
    words
        .iter()
        .for_each(|word| assert!(text.contains(word), "\"{text}\" does not say \"{word}\""));
    assert!(!folder.path().join("out.avatar").exists());
}

/// Writes frame 7 anew, changed.
fn change(path: &Path, at: impl Fn(&mut FrameAttributes)) {
    let (avatar, clip) = model();
    let mut changed = frame(&avatar, &Posed::new(&avatar, &clip.frame(7)));
    at(&mut changed);
    write_frame(&path.join(frame_name(7)), &changed);
}

fn write_frame(path: &Path, frame: &FrameAttributes) {
    use safetensors::{Dtype, tensor::TensorView};
    let count = frame.color.len();
    let columns: [(&str, usize, &[u8]); 4] = [
        ("rotation", 4, bytemuck::cast_slice(&frame.rotation)),
        ("log_scale", 3, bytemuck::cast_slice(&frame.log_scale)),
        ("color", 3, bytemuck::cast_slice(&frame.color)),
        ("offset", 3, bytemuck::cast_slice(&frame.offset)),
    ];
    let views = columns.map(|(name, width, bytes)| {
        (
            name,
            TensorView::new(Dtype::F16, vec![count, width], bytes).expect("the shape fits"),
        )
    });
    std::fs::write(path, safetensors::serialize(views, None).expect("tensors"))
        .expect("the file can be written");
}

fn damaged_datasets_are_refused_by_file_and_frame() {
    let cut = |f: &mut FrameAttributes| {
        f.rotation.truncate(599);
        f.log_scale.truncate(599);
        f.color.truncate(599);
        f.offset.truncate(599);
    };
    refused(
        |path| std::fs::remove_file(path.join(frame_name(7))).expect("it is there"),
        &["frame-00007.safetensors, frame 7", "nothing"],
    );
    refused(
        |path| change(path, cut),
        &["frame-00007.safetensors, frame 7", "[599, 4]", "[600, 4]"],
    );
    refused(
        |path| change(path, |f| f.color[3][1] = f16::NAN),
        &[
            "frame-00007.safetensors, frame 7",
            "NaN",
            "`color` of Gaussian 3",
        ],
    );
    let shorten = |path: &Path| {
        let bytes = std::fs::read(path.join(frame_name(7))).expect("it is there");
        std::fs::write(path.join(frame_name(7)), &bytes[..bytes.len() - 9])
            .expect("it can be written");
    };
    refused(shorten, &["frame-00007.safetensors, frame 7", "whole"]);
    refused(
        |path| std::fs::remove_file(path.join("dataset.json")).expect("it is there"),
        &["dataset.json", "interrupted"],
    );
    refused(
        |path| std::fs::write(path.join("dataset.json"), "{").expect("it can be written"),
        &["dataset.json", "a dataset's header"],
    );
}

fn datasets_of_another_skeleton_or_length_are_refused() {
    let clip = |at: &dyn Fn(&mut Clip)| {
        let mut clip = model().1;
        at(&mut clip);
        move |path: &Path| {
            clip.write(&path.join("poses.motion"))
                .expect("it can be written")
        }
    };
    refused(
        clip(&|clip| clip.joint[3] = "tail".into()),
        &[
            "poses.motion",
            "joint \"tail\"",
            "neutral.avatar's skeleton",
        ],
    );
    let shorter = clip(&|clip| {
        clip.translation.truncate(40);
        clip.rotation.truncate(40 * 24);
        clip.expression.truncate(400);
    });
    refused(shorter, &["poses.motion, frame 40", "40 poses", "48"]);
    let smaller = |path: &Path| {
        let avatar = common::avatar(
            11,
            Sizes {
                gaussians: 500,
                parts: 6,
                nodes: 60,
                joints: 24,
                ..Sizes::default()
            },
        );
        avatar
            .write(&path.join("neutral.avatar"))
            .expect("it can be written");
    };
    refused(smaller, &["neutral.avatar", "500 Gaussians", "600"]);
    let folder = tempfile::tempdir().expect("a folder can be made");
    write_dataset(folder.path());
    common::small_files(folder.path());
    let text = fails(folder.path(), "evaluate small.avatar model.dataset");
    assert!(
        text.contains("small.avatar") && text.contains("another skeleton"),
        "{text}"
    );
    let text = fails(
        folder.path(),
        "fit model.dataset --clip jumps --out out.avatar",
    );
    assert!(
        text.contains("no clip `jumps`") && text.contains("waves"),
        "{text}"
    );
}

tests! {
    a_fit_learns_what_made_the_data_and_pruning_keeps_what_varies_most,
    the_constraint_makes_correctives_smaller,
    an_interrupted_fit_goes_on_and_ends_with_the_same_bytes,
    #[cfg(target_os = "linux")]
    a_full_disk_is_said_and_leaves_the_last_good_file,
    damaged_datasets_are_refused_by_file_and_frame,
    datasets_of_another_skeleton_or_length_are_refused,
}
