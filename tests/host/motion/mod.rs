//! Motion of other bodies: `tests/data/motion/make.py`, which knows nothing of Effigy, wrote one walk
//! in the conventions of several rigs, and where its joints are.

pub mod axes;
pub mod hostile;
pub mod limbs;

use effigy_core::avatar::{Avatar, Clip, Pose, Skeleton};
use effigy_formats::{
    bvh,
    capture::{Capture, CaptureJoint, Captured, LocalPose, UpAxis},
    retarget::{self, ArmsInside, Basis, Correction, Girth, RetargetOptions, Retargeted},
};
use glam::{DQuat, DVec3};
use serde::Deserialize;

pub const WILD: &[u8] = include_bytes!("../../data/motion/poser_wild.bvh");
const MIXAMO: &[u8] = include_bytes!("../../data/motion/mixamo.bvh");
const LAFAN: &[u8] = include_bytes!("../../data/motion/lafan.bvh");
const BANDAI: &[u8] = include_bytes!("../../data/motion/bandai.bvh");
const NAMELESS: &[u8] = include_bytes!("../../data/motion/nameless.bvh");

/// A rig's file, and how its axes and unit are to be read.
struct Rig {
    name: &'static str,
    bytes: &'static [u8],
    basis: Basis,
    /// The file's axis that points up.
    up: DVec3,
    /// Metres a unit.
    unit: f64,
}

const fn rig(name: &'static str, bytes: &'static [u8], basis: Basis, up: DVec3, unit: f64) -> Rig {
    Rig {
        name,
        bytes,
        basis,
        up,
        unit,
    }
}

const RIGS: [Rig; 5] = [
    rig("mixamo", MIXAMO, Basis::Rest, DVec3::Y, 0.01),
    rig("poser", WILD, Basis::Rest, DVec3::Y, 0.0254 / 0.45),
    rig("lafan", LAFAN, Basis::Motion, DVec3::Y, 0.01),
    rig("bandai", BANDAI, Basis::Motion, DVec3::Y, 0.01),
    rig("nameless", NAMELESS, Basis::Rest, DVec3::Z, 0.001),
];

/// What the files show.
#[derive(Deserialize)]
struct Shown {
    joints: Vec<String>,
    /// Places a frame; metres, y up.
    at: Vec<Vec<[f64; 3]>>,
}

impl Shown {
    fn read() -> Self {
        let text = include_str!("../../data/motion/shown.json");
        serde_json::from_str(text).unwrap()
    }

    fn at(&self, frame: usize, joint: &str) -> DVec3 {
        let place = self.joints.iter().position(|own| own == joint).unwrap();
        DVec3::from(self.at[frame][place])
    }
}

/// Bones of make.py's body from joint to joint, and the same of Effigy's rigs.
const BONES: [[&str; 4]; 8] = [
    ["left upper arm", "left forearm", "LeftArm", "LeftForeArm"],
    [
        "right upper arm",
        "right forearm",
        "RightArm",
        "RightForeArm",
    ],
    ["left forearm", "left hand", "LeftForeArm", "LeftHand"],
    ["right forearm", "right hand", "RightForeArm", "RightHand"],
    ["left thigh", "left shin", "LeftUpLeg", "LeftLeg"],
    ["right thigh", "right shin", "RightUpLeg", "RightLeg"],
    ["left shin", "left foot", "LeftLeg", "LeftFoot"],
    ["right shin", "right foot", "RightLeg", "RightFoot"],
];

fn demo() -> Avatar {
    effigy_demo::avatar().unwrap()
}

fn read(bytes: &[u8]) -> Captured {
    bvh::from_bytes(bytes).unwrap()
}

fn made(bytes: &[u8], options: &RetargetOptions) -> Retargeted {
    retarget::retarget(&read(bytes).capture, &demo().skeleton, "walk", options).unwrap()
}

fn keep_feet() -> RetargetOptions {
    RetargetOptions {
        keep_feet: true,
        ..RetargetOptions::default()
    }
}

fn place(skeleton: &Skeleton, pose: &Pose, joint: &str) -> DVec3 {
    let index = skeleton.name.iter().position(|name| name == joint).unwrap();
    skeleton.joints(pose)[index].translation
}

fn every_rig_shows_what_numpy_shows() {
    let shown = Shown::read();
    for rig in RIGS {
        let Captured { capture, .. } = read(rig.bytes);
        assert_eq!(capture.frames(), shown.at.len(), "{}", rig.name);
        let joints = capture.joints.iter().map(|joint| &joint.name);
        // The order of joints in the files is that of a walk down the tree: compare by place.
        let mut furthest = 0.0_f64;
        for frame in 0..capture.frames() {
            let to_y_up = if rig.up == DVec3::Z {
                DQuat::from_mat3(&glam::DMat3::from_cols(-DVec3::X, DVec3::Z, DVec3::Y))
            } else {
                DQuat::IDENTITY
            };
            for at in capture.world(frame) {
                let own = to_y_up * at.translation * rig.unit;
                let near = shown.at[frame].iter().map(|at| own.distance((*at).into()));
                furthest = furthest.max(near.fold(f64::INFINITY, f64::min));
            }
        }
        // Four decimals of a degree and of the unit.
        assert!(furthest < 2e-5, "{}: {furthest} m", rig.name);
        assert_eq!(joints.count(), shown.joints.len());
    }
}

fn bones_point_where_the_captures_do() {
    let shown = Shown::read();
    let skeleton = demo().skeleton;
    for rig in RIGS {
        let Retargeted { clip, report, .. } = made(rig.bytes, &keep_feet());
        assert_eq!(report.basis, rig.basis, "{}", rig.name);
        assert_eq!(report.up, rig.up, "{}", rig.name);
        assert!((report.unit.metres / rig.unit - 1.0).abs() < 1e-9);
        assert_eq!(clip.frames(), shown.at.len());
        let worst = worst_bone(&shown, &skeleton, &clip, rig.up == DVec3::Z);
        assert!(worst.degrees < 0.1, "{}: {worst:?}", rig.name);
    }
}

/// A bone of a clip that is far from what the files show.
#[derive(Clone, Copy, Debug)]
#[expect(dead_code, reason = "a failed test prints all of it")]
struct Worst {
    degrees: f64,
    frame: usize,
    bone: &'static str,
}

/// The bone that is furthest from where the files show it. `z_up`: whether the file's axes are.
fn worst_bone(shown: &Shown, skeleton: &Skeleton, clip: &Clip, z_up: bool) -> Worst {
    let mut worst = Worst {
        degrees: 0.0,
        frame: 0,
        bone: "",
    };
    for frame in 0..clip.frames() {
        let pose = clip.frame(frame);
        for [from, to, own_from, own_to] in BONES {
            let way = shown.at(frame, to) - shown.at(frame, from);
            // The file's other horizontal axes are its own affair.
            let way = if z_up {
                DVec3::new(-way.x, way.y, -way.z)
            } else {
                way
            };
            let own = place(skeleton, &pose, own_to) - place(skeleton, &pose, own_from);
            let degrees = own.angle_between(way).to_degrees();
            if degrees > worst.degrees {
                worst = Worst {
                    degrees,
                    frame,
                    bone: own_from,
                };
            }
        }
    }
    worst
}

fn one_walk_moves_the_body_alike_whatever_the_rig() {
    let expected = made(MIXAMO, &keep_feet()).clip;
    // Rest poses give the same rotations. Without one, rotations about bones are taken from how
    // elbows and knees bend, and those of the trunk from where its bones point.
    for (name, bytes, most) in [
        ("poser", WILD, 1.0),
        ("lafan", LAFAN, 12.0),
        ("bandai", BANDAI, 12.0),
    ] {
        let clip = made(bytes, &keep_feet()).clip;
        let joints = clip.joint.len();
        for (at, (own, other)) in clip.rotation.iter().zip(&expected.rotation).enumerate() {
            let turn = |axis: &[f32; 3]| DQuat::from_scaled_axis(DVec3::from(axis.map(f64::from)));
            let off = turn(own).angle_between(turn(other)).to_degrees();
            let off = off.min(360.0 - off);
            let joint = &clip.joint[at % joints];
            assert!(off < most, "{name}: {joint} is turned by {off}° more");
        }
    }
}

fn a_clip_that_is_read_as_a_capture_comes_back() {
    let avatar = demo();
    let clip = effigy_demo::clip().unwrap();
    let skeleton = &avatar.skeleton;
    let capture = captured_clip(skeleton, &clip);
    let made = retarget::retarget(&capture, skeleton, "again", &keep_feet()).unwrap();
    assert_eq!(made.report.driven, driven(skeleton));
    let map = clip.map_to(skeleton);
    let mut fall = vec![];
    for frame in 0..clip.frames() {
        let [before, after] = [clip.frame(frame), made.clip.frame(frame)];
        for (joint, place) in map.iter().enumerate() {
            let expected = DQuat::from_scaled_axis(before.rotation[place.unwrap()]);
            let own = DQuat::from_scaled_axis(after.rotation[joint]);
            let off = expected.angle_between(own).to_degrees();
            let name = &skeleton.name[joint];
            // The head of a few frames is turned further than a head turns.
            let most = if matches!(name.as_str(), "Head" | "Neck") {
                20.0
            } else {
                1e-3
            };
            assert!(off.min(360.0 - off) < most, "frame {frame}: {name} {off}°");
        }
        fall.push(after.translation - before.translation);
    }
    // All frames are moved by one height, so that soles are on the ground.
    for moved in &fall {
        assert!(moved.distance(fall[0]) < 1e-5, "{moved} {}", fall[0]);
    }
}

/// Joints of a rig that a capture of the same rig moves.
fn driven(skeleton: &Skeleton) -> usize {
    let unknown = ["Eye"];
    let known = |name: &&String| !unknown.iter().any(|part| name.contains(part));
    skeleton.name.iter().filter(known).count()
}

fn captured_clip(skeleton: &Skeleton, clip: &Clip) -> Capture {
    let rest = |joint: usize| DVec3::from(skeleton.rest[joint].map(f64::from));
    let offset = |joint: usize| match skeleton.parent[joint] {
        Some(parent) => rest(joint) - rest(usize::from(parent)),
        None => rest(joint),
    };
    let joints = (0..skeleton.len()).map(|joint| CaptureJoint {
        name: skeleton.name[joint].clone(),
        parent: skeleton.parent[joint].map(usize::from),
        offset: offset(joint),
        rest: DQuat::IDENTITY,
    });
    let map = clip.map_to(skeleton);
    let local = (0..clip.frames()).flat_map(|frame| {
        let pose = clip.frame(frame);
        let map = &map;
        (0..skeleton.len())
            .map(|joint| {
                let moved = if joint == 0 {
                    pose.translation
                } else {
                    DVec3::ZERO
                };
                LocalPose {
                    rotation: DQuat::from_scaled_axis(pose.rotation[map[joint].unwrap()]).as_quat(),
                    offset: (offset(joint) + moved).as_vec3(),
                }
            })
            .collect::<Vec<_>>()
    });
    Capture {
        joints: joints.collect(),
        rate: clip.rate,
        local: local.collect(),
        unit: Some(1.0),
        up: UpAxis::Said(DVec3::Y),
        model_rest: false,
        expression: vec![],
        expression_len: 0,
    }
}

fn standing_feet_neither_slide_nor_sink() {
    for rig in RIGS {
        let Retargeted { clip, report, .. } = made(rig.bytes, &RetargetOptions::default());
        // Each foot stands, makes a step, and stands.
        assert_eq!(report.contacts, 4, "{}", rig.name);
        assert!((0.5..0.8).contains(&report.standing), "{}", report.standing);
        assert!(report.slide.max < 1e-3, "{}: {:?}", rig.name, report.slide);
        assert!(report.sink.max < 1e-3, "{}: {:?}", rig.name, report.sink);
        assert!(report.hips.max < 0.02, "{}: {:?}", rig.name, report.hips);
        assert!(report.directions.mean < 0.5, "{:?}", report.directions);
        let Captured { capture, .. } = read(rig.bytes);
        let again = retarget::compare(&clip, &capture, &demo().skeleton, &[]).unwrap();
        assert!((again.slide.max - report.slide.max).abs() < 1e-4);
        assert!((again.positions.mean - report.positions.mean).abs() < 1e-5);
    }
}

fn feet_that_are_kept_slide_on_another_body() {
    // The measure sees what the correction repairs: legs of the demo have other shares.
    let report = made(MIXAMO, &keep_feet()).report;
    assert!(report.slide.max > 5e-3, "{:?}", report.slide);
}

fn arms_stay_out_of_the_body_where_the_captures_do() {
    let avatar = demo();
    let skeleton = &avatar.skeleton;
    let index = |name: &str| skeleton.name.iter().position(|own| own == name).unwrap();
    let rest = |joint: usize| DVec3::from(skeleton.rest[joint].map(f64::from));
    // Arms hang towards the hips, from shoulders that are twice as wide.
    let mut clip = Clip::still(skeleton);
    for (side, x) in [("Left", 1.0), ("Right", -1.0)] {
        let [upper, forearm] = ["Arm", "ForeArm"].map(|name| index(&format!("{side}{name}")));
        let along = (rest(forearm) - rest(upper)).normalize();
        let way = DVec3::new(-0.3 * x, -1.0, 0.0).normalize();
        let turn = DQuat::from_rotation_arc(along, way).to_scaled_axis();
        clip.rotation[upper] = turn.as_vec3().to_array();
    }
    let mut capture = captured_clip(skeleton, &clip);
    for side in ["Left", "Right"] {
        let shoulder = index(&format!("{side}Arm"));
        capture.joints[shoulder].offset.x *= 2.0;
        capture.local[shoulder].offset.x *= 2.0;
    }
    let options = RetargetOptions {
        girth: Girth::of(&avatar),
        ..RetargetOptions::default()
    };
    let made = retarget::retarget(&capture, skeleton, "reach", &options).unwrap();
    let ArmsInside { before, after } = made.report.arms.unwrap();
    assert!(before.max > 0.015, "{before:?}");
    assert!(after.max < 0.006, "{after:?}, {before:?} before");
    // The capture of the same body as the avatar's is left as it is.
    let same = captured_clip(skeleton, &clip);
    let options = RetargetOptions {
        keep_feet: true,
        ..options
    };
    let made = retarget::retarget(&same, skeleton, "reach", &options).unwrap();
    let directions = made.report.directions;
    assert!(directions.max < 0.1, "{directions:?}");
}

fn a_correction_says_which_joint_is_which() {
    let options = |part: &str, joint: &str| RetargetOptions {
        corrections: vec![Correction {
            part: part.into(),
            joint: joint.into(),
        }],
        ..RetargetOptions::default()
    };
    let capture = read(MIXAMO).capture;
    let skeleton = demo().skeleton;
    let fault = |options: &RetargetOptions| {
        let made = retarget::retarget(&capture, &skeleton, "walk", options);
        made.map_or_else(|error| error.to_string(), |_| "none".into())
    };
    assert!(fault(&options("LeftKnee", "x")).contains("no part of that name"));
    assert!(fault(&options("LeftLeg", "x")).contains("a joint of the file"));
    // A knee that is an elbow is no leg's.
    assert!(fault(&options("LeftLeg", "mixamorig:LeftForeArm")).contains("no body"));
    // A clavicle that is left out stays with the chest.
    let made = retarget::retarget(
        &capture,
        &skeleton,
        "walk",
        &options("Head", "mixamorig:Neck"),
    );
    let report = made.unwrap().report;
    let head = report.joints.iter().find(|guess| guess.part == "Head");
    assert_eq!(head.unwrap().joint, "mixamorig:Neck");
}

fn a_models_rest_pose_says_nothing_of_which_way_is_up() {
    let mut capture = read(MIXAMO).capture;
    let roots = capture.local.iter_mut().step_by(capture.joints.len());
    // The file's own axes are turned: what was up is x.
    let turn = glam::Quat::from_rotation_z(-std::f32::consts::FRAC_PI_2);
    for root in roots {
        root.rotation = turn * root.rotation;
        root.offset = turn * root.offset;
    }
    let up = |capture: &Capture| {
        let skeleton = demo().skeleton;
        let made = retarget::retarget(capture, &skeleton, "x", &keep_feet());
        made.unwrap().report.up
    };
    assert_eq!(up(&capture), DVec3::Y);
    capture.model_rest = true;
    assert_eq!(up(&capture), DVec3::X);
}

fn absurd_captures_are_refused() {
    let skeleton = demo().skeleton;
    let fault = |capture: &Capture, options: &RetargetOptions| {
        let made = retarget::retarget(capture, &skeleton, "x", options);
        made.map_or_else(|error| error.to_string(), |_| "none".into())
    };
    let mut capture = read(MIXAMO).capture;
    capture.rate = 1e-3;
    let fast = RetargetOptions {
        rate: Some(1000.0),
        ..keep_feet()
    };
    let found = fault(&capture, &fast);
    assert!(found.contains("frames of 52 joints"), "{found}");
    let mut capture = read(MIXAMO).capture;
    for joint in &mut capture.joints {
        joint.offset *= 1e-9;
    }
    for pose in &mut capture.local {
        pose.offset *= 1e-9;
    }
    let found = fault(&capture, &RetargetOptions::default());
    assert!(found.contains("units long"), "{found}");
    // A hand at its elbow, and a shin without length.
    let mut capture = read(MIXAMO).capture;
    let joints = capture.joints.len();
    let named = |name: &str| {
        read(MIXAMO)
            .capture
            .joints
            .iter()
            .position(|joint| joint.name.ends_with(name))
    };
    for joint in ["LeftHand", "LeftFoot"].map(|name| named(name).unwrap()) {
        for pose in capture.local.iter_mut().skip(joint).step_by(joints) {
            pose.offset = glam::Vec3::ZERO;
        }
    }
    let made = retarget::retarget(&capture, &skeleton, "x", &RetargetOptions::default()).unwrap();
    assert!(made.report.directions.mean.is_finite());
    let mut turns = made.clip.rotation.iter().flatten();
    assert!(turns.all(|turn| turn.is_finite()));
}

fn who_has_no_body_is_told_what_is_missing() {
    let text = "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0\n";
    let capture = read(text.as_bytes()).capture;
    let made = retarget::retarget(&capture, &demo().skeleton, "x", &RetargetOptions::default());
    let error = made.unwrap_err().to_string();
    assert!(error.contains("no body among 1 joints (Hips"), "{error}");
    assert!(error.contains("LeftForeArm"), "{error}");
    let mut static_one = demo().skeleton;
    for name in &mut static_one.name {
        *name = "bone".into();
    }
    static_one.rest.fill([0.0; 3]);
    let walk = read(MIXAMO).capture;
    let made = retarget::retarget(&walk, &static_one, "x", &RetargetOptions::default());
    let error = made.unwrap_err().to_string();
    assert!(
        error.contains("an avatar of 52 joints without a body"),
        "{error}"
    );
}

fn a_rest_pose_before_the_motion_is_left_out() {
    let file = |first: &str| {
        format!(
            "HIERARCHY\nROOT a {{\nCHANNELS 3 Xrotation Yrotation Zrotation\n}}\nMOTION\nFrames: 2\nFrame Time: 1\n{first}\n90 0 0\n"
        )
    };
    let first = |text: &str| {
        let read = read(text.as_bytes());
        let turn = read.capture.local[0].rotation.to_axis_angle().1;
        (turn.to_degrees(), read.assumptions.len())
    };
    let (turn, assumptions) = first(&file("0 0 0"));
    assert!((turn - 90.0).abs() < 1e-3 && assumptions == 1, "{turn}");
    let (turn, assumptions) = first(&file("45 0 0"));
    assert!((turn - 45.0).abs() < 1e-3 && assumptions == 0, "{turn}");
}

fn positions_of_zero_do_not_take_joints_to_one_point() {
    let text = "HIERARCHY\nROOT a {\nCHANNELS 3 Xposition Yposition Zposition\nJOINT b {\nOFFSET 1 2 3\nCHANNELS 4 Xrotation Xposition Yposition Zposition\n}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n4 0 0 10 0 0 0\n";
    let read = read(text.as_bytes());
    assert_eq!(read.capture.local[1].offset, glam::Vec3::new(1.0, 2.0, 3.0));
    assert_eq!(read.capture.local[0].offset, glam::Vec3::new(4.0, 0.0, 0.0));
    assert_eq!(read.assumptions.len(), 1);
}

fn a_clip_has_the_rate_that_is_asked_for() {
    let clip = |rate: f64| {
        let options = RetargetOptions {
            rate: Some(rate),
            ..keep_feet()
        };
        made(MIXAMO, &options).clip
    };
    let [own, finer] = [clip(20.0), clip(50.0)];
    assert_eq!((own.frames(), finer.frames()), (44, 108));
    let [a, b] = [own.sample(1.0), finer.sample(1.0)];
    for (a, b) in a.rotation.iter().zip(&b.rotation) {
        assert!(a.distance(*b) < 1e-3, "{a} {b}");
    }
}

tests! {
    every_rig_shows_what_numpy_shows,
    bones_point_where_the_captures_do,
    one_walk_moves_the_body_alike_whatever_the_rig,
    a_clip_that_is_read_as_a_capture_comes_back,
    standing_feet_neither_slide_nor_sink,
    feet_that_are_kept_slide_on_another_body,
    arms_stay_out_of_the_body_where_the_captures_do,
    a_correction_says_which_joint_is_which,
    a_models_rest_pose_says_nothing_of_which_way_is_up,
    absurd_captures_are_refused,
    who_has_no_body_is_told_what_is_missing,
    a_rest_pose_before_the_motion_is_left_out,
    positions_of_zero_do_not_take_joints_to_one_point,
    a_clip_has_the_rate_that_is_asked_for,
}
