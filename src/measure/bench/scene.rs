//! The scenes of a case: an avatar, a clip and, if given, cameras go in; the scene of every frame
//! comes out.
//!
//! [`BenchCase::Full`] jumps through the clip and around the avatar, so that no frame resembles the
//! one before. The other moving cases run in real time at [`RATE`], as in a viewer, but in takes of
//! [`TAKE`] frames from places spread over the clip, each from another side: so even a short run
//! measures more than one step seen from one side. A zoom has no takes.

use super::case::BenchCase;
use crate::{
    in_rows,
    viewpoint::{self, FOV, PITCH},
};
use effigy_core::{
    avatar::{Avatar, Pose, motion::Player},
    scene::{AvatarBounds, Camera, Framing, Posed},
};
use glam::DVec3;
use std::{f64::consts::TAU, ops::Range};

/// Frames a second in real time.
pub const RATE: f64 = 60.0;
/// Frames from one cut to the next.
pub const TAKE: usize = 12;

/// Angle of a slow orbit, radians a frame: half a degree.
const ORBIT_STEP: f64 = TAU / 720.0;
/// Distance from the camera to the face in a close-up, metres: a forearm.
const FOREARM: f64 = 0.45;

/// Height of the avatar in the first and last frame of a zoom, px, in an image that has room for
/// it.
const ZOOM: [f64; 2] = [2000.0, 20.0];
/// Most of an image's height that it takes.
const ZOOM_SHARE: f64 = 0.98;

/// One avatar of a scene.
#[derive(Clone, Debug)]
pub struct PosedInstance {
    /// The pose to draw.
    pub drawn: Posed,
    /// The pose to compare with: that of the clip at this time. It differs while a pose is held.
    pub reference: Posed,
}

/// The contents of one frame.
#[derive(Clone, Debug)]
pub struct BenchScene {
    /// At least one. All of them are copies of one avatar.
    pub instances: Vec<PosedInstance>,
    /// Where all of them are seen from.
    pub camera: Camera,
}

/// Inputs that scenes are built from.
#[derive(Clone, Copy)]
pub struct SceneInputs<'a> {
    /// The avatar of every instance.
    pub avatar: &'a Avatar,
    /// The clip that moves it.
    pub player: &'a Player,
    /// Width and height of the image, px.
    pub size: [u32; 2],
    /// Cameras for images of that size, one for each frame in turn, in place of those around the
    /// avatar; may be empty. A close-up, a far avatar and four avatars keep their own.
    pub cameras: &'a [Camera],
    /// Number of frames, at least 1.
    pub frames: usize,
    /// Views around the avatar, used in turn, at least 1.
    pub views: usize,
    /// Frames that each pose is held for, at least 1. Only for motion in real time.
    pub hold: usize,
}

/// The scenes of a case, one a frame.
pub fn scenes(case: BenchCase, inputs: &SceneInputs) -> Vec<BenchScene> {
    let bounds = AvatarBounds::new(inputs.avatar);
    (0..inputs.frames)
        .map(|frame| scene(case, inputs, &bounds, frame))
        .collect()
}

fn scene(case: BenchCase, inputs: &SceneInputs, bounds: &AvatarBounds, frame: usize) -> BenchScene {
    let drawn_frame = if case.in_real_time() {
        frame - frame % TAKE % inputs.hold
    } else {
        frame
    };
    let instances = (0..case.instances()).map(|instance| PosedInstance {
        drawn: posed(case, inputs, drawn_frame, instance),
        reference: posed(case, inputs, frame, instance),
    });
    let camera = if case.own_camera() || inputs.cameras.is_empty() {
        camera(case, inputs, bounds, frame)
    } else if case.camera_moves() {
        inputs.cameras[frame % inputs.cameras.len()]
    } else {
        inputs.cameras[0]
    };
    BenchScene {
        instances: instances.collect(),
        camera,
    }
}

/// Frames of a case unless the user says otherwise. `sweep`: in each round of a sweep.
pub fn default_frames(case: BenchCase, sweep: bool) -> usize {
    match case {
        BenchCase::Zoom => 200,
        BenchCase::Flicker => 2 * TAKE,
        _ if sweep => 24,
        _ => 48,
    }
}

/// How tall the avatar is in the image, px, where the case says so.
fn tall(case: BenchCase, inputs: &SceneInputs, frame: usize) -> Option<f64> {
    if case != BenchCase::Zoom {
        return case.tall();
    }
    let [first, last] = ZOOM.map(|tall| tall.min(ZOOM_SHARE * f64::from(inputs.size[1])));
    let share = frame as f64 / (inputs.frames.max(2) - 1) as f64;
    Some(first * (last / first).powf(share))
}

/// Which of `frames` scenes to compare with the reference: `count` of them, spread over the run and
/// over the views; while poses are held, at the end of the hold rather than at its start.
pub fn checks(case: BenchCase, frames: usize, count: usize) -> Vec<usize> {
    let count = count.min(frames);
    let last = |check: usize| (check + 1) * frames / count - 1;
    // One frame earlier each time, for another view. Between takes the view changes anyway.
    let shift = |check: usize| {
        if case == BenchCase::Full {
            check % (frames / count)
        } else {
            0
        }
    };
    (0..count).map(|check| last(check) - shift(check)).collect()
}

/// Time in the clip, seconds. Static cases stay in its middle.
fn seconds(case: BenchCase, inputs: &SceneInputs, frame: usize) -> f64 {
    let duration = inputs.player.clip().duration();
    match case {
        BenchCase::Full => duration * frame as f64 / inputs.frames as f64,
        BenchCase::Camera | BenchCase::Expression | BenchCase::Static | BenchCase::Zoom => {
            0.5 * duration
        }
        _ => {
            let takes = inputs.frames.div_ceil(TAKE);
            let start =
                (duration - TAKE as f64 / RATE).max(0.0) * (frame / TAKE) as f64 / takes as f64;
            start + (frame % TAKE) as f64 / RATE
        }
    }
}

/// The pose of an instance in a frame. Each instance is at another time of the clip.
fn pose(case: BenchCase, inputs: &SceneInputs, frame: usize, instance: usize) -> Pose {
    let duration = inputs.player.clip().duration();
    let offset = duration * instance as f64 / case.instances() as f64;
    let mut clip_time = seconds(case, inputs, frame) + offset;
    if offset > 0.0 {
        clip_time %= duration;
    }
    let mut pose = inputs.player.pose(clip_time);
    if case == BenchCase::Expression {
        // Clips of bodies have no expression: slow waves of one deviation, each component at its
        // own rate.
        let wave = |k: usize| {
            let cycles = frame as f64 / 40.0 * (1 + k % 3) as f64 + 0.1 * k as f64;
            (TAU * cycles).sin()
        };
        pose.expression = (0..inputs.avatar.inputs.expression).map(wave).collect();
    }
    pose
}

fn posed(case: BenchCase, inputs: &SceneInputs, frame: usize, instance: usize) -> Posed {
    Posed::new(inputs.avatar, &pose(case, inputs, frame, instance))
        .placed(in_rows(instance, case.instances()))
}

fn camera(case: BenchCase, inputs: &SceneInputs, bounds: &AvatarBounds, frame: usize) -> Camera {
    if case == BenchCase::Close {
        return close_up(inputs, bounds, frame);
    }
    // Within a take the camera does not follow the avatar's steps.
    let framed = match case {
        BenchCase::Full => frame,
        BenchCase::Zoom => 0,
        _ => frame - frame % TAKE,
    };
    let own = |instance| bounds.framing(&posed(case, inputs, framed, instance).joints);
    let framing = framed_instances(case, frame)
        .map(own)
        .reduce(Framing::union)
        .unwrap_or_else(|| own(0));
    let [min, max] = framing.bounds;
    let view = match case {
        BenchCase::Full => frame % inputs.views,
        BenchCase::Static | BenchCase::Expression | BenchCase::Zoom => 0,
        _ => frame / TAKE % inputs.views,
    };
    let orbit = if matches!(case, BenchCase::Full | BenchCase::Zoom) || !case.camera_moves() {
        0.0
    } else {
        ORBIT_STEP * (frame % TAKE) as f64
    };
    let mut distance = Camera::framing_distance([min, max], FOV, inputs.size);
    if let Some(tall) = tall(case, inputs, frame) {
        let focal = 0.5 * f64::from(inputs.size[1]) / (0.5 * FOV).tan();
        let asked = focal * (max.y - min.y) / tall;
        distance = if case == BenchCase::Zoom {
            asked
        } else {
            distance.max(asked)
        };
    }
    let yaw = viewpoint::yaw_of_view(view, inputs.views) + orbit;
    Camera {
        near: framing.near,
        ..Camera::orbit(framing.middle(), yaw, PITCH, distance, FOV, inputs.size)
    }
}

/// The instances that the camera frames. Of a few, every other take frames only the first, so that
/// the others are partly or wholly outside the image.
fn framed_instances(case: BenchCase, frame: usize) -> Range<usize> {
    let all = case.instances();
    if case != BenchCase::Crowd && (frame / TAKE).is_multiple_of(2) {
        0..all.div_ceil(4)
    } else {
        0..all
    }
}

/// A camera straight in front of the face: of the joint `head`, or else of the upper end of the
/// bounds.
fn close_up(inputs: &SceneInputs, bounds: &AvatarBounds, frame: usize) -> Camera {
    let pose = pose(BenchCase::Close, inputs, frame, 0);
    let skeleton = &inputs.avatar.skeleton;
    let is_head = |name: &String| name.eq_ignore_ascii_case("head");
    let face;
    let forward;
    if let Some(head) = skeleton.name.iter().position(is_head) {
        let rotation = skeleton.matrices(&pose)[head].matrix3;
        let joint = skeleton.joints(&pose)[head].translation;
        face = joint + rotation * DVec3::new(0.0, 0.06, 0.08);
        forward = rotation * DVec3::Z;
    } else {
        let [min, max] = bounds.bounds(&Posed::new(inputs.avatar, &pose).joints);
        face = DVec3::new((min.x + max.x) / 2.0, max.y - 0.15, (min.z + max.z) / 2.0);
        forward = DVec3::Z;
    }
    Camera::look_at(face + FOREARM * forward, face, FOV, inputs.size)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_demo(frames: usize, hold: usize, test: impl Fn(SceneInputs)) {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let player = Player::new(
            effigy_demo::clip().expect("inside the program"),
            &avatar.skeleton,
        );
        test(SceneInputs {
            avatar: &avatar,
            player: &player,
            size: [200, 240],
            cameras: &[],
            frames,
            views: 4,
            hold,
        });
    }

    /// Differences between one frame and the next.
    #[derive(Debug, PartialEq)]
    struct Changes {
        joints: bool,
        input: bool,
        camera: bool,
    }

    fn expected(joints: bool, input: bool, camera: bool) -> Changes {
        Changes {
            joints,
            input,
            camera,
        }
    }

    fn changes(scenes: &[BenchScene]) -> Changes {
        let all = |same: fn(&BenchScene, &BenchScene) -> bool| {
            scenes.windows(2).all(|pair| !same(&pair[0], &pair[1]))
        };
        Changes {
            joints: all(|a, b| a.instances[0].drawn.joints == b.instances[0].drawn.joints),
            input: all(|a, b| a.instances[0].drawn.input == b.instances[0].drawn.input),
            camera: all(|a, b| a.camera == b.camera),
        }
    }

    #[test]
    fn each_case_changes_only_what_it_names() {
        with_demo(24, 1, |inputs| {
            let of = |case| changes(&scenes(case, &inputs));
            assert_eq!(of(BenchCase::Full), expected(true, true, true));
            assert_eq!(of(BenchCase::Orbit), expected(true, true, true));
            assert_eq!(of(BenchCase::Camera), expected(false, false, true));
            assert_eq!(of(BenchCase::Expression), expected(false, true, false));
            assert_eq!(of(BenchCase::Static), expected(false, false, false));
            assert_eq!(of(BenchCase::Flicker), expected(true, true, true));
            assert_eq!(of(BenchCase::Zoom), expected(false, false, true));
            let still = scenes(BenchCase::Static, &inputs);
            assert!(still.iter().all(|scene| scene.instances[0].drawn.input
                == still[0].instances[0].drawn.input
                && scene.camera == still[0].camera));
        });
    }

    #[test]
    fn far_avatars_and_close_faces_have_their_distance() {
        with_demo(12, 1, |inputs| {
            let bounds = |scene: &BenchScene| {
                AvatarBounds::new(inputs.avatar)
                    .framing(&scene.instances[0].drawn.joints)
                    .bounds
            };
            let middle = |scene: &BenchScene| bounds(scene).into_iter().sum::<DVec3>() / 2.0;
            let height_in = |case, inputs: &SceneInputs| {
                let scene = &scenes(case, inputs)[0];
                let [min, max] = bounds(scene);
                let middle = (min + max) / 2.0;
                let at = |y| {
                    scene
                        .camera
                        .project(
                            scene
                                .camera
                                .view
                                .transform_point3(DVec3::new(middle.x, y, middle.z)),
                        )
                        .y
                };
                at(min.y) - at(max.y)
            };
            let height = |case| height_in(case, &inputs);
            // A crowd needs more room, and some of it stands nearer.
            let large = SceneInputs {
                size: [2048, 2048],
                ..inputs
            };
            let of_the_crowd = height_in(BenchCase::Crowd, &large);
            assert!((45.0..65.0).contains(&of_the_crowd), "{of_the_crowd}");
            for case in BenchCase::ALL {
                let tall = case.tall().filter(|tall| *tall < 200.0);
                if let Some(tall) = tall.filter(|_| case != BenchCase::Crowd) {
                    assert!(
                        (height(case) - tall).abs() < 2.0,
                        "{case}: {}",
                        height(case)
                    );
                }
            }
            assert!(height(BenchCase::Orbit) > 120.0);
            let zoom = scenes(BenchCase::Zoom, &inputs);
            let distances = zoom
                .iter()
                .map(|scene| scene.camera.eye().distance(middle(scene)));
            let ratios: Vec<f64> = distances
                .collect::<Vec<_>>()
                .windows(2)
                .map(|pair| pair[1] / pair[0])
                .collect();
            // 235 px at first, 20 at last, and each frame smaller than the last by one factor.
            let ratio = (ZOOM_SHARE * 240.0 / 20.0).powf(1.0 / 11.0);
            assert!(
                ratios.iter().all(|own| (own - ratio).abs() < 1e-9),
                "{ratios:?}, expected {ratio}"
            );
            let skeleton = &inputs.avatar.skeleton;
            let head = skeleton
                .name
                .iter()
                .position(|name| name.eq_ignore_ascii_case("head"))
                .expect("the demo has a head");
            for (frame, scene) in scenes(BenchCase::Close, &inputs).iter().enumerate() {
                let joint =
                    skeleton.joints(&pose(BenchCase::Close, &inputs, frame, 0))[head].translation;
                let view_space = scene.camera.view.transform_point3(joint);
                let at = scene.camera.project(view_space);
                assert!(
                    (FOREARM..FOREARM + 0.2).contains(&view_space.z),
                    "the head is {} m away",
                    view_space.z
                );
                assert!(
                    (0.0..200.0).contains(&at.x) && (0.0..240.0).contains(&at.y),
                    "the head is at {at}"
                );
            }
        });
    }

    #[test]
    fn a_pose_is_held_while_the_reference_moves_on() {
        with_demo(24, 3, |inputs| {
            let scenes = scenes(BenchCase::Orbit, &inputs);
            for (frame, scene) in scenes.iter().enumerate() {
                assert_eq!(
                    scene.instances[0].drawn.joints,
                    scenes[frame - frame % 3].instances[0].reference.joints,
                    "frame {frame}"
                );
                assert_eq!(
                    frame % 3 == 0,
                    scene.instances[0].drawn.joints == scene.instances[0].reference.joints,
                    "frame {frame}"
                );
            }
            assert!(
                checks(BenchCase::Orbit, 24, 2)
                    .iter()
                    .all(|frame| frame % 3 == 2),
                "checks must be at the end of a hold"
            );
        });
    }

    #[test]
    fn four_avatars_stand_apart_and_move_differently() {
        with_demo(4, 1, |inputs| {
            let scenes = scenes(
                BenchCase::Four,
                &SceneInputs {
                    frames: 2 * TAKE,
                    ..inputs
                },
            );
            let bounds = AvatarBounds::new(inputs.avatar);
            let in_view = |scene: &BenchScene| {
                scene
                    .instances
                    .iter()
                    .filter(|instance| {
                        !bounds
                            .visible(&instance.drawn.joints, &scene.camera)
                            .parts
                            .is_empty()
                    })
                    .count()
            };
            let visible = [in_view(&scenes[0]), in_view(&scenes[TAKE])];
            assert!(visible[0] < 4 && visible[1] == 4, "{visible:?}");
            let stand = |instance: &PosedInstance| {
                bounds
                    .bounds(&instance.drawn.joints)
                    .into_iter()
                    .sum::<DVec3>()
                    / 2.0
            };
            for pair in scenes[0].instances.windows(2) {
                let apart = (stand(&pair[1]) - stand(&pair[0])).length();
                assert!(
                    apart > 0.4 && pair[0].drawn.input != pair[1].drawn.input,
                    "{apart} m apart"
                );
            }
        });
    }

    #[test]
    fn given_cameras_are_used_in_turn() {
        with_demo(5, 1, |inputs| {
            let cameras: Vec<_> = (0..2)
                .map(|k| Camera::orbit(DVec3::Y, f64::from(k), 0.0, 3.0, 0.5, inputs.size))
                .collect();
            let inputs = SceneInputs {
                cameras: &cameras,
                ..inputs
            };
            let used = |case| {
                scenes(case, &inputs)
                    .iter()
                    .map(|scene| cameras.iter().position(|camera| *camera == scene.camera))
                    .collect::<Vec<_>>()
            };
            assert_eq!(
                used(BenchCase::Full),
                [Some(0), Some(1), Some(0), Some(1), Some(0)]
            );
            assert_eq!(used(BenchCase::Static), [Some(0); 5]);
            assert_eq!(used(BenchCase::Close), [None; 5]);
        });
    }

    #[test]
    fn checked_frames_are_spread_and_show_every_view() {
        let views = |frames, count| {
            checks(BenchCase::Full, frames, count)
                .iter()
                .map(|frame| frame % 4)
                .collect::<std::collections::BTreeSet<_>>()
        };
        assert_eq!(views(32, 4).len(), 4);
        for (frames, count) in [(1, 1), (3, 8), (32, 0), (10, 4), (5, 5)] {
            for case in BenchCase::ALL {
                let checks = checks(case, frames, count);
                assert_eq!(
                    checks.len(),
                    count.min(frames),
                    "{frames} frames, {count} checks"
                );
                assert!(
                    checks.iter().all(|&check| check < frames) && checks.is_sorted_by(|a, b| a < b),
                    "{checks:?}"
                );
            }
        }
    }
}
