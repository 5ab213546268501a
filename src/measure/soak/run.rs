//! Draws a soak without a window: an avatar, a clip and a device go in, a report comes out.

use super::{
    faults::{self, SoakLimits},
    memory,
    renderer::{SoakRenderer, middle_frame},
    report::{Drift, SCHEMA, SoakReport},
    session::{Session, SoakSettings},
};
use crate::{
    error,
    report::{DeviceReport, ErrorReport, OptionsReport, Program, Subject},
    setting::RenderSetting,
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    reference,
    scene::FrameImage,
};
use effigy_render::vulkan::{Copied, Gpu, Result};
use effigy_runtime::{thermals::Thermals, trace::TraceRecorder};
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

/// Rates to choose from if none is asked for, highest first, frames a second.
const RATES: [f64; 16] = [
    120.0, 90.0, 72.0, 60.0, 48.0, 30.0, 24.0, 20.0, 15.0, 12.0, 10.0, 6.0, 5.0, 3.0, 2.0, 1.0,
];
/// A rate is chosen if frames take at most this share of its time.
const MAX_LOAD: f64 = 0.8;
/// Length of the test for that, at least.
const TEST_FRAMES: usize = 16;
const TEST_TIME: Duration = Duration::from_millis(1500);
/// First frames of the test that don't count.
const TEST_WARM_UP: usize = 4;

/// A soak to run.
pub struct SoakTask<'a> {
    /// The avatar to draw.
    pub avatar: &'a Avatar,
    /// The clip that moves it.
    pub player: &'a Player,
    /// How to draw at full quality.
    pub setting: RenderSetting,
    /// Rate, governor and time.
    pub settings: SoakSettings,
    /// The limits to keep.
    pub bounds: SoakLimits,
    /// Whether to compare a frame with the reference, which takes seconds.
    pub check: bool,
    /// The command line.
    pub command: Vec<String>,
}

/// The highest common rate that full quality holds with some time to spare, by a short test.
///
/// # Errors
/// When the device fails.
pub fn recommended_rate(
    gpu: &Arc<Gpu>,
    avatar: &Avatar,
    player: &Player,
    setting: &RenderSetting,
) -> Result<f64> {
    let mut renderer = SoakRenderer::new(gpu, avatar, player, setting.options)?;
    let start = Instant::now();
    let mut ends = Vec::new();
    while ends.len() < TEST_FRAMES || start.elapsed() < TEST_TIME {
        renderer.draw(start.elapsed().as_secs_f64(), false)?;
        ends.push(start.elapsed().as_secs_f64());
    }
    renderer.finish()?;
    let pairs = ends.windows(2).skip(TEST_WARM_UP);
    let mut intervals: Vec<f64> = pairs.map(|pair| pair[1] - pair[0]).collect();
    intervals.sort_unstable_by(f64::total_cmp);
    let upper_quartile = intervals[intervals.len() * 3 / 4];
    let fits = |rate: &f64| rate * upper_quartile <= MAX_LOAD;
    Ok(RATES
        .into_iter()
        .find(fits)
        .unwrap_or(RATES[RATES.len() - 1]))
}

/// Draws until the time is over or `stop` is set, and calls `tick` every second.
///
/// # Errors
/// When the device fails.
pub fn run(
    gpu: &Arc<Gpu>,
    task: &SoakTask,
    thermals: &mut Thermals,
    trace: Option<&mut TraceRecorder>,
    stop: &AtomicBool,
    tick: &mut dyn FnMut(&Session),
) -> Result<SoakReport> {
    let mut renderer = SoakRenderer::new(gpu, task.avatar, task.player, task.setting.options)?;
    let before = if task.check {
        Some(renderer.draw_middle_frame()?)
    } else {
        None
    };
    let mut session = Session::new(task.settings);
    let run = Run {
        gpu,
        renderer: &mut renderer,
        session: &mut session,
        thermals,
        trace,
        start: Instant::now(),
    };
    run.draw_until_over(stop, tick)?;
    let drift = match &before {
        Some(before) if session.is_over() => Some(drift(task, &mut renderer, before)?),
        _ => None,
    };
    let simulated_heat = matches!(thermals, Thermals::Simulated(_));
    let device = DeviceReport::from_vulkan(gpu);
    let mut report = report(device, task, &session, simulated_heat);
    report.drift = drift;
    report.faults = faults::find_faults(&report, &task.bounds);
    Ok(report)
}

/// A soak in progress.
struct Run<'a, 'b> {
    gpu: &'a Gpu,
    renderer: &'a mut SoakRenderer<'b>,
    session: &'a mut Session,
    thermals: &'a mut Thermals,
    trace: Option<&'a mut TraceRecorder>,
    start: Instant,
}

impl Run<'_, '_> {
    /// Seconds since the start.
    fn clock(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    fn wait_until(&self, seconds: f64) {
        thread::sleep(Duration::from_secs_f64((seconds - self.clock()).max(0.0)));
    }

    fn draw_until_over(mut self, stop: &AtomicBool, tick: &mut dyn FnMut(&Session)) -> Result<()> {
        // When the device is done with all frames, on a clock as simulated heat lowers it.
        let mut device_done: f64 = 0.0;
        let mut check_image = true;
        while !self.session.is_over() && !stop.load(Ordering::Relaxed) {
            if let Some(next_frame) = self.session.next_frame() {
                self.wait_until(next_frame);
            }
            let began = self.clock();
            self.renderer.draw(began, check_image)?;
            check_image = false;
            if let Some(trace) = &mut self.trace {
                trace.add_frame(self.renderer.report());
            }
            let mut busy_ms = None;
            let mut added_seconds = 0.0;
            if let Some(real_ms) = self.renderer.busy_ms() {
                let simulated_ms = 1e3 * self.thermals.add_frame(began, real_ms / 1e3);
                if simulated_ms > real_ms {
                    added_seconds = simulated_ms / 1e3;
                }
                busy_ms = Some(simulated_ms);
            }
            // The device does not really slow down, so the host waits as it would for a slower one:
            // one frame may be in flight while the next is recorded.
            device_done = device_done.max(began) + added_seconds;
            self.wait_until(device_done - 1.0 / self.session.settings().rate);
            let event = self.session.add_frame(self.clock(), busy_ms);
            if let Some(check) = self.renderer.finished_check() {
                self.session.add_image_check(check);
            }
            self.session.add_counters(&self.renderer.report().counters);
            if event.full {
                self.close_second();
                tick(self.session);
                check_image = true;
            }
            if event.changed {
                self.renderer.set_quality(self.session.quality())?;
            }
        }
        self.renderer.finish()
    }

    fn close_second(&mut self) {
        let reading = self.thermals.read(self.clock());
        let device_bytes = self.gpu.memory().0;
        let resident_bytes = memory::resident_bytes();
        let second = self
            .session
            .close_second(&reading, device_bytes, resident_bytes);
        if let Some(trace) = &mut self.trace {
            trace.add_counter("governor's step", second.rung as f64);
            if let Some(headroom) = reading.headroom {
                trace.add_counter("headroom used", headroom);
            }
        }
    }
}

/// Draws the frame `before` again and compares both with the reference.
fn drift(task: &SoakTask, renderer: &mut SoakRenderer, before: &Copied) -> Result<Drift> {
    let after = renderer.draw_middle_frame()?.decode();
    let before = before.decode();
    let size = task.setting.options.size;
    let (posed, camera) = middle_frame(task.avatar, task.player, size);
    let options = &task.setting.options;
    let (supersampling, filter) = (options.supersampling, options.filter);
    let people = reference::people(task.avatar, &[&posed]);
    let reference = reference::render_shown(&people, &camera, supersampling, filter);
    let error = |image: &FrameImage| ErrorReport::new(&error::between(image, &reference), None);
    Ok(Drift {
        before: error(&before),
        after: error(&after),
        same: before == after,
    })
}

/// The report of a session, without drift, redrawn frame and faults.
pub fn report(
    device: DeviceReport,
    task: &SoakTask,
    session: &Session,
    simulated_heat: bool,
) -> SoakReport {
    let totals = session.totals();
    let seconds = session.seconds();
    let lasted_seconds = session.lasted();
    let fps = if lasted_seconds > 0.0 {
        totals.frames.saturating_sub(1) as f64 / lasted_seconds
    } else {
        0.0
    };
    SoakReport {
        schema: SCHEMA.to_owned(),
        program: Program::current(task.command.clone()),
        device,
        avatar: Subject::new(task.avatar, task.player),
        size: task.setting.options.size,
        options: OptionsReport::new(&task.setting),
        rate: task.settings.rate,
        governed: task.settings.governed,
        simulated_heat,
        planned_seconds: task.settings.seconds,
        lasted_seconds,
        ladder: session.rungs().iter().map(Into::into).collect(),
        frames: totals.frames,
        fps,
        late: totals.late,
        dropped: totals.dropped,
        dropped_share: faults::dropped_share(seconds),
        changes: totals.changes,
        lowest_rung: totals.lowest_rung,
        growth: memory::growth(seconds),
        images: totals.images,
        broken_pixels: totals.broken_pixels,
        broken_gaussians: totals.broken_gaussians,
        empty_images: totals.empty_images,
        drift: None,
        redrawn: None,
        faults: Vec::new(),
        each: seconds.to_vec(),
    }
}
