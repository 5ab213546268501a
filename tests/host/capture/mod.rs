//! Captures: one that `tests/data/capture/make.py` wrote, which knows nothing of Effigy, and one of
//! the baked person.

pub mod hostile;
pub mod masks;
pub mod wrong;

use crate::common;
use effigy_capture::{Capture, CaptureFrame, Truth};
use effigy_core::avatar::Pose;
use effigy_learn::{
    bake::{self, Assets, Person},
    pictures::{Flaws, PictureOptions, shoot},
};
use glam::{DVec2, DVec3};
use serde::Deserialize;
use std::{fs, path::Path, process::Command};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/capture");
/// Joints that the pictures show in red, green and blue.
const SHOWN: [usize; 3] = [15, 20, 21];

/// A frame as NumPy computed it.
#[derive(Deserialize)]
struct Shown {
    joints: Vec<[f64; 3]>,
    vertices: Vec<[f64; 3]>,
}

/// Copies a folder's capture, file by file.
fn copied(to: &Path, place: impl Fn(&str) -> String) {
    for below in [
        "",
        "images/cam00",
        "images/cam01",
        "masks/cam00",
        "masks/cam01",
    ] {
        for entry in fs::read_dir(Path::new(FOLDER).join(below)).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() {
                let name = path.strip_prefix(FOLDER).unwrap().to_str().unwrap();
                let target = to.join(place(name));
                fs::create_dir_all(target.parent().unwrap()).unwrap();
                fs::copy(&path, target).unwrap();
            }
        }
    }
}

/// Joints and vertices of SMPL-X's arrays are where its own equations put them.
fn smpl_xs_parameters_are_read_as_smpl_x_means_them() {
    let capture = Capture::read(FOLDER.as_ref()).unwrap();
    assert_eq!((capture.cameras.len(), capture.frames.len()), (2, 3));
    assert_eq!(capture.left_out, []);
    let template = &capture.template;
    assert_eq!(template.expression, 10);
    assert_eq!(template.input_joints, (1..22).collect::<Vec<u8>>());
    assert_eq!(template.head_joints, [15, 22, 23, 24]);
    assert_eq!(template.skeleton.name[17], "RightArm");
    assert!((template.skeleton.canonical[1][2].to_degrees() - 25.0).abs() < 1e-4);
    let shown: Vec<Shown> =
        serde_json::from_slice(&fs::read(Path::new(FOLDER).join("shown.json")).unwrap()).unwrap();
    for (frame, shown) in capture.frames.iter().zip(&shown) {
        let joints = template.skeleton.joints(&frame.pose);
        for (joint, expected) in joints.iter().zip(&shown.joints) {
            let off = joint.translation.distance(DVec3::from(*expected));
            assert!(off < 1e-5, "{off}");
        }
        for (vertex, expected) in template.posed(&frame.pose).iter().zip(&shown.vertices) {
            let off = vertex.distance(DVec3::from(*expected));
            assert!(off < 1e-5, "{off}");
        }
    }
}

/// Dots that OpenCV put where lenses show joints are where the pinhole cameras see them.
fn pictures_are_undistorted_to_where_cameras_see_joints() {
    let capture = Capture::read(FOLDER.as_ref()).unwrap();
    let mut compared = 0;
    for (at, camera) in capture.cameras.iter().enumerate() {
        for (number, frame) in capture.frames.iter().enumerate() {
            let picture = capture.picture(at, number).unwrap();
            let joints = capture.template.skeleton.joints(&frame.pose);
            for (channel, joint) in SHOWN.into_iter().enumerate() {
                let seen = camera
                    .camera
                    .view
                    .transform_point3(joints[joint].translation);
                let place = camera.camera.project(seen);
                let width = picture.size[0] as usize;
                let mut sum = DVec2::ZERO;
                let mut weight = 0.0;
                for (k, color) in picture.color.iter().enumerate() {
                    let pixel = DVec2::new((k % width) as f64, (k / width) as f64) + 0.5;
                    let light = f64::from(color[channel]);
                    sum += light * pixel;
                    weight += light;
                }
                // Dots that the picture's edge cuts have no middle.
                let size = DVec2::from(picture.size.map(f64::from));
                if place.min_element() > 8.0 && (size - place).min_element() > 8.0 {
                    let off = (sum / weight).distance(place);
                    assert!(off < 0.15, "camera {at}, frame {number}: {off} px");
                    let pixel = place.y as usize * width + place.x as usize;
                    assert_eq!(picture.mask[pixel], 255);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared >= 12, "{compared} dots");
    assert_eq!(capture.check(&|_, _| {}), []);
}

/// The same files by AvatarReX's names, sizes left out of the calibration.
fn avatarrexs_names_are_known() {
    let folder = tempfile::tempdir().unwrap();
    copied(folder.path(), |name| {
        let name = name.replace("calibration.json", "calibration_full.json");
        match name.split('/').collect::<Vec<_>>()[..] {
            ["images", camera, file] => format!("{camera}/{file}"),
            ["masks", camera, file] => format!("{camera}/mask/pha/{file}"),
            _ => name,
        }
    });
    let file = folder.path().join("calibration_full.json");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replace(", \"imgSize\": [96, 80]", "")).unwrap();
    fs::write(
        folder.path().join("missing_img_files.txt"),
        "cam01\\00000001.png\r\n",
    )
    .unwrap();
    let capture = Capture::read(folder.path()).unwrap();
    assert_eq!(capture.cameras[1].camera.size, [96, 80]);
    assert_eq!((capture.pictures(), capture.left_out.len()), (5, 1));
    assert!(!capture.has(1, 1));
    let own = Capture::read(FOLDER.as_ref()).unwrap();
    assert_eq!(capture.picture(1, 2).unwrap(), own.picture(1, 2).unwrap());
}

/// Two frames of the second person, small.
fn person(folder: &Path, flaws: Flaws) -> Capture {
    shot(folder, flaws, 0)
}

/// [`person`] with more cameras, near the head.
fn shot(folder: &Path, flaws: Flaws, close: usize) -> Capture {
    let clothed = bake::clothed(&Assets::new(common::assets()), Person::ALL[1]).unwrap();
    let joints = clothed.body.skeleton.len();
    let frame = |number: u32| {
        let mut pose = Pose::rest(joints, 10);
        pose.rotation[0] = DVec3::new(0.2, f64::from(number), -0.1);
        pose.rotation[1] = DVec3::new(-0.7, 0.0, 0.0);
        pose.rotation[4] = DVec3::new(0.9, 0.0, 0.0);
        pose.rotation[16] = DVec3::new(0.0, 0.3, -0.6);
        pose.translation = DVec3::new(0.3, 0.05, -0.2);
        pose.expression[0] = 0.5;
        CaptureFrame {
            number,
            pose,
            held: number == 1,
        }
    };
    let options = PictureOptions {
        cameras: 4,
        close,
        size: [128, 128],
        samples: 2,
        rays: 24,
        flaws,
        seed: 3,
    };
    let frames = [frame(0), frame(1)];
    shoot(folder, clothed, &frames, &options, &|| ()).unwrap();
    Capture::read(folder).unwrap()
}

/// The share of the posed body model's vertices that are inside the masks or within 2 px of them.
fn inside(capture: &Capture) -> f64 {
    let mut inside = 0.0;
    let mut all = 0.0;
    for (number, frame) in capture.frames.iter().enumerate() {
        let vertices = capture.template.posed(&frame.pose);
        for (at, camera) in capture.cameras.iter().enumerate() {
            let picture = capture.picture(at, number).unwrap();
            let [width, height] = picture.size.map(|side| side as i64);
            for vertex in &vertices {
                let seen = camera.camera.view.transform_point3(*vertex);
                let place = camera.camera.project(seen).floor().as_i64vec2();
                let near = |dx: i64, dy: i64| {
                    let (x, y) = (place.x + dx, place.y + dy);
                    let within = (0..width).contains(&x) && (0..height).contains(&y);
                    within && picture.mask[(y * width + x) as usize] == 255
                };
                let hit = (-2..=2).any(|dy| (-2..=2).any(|dx| near(dx, dy)));
                inside += f64::from(u8::from(hit));
                all += 1.0;
            }
        }
    }
    inside / all
}

fn the_baked_persons_poses_cameras_and_pictures_agree() {
    let folder = tempfile::tempdir().unwrap();
    let capture = person(folder.path(), Flaws::default());
    assert_eq!(capture.left_out, []);
    assert_eq!(capture.check(&|_, _| {}), []);
    assert!(inside(&capture) > 0.995, "{}", inside(&capture));
    let held = [capture.frames[0].held, capture.frames[1].held];
    assert_eq!(held, [false, true]);
    assert!(Truth::read(folder.path()).unwrap().is_none());
    // The person fills the picture, and is not all of it.
    for camera in 0..4 {
        let picture = capture.picture(camera, 0).unwrap();
        let covered = picture.mask.iter().filter(|&&part| part > 0).count();
        assert!((800..6000).contains(&covered), "{covered} pixels");
    }
    // Neither threads nor an earlier capture in the folder change a byte.
    let again = tempfile::tempdir().unwrap();
    fs::create_dir_all(again.path().join("images/cam00")).unwrap();
    fs::write(again.path().join("images/cam00/00000009.png"), "old").unwrap();
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    one.install(|| person(again.path(), Flaws::default()));
    for name in [
        "images/cam03/00000001.png",
        "masks/cam02/00000000.png",
        "calibration.json",
    ] {
        let read = |folder: &Path| fs::read(folder.join(name)).unwrap();
        assert!(read(folder.path()) == read(again.path()), "{name} differs");
    }
    assert!(!again.path().join("images/cam00/00000009.png").exists());
}

/// Cameras near the head see it whole in every frame, and larger than the others do, which stay
/// what they are without them.
fn close_cameras_see_head_and_chest() {
    const HEAD: u8 = 15;
    let folders = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let without = person(folders[0].path(), Flaws::default());
    let capture = shot(folders[1].path(), Flaws::default(), 3);
    assert_eq!((without.cameras.len(), capture.cameras.len()), (4, 7));
    assert_eq!(capture.check(&|_, _| {}), []);
    assert_eq!(
        capture.picture(2, 0).unwrap(),
        without.picture(2, 0).unwrap()
    );
    let template = &capture.template;
    let head: Vec<usize> = (0..template.vertices.len())
        .filter(|&v| {
            let mut own = template.weights[v].iter();
            own.any(|influence| influence.joint == HEAD && influence.weight > 0.9)
        })
        .collect();
    for frame in &capture.frames {
        let vertices = template.posed(&frame.pose);
        let heights = capture.cameras.iter().map(|own| {
            let camera = &own.camera;
            let seen = head.iter().map(|&v| {
                let at = camera.view.transform_point3(vertices[v]);
                camera.project(at) / 128.0
            });
            let (low, high) = seen.fold((DVec2::MAX, DVec2::MIN), |(low, high), at| {
                (low.min(at), high.max(at))
            });
            assert!(low.min_element() > 0.0 && high.max_element() < 1.0);
            high.y - low.y
        });
        let heights: Vec<f64> = heights.collect();
        let far = heights[..4].iter().copied().fold(0.0, f64::max);
        let near = heights[4..].iter().copied().fold(1.0, f64::min);
        assert!(near > 1.5 * far, "{near} of the picture, {far} from afar");
    }
}

fn captures_with_flaws_keep_the_truth_apart() {
    let folder = tempfile::tempdir().unwrap();
    let capture = person(folder.path(), Flaws::CAPTURED);
    assert_eq!(capture.check(&|_, _| {}), []);
    let truth = Truth::read(folder.path()).unwrap().expect("a truth");
    let given = inside(&capture);
    let mut true_capture = capture.clone();
    for (frame, pose) in true_capture.frames.iter_mut().zip(&truth.poses) {
        assert!(frame.pose.rotation[3].distance(pose.rotation[3]) > 1e-4);
        frame.pose = pose.clone();
    }
    for (camera, own) in true_capture.cameras.iter_mut().zip(&truth.cameras) {
        assert!(camera.camera.center.distance(own.camera.camera.center) > 1e-3);
        assert!(own.gain.iter().all(|gain| (0.5..2.0).contains(gain)));
        camera.camera = own.camera.camera;
    }
    let known = inside(&true_capture);
    assert!(
        given < known && known > 0.97,
        "{given} as given, {known} in truth"
    );
}

/// What a capture has, before anybody trains for a night: also what of it is no use, by file.
fn inspect_says_what_a_capture_has() {
    let folder = tempfile::tempdir().unwrap();
    copied(folder.path(), str::to_owned);
    fs::remove_file(folder.path().join("masks/cam01/00000002.jpg")).unwrap();
    fs::write(
        folder.path().join("split.json"),
        r#"{"cameras": ["cam01"], "frames": [1]}"#,
    )
    .unwrap();
    let inspect = |arguments: &[&str]| {
        let output = Command::new(common::program())
            .arg("inspect")
            .arg(folder.path())
            .args(arguments)
            .output()
            .unwrap();
        let text = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        (output.status.success(), text.concat())
    };
    let (is_good, text) = inspect(&["--json"]);
    assert!(is_good, "{text}");
    let found: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(
        [&found["pictures"], &found["learned"], &found["held_frames"]],
        [5, 2, 1]
    );
    assert_eq!(found["held_cameras"], serde_json::json!(["cam01"]));
    assert_eq!(found["left_out"]["missing"], 1);
    let (is_good, text) = inspect(&[]);
    assert!(is_good && text.contains("1 × missing"), "{text}");
    assert!(
        text.contains("00000002") && text.contains("cam01"),
        "{text}"
    );
    let (is_good, text) = inspect(&["--png", "a.png"]);
    assert!(!is_good && text.contains("--png"), "{text}");
    let template = folder.path().join("template.npz");
    let elsewhere = tempfile::tempdir().unwrap();
    let moved = elsewhere.path().join("body.npz");
    fs::rename(&template, &moved).unwrap();
    // The parameters of poses are motion: a folder of files, then.
    let (_, text) = inspect(&[]);
    assert!(text.contains("template.npz"), "{text}");
    let (is_good, text) = inspect(&["--template", moved.to_str().unwrap()]);
    assert!(is_good && text.contains("1 × missing"), "{text}");
}

tests! {
    inspect_says_what_a_capture_has,
    smpl_xs_parameters_are_read_as_smpl_x_means_them,
    pictures_are_undistorted_to_where_cameras_see_joints,
    avatarrexs_names_are_known,
    the_baked_persons_poses_cameras_and_pictures_agree,
    close_cameras_see_head_and_chest,
    captures_with_flaws_keep_the_truth_apart,
}
