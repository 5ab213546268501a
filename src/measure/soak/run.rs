//! Draws a soak without a window: an avatar, a clip and a device go in, a report comes out.

use super::{
    memory,
    report::{Drift, Report, SCHEMA},
    session::{Session, Settings},
    stage::Stage,
    verdict::{self, Bounds},
};
use crate::{
    avatar::{Avatar, motion::Player},
    measure::{
        bench::{
            self, Setting, check,
            report::{Device, ErrorReport},
        },
        error,
        thermals::Thermals,
        trace::Trace,
    },
    reference,
    vulkan::{Gpu, Result, picture::Copied},
};
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

/// Rates that may be promised unasked, frames a second.
const RATES: [f64; 16] = [120.0, 90.0, 72.0, 60.0, 48.0, 30.0, 24.0, 20.0, 15.0, 12.0, 10.0, 6.0, 5.0, 3.0, 2.0, 1.0];
/// A rate is promised unasked where frames take at most this share of the time that it leaves them.
const SPARE: f64 = 0.8;
/// Frames of the test for that, and its shortest time.
const TEST: (usize, Duration) = (16, Duration::from_millis(1500));

/// What to do.
pub struct Task<'a> {
    pub avatar: &'a Avatar,
    pub player: &'a Player,
    pub setting: Setting,
    pub settings: Settings,
    pub bounds: Bounds,
    /// Whether to compare with the reference, which takes seconds.
    pub check: bool,
    /// The command line.
    pub command: Vec<String>,
}

/// The highest rate that the whole quality holds with some time to spare, from a short test.
pub fn suited_rate(gpu: &Arc<Gpu>, avatar: &Avatar, player: &Player, setting: &Setting) -> Result<f64> {
    let mut stage = Stage::new(gpu, (avatar, player), setting.options)?;
    let start = Instant::now();
    let mut ends = Vec::new();
    while ends.len() < TEST.0 || start.elapsed() < TEST.1 {
        stage.frame(start.elapsed().as_secs_f64(), false)?;
        ends.push(start.elapsed().as_secs_f64());
    }
    stage.finish()?;
    let mut intervals: Vec<f64> = ends.windows(2).skip(4).map(|pair| pair[1] - pair[0]).collect();
    intervals.sort_unstable_by(f64::total_cmp);
    let slow = intervals[intervals.len() * 3 / 4];
    Ok(RATES.into_iter().find(|rate| rate * slow <= SPARE).unwrap_or(RATES[RATES.len() - 1]))
}

/// Draws until the time is over or `stop` is set. `tick` is shown every second.
pub fn run(
    gpu: &Arc<Gpu>,
    task: &Task,
    (thermals, trace): (&mut Thermals, Option<&mut Trace>),
    stop: &AtomicBool,
    tick: &mut dyn FnMut(&Session),
) -> Result<Report> {
    let mut stage = Stage::new(gpu, (task.avatar, task.player), task.setting.options)?;
    let before = if task.check { Some(stage.picture()?) } else { None };
    let mut session = Session::new(task.settings);
    soak((gpu, &mut stage, trace), &mut session, (thermals, stop), tick)?;
    let drift = before.filter(|_| session.is_over()).map(|before| drift(task.avatar, &mut stage, &before)).transpose()?;
    let mut report = report(bench::backend::device(gpu), task, &session, matches!(thermals, Thermals::Simulated(_)));
    report.drift = drift;
    report.faults = verdict::faults(&report, &task.bounds);
    Ok(report)
}

fn soak(
    (gpu, stage, mut trace): (&Gpu, &mut Stage, Option<&mut Trace>),
    session: &mut Session,
    (thermals, stop): (&mut Thermals, &AtomicBool),
    tick: &mut dyn FnMut(&Session),
) -> Result<()> {
    let start = Instant::now();
    let clock = || start.elapsed().as_secs_f64();
    let wait = |until: f64| thread::sleep(Duration::from_secs_f64((until - clock()).max(0.0)));
    let (mut look, mut done) = (true, 0.0_f64);
    while !session.is_over() && !stop.load(Ordering::Relaxed) {
        session.next().into_iter().for_each(wait);
        let began = clock();
        stage.frame(began, look)?;
        look = false;
        trace.iter_mut().for_each(|trace| trace.frame(stage.report()));
        let busy = stage.busy_ms();
        let stretched = busy.map(|busy| 1e3 * thermals.frame(began, busy / 1e3));
        // A clock that is only said to be lower has to be waited for: one frame may be under way while the next is made.
        done = done.max(began) + stretched.zip(busy).map_or(0.0, |(stretched, busy)| if stretched > busy { stretched / 1e3 } else { 0.0 });
        wait(done - 1.0 / session.settings().rate);
        let event = session.frame(clock(), stretched);
        stage.seen().into_iter().for_each(|seen| session.seen(seen));
        session.counted(&stage.report().counters);
        if event.full {
            let reading = thermals.read(clock());
            let rung = session.close(&reading, (gpu.memory().0, memory::resident())).rung;
            if let Some(trace) = &mut trace {
                trace.counter("governor's step", rung as f64);
                reading.headroom.into_iter().for_each(|headroom| trace.counter("headroom used", headroom));
            }
            tick(session);
            look = true;
        }
        if event.changed {
            stage.set_quality(session.quality())?;
        }
    }
    stage.finish()
}

/// The same picture before and after, against the reference.
fn drift(avatar: &Avatar, stage: &mut Stage, before: &Copied) -> Result<Drift> {
    let after = stage.picture()?.decode();
    let before = before.decode();
    let (posed, camera) = stage.middle();
    let truth = reference::render_scene(avatar, &[&posed], &camera);
    let of = |picture| -> ErrorReport { check::report(&error::between(picture, &truth), None) };
    Ok(Drift { before: of(&before), after: of(&after), same: before == after })
}

/// The report of what a session has written down; drift, still and faults are left open.
pub fn report(device: Device, task: &Task, session: &Session, simulated_heat: bool) -> Report {
    let (totals, each) = (session.totals(), session.each());
    let lasted = session.lasted();
    Report {
        schema: SCHEMA.to_owned(),
        program: bench::program(task.command.clone()),
        device,
        avatar: bench::subject(task.avatar, task.player),
        size: task.setting.options.size,
        options: bench::options(&task.setting),
        rate: task.settings.rate,
        governed: task.settings.governed,
        simulated_heat,
        planned_seconds: task.settings.seconds,
        lasted_seconds: lasted,
        ladder: session.ladder().0.iter().map(Into::into).collect(),
        frames: totals.frames,
        fps: if lasted > 0.0 { (totals.frames.saturating_sub(1)) as f64 / lasted } else { 0.0 },
        late: totals.late,
        dropped: totals.dropped,
        dropped_share: verdict::dropped_share(each),
        changes: totals.changes,
        lowest_rung: totals.lowest_rung,
        growth: memory::growth(each),
        pictures: totals.pictures,
        broken_pixels: totals.broken_pixels,
        empty_pictures: totals.empty_pictures,
        broken_gaussians: totals.broken_gaussians,
        drift: None,
        still: None,
        faults: Vec::new(),
        each: each.to_vec(),
    }
}
