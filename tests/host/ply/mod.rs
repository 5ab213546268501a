//! 3DGS's `.ply` and `cameras.json`: what they hold arrives, what is wrong with them is named, and
//! what we write can be read back.

pub mod adversarial;
pub mod cameras;
pub mod columns;
mod table;

use crate::common::{self, Sizes};
use effigy_cli::source::Source;
use effigy_core::{
    avatar::{Avatar, Clip},
    io::{
        ply,
        ply_export::to_ply,
        splats::{Uniform, Up, from_gaussians},
    },
    reference,
    scene::{AvatarBounds, Posed},
};
use effigy_measure::error;
use glam::{DAffine3, DQuat, DVec3};
use table::{Encoding, Table};

fn every_encoding_and_order_gives_the_same_avatar() {
    for degree in 0..=3 {
        let table = Table::new(degree as u64, 100, degree);
        let avatar = table.read(Encoding::Little).unwrap();
        assert_eq!(
            avatar.sh.as_ref().map_or(0, |harmonics| harmonics.degree),
            degree
        );
        for encoding in [Encoding::Ascii, Encoding::Little, Encoding::Big] {
            assert_eq!(table.read(encoding).unwrap(), avatar);
            assert_eq!(table.clone().shuffled().read(encoding).unwrap(), avatar);
        }
    }
}

/// Every Gaussian of the file, found again by its position, has the file's numbers within what an
/// avatar's types can hold.
fn numbers_arrive_as_3dgs_means_them() {
    let table = Table::new(7, 200, 3);
    let avatar = table.read(Encoding::Little).unwrap();
    let (g, harmonics) = (&avatar.gaussians, avatar.sh.as_ref().unwrap());
    let step = g.bounds.step().max_element();
    for row in &table.rows {
        let get = |name: &str| f64::from(row[table.column(name)]);
        let three =
            |name: &str| DVec3::from_array(std::array::from_fn(|k| get(&format!("{name}_{k}"))));
        let at = DVec3::new(get("x"), get("y"), get("z"));
        let found = (0..g.len())
            .find(|&i| (avatar.position(i) - at).abs().max_element() <= 0.51 * step)
            .expect("its place is known");
        let vector = |v: [half::f16; 3]| DVec3::from(v.map(f64::from));
        assert!(
            (vector(g.log_scale[found]) - three("scale"))
                .abs()
                .max_element()
                <= 2e-3
        );
        assert!(
            (vector(g.color[found]) - (0.5 + 0.282_094_791_773_878 * three("f_dc")))
                .abs()
                .max_element()
                <= 5e-4
        );
        assert!(
            (f64::from(g.opacity[found]) / 255.0 - 1.0 / (1.0 + (-get("opacity")).exp())).abs()
                <= 0.51 / 255.0
        );
        let [w, x, y, z] = g.rotation[found].map(f64::from);
        let (got, expected) = (
            DQuat::from_xyzw(x, y, z, w),
            DQuat::from_xyzw(get("rot_1"), get("rot_2"), get("rot_3"), get("rot_0")),
        );
        assert!((got.normalize().dot(expected.normalize()).abs() - 1.0).abs() <= 1e-6);
        for function in 0..15 {
            let expected = DVec3::from_array(std::array::from_fn(|channel| {
                get(&format!("f_rest_{}", 15 * channel + function))
            }));
            assert!(
                (vector(harmonics.coefficients[15 * found + function]) - expected)
                    .abs()
                    .max_element()
                    <= 2e-4
            );
        }
    }
}

fn neighbours_in_memory_are_neighbours_in_space() {
    let avatar = Table::new(1, 4000, 0).read(Encoding::Little).unwrap();
    let path: f64 = (1..4000)
        .map(|i| avatar.position(i).distance(avatar.position(i - 1)))
        .sum();
    // At random, two points of a cube of side 2 are 1.32 apart.
    assert!(
        path / 3999.0 < 0.3,
        "{} from one to the next",
        path / 3999.0
    );
}

fn the_files_up_becomes_y() {
    let table = Table::new(3, 50, 0);
    let bytes = table.bytes(Encoding::Little);
    let ours = String::from_utf8_lossy(&bytes[..4]).into_owned() + "comment effigy up z\n";
    let ours = [ours.as_bytes(), &bytes[4..]].concat();
    let world = |bytes: &[u8], up| {
        let avatar = ply::from_bytes(bytes, "", up).unwrap();
        let posed = Posed::new(&avatar, &Clip::still(&avatar.skeleton).sample(0.0));
        posed.joints[0].transform_vector3(DVec3::new(1.0, 2.0, 3.0))
    };
    for (bytes, up, expected) in [
        (&bytes, None, [1.0, -2.0, -3.0]),
        (&bytes, Some(Up::Y), [1.0, 2.0, 3.0]),
        (&bytes, Some(Up::MinusY), [1.0, -2.0, -3.0]),
        (&bytes, Some(Up::Z), [1.0, 3.0, -2.0]),
        (&bytes, Some(Up::MinusZ), [1.0, -3.0, 2.0]),
        (&ours, None, [1.0, 3.0, -2.0]),
        (&ours, Some(Up::Y), [1.0, 2.0, 3.0]),
    ] {
        assert!(
            world(bytes, up).distance(DVec3::from(expected)) < 1e-6,
            "{up:?}: {}",
            world(bytes, up)
        );
    }
}

fn a_static_avatar_needs_no_clip() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.ply");
    std::fs::write(&path, Table::new(1, 20, 2).bytes(Encoding::Little)).unwrap();
    let (avatar, clips) = Source {
        avatar: Some(path),
        motion: vec![],
        capture: Default::default(),
        up: Some(Up::Y),
        project: Default::default(),
    }
    .load()
    .unwrap();
    assert!(avatar.is_static() && avatar.name == "scene");
    assert_eq!(
        (clips.len(), clips[0].frames(), clips[0].duration()),
        (1, 1, 0.0)
    );
    let posed = Posed::new(&avatar, &clips[0].sample(0.0));
    assert!(posed.joints[0].abs_diff_eq(DAffine3::IDENTITY, 1e-12));
    let missing = Source {
        avatar: Some(folder.path().join("none.ply")),
        motion: vec![],
        capture: Default::default(),
        up: None,
        project: Default::default(),
    }
    .load()
    .unwrap_err();
    assert!(missing.to_string().contains("cannot read"), "{missing}");
}

#[cfg(feature = "window")]
fn the_viewer_rests_on_a_static_avatar() {
    let avatar = Table::new(1, 20, 2).read(Encoding::Little).unwrap();
    let clips = vec![Clip::still(&avatar.skeleton)];
    let mut scene = effigy_app::scene::ViewerScene::new(avatar, clips, [0.5; 3], [300, 200], 0.0);
    assert!(!scene.is_moving(), "the play bar is idle");
    let first = scene.advance(0.5, [300, 200]);
    assert!(scene.advance(3.0, [300, 200]) == first);
}

/// Images of an avatar in motion and of its file agree: the reference draws both.
fn an_exported_pose_looks_like_the_avatar() {
    let avatar = common::avatar(
        4,
        Sizes {
            gaussians: 8000,
            ..Sizes::default()
        },
    );
    let posed = Posed::new(&avatar, &common::pose(5, &avatar));
    let camera = common::gpu::camera(&avatar, &posed, [300, 300]);
    let stages = reference::ReferenceFrame::new(&avatar, &posed, &camera);
    let file =
        ply::from_bytes(&to_ply(&from_gaussians(&stages.gaussians, None)), "", None).unwrap();
    let still = Posed::new(&file, &Clip::still(&file.skeleton).sample(0.0));
    let error = error::between(
        &reference::render(&file, &still, &camera),
        &stages.canvas.to_image(),
    );
    assert!(
        error.covered.psnr_db >= 50.0 && error.covered.pixels > 1000,
        "{error:?}"
    );
    let opacity = |avatar: &Avatar| {
        let mut sorted = avatar.gaussians.opacity.clone();
        sorted.sort_unstable();
        sorted
    };
    assert_eq!(
        opacity(&file),
        opacity(&avatar),
        "eight bits of opacity come back"
    );
}

fn a_uniform_body_is_of_equal_balls() {
    let avatar = common::avatar(
        4,
        Sizes {
            gaussians: 500,
            ..Sizes::default()
        },
    );
    let posed = Posed::new(&avatar, &common::pose(5, &avatar));
    let stages = reference::ReferenceFrame::new(
        &avatar,
        &posed,
        &common::gpu::camera(&avatar, &posed, [20, 20]),
    );
    let balls = Uniform {
        deviation: 0.003,
        opacity: 0.9,
    };
    let body = to_ply(&from_gaussians(&stages.gaussians, Some(balls)));
    let body = ply::from_bytes(&body, "", None).unwrap();
    assert!(
        body.gaussians
            .log_scale
            .as_flattened()
            .iter()
            .all(|s| (s.to_f64().exp() - 0.003).abs() < 1e-5)
    );
    assert!(body.gaussians.opacity.iter().all(|&o| o == 230));
    let [min, max] = AvatarBounds::new(&avatar).bounds(&posed.joints);
    assert!(
        (0..500).all(|i| body.position(i).cmpge(min).all() && body.position(i).cmple(max).all())
    );
}

tests! {
    every_encoding_and_order_gives_the_same_avatar,
    numbers_arrive_as_3dgs_means_them,
    neighbours_in_memory_are_neighbours_in_space,
    the_files_up_becomes_y,
    a_static_avatar_needs_no_clip,
    the_viewer_rests_on_a_static_avatar,
    an_exported_pose_looks_like_the_avatar,
    a_uniform_body_is_of_equal_balls,
}
