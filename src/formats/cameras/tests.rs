//! The layouts of other programs: each sees what it should, and what is wrong is named.

use super::*;
use effigy_core::scene::Camera;
use flate2::{Compression, write::GzEncoder};
use glam::{DVec2, DVec3};
use std::{
    fs,
    io::{Cursor, Write},
};
use zip::{ZipWriter, write::SimpleFileOptions};

/// One camera in each layout: 2.2 m before the origin on COLMAP's z, seen by 230 px, turned a
/// quarter about its own axis, with the optical axis 6 and −5 px from the image's middle.
const COLMAP_CAMERAS: &str = "# Camera list\n7 OPENCV 192 160 230 240 102 75 0.1 0 0 0\n";
const COLMAP_IMAGES: &str = "# Image list\n\
    3 0.70710678118654757 0 0 0.70710678118654757 0 0 2.2 7 b 1.jpg\n1 2 -1 4.5 6.5 9\n\
    9 0.70710678118654757 0 0 0.70710678118654757 0 0 2.2 7 a.jpg\n\n";
const TRANSFORMS: &str = r#"{"w": 192.0, "h": 160, "fl_x": 230, "fl_y": 240, "cx": 102, "cy": 75,
    "camera_model": "OPENCV", "k1": 0.1, "k2": 0, "frames": [{"file_path": "images/a.jpg",
    "transform_matrix": [[0, -1, 0, 0], [-1, 0, 0, 0], [0, 0, -1, -2.2], [0, 0, 0, 1]]}]}"#;

fn read_text(name: &str, text: &str) -> Result<OpenedCameras, String> {
    read_bytes(name, text.as_bytes())
}

fn read_colmap(cameras: &str, images: &str) -> Result<OpenedCameras, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("cameras.txt"), cameras).unwrap();
    fs::write(folder.path().join("images.txt"), images).unwrap();
    read(folder.path(), DAffine3::IDENTITY).map_err(|error| error.to_string())
}

fn check(camera: &Camera) {
    assert_eq!(camera.size, [192, 160]);
    assert!(
        camera.eye().distance(DVec3::new(0.0, 0.0, -2.2)) < 1e-9,
        "{camera:?}"
    );
    // The world's y is to the left in the image, its x points down.
    let at = camera.project(camera.view.transform_point3(DVec3::new(0.11, 0.22, 0.0)));
    let expected = DVec2::new(102.0 - 230.0 * 0.1, 75.0 + 240.0 * 0.05);
    assert!(at.distance(expected) < 1e-6, "{at}");
}

#[test]
fn colmap_and_transforms_see_the_same() {
    for opened in [
        read_colmap(COLMAP_CAMERAS, COLMAP_IMAGES).unwrap(),
        read_text("transforms.json", TRANSFORMS).unwrap(),
        read_text("t", &format!("\u{feff} {TRANSFORMS}")).unwrap(),
    ] {
        opened.cameras.iter().for_each(check);
        let [ref assumption] = opened.assumptions[..] else {
            panic!("{:?}", opened.assumptions)
        };
        assert_eq!(assumption.what, "distortion of the lens");
    }
}

fn read_bytes(name: &str, bytes: &[u8]) -> Result<OpenedCameras, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    read(&path, DAffine3::IDENTITY).map_err(|error| error.to_string())
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut gzip = GzEncoder::new(vec![], Compression::fast());
    gzip.write_all(bytes).unwrap();
    gzip.finish().unwrap()
}

fn zip(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(vec![]));
    for (name, bytes) in members {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// UTF-16 with its mark, as PowerShell redirects text.
fn utf16(text: &str) -> Vec<u8> {
    let units = "\u{feff}".encode_utf16().chain(text.encode_utf16());
    units.flat_map(u16::to_le_bytes).collect()
}

#[test]
fn what_is_packed_sees_the_same() {
    let plain = read_text("t.json", TRANSFORMS).unwrap();
    let transforms = TRANSFORMS.as_bytes();
    let litter: (&str, &[u8]) = ("scan/images/a.jpg", b"\xff\xd8");
    let text = |encode: &dyn Fn(&str) -> Vec<u8>| {
        zip(&[
            ("sparse/0/cameras.txt", &encode(COLMAP_CAMERAS)),
            ("sparse/0/images.txt", &encode(COLMAP_IMAGES)),
            ("sparse/0/points3D.txt", b"# none\n"),
        ])
    };
    let placed = br#"[{"width":192,"height":160,"position":[0,0,-2.2],
        "rotation":[[0,1,0],[-1,0,0],[0,0,1]],"fx":230,"fy":240}]"#;
    let cameras = read_bytes("cameras.json", placed).unwrap();
    for (name, packed, expected) in [
        ("t.json", utf16(TRANSFORMS), &plain),
        ("t.json.gz", gzip(transforms), &plain),
        ("t.json.gz", gzip(&utf16(TRANSFORMS)), &plain),
        ("t.zip", zip(&[("scan/t.json", transforms), litter]), &plain),
        (
            "scan.zip",
            zip(&[("t.json", transforms), ("a.ply", b"ply\n")]),
            &plain,
        ),
        ("scan.zip", zip(&[("t.json.gz", &gzip(transforms))]), &plain),
        (
            "two.zip.gz",
            gzip(&zip(&[("scan.zip", &zip(&[("t.json", transforms)]))])),
            &plain,
        ),
        ("cameras.json.gz", gzip(placed), &cameras),
        (
            "scan.zip",
            zip(&[("cameras.json", placed), ("cfg_args", b"x")]),
            &cameras,
        ),
        // What other readers would take whole.
        (
            "scan.zip",
            zip(&[("a/cameras.json", placed), ("poses.npy", b"x")]),
            &cameras,
        ),
    ] {
        assert_eq!(read_bytes(name, &packed).as_ref(), Ok(expected), "{name}");
    }
    let colmap = read_colmap(COLMAP_CAMERAS, COLMAP_IMAGES).unwrap();
    let own = |text: &str| text.as_bytes().to_vec();
    for packed in [text(&own), text(&utf16), gzip(&text(&own))] {
        assert_eq!(read_bytes("colmap.zip", &packed).as_ref(), Ok(&colmap));
    }
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in [
        ("cameras.txt", utf16(COLMAP_CAMERAS)),
        ("images.txt", utf16(COLMAP_IMAGES)),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    assert_eq!(read(folder.path(), DAffine3::IDENTITY).unwrap(), colmap);
}

#[test]
fn packed_files_without_cameras_say_what_they_hold() {
    let transforms = TRANSFORMS.as_bytes();
    let [lenses, images] = [COLMAP_CAMERAS, COLMAP_IMAGES].map(str::as_bytes);
    let litter: (&str, &[u8]) = ("scan/images/a.jpg", b"\xff\xd8");
    for (packed, expected) in [
        (
            zip(&[
                ("a_train.json", transforms),
                ("a_test.json", transforms),
                litter,
            ]),
            "found a zip of `a_train.json`, `a_test.json`, `scan/images/a.jpg`, expected one file",
        ),
        (
            zip(&[("0/cameras.bin", b"\x01"), ("0/images.bin", b"\x01")]),
            "expected cameras.json, transforms.json or COLMAP's text files in it",
        ),
        (zip(&[("0/images.txt", images)]), "cameras.txt beside it"),
        (
            zip(&[("0/cameras.txt", lenses)]),
            "COLMAP's text files in it",
        ),
        (gzip(b"hello"), "found other text"),
    ] {
        let error = read_bytes("scan.zip", &packed).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn images_of_colmap_are_in_the_order_of_their_names() {
    let moved = COLMAP_IMAGES.replacen("2.2 7 b", "4.4 7 b", 1);
    // With points, without, and where a program has left out the empty lines.
    let bare = moved
        .replace("1 2 -1 4.5 6.5 9\n", "")
        .replace("\n\n", "\n");
    let windows = moved.replace('\n', "\r\n");
    for images in [&moved, &bare, &windows] {
        let opened = read_colmap(COLMAP_CAMERAS, images).unwrap();
        let away: Vec<f64> = opened.cameras.iter().map(|c| -c.eye().z).collect();
        assert!(
            (away[0] - 2.2).abs() < 1e-9 && (away[1] - 4.4).abs() < 1e-9,
            "{away:?}"
        );
    }
}

#[test]
fn every_pinhole_of_colmap_is_read() {
    for (model, numbers) in [
        ("SIMPLE_PINHOLE", "230 96 80"),
        ("PINHOLE", "230 230 96 80"),
        ("SIMPLE_RADIAL", "230 96 80 0"),
        ("RADIAL", "230 96 80 0 0"),
        ("OPENCV", "230 230 96 80 0 0 0 0"),
        ("FULL_OPENCV", "230 230 96 80 0 0 0 0 0 0 0 0"),
    ] {
        let cameras = format!("7 {model} 192 160 {numbers}\n");
        let opened = read_colmap(&cameras, COLMAP_IMAGES).unwrap();
        assert_eq!(opened.cameras[0].focal, DVec2::splat(230.0), "{model}");
        assert_eq!(opened.cameras[0].center, DVec2::new(96.0, 80.0), "{model}");
        assert_eq!(opened.assumptions, [], "{model}");
        let short = format!("7 {model} 192 160 {}\n", &numbers[4..]);
        assert!(read_colmap(&short, COLMAP_IMAGES).is_err(), "{model}");
    }
}

#[test]
fn one_of_colmaps_files_finds_the_other() {
    let root = tempfile::tempdir().unwrap();
    let folder = root.path().join("sparse/0");
    fs::create_dir_all(&folder).unwrap();
    let failed = |path: &Path| read(path, DAffine3::IDENTITY).unwrap_err().to_string();
    fs::write(folder.join("cameras.bin"), [0xff, 1]).unwrap();
    fs::write(folder.join("images.bin"), [0xff, 1]).unwrap();
    assert!(failed(root.path()).contains("binary files, expected cameras.txt"));
    assert!(failed(&folder.join("images.bin")).contains("model_converter"));
    fs::write(folder.join("cameras.txt"), COLMAP_CAMERAS).unwrap();
    assert!(
        failed(&folder.join("cameras.txt"))
            .contains("not where they are, expected images.txt beside it")
    );
    fs::write(folder.join("images.txt"), COLMAP_IMAGES).unwrap();
    for name in ["cameras.txt", "images.txt", "", "../.."] {
        let opened = read(&folder.join(name), DAffine3::IDENTITY).unwrap();
        assert_eq!(opened.cameras.len(), 2, "{name}");
    }
}

#[test]
fn what_transforms_leave_open_is_taken_and_said() {
    let frame = r#""frames": [{"file_path": "./r_0", "transform_matrix":
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 2]]}]"#;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("transforms_train.json");
    fs::write(&path, format!(r#"{{"camera_angle_x": 1.0, {frame}}}"#)).unwrap();
    let opened = || read(&path, DAffine3::IDENTITY).unwrap();
    let synthetic = opened();
    assert_eq!(synthetic.cameras[0].size, [800, 800]);
    let focal = 400.0 / 0.5_f64.tan();
    assert!((synthetic.cameras[0].focal.x - focal).abs() < 1e-9);
    assert_eq!(synthetic.assumptions[0].what, "size of the images");
    // The header of a PNG of 640 × 360.
    let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec();
    png.extend([0, 0, 2, 128, 0, 0, 1, 104]);
    fs::write(folder.path().join("r_0.png"), png).unwrap();
    assert_eq!(opened().cameras[0].size, [640, 360]);
    assert_eq!(opened().assumptions, []);

    let of = |fields: &str| read_text("t.json", &format!("{{{fields}, {frame}}}")).unwrap();
    let centred = of(r#""fl_x": 100, "cx": 50.5, "cy": 30, "is_fisheye": false"#);
    assert_eq!(centred.cameras[0].size, [101, 60]);
    assert_eq!(centred.cameras[0].focal, DVec2::splat(100.0));
    assert_eq!(centred.cameras[0].center, DVec2::new(50.5, 30.0));
    let turned = r#""applied_transform": [[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, -1, 0]]"#;
    let turned = of(&format!(r#""w": 8, "h": 8, "fl_x": 9, {turned}"#));
    assert_eq!(turned.assumptions[0].what, "axes");
    let own = r#"{"w": 8, "h": 8, "fl_x": 9, "frames": [{"w": 6, "fl_x": 5, "transform_matrix":
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 2]]}]}"#;
    let own = read_text("t.json", own).unwrap().cameras[0];
    assert_eq!((own.size, own.focal.x), ([6, 8], 5.0));
}

#[test]
fn what_is_no_pinhole_or_no_camera_is_named() {
    let changed =
        |from: &str, to: &str| read_text("t.json", &TRANSFORMS.replace(from, to)).unwrap_err();
    let colmap = |from: &str, to: &str| {
        let [cameras, images] = [COLMAP_CAMERAS, COLMAP_IMAGES].map(|text| text.replace(from, to));
        read_colmap(&cameras, &images).unwrap_err()
    };
    let cases = [
        (
            changed("OPENCV", "OPENCV_FISHEYE"),
            "found the camera model OPENCV_FISHEYE at camera 0",
        ),
        (
            changed("\"k2\": 0", "\"is_fisheye\": true"),
            "found the camera model fisheye",
        ),
        (
            changed("[0, 0, -1, -2.2], [0", "[0"),
            "found the matrix [[0.0",
        ),
        (
            changed("[0, 0, -1, -2.2]", "[0, 0, -2, -2.2]"),
            "found the matrix",
        ),
        (
            changed("192.0", "192.5"),
            "found an image of 192.5 × 160 px",
        ),
        (
            changed("\"fl_x\": 230, \"fl_y\": 240,", ""),
            "found no focal length at camera 0",
        ),
        (
            changed("\"frames\"", "\"shots\""),
            "found a JSON object of `camera_model`, `cx`",
        ),
        (changed("-2.2", "1e999"), "found number out of range"),
        (
            colmap("7 OPENCV", "7 FOV"),
            "found a camera of the model FOV",
        ),
        (colmap("7 OPENCV", "7 LENS"), "found `7 LENS 192"),
        (
            colmap("7 OPENCV", "8 OPENCV"),
            "found camera 7 of the image `a.jpg`, expected one of cameras.txt: 8",
        ),
        (colmap("230", "x"), "found `7 OPENCV 192 160 x"),
        (colmap("0.70710678118654757", "0"), "found `3 0 0 0 0"),
        (colmap("9 0.7", "nine and"), "found `nine and"),
        (
            read_colmap(COLMAP_CAMERAS, "# none\n").unwrap_err(),
            "found 0 cameras",
        ),
        (
            read_text("x.txt", "hello world").unwrap_err(),
            "found other text, expected cameras.json as 3DGS",
        ),
        (
            read_text("x.json", "").unwrap_err(),
            "found other text, expected cameras.json as 3DGS",
        ),
    ];
    for (error, expected) in cases {
        assert!(error.contains(expected), "{error}\n  has no {expected}");
    }
}
