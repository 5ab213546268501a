//! The governor against a simulated phone: frame by frame at 120 Hz, and against every reading that
//! a system may give.

use effigy_measure::soak::{Session, SoakSettings, cadence::Cadence, report::Second};
use effigy_runtime::{
    governor::{FrameQuality, Governor, Sample},
    thermals::{Phone, PhoneModel, Simulated},
};
use proptest::prelude::*;
use std::time::Duration;

const RATE: f64 = 120.0;

/// What became of a simulated run.
#[derive(Debug, Default)]
struct Run {
    frames: u64,
    dropped: u64,
    /// When and to which rung it stepped.
    steps: Vec<(f64, usize)>,
    seconds: f64,
    /// Lowest rate of a minute, frames a second.
    slowest: f64,
}

impl Run {
    fn late(&self) -> f64 {
        self.dropped as f64 / (self.frames + self.dropped) as f64
    }

    /// Steps in another direction than the one before.
    fn turns(&self) -> usize {
        let rungs: Vec<usize> = std::iter::once(0)
            .chain(self.steps.iter().map(|step| step.1))
            .collect();
        let downs: Vec<bool> = rungs.windows(2).map(|pair| pair[1] > pair[0]).collect();
        downs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    fn rung_at(&self, seconds: f64) -> usize {
        self.steps
            .iter()
            .rev()
            .find(|step| step.0 <= seconds)
            .map_or(0, |step| step.1)
    }
}

/// Draws for some minutes. `work`: GPU time of a whole frame at the highest clock at a time, as a
/// share of a refresh; `cost`: what a quality really takes of that; `air`: °C.
fn run(
    minutes: f64,
    governed: bool,
    work: impl Fn(f64) -> f64,
    cost: impl Fn(&FrameQuality) -> f64,
    air: impl Fn(f64) -> f64,
) -> Run {
    let refresh = 1.0 / RATE;
    let (mut model, mut governor, mut cadence) = (
        PhoneModel::new(Phone::default()),
        Governor::new(RATE),
        Cadence::new(refresh),
    );
    let mut run = Run {
        slowest: f64::INFINITY,
        ..Run::default()
    };
    let (mut now, mut read, mut done, mut minute, mut drawn) = (0.0, 0.0, 0.0_f64, 0.0, 0u64);
    while now < 60.0 * minutes {
        let quality = if governed {
            governor.quality()
        } else {
            FrameQuality::FULL
        };
        let frame = refresh * f64::from(quality.refreshes);
        let asked = work(now) * cost(&quality);
        let busy = refresh * asked / model.clock();
        // The device takes one frame after the other; two may be under way.
        let begin = cadence.next_frame().map_or(now, |next| next.max(now));
        let handed = (done - frame.max(busy)).max(begin);
        done = done.max(begin) + busy;
        cadence.set_period(frame);
        let dropped = cadence.add_frame(handed);
        model.set_air(air(now));
        model.advance(
            Duration::from_secs_f64((handed - now).max(1e-6)),
            asked / f64::from(quality.refreshes),
        );
        run.frames += 1;
        run.dropped += u64::from(dropped);
        drawn += 1;
        now = handed;
        if now - read >= 1.0 {
            read = now;
            governor.add_headroom(
                now,
                model.headroom() + 0.004 * (now.to_bits() % 5) as f64 - 0.008,
            );
        }
        if governor.add_frame(Sample {
            seconds: now,
            busy_ms: Some(1e3 * busy),
            dropped,
        }) && governed
        {
            run.steps.push((now, governor.rung()));
        }
        if now - minute >= 60.0 {
            run.slowest = run.slowest.min(drawn as f64 / (now - minute));
            (minute, drawn) = (now, 0);
        }
    }
    run.seconds = now;
    run
}

fn pixels(quality: &FrameQuality) -> f64 {
    let held = if quality.hold > 1 { 0.6 } else { 1.0 };
    let thin = 0.75f64.powi(quality.level as i32);
    (0.2 + 0.8 * quality.scale * quality.scale) * thin * held
}

/// A device on which giving things up gains little.
fn stubborn(quality: &FrameQuality) -> f64 {
    1.0 - 0.5 * (1.0 - pixels(quality))
}

fn the_papers_phone_throttles_when_nothing_governs_it() {
    let run = run(20.0, false, |_| 0.89, pixels, |_| 25.0);
    assert!((84.0..96.0).contains(&run.slowest), "{run:?}");
    assert!(run.late() > 0.05, "{run:?}");
}

/// The number: 120 held by giving up quality, at most 1 % late.
fn the_promised_rate_is_held_on_the_papers_phone() {
    for (name, cost) in [
        ("pixels", pixels as fn(&FrameQuality) -> f64),
        ("stubborn", stubborn),
    ] {
        let run = run(40.0, true, |_| 0.89, cost, |_| 25.0);
        assert!(
            run.late() <= 0.01 && run.slowest >= 118.8,
            "{name}: {run:?}"
        );
        assert!(
            !run.steps.is_empty() && run.steps[0].0 > 300.0,
            "{name}: quality goes before the phone is warm: {run:?}"
        );
        assert!(run.turns() <= 8, "{name}: {run:?}");
        println!(
            "{name}: {:.3} % late, {} steps, {} turns: {:?}",
            100.0 * run.late(),
            run.steps.len(),
            run.turns(),
            run.steps
        );
    }
}

fn quality_comes_back_when_the_air_cools_and_when_the_work_is_less() {
    let cooled = run(
        60.0,
        true,
        |_| 0.89,
        pixels,
        |at| if at < 1500.0 { 25.0 } else { 5.0 },
    );
    assert!(
        cooled.rung_at(1500.0) > 0 && cooled.rung_at(3600.0) == 0 && cooled.late() <= 0.01,
        "{cooled:?}"
    );
    let eased = run(
        50.0,
        true,
        |at| if at < 1500.0 { 0.89 } else { 0.4 },
        pixels,
        |_| 25.0,
    );
    assert!(
        eased.rung_at(1500.0) > 0 && eased.rung_at(3000.0) == 0 && eased.late() <= 0.01,
        "{eased:?}"
    );
}

fn a_sudden_load_costs_few_frames_and_is_given_back() {
    let run = run(
        6.0,
        true,
        |at| {
            if (60.0..120.0).contains(&at) {
                1.6
            } else {
                0.6
            }
        },
        pixels,
        |_| 25.0,
    );
    assert!(
        run.late() < 0.01 && run.rung_at(119.0) >= 3 && run.rung_at(350.0) == 0,
        "{run:?}"
    );
}

/// Draws an avatar of a side at full quality, px, for some seconds, as a device would of which
/// small avatars cost what their level does. Returns the qualities it was drawn with, each once.
fn drawn(
    governor: &mut Governor,
    now: &mut f64,
    side: f64,
    work: f64,
    seconds: f64,
) -> Vec<FrameQuality> {
    let mut qualities = vec![governor.quality()];
    let until = *now + seconds;
    while *now < until {
        let quality = governor.quality();
        if qualities.last() != Some(&quality) {
            qualities.push(quality);
        }
        // What is small is drawn as if it were 720 px: a smaller image gains nothing.
        let gained = if side * quality.scale < 720.0 {
            0.42f64.powi(quality.coarser as i32)
        } else {
            pixels(&quality)
        };
        *now += f64::from(quality.refreshes) / RATE;
        // As counted in the frame's image, and taken back to full quality.
        governor.note_side((side * quality.scale).ceil() / quality.scale);
        governor.add_frame(Sample {
            seconds: *now,
            busy_ms: Some(1e3 * work * gained / RATE),
            dropped: 0,
        });
    }
    qualities
}

/// A smaller image saves nothing of small avatars, and coarser levels do. One that comes near walks
/// the other path, as far down as it was.
fn small_avatars_keep_their_resolution() {
    let (mut governor, mut now) = (Governor::new(RATE), 0.0);
    let mut draw = |side, work, seconds| {
        let all = drawn(&mut governor, &mut now, side, work, seconds);
        all[all.len() - 1]
    };
    let held = draw(300.0, 2.0, 30.0);
    assert_eq!((held.scale, held.refreshes), (1.0, 1));
    assert_eq!(held.coarser, 1, "{held:?}");
    let near = draw(1500.0, 2.0, 30.0);
    assert!(near.coarser == 0 && near.scale < 0.9, "{near:?}");
    let far = draw(300.0, 5.0, 30.0);
    assert_eq!((far.scale, far.coarser), (1.0, 2), "{far:?}");
    assert_eq!(draw(300.0, 0.3, 1000.0), FrameQuality::FULL);
}

/// A lower resolution makes no avatar small, whatever its size: the governor settles on one path,
/// and comes back when there is less to do.
fn a_lower_resolution_makes_no_avatar_small() {
    for side in [500.0, 570.0, 630.0, 645.0, 700.0, 900.0, 1200.0, 2000.0] {
        for work in [1.1, 1.6, 2.5] {
            let (mut governor, mut now) = (Governor::new(RATE), 0.0);
            drawn(&mut governor, &mut now, side, work, 60.0);
            let settled = drawn(&mut governor, &mut now, side, work, 60.0);
            // What is tried and taken back, not a walk to and fro between the paths.
            assert!(settled.len() <= 8, "{side} px, work {work}: {settled:?}");
            for quality in settled {
                let small = quality.scale == 1.0 && quality.level == 0;
                let large =
                    quality.coarser == 0 && (quality.scale * side >= 640.0 || quality.scale == 1.0);
                assert!(
                    if side < 560.0 { small } else { large },
                    "{side} px: {quality:?}"
                );
            }
            drawn(&mut governor, &mut now, side, 0.2, 2000.0);
            assert_eq!(governor.quality(), FrameQuality::FULL, "{side} px");
        }
    }
}

fn a_load_between_two_rungs_settles() {
    for tenth in 0..12 {
        let work = 0.7 + 0.1 * f64::from(tenth);
        let run = run(20.0, true, |_| work, pixels, |_| 0.0);
        let late_turns = run.steps.iter().filter(|step| step.0 > 600.0).count();
        assert!(late_turns <= 4, "work {work}: {run:?}");
        assert!(work > 1.6 || run.late() <= 0.01, "work {work}: {run:?}");
    }
}

/// Headroom as systems report it, whatever the governor does: smooth, in coarse steps, with noise,
/// with readings that are missing.
fn headroom_is_followed_down_and_up_however_it_is_reported() {
    /// Warms for ten minutes, stays hot for five, cools for five, stays cool.
    fn curve(at: f64) -> f64 {
        match at {
            at if at < 600.0 => 0.5 + 0.6 * at / 600.0,
            at if at < 900.0 => 1.1,
            at if at < 1200.0 => 1.1 - 0.7 * (at - 900.0) / 300.0,
            _ => 0.4,
        }
    }
    let noise = |at: f64| 0.03 * (((at * 7.3).sin() * 43_758.5).fract());
    let reports: [(&str, &dyn Fn(f64) -> f64); 4] = [
        ("smooth", &curve),
        ("coarse", &|at| (curve(at) * 20.0).floor() / 20.0),
        ("noisy", &|at| curve(at) + noise(at)),
        ("missing", &|at| {
            if (at as u64).is_multiple_of(3) {
                curve(at)
            } else {
                f64::NAN
            }
        }),
    ];
    for (name, report) in reports {
        let mut governor = Governor::new(RATE);
        let mut run = Run::default();
        for second in 0..3600 {
            let at = f64::from(second);
            let before = governor.rung();
            drive(&mut governor, 1, at, Some(5.0), 0, Some(report(at)));
            if governor.rung() != before {
                run.steps.push((at, governor.rung()));
            }
        }
        let downs: Vec<f64> = run
            .steps
            .windows(2)
            .filter(|pair| pair[1].1 > pair[0].1)
            .map(|pair| pair[1].0 - pair[0].0)
            .collect();
        let lowest = governor.ladder().path(false).len() - 1;
        assert!(
            run.steps
                .first()
                .is_some_and(|step| (300.0..560.0).contains(&step.0)),
            "{name}: {run:?}"
        );
        assert!(
            run.rung_at(890.0) == lowest && downs.iter().all(|wait| *wait >= 14.0),
            "{name}: steps for heat come too fast: {run:?}"
        );
        assert!(governor.rung() == 0 && run.turns() <= 3, "{name}: {run:?}");
    }
}

/// Frames of a second each: time, busy and dropped as given.
fn drive(
    governor: &mut Governor,
    seconds: usize,
    from: f64,
    busy: Option<f64>,
    dropped: u32,
    headroom: Option<f64>,
) -> Vec<usize> {
    let mut rungs = Vec::new();
    for second in 0..seconds {
        let start = from + second as f64;
        headroom.inspect(|&headroom| governor.add_headroom(start, headroom));
        for frame in 0..120 {
            governor.add_frame(Sample {
                seconds: start + f64::from(frame) / RATE,
                busy_ms: busy,
                dropped: if frame == 0 { dropped } else { 0 },
            });
            rungs.push(governor.rung());
        }
    }
    rungs
}

proptest! {
    /// Whatever is measured, every step is one that the ladder has, climbs are a rung at a time and
    /// never within the calm.
    fn steps_are_always_on_the_ladder(seconds in proptest::collection::vec((0.0..30.0_f64, 0u32..40, prop_oneof![Just(f64::NAN), 0.0..2.0_f64]), 1..120)) {
        let mut governor = Governor::new(RATE);
        let mut last_down = f64::NEG_INFINITY;
        for (at, &(busy, dropped, headroom)) in seconds.iter().enumerate() {
            let before = governor.rung();
            let rungs = drive(&mut governor, 1, at as f64, Some(busy), dropped, Some(headroom));
            for pair in std::iter::once(&before).chain(&rungs).collect::<Vec<_>>().windows(2) {
                let (from, to) = (*pair[0], *pair[1]);
                prop_assert!(to < governor.ladder().path(false).len());
                prop_assert!(from <= to + 1, "climbs from {from} to {to}");
                if to > from {
                    last_down = at as f64;
                }
                prop_assert!(to >= from || at as f64 - last_down >= 9.0, "climbs {} s after a step down", at as f64 - last_down);
            }
        }
    }

    /// Under constant conditions it comes to rest: nothing changes in the second half of an hour
    /// but for ever rarer tries.
    fn constant_conditions_come_to_rest(busy in 0.1..20.0_f64, dropped in 0u32..3, headroom in 0.0..1.2_f64) {
        let mut governor = Governor::new(RATE);
        drive(&mut governor, 1800, 0.0, Some(busy), dropped, Some(headroom));
        let rungs = drive(&mut governor, 1800, 1800.0, Some(busy), dropped, Some(headroom));
        let changes = rungs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        prop_assert!(changes <= 8, "{changes} changes at {busy} ms, {dropped} dropped, headroom {headroom}");
    }

    /// No reading of heat at all, and none of busy time, still leave a governor that answers to
    /// late frames.
    fn late_frames_alone_are_enough(dropped in 4u32..60) {
        let mut governor = Governor::new(RATE);
        drive(&mut governor, 60, 0.0, None, dropped, None);
        prop_assert!(governor.is_at_last());
        drive(&mut governor, 1200, 60.0, None, 0, None);
        prop_assert_eq!(governor.rung(), 0);
    }
}

/// Seconds of a soak on the simulated phone, 33 times as fast as a real one, in virtual time; and
/// how often its governor stepped.
fn heated(governed: bool) -> (Vec<Second>, usize) {
    const RATE: f64 = 30.0;
    let mut phone = Simulated::new(Phone::default(), 33.0, RATE);
    let mut session = Session::new(SoakSettings {
        rate: RATE,
        governed,
        seconds: 60.0,
    });
    let mut now = 0.0;
    while !session.is_over() {
        let took = phone.add_frame(now, 0.004 * (0.25 + 0.75 * session.quality().scale.powi(2)));
        now += took.max(1.0 / RATE);
        if session.add_frame(now, Some(1e3 * took)).full {
            session.close_second(&phone.read(), 0, None);
        }
    }
    (session.seconds().to_vec(), session.totals().changes)
}

fn simulated_heat_lowers_clock_and_rate_until_a_governor_acts() {
    let (alone, steps) = heated(false);
    let dropped = |each: &[Second]| {
        each[each.len() / 2..]
            .iter()
            .map(|second| second.dropped)
            .sum::<u32>()
    };
    assert!(
        steps == 0 && dropped(&alone[..alone.len() / 4]) == 0,
        "{alone:?}"
    );
    assert!(
        alone
            .iter()
            .any(|second| second.headroom > Some(1.0) && second.clock < Some(0.8))
            && dropped(&alone) > 50,
        "{alone:?}"
    );
    let (governed, steps) = heated(true);
    assert!(
        steps > 0
            && governed
                .iter()
                .any(|second| second.rung > 0 && second.clock < Some(1.0)),
        "{governed:?}"
    );
    assert!(
        dropped(&governed) < dropped(&alone) / 4,
        "{} of {}",
        dropped(&governed),
        dropped(&alone)
    );
}

tests! {
    small_avatars_keep_their_resolution,
    a_lower_resolution_makes_no_avatar_small,
    the_papers_phone_throttles_when_nothing_governs_it,
    the_promised_rate_is_held_on_the_papers_phone,
    quality_comes_back_when_the_air_cools_and_when_the_work_is_less,
    a_sudden_load_costs_few_frames_and_is_given_back,
    a_load_between_two_rungs_settles,
    headroom_is_followed_down_and_up_however_it_is_reported,
    steps_are_always_on_the_ladder,
    constant_conditions_come_to_rest,
    late_frames_alone_are_enough,
    simulated_heat_lowers_clock_and_rate_until_a_governor_acts,
}
