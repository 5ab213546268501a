//! Holds a promised frame rate: what frames took and how warm the device is go in, how much to draw comes out.
//!
//! It walks a [`Ladder`]. Down at once, and as far as the load asks for, when frames come late or are about to, and a rung at a time when
//! the device is about to take its clock away. Up a rung at a time, when there is room for it and has been for a while. A climb that had to
//! be taken back makes the next one wait twice as long, so that it settles under a load that no rung fits exactly.

mod heat;
mod ladder;

pub use ladder::{Ladder, Quality, Rung};

use heat::Heat;

/// A decision looks at frames of at least this time, seconds, and at least so many.
const WINDOW: (f64, u32) = (0.5, 8);
/// Windows after a step that say nothing: what was under way belongs to the rung before.
const SETTLE: u32 = 1;
/// More dropped refreshes than this share are too many.
const LATE: f64 = 0.02;
/// Time that frames take, as a share of the time they have: above the first there is no room left, and a step down leads to the second.
const FULL: f64 = 0.95;
const EASY: f64 = 0.85;
/// Late frames of a device that has this much time left are not its fault, and drawing less would not help.
const IDLE: f64 = 0.7;
/// A climb must be expected to end below this share.
const CLIMB: f64 = 0.9;
/// Headroom from which on to step down, as it is or as it soon will be, and below which to climb.
const HOT: f64 = 0.95;
const COOL: f64 = 0.8;
/// After any step, until one down for heat, seconds: it takes that long to see what the first has done.
const HEAT_DWELL: f64 = 15.0;
/// Calm before a climb, seconds: at first, and at most.
const CALM: [f64; 2] = [10.0, 600.0];
/// A device that lowers its clock when it has little to do looks as busy as ever. It gets a rung more after so many times the calm.
const PROBE: f64 = 6.0;
/// A step down within this of a climb takes the climb back, seconds: for load, and for heat.
const TAKEN_BACK: [f64; 2] = [60.0, 300.0];
/// Rungs that one step down may skip at most, plus one.
const MOST_DOWN: usize = 3;

/// What one frame took.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// When it was handed over, on a clock that only rises, seconds.
    pub seconds: f64,
    /// How long the device was busy with it, ms. None where nothing tells.
    pub busy_ms: Option<f64>,
    /// Refreshes that showed nothing new before it.
    pub dropped: u32,
}

/// Frames since the last decision.
#[derive(Clone, Copy, Debug, Default)]
struct Window {
    began: Option<f64>,
    frames: u32,
    dropped: u32,
    busy_ms: f64,
    /// Frames whose time is known.
    known: u32,
}

/// Why to step down.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reason {
    Load,
    Heat,
}

/// Decides on which rung to draw.
#[derive(Clone, Debug)]
pub struct Governor {
    ladder: Ladder,
    /// Time from one refresh to the next, ms.
    refresh_ms: f64,
    rung: usize,
    window: Window,
    settling: u32,
    heat: Heat,
    /// Since when nothing spoke against a climb.
    calm: Option<f64>,
    wait: f64,
    climbed: Option<f64>,
    /// When the rung was changed last, seconds.
    changed: f64,
}

impl Governor {
    /// For a promised rate, frames a second.
    pub fn new(rate: f64) -> Self {
        Self {
            ladder: Ladder::new(rate),
            refresh_ms: 1e3 / rate,
            rung: 0,
            window: Window::default(),
            settling: SETTLE,
            heat: Heat::default(),
            calm: None,
            wait: CALM[0],
            climbed: None,
            changed: f64::NEG_INFINITY,
        }
    }

    /// Another rate is promised from now on. It begins anew at the whole quality; what is known of heat stays.
    pub fn set_rate(&mut self, rate: f64) {
        *self = Self { heat: std::mem::take(&mut self.heat), changed: self.changed, ..Self::new(rate) };
    }

    pub fn ladder(&self) -> &Ladder {
        &self.ladder
    }

    /// Number of the rung; 0 is the whole quality.
    pub fn rung(&self) -> usize {
        self.rung
    }

    pub fn quality(&self) -> Quality {
        self.ladder.rungs()[self.rung].quality
    }

    /// A reading of thermal headroom at a time on the frames' clock: 0 is cool, 1 where the system takes the clock away.
    pub fn headroom(&mut self, seconds: f64, headroom: f64) {
        self.heat.read(seconds, headroom);
    }

    /// Frames were not drawn for a while, by nobody's fault.
    pub fn rest(&mut self) {
        self.window = Window::default();
        self.calm = None;
    }

    /// A frame was handed over. True where the quality is another from now on.
    pub fn frame(&mut self, sample: Sample) -> bool {
        let window = &mut self.window;
        let began = *window.began.get_or_insert(sample.seconds);
        window.frames += 1;
        window.dropped += sample.dropped;
        if let Some(busy) = sample.busy_ms.filter(|busy| busy.is_finite()) {
            window.busy_ms += busy;
            window.known += 1;
        }
        if sample.seconds - began < WINDOW.0 || window.frames < WINDOW.1 {
            return false;
        }
        let window = std::mem::take(window);
        if self.settling > 0 {
            self.settling -= 1;
            return false;
        }
        self.decide(&window, sample.seconds)
    }

    fn decide(&mut self, window: &Window, now: f64) -> bool {
        let frame_ms = self.refresh_ms * f64::from(self.quality().refreshes);
        let load = (window.known > 0).then(|| window.busy_ms / f64::from(window.known) / frame_ms);
        let late = f64::from(window.dropped) / f64::from(window.frames + window.dropped);
        let full = late > LATE && load.is_none_or(|load| load > IDLE) || load.is_some_and(|load| load > FULL);
        if full {
            return self.step_down(self.rungs_down(load), Reason::Load, now);
        }
        let (headroom, soon) = (self.heat.now(now), self.heat.soon(now));
        let heats = headroom.is_some_and(|now| now >= 1.0) && self.heat.slope() >= 0.0
            || soon.is_some_and(|soon| soon >= HOT) && self.heat.slope() > 0.0;
        if heats && now - self.changed >= HEAT_DWELL {
            return self.step_down(1, Reason::Heat, now);
        }
        let cool = headroom.is_none_or(|headroom| headroom <= COOL) && soon.is_none_or(|soon| soon <= COOL);
        if self.climbed.is_some_and(|climbed| now - climbed > TAKEN_BACK[1]) {
            self.wait = CALM[0];
        }
        if !cool || late > LATE || self.rung == 0 {
            self.calm = None;
            return false;
        }
        let calm = now - *self.calm.get_or_insert(now);
        if calm >= self.wait && (self.has_room(load) || calm >= PROBE * self.wait) {
            return self.climb(now);
        }
        false
    }

    /// Rungs to go down so that a load is easy.
    fn rungs_down(&self, load: Option<f64>) -> usize {
        let rungs = self.ladder.rungs();
        let cost = rungs[self.rung].cost;
        let below = rungs[self.rung..].iter().take(MOST_DOWN + 1).skip(1);
        let eases = |rung: &Rung| load.is_none_or(|load| load * rung.cost / cost <= EASY);
        below.clone().position(eases).map_or(below.len(), |at| at + 1).max(1)
    }

    /// Whether the rung above is expected to fit.
    fn has_room(&self, load: Option<f64>) -> bool {
        let rungs = self.ladder.rungs();
        load.is_some_and(|load| load * rungs[self.rung - 1].cost / rungs[self.rung].cost <= CLIMB)
    }

    fn step_down(&mut self, by: usize, reason: Reason, now: f64) -> bool {
        self.calm = None;
        let to = (self.rung + by).min(self.ladder.lowest());
        if to == self.rung {
            return false;
        }
        let within = TAKEN_BACK[usize::from(reason == Reason::Heat)];
        if self.climbed.take().is_some_and(|climbed| now - climbed <= within) {
            self.wait = (2.0 * self.wait).min(CALM[1]);
        }
        self.change(to, now);
        true
    }

    fn climb(&mut self, now: f64) -> bool {
        self.climbed = Some(now);
        self.calm = None;
        self.change(self.rung - 1, now);
        true
    }

    fn change(&mut self, to: usize, now: f64) {
        (self.rung, self.changed) = (to, now);
        self.settling = SETTLE;
        self.heat.changed();
    }
}
