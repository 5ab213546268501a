//! The books of a soak: frames and readings go in, the quality to draw at and a line each second come out. It knows no device and no clock.

use super::{cadence::Cadence, report::Second};
use crate::{
    frame::Counters,
    measure::{
        governor::{Governor, Quality, Rung, Sample},
        thermals::Reading,
    },
    vulkan::watch::Seen,
};

/// Rates that differ by a smaller share are the same.
const SAME_RATE: f64 = 0.02;

/// What is asked of a soak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The promised rate, frames a second.
    pub rate: f64,
    /// Whether the governor may give up quality for it.
    pub governed: bool,
    /// How long to go on, seconds.
    pub seconds: f64,
}

/// What a frame has brought about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Event {
    /// The quality is another from now on.
    pub changed: bool,
    /// A second is full: [`Session::close`] wants readings.
    pub full: bool,
}

/// Counts over the whole run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Totals {
    pub frames: u64,
    pub late: u64,
    pub dropped: u64,
    pub changes: usize,
    pub lowest_rung: usize,
    pub pictures: u64,
    pub broken_pixels: u64,
    pub empty_pictures: u64,
    /// The most Gaussians of one frame whose place or shape is no number, or beyond what f32 can tell. None where nobody counted.
    pub broken_gaussians: Option<u64>,
}

/// A soak under way.
pub struct Session {
    settings: Settings,
    governor: Governor,
    cadence: Cadence,
    /// The clock at the first frame, at the second's start, and at the last frame.
    times: Option<[f64; 3]>,
    intervals: Vec<f64>,
    busy: (f64, u32),
    late: u32,
    dropped: u32,
    totals: Totals,
    each: Vec<Second>,
}

impl Session {
    pub fn new(settings: Settings) -> Self {
        let most = if settings.seconds.is_finite() { settings.seconds.max(0.0) as usize + 2 } else { 1 };
        Self {
            settings,
            governor: Governor::new(settings.rate),
            cadence: Cadence::new(1.0 / settings.rate),
            times: None,
            // What is kept grows with none of it, for memory is what a soak looks at.
            intervals: Vec::with_capacity(4096),
            busy: (0.0, 0),
            late: 0,
            dropped: 0,
            totals: Totals::default(),
            each: Vec::with_capacity(most.min(1 << 16)),
        }
    }

    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The display shows so many frames a second from now on: that is promised instead. False where it is what was promised before, or within
    /// the little by which displays are off.
    pub fn set_rate(&mut self, rate: f64) -> bool {
        if !(rate.is_finite() && rate > 0.0) || (rate / self.settings.rate - 1.0).abs() < SAME_RATE {
            return false;
        }
        self.settings.rate = rate;
        self.governor.set_rate(rate);
        self.cadence = Cadence::new(1.0 / rate);
        true
    }

    pub fn quality(&self) -> Quality {
        if self.settings.governed { self.governor.quality() } else { Quality::FULL }
    }

    /// The governor's ladder and the number of the rung it is on.
    pub fn ladder(&self) -> (&[Rung], usize) {
        (self.governor.ladder().rungs(), if self.settings.governed { self.governor.rung() } else { 0 })
    }

    pub fn totals(&self) -> &Totals {
        &self.totals
    }

    pub fn each(&self) -> &[Second] {
        &self.each
    }

    /// When to begin the next frame; at once where None.
    pub fn next(&self) -> Option<f64> {
        self.cadence.next()
    }

    /// Lets go of the lines so far: of a session that is only there for its governor.
    pub fn forget(&mut self) {
        self.each.clear();
    }

    /// Seconds since the first frame.
    pub fn lasted(&self) -> f64 {
        self.times.map_or(0.0, |[first, _, last]| last - first)
    }

    pub fn is_over(&self) -> bool {
        self.lasted() >= self.settings.seconds
    }

    /// Time in which no frame was wanted, until a time: it counts for nothing.
    pub fn rest(&mut self, until: f64) {
        self.cadence.rest();
        self.governor.rest();
        if let Some([first, start, last]) = &mut self.times {
            let away = until - *last;
            (*first, *start, *last) = (*first + away, *start + away, until);
        }
    }

    /// A frame was handed over at a time, seconds on a clock that only rises; the device was busy with one for so many ms, where that is
    /// known.
    pub fn frame(&mut self, at: f64, busy_ms: Option<f64>) -> Event {
        let [first, start, last] = *self.times.get_or_insert([at; 3]);
        self.times = Some([first, start, at]);
        if self.totals.frames > 0 && self.intervals.len() < self.intervals.capacity() {
            self.intervals.push(1e3 * (at - last));
        }
        let dropped = self.cadence.frame(at);
        self.totals.frames += 1;
        self.late += u32::from(dropped > 0);
        self.dropped += dropped;
        if let Some(busy) = busy_ms {
            self.busy = (self.busy.0 + busy, self.busy.1 + 1);
        }
        let changed = self.governor.frame(Sample { seconds: at, busy_ms, dropped }) && self.settings.governed;
        if changed {
            self.totals.changes += 1;
            self.totals.lowest_rung = self.totals.lowest_rung.max(self.governor.rung());
            self.cadence.set_period(f64::from(self.quality().refreshes) / self.settings.rate);
        }
        Event { changed, full: at - start >= 1.0 && !self.intervals.is_empty() }
    }

    /// A frame's counts are known, where reasons were counted in it.
    pub fn counted(&mut self, counters: &Counters) {
        self.totals.broken_gaussians = self.totals.broken_gaussians.max(counters.reasons.map(|reasons| reasons.degenerate));
    }

    /// A picture was looked at.
    pub fn seen(&mut self, seen: Seen) {
        self.totals.pictures += 1;
        self.totals.broken_pixels += seen.broken;
        self.totals.empty_pictures += u64::from(seen.covered == 0);
    }

    /// Ends a second. `memory`: bytes in use of the device's memory and of the process's.
    pub fn close(&mut self, reading: &Reading, (device_bytes, resident_bytes): (u64, Option<u64>)) -> &Second {
        let [first, start, last] = self.times.unwrap_or_default();
        if let Some(headroom) = reading.headroom {
            self.governor.headroom(last, headroom);
        }
        self.intervals.sort_unstable_by(f64::total_cmp);
        let at = |share: f64| self.intervals[(share * (self.intervals.len().max(1) - 1) as f64).round() as usize];
        let frames = self.intervals.len() as u32;
        let [p50, p95, p99] = if frames > 0 { [0.5, 0.95, 0.99].map(at) } else { [0.0; 3] };
        let rung = self.ladder().1;
        self.each.push(Second {
            seconds: last - first,
            frames,
            fps: if last > start { f64::from(frames) / (last - start) } else { 0.0 },
            frame_ms_p50: p50,
            frame_ms_p95: p95,
            frame_ms_p99: p99,
            busy_ms: (self.busy.1 > 0).then(|| self.busy.0 / f64::from(self.busy.1)),
            late: self.late,
            dropped: self.dropped,
            headroom: reading.headroom,
            celsius: reading.celsius,
            clock: reading.clock,
            battery: reading.battery,
            watts: reading.watts,
            rung,
            device_bytes,
            resident_bytes,
        });
        self.totals.late += u64::from(self.late);
        self.totals.dropped += u64::from(self.dropped);
        self.intervals.clear();
        (self.busy, self.late, self.dropped) = ((0.0, 0), 0, 0);
        self.times = Some([first, last, last]);
        &self.each[self.each.len() - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn session(governed: bool) -> Session {
        Session::new(Settings { rate: 100.0, governed, seconds: 10.5 })
    }

    /// Frames every `interval` seconds until it is over.
    fn drive(session: &mut Session, interval: f64, busy: f64) {
        let mut at = 5.0;
        while !session.is_over() {
            if session.frame(at, Some(busy)).full {
                session.close(&Reading::default(), (1, Some(2)));
            }
            at += interval;
        }
    }

    #[test]
    fn a_steady_run_is_ten_equal_seconds() {
        let mut session = session(true);
        drive(&mut session, 0.01, 5.0);
        let (each, totals) = (session.each(), session.totals());
        assert_eq!((each.len(), totals.late, totals.dropped, totals.changes), (10, 0, 0, 0));
        assert!(each.iter().all(|second| (99.0..101.0).contains(&second.fps) && (second.frame_ms_p99 - 10.0).abs() < 1e-6), "{each:?}");
        assert!((each[9].seconds - 10.0).abs() < 0.2 && each[9].busy_ms == Some(5.0) && each[9].resident_bytes == Some(2));
    }

    #[test]
    fn slow_frames_are_late_and_move_the_governor_only_where_it_is_on() {
        for governed in [true, false] {
            let mut session = session(governed);
            drive(&mut session, 0.02, 19.0);
            // At its last step the governor has frames shown for two refreshes each.
            assert!(session.totals().dropped >= if governed { 100 } else { 400 }, "{:?}", session.totals());
            assert_eq!(
                (session.totals().changes > 0, session.ladder().1 > 0, session.quality() != Quality::FULL),
                (governed, governed, governed)
            );
        }
    }

    /// A display that was asked for 120 refreshes a second and makes 60 holds frames up by itself: that is no reason to draw less.
    #[test]
    fn a_display_at_half_the_rate_it_was_asked_for_costs_no_quality() {
        for busy in [None, Some(7.5)] {
            let run = |follow: bool| {
                let mut session = Session::new(Settings { rate: 120.0, governed: true, seconds: 20.0 });
                for frame in 0..1200 {
                    if follow && frame == 20 {
                        assert!(session.set_rate(60.0) && !session.set_rate(59.94) && !session.set_rate(f64::NAN));
                    }
                    if session.frame(f64::from(frame) / 60.0, busy).full {
                        session.close(&Reading::default(), (0, None));
                    }
                }
                session
            };
            let (followed, promised) = (run(true), run(false));
            assert_eq!((followed.quality(), followed.ladder().1), (Quality::FULL, 0), "{busy:?}");
            assert!(followed.settings().rate == 60.0 && followed.each()[1..].iter().all(|second| second.dropped == 0), "{busy:?}");
            assert!(promised.ladder().1 > 0, "{busy:?}: without that it falls, and this test shows nothing");
        }
    }

    #[test]
    fn a_rest_counts_for_nothing() {
        let mut session = session(true);
        (0..50).for_each(|k| assert_eq!(session.frame(0.01 * f64::from(k), None), Event::default()));
        session.rest(1000.0);
        let full = (0..60).any(|k| session.frame(1000.0 + 0.01 * f64::from(k), None).full);
        let second = *session.close(&Reading::default(), (0, None));
        assert!(full && second.dropped == 0 && (0.9..1.2).contains(&second.seconds), "{second:?}");
    }
}
