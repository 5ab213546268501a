//! Where the source files are: a small configuration of the real body, from clips to images, and
//! what the truth is made of.

use crate::common;
use effigy_core::avatar::{Avatar, Pose};
use effigy_learn::bake::{self, Assets, BakeSizes, BodyShape, CutOptions};
use effigy_learn::dataset::Dataset;
use effigy_learn::ground_truth::GroundTruth;
use glam::DVec3;
use half::f16;
use std::path::Path;
use std::process::Command;

fn works(folder: &Path, arguments: &str) {
    let output = Command::new(common::program())
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output();
    let output = output.expect("the program is built");
    assert!(
        output.status.success(),
        "effigy {arguments}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
}

/// Lines of a CSV by their first words.
fn lines(path: &Path) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(path).expect("the file was written");
    text.lines()
        .skip(1)
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect()
}

fn the_small_configuration_has_the_papers_orderings() {
    let assets = common::assets();
    let folder = tempfile::tempdir().expect("a folder can be made");
    works(
        folder.path(),
        &format!("bake motion 01_01.bvh --assets {assets} --rate 30 --out clip.motion"),
    );
    let sizes = "--gaussians 3000 --parts 24 --nodes 250 --frames 90 --rays 64";
    works(
        folder.path(),
        &format!("dataset clip.motion --assets {assets} {sizes} --out small.dataset"),
    );
    let dataset =
        Dataset::open(&folder.path().join("small.dataset")).expect("the dataset is sound");
    assert_eq!(
        (
            dataset.len(),
            dataset.avatar.gaussians.len(),
            dataset.avatar.parts.len()
        ),
        (90, 3000, 24)
    );
    let held = dataset
        .header
        .frames
        .iter()
        .filter(|shot| shot.held)
        .count();
    assert!((12..24).contains(&held), "{held} of 90 frames are held out");
    works(
        folder.path(),
        "analyse small.dataset --out analysis --fits --parts 6 --rows 0.1,0.5 --epochs 240 --frames 6 --size 120x160",
    );
    let text = std::fs::read_to_string(folder.path().join("analysis/analysis.txt"))
        .expect("the table was written");
    println!("{text}");
    let row = text
        .lines()
        .find(|line| line.starts_with("color"))
        .expect("a line of colours");
    let l1: Vec<f64> = row
        .split_whitespace()
        .skip(1)
        .map(|word| word.parse().expect("a number"))
        .collect();
    let [global, global_64, local, random] = l1[..] else {
        panic!("four numbers: {row}")
    };
    assert!(local <= 0.5 * global && global_64 < global, "{row}");
    // A group's own components always do at least as well as those that all share, and the better
    // the fewer Gaussians a group has.
    assert!(
        random > 0.7 * global && random <= global && random > 1.6 * local,
        "{row}"
    );

    let tried = lines(&folder.path().join("analysis/fits.csv"));
    let psnr = |what: &str| -> f64 {
        let line = tried
            .iter()
            .find(|line| line[0] == what)
            .unwrap_or_else(|| panic!("no line of {what}"));
        line[5].parse().expect("a number")
    };
    let (none, local, global) = (
        psnr("no correctives"),
        psnr("local 16 unpruned"),
        psnr("global 16 unpruned"),
    );
    assert!(
        local >= none + 3.0,
        "{local} dB, {none} without correctives"
    );
    assert!(
        local >= global + 1.0,
        "{local} dB, {global} with a global feature"
    );
    let pruned = |how: &str| {
        (
            psnr(&format!("10 % of rows {how}")),
            psnr(&format!("50 % of rows {how}")),
        )
    };
    for (tenth, half) in [pruned("each alike"), pruned("as shown")] {
        assert!(
            none < tenth && tenth < half && half <= local + 0.05,
            "{none} without, {tenth} with a tenth, {half} with half, {local} with all"
        );
    }
    let (each, shown) = (
        psnr("10 % of rows each alike"),
        psnr("10 % of rows as shown"),
    );
    assert!(
        shown > each + 1.0,
        "{shown} dB with a tenth of the rows by what images show, {each} as many of each attribute"
    );
    for name in [
        "components.csv",
        "explained-color.svg",
        "rows.svg",
        "kept.png",
    ] {
        assert!(
            folder
                .path()
                .join("analysis")
                .join(name)
                .metadata()
                .expect("it was written")
                .len()
                > 500,
            "{name}"
        );
    }
    works(
        folder.path(),
        "fit small.dataset --out learned.avatar --variance 0.9 --epochs 80",
    );
    works(
        folder.path(),
        "prune learned.avatar small.dataset --rows 200 --epochs 80 --out pruned.avatar",
    );
    works(
        folder.path(),
        "evaluate learned.avatar small.dataset --frames 2 --size 90x120 --json scores.json --images images",
    );
    let pruned = Avatar::read(&folder.path().join("pruned.avatar")).expect("it was written");
    assert_eq!(pruned.color_rows.gaussian.len(), 200);
    let space = pruned
        .inputs
        .pose_space
        .as_ref()
        .expect("the training poses' space is in the file");
    assert_eq!((space.mean.len(), space.sigma.len()), (63, 20));
    let scores: serde_json::Value = serde_json::from_slice(
        &std::fs::read(folder.path().join("scores.json")).expect("it was written"),
    )
    .expect("JSON");
    assert_eq!(
        scores.as_array().map(Vec::len),
        Some(6),
        "three ways, held out or not: {scores}"
    );
    assert_eq!(
        std::fs::read_dir(folder.path().join("images"))
            .expect("it was made")
            .count(),
        8
    );
}

fn ground_truth_depends_on_neither_threads_nor_the_hips_turn() {
    let assets = common::assets();
    let assets = Assets::new(assets);
    let skeleton = bake::skeleton(&assets, BodyShape::Male).expect("the assets are whole");
    let options = CutOptions {
        rate: 10.0,
        from: 1.0,
        to: Some(12.0),
        in_place: false,
        start: None,
        fade: 0.0,
        credit: String::new(),
    };
    let clip =
        bake::motion(&assets.path("01_01.bvh"), &skeleton, &options).expect("the capture is whole");
    let sizes = BakeSizes {
        gaussians: 1500,
        parts: 8,
        nodes: 60,
        rows: 0,
        seed: 7,
    };
    let dressed = bake::dressed(
        &assets,
        BodyShape::Male,
        std::slice::from_ref(&clip),
        &sizes,
        &|_| (),
    )
    .expect("the assets are whole");
    let truth = GroundTruth::new(&dressed, 48);
    let pose = clip.frame(60);
    let frame = truth.frame(&pose);
    let mut turned = pose.clone();
    turned.rotation[0] = DVec3::new(0.3, 2.0, -0.1);
    turned.translation = DVec3::new(4.0, 1.0, -2.0);
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("one thread can be had");
    assert!(
        one.install(|| truth.frame(&turned)) == frame,
        "two runs differ"
    );

    // In the canonical pose skinning is exact: nothing but cloth settles.
    let moved = |pose: &Pose| {
        let frame = truth.frame(pose);
        let lengths: Vec<f64> = frame
            .offset
            .iter()
            .map(|o| DVec3::from(o.map(f16::to_f64)).length())
            .collect();
        (
            lengths.iter().sum::<f64>() / lengths.len() as f64,
            lengths.iter().copied().fold(0.0, f64::max),
        )
    };
    let mut rest = Pose::rest(skeleton.len(), 10);
    let (calm, _) = moved(&rest);
    rest.rotation[18] = DVec3::new(0.0, -1.8, 0.0);
    rest.rotation[4] = DVec3::new(1.8, 0.0, 0.0);
    let (bent, furthest) = moved(&rest);
    assert!(calm < 0.0015, "{calm} m at rest");
    assert!(
        bent > 1.3 * calm && (0.004..0.12).contains(&furthest),
        "bent joints move Gaussians {bent} m on average, {furthest} m at most; {calm} m at rest"
    );
}

tests! {
    the_small_configuration_has_the_papers_orderings,
    ground_truth_depends_on_neither_threads_nor_the_hips_turn,
}
