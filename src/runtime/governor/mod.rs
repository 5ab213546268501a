//! Holds a promised frame rate: frame times and thermal headroom go in, the quality to draw at
//! comes out.
//!
//! The governor walks a [`Ladder`]. It steps down at once, as far as the load requires, when frames
//! are late or nearly so, and one rung at a time when the device is about to lower its clock. It
//! climbs one rung at a time, once the load has been low enough for a while. After a climb that had
//! to be taken back, the next one waits twice as long, so that the governor settles even under a
//! load that no rung fits exactly.

mod heat;
mod ladder;

pub use ladder::{FrameQuality, Ladder, Rung};

use effigy_core::scene::supersampling::DRAWN_SIDE;
use heat::HeatTrend;

/// A decision needs frames of at least this time, seconds, and at least this many.
const MIN_WINDOW_SECONDS: f64 = 0.5;
const MIN_WINDOW_FRAMES: u32 = 8;
/// Windows that are ignored after a step: frames already under way belong to the rung before.
const IGNORED_WINDOWS: u32 = 1;
/// A larger share of dropped refreshes is too much.
const MAX_LATE_SHARE: f64 = 0.02;
/// Load is GPU time as a share of the time that frames have. Above the first the device is full; a
/// step down leads to the second or below.
const FULL_LOAD: f64 = 0.95;
const EASY_LOAD: f64 = 0.85;
/// Below this load late frames are not the device's fault, and drawing less would not help.
const IDLE_LOAD: f64 = 0.7;
/// A climb must be expected to end below this load.
const MAX_LOAD_AFTER_CLIMB: f64 = 0.9;
/// Headroom, current or forecast, from which to step down, and below which to climb.
const HOT: f64 = 0.95;
const COOL: f64 = 0.8;
/// Time from any step to one down for heat, seconds: it takes that long to see what the first did.
const HEAT_DWELL: f64 = 15.0;
/// Time of low load before a climb, seconds: at first, and at most.
const MIN_WAIT: f64 = 10.0;
const MAX_WAIT: f64 = 600.0;
/// A device that lowers its clock when it has little to do looks as busy as ever. After the wait
/// times this, the rung above is tried anyway.
const TRIAL_WAITS: f64 = 6.0;
/// A step down this soon after a climb takes the climb back, seconds: for load, and for heat.
const TAKEN_BACK_FOR_LOAD: f64 = 60.0;
const TAKEN_BACK_FOR_HEAT: f64 = 300.0;
/// Avatars whose longest side is below the first are drawn larger than they are shown, px. One that
/// was not small has to be below the second to be.
const SMALL: f64 = DRAWN_SIDE;
const BECOMES_SMALL: f64 = 560.0;
/// Rungs that one step goes down at most.
const MAX_RUNGS_DOWN: usize = 3;

/// Timing of one frame.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// When it was submitted, on a monotonic clock, seconds.
    pub seconds: f64,
    /// GPU time, ms. None if unknown.
    pub busy_ms: Option<f64>,
    /// Refreshes before it that had no new frame.
    pub dropped: u32,
}

/// The frames since the last decision.
#[derive(Clone, Copy, Debug, Default)]
struct DecisionWindow {
    began: Option<f64>,
    frames: u32,
    dropped: u32,
    /// GPU time of all frames for which it is known, ms, and their number.
    busy_ms: f64,
    timed_frames: u32,
    /// Frames of which it is known how avatars were drawn, and those in which all of them were
    /// small.
    known_frames: u32,
    small_frames: u32,
    /// The longest side at full quality, px.
    side: f64,
}

/// Why to step down.
#[derive(Clone, Copy, PartialEq, Eq)]
enum StepDownReason {
    Load,
    Heat,
}

impl StepDownReason {
    /// A step down within this time of a climb takes the climb back, seconds.
    fn taken_back_within(self) -> f64 {
        match self {
            Self::Load => TAKEN_BACK_FOR_LOAD,
            Self::Heat => TAKEN_BACK_FOR_HEAT,
        }
    }
}

/// Decides which rung of a [`Ladder`] to draw at.
#[derive(Clone, Debug)]
pub struct Governor {
    ladder: Ladder,
    /// Whether it walks the path of small avatars.
    is_small: bool,
    /// The least resolution, as a share of the full one, that still saves something: where an
    /// avatar becomes small it no longer does.
    least_scale: f64,
    /// Time from one refresh to the next, ms.
    refresh_ms: f64,
    /// Steps down the path; 0 is full quality.
    step: usize,
    window: DecisionWindow,
    /// Windows still to be ignored.
    ignored_windows: u32,
    heat: HeatTrend,
    /// Since when a climb has been possible, seconds.
    calm_since: Option<f64>,
    /// How long that has to last before a climb, seconds.
    wait: f64,
    /// When the governor climbed last, seconds; None if that climb was taken back.
    climbed_at: Option<f64>,
    /// When the rung changed last, seconds.
    changed_at: f64,
}

impl Governor {
    /// A governor for a promised rate, frames a second, at full quality.
    pub fn new(rate: f64) -> Self {
        Self {
            ladder: Ladder::new(rate),
            is_small: false,
            least_scale: 0.0,
            refresh_ms: 1e3 / rate,
            step: 0,
            window: DecisionWindow::default(),
            ignored_windows: IGNORED_WINDOWS,
            heat: HeatTrend::default(),
            calm_since: None,
            wait: MIN_WAIT,
            climbed_at: None,
            changed_at: f64::NEG_INFINITY,
        }
    }

    /// Promises another rate. The governor starts again at full quality and keeps its heat
    /// readings.
    pub fn set_rate(&mut self, rate: f64) {
        *self = Self {
            heat: std::mem::take(&mut self.heat),
            changed_at: self.changed_at,
            is_small: self.is_small,
            least_scale: self.least_scale,
            ..Self::new(rate)
        };
    }

    /// The rungs that it walks.
    pub fn ladder(&self) -> &Ladder {
        &self.ladder
    }

    /// Index of the current rung in the ladder; 0 is full quality.
    pub fn rung(&self) -> usize {
        self.ladder.rung(self.is_small, self.step)
    }

    /// Whether nothing is left to give up.
    pub fn is_at_last(&self) -> bool {
        self.step + 1 == self.ladder.path(self.is_small).len()
    }

    /// The quality to draw the next frame at.
    pub fn quality(&self) -> FrameQuality {
        let quality = self.ladder.rungs()[self.rung()].quality;
        FrameQuality {
            scale: quality.scale.max(self.least_scale),
            ..quality
        }
    }

    /// The rungs of the path that it walks.
    fn path(&self) -> Vec<&Rung> {
        let path = self.ladder.path(self.is_small);
        path.into_iter()
            .map(|rung| &self.ladder.rungs()[rung])
            .collect()
    }

    /// Adds a reading of thermal headroom: 0 is cool, at 1 the system lowers the clock. `seconds`
    /// is on the clock of [`Sample::seconds`].
    pub fn add_headroom(&mut self, seconds: f64, headroom: f64) {
        self.heat.add_reading(seconds, headroom);
    }

    /// Says how large the largest avatar of a frame would be at full quality: its longest side, px.
    /// From a window on in which all frames say that it is small, the governor walks the path of
    /// [small](Ladder) avatars.
    pub fn note_side(&mut self, side: f64) {
        let limit = if self.is_small { SMALL } else { BECOMES_SMALL };
        self.window.known_frames += 1;
        self.window.side = self.window.side.max(side);
        self.window.small_frames += u32::from(side < limit);
    }

    /// Leaves out a time in which no frame was wanted.
    pub fn skip_idle(&mut self) {
        self.window = DecisionWindow::default();
        self.calm_since = None;
    }

    /// Adds a frame that was submitted. True if [`Self::quality`] has changed.
    pub fn add_frame(&mut self, sample: Sample) -> bool {
        let window = &mut self.window;
        let began = *window.began.get_or_insert(sample.seconds);
        window.frames += 1;
        window.dropped += sample.dropped;
        if let Some(busy_ms) = sample.busy_ms
            && busy_ms.is_finite()
        {
            window.busy_ms += busy_ms;
            window.timed_frames += 1;
        }
        if sample.seconds - began < MIN_WINDOW_SECONDS || window.frames < MIN_WINDOW_FRAMES {
            return false;
        }
        let window = std::mem::take(window);
        if self.ignored_windows > 0 {
            self.ignored_windows -= 1;
            return false;
        }
        self.decide(&window, sample.seconds)
    }

    /// Judges a full window of frames. True if the quality has changed.
    fn decide(&mut self, window: &DecisionWindow, now: f64) -> bool {
        let is_small = window.small_frames > 0;
        let is_sure = [0, window.known_frames].contains(&window.small_frames);
        if window.known_frames > 0 && is_sure && is_small != self.is_small {
            return self.change_path(is_small, now);
        }
        if window.known_frames > 0 && self.change_least_scale(window.side) {
            self.set_step(self.step, now);
            return true;
        }
        let frame_ms = self.refresh_ms * f64::from(self.quality().refreshes);
        let load = (window.timed_frames > 0)
            .then(|| window.busy_ms / f64::from(window.timed_frames) / frame_ms);
        let late_share = f64::from(window.dropped) / f64::from(window.frames + window.dropped);
        let is_late = late_share > MAX_LATE_SHARE;
        let late_by_load = is_late && load.is_none_or(|load| load > IDLE_LOAD);
        let is_full = load.is_some_and(|load| load > FULL_LOAD);
        if late_by_load || is_full {
            return self.step_down(self.rungs_down(load), StepDownReason::Load, now);
        }

        let headroom = self.heat.current(now);
        let forecast = self.heat.forecast(now);
        let slope = self.heat.slope();
        let is_hot = headroom.is_some_and(|headroom| headroom >= 1.0) && slope >= 0.0;
        let gets_hot = forecast.is_some_and(|forecast| forecast >= HOT) && slope > 0.0;
        if (is_hot || gets_hot) && now - self.changed_at >= HEAT_DWELL {
            return self.step_down(1, StepDownReason::Heat, now);
        }

        if self
            .climbed_at
            .is_some_and(|climbed_at| now - climbed_at > TAKEN_BACK_FOR_HEAT)
        {
            self.wait = MIN_WAIT;
        }
        let is_cool = headroom.is_none_or(|headroom| headroom <= COOL)
            && forecast.is_none_or(|forecast| forecast <= COOL);
        if !is_cool || is_late || self.step == 0 {
            self.calm_since = None;
            return false;
        }
        let calm = now - *self.calm_since.get_or_insert(now);
        let fits = calm >= self.wait && self.fits_above(load);
        if fits || calm >= TRIAL_WAITS * self.wait {
            self.climb(now);
            return true;
        }
        false
    }

    /// How many rungs to go down so that a load becomes easy.
    fn rungs_down(&self, load: Option<f64>) -> usize {
        let rungs = self.path();
        let cost = rungs[self.step].cost;
        let below = &rungs[self.step + 1..];
        let below = &below[..below.len().min(MAX_RUNGS_DOWN)];
        let is_easy = |rung: &&Rung| load.is_none_or(|load| load * rung.cost / cost <= EASY_LOAD);
        let first_easy = below.iter().position(is_easy).map(|index| index + 1);
        first_easy.unwrap_or(below.len()).max(1)
    }

    /// Whether the rung above is expected to fit. Must not be called on the first rung.
    fn fits_above(&self, load: Option<f64>) -> bool {
        let rungs = self.path();
        let above = rungs[self.step - 1].cost;
        let current = rungs[self.step].cost;
        load.is_some_and(|load| load * above / current <= MAX_LOAD_AFTER_CLIMB)
    }

    fn step_down(&mut self, rungs: usize, reason: StepDownReason, now: f64) -> bool {
        self.calm_since = None;
        let target = (self.step + rungs).min(self.path().len() - 1);
        if target == self.step {
            return false;
        }
        if let Some(climbed_at) = self.climbed_at.take()
            && now - climbed_at <= reason.taken_back_within()
        {
            self.wait = (2.0 * self.wait).min(MAX_WAIT);
        }
        self.set_step(target, now);
        true
    }

    /// Sets the least resolution for avatars of a side, px. True if the quality has changed.
    fn change_least_scale(&mut self, side: f64) -> bool {
        let before = self.quality();
        let scales = || self.ladder.rungs().iter().map(|rung| rung.quality.scale);
        let least = |side: f64| {
            let saving = scales().filter(|scale| scale * side >= SMALL);
            saving.fold(1.0, f64::min)
        };
        // A lower one only where the avatar is well above it, so that it does not come and go.
        self.least_scale = least(side).max(self.least_scale.min(least(side / 1.1)));
        self.quality() != before
    }

    /// Goes on at the first rung of the other path that costs no more than this one.
    fn change_path(&mut self, is_small: bool, now: f64) -> bool {
        let before = self.quality();
        let cost = self.ladder.rungs()[self.rung()].cost;
        self.is_small = is_small;
        let path = self.path();
        let step = path.iter().position(|rung| rung.cost <= cost);
        let step = step.unwrap_or(path.len() - 1);
        self.calm_since = None;
        self.set_step(step, now);
        self.quality() != before
    }

    fn climb(&mut self, now: f64) {
        self.climbed_at = Some(now);
        self.calm_since = None;
        self.set_step(self.step - 1, now);
    }

    fn set_step(&mut self, step: usize, now: f64) {
        self.step = step;
        self.changed_at = now;
        self.ignored_windows = IGNORED_WINDOWS;
        self.heat.reset_slope();
    }
}
