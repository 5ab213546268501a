//! Limbs where names say nothing, where an end is as long as a bone, where there are none, and where
//! somebody says the wrong joint.

use super::{MIXAMO, NAMELESS, Shown, demo, keep_feet, made, read, worst_bone};
use effigy_core::avatar::Pose;
use effigy_formats::{
    capture::{Capture, CaptureJoint, LocalPose},
    retarget::{self, Correction, RetargetOptions, Retargeted},
};
use glam::{DQuat, DVec3, Quat};

fn worst(retargeted: &Retargeted, z_up: bool) -> f64 {
    worst_bone(&Shown::read(), &demo().skeleton, &retargeted.clip, z_up).degrees
}

/// A forearm has 250 mm, an upper arm 280.
fn a_long_end_of_a_hand_is_no_forearm() {
    let text = std::str::from_utf8(NAMELESS).unwrap();
    for end in [
        "10.0", "50.0", "140.0", "160.0", "190.0", "240.0", "290.0", "300.0", "600.0",
    ] {
        let longer = text.replace("90.00000 0.00000 0.0", &format!("{end} 0.00000 0.0"));
        assert!(longer != text, "{end}");
        let retargeted = made(longer.as_bytes(), &keep_feet());
        let off = worst(&retargeted, true);
        assert!(off < 0.1, "{end} mm: {off}°");
        assert!(retargeted.report.directions.max < 0.1);
        for part in ["LeftHand", "RightHand"] {
            assert!(!joint_of(&retargeted, part).ends_with("end"), "{end} mm");
        }
        assert!(
            retargeted.assumptions.is_empty(),
            "{:?}",
            retargeted.assumptions
        );
    }
}

/// Nor is a collar bone of 140 mm an upper arm.
fn a_long_collar_bone_is_no_upper_arm() {
    let text = std::str::from_utf8(NAMELESS).unwrap();
    // From the collar bone to the shoulder.
    for wide in ["20.0", "100.0", "170.0", "200.0"] {
        let wider = text.replace("140.00000 0.00000", &format!("{wide} 0.00000"));
        assert!(wider != text);
        let off = worst(&made(wider.as_bytes(), &keep_feet()), true);
        assert!(off < 0.1, "{wide} mm: {off}°");
    }
}

/// 220 mm of a collar bone beside 220 and 200 mm of an arm.
fn what_turns_goes_before_what_is_long() {
    let mut text = std::str::from_utf8(NAMELESS).unwrap().to_owned();
    for [was, is] in [
        ["140", "220"],
        ["280", "220"],
        ["250", "200"],
        ["90", "200"],
    ] {
        text = text.replace(
            &format!("{was}.00000 0.00000"),
            &format!("{is}.00000 0.00000"),
        );
    }
    assert!(worst(&made(text.as_bytes(), &keep_feet()), true) < 0.1);
}

fn ends_of_two_hands_may_differ() {
    let text = std::str::from_utf8(NAMELESS).unwrap();
    let other = text.replacen("90.00000 0.00000 0.0", "300.00000 0.00000 0.0", 1);
    assert!(other != text);
    assert!(worst(&made(other.as_bytes(), &keep_feet()), true) < 0.1);
}

fn toes_at_the_ankles_point_where_their_ends_do() {
    let text = std::str::from_utf8(NAMELESS).unwrap();
    let short = text.replace("0.00000 130.00000 -60.00000", "0.00000 0.00000 0.00000");
    assert!(short != text);
    assert!(worst(&made(short.as_bytes(), &keep_feet()), true) < 0.1);
}

/// A capture with another joint half way to some of its joints.
fn with_twists(mut capture: Capture, names: &[&str]) -> Capture {
    for name in names {
        let count = capture.joints.len();
        let own = |joint: &CaptureJoint| joint.name == *name;
        let at = capture.joints.iter().position(own).unwrap();
        for joint in &mut capture.joints[at..] {
            joint.parent = joint
                .parent
                .map(|parent| parent + usize::from(parent >= at));
        }
        let mut twist = capture.joints[at].clone();
        twist.name = format!("{name} twist");
        twist.offset /= 2.0;
        twist.rest = DQuat::IDENTITY;
        capture.joints[at].offset /= 2.0;
        capture.joints[at].parent = Some(at);
        capture.joints.insert(at, twist);
        let local = capture.local.chunks_exact(count).flat_map(|frame| {
            let mut frame = frame.to_vec();
            frame[at].offset /= 2.0;
            let twist = LocalPose {
                rotation: Quat::IDENTITY,
                offset: frame[at].offset,
            };
            frame.insert(at, twist);
            frame
        });
        capture.local = local.collect();
    }
    capture
}

fn twist_joints_divide_no_bone() {
    let elbows = ["bone 09", "bone 19"];
    let wrists = ["bone 10", "bone 20"];
    let knees = ["bone 13", "bone 23"];
    let ankles = ["bone 14", "bone 24"];
    let all = [elbows, wrists, knees, ankles].concat();
    for names in [&elbows[..], &wrists, &knees, &ankles, &all] {
        let capture = with_twists(read(NAMELESS).capture, names);
        let made = retarget::retarget(&capture, &demo().skeleton, "x", &keep_feet()).unwrap();
        let off = worst(&made, true);
        assert!(off < 0.1, "{names:?}: {off}°");
        assert!(made.assumptions.is_empty(), "{:?}", made.assumptions);
        for part in ["LeftHand", "RightHand", "LeftFoot", "RightFoot"] {
            let joint = joint_of(&made, part);
            let ends = [wrists, ankles].concat();
            assert!(ends.contains(&joint), "{names:?}: {part} is {joint}");
        }
    }
}

fn joint_of<'a>(made: &'a Retargeted, part: &str) -> &'a str {
    let own = |guess: &&retarget::JointGuess| guess.part == part;
    &made.report.joints.iter().find(own).unwrap().joint
}

fn arms_may_be_longer_than_legs() {
    let text = std::str::from_utf8(NAMELESS).unwrap();
    let short = text.replace("-410.00000", "-220.00000");
    assert!(short != text);
    let made = made(short.as_bytes(), &keep_feet());
    assert!(["bone 10", "bone 20"].contains(&joint_of(&made, "LeftHand")));
    assert!(["bone 14", "bone 24"].contains(&joint_of(&made, "LeftFoot")));
}

/// A forearm that moves alone begins no arm.
fn an_upper_arm_that_stands_still_is_one() {
    let mut capture = read(NAMELESS).capture;
    let count = capture.joints.len();
    let first = capture.local[..count].to_vec();
    for name in ["bone 08", "bone 18"] {
        let own = |joint: &CaptureJoint| joint.name == name;
        let at = capture.joints.iter().position(own).unwrap();
        for frame in capture.local.chunks_exact_mut(count) {
            frame[at] = first[at];
        }
    }
    let made = retarget::retarget(&capture, &demo().skeleton, "x", &keep_feet()).unwrap();
    let uppers = ["LeftArm", "RightArm"].map(|part| joint_of(&made, part));
    assert!(uppers == ["bone 08", "bone 18"] || uppers == ["bone 18", "bone 08"]);
}

const JAPANESE: [[&str; 2]; 18] = [
    ["LeftToeBase", "左つま先"],
    ["RightToeBase", "右つま先"],
    ["LeftForeArm", "左ひじ"],
    ["RightForeArm", "右ひじ"],
    ["LeftUpLeg", "左足"],
    ["RightUpLeg", "右足"],
    ["LeftShoulder", "左肩"],
    ["RightShoulder", "右肩"],
    ["LeftHand", "左手首"],
    ["RightHand", "右手首"],
    ["LeftArm", "左腕"],
    ["RightArm", "右腕"],
    ["LeftFoot", "左足首"],
    ["RightFoot", "右足首"],
    ["LeftLeg", "左ひざ"],
    ["RightLeg", "右ひざ"],
    ["Neck", "首"],
    ["Head", "頭"],
];

fn names_of_mikumikudance_are_known() {
    let mut text = std::str::from_utf8(MIXAMO).unwrap().to_owned();
    for [english, japanese] in JAPANESE {
        text = text.replace(&format!("mixamorig:{english}"), japanese);
    }
    let retargeted = made(text.as_bytes(), &keep_feet());
    assert!(worst(&retargeted, false) < 0.1);
    let arm = |guess: &&retarget::JointGuess| guess.part == "LeftForeArm";
    let joints = &retargeted.report.joints;
    assert_eq!(joints.iter().find(arm).unwrap().joint, "左ひじ");
}

/// In Shift-JIS the second half of some letters is a brace.
fn names_in_other_encodings_do_not_break_the_tree() {
    let text = std::str::from_utf8(NAMELESS).unwrap();
    let mut bytes = vec![];
    for piece in text.split_inclusive("bone ") {
        match piece.strip_suffix("bone ") {
            // "ボーン" and "マ".
            Some(before) => {
                bytes.extend([before.as_bytes(), b"\x83\x7b\x81\x5b\x83\x93\x83\x7d"].concat())
            }
            None => bytes.extend(piece.as_bytes()),
        }
    }
    assert!(bytes.len() > text.len());
    assert!(worst(&made(&bytes, &keep_feet()), true) < 0.1);
}

/// A capture without some joints and what hangs from them.
fn without(mut capture: Capture, names: &[&str]) -> Capture {
    let count = capture.joints.len();
    let mut place: Vec<Option<usize>> = vec![];
    let mut joints = vec![];
    for joint in &capture.joints {
        let above = joint.parent.map(|parent| place[parent]);
        let gone = above == Some(None) || names.iter().any(|name| joint.name.ends_with(name));
        place.push((!gone).then_some(joints.len()));
        if !gone {
            let mut joint = joint.clone();
            joint.parent = above.flatten();
            joints.push(joint);
        }
    }
    let local = capture.local.chunks_exact(count).flat_map(|frame| {
        let kept = frame
            .iter()
            .zip(&place)
            .filter(|(_, place)| place.is_some());
        kept.map(|(pose, _)| *pose)
    });
    capture.local = local.collect();
    capture.joints = joints;
    capture
}

fn a_body_without_legs_moves_the_arms_and_rests_the_legs() {
    let whole = made(MIXAMO, &keep_feet()).clip;
    let skeleton = demo().skeleton;
    for options in [keep_feet(), RetargetOptions::default()] {
        let upper = without(read(MIXAMO).capture, &["LeftUpLeg", "RightUpLeg"]);
        let made = retarget::retarget(&upper, &skeleton, "x", &options).unwrap();
        let said = made.assumptions.iter().find(|own| own.what == "legs");
        assert_eq!(said.unwrap().taken, "at rest");
        assert_eq!(made.report.contacts, 0);
        assert!(
            made.report.directions.max < 0.1,
            "{:?}",
            made.report.directions
        );
        let joints = skeleton.len();
        let legs = ["UpLeg", "Leg", "Foot", "ToeBase"];
        for (at, (own, expected)) in made.clip.rotation.iter().zip(&whole.rotation).enumerate() {
            let name = &skeleton.name[at % joints];
            let [own, expected] = [own, expected].map(|turn| DVec3::from(turn.map(f64::from)));
            let expected = match legs.iter().any(|leg| name.ends_with(leg)) {
                true => DVec3::ZERO,
                false => expected,
            };
            assert!(own.distance(expected) < 1e-3, "{name}");
        }
        let low = |pose: &Pose| {
            let foot = super::place(&skeleton, pose, "LeftToeBase").y;
            foot.min(super::place(&skeleton, pose, "RightToeBase").y)
        };
        let lowest = (0..made.clip.frames()).map(|frame| low(&made.clip.frame(frame)));
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        assert!((-0.02..0.1).contains(&lowest), "{lowest}");
    }
    let bust = without(
        read(MIXAMO).capture,
        &["LeftUpLeg", "RightUpLeg", "LeftForeArm"],
    );
    let error = retarget::retarget(&bust, &skeleton, "x", &keep_feet()).unwrap_err();
    let error = error.to_string();
    assert!(
        error.contains("LeftForeArm") && !error.contains("UpLeg"),
        "{error}"
    );
}

/// Says that the bones of an arm are others.
fn shifted(names: [&str; 3]) -> Retargeted {
    let parts = ["LeftArm", "LeftForeArm", "LeftHand"];
    let corrections = parts.into_iter().zip(names).map(|(part, name)| Correction {
        part: part.into(),
        joint: format!("mixamorig:{name}"),
    });
    let options = RetargetOptions {
        corrections: corrections.collect(),
        ..keep_feet()
    };
    made(MIXAMO, &options)
}

/// A report of a guess measures the guess: this one sees an arm that is taken a joint too far out or
/// in.
fn the_report_sees_an_arm_that_is_shifted_by_a_joint() {
    let sound = shifted(["LeftArm", "LeftForeArm", "LeftHand"]);
    assert!(sound.report.directions.max < 0.1 && sound.assumptions.is_empty());
    for names in [
        ["LeftForeArm", "LeftHand", "LeftHand end"],
        ["LeftShoulder", "LeftArm", "LeftForeArm"],
    ] {
        let Retargeted {
            report,
            assumptions,
            ..
        } = shifted(names);
        assert!(
            report.directions.mean > 2.0,
            "{names:?} {:?}",
            report.directions
        );
        assert!(
            report.directions.max > 20.0,
            "{names:?} {:?}",
            report.directions
        );
        let doubt = assumptions.iter().find(|own| own.what == "left arm");
        let doubt = doubt.unwrap();
        assert!(doubt.because.contains("mixamorig:LeftArm"), "{doubt}");
        assert_eq!(assumptions.len(), 1, "{assumptions:?}");
    }
}

tests! {
    a_long_end_of_a_hand_is_no_forearm,
    a_long_collar_bone_is_no_upper_arm,
    what_turns_goes_before_what_is_long,
    ends_of_two_hands_may_differ,
    toes_at_the_ankles_point_where_their_ends_do,
    twist_joints_divide_no_bone,
    arms_may_be_longer_than_legs,
    an_upper_arm_that_stands_still_is_one,
    names_of_mikumikudance_are_known,
    names_in_other_encodings_do_not_break_the_tree,
    a_body_without_legs_moves_the_arms_and_rests_the_legs,
    the_report_sees_an_arm_that_is_shifted_by_a_joint,
}
