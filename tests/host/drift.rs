//! Time and motion over a million frames: the moment drawn is the one that the clock says, to the
//! microsecond and far below it, however many frames and repetitions came before, and the pose at
//! it is the same each time round.

use crate::common::Sizes;
#[cfg(feature = "window")]
use crate::common::{self, Random};
#[cfg(feature = "window")]
use effigy_app::playback::{ClipTiming, Playback, Repeat};
use effigy_core::avatar::{Pose, motion::Player};

#[cfg(feature = "window")]
const FRAMES: u64 = 1_000_000;

/// A track whose duration is a whole number of ticks of a clock.
#[cfg(feature = "window")]
fn track(ticks: u64, tick: f64) -> ClipTiming {
    ClipTiming {
        name: format!("{ticks} ticks"),
        duration: ticks as f64 * tick,
        rate: 1.0 / tick,
    }
}

#[cfg(feature = "window")]
fn playing(tracks: Vec<ClipTiming>, repeat: Repeat) -> Playback {
    let mut playback = Playback::new(tracks);
    playback.set_repeat(repeat);
    playback.play(true, 0.0);
    playback
}

/// How far two times of a clip are apart, around its end.
#[cfg(feature = "window")]
fn apart(a: f64, b: f64, duration: f64) -> f64 {
    let difference = (a - b).abs();
    difference.min(duration - difference)
}

#[cfg(feature = "window")]
fn a_million_frames_at_display_rates_end_where_whole_numbers_say() {
    // 60 Hz, 59.94 Hz, 144 Hz, 90 Hz; loops of 1.15 s to a minute.
    for (tick, ticks) in [
        (1.0 / 60.0, 69),
        (1001.0 / 60_000.0, 601),
        (1.0 / 144.0, 8639),
        (1.0 / 90.0, 197),
    ] {
        let mut playback = playing(vec![track(ticks, tick)], Repeat::Clip);
        let duration = ticks as f64 * tick;
        let mut worst = 0.0f64;
        for frame in 0..=FRAMES {
            let moment = playback.advance(frame as f64 * tick);
            assert!(
                (0.0..=duration).contains(&moment.time),
                "frame {frame}: {} s",
                moment.time
            );
            worst = worst.max(apart(moment.time, (frame % ticks) as f64 * tick, duration));
        }
        assert!(worst < 1e-9, "{ticks} ticks of {tick} s: {worst} s off");
    }
}

#[cfg(feature = "window")]
fn odd_steps_and_dropped_frames_change_nothing() {
    let random = &mut Random(1);
    let mut every = playing(vec![track(69, 1.0 / 60.0)], Repeat::Clip);
    let mut some = every.clone();
    let mut clock = 0.0;
    for frame in 0..FRAMES {
        // From a microsecond to a stall of ten seconds.
        clock += if frame % 1000 == 0 {
            10.0
        } else {
            random.range(1e-6, 0.03)
        };
        let moment = every.advance(clock);
        if frame % 997 == 0 {
            assert_eq!(
                some.advance(clock),
                moment,
                "frame {frame}: the moment hangs on how many frames were drawn"
            );
        }
        let exact = clock % (69.0 / 60.0);
        assert!(
            apart(moment.time, exact, 69.0 / 60.0) < 1e-9,
            "frame {frame} at {clock} s: {} instead of {exact}",
            moment.time
        );
    }
}

#[cfg(feature = "window")]
fn speeds_and_clips_in_turn_do_not_drift() {
    let tick = 1.0 / 64.0;
    let ticks = [100, 37, 411];
    let all: u64 = ticks.iter().sum();
    let mut playback = playing(ticks.map(|ticks| track(ticks, tick)).to_vec(), Repeat::All);
    playback.set_speed(0.75, 0.0);
    for frame in 0..FRAMES {
        // Three quarters of a tick a frame: four frames make three ticks.
        let moment = playback.advance(frame as f64 * tick);
        let mut quarters = 3 * frame % (4 * all);
        let mut clip = 0;
        while quarters >= 4 * ticks[clip] {
            quarters -= 4 * ticks[clip];
            clip += 1;
        }
        assert_eq!(
            (moment.clip, moment.time),
            (clip, quarters as f64 / 4.0 * tick),
            "frame {frame}: powers of two are exact"
        );
    }
}

#[cfg(feature = "window")]
fn changing_what_repeats_or_how_fast_keeps_the_moment() {
    let mut playback = playing(
        vec![track(60, 1.0 / 60.0), track(45, 1.0 / 60.0)],
        Repeat::Clip,
    );
    let before = playback.advance(1234.567);
    for repeat in [Repeat::Off, Repeat::All, Repeat::Clip] {
        playback.set_repeat(repeat);
        assert_eq!(playback.advance(1234.567), before, "{repeat:?}");
    }
    playback.set_speed(2.0, 1234.567);
    assert_eq!(playback.advance(1234.567), before);
    playback.set_repeat(Repeat::Off);
    assert!(playback.is_playing(), "it has half a second to go");
    assert_eq!(playback.advance(1240.0).time, 1.0);
    assert!(!playback.is_playing());
    for clock in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        playback.play(true, 1250.0);
        assert!(
            playback.advance(clock).time.is_finite(),
            "a clock of {clock}"
        );
    }
}

/// The largest difference of any number of two poses, joints compared as rotations.
fn difference(a: &Pose, b: &Pose) -> f64 {
    let turned = |(a, b): (&glam::DVec3, &glam::DVec3)| {
        let [a, b] = [a, b].map(|r| glam::DQuat::from_scaled_axis(*r));
        (a - b).length().min((a + b).length())
    };
    let rotation = a
        .rotation
        .iter()
        .zip(&b.rotation)
        .map(turned)
        .fold(0.0, f64::max);
    let expression = a
        .expression
        .iter()
        .zip(&b.expression)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    rotation
        .max(expression)
        .max(a.translation.distance(b.translation))
}

#[cfg(feature = "window")]
fn every_time_round_has_the_same_poses() {
    let avatar = common::avatar(
        1,
        Sizes {
            gaussians: 100,
            joints: 12,
            ..Sizes::default()
        },
    );
    // 120 frames of 1/30 s: from the first to the last are 119, which at 60 Hz are 238 ticks.
    let player = Player::new(common::clip(1, &avatar, 120), &avatar.skeleton);
    let mut playback = playing(vec![ClipTiming::from(player.clip())], Repeat::Clip);
    let tick = 1.0 / 60.0;
    let first: Vec<Pose> = (0..238)
        .map(|at| player.pose(playback.advance(f64::from(at) * tick).time))
        .collect();
    for frame in 238..FRAMES {
        let moment = playback.advance(frame as f64 * tick);
        // Every loop's end and start, and one frame in 61 elsewhere.
        let at = (frame % 238) as usize;
        if (1..237).contains(&at) && frame % 61 == 0 {
            let off = difference(&player.pose(moment.time), &first[at]);
            assert!(off < 1e-9, "frame {frame}: {off} off");
        }
    }
}

fn a_frame_of_the_clip_is_met_from_both_sides() {
    let avatar = common::avatar(
        2,
        Sizes {
            gaussians: 100,
            joints: 22,
            ..Sizes::default()
        },
    );
    let mut clip = common::clip(2, &avatar, 30);
    // Joints that turn on past π, where the numbers of a frame and of its neighbours may be of
    // different turns.
    for (at, rotation) in clip.rotation.iter_mut().enumerate() {
        let angle = at as f32 * 0.013;
        *rotation = [angle.rem_euclid(7.0), 0.1, 0.0];
    }
    let player = Player::new(clip, &avatar.skeleton);
    for frame in 1..29 {
        let at = f64::from(frame) / 30.0;
        let [before, here, after] = [at - 1e-9, at, at + 1e-9].map(|time| player.pose(time));
        for beside in [before, after] {
            assert!(
                difference(&beside, &here) < 1e-6,
                "frame {frame}: {}",
                difference(&beside, &here)
            );
            // What the networks see does not depend on which way a rotation was written, but for
            // the half turn, which has two.
            let [a, b] = [&beside, &here].map(|pose| avatar.inputs.from_pose(pose));
            for (joint, (a, b)) in a
                .chunks(3)
                .zip(b.chunks(3))
                .take(avatar.inputs.joint.len())
                .enumerate()
            {
                let [a, b] = [a, b].map(|v| glam::DVec3::from_slice(v));
                let half_turn = (a.length() - std::f64::consts::PI).abs() < 1e-6;
                assert!(
                    half_turn || a.distance(b) < 1e-6,
                    "frame {frame}, joint {joint}: the networks see {a} beside {b}"
                );
            }
        }
    }
}

fn times_that_are_none_and_times_past_the_ends_have_poses() {
    let avatar = common::avatar(
        3,
        Sizes {
            gaussians: 100,
            joints: 5,
            ..Sizes::default()
        },
    );
    let player = Player::new(common::clip(3, &avatar, 7), &avatar.skeleton);
    let [start, end] = [0.0, player.clip().duration()].map(|time| player.pose(time));
    for (time, expected) in [
        (f64::NAN, &start),
        (-1e300, &start),
        (f64::NEG_INFINITY, &start),
        (1e300, &end),
        (f64::INFINITY, &end),
    ] {
        assert!(
            difference(&player.pose(time), expected) < 1e-12,
            "at {time}"
        );
    }
}

tests! {
    #[cfg(feature = "window")]
    a_million_frames_at_display_rates_end_where_whole_numbers_say,
    #[cfg(feature = "window")]
    odd_steps_and_dropped_frames_change_nothing,
    #[cfg(feature = "window")]
    speeds_and_clips_in_turn_do_not_drift,
    #[cfg(feature = "window")]
    changing_what_repeats_or_how_fast_keeps_the_moment,
    #[cfg(feature = "window")]
    every_time_round_has_the_same_poses,
    a_frame_of_the_clip_is_met_from_both_sides,
    times_that_are_none_and_times_past_the_ends_have_poses,
}
