//! mmlphuman's checkpoint: `tests/data/mmlphuman/make.py`, which knows nothing of Effigy, wrote the
//! file with PyTorch and computed with NumPy what it shows.

pub mod hostile;

use effigy_core::{
    avatar::{Activation, Avatar},
    io::file::FormatError,
};
use effigy_formats::{
    content::Content,
    mmlphuman::{Checkpoint, Options},
    pickle::Pickle,
};
use effigy_learn::{
    distil::{AnchorFeatures, DistilOptions, Distilled, SampleOptions, Teacher, distil},
    prune::RowBudget,
};
use glam::{DMat3, DVec3};
use serde::Deserialize;
use std::path::Path;

pub const SMALL: &[u8] = include_bytes!("../../data/mmlphuman/chkpnt800000.pth");

/// What NumPy computed of every so many Gaussians.
#[derive(Deserialize)]
struct Shown {
    eye: [f64; 3],
    every: usize,
    frames: Vec<ShownFrame>,
}

#[derive(Deserialize)]
struct ShownFrame {
    /// Index of the pose.
    frame: usize,
    position: Vec<[f64; 3]>,
    log_scale: Vec<[f64; 3]>,
    rotation: Vec<[f64; 4]>,
    opacity: Vec<f64>,
    centre: Vec<[f64; 3]>,
    /// xx xy xz yy yz zz.
    covariance: Vec<[f64; 6]>,
    color: Vec<[f64; 3]>,
}

fn shown() -> Shown {
    let text = include_str!("../../data/mmlphuman/shown.json");
    serde_json::from_str(text).unwrap()
}

/// Reads the small checkpoint and hands it over.
fn with_small<T>(options: &Options, then: impl FnOnce(&Checkpoint) -> T) -> T {
    let pickle = Pickle::from_bytes(SMALL).unwrap();
    let checkpoint = Checkpoint::new(&pickle, options).unwrap();
    then(&checkpoint)
}

/// Fails where a number is off by more than a share of 1, or of itself.
fn assert_near<const C: usize>(what: &str, own: [f64; C], expected: [f64; C], slack: f64) {
    for (own, expected) in own.iter().zip(expected) {
        let off = (own - expected).abs();
        assert!(
            off < slack * expected.abs().max(1.0),
            "{what}: {own}, NumPy has {expected}"
        );
    }
}

fn the_checkpoint_shows_what_numpy_computes_from_the_documented_equations() {
    let shown = shown();
    with_small(&Options::default(), |checkpoint| {
        let inputs = |frame: &ShownFrame| -> Vec<f32> {
            let joints = checkpoint.input_joints();
            let own = joints.map(|joint| checkpoint.poses[frame.frame].rotation[joint].as_vec3());
            own.flat_map(|axis| axis.to_array()).collect()
        };
        let rows: Vec<f32> = shown.frames.iter().flat_map(inputs).collect();
        let features = AnchorFeatures::new(&checkpoint.networks, &rows, &|_| {}).unwrap();
        let teacher = Teacher { checkpoint };
        for (row, frame) in shown.frames.iter().enumerate() {
            let look = teacher.look(&features, row);
            let pose = &checkpoint.poses[frame.frame];
            let posed = teacher.posed(&look, pose, DVec3::from(shown.eye));
            for (at, k) in (0..checkpoint.len()).step_by(shown.every).enumerate() {
                assert_near(
                    "position",
                    look.position[k].to_array(),
                    frame.position[at],
                    1e-6,
                );
                assert_near("log scale", look.log_scale[k], frame.log_scale[at], 2e-6);
                assert_near("rotation", look.rotation[k], frame.rotation[at], 2e-6);
                assert_near("opacity", [look.opacity[k]], [frame.opacity[at]], 2e-6);
                assert_near("centre", posed[k].mean.to_array(), frame.centre[at], 1e-6);
                assert_near("colour", posed[k].color.to_array(), frame.color[at], 2e-6);
                let own = upper(posed[k].covariance());
                // Relative to the largest variance.
                let size = frame.covariance[at]
                    .iter()
                    .fold(0.0, |m: f64, c| m.max(c.abs()));
                let expected = frame.covariance[at].map(|c| c / size);
                assert_near("covariance", own.map(|c| c / size), expected, 1e-5);
            }
        }
    });
}

fn upper(m: DMat3) -> [f64; 6] {
    let at = |row: usize, column: usize| m.col(column)[row];
    [at(0, 0), at(0, 1), at(0, 2), at(1, 1), at(1, 2), at(2, 2)]
}

fn the_file_is_told_from_others_and_says_what_it_has() {
    assert_eq!(Content::of(SMALL, Path::new("a.pth")), Content::Checkpoint);
    let other = include_bytes!("../../data/smpl/hmr4d_results.pt");
    assert_ne!(Content::of(other, Path::new("a.pt")), Content::Checkpoint);
    with_small(&Options::default(), |checkpoint| {
        assert_eq!(checkpoint.len(), 120);
        assert_eq!(checkpoint.networks.widths, [63, 24, 16, 10, 12]);
        assert_eq!(
            (
                checkpoint.networks.count,
                checkpoint.basis,
                checkpoint.node_basis
            ),
            (5, 7, 5)
        );
        assert_eq!(
            (checkpoint.poses.len(), checkpoint.iteration),
            (80, Some(800_000.0))
        );
        assert_eq!(checkpoint.skeleton.name[20], "LeftHand");
        let taken: Vec<&str> = checkpoint.assumptions.iter().map(|own| own.what).collect();
        assert!(
            taken.contains(&"free offset") && !taken.contains(&"node positions"),
            "{taken:?}"
        );
    });
}

/// Options change what the training code has as constants.
fn options_change_the_model() {
    let still = with_small(&Options::default(), |own| own.gaussians.position[0]);
    let options = Options {
        reach: 0.0,
        hips: 0.0,
        activation: Activation::LeakyRelu,
        ..Options::default()
    };
    with_small(&options, |checkpoint| {
        let moved = checkpoint.gaussians.position[0].distance(still);
        assert!(moved > 1e-4 && moved < 0.014, "{moved}");
        assert_eq!(checkpoint.skeleton.canonical[1], [0.0; 3]);
        assert_eq!(checkpoint.networks.activation, Activation::LeakyRelu);
    });
}

fn options(rows: usize) -> DistilOptions {
    DistilOptions {
        samples: SampleOptions {
            poses: 80,
            between: 40,
            seed: 1,
        },
        basis: 16,
        epochs: 160,
        budget: RowBudget::Rows(rows),
        seed: 1,
    }
}

fn distilled(rows: usize) -> Result<Distilled, FormatError> {
    with_small(&Options::default(), |checkpoint| {
        distil(checkpoint, "small", &[], &options(rows), &|_, _| {})
    })
}

fn a_distilled_avatar_is_like_its_checkpoint() {
    let Distilled { avatar, likeness } = distilled(120).unwrap();
    assert_eq!(avatar.parts.len(), 5);
    let again = Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap();
    assert_eq!(again, avatar);
    let [learned_left, held_left] = likeness.unexplained;
    assert!(learned_left < 0.005 && held_left < 0.04, "{likeness:?}");
    for (own, slack) in [(likeness.learned, 1.0), (likeness.held, 3.0)] {
        assert!(own.position < slack * 0.8e-3, "{own:?}");
        assert!(own.axes < slack * 0.4e-3, "{own:?}");
        assert!(own.log_scale < slack * 0.006, "{own:?}");
        assert!(own.color < slack * 0.005, "{own:?}");
        // Harmonics and a fifth joint, which images of the checkpoint have, weigh more here.
        assert!(own.psnr_db > own.neutral_db, "{own:?}");
        assert!(own.diffuse_db > own.psnr_db, "{own:?}");
    }
    assert!(likeness.harmonics_lost > 0.01 && likeness.skin_lost > 0.01);
}

fn pruned_rows_cost_little_and_runs_repeat() {
    let own = distilled(60).unwrap();
    for rows in [
        own.avatar.rotation_rows.gaussian.len(),
        own.avatar.scale_rows.gaussian.len(),
        own.avatar.color_rows.gaussian.len(),
    ] {
        assert_eq!(rows, 60);
    }
    let still = own.likeness.learned;
    let whole = distilled(120).unwrap().likeness.learned;
    assert!(still.color > whole.color && still.color < 0.1, "{still:?}");
    assert_eq!(distilled(60).unwrap().avatar, own.avatar);
}

tests! {
    the_checkpoint_shows_what_numpy_computes_from_the_documented_equations: smoke,
    the_file_is_told_from_others_and_says_what_it_has,
    options_change_the_model,
    a_distilled_avatar_is_like_its_checkpoint,
    pruned_rows_cost_little_and_runs_repeat,
}
