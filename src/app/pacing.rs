//! Frames in step with the display: the times of its refreshes go in; when to begin a frame, when
//! to show it and for which time to draw it come out. Plain arithmetic on a clock that never goes
//! back, seconds.
//!
//! A display that shows frames first in, first out shows them at even intervals even if they were
//! begun at uneven ones. Motion has to be as even as that: a frame is drawn for a refresh of the
//! display, not for the time at which a busy processor came to it. If every frame is shown for
//! several refreshes, frames are begun early enough to be done half a refresh before their own: a
//! frame that is a little early or late is then still shown at the right one.

use std::collections::VecDeque;

/// Refreshes that the period is estimated from.
const HISTORY: usize = 16;
/// Shortest and longest period of a display, seconds.
const PERIOD_MIN: f64 = 1.0 / 500.0;
const PERIOD_MAX: f64 = 0.1;
/// Refreshes older than this say nothing about the next one, seconds.
const STALE: f64 = 0.5;
/// Periods by which a frame's time may be behind the clock, and ahead of it while frames wait in
/// the display's queue.
const BEHIND: f64 = 0.75;
const AHEAD: f64 = 3.5;
/// Factor by which the longest frame's duration is forgotten with every frame.
const FADE: f64 = 0.98;

/// The display's refreshes, and the frames that are drawn for them.
#[derive(Clone, Debug, Default)]
pub struct Pacing {
    /// When the last refreshes began, oldest first.
    refreshes: VecDeque<f64>,
    /// These are times at which images were shown, which are exact.
    are_image_times: bool,
    /// From one refresh to the next, if the display reports it.
    reported_period: Option<f64>,
    last: Option<PacedFrame>,
    /// From the planned beginning of a frame until it can be shown: a recent worst case.
    duration: f64,
    /// How much later than planned the last frame began.
    delay: f64,
}

/// A frame that was begun.
#[derive(Clone, Copy, Debug)]
struct PacedFrame {
    /// The time that its image is for.
    time: f64,
    /// When to show it.
    shown: f64,
}

impl Pacing {
    /// Whether to pass the system's refreshes to [`Self::refresh`]. Their phase is not that of the
    /// display, so they are useless while the display reports when it shows images.
    pub fn wants_refreshes(&self, now: f64) -> bool {
        let is_stale = self.refreshes.back().is_none_or(|&last| now - last > STALE);
        is_stale || !self.are_image_times
    }

    /// The system reports that a refresh began.
    pub fn refresh(&mut self, at: f64) {
        if !self.wants_refreshes(at) {
            return;
        }
        if self.are_image_times {
            self.are_image_times = false;
            self.refreshes.clear();
        }
        self.record(at);
    }

    /// The display reports that an image was shown.
    pub fn image_shown(&mut self, at: f64) {
        if !self.are_image_times {
            self.are_image_times = true;
            self.refreshes.clear();
        }
        self.record(at);
    }

    /// Adds a refresh. One that is not later than the last, or NaN, is ignored.
    fn record(&mut self, at: f64) {
        if !at.is_finite() {
            return;
        }
        if let Some(&last) = self.refreshes.back() {
            if at <= last {
                return;
            }
            if at - last > STALE {
                self.refreshes.clear();
            }
        }
        self.refreshes.push_back(at);
        if self.refreshes.len() > HISTORY {
            self.refreshes.pop_front();
        }
    }

    /// The display reports the time from one refresh to the next. An implausible one is ignored.
    pub fn set_period(&mut self, period: f64) {
        self.reported_period = is_plausible(period).then_some(period);
    }

    /// Refreshes a second, if the display reports them.
    pub fn rate(&self) -> Option<f64> {
        self.reported_period.map(|period| 1.0 / period)
    }

    /// Nothing was drawn for a while.
    pub fn rest(&mut self) {
        self.last = None;
    }

    /// The last frame took this long from its beginning until it could be shown.
    pub fn took(&mut self, seconds: f64) {
        if seconds.is_finite() {
            self.duration = (self.delay + seconds).max(FADE * self.duration).min(1.0);
        }
    }

    /// A frame begins now, to be shown for `refreshes`. Returns the time that its image is for:
    /// `now` if the display's rhythm is unknown.
    pub fn frame(&mut self, now: f64, refreshes: u32) -> f64 {
        let Some(rhythm) = self.rhythm(now) else {
            self.last = None;
            return now;
        };
        let step = f64::from(refreshes) * rhythm.period;
        self.delay = self
            .next_frame(now, refreshes)
            .map_or(0.0, |planned| (now - planned).clamp(0.0, step));
        let due = rhythm.nearest(self.last.map_or(now, |last| last.time + step));
        let time = if (-BEHIND..=AHEAD).contains(&((due - now) / rhythm.period)) {
            due
        } else {
            // The frame is too early or too late for its turn. Time still must not go back.
            let last_time = self.last.map_or(f64::NEG_INFINITY, |last| last.time);
            rhythm.nearest(now).max(last_time)
        };
        let soonest = now - self.delay + self.duration;
        let shown = self
            .last
            .map(|last| rhythm.nearest(last.shown + step))
            .filter(|&shown| shown >= soonest && shown - soonest < 2.0 * step)
            .unwrap_or_else(|| rhythm.first_after(soonest));
        self.last = Some(PacedFrame { time, shown });
        time
    }

    /// When to begin the next frame. None: as soon as the display takes one.
    pub fn next_frame(&self, now: f64, refreshes: u32) -> Option<f64> {
        if refreshes <= 1 {
            return None;
        }
        let rhythm = self.rhythm(now)?;
        let last = self.last?;
        let step = f64::from(refreshes) * rhythm.period;
        Some(last.shown + step - (self.duration + 0.5 * rhythm.period).min(step))
    }

    /// The earliest time to show the frame that was begun last: half a refresh before its own.
    /// None: as soon as possible.
    pub fn show_at(&self, now: f64, refreshes: u32) -> Option<f64> {
        if refreshes <= 1 {
            return None;
        }
        let rhythm = self.rhythm(now)?;
        Some(self.last?.shown - 0.5 * rhythm.period)
    }

    /// None if too few refreshes are known, or the last one is too old.
    fn rhythm(&self, now: f64) -> Option<Rhythm> {
        let phase = *self.refreshes.back()?;
        if now - phase > STALE {
            return None;
        }
        let period = self.reported_period.or_else(|| self.estimated_period())?;
        Some(Rhythm { phase, period })
    }

    /// The period by the times of the last refreshes.
    fn estimated_period(&self) -> Option<f64> {
        let intervals = || {
            let next = self.refreshes.iter().skip(1);
            self.refreshes.iter().zip(next).map(|(from, to)| to - from)
        };
        if intervals().len() < 2 {
            return None;
        }
        let shortest = intervals()
            .filter(|interval| *interval >= PERIOD_MIN)
            .reduce(f64::min)?;
        // Not every refresh is reported: an interval may be several periods long.
        let mut span = 0.0;
        let mut periods = 0.0;
        for interval in intervals() {
            span += interval;
            periods += (interval / shortest).round();
        }
        let period = span / periods;
        is_plausible(period).then_some(period)
    }
}

fn is_plausible(period: f64) -> bool {
    (PERIOD_MIN..=PERIOD_MAX).contains(&period)
}

/// Refreshes at even intervals.
#[derive(Clone, Copy)]
struct Rhythm {
    /// When one of them begins.
    phase: f64,
    /// From one to the next.
    period: f64,
}

impl Rhythm {
    /// The refresh nearest to a time.
    fn nearest(&self, time: f64) -> f64 {
        self.phase + ((time - self.phase) / self.period).round() * self.period
    }

    /// The first refresh at or after a time.
    fn first_after(&self, time: f64) -> f64 {
        self.phase + ((time - self.phase) / self.period).ceil() * self.period
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f64 = 1.0 / 120.0;

    /// A reproducible disorder between 0 and 1.
    fn noise(number: u32) -> f64 {
        f64::from(number.wrapping_mul(2_654_435_761) >> 8) / f64::from(1u32 << 24)
    }

    /// A display that shows frames first in, first out, at most two of them waiting.
    #[derive(Clone, Copy)]
    struct SimulatedDisplay {
        /// Refreshes that every frame is shown for.
        refreshes: u32,
        /// It reports its refreshes.
        reports: bool,
        /// It keeps frames back until they are due.
        schedules: bool,
    }

    /// Draws frames on a processor that begins each up to 0.4 periods late. `work`: how long a
    /// frame takes, in periods, by its number.
    fn draw(display: SimulatedDisplay, work: impl Fn(u32) -> f64) -> Vec<PacedFrame> {
        let refreshes = display.refreshes;
        let mut pacing = Pacing::default();
        let mut frames = Vec::<PacedFrame>::new();
        let mut next_refresh = 0;
        let mut last_begun = f64::NEG_INFINITY;
        let mut last_done = 0.0_f64;
        for number in 0..600 {
            let slot_free = match frames.len().checked_sub(2) {
                Some(second_last) => frames[second_last].shown,
                None => 0.0,
            };
            let mut begin = last_done.max(slot_free);
            let planned = if refreshes > 1 {
                let without_reports = last_begun + (f64::from(refreshes) - 0.5) * PERIOD;
                pacing
                    .next_frame(begin, refreshes)
                    .unwrap_or(without_reports)
            } else {
                0.0
            };
            begin = begin.max(planned) + 0.4 * noise(7 * number + 3) * PERIOD;
            while display.reports && f64::from(next_refresh) * PERIOD <= begin {
                pacing.refresh(f64::from(next_refresh) * PERIOD);
                next_refresh += 1;
            }
            let time = pacing.frame(begin, refreshes);
            let done = begin + work(number) * PERIOD;
            pacing.took(done - begin);
            let mut ready = done;
            if display.schedules
                && let Some(due) = pacing.show_at(begin, refreshes)
            {
                ready = ready.max(due);
            }
            if let Some(last) = frames.last() {
                ready = ready.max(last.shown + 0.99 * PERIOD);
            }
            let shown = (ready / PERIOD).ceil() * PERIOD;
            frames.push(PacedFrame { time, shown });
            last_done = done;
            last_begun = begin;
        }
        frames.split_off(60)
    }

    /// Share of the frames whose time moves on by more or less than they are shown for, by a tenth
    /// of a period.
    fn uneven(frames: &[PacedFrame]) -> f64 {
        let uneven = frames.windows(2).filter(|pair| {
            let time = pair[1].time - pair[0].time;
            let shown = pair[1].shown - pair[0].shown;
            (time - shown).abs() > 0.1 * PERIOD
        });
        uneven.count() as f64 / (frames.len() - 1) as f64
    }

    /// Share of the frames that are shown for more or fewer refreshes than planned.
    fn misplaced(frames: &[PacedFrame], refreshes: u32) -> f64 {
        let planned = f64::from(refreshes) * PERIOD;
        let misplaced = frames
            .windows(2)
            .filter(|pair| (pair[1].shown - pair[0].shown - planned).abs() > 0.1 * PERIOD);
        misplaced.count() as f64 / (frames.len() - 1) as f64
    }

    #[test]
    fn motion_is_as_even_as_the_display() {
        let silent = SimulatedDisplay {
            refreshes: 1,
            reports: false,
            schedules: false,
        };
        let reporting = SimulatedDisplay {
            reports: true,
            ..silent
        };
        let work = |number| 0.3 + 0.6 * noise(number);
        assert!(
            uneven(&draw(silent, work)) > 0.3,
            "without reports the clock's unevenness shows"
        );
        let frames = draw(reporting, work);
        assert_eq!(misplaced(&frames, 1), 0.0);
        assert_eq!(uneven(&frames), 0.0);
        // One frame in a hundred takes four refreshes: only these are made up for.
        let hitches = draw(reporting, |number| {
            if number % 100 == 50 {
                4.0
            } else {
                work(number)
            }
        });
        assert!(uneven(&hitches) <= 0.03, "{}", uneven(&hitches));
        assert!(hitches.windows(2).all(|pair| pair[1].time > pair[0].time));
    }

    #[test]
    fn frames_of_two_refreshes_are_shown_for_two() {
        let silent = SimulatedDisplay {
            refreshes: 2,
            reports: false,
            schedules: false,
        };
        // About one and a half periods: near the edge between one refresh and the next, where the
        // clock alone can't decide.
        let work = |number| 1.1 + 0.3 * noise(number);
        assert!(misplaced(&draw(silent, work), 2) > 0.05);
        for schedules in [false, true] {
            let display = SimulatedDisplay {
                reports: true,
                schedules,
                ..silent
            };
            let frames = draw(display, work);
            assert_eq!(misplaced(&frames, 2), 0.0, "schedules: {schedules}");
            assert_eq!(uneven(&frames), 0.0, "schedules: {schedules}");
        }
        // Frames of very different durations need a display that keeps the early ones back.
        let variable = |number| 0.1 + 1.3 * noise(number);
        let scheduling = SimulatedDisplay {
            reports: true,
            schedules: true,
            ..silent
        };
        let frames = draw(scheduling, variable);
        assert_eq!(misplaced(&frames, 2), 0.0);
        assert_eq!(uneven(&frames), 0.0);
        assert!(misplaced(&draw(silent, variable), 2) > 0.2);
    }

    #[test]
    fn the_rhythm_is_learned_lost_and_learned_again() {
        let mut pacing = Pacing::default();
        assert_eq!(pacing.frame(5.0, 1), 5.0);
        for number in [0, 1, 3, 4, 8, 9] {
            pacing.refresh(10.0 + f64::from(number) / 60.0);
        }
        pacing.refresh(f64::NAN);
        pacing.refresh(3.0);
        let time = pacing.frame(10.16, 1);
        assert!((time - (10.0 + 10.0 / 60.0)).abs() < 1e-9, "{time}");
        assert!(pacing.next_frame(10.16, 1).is_none());
        assert!(
            pacing
                .next_frame(10.16, 2)
                .is_some_and(|next| next > 10.16 && next < 10.25)
        );
        assert_eq!(pacing.frame(20.0, 1), 20.0, "the last refresh is too old");
        assert_eq!(pacing.next_frame(20.0, 2), None);

        for number in 0..9 {
            pacing.refresh(30.0 + f64::from(number) / 144.0);
        }
        let times = [30.06, 30.066].map(|now| pacing.frame(now, 1));
        assert!(
            (times[1] - times[0] - 1.0 / 144.0).abs() < 1e-9,
            "{times:?}"
        );
    }

    #[test]
    fn image_times_take_precedence_while_they_come() {
        let mut pacing = Pacing::default();
        for number in 0..9 {
            pacing.refresh(30.0 + f64::from(number) / 144.0);
        }
        pacing.image_shown(30.075);
        pacing.refresh(30.07);
        assert_eq!(pacing.frame(30.08, 1), 30.08, "one image is no rhythm yet");
        pacing.rest();
        pacing.set_period(1.0 / 90.0);
        let phase_error = |periods: f64| (periods - periods.round()).abs();
        assert!(
            phase_error((pacing.frame(30.2, 1) - 30.075) * 90.0) < 1e-6,
            "in step with the images"
        );
        pacing.refresh(31.0);
        pacing.refresh(31.0 + 1.0 / 90.0);
        pacing.rest();
        assert!(
            phase_error((pacing.frame(31.1, 1) - 31.0) * 90.0) < 1e-6,
            "the display no longer reports images"
        );
    }
}
