//! Levels of detail as they are made: a fit helps in poses and from sides that it did not see,
//! results do not depend on the number of threads, and files hold them.

use crate::common::{self, Sizes};
use effigy_core::{
    avatar::{Avatar, Filter, Level, LevelError, ShCoefficients, motion::Player},
    io::{
        pack::PackQuality,
        ply_export::to_ply,
        splats::{Splats, Up},
    },
};
use effigy_formats::open::{self, OpenOptions};
use effigy_learn::levels::{LevelOptions, LevelPoses, levels_of};
use half::f16;
use std::process::Command;

/// A small body.
fn body() -> Avatar {
    let sizes = Sizes {
        gaussians: 4000,
        ..Sizes::default()
    };
    common::avatar(3, sizes)
}

fn make(avatar: &Avatar, poses: &LevelPoses, images: usize, steps: usize) -> Vec<Level> {
    let options = LevelOptions {
        images,
        steps,
        ..LevelOptions::default()
    };
    let mut last = 0;
    let levels = levels_of(avatar, poses, &options, &mut |progress| {
        assert!(progress.done <= progress.all && progress.done >= last);
        last = progress.done;
    });
    let levelled = Avatar {
        levels,
        ..avatar.clone()
    };
    levelled.check().expect("levels can be drawn");
    levelled.levels
}

/// The error at the tallest of the heights with 4 samples: what a level shows most of.
fn tallest(level: &Level) -> LevelError {
    *level.measured.last().expect("it was measured")
}

fn a_fit_helps_in_poses_that_it_did_not_see() {
    let avatar = body();
    let clip = common::clip(4, &avatar, 40);
    let mut poses = LevelPoses::new(&avatar, &[Player::new(clip, &avatar.skeleton)], 1);
    poses.training.truncate(6);
    let merged = make(&avatar, &poses, 24, 0);
    let fitted = make(&avatar, &poses, 24, 60);
    let counts: Vec<usize> = fitted.iter().map(|level| level.gaussians.len()).collect();
    let whole = avatar.gaussians.len();
    assert_eq!(
        counts,
        [2, 4, 16].map(|one_in| whole / one_in),
        "a 64th is too few"
    );
    for (merged, fitted) in merged.iter().zip(&fitted) {
        let [before, after] = [merged, fitted].map(tallest);
        assert_eq!((before.height, before.samples), (after.height, 4));
        // Half of the Gaussians lose little in their merge.
        let gained = if 2 * fitted.gaussians.len() == whole {
            0.5
        } else {
            3.0
        };
        assert!(
            after.psnr_db > before.psnr_db + gained && after.psnr_db > 30.0,
            "{before:?}, then {after:?}"
        );
        assert!(
            after.color.abs() < 0.03 && after.coverage.abs() < 0.03,
            "{after:?}"
        );
    }
}

fn random_poses_do_for_an_avatar_without_a_clip() {
    let avatar = body();
    let mut poses = LevelPoses::new(&avatar, &[], 1);
    let pairs = poses.training.iter().zip(&poses.training[1..]);
    assert!(pairs.clone().all(|(a, b)| a != b) && poses.training.len() == 24);
    poses.training.truncate(4);
    let [before, after] = [0, 40].map(|steps| make(&avatar, &poses, 16, steps));
    let [before, after] = [tallest(&before[1]), tallest(&after[1])];
    assert!(
        after.psnr_db > before.psnr_db + 2.0,
        "{before:?}, then {after:?}"
    );
}

fn threads_do_not_change_the_result() {
    let avatar = body();
    let mut poses = LevelPoses::new(&avatar, &[], 1);
    poses.training.truncate(2);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads")
            .install(|| make(&avatar, &poses, 4, 3))
    };
    assert!(with(1) == with(3));
}

/// Splats in a ball, red from one side and blue from the other.
fn ball() -> Avatar {
    let random = &mut common::Random(5);
    let count = 2000;
    let position: Vec<[f32; 3]> = (0..count)
        .map(|_| random.vector(1.0).normalize().as_vec3().to_array())
        .collect();
    let splats = Splats {
        rotation: vec![[1.0, 0.0, 0.0, 0.0]; count],
        log_scale: vec![[-2.8; 3]; count],
        color: vec![[0.0; 3]; count],
        opacity: vec![2.0; count],
        degree: 1,
        harmonics: (0..count)
            .flat_map(|_| [[0.0; 3], [0.0; 3], [0.9, 0.0, -0.9]])
            .collect(),
        position,
        up: Up::ALL[0],
        filter: Filter::DEFAULT,
    };
    splats.to_avatar("ball").expect("valid splats")
}

fn splats_have_levels_too() {
    let avatar = ball();
    let poses = LevelPoses::new(&avatar, &[], 1);
    assert_eq!(poses.training.len(), 1);
    let levels = make(&avatar, &poses, 12, 40);
    assert_eq!(levels.len(), 2, "a 96th is too few");
    for level in &levels {
        let sh: &ShCoefficients = level.sh.as_ref().expect("as the avatar has");
        assert_eq!(sh.coefficients.len(), 3 * level.gaussians.len());
        // The third function is x, which is the same on all splats.
        let [red, green, blue] = sh.coefficients[2].map(f16::to_f32);
        assert!((red - 0.9).abs() < 1e-2 && green == 0.0 && (blue + 0.9).abs() < 1e-2);
        assert!(
            !level.correctives && tallest(level).psnr_db > 26.0,
            "{:?}",
            level.measured
        );
    }
}

fn too_few_gaussians_have_no_levels() {
    let sizes = Sizes {
        gaussians: 120,
        ..Sizes::default()
    };
    let avatar = common::avatar(1, sizes);
    let poses = LevelPoses::new(&avatar, &[], 1);
    assert!(make(&avatar, &poses, 2, 0).is_empty());
}

/// What the program prints, or its error.
fn run(arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(common::program())
        .args(arguments)
        .output()
        .expect("the program runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    if output.status.success() {
        Ok(text(&output.stdout))
    } else {
        Err(text(&output.stderr))
    }
}

/// From a `.ply` to a file with levels, in two steps or in one.
fn splats_are_imported_and_get_levels() {
    let folder = tempfile::tempdir().expect("a folder");
    let [ply, scan, two, one] = ["scene.ply", "scan.avatar", "two.avatar", "one.avatar"]
        .map(|name| folder.path().join(name).to_str().expect("UTF-8").to_owned());
    std::fs::write(&ply, to_ply(&common::splats(9, 5000, 1))).expect("it can be written");
    let said = run(&["import", &ply, "--out", &scan]).expect("it succeeds");
    assert!(
        said.ends_with("scan.avatar: 5000 Gaussians, spherical harmonics of degree 1\n"),
        "{said}"
    );
    let read = |path: &str| open::avatar(path.as_ref(), &OpenOptions::default());
    let imported = read(&scan).expect("an avatar").avatar;
    assert!(imported == read(&ply).expect("splats").avatar && imported.is_static());
    let pack = |from: &str, to: &str| {
        run(&["pack", from, "--levels", "--frames", "0", "--out", to]).expect("it succeeds")
    };
    let said = pack(&scan, &two);
    assert!(
        said.contains("spherical harmonics in 256ths") && !said.contains("networks in"),
        "{said}"
    );
    pack(&ply, &one);
    let [two_bytes, one_bytes] = [&two, &one].map(|path| std::fs::read(path).expect("a file"));
    assert!(two_bytes == one_bytes);
    let avatar = read(&two).expect("an avatar").avatar;
    let counts: Vec<usize> = avatar.levels.iter().map(|l| l.gaussians.len()).collect();
    assert_eq!(counts, [833, 208], "a 96th is too few");
    let shown = run(&["inspect", &two]).expect("it succeeds");
    assert!(shown.contains("degree 1"), "{shown}");
    for level in &avatar.levels {
        let error = tallest(level);
        let count = level.gaussians.len();
        assert!(
            shown.contains(&format!("level       {count} Gaussians, without networks"))
                && shown.contains(&format!("{:.1} dB, mean colour", error.psnr_db)),
            "{shown}"
        );
        // Colours of neighbours have nothing in common, so a mean is far from each of them.
        assert!(error.psnr_db > 20.0, "{error:?}");
    }
    let plain = imported.packed(PackQuality::High).to_packed_bytes();
    let before = plain.expect("it can be written").len();
    let after = two_bytes.len();
    assert!(after < before * 185 / 100, "{after} bytes after {before}");
    let motion = folder.path().join("walk.motion");
    let body = body();
    common::clip(4, &body, 4)
        .write(&motion)
        .expect("it can be written");
    let motion = motion.to_str().expect("UTF-8");
    for (arguments, expected) in [
        (
            &["pack", &scan, "--motion", motion, "--out", &one][..],
            "has splats, which stand still: motion is for avatars",
        ),
        (
            &[
                "pack",
                &ply,
                "--levels",
                "--held-out",
                motion,
                "--out",
                &one,
            ],
            "has splats, which stand still: --held-out is for avatars that move",
        ),
        (
            &["import", &ply, "--out", &ply],
            "does not end in .avatar, .motion",
        ),
        (
            &["import", &ply, "--trained", motion, "--out", &one],
            "--trained, --poses and --activation are for avatars that move",
        ),
        (
            &["import", motion, "--up", "y", "--out", &one],
            "--up is for splats",
        ),
        (
            &["pack", &scan, "--up", "y", "--out", &one],
            "--up is for splats only",
        ),
    ] {
        let error = run(arguments).expect_err("it is refused");
        assert!(error.contains(expected), "{error}");
    }
}

fn pack_makes_levels_and_inspect_shows_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("levels.avatar");
    let run = |arguments: &[&str]| run(arguments).expect("it succeeds");
    let file = folder.path().join("body.avatar");
    let whole = body();
    whole.write(&file).expect("it can be written");
    let motion = folder.path().join("walk.motion");
    let clip = common::clip(4, &whole, 40);
    clip.write(&motion).expect("it can be written");
    let [file, motion, path] =
        [&file, &motion, &out].map(|path| path.to_str().expect("a path in UTF-8"));
    let arguments = ["--levels", "--motion", motion, "--held-out", motion];
    let packed = [
        &["pack", file, "--frames", "0", "--out", path][..],
        &arguments,
    ]
    .concat();
    let packed = run(&packed);
    let avatar = Avatar::read(&out).expect("it was written");
    assert_eq!(avatar.levels.len(), 3);
    let shown = run(&["inspect", path]);
    for level in &avatar.levels {
        let error = tallest(level);
        assert!(error.psnr_db > 27.0, "{error:?}");
        let line = format!(
            "{} px tall, 4 × 4 samples a pixel: {:.1} dB",
            error.height, error.psnr_db
        );
        for text in [&packed, &shown] {
            assert!(text.contains(&line), "{line}: {text}");
        }
    }
    assert!(
        shown.contains("level       1,000 Gaussians, without networks"),
        "{shown}"
    );
    let plain = whole.packed(PackQuality::High).to_packed_bytes();
    let before = plain.expect("it can be written").len();
    let after = std::fs::metadata(&out).expect("it is there").len() as usize;
    assert!(after < before * 135 / 100, "{after} bytes after {before}");
}

tests! {
    a_fit_helps_in_poses_that_it_did_not_see,
    random_poses_do_for_an_avatar_without_a_clip,
    threads_do_not_change_the_result,
    splats_have_levels_too,
    too_few_gaussians_have_no_levels,
    splats_are_imported_and_get_levels,
    pack_makes_levels_and_inspect_shows_them,
}
