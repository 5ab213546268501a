//! What the viewer plays and shows, without a window: clips over time, and the scene that a frame
//! is drawn from.

use crate::common::{self, Sizes};
use effigy_app::{
    action::Action,
    gesture::Gesture,
    playback::{ClipTime, ClipTiming, Playback, Repeat, SPEED},
    scene::{ViewerBackground, ViewerScene},
    views::StandardView,
};
use effigy_core::{
    avatar::{Avatar, Clip, motion::Player},
    scene::Posed,
};
use glam::{DVec2, DVec3};
use std::{f64::consts::FRAC_PI_2, sync::Arc};

fn playing(durations: &[f64], repeat: Repeat) -> Playback {
    let track = |(i, &duration)| ClipTiming {
        name: format!("clip {i}"),
        duration,
        rate: 30.0,
    };
    let mut playback = Playback::new(durations.iter().enumerate().map(track).collect());
    playback.set_repeat(repeat);
    playback.play(true, 0.0);
    playback
}

fn ten_hours_of_playing_do_not_drift() {
    let mut playback = playing(&[3.1], Repeat::Clip);
    let frame = 1.0 / 59.94;
    let mut clock = 0.0;
    for i in 0..2_000_000_u32 {
        clock = f64::from(i) * frame;
        playback.advance(clock);
    }
    let expected = clock % 3.1;
    let got = playback.position().time;
    let off = (got - expected).abs();
    assert!(
        off.min(3.1 - off) < 1e-6,
        "{got} instead of {expected} after {clock} s"
    );
}

fn speed_changes_without_a_jump() {
    let mut playback = playing(&[100.0], Repeat::Clip);
    playback.advance(10.0);
    playback.set_speed(0.5, 10.0);
    assert_eq!(playback.advance(10.0).time, 10.0);
    assert_eq!(playback.advance(14.0).time, 12.0);
    playback.set_speed(1e9, 14.0);
    assert_eq!(playback.speed(), SPEED[1]);
    playback.set_speed(f64::NAN, 14.0);
    assert_eq!(playback.speed(), SPEED[1]);
}

fn a_clip_that_does_not_repeat_stops_at_its_end_and_can_be_played_again() {
    let mut playback = playing(&[2.0], Repeat::Off);
    assert_eq!(playback.advance(5.0).time, 2.0);
    assert!(!playback.is_playing() && !playback.is_moving());
    playback.play(true, 9.0);
    assert_eq!(playback.advance(9.5).time, 0.5);
}

fn all_clips_follow_one_another_and_the_time_left_over_is_not_lost() {
    let mut playback = playing(&[1.0, 0.0, 2.0], Repeat::All);
    assert_eq!(
        playback.advance(1.25),
        ClipTime {
            clip: 2,
            time: 0.25
        }
    );
    assert_eq!(playback.advance(3.5), ClipTime { clip: 0, time: 0.5 });
    assert_eq!(
        playback.advance(3.5 + 3000.0),
        ClipTime { clip: 0, time: 0.5 }
    );
    assert_eq!(
        playback.advance(3.5 + 3001.0),
        ClipTime { clip: 2, time: 0.5 }
    );
}

fn a_paused_clip_and_a_single_pose_do_not_move() {
    let mut playback = playing(&[2.0, 0.0], Repeat::All);
    playback.play(false, 0.5);
    assert_eq!(playback.advance(100.0).time, 0.5);
    assert!(!playback.is_moving());
    playback.skip_clips(1, 100.0);
    playback.play(true, 100.0);
    assert!(!playback.is_moving());
    assert_eq!(playback.advance(200.0), ClipTime { clip: 1, time: 0.0 });
    let mut empty = playing(&[], Repeat::All);
    empty.skip_clips(1, 1.0);
    empty.step(1, 1.0);
    empty.scrub(1.0, 1.0);
    assert_eq!(empty.advance(2.0), ClipTime { clip: 0, time: 0.0 });
}

fn stepping_goes_from_frame_to_frame() {
    let mut playback = playing(&[2.0], Repeat::Clip);
    playback.advance(0.51);
    playback.step(1, 0.51);
    assert!(!playback.is_playing());
    let frame = |playback: &Playback| (playback.position().time * 30.0 * 1e6).round() / 1e6;
    assert_eq!(frame(&playback), 16.0);
    playback.step(-1, 0.6);
    assert_eq!(frame(&playback), 15.0);
    playback.step(-16, 0.6);
    assert_eq!(
        frame(&playback),
        60.0,
        "before the first frame comes the last"
    );
    playback.step(1, 0.6);
    assert_eq!(frame(&playback), 0.0);
}

fn scrubbing_goes_round_the_ends_only_where_the_clip_repeats() {
    let mut playback = playing(&[4.0], Repeat::Clip);
    playback.scrub(-1.0, 0.0);
    assert_eq!(playback.position().time, 3.0);
    assert_eq!(playback.advance(0.5).time, 3.5, "it plays on from there");
    playback.set_repeat(Repeat::Off);
    playback.scrub(9.0, 0.5);
    assert_eq!(playback.position().time, 4.0);
    playback.seek(f64::NAN, 1.0);
    assert_eq!(playback.position().time, 4.0);
}

fn next_and_previous_go_round() {
    let mut playback = playing(&[1.0, 1.0, 1.0], Repeat::Clip);
    playback.advance(0.7);
    playback.skip_clips(-1, 0.7);
    assert_eq!(playback.position(), ClipTime { clip: 2, time: 0.0 });
    playback.skip_clips(1, 0.8);
    assert_eq!(playback.advance(1.0).clip, 0);
    playback.choose(17, 1.0);
    assert_eq!(playback.position().clip, 0);
}

const SIZE: [u32; 2] = [640, 480];

/// A seeded avatar with two clips of two seconds.
fn scene() -> ViewerScene {
    let avatar = common::avatar(
        1,
        Sizes {
            gaussians: 200,
            ..Sizes::default()
        },
    );
    let clips = vec![common::clip(1, &avatar, 61), common::clip(2, &avatar, 61)];
    ViewerScene::new(avatar, clips, [0.5; 3], SIZE, 0.0)
}

fn a_scene_at_rest_looks_the_same_at_every_time() {
    let mut scene = scene();
    assert!(scene.is_moving());
    let playing = [scene.advance(0.5, SIZE), scene.advance(1.0, SIZE)];
    assert!(playing[0] != playing[1], "it plays from the start");
    scene.act(Action::PlayOrPause, 1.0, SIZE);
    let paused = scene.advance(1.0, SIZE);
    assert!(!scene.is_moving());
    assert_eq!(scene.advance(50.0, SIZE), paused);
    let joints = scene.posed().joints.clone();
    scene.act(Action::Step(1), 50.0, SIZE);
    assert!(
        scene.advance(50.0, SIZE) != paused && scene.posed().joints != joints,
        "a step shows another pose"
    );
}

fn a_held_pose_stays_while_the_view_moves_and_falls_behind_nothing() {
    let mut scene = scene();
    let shown = scene.advance(0.5, SIZE);
    scene.gesture(
        &Gesture {
            orbit: DVec2::new(200.0, 0.0),
            ..Gesture::default()
        },
        SIZE,
    );
    let held = scene.hold_pose(0.6, SIZE);
    assert!(held.position == shown.position && held.camera != shown.camera);
    assert!(
        (scene.advance(0.7, SIZE).position.time - 0.7).abs() < 1e-9,
        "the clip goes by the clock, not by frames"
    );
    scene.act(Action::PlayOrPause, 0.7, SIZE);
    scene.act(Action::Step(1), 0.7, SIZE);
    let stepped = scene.hold_pose(0.8, SIZE).position;
    assert_eq!(
        stepped,
        scene.advance(0.8, SIZE).position,
        "what the user asks for is shown at once"
    );
}

fn a_gesture_after_a_long_rest_glides_and_does_not_jump() {
    let mut scene = scene();
    scene.act(Action::PlayOrPause, 0.0, SIZE);
    let before = scene.advance(0.0, SIZE).camera.eye();
    scene.skip_to(1000.0);
    scene.gesture(
        &Gesture {
            orbit: DVec2::new(200.0, 0.0),
            ..Gesture::default()
        },
        SIZE,
    );
    let first = scene.advance(1000.01, SIZE).camera.eye();
    (0..100).for_each(|frame| {
        scene.advance(1000.02 + 0.02 * f64::from(frame), SIZE);
    });
    let last = scene.advance(1003.0, SIZE).camera.eye();
    let (moved, whole) = (first.distance(before), last.distance(before));
    assert!(
        moved > 0.05 * whole && moved < 0.5 * whole,
        "{moved} m of {whole} m in the first 10 ms"
    );
    assert!(!scene.is_moving());
}

fn the_view_follows_the_avatar_until_following_is_off() {
    let offset = |scene: &mut ViewerScene, clock| {
        let eye = scene.advance(clock, SIZE).camera.eye();
        let rest = scene.avatar().skeleton.rest[0].map(f64::from);
        (eye - scene.posed().joints[0].transform_point3(rest.into())).with_y(0.0)
    };
    let mut scene = scene();
    let [start, later] = [0.0, 0.9].map(|clock| offset(&mut scene, clock));
    assert!(
        start.distance(later) < 1e-9,
        "it was {start} from the avatar, now {later}"
    );
    scene.act(Action::Follow(false), 0.9, SIZE);
    let [here, there] = [1.0, 1.8].map(|clock| scene.advance(clock, SIZE).camera.eye());
    assert!(here == there, "the camera stands still");
}

fn a_newer_state_of_the_avatar_keeps_view_clip_time_and_options() {
    let mut scene = scene();
    scene.act(Action::Background([0.1, 0.2, 0.3]), 0.0, SIZE);
    scene.act(Action::Next(1), 0.0, SIZE);
    scene.gesture(
        &Gesture {
            orbit: DVec2::new(200.0, 30.0),
            ..Gesture::default()
        },
        SIZE,
    );
    (0..200).for_each(|frame| {
        scene.advance(0.01 * f64::from(frame), SIZE);
    });
    let shown = scene.advance(1.25, SIZE);
    let joints = scene.posed().joints.clone();
    let mut newer = Avatar::clone(scene.avatar());
    newer.gaussians.color[0] = [half::f16::ONE; 3];
    let newer = Arc::new(newer);
    scene.replace_avatar(newer.clone());
    assert!(Arc::ptr_eq(scene.avatar(), &newer));
    assert!(scene.playback().is_playing() && scene.posed().joints == joints);
    assert_eq!(scene.advance(1.25, SIZE), shown);
    assert_eq!(scene.advance(1.5, SIZE).position.time, 1.5);
    // Paused, it stands where it stood.
    scene.act(Action::PlayOrPause, 1.5, SIZE);
    let paused = scene.advance(1.5, SIZE);
    scene.replace_avatar(newer);
    assert!(!scene.is_moving());
    assert_eq!(scene.advance(9.0, SIZE), paused);
}

fn a_newer_state_may_have_joints_elsewhere_and_in_another_order() {
    let mut scene = scene();
    scene.advance(0.7, SIZE);
    let mut newer = Avatar::clone(scene.avatar());
    let last = newer.skeleton.len() - 1;
    newer.skeleton.rest[last][1] += 0.1;
    newer.skeleton.name[last] = "another".into();
    scene.replace_avatar(Arc::new(newer));
    let clip = scene.player().unwrap().clip().clone();
    let expected = Player::new(clip, &scene.avatar().skeleton).pose(0.7);
    assert_eq!(expected.rotation[last], DVec3::ZERO, "no clip moves it");
    assert_eq!(
        scene.posed().joints,
        Posed::new(scene.avatar(), &expected).joints
    );
}

/// The demo, turned a quarter to its left, as it stands.
fn turned_demo() -> ViewerScene {
    let avatar = effigy_demo::avatar().unwrap();
    let mut clip = Clip::still(&avatar.skeleton);
    clip.rotation[0] = [0.0, FRAC_PI_2 as f32, 0.0];
    ViewerScene::new(avatar, vec![clip], [0.5; 3], SIZE, 0.0)
}

fn views_go_by_how_the_avatar_stands() {
    let mut scene = turned_demo();
    let mut clock = 0.0;
    let mut seen = |view: StandardView| {
        scene.act(Action::View(view), clock, SIZE);
        (0..100).for_each(|_| {
            clock += 0.05;
            scene.advance(clock, SIZE);
        });
        assert!(!scene.is_moving(), "{view:?}");
        let camera = scene.advance(clock, SIZE).camera;
        let names = &scene.avatar().skeleton.name;
        let head = names.iter().position(|name| name == "Head").unwrap();
        let rest = scene.avatar().skeleton.rest[head].map(f64::from);
        let head = scene.posed().joints[head].transform_point3(rest.into());
        (camera, camera.view.transform_point3(head))
    };
    // Its front is the world's +x now, its left −z.
    for (view, axis) in [
        (StandardView::Front, DVec3::X),
        (StandardView::Left, DVec3::NEG_Z),
        (StandardView::Back, DVec3::NEG_X),
        (StandardView::Right, DVec3::Z),
        (StandardView::Top, DVec3::Y),
    ] {
        let (camera, _) = seen(view);
        let forward = camera.view.matrix3.transpose().z_axis;
        assert!(forward.dot(axis) < -0.95, "{view:?}: {forward}");
    }
    let (front, far) = seen(StandardView::Front);
    let (face, near) = seen(StandardView::Face);
    assert!(near.z < 0.3 * far.z, "{near} is no nearer than {far}");
    // The joint is at the head's lower end.
    let below = face.project(near) - face.center;
    assert!(
        below.x.abs() < 60.0 && (0.0..200.0).contains(&below.y),
        "{below} px"
    );
    assert!(front.project(far).distance(front.center) > 100.0);
}

fn keys_zoom_to_the_middle() {
    let mut scene = scene();
    scene.act(Action::PlayOrPause, 0.0, SIZE);
    let before = scene.advance(0.0, SIZE).camera;
    scene.act(Action::Zoom(0.5), 0.0, SIZE);
    (1..100).for_each(|frame| {
        scene.advance(0.05 * f64::from(frame), SIZE);
    });
    let after = scene.advance(6.0, SIZE).camera;
    let forward = before.view.matrix3.transpose().z_axis;
    let way = after.eye() - before.eye();
    assert!(
        way.length() > 0.5 && way.normalize().distance(forward) < 1e-6,
        "{way}"
    );
}

fn backgrounds_go_round_and_stay_within_their_range() {
    let mut scene = scene();
    let mut seen = Vec::new();
    for _ in 0..8 {
        scene.act(Action::NextBackground, 0.0, SIZE);
        seen.push(scene.background());
    }
    assert_eq!(seen[..4], seen[4..]);
    assert!((1..4).all(|k| seen[k] != seen[0]), "{seen:?}");
    scene.act(Action::Background([-1.0, 0.5, 9.0]), 0.0, SIZE);
    assert_eq!(scene.background().color, [0.0, 0.5, 1.0]);
}

/// First and after the last colour; a colour of one's own takes its place.
fn a_picture_is_one_of_the_backgrounds() {
    let mut scene = scene();
    let background = ViewerBackground {
        has_picture: true,
        shows_picture: true,
        ..scene.background()
    };
    scene = ViewerScene::new(scene.avatar().clone(), Vec::new(), background, SIZE, 0.0);
    let mut seen = vec![scene.advance(0.0, SIZE).background];
    for _ in 0..5 {
        scene.act(Action::NextBackground, 0.0, SIZE);
        seen.push(scene.advance(0.0, SIZE).background);
    }
    assert!(seen[1..5].iter().all(Option::is_some), "{seen:?}");
    assert_eq!([seen[0], seen[5]], [None, None]);
    scene.act(Action::Background([0.5; 3]), 0.0, SIZE);
    assert_eq!(scene.advance(0.0, SIZE).background, Some([0.5; 3]));
}

tests! {
    ten_hours_of_playing_do_not_drift,
    speed_changes_without_a_jump,
    a_clip_that_does_not_repeat_stops_at_its_end_and_can_be_played_again,
    all_clips_follow_one_another_and_the_time_left_over_is_not_lost,
    a_paused_clip_and_a_single_pose_do_not_move,
    stepping_goes_from_frame_to_frame,
    scrubbing_goes_round_the_ends_only_where_the_clip_repeats,
    next_and_previous_go_round,
    a_scene_at_rest_looks_the_same_at_every_time,
    a_held_pose_stays_while_the_view_moves_and_falls_behind_nothing,
    a_gesture_after_a_long_rest_glides_and_does_not_jump,
    the_view_follows_the_avatar_until_following_is_off,
    a_newer_state_of_the_avatar_keeps_view_clip_time_and_options,
    a_newer_state_may_have_joints_elsewhere_and_in_another_order,
    views_go_by_how_the_avatar_stands,
    keys_zoom_to_the_middle,
    backgrounds_go_round_and_stay_within_their_range,
    a_picture_is_one_of_the_backgrounds,
}
