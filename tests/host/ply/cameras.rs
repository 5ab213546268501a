//! `cameras.json`: the cameras see what 3DGS sees, come back as they are written, and are refused
//! where they can't see.

use effigy_core::{
    avatar::{Avatar, Filter},
    io::{
        cameras,
        splats::{Splats, Up},
    },
    scene::Camera,
};
use glam::{DAffine3, DMat3, DVec2, DVec3};
use proptest::prelude::*;

/// What 3DGS writes: a camera two metres before the origin (COLMAP's z points forward), turned a
/// quarter about its own axis.
const CAMERAS: &str = r#"[{"id": 0, "img_name": "a", "width": 640, "height": 480, "position": [0, 0, -2],
    "rotation": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "fy": 500, "fx": 400, "extra": 1}]"#;

fn cameras_see_what_3dgs_sees() {
    let camera = cameras::parse(CAMERAS.as_bytes(), DAffine3::IDENTITY).unwrap()[0];
    assert_eq!(
        (camera.size, camera.focal, camera.center),
        (
            [640, 480],
            DVec2::new(400.0, 500.0),
            DVec2::new(320.0, 240.0)
        )
    );
    assert!(camera.eye().distance(DVec3::new(0.0, 0.0, -2.0)) < 1e-12);
    // The camera's x axis is the world's y; its y axis, down in the image, the world's −x.
    let at = camera.project(camera.view.transform_point3(DVec3::new(0.1, 0.2, 0.0)));
    assert!(
        at.distance(DVec2::new(320.0 + 400.0 * 0.1, 240.0 - 500.0 * 0.05)) < 1e-9,
        "{at}"
    );
    let turned = DAffine3::from_quat(Up::TRAINED.rotation());
    let turned = cameras::parse(CAMERAS.as_bytes(), turned).unwrap()[0];
    assert!(turned.eye().distance(DVec3::new(0.0, 0.0, 2.0)) < 1e-12);
    let again = turned.project(turned.view.transform_point3(DVec3::new(0.1, -0.2, 0.0)));
    assert!(
        again.distance(at) < 1e-9,
        "the same point in turned axes: {again}"
    );
    let half = cameras::scaled(&camera, [400, 240]);
    assert_eq!(
        (half.size, half.focal, half.center),
        (
            [400, 240],
            DVec2::new(200.0, 250.0),
            DVec2::new(200.0, 120.0)
        )
    );
}

/// Cameras of a scene of a centimetre have their near plane nearer than its splats; those of a person
/// have theirs where it was.
fn near_planes_follow_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cameras.json");
    std::fs::write(&path, CAMERAS).unwrap();
    let near = |avatar: &Avatar| effigy_cli::source::cameras(&path, avatar).unwrap()[0].near;
    let scene = |scale: f32| {
        let splats = Splats {
            position: vec![[scale, 0.0, 0.0], [-scale, scale, scale]],
            rotation: vec![[1.0, 0.0, 0.0, 0.0]; 2],
            log_scale: vec![[(0.1 * scale).ln(); 3]; 2],
            opacity: vec![2.0; 2],
            color: vec![[0.5; 3]; 2],
            degree: 0,
            harmonics: vec![],
            up: Up::TRAINED,
            filter: Filter::DEFAULT,
        };
        near(&splats.to_avatar("scene").unwrap())
    };
    assert_eq!(scene(10.0), Camera::NEAR);
    assert!((scene(0.01) / scene(0.1) - 0.1).abs() < 1e-3);
    assert!(scene(0.01) < 0.002);
    assert_eq!(near(&effigy_demo::avatar().unwrap()), Camera::NEAR);
}

/// What mmlphuman writes: a camera two metres before the origin, turned a quarter about its own
/// axis, as that of [`CAMERAS`] is.
const RIG: &str = r#"[{"cam_id": "00", "w2c": [[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 2], [0, 0, 0, 1]],
    "K": [[400, 0, 320], [0, 500, 240], [0, 0, 1]]}]"#;

fn cameras_of_mmlphuman_see_what_those_of_3dgs_see() {
    let read = |text: &str| cameras::parse(text.as_bytes(), DAffine3::IDENTITY);
    let [rig, plain] = [RIG, CAMERAS].map(|text| read(text).unwrap()[0]);
    assert!(rig.view.abs_diff_eq(plain.view, 1e-12), "{rig:?}");
    assert_eq!(
        (rig.size, rig.focal, rig.center),
        (plain.size, plain.focal, plain.center)
    );
    // A point to the right of the camera and in front of it is in the right half of the image.
    let point = rig
        .view
        .inverse()
        .transform_point3(DVec3::new(0.1, 0.0, 1.0));
    let at = rig.project(rig.view.transform_point3(point));
    assert!(at.distance(DVec2::new(360.0, 240.0)) < 1e-9, "{at}");

    let fault = |from: &str, to: &str| read(&RIG.replace(from, to)).unwrap_err().to_string();
    let cases = [
        (
            fault("[0, 0, 0, 1]", "[0, 0, 0, 2]"),
            "found the last row [0.0, 0.0, 0.0, 2.0] of `w2c` at camera 0, expected 0, 0, 0, 1",
        ),
        (
            fault("[400, 0, 320]", "[400, 9, 320]"),
            "found the matrix `K` [[400.0, 9.0, 320.0]",
        ),
        (
            fault("[400, 0, 320]", "[400, 0, -320]"),
            "found an image of -640 × 480 px at camera 0",
        ),
        (
            fault("[400, 0, 320]", "[0, 0, 320]"),
            "found focal lengths of 0 and 500 px",
        ),
        (
            fault("[0, 1, 0, 0]", "[0, 2, 0, 0]"),
            "found the matrix [[0.0, -1.0, 0.0], [2.0, 0.0, 0.0]",
        ),
        (fault("\"K\"", "\"k\""), "found missing field `K`"),
    ];
    for (found, expected) in cases {
        assert!(found.starts_with(expected), "{found}");
    }
}

fn other_programs_spellings_are_read() {
    let read = |text: &str| cameras::parse(text.as_bytes(), DAffine3::IDENTITY).unwrap();
    let plain = read(CAMERAS);
    for text in [
        CAMERAS.replace("640", "640.0"),
        CAMERAS.replace("\"id\": 0", "\"id\": \"cam_0\""),
        CAMERAS.replace(
            "\"id\": 0, \"img_name\": \"a\"",
            "\"id\": null, \"img_name\": 7",
        ),
        format!("{{\"cameras\": {CAMERAS}}}"),
    ] {
        assert_eq!(read(&text), plain, "{text}");
    }
}

fn an_optical_axis_beside_the_middle_stays_there_in_other_sizes() {
    let mut camera = cameras::parse(CAMERAS.as_bytes(), DAffine3::IDENTITY).unwrap()[0];
    camera.center = DVec2::new(330.0, 220.0);
    assert_eq!(cameras::scaled(&camera, camera.size), camera);
    let point = camera
        .view
        .inverse()
        .transform_point3(DVec3::new(0.1, -0.2, 1.0));
    let at = |camera: &Camera| camera.project(camera.view.transform_point3(point));
    let middle = |camera: &Camera| 0.5 * DVec2::new(camera.size[0].into(), camera.size[1].into());
    let half = cameras::scaled(&camera, [500, 240]);
    let expected = middle(&half) + 0.5 * (at(&camera) - middle(&camera));
    assert!(at(&half).distance(expected) < 1e-9);
}

fn cameras_come_back_as_they_are_written() {
    let written: Vec<_> = (0..5)
        .map(|k| {
            Camera::orbit(
                DVec3::new(0.1, 0.9, 0.0),
                f64::from(k),
                0.1 * f64::from(k),
                3.0,
                0.6,
                [200, 100 + k],
            )
        })
        .collect();
    let read = cameras::parse(cameras::to_json(&written).as_bytes(), DAffine3::IDENTITY).unwrap();
    assert_eq!(read.len(), written.len());
    for (read, written) in read.iter().zip(&written) {
        assert!(
            read.view.abs_diff_eq(written.view, 1e-12)
                && read.focal.abs_diff_eq(written.focal, 1e-9)
        );
        assert_eq!(
            (read.size, read.center, read.near),
            (written.size, written.center, written.near)
        );
    }
}

fn cameras_that_cannot_see_are_named() {
    let with = |from: &str, to: &str| {
        cameras::parse(CAMERAS.replace(from, to).as_bytes(), DAffine3::IDENTITY)
            .unwrap_err()
            .to_string()
    };
    let cases = [
        (
            with("640", "0"),
            "found an image of 0 × 480 px at camera 0, expected sides from 1 to 65536 px",
        ),
        (
            with("\"fx\": 400", "\"fx\": 0"),
            "found focal lengths of 0 and 500 px at camera 0",
        ),
        (
            with("[0, -1, 0]", "[0, -2, 0]"),
            "found the matrix [[0.0, -2.0, 0.0]",
        ),
        (
            with("[0, -1, 0]", "[0, 1, 0]"),
            "found the matrix [[0.0, 1.0, 0.0]",
        ),
        (
            with("[0, 0, -2]", "[0, 0, 1e999]"),
            "found number out of range",
        ),
        (with("\"width\": 640, ", ""), "found missing field `width`"),
        (with("[{", "{"), "found "),
    ];
    for (found, expected) in cases {
        assert!(found.starts_with(expected), "{found}");
    }
    assert!(
        cameras::parse(b"[]", DAffine3::IDENTITY)
            .unwrap_err()
            .to_string()
            .starts_with("found 0 cameras, expected 1 to")
    );
}

proptest! {
    fn changed_cameras_never_panic(rig: bool, changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6)) {
        let mut bytes = if rig { RIG } else { CAMERAS }.as_bytes().to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Ok(cameras) = cameras::parse(&bytes, DAffine3::from_mat3(DMat3::IDENTITY)) {
            prop_assert!(cameras.iter().all(|camera| camera.view.is_finite()));
        }
    }
}

tests! {
    cameras_see_what_3dgs_sees,
    near_planes_follow_the_scene,
    cameras_of_mmlphuman_see_what_those_of_3dgs_see,
    other_programs_spellings_are_read,
    an_optical_axis_beside_the_middle_stays_there_in_other_sizes,
    cameras_come_back_as_they_are_written,
    cameras_that_cannot_see_are_named,
    changed_cameras_never_panic,
}
