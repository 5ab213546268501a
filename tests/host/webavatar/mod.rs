//! The paper's own model: `tests/data/webavatar/make.py`, which knows nothing of Effigy, wrote the
//! files and computed what they show.

pub mod hostile;

use effigy_core::{
    avatar::{Activation, Avatar, Pose, Skeleton},
    reference::{mlp, nodes, project},
    scene::Posed,
};
use effigy_formats::{
    read::{self, ClipOptions, Source},
    splats::Nothing,
    webavatar::{self, ColorCode, ForeignAvatar, Options},
};
use glam::DVec3;
use serde::Deserialize;

pub const SMALL: &[u8] = include_bytes!("../../data/webavatar/small.npz");
/// The numbers of [`SMALL`] in other widths and orders of memory, with a padded input of 80.
const WIDE: &[u8] = include_bytes!("../../data/webavatar/wide.npz");
const POSES: &[u8] = include_bytes!("../../data/webavatar/small_poses.json");

/// A frame as NumPy computed it; Gaussians in the file's order.
#[derive(Deserialize)]
struct Shown {
    part: Vec<usize>,
    centre: Vec<[f64; 3]>,
    /// xx xy xz yy yz zz.
    covariance: Vec<[f64; 6]>,
    color: Vec<[f64; 3]>,
}

fn shown() -> Vec<Shown> {
    let text = include_str!("../../data/webavatar/small_shown.json");
    serde_json::from_str(text).unwrap()
}

fn small() -> ForeignAvatar {
    webavatar::from_bytes(SMALL, "small", &Options::default()).unwrap()
}

/// The file's indices of Gaussians in the avatar's order: by part.
fn order(part: &[usize]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..part.len()).collect();
    order.sort_by_key(|&gaussian| part[gaussian]);
    order
}

fn a_model_shows_what_numpy_computes_from_the_documented_equations() {
    let avatar = small().avatar;
    let clip = webavatar::read_poses(POSES, "small", &avatar.skeleton, 30.0).unwrap();
    assert_eq!((clip.frames(), clip.expression_len), (3, 10));
    for (frame, shown) in shown().iter().enumerate() {
        let posed = Posed::new(&avatar, &clip.frame(frame));
        let features = mlp::features(&avatar, &posed.input);
        let moved = nodes::nodes(&avatar, &features);
        let gaussians = project::gaussians(&avatar, &posed, &features, &moved);
        for (own, k) in gaussians.iter().zip(order(&shown.part)) {
            let off = own.mean.distance(DVec3::from(shown.centre[k]));
            // 16 bits a coordinate; weights of nodes that are not where they were.
            assert!(off < 5e-5, "frame {frame}: Gaussian {k} is {off} m off");
            let color = (own.color - DVec3::from(shown.color[k]))
                .abs()
                .max_element();
            assert!(color < 2e-3, "frame {frame}: colour {k} is {color} off");
            let sigma = own.covariance();
            let [xx, xy, xz, yy, yz, zz] = shown.covariance[k];
            let size = xx + yy + zz;
            let pairs = [
                (sigma.x_axis.x, xx),
                (sigma.y_axis.x, xy),
                (sigma.z_axis.x, xz),
                (sigma.y_axis.y, yy),
                (sigma.z_axis.y, yz),
                (sigma.z_axis.z, zz),
            ];
            for (found, expected) in pairs {
                assert!(
                    (found - expected).abs() < 1e-3 * size,
                    "frame {frame}: shape {k}"
                );
            }
        }
    }
}

fn widths_orders_of_memory_and_padding_change_nothing() {
    let wide = webavatar::from_bytes(WIDE, "small", &Options::default()).unwrap();
    assert_eq!(wide.avatar, small().avatar);
    let input = |imported: &ForeignAvatar| {
        let asked = |a: &&effigy_formats::assumption::Assumption| a.what == "networks' input";
        imported
            .assumptions
            .iter()
            .find(asked)
            .unwrap()
            .taken
            .clone()
    };
    assert_eq!(input(&small()), "63 of a pose, 10 of an expression");
    assert!(input(&wide).contains("6 of padding"), "{}", input(&wide));
}

fn what_the_file_leaves_open_can_be_said() {
    let said = Options {
        activation: Activation::Relu,
        color: ColorCode::Offset,
    };
    let other = webavatar::from_bytes(SMALL, "small", &said).unwrap().avatar;
    let usual = small().avatar;
    assert_eq!(other.networks.activation, Activation::Relu);
    let [a, b] = [&usual, &other].map(|avatar| avatar.gaussians.color[3][1].to_f64() - 0.5);
    assert!((a - 0.282_094_8 * b).abs() < 1e-3, "{a} and {b}");
}

/// What is written is read again, with no more rounding than the format's halves.
fn a_model_that_was_written_is_read_again() {
    let avatar = small().avatar;
    let (bytes, losses) = webavatar::to_bytes(&avatar).unwrap();
    assert!(losses.is_empty(), "{losses:?}");
    let again = webavatar::from_bytes(&bytes, "small", &Options::default()).unwrap();
    compare(&avatar, &again.avatar, 5e-4);
}

/// The demo has joints, a canonical pose and networks that the format can hold.
fn the_demo_is_the_same_after_a_journey() {
    let demo = effigy_demo::avatar().unwrap();
    let (bytes, losses) = webavatar::to_bytes(&demo).unwrap();
    assert_eq!(losses.len(), 2, "{losses:?}");
    let back = webavatar::from_bytes(&bytes, "demo", &Options::default()).unwrap();
    assert_eq!(back.avatar.skeleton.len(), 55);
    compare(&demo, &back.avatar, 1e-3);
}

/// Poses both by one frame of the demo's clip, and compares centres and colours.
fn compare(a: &Avatar, b: &Avatar, tolerance: f64) {
    let clip = effigy_demo::clip().unwrap();
    let evaluate = |avatar: &Avatar| {
        let pose = clip.frame(40);
        let map = clip.map_to(&avatar.skeleton);
        let pose = Pose {
            rotation: map
                .iter()
                .map(|joint| joint.map_or(DVec3::ZERO, |joint| pose.rotation[joint]))
                .collect(),
            ..pose
        };
        let posed = Posed::with_projection(avatar, &pose, false);
        let features = mlp::features(avatar, &posed.input);
        project::gaussians(avatar, &posed, &features, &nodes::nodes(avatar, &features))
    };
    let [a, b] = [a, b].map(evaluate);
    assert_eq!(a.len(), b.len());
    for (k, (a, b)) in a.iter().zip(&b).enumerate() {
        let off = a.mean.distance(b.mean);
        assert!(off < tolerance, "Gaussian {k} is {off} m off");
        let color = (a.color - b.color).abs().max_element();
        assert!(color < 4e-3, "colour {k} is {color} off");
        assert_eq!(a.opacity, b.opacity);
    }
}

fn what_the_format_cannot_hold_is_refused() {
    let refusal = |change: &dyn Fn(&mut Avatar)| {
        let mut avatar = small().avatar;
        change(&mut avatar);
        match webavatar::to_bytes(&avatar) {
            Ok(_) => "none".to_owned(),
            Err(error) => error.to_string(),
        }
    };
    let names = [
        (refusal(&|a| a.skeleton.name[4] = "Tail".into()), "`Tail`"),
        (
            refusal(&|a| a.skeleton.parent[15] = Some(9)),
            "`Head` under",
        ),
        (
            refusal(&|a| a.skeleton.canonical[1][2] = 0.0),
            "`LeftUpLeg` turned",
        ),
        (refusal(&|a| a.inputs.joint.swap(0, 1)), "`inputs`"),
        (
            refusal(&|a| a.networks.activation = Activation::Relu),
            "with ReLU",
        ),
    ];
    for (found, expected) in names {
        assert!(found.contains(expected), "{found}, expected {expected}");
    }
}

/// Poses are a clip as they are for the model that they lie beside, however its arms rest; another
/// body with arms that are level follows them by its own bones.
fn poses_are_taken_as_they_are_by_the_models_own_skeleton() {
    let clip = |skeleton: &Skeleton| {
        let mut beside = Nothing;
        let source = Source::new(POSES, "small_poses.json".as_ref(), &mut beside);
        read::clip(source, skeleton, || None, &ClipOptions::default()).unwrap()
    };
    let own = small().avatar.skeleton;
    let mut lowered = own.clone();
    for (name, rest) in lowered.name.iter().zip(&mut lowered.rest) {
        if name.starts_with("LeftForeArm") || name.starts_with("LeftHand") {
            rest[1] -= 1.0;
        }
    }
    for skeleton in [&own, &lowered] {
        assert!(clip(skeleton).report.is_none());
    }
    let mut fewer = own.clone();
    for list in [&mut fewer.rest, &mut fewer.canonical] {
        list.pop();
    }
    fewer.name.pop();
    fewer.parent.pop();
    let mut renamed = own.clone();
    renamed.name.swap(22, 23);
    let mut turned = own;
    turned.parent[22] = Some(12);
    for skeleton in [&fewer, &renamed, &turned] {
        assert!(clip(skeleton).report.is_some());
    }
}

tests! {
    poses_are_taken_as_they_are_by_the_models_own_skeleton,
    a_model_shows_what_numpy_computes_from_the_documented_equations,
    widths_orders_of_memory_and_padding_change_nothing,
    what_the_file_leaves_open_can_be_said,
    a_model_that_was_written_is_read_again,
    the_demo_is_the_same_after_a_journey,
    what_the_format_cannot_hold_is_refused,
}
