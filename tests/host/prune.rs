//! Fewer correctives: which rows stay, what becomes of the others, and the command.

use crate::common::{self, Sizes};
use effigy_core::avatar::{Avatar, Clip, motion::Player};
use effigy_core::reference::{self, basis::corrective, mlp};
use effigy_core::scene::{AvatarBounds, Camera, Orbit, Posed};
use effigy_learn::prune::{RowBudget, prune};
use effigy_measure::similarity::similarity;
use half::f16;
use std::process::Command;

/// Gaussians, each with a row of every attribute.
const GAUSSIANS: usize = 600;

fn model() -> (Avatar, Clip) {
    let sizes = Sizes {
        gaussians: GAUSSIANS,
        parts: 6,
        nodes: 60,
        rows: GAUSSIANS,
        joints: 24,
        split_features: true,
        ..Sizes::default()
    };
    let avatar = common::avatar(11, sizes);
    let clip = common::clip(12, &avatar, 48);
    (avatar, clip)
}

fn rows(avatar: &Avatar) -> [usize; 3] {
    [
        avatar.rotation_rows.gaussian.len(),
        avatar.scale_rows.gaussian.len(),
        avatar.color_rows.gaussian.len(),
    ]
}

/// The colours of a Gaussian in all frames of a clip.
fn colors(avatar: &Avatar, clip: &Clip, gaussian: usize) -> Vec<[f64; 3]> {
    let color = |frame: usize| {
        let input = avatar.inputs.from_pose(&clip.frame(frame));
        let features = mlp::features(avatar, &input);
        let e = mlp::of_gaussian(avatar, &features, gaussian);
        let moved = corrective(&avatar.color_rows, gaussian, e);
        let neutral = avatar.gaussians.color[gaussian].map(f16::to_f64);
        [0, 1, 2].map(|c| neutral[c] + moved[c])
    };
    (0..clip.frames()).map(color).collect()
}

fn spread(colors: &[[f64; 3]]) -> f64 {
    let range = |c: usize| {
        let of = || colors.iter().map(move |color| color[c]);
        of().fold(f64::MIN, f64::max) - of().fold(f64::MAX, f64::min)
    };
    (0..3).map(range).sum()
}

/// Mean PSNR against the whole avatar in the clip's frames, dB.
fn psnr(whole: &Avatar, pruned: &Avatar, clip: &Clip) -> f64 {
    let bounds = AvatarBounds::new(whole);
    let frames = [3, 17, 31, 45];
    let of = |frame: usize| {
        let posed = Posed::new(whole, &clip.frame(frame));
        let orbit = Orbit {
            yaw: 0.4,
            pitch: 0.1,
            fov: 0.6,
        };
        let camera = Camera::around(bounds.framing(&posed.joints), orbit, [96, 128]);
        let truth = reference::render(whole, &posed, &camera);
        let image = reference::render(pruned, &posed, &camera);
        similarity(&image, &truth)
            .expect("the avatar is in the image")
            .psnr_db
    };
    frames.map(of).iter().sum::<f64>() / frames.len() as f64
}

fn what_varies_most_stays_and_the_rest_gets_its_mean() {
    let (avatar, clip) = model();
    let players = [Player::new(clip.clone(), &avatar.skeleton)];
    let pruned = prune(&avatar, &players, RowBudget::Rows(150));
    pruned.check().expect("it keeps the file's rules");
    assert_eq!(rows(&pruned), [150; 3]);
    assert_ne!(
        pruned.rotation_rows.gaussian, pruned.color_rows.gaussian,
        "attributes are pruned independently"
    );
    let (mut retained, mut removed) = (Vec::new(), Vec::new());
    for gaussian in (0..GAUSSIANS).step_by(7) {
        let before = colors(&avatar, &clip, gaussian);
        let after = colors(&pruned, &clip, gaussian);
        let has_row = pruned.color_rows.gaussian.contains(&(gaussian as u32));
        if has_row {
            assert_eq!(before, after, "Gaussian {gaussian} keeps its row");
            retained.push(spread(&before));
        } else {
            removed.push(spread(&before));
            let count = before.len() as f64;
            for c in 0..3 {
                let mean = before.iter().map(|color| color[c]).sum::<f64>() / count;
                let furthest = before.iter().map(|color| (color[c] - mean).abs());
                let furthest = furthest.fold(0.0, f64::max);
                // 200 poses of the clip and its 48 frames have nearly the same mean.
                assert!(
                    (after[0][c] - mean).abs() < 1e-3 + 0.2 * furthest,
                    "Gaussian {gaussian}: {} for a mean of {mean}, ±{furthest}",
                    after[0][c]
                );
            }
        }
    }
    let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len() as f64;
    assert!(
        mean(&retained) > 1.3 * mean(&removed),
        "retained colours range over {}, removed ones over {}",
        mean(&retained),
        mean(&removed)
    );
}

fn what_images_show_is_worth_more_than_variance() {
    let (avatar, clip) = model();
    let players = [Player::new(clip.clone(), &avatar.skeleton)];
    let each = prune(&avatar, &players, RowBudget::Rows(150));
    let shown = prune(&avatar, &players, RowBudget::Contribution(450));
    assert_eq!(rows(&shown).iter().sum::<usize>(), 450);
    let none = prune(&avatar, &players, RowBudget::Rows(0));
    let [none, each, shown] = [&none, &each, &shown].map(|pruned| psnr(&avatar, pruned, &clip));
    println!("{none:.2} dB without, {each:.2} as many of each, {shown:.2} as images show");
    assert!(none < each && each < shown, "{none}, {each}, {shown} dB");
    let share = prune(&avatar, &players, RowBudget::Variance(0.9));
    assert!(
        (150..GAUSSIANS).contains(&rows(&share)[2]),
        "{:?} rows hold 90 % of the variance",
        rows(&share)
    );
    let all = prune(&avatar, &players, RowBudget::Contribution(3 * GAUSSIANS));
    assert_eq!(all, avatar, "nothing to prune");
}

fn the_command_prunes_by_clips_or_by_the_poses_of_the_training() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let (avatar, clip) = model();
    avatar
        .write(&folder.path().join("whole.avatar"))
        .expect("it can be written");
    clip.write(&folder.path().join("waves.motion"))
        .expect("it can be written");
    let run = |arguments: &str| {
        Command::new(common::program())
            .args(arguments.split_whitespace())
            .current_dir(folder.path())
            .output()
            .expect("the program is built")
    };
    for arguments in [
        "prune whole.avatar --motion waves.motion --out pruned.avatar",
        "prune whole.avatar --keep 180 --out random.avatar",
    ] {
        let output = run(arguments);
        assert!(
            output.status.success(),
            "effigy {arguments}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        let name = arguments.split_whitespace().next_back().expect("a name");
        let pruned = Avatar::read(&folder.path().join(name)).expect("it was written");
        assert_eq!(rows(&pruned).iter().sum::<usize>(), 3 * GAUSSIANS / 10);
    }
    let again = run("prune none.avatar --out o.avatar");
    assert!(!again.status.success());
    let bare = prune(&avatar, &[], RowBudget::Rows(0));
    bare.write(&folder.path().join("bare.avatar"))
        .expect("it can be written");
    let output = run("prune bare.avatar --out o.avatar");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(
        !output.status.success() && text.contains("no correctives"),
        "{text}"
    );
}

tests! {
    what_varies_most_stays_and_the_rest_gets_its_mean,
    what_images_show_is_worth_more_than_variance,
    the_command_prunes_by_clips_or_by_the_poses_of_the_training,
}
