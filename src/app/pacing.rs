//! Frames in step with the display: the times of its refreshes go in; when to begin a frame, when it is to be shown and which moment it is a
//! picture of come out. Plain arithmetic on a clock that only rises, seconds.
//!
//! A display that shows frames first in, first out shows them evenly even where they were begun unevenly. What moves has to be as even as
//! that: a frame is a picture of a time on the display's beat, not of the moment at which a busy processor came to it. Where every frame is
//! shown for several refreshes, frames are begun so early that they are done half a refresh before the one that they are for: what is a
//! little early or late is then shown with the same one.

use std::collections::VecDeque;

/// Refreshes that the beat is taken from.
const TICKS: usize = 16;
/// Refreshes are no shorter and no longer than this, seconds.
const PERIODS: [f64; 2] = [1.0 / 500.0, 0.1];
/// A beat that was heard longer ago than this is forgotten, seconds.
const STALE: f64 = 0.5;
/// Periods by which a frame's time may be behind the clock, and ahead of it while frames wait in the display's queue.
const BEHIND: f64 = 0.75;
const AHEAD: f64 = 3.5;
/// What is left of the longest frame's time after another frame.
const FADE: f64 = 0.98;

/// The display's beat, and the frames on it.
#[derive(Clone, Debug, Default)]
pub struct Pacing {
    ticks: VecDeque<f64>,
    /// They are the times at which images were shown.
    exact: bool,
    /// From one refresh to the next, where the display says so itself.
    told: Option<f64>,
    /// The time that the last frame is a picture of, and when it is to be shown.
    last: Option<[f64; 2]>,
    /// From when a frame was to begin until it can be shown: a recent worst case.
    work: f64,
    /// How much later than that the last one began.
    lag: f64,
}

impl Pacing {
    /// Whether the system is to tell of refreshes: its have another phase than what the display shows, so they are of no use while the
    /// display tells of its images.
    pub fn wants_ticks(&self, now: f64) -> bool {
        !self.exact || self.ticks.back().is_none_or(|&last| now - last > STALE)
    }

    /// The system says that a refresh began.
    pub fn tick(&mut self, at: f64) {
        if self.wants_ticks(at) {
            if std::mem::take(&mut self.exact) {
                self.ticks.clear();
            }
            self.hear(at);
        }
    }

    /// The display says that an image was shown.
    pub fn shown(&mut self, at: f64) {
        if !self.exact {
            self.exact = true;
            self.ticks.clear();
        }
        self.hear(at);
    }

    /// One that is no later than the last one known, or no number, says nothing.
    fn hear(&mut self, at: f64) {
        if !at.is_finite() || self.ticks.back().is_some_and(|&last| at <= last) {
            return;
        }
        if self.ticks.back().is_some_and(|&last| at - last > STALE) {
            self.ticks.clear();
        }
        self.ticks.push_back(at);
        if self.ticks.len() > TICKS {
            self.ticks.pop_front();
        }
    }

    /// The display says how long its refreshes are.
    pub fn set_period(&mut self, period: f64) {
        self.told = Some(period).filter(|period| (PERIODS[0]..=PERIODS[1]).contains(period));
    }

    /// Refreshes a second, where the display says so itself.
    pub fn rate(&self) -> Option<f64> {
        self.told.map(|period| 1.0 / period)
    }

    /// Nothing was to be drawn for a while.
    pub fn rest(&mut self) {
        self.last = None;
    }

    /// A frame took so long from its beginning until it could be shown.
    pub fn took(&mut self, seconds: f64) {
        if seconds.is_finite() {
            self.work = (self.lag + seconds).max(FADE * self.work).min(1.0);
        }
    }

    /// A frame begins now. Gives the time that it is a picture of: the clock's, where no beat is known.
    pub fn frame(&mut self, now: f64, refreshes: u32) -> f64 {
        let Some(beat) = self.beat(now) else {
            self.last = None;
            return now;
        };
        let step = f64::from(refreshes) * beat.period;
        self.lag = self.begin(now, refreshes).map_or(0.0, |begin| (now - begin).clamp(0.0, step));
        let due = beat.nearest(self.last.map_or(now, |[last, _]| last + step));
        let fits = (-BEHIND..=AHEAD).contains(&((due - now) / beat.period));
        let time = if fits { due } else { beat.nearest(now).max(self.last.map_or(f64::NEG_INFINITY, |[last, _]| last)) };
        let soonest = now - self.lag + self.work;
        let wanted =
            self.last.map(|[_, shown]| beat.nearest(shown + step)).filter(|&wanted| wanted >= soonest && wanted - soonest < 2.0 * step);
        self.last = Some([time, wanted.unwrap_or_else(|| beat.after(soonest))]);
        time
    }

    /// When to begin the next frame. None: as soon as the display takes one.
    pub fn begin(&self, now: f64, refreshes: u32) -> Option<f64> {
        let (Some(beat), Some([_, shown]), true) = (self.beat(now), self.last, refreshes > 1) else { return None };
        let step = f64::from(refreshes) * beat.period;
        Some(shown + step - (self.work + 0.5 * beat.period).min(step))
    }

    /// Before when the frame that was begun last is not to be shown: half a refresh before the one that it is for. None: as soon as can be.
    pub fn show(&self, now: f64, refreshes: u32) -> Option<f64> {
        let (Some(beat), Some([_, shown]), true) = (self.beat(now), self.last, refreshes > 1) else { return None };
        Some(shown - 0.5 * beat.period)
    }

    fn beat(&self, now: f64) -> Option<Beat> {
        let phase = *self.ticks.back().filter(|&&last| now - last <= STALE)?;
        let intervals = || self.ticks.iter().zip(self.ticks.iter().skip(1)).map(|(from, to)| to - from);
        let heard = || {
            let shortest = intervals().filter(|interval| *interval >= PERIODS[0]).reduce(f64::min)?;
            // Not every refresh is heard of.
            let (span, count) =
                intervals().fold((0.0, 0.0), |(span, count), interval| (span + interval, count + (interval / shortest).round()));
            Some(span / count).filter(|period| intervals().len() > 1 && (PERIODS[0]..=PERIODS[1]).contains(period))
        };
        Some(Beat { phase, period: self.told.or_else(heard)? })
    }
}

/// Refreshes at even distances.
#[derive(Clone, Copy)]
struct Beat {
    phase: f64,
    period: f64,
}

impl Beat {
    fn nearest(&self, time: f64) -> f64 {
        self.phase + ((time - self.phase) / self.period).round() * self.period
    }

    /// The first at or after a time.
    fn after(&self, time: f64) -> f64 {
        self.phase + ((time - self.phase) / self.period).ceil() * self.period
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f64 = 1.0 / 120.0;

    /// Every so often the same disorder between 0 and 1.
    fn noise(number: u32) -> f64 {
        f64::from(number.wrapping_mul(2_654_435_761) >> 8) / f64::from(1u32 << 24)
    }

    /// Draws frames for a display that shows them first in, first out, two waiting at most, on a processor that comes to each up to 0.4 periods
    /// late. `work` gives a frame's time in periods; `heard`:
    /// the display tells of its refreshes; `held`: it keeps frames back until they are due. Gives each frame's time and when it was shown.
    fn draw(refreshes: u32, work: impl Fn(u32) -> f64, heard: bool, held: bool) -> Vec<[f64; 2]> {
        let (mut pacing, mut frames, mut told) = (Pacing::default(), Vec::<[f64; 2]>::new(), 0);
        let (mut free, mut begun) = (0.0_f64, f64::NEG_INFINITY);
        for number in 0..600 {
            let taken = frames.len().checked_sub(2).map_or(0.0, |older: usize| frames[older][1]);
            let mut begin = free.max(taken);
            let unheard = begun + (f64::from(refreshes) - 0.5) * PERIOD;
            begin = begin.max(pacing.begin(begin, refreshes).unwrap_or(if refreshes > 1 { unheard } else { 0.0 }));
            begin += 0.4 * noise(7 * number + 3) * PERIOD;
            while heard && f64::from(told) * PERIOD <= begin {
                pacing.tick(f64::from(told) * PERIOD);
                told += 1;
            }
            let time = pacing.frame(begin, refreshes);
            let done = begin + work(number) * PERIOD;
            pacing.took(done - begin);
            let due = pacing.show(begin, refreshes).filter(|_| held).unwrap_or(0.0);
            let before = frames.last().map_or(0.0, |last| last[1] + PERIOD);
            let shown = (done.max(due).max(before - 0.01 * PERIOD) / PERIOD).ceil() * PERIOD;
            frames.push([time, shown]);
            (free, begun) = (done, begin);
        }
        frames.split_off(60)
    }

    /// Share of the frames whose time moved on by something else than what they were shown for, by more than a tenth of a period.
    fn uneven(frames: &[[f64; 2]]) -> f64 {
        let wrong = frames.windows(2).filter(|pair| ((pair[1][0] - pair[0][0]) - (pair[1][1] - pair[0][1])).abs() > 0.1 * PERIOD);
        wrong.count() as f64 / (frames.len() - 1) as f64
    }

    /// Share of the frames that were shown for another number of refreshes than they were meant for.
    fn astray(frames: &[[f64; 2]], refreshes: u32) -> f64 {
        let meant = f64::from(refreshes) * PERIOD;
        frames.windows(2).filter(|pair| (pair[1][1] - pair[0][1] - meant).abs() > 0.1 * PERIOD).count() as f64 / (frames.len() - 1) as f64
    }

    #[test]
    fn what_moves_is_as_even_as_what_is_shown() {
        let work = |number| 0.3 + 0.6 * noise(number);
        assert!(uneven(&draw(1, work, false, false)) > 0.3, "without a beat the clock's unevenness is seen");
        let frames = draw(1, work, true, false);
        assert_eq!((astray(&frames, 1), uneven(&frames)), (0.0, 0.0));
        // One frame in a hundred takes four refreshes: what was missed is made up for, not more.
        let hitches = draw(1, |number| if number % 100 == 50 { 4.0 } else { work(number) }, true, false);
        assert!(uneven(&hitches) <= 0.03, "{}", uneven(&hitches));
        assert!(hitches.windows(2).all(|pair| pair[1][0] > pair[0][0]));
    }

    #[test]
    fn frames_of_two_refreshes_are_shown_for_two() {
        // About one and a half: near the edge between one refresh and the next, where the clock alone can't decide.
        let work = |number| 1.1 + 0.3 * noise(number);
        assert!(astray(&draw(2, work, false, false), 2) > 0.05);
        for held in [false, true] {
            let frames = draw(2, work, true, held);
            assert_eq!((astray(&frames, 2), uneven(&frames)), (0.0, 0.0), "held: {held}");
        }
        // Frames of very different times want a display that keeps the early ones back.
        let wild = |number| 0.1 + 1.3 * noise(number);
        let frames = draw(2, wild, true, true);
        assert_eq!((astray(&frames, 2), uneven(&frames)), (0.0, 0.0));
        assert!(astray(&draw(2, wild, false, false), 2) > 0.2);
    }

    #[test]
    fn a_beat_is_learned_lost_and_learned_anew() {
        let mut pacing = Pacing::default();
        assert_eq!(pacing.frame(5.0, 1), 5.0);
        for number in [0, 1, 3, 4, 8, 9] {
            pacing.tick(10.0 + f64::from(number) / 60.0);
        }
        pacing.tick(f64::NAN);
        pacing.tick(3.0);
        let time = pacing.frame(10.16, 1);
        assert!((time - (10.0 + 10.0 / 60.0)).abs() < 1e-9, "{time}");
        assert!(pacing.begin(10.16, 1).is_none() && pacing.begin(10.16, 2).is_some_and(|begin| begin > 10.16 && begin < 10.25));
        assert_eq!((pacing.frame(20.0, 1), pacing.begin(20.0, 2)), (20.0, None), "the beat is too old");
        (0..9).for_each(|number| pacing.tick(30.0 + f64::from(number) / 144.0));
        let times = [30.06, 30.066].map(|now| pacing.frame(now, 1));
        assert!((times[1] - times[0] - 1.0 / 144.0).abs() < 1e-9, "{times:?}");
        pacing.shown(30.075);
        pacing.tick(30.07);
        assert_eq!(pacing.frame(30.08, 1), 30.08, "one image is no beat yet");
        pacing.rest();
        pacing.set_period(1.0 / 90.0);
        let off = |beats: f64| (beats - beats.round()).abs();
        assert!(off((pacing.frame(30.2, 1) - 30.075) * 90.0) < 1e-6, "on the images' beat");
        pacing.tick(31.0);
        pacing.tick(31.0 + 1.0 / 90.0);
        pacing.rest();
        assert!(off((pacing.frame(31.1, 1) - 31.0) * 90.0) < 1e-6, "the display no longer tells of images");
    }
}
