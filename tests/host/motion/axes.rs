//! Which way is up: in the axes that bodies stand along, whatever names and formats say.

use super::{MIXAMO, demo, keep_feet, place, read};
use effigy_formats::{
    assumption::Assumption,
    capture::{Capture, CaptureJoint, UpAxis},
    retarget,
};
use glam::{DVec3, Quat, Vec3};
use std::f32::consts::{FRAC_PI_2, PI};

const AMASS: UpAxis = UpAxis::Usual {
    axis: DVec3::Z,
    whose: "AMASS's files",
};
const CAMERA: UpAxis = UpAxis::Said(DVec3::NEG_Y);

/// A walk of 0.4 m along z with y up, centimetres, as a file of SMPL's has it.
fn walk(up: UpAxis) -> Capture {
    let mut capture = read(MIXAMO).capture;
    capture.model_rest = true;
    capture.up = up;
    capture
}

/// A place of the root in a frame.
struct Root {
    turn: Quat,
    /// None: where it was, turned.
    at: Option<Vec3>,
}

fn turned(turn: Quat) -> Root {
    Root { turn, at: None }
}

/// The same with the root elsewhere. `root`: from the share of the frames that are over.
fn with_roots(mut capture: Capture, root: impl Fn(f32) -> Root) -> Capture {
    let joints = capture.joints.len();
    let frames = capture.frames() as f32;
    for (frame, own) in capture.local.iter_mut().step_by(joints).enumerate() {
        let Root { turn, at } = root(frame as f32 / frames);
        own.rotation = turn * own.rotation;
        own.offset = at.unwrap_or(turn * own.offset);
    }
    capture
}

struct Found {
    up: DVec3,
    said: Option<Assumption>,
    /// Height of the neck over the hips in the last frame.
    height: f64,
}

fn found(capture: &Capture) -> Found {
    let skeleton = demo().skeleton;
    let made = retarget::retarget(capture, &skeleton, "x", &keep_feet()).unwrap();
    let pose = made.clip.frame(made.clip.frames() - 1);
    let trunk = place(&skeleton, &pose, "Neck") - place(&skeleton, &pose, "Hips");
    let said = made
        .assumptions
        .into_iter()
        .find(|own| own.what == "up axis");
    Found {
        up: made.report.up,
        said,
        height: trunk.normalize().y,
    }
}

/// From y up to z up.
fn z_up() -> Quat {
    Quat::from_rotation_x(FRAC_PI_2)
}

fn bodies_stand_along_whichever_axis_they_stand_along_in_the_file() {
    for (turn, up) in [
        (Quat::IDENTITY, DVec3::Y),
        (Quat::from_rotation_x(PI), DVec3::NEG_Y),
        (z_up(), DVec3::Z),
        (z_up().inverse(), DVec3::NEG_Z),
        (Quat::from_rotation_z(-FRAC_PI_2), DVec3::X),
        (Quat::from_rotation_z(FRAC_PI_2), DVec3::NEG_X),
    ] {
        for in_place in [false, true] {
            let capture = with_roots(walk(AMASS), |_| Root {
                turn,
                at: in_place.then_some(Vec3::ZERO),
            });
            // Nobody writes x or -z up: who does not travel along it lies or stands on the hands.
            let stands = [DVec3::Y, DVec3::NEG_Y, DVec3::Z].contains(&up);
            if stands || (!in_place && up != DVec3::NEG_Z) {
                let Found {
                    up: own,
                    said,
                    height,
                } = found(&capture);
                assert_eq!(own, up);
                assert!(height > 0.9, "{height}");
                assert_eq!(said.is_none(), up == DVec3::Z, "{said:?}");
            } else {
                assert_eq!(found(&capture).up, DVec3::Z, "{up}");
            }
            let open = Capture {
                up: UpAxis::Open,
                ..capture
            };
            assert_eq!(found(&open).up, up);
        }
    }
}

/// On the floor, along one of its axes, for most of the time.
fn who_lies_down_for_a_while_is_not_stood_up() {
    for share in [0.3, 0.6, 0.8] {
        for turn in [z_up(), z_up().inverse(), Quat::from_rotation_z(FRAC_PI_2)] {
            let mut lies = walk(AMASS);
            let joints = lies.joints.len();
            let still = lies.local[..joints].to_vec();
            let frames = (share * lies.frames() as f32).ceil() as usize;
            for frame in lies.local.chunks_exact_mut(joints).take(frames) {
                frame.copy_from_slice(&still);
            }
            let lies = with_roots(lies, |at| Root {
                turn: if at < share { turn } else { Quat::IDENTITY },
                at: (at < share).then_some(Vec3::new(0.0, 10.0, 10.0)),
            });
            assert_eq!(found(&lies).up, DVec3::Y, "{share}");
            let amass = with_roots(lies, |_| turned(z_up()));
            assert_eq!(found(&amass).up, DVec3::Z, "{share}");
            let open = Capture {
                up: UpAxis::Open,
                ..amass
            };
            assert_eq!(found(&open).up, DVec3::Z, "{share}");
        }
    }
}

/// Along a file's axis or across two, on the back or the side.
fn who_sleeps_is_not_stood_up() {
    // From a trunk along y to one along x and, by degrees, to one along -y.
    for degrees in [0.0_f32, 15.0, 35.0, 40.0, 50.0, 145.0, 180.0, 220.0_f32] {
        for roll in [0.0, FRAC_PI_2] {
            let lies = Quat::from_rotation_z(degrees.to_radians() - FRAC_PI_2)
                * Quat::from_rotation_y(roll);
            let asleep = with_roots(walk(AMASS), |_| Root {
                turn: lies,
                at: Some(Vec3::new(0.0, 0.0, 20.0)),
            });
            assert_eq!(found(&asleep).up, DVec3::Z, "{degrees}°");
            // The same where y is usual.
            let aist = Capture {
                up: UpAxis::Usual {
                    axis: DVec3::Y,
                    whose: "AIST++'s files",
                },
                ..with_roots(asleep, |_| turned(z_up().inverse()))
            };
            assert_eq!(found(&aist).up, DVec3::Y, "{degrees}°");
        }
    }
}

/// For most of the frames; those who stand tell.
fn few_frames_that_stand_are_enough() {
    let lies = with_roots(walk(AMASS), |at| Root {
        turn: if at < 0.85 {
            Quat::from_rotation_z(FRAC_PI_2)
        } else {
            Quat::IDENTITY
        },
        at: None,
    });
    assert_eq!(found(&lies).up, DVec3::Y);
}

fn a_cartwheel_is_upside_down_as_long_as_it_is_not() {
    for times in [1.0, 2.0, 3.0] {
        let wheel = with_roots(walk(AMASS), |at| Root {
            turn: Quat::from_rotation_z(times * 2.0 * PI * at),
            at: Some(Vec3::new(0.0, 95.0, 160.0 * at)),
        });
        assert_eq!(found(&wheel).up, DVec3::Y);
    }
}

fn who_leans_over_stands_where_the_feet_are() {
    // Over the ground, all of the body, and on a spot, the trunk alone.
    let skates = with_roots(walk(AMASS), |at| Root {
        turn: Quat::from_rotation_x(0.6),
        at: Some(Vec3::new(0.0, 90.0, 300.0 * at)),
    });
    assert_eq!(found(&skates).up, DVec3::Y);
    let mut rides = with_roots(walk(AMASS), |_| Root {
        turn: Quat::from_rotation_x(0.6),
        at: Some(Vec3::ZERO),
    });
    let joints = rides.joints.len();
    let thigh = |joint: &CaptureJoint| joint.name.ends_with("UpLeg");
    let is_thigh: Vec<bool> = rides.joints.iter().map(thigh).collect();
    for (at, own) in rides.local.iter_mut().enumerate() {
        if is_thigh[at % joints] {
            own.rotation = Quat::from_rotation_x(-0.6) * own.rotation;
        }
    }
    assert_eq!(found(&rides).up, DVec3::Y);
}

fn a_handstand_and_a_crawl_keep_the_usual_axis() {
    let handstand = with_roots(walk(AMASS), |at| Root {
        turn: if at > 0.6 {
            z_up() * Quat::from_rotation_x(PI)
        } else {
            z_up()
        },
        at: None,
    });
    assert_eq!(found(&handstand).up, DVec3::Z);
    // Three metres along y, the trunk along it all the time.
    let crawl = with_roots(walk(AMASS), |at| Root {
        turn: Quat::IDENTITY,
        at: Some(Vec3::new(0.0, 300.0 * at, 10.0)),
    });
    let Found { up, said, .. } = found(&crawl);
    assert_eq!(up, DVec3::Z);
    assert!(said.is_some_and(|said| said.taken == "z, as AMASS's files have"));
    let all_the_time = with_roots(walk(AMASS), |_| Root {
        turn: z_up() * Quat::from_rotation_x(PI),
        at: Some(Vec3::new(0.0, 0.0, 95.0)),
    });
    assert_eq!(found(&all_the_time).up, DVec3::Z);
}

fn a_cameras_axes_hold_unless_bodies_are_upside_down() {
    let usual = with_roots(walk(CAMERA), |_| turned(Quat::from_rotation_x(PI)));
    assert_eq!(found(&usual).up, DVec3::NEG_Y);
    assert!(found(&usual).said.is_none());
    // A plank that is seen from the side.
    let plank = with_roots(walk(CAMERA), |_| Root {
        turn: Quat::from_rotation_z(FRAC_PI_2),
        at: Some(Vec3::ZERO),
    });
    let Found { up, said, .. } = found(&plank);
    assert_eq!(up, DVec3::NEG_Y);
    assert!(said.is_some_and(|said| said.because.starts_with("bodies stand along -x")));
    let Found { up, said, height } = found(&walk(CAMERA));
    assert_eq!(up, DVec3::Y);
    assert!(said.is_some() && height > 0.9);
}

/// A file that says z while its rest pose and its frames stand along y; one whose body swims.
fn what_a_file_says_holds_unless_rest_and_motion_contradict_it() {
    let with_rest = |up| Capture {
        model_rest: false,
        ..walk(UpAxis::Said(up))
    };
    let Found { up, said, .. } = found(&with_rest(DVec3::Z));
    assert_eq!(up, DVec3::Y);
    assert!(said.is_some_and(|said| said.because.contains("the file says z")));
    let swims = with_roots(with_rest(DVec3::Y), |at| Root {
        turn: z_up(),
        at: Some(Vec3::new(0.0, 0.0, 300.0 * at)),
    });
    assert_eq!(found(&swims).up, DVec3::Y);
    // A rest pose with y up, and motion that walks over another ground.
    let other = Capture {
        up: UpAxis::Open,
        ..with_roots(with_rest(DVec3::Y), |at| Root {
            turn: z_up(),
            at: Some(Vec3::new(0.0, -400.0 * at, 90.0)),
        })
    };
    let Found { up, said, .. } = found(&other);
    assert_eq!(up, DVec3::Z);
    assert!(said.is_some_and(|said| said.because.contains("its rest pose has y")));
    // Who lies most of the time walks over it as well.
    for (upright, up) in [(z_up(), DVec3::Z), (z_up().inverse(), DVec3::NEG_Z)] {
        let lies = Capture {
            up: UpAxis::Open,
            ..with_roots(with_rest(DVec3::Y), |at| Root {
                turn: if at < 0.6 {
                    upright * Quat::from_rotation_x(-FRAC_PI_2)
                } else {
                    upright
                },
                at: Some(upright * Vec3::new(0.0, if at < 0.6 { 12.0 } else { 90.0 }, 400.0 * at)),
            })
        };
        assert_eq!(found(&lies).up, up);
    }
}

tests! {
    bodies_stand_along_whichever_axis_they_stand_along_in_the_file,
    who_lies_down_for_a_while_is_not_stood_up,
    who_sleeps_is_not_stood_up,
    few_frames_that_stand_are_enough,
    a_cartwheel_is_upside_down_as_long_as_it_is_not,
    who_leans_over_stands_where_the_feet_are,
    a_handstand_and_a_crawl_keep_the_usual_axis,
    a_cameras_axes_hold_unless_bodies_are_upside_down,
    what_a_file_says_holds_unless_rest_and_motion_contradict_it,
}
