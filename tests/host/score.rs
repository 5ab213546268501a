//! Avatars and pictures scored against a capture: one whose truth is the avatar itself.

use crate::common::{self, Sizes};
use effigy_capture::{
    Capture, CaptureCamera, CaptureFrame, CaptureWriter, Picture, Template, VertexInfluence,
};
use effigy_core::{
    avatar::{Avatar, Pose},
    reference,
    scene::{AvatarBounds, Camera, FrameImage, Orbit, Posed},
};
use effigy_learn::score::{
    Ground, PictureIndex, Region, ScoreReport, ScoredImages, Scorer, ViewChoice, ViewScore, choose,
};
use effigy_perceptual::{Network, Perceptual};
use glam::DVec3;
use std::path::Path;

const SIZE: [u32; 2] = [240, 320];

fn avatar() -> Avatar {
    common::avatar(
        3,
        Sizes {
            gaussians: 2000,
            parts: 8,
            nodes: 60,
            rows: 100,
            expression: 0,
            // No further ones, some of which are called fingers and hang on the head.
            joints: 25,
            ..Sizes::default()
        },
    )
}

/// A box around each joint.
fn template(avatar: &Avatar) -> Template {
    let mut template = Template {
        skeleton: avatar.skeleton.clone(),
        vertices: vec![],
        triangles: vec![],
        weights: vec![],
        input_joints: avatar.inputs.joint.clone(),
        head_joints: vec![],
        expression: 0,
    };
    for (joint, rest) in avatar.skeleton.rest.iter().enumerate() {
        let first = template.vertices.len() as u32;
        for corner in 0..8 {
            let side = |bit: u32| if corner >> bit & 1 == 1 { 0.06 } else { -0.06 };
            let at = DVec3::from(rest.map(f64::from));
            template
                .vertices
                .push(at + DVec3::new(side(0), side(1), side(2)));
            template.weights.push(vec![VertexInfluence {
                joint: joint as u8,
                weight: 1.0,
            }]);
        }
        for [a, b, c, d] in [
            [4, 5, 7, 6],
            [1, 0, 2, 3],
            [5, 1, 3, 7],
            [0, 4, 6, 2],
            [6, 7, 3, 2],
            [0, 1, 5, 4],
        ] {
            for triangle in [[a, b, c], [a, c, d]] {
                template
                    .triangles
                    .push(triangle.map(|corner: u32| first + corner));
            }
        }
    }
    template
}

fn poses(avatar: &Avatar) -> Vec<Pose> {
    let rest = Pose::rest(avatar.skeleton.len(), 0);
    let mut bent = rest.clone();
    bent.rotation[16] = DVec3::new(0.0, 0.3, 0.4);
    bent.translation = DVec3::new(0.05, 0.0, 0.0);
    vec![rest, bent]
}

fn drawn(avatar: &Avatar, pose: &Pose, camera: &Camera) -> FrameImage {
    reference::render(avatar, &Posed::new(avatar, pose), camera)
}

/// Two cameras and two frames, one of each held out; the truth is the avatar over a shaded ground.
fn write(folder: &Path, avatar: &Avatar) -> Capture {
    let template = template(avatar);
    let poses = poses(avatar);
    let posed = Posed::new(avatar, &poses[0]);
    let framing = AvatarBounds::new(avatar).framing(&posed.joints);
    let cameras = [0.2, 1.0].map(|yaw| CaptureCamera {
        name: format!("cam{:02}", (10.0 * yaw) as u32),
        camera: Camera::around(
            framing,
            Orbit {
                yaw,
                pitch: 0.1,
                fov: 0.6,
            },
            SIZE,
        ),
        distortion: [0.0; 5],
        held: yaw > 0.5,
    });
    let writer = CaptureWriter::new(folder, &cameras, &template).expect("a folder");
    for (camera, own) in cameras.iter().enumerate() {
        for (frame, pose) in poses.iter().enumerate() {
            let image = drawn(avatar, pose, &own.camera);
            let pixel = |at: usize| {
                let [r, g, b, alpha] = image.pixels[at];
                let ground = 0.1 + 0.3 * (at as u32 / SIZE[0]) as f32 / SIZE[1] as f32;
                let byte = |own: f32| ((own + (1.0 - alpha) * ground) * 255.0).round() as u8;
                ([r, g, b].map(byte), if alpha > 0.5 { 255 } else { 0 })
            };
            let pixels: Vec<_> = (0..image.pixels.len()).map(pixel).collect();
            let picture = Picture {
                size: SIZE,
                color: pixels.iter().map(|pixel| pixel.0).collect(),
                mask: pixels.iter().map(|pixel| pixel.1).collect(),
            };
            writer
                .write(camera, frame as u32, &picture)
                .expect("a picture");
        }
    }
    let frames = poses
        .into_iter()
        .enumerate()
        .map(|(number, pose)| CaptureFrame {
            number: number as u32,
            pose,
            held: number == 1,
        });
    writer
        .finish(&frames.collect::<Vec<_>>())
        .expect("a capture");
    Capture::read(folder).expect("what was written")
}

fn scores(scorer: &Scorer) -> Vec<ViewScore> {
    let choice = ViewChoice {
        cameras: 9,
        frames: 9,
        training: true,
    };
    let views = choose(scorer.capture, &choice);
    let score = |view: &PictureIndex| {
        let compared = scorer.compare(*view).expect("both pictures");
        scorer.named(*view, &compared.expect("a mask"))
    };
    views.iter().map(score).collect()
}

fn the_truth_itself_scores_high_and_a_changed_avatar_lower() {
    let folder = tempfile::tempdir().expect("a folder");
    let avatar = avatar();
    let capture = write(folder.path(), &avatar);
    let perceptual = Perceptual::random(Network::Alex, 1);
    let score = |avatar: &Avatar, ground| {
        let candidate = ScoredImages::Avatar(avatar);
        scores(&Scorer::new(&capture, candidate, ground, Some(&perceptual)))
    };
    let own = score(&avatar, Ground::Truth);
    let names: Vec<&str> = own.iter().map(|view| view.group).collect();
    assert_eq!(
        names,
        [
            "training",
            "held-out poses",
            "held-out cameras",
            "held-out cameras and poses"
        ]
    );
    for view in &own {
        let whole = view.whole;
        println!("{}: {whole:?}", view.group);
        assert!(whole.psnr_db > 40.0 && whole.ssim > 0.99, "{whole:?}");
        assert!(
            whole.st_lpips.is_some_and(|d| (0.0..0.05).contains(&d)),
            "{whole:?}"
        );
        assert!(
            view.regions.contains_key(&Region::Rest),
            "{:?}",
            view.regions.keys()
        );
    }
    // The head alone is another: its region falls, the hands' doesn't.
    let mut faceless = avatar.clone();
    let head = avatar
        .skeleton
        .name
        .iter()
        .position(|name| name == "head")
        .expect("a head") as u8;
    for (k, joints) in avatar.gaussians.joint.iter().enumerate() {
        if joints[0] == head {
            faceless.gaussians.color[k] = avatar.gaussians.color[k].map(|_| Default::default());
        }
    }
    let other = score(&faceless, Ground::Truth);
    let of = |views: &[ViewScore], region: Region| {
        let found = views[0].regions.get(&region);
        found
            .unwrap_or_else(|| panic!("{region:?}: {:?}", views[0].regions.keys()))
            .psnr_db
    };
    assert!(of(&other, Region::Face) < of(&own, Region::Face) - 10.0);
    assert!((of(&other, Region::Hands) - of(&own, Region::Hands)).abs() < 0.5);
    // One colour under both: the mask is hard, the avatar's edge is not.
    let grey = score(&avatar, Ground::Color([0.5; 3]));
    assert!(grey[0].whole.psnr_db > 20.0 && grey[0].whole.psnr_db < own[0].whole.psnr_db);
    let protocol =
        Scorer::new(&capture, ScoredImages::Avatar(&avatar), Ground::Truth, None).protocol();
    let report = ScoreReport::new(protocol, other);
    assert_eq!(report.groups.len(), 4);
    assert_eq!(report.protocol.poses, "as given");
    assert!(serde_json::to_string(&report).is_ok());
}

fn pictures_of_another_program_score_as_the_avatar_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let avatar = avatar();
    let capture = write(&folder.path().join("capture"), &avatar);
    let pictures = folder.path().join("pictures");
    for camera in &capture.cameras {
        std::fs::create_dir_all(pictures.join(&camera.name)).expect("a folder");
        for frame in &capture.frames {
            let image = drawn(&avatar, &frame.pose, &camera.camera);
            let mut pixels = image::RgbaImage::new(SIZE[0], SIZE[1]);
            for (pixel, [r, g, b, alpha]) in pixels.pixels_mut().zip(image.pixels) {
                let straight = [r, g, b].map(|c| c / alpha.max(1e-6));
                let byte = |c: f32| (255.0 * c.clamp(0.0, 1.0)).round() as u8;
                let [r, g, b] = straight.map(byte);
                *pixel = image::Rgba([r, g, b, byte(alpha)]);
            }
            let file = pictures
                .join(&camera.name)
                .join(format!("{:08}.png", frame.number));
            pixels.save(file).expect("a picture");
        }
    }
    let own = scores(&Scorer::new(
        &capture,
        ScoredImages::Avatar(&avatar),
        Ground::Truth,
        None,
    ));
    let scorer = Scorer::new(
        &capture,
        ScoredImages::Pictures(&pictures),
        Ground::Truth,
        None,
    );
    for (a, b) in own.iter().zip(scores(&scorer)) {
        assert!((a.whole.ssim - b.whole.ssim).abs() < 0.005, "{a:?} {b:?}");
        assert!(b.whole.psnr_db > 38.0, "{b:?}");
    }
    // One is of another size, one is missing, one has no alpha.
    let view = PictureIndex {
        camera: 0,
        frame: 0,
    };
    let file = pictures.join("cam02/00000000.png");
    let error = |scorer: &Scorer| scorer.compare(view).expect_err("no picture").to_string();
    image::RgbaImage::new(10, 12)
        .save(&file)
        .expect("a picture");
    assert!(error(&scorer).contains("found 10 x 12 px, expected the capture's 240 x 320"));
    image::RgbImage::new(SIZE[0], SIZE[1])
        .save(&file)
        .expect("a picture");
    assert!(
        error(&scorer).contains("without alpha"),
        "{}",
        error(&scorer)
    );
    let over = Ground::Color([0.0; 3]);
    let opaque = Scorer::new(&capture, ScoredImages::Pictures(&pictures), over, None);
    assert!(opaque.compare(view).is_ok());
    std::fs::remove_file(&file).expect("it is there");
    assert!(error(&scorer).contains("cannot read"));
}

/// Runs `effigy evaluate` and returns what it printed.
fn evaluate(arguments: &[&str]) -> String {
    let output = std::process::Command::new(common::program())
        .arg("evaluate")
        .args(arguments)
        .env("EFFIGY_ASSETS", "/nowhere")
        .output()
        .expect("the program runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{text}{error}");
    text + &error
}

fn the_command_prints_the_protocol_and_writes_numbers_and_images() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let avatar = avatar();
    write(&folder.path().join("capture"), &avatar);
    let file = path("body.avatar");
    avatar
        .write(file.as_ref())
        .expect("an avatar can be written");
    let (capture, json, images) = (path("capture"), path("scores.json"), path("images"));
    let text = evaluate(&[
        &file,
        &capture,
        "--json",
        &json,
        "--images",
        &images,
        "--video",
        &path("video.png"),
        "--training",
    ]);
    for expected in [
        "poses as given",
        "held-out cameras and poses",
        "face",
        "without ST-LPIPS",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
    let video = std::fs::File::open(path("video.png")).expect("a video");
    let decoder = png::Decoder::new(std::io::BufReader::new(video));
    let reader = decoder.read_info().expect("a PNG");
    let frames = reader.info().animation_control().expect("animated");
    assert_eq!(frames.num_frames, 2);
    let json = std::fs::read_to_string(json).expect("numbers");
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["groups"].as_array().map(Vec::len), Some(4));
    assert_eq!(json["protocol"]["poses"], "as given");
    assert!(json["views"][0]["whole"]["psnr_db"].as_f64() > Some(40.0));
    assert_eq!(std::fs::read_dir(images).expect("images").count(), 4);
    // Pictures that are not there are said and left out, and all of them are an error.
    let output = std::process::Command::new(common::program())
        .args([
            "evaluate",
            "--pictures",
            &path("none"),
            &capture,
            "--perceptual",
            "none",
        ])
        .output()
        .expect("the program runs");
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(
        !output.status.success() && error.contains("no picture could be compared"),
        "{error}"
    );
}

tests! {
    the_truth_itself_scores_high_and_a_changed_avatar_lower,
    pictures_of_another_program_score_as_the_avatar_does,
    the_command_prints_the_protocol_and_writes_numbers_and_images,
}
