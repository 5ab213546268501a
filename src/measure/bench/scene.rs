//! The scenes of a case: an avatar, a clip and, where given, cameras go in; the scene of every frame comes out.
//!
//! [`Case::Full`] jumps through the clip and around the avatar, so that no frame is like the one before. The other moving cases go
//! in real time at [`RATE`], as a viewer does, but in takes of [`TAKE`] frames from places spread over the clip, each seen from
//! another side: a short run is then not a measurement of one step from one side.

use super::Case;
use crate::{
    avatar::{Avatar, Pose, motion::Player},
    frame::{Camera, Extent, Posed},
    measure::{in_a_row, upright},
};
use glam::DVec3;
use std::{f64::consts::TAU, ops::Range};

/// Frames a second of what moves in real time.
pub const RATE: f64 = 60.0;
/// Frames from one cut to the next.
pub const TAKE: usize = 12;

/// Vertical field of view, radians.
const FOV: f64 = 35f64.to_radians();
/// Height above the horizon that cameras look from, radians.
const PITCH: f64 = 0.09;
/// A slow orbit, radians a frame: half a degree.
const TURN: f64 = TAU / 720.0;
/// From the eye to the face when close, metres: a forearm.
const FOREARM: f64 = 0.45;
/// Height of a far avatar in the picture, px.
const FAR: f64 = 60.0;
/// An avatar in a scene.
#[derive(Clone, Debug)]
pub struct Actor {
    /// As it is drawn.
    pub shown: Posed,
    /// As the clip has it at that time, which is another pose when poses are held.
    pub truth: Posed,
}

/// What one frame shows.
#[derive(Clone, Debug)]
pub struct Scene {
    /// At least one; all of them are copies of one avatar.
    pub actors: Vec<Actor>,
    pub camera: Camera,
}

/// What scenes are made of.
#[derive(Clone, Copy)]
pub struct Set<'a> {
    pub avatar: &'a Avatar,
    pub player: &'a Player,
    /// Width and height of the picture, px.
    pub size: [u32; 2],
    /// Cameras of that size to see from, one a frame in turn, instead of those around the avatar; may be empty. A close-up, a far
    /// avatar and four of them keep their own.
    pub cameras: &'a [Camera],
    /// Frames, at least 1.
    pub frames: usize,
    /// Views around the avatar, used in turn, at least 1.
    pub views: usize,
    /// Frames that a pose is held, at least 1. Only where motion is in real time.
    pub hold: usize,
}

/// The scenes of a case, one a frame.
pub fn scenes(case: Case, set: &Set) -> Vec<Scene> {
    let extent = Extent::new(set.avatar);
    let scene = |frame| {
        let held = if case.in_real_time() { frame - frame % TAKE % set.hold } else { frame };
        let actors = (0..case.actors()).map(|actor| Actor { shown: posed(case, set, held, actor), truth: posed(case, set, frame, actor) });
        let actors: Vec<_> = actors.collect();
        let camera = match set.cameras.get(if case.camera_moves() { frame % set.cameras.len().max(1) } else { 0 }) {
            Some(&camera) if !case.own_camera() => camera,
            _ => camera(case, set, &extent, frame),
        };
        Scene { actors, camera }
    };
    (0..set.frames).map(scene).collect()
}

/// Which of `frames` scenes to compare with the reference: `count` of them, spread, from several views, and where poses are held, at
/// the end of the hold rather than at its start.
pub fn checks(case: Case, frames: usize, count: usize) -> Vec<usize> {
    let count = count.min(frames);
    let last = |check: usize| (check + 1) * frames / count - 1;
    // One frame earlier each time, for the next view; a take's view changes by itself.
    let shift = |check: usize| if case == Case::Full { check % (frames / count) } else { 0 };
    (0..count).map(|check| last(check) - shift(check)).collect()
}

/// Seconds into the clip. Still cases stay in its middle.
fn seconds(case: Case, set: &Set, frame: usize) -> f64 {
    let duration = set.player.clip().duration();
    match case {
        Case::Full => duration * frame as f64 / set.frames as f64,
        Case::Camera | Case::Expression | Case::Static => 0.5 * duration,
        Case::Orbit | Case::Close | Case::Far | Case::Four => {
            let takes = set.frames.div_ceil(TAKE);
            let start = (duration - TAKE as f64 / RATE).max(0.0) * (frame / TAKE) as f64 / takes as f64;
            start + (frame % TAKE) as f64 / RATE
        }
    }
}

fn pose(case: Case, set: &Set, frame: usize, actor: usize) -> Pose {
    let duration = set.player.clip().duration();
    let later = duration * actor as f64 / case.actors() as f64;
    let at = seconds(case, set, frame) + later;
    let mut pose = set.player.pose(if later > 0.0 { at % duration } else { at });
    if case == Case::Expression {
        // Clips of bodies have none: slow waves of one deviation, each component at its own pace.
        let wave = |k: usize| (TAU * (frame as f64 / 40.0 * (1 + k % 3) as f64 + 0.1 * k as f64)).sin();
        pose.expression = (0..set.avatar.inputs.expression).map(wave).collect();
    }
    pose
}

fn posed(case: Case, set: &Set, frame: usize, actor: usize) -> Posed {
    Posed::new(set.avatar, &pose(case, set, frame, actor)).placed(in_a_row(actor, case.actors()))
}

fn camera(case: Case, set: &Set, extent: &Extent, frame: usize) -> Camera {
    if case == Case::Close {
        return close(set, extent, frame);
    }
    // A take is seen by a camera that does not follow every step.
    let seen = if case == Case::Full { frame } else { frame - frame % TAKE };
    let boxes = looked_at(case, frame).map(|actor| upright(extent.bounds(&posed(case, set, seen, actor).joints)));
    let [min, max] = boxes.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], [min, max]| [low.min(min), high.max(max)]);
    let view = match case {
        Case::Full => frame % set.views,
        Case::Static | Case::Expression => 0,
        _ => frame / TAKE % set.views,
    };
    let turn = if case == Case::Full || !case.camera_moves() { 0.0 } else { TURN * (frame % TAKE) as f64 };
    let framing = Camera::framing_distance([min, max], FOV, set.size);
    let distance = match case {
        Case::Far => framing.max(0.5 * f64::from(set.size[1]) / (0.5 * FOV).tan() * (max.y - min.y) / FAR),
        _ => framing,
    };
    let yaw = TAU * (0.05 + view as f64 / set.views as f64) + turn;
    Camera::orbit((min + max) / 2.0, yaw, PITCH, distance, FOV, set.size)
}

/// The avatars that the camera is for: of several, in every other take only the first, so that others are partly or all outside the
/// picture.
fn looked_at(case: Case, frame: usize) -> Range<usize> {
    let all = case.actors();
    0..if (frame / TAKE).is_multiple_of(2) { all.div_ceil(4) } else { all }
}

/// Straight in front of the face: of the joint `head`, else of what would be the head of the bounds.
fn close(set: &Set, extent: &Extent, frame: usize) -> Camera {
    let pose = pose(Case::Close, set, frame, 0);
    let skeleton = &set.avatar.skeleton;
    let (face, forward) = match skeleton.name.iter().position(|name| name.eq_ignore_ascii_case("head")) {
        Some(head) => {
            let turned = skeleton.matrices(&pose)[head].matrix3;
            (skeleton.joints(&pose)[head].translation + turned * DVec3::new(0.0, 0.06, 0.08), turned * DVec3::Z)
        }
        None => {
            let [min, max] = extent.bounds(&Posed::new(set.avatar, &pose).joints);
            (DVec3::new((min.x + max.x) / 2.0, max.y - 0.15, (min.z + max.z) / 2.0), DVec3::Z)
        }
    };
    Camera::look_at(face + FOREARM * forward, face, FOV, set.size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo;

    fn with_demo(frames: usize, hold: usize, test: impl Fn(Set)) {
        let avatar = demo::avatar().expect("inside the program");
        let player = Player::new(demo::clip().expect("inside the program"), &avatar.skeleton);
        test(Set { avatar: &avatar, player: &player, size: [200, 240], cameras: &[], frames, views: 4, hold });
    }

    /// Whether joints, network inputs and camera differ from one frame to the next.
    fn changes(scenes: &[Scene]) -> [bool; 3] {
        let all = |same: fn(&Scene, &Scene) -> bool| scenes.windows(2).all(|pair| !same(&pair[0], &pair[1]));
        [
            all(|a, b| a.actors[0].shown.joints == b.actors[0].shown.joints),
            all(|a, b| a.actors[0].shown.input == b.actors[0].shown.input),
            all(|a, b| a.camera == b.camera),
        ]
    }

    #[test]
    fn each_case_changes_what_it_says_and_nothing_else() {
        with_demo(24, 1, |set| {
            let of = |case| changes(&scenes(case, &set));
            assert_eq!(of(Case::Full), [true; 3]);
            assert_eq!(of(Case::Orbit), [true; 3]);
            assert_eq!(of(Case::Camera), [false, false, true]);
            assert_eq!(of(Case::Expression), [false, true, false]);
            assert_eq!(of(Case::Static), [false; 3]);
            let still = scenes(Case::Static, &set);
            assert!(
                still.iter().all(|scene| scene.actors[0].shown.input == still[0].actors[0].shown.input && scene.camera == still[0].camera)
            );
        });
    }

    #[test]
    fn a_far_avatar_is_sixty_pixels_tall_and_a_close_face_is_a_forearm_away() {
        with_demo(12, 1, |set| {
            let height = |case| {
                let scene = &scenes(case, &set)[0];
                let [min, max] = upright(Extent::new(set.avatar).bounds(&scene.actors[0].shown.joints));
                let middle = (min + max) / 2.0;
                let at = |y| scene.camera.project(scene.camera.view.transform_point3(DVec3::new(middle.x, y, middle.z))).y;
                at(min.y) - at(max.y)
            };
            assert!((height(Case::Far) - FAR).abs() < 2.0, "{}", height(Case::Far));
            assert!(height(Case::Orbit) > 2.0 * FAR);
            let skeleton = &set.avatar.skeleton;
            let head = skeleton.name.iter().position(|name| name.eq_ignore_ascii_case("head")).expect("the demo has a head");
            for (frame, scene) in scenes(Case::Close, &set).iter().enumerate() {
                let joint = skeleton.joints(&pose(Case::Close, &set, frame, 0))[head].translation;
                let seen = scene.camera.view.transform_point3(joint);
                let at = scene.camera.project(seen);
                assert!((FOREARM..FOREARM + 0.2).contains(&seen.z), "the head is {} m away", seen.z);
                assert!((0.0..200.0).contains(&at.x) && (0.0..240.0).contains(&at.y), "the head is at {at}");
            }
        });
    }

    #[test]
    fn a_held_pose_is_drawn_for_as_long_as_it_is_held_while_the_truth_goes_on() {
        with_demo(24, 3, |set| {
            let scenes = scenes(Case::Orbit, &set);
            for (frame, scene) in scenes.iter().enumerate() {
                assert_eq!(scene.actors[0].shown.joints, scenes[frame - frame % 3].actors[0].truth.joints, "frame {frame}");
                assert_eq!(frame % 3 == 0, scene.actors[0].shown.joints == scene.actors[0].truth.joints, "frame {frame}");
            }
            assert!(checks(Case::Orbit, 24, 2).iter().all(|frame| frame % 3 == 2), "the errors of held poses are not looked at");
        });
    }

    #[test]
    fn four_avatars_stand_apart_and_move_differently() {
        with_demo(4, 1, |set| {
            let scenes = scenes(Case::Four, &Set { frames: 2 * TAKE, ..set });
            let extent = Extent::new(set.avatar);
            let in_view = |scene: &Scene| {
                scene.actors.iter().filter(|actor| !extent.visible(&actor.shown.joints, &scene.camera).parts.is_empty()).count()
            };
            let seen = [in_view(&scenes[0]), in_view(&scenes[TAKE])];
            assert!(seen[0] < 4 && seen[1] == 4, "{seen:?}");
            let stand = |actor: &Actor| extent.bounds(&actor.shown.joints).into_iter().sum::<DVec3>() / 2.0;
            for pair in scenes[0].actors.windows(2) {
                let apart = (stand(&pair[1]) - stand(&pair[0])).length();
                assert!(apart > 0.4 && pair[0].shown.input != pair[1].shown.input, "{apart} m apart");
            }
        });
    }

    #[test]
    fn given_cameras_are_used_in_turn() {
        with_demo(5, 1, |set| {
            let cameras: Vec<_> = (0..2).map(|k| Camera::orbit(DVec3::Y, f64::from(k), 0.0, 3.0, 0.5, set.size)).collect();
            let set = Set { cameras: &cameras, ..set };
            let seen =
                |case| scenes(case, &set).iter().map(|scene| cameras.iter().position(|camera| *camera == scene.camera)).collect::<Vec<_>>();
            assert_eq!(seen(Case::Full), [Some(0), Some(1), Some(0), Some(1), Some(0)]);
            assert_eq!(seen(Case::Static), [Some(0); 5]);
            assert_eq!(seen(Case::Close), [None; 5]);
        });
    }

    #[test]
    fn checked_frames_are_spread_and_show_every_view() {
        let views =
            |frames, count| checks(Case::Full, frames, count).iter().map(|frame| frame % 4).collect::<std::collections::BTreeSet<_>>();
        assert_eq!(views(32, 4).len(), 4);
        for (frames, count) in [(1, 1), (3, 8), (32, 0), (10, 4), (5, 5)] {
            for case in Case::ALL {
                let checks = checks(case, frames, count);
                assert_eq!(checks.len(), count.min(frames), "{frames} frames, {count} checks");
                assert!(checks.iter().all(|&check| check < frames) && checks.is_sorted_by(|a, b| a < b), "{checks:?}");
            }
        }
    }
}
