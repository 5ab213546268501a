//! The records of a soak: frames and readings go in, the quality to draw at and a [`Second`] each
//! second come out. A session knows neither device nor clock.

use super::{cadence::Cadence, report::Second};
use effigy_core::frame::Counters;
use effigy_render::vulkan::PixelCounts;
use effigy_runtime::{
    governor::{FrameQuality, Governor, Rung, Sample},
    thermals::ThermalReading,
};

/// Rates that differ by a smaller share count as equal.
const RATE_TOLERANCE: f64 = 0.02;
/// Frames of a second that are recorded; any more are not.
const MAX_FRAMES_A_SECOND: usize = 4096;
/// Seconds for which memory is taken at the start.
const MAX_RESERVED_SECONDS: usize = 1 << 16;

/// Settings of a soak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoakSettings {
    /// The promised rate, frames a second.
    pub rate: f64,
    /// Whether the governor may give up quality for it.
    pub governed: bool,
    /// How long to draw, seconds.
    pub seconds: f64,
}

/// Duties of the caller after a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameEvent {
    /// Draw at the new [`Session::quality`].
    pub changed: bool,
    /// Call [`Session::close_second`].
    pub full: bool,
}

/// Counts over the whole run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Totals {
    /// Frames drawn.
    pub frames: u64,
    /// Frames that were late, up to the last full second.
    pub late: u64,
    /// Refreshes without a new frame, up to the last full second.
    pub dropped: u64,
    /// Changes of quality.
    pub changes: usize,
    /// The lowest rung that the governor was on.
    pub lowest_rung: usize,
    /// Images that were checked.
    pub images: u64,
    /// Pixels in them that are NaN or infinite.
    pub broken_pixels: u64,
    /// Checked images in which nothing is covered.
    pub empty_images: u64,
    /// Most Gaussians of one frame whose place or shape is NaN or out of range of f32. None if they
    /// were not counted.
    pub broken_gaussians: Option<u64>,
}

/// Times on the caller's clock, seconds.
#[derive(Clone, Copy, Debug, Default)]
struct SoakClock {
    first_frame: f64,
    second_start: f64,
    last_frame: f64,
}

/// GPU times of a second's frames.
#[derive(Clone, Copy, Debug, Default)]
struct BusyTime {
    total_ms: f64,
    frames: u32,
}

/// A soak in progress.
pub struct Session {
    settings: SoakSettings,
    governor: Governor,
    cadence: Cadence,
    /// None before the first frame.
    clock: Option<SoakClock>,
    /// Of this second: times from frame to frame, ms.
    intervals: Vec<f64>,
    /// Of this second.
    busy: BusyTime,
    late: u32,
    dropped: u32,
    totals: Totals,
    seconds: Vec<Second>,
}

impl Session {
    /// A session before its first frame.
    pub fn new(settings: SoakSettings) -> Self {
        let expected_seconds = if settings.seconds.is_finite() {
            settings.seconds.max(0.0) as usize + 2
        } else {
            1
        };
        Self {
            settings,
            governor: Governor::new(settings.rate),
            cadence: Cadence::new(1.0 / settings.rate),
            clock: None,
            // Memory is taken at once: a soak checks that it does not grow.
            intervals: Vec::with_capacity(MAX_FRAMES_A_SECOND),
            busy: BusyTime::default(),
            late: 0,
            dropped: 0,
            totals: Totals::default(),
            seconds: Vec::with_capacity(expected_seconds.min(MAX_RESERVED_SECONDS)),
        }
    }

    /// The settings, with the rate that is promised now.
    pub fn settings(&self) -> &SoakSettings {
        &self.settings
    }

    /// Promises the rate that a display has changed to, frames a second. False if it is invalid or
    /// the promised one, within the tolerance of displays.
    pub fn set_rate(&mut self, rate: f64) -> bool {
        let is_valid = rate.is_finite() && rate > 0.0;
        if !is_valid || (rate / self.settings.rate - 1.0).abs() < RATE_TOLERANCE {
            return false;
        }
        self.settings.rate = rate;
        self.governor.set_rate(rate);
        self.cadence = Cadence::new(1.0 / rate);
        true
    }

    /// The quality to draw the next frame at.
    pub fn quality(&self) -> FrameQuality {
        if self.settings.governed {
            self.governor.quality()
        } else {
            FrameQuality::FULL
        }
    }

    /// The governor's ladder.
    pub fn rungs(&self) -> &[Rung] {
        self.governor.ladder().rungs()
    }

    /// Index of the rung that is drawn at.
    pub fn rung(&self) -> usize {
        if self.settings.governed {
            self.governor.rung()
        } else {
            0
        }
    }

    /// The governor's ladder and the index of the rung that is drawn at.
    pub fn ladder(&self) -> (&[Rung], usize) {
        (self.rungs(), self.rung())
    }

    /// Counts so far.
    pub fn totals(&self) -> &Totals {
        &self.totals
    }

    /// All full seconds so far.
    pub fn seconds(&self) -> &[Second] {
        &self.seconds
    }

    /// When to begin the next frame, seconds. None: at once.
    pub fn next_frame(&self) -> Option<f64> {
        self.cadence.next_frame()
    }

    /// Drops the recorded seconds. For a session that is used for its governor alone.
    pub fn clear_seconds(&mut self) {
        self.seconds.clear();
    }

    /// Seconds from the first frame to the last.
    pub fn lasted(&self) -> f64 {
        let clock = self.clock.unwrap_or_default();
        clock.last_frame - clock.first_frame
    }

    /// Whether the time is over.
    pub fn is_over(&self) -> bool {
        self.lasted() >= self.settings.seconds
    }

    /// Leaves out a time in which no frame was wanted, until `until`.
    pub fn skip_idle(&mut self, until: f64) {
        self.cadence.skip_idle();
        self.governor.skip_idle();
        if let Some(clock) = &mut self.clock {
            let idle = until - clock.last_frame;
            clock.first_frame += idle;
            clock.second_start += idle;
            clock.last_frame = until;
        }
    }

    /// Adds a frame that was submitted at `seconds` on a monotonic clock, and its GPU time, if
    /// known.
    pub fn add_frame(&mut self, seconds: f64, busy_ms: Option<f64>) -> FrameEvent {
        let clock = self.clock.get_or_insert(SoakClock {
            first_frame: seconds,
            second_start: seconds,
            last_frame: seconds,
        });
        if self.totals.frames > 0 && self.intervals.len() < self.intervals.capacity() {
            self.intervals.push(1e3 * (seconds - clock.last_frame));
        }
        clock.last_frame = seconds;
        let second_start = clock.second_start;

        let dropped = self.cadence.add_frame(seconds);
        self.totals.frames += 1;
        self.late += u32::from(dropped > 0);
        self.dropped += dropped;
        if let Some(busy_ms) = busy_ms {
            self.busy.total_ms += busy_ms;
            self.busy.frames += 1;
        }

        let stepped = self.governor.add_frame(Sample {
            seconds,
            busy_ms,
            dropped,
        });
        let changed = stepped && self.settings.governed;
        if changed {
            self.totals.changes += 1;
            let rungs = self.governor.ladder().rungs();
            let [lowest, now] = [self.totals.lowest_rung, self.governor.rung()];
            if rungs[now].cost < rungs[lowest].cost {
                self.totals.lowest_rung = now;
            }
            let refreshes = f64::from(self.quality().refreshes);
            self.cadence.set_period(refreshes / self.settings.rate);
        }
        FrameEvent {
            changed,
            full: seconds - second_start >= 1.0 && !self.intervals.is_empty(),
        }
    }

    /// Adds the counts of a finished frame.
    pub fn add_counters(&mut self, counters: &Counters) {
        let degenerate = counters.reasons.map(|reasons| reasons.degenerate);
        self.totals.broken_gaussians = self.totals.broken_gaussians.max(degenerate);
        if counters.longest_side > 0 {
            // A lower resolution must not make an avatar small.
            let scale = self.quality().scale;
            self.governor
                .note_side(counters.longest_side as f64 / scale);
        }
    }

    /// Adds the check of an image.
    pub fn add_image_check(&mut self, check: PixelCounts) {
        self.totals.images += 1;
        self.totals.broken_pixels += check.broken;
        self.totals.empty_images += u64::from(check.covered == 0);
    }

    /// Ends a second and records it with the system's readings and the memory in use: device
    /// memory, and resident memory of the process.
    pub fn close_second(
        &mut self,
        reading: &ThermalReading,
        device_bytes: u64,
        resident_bytes: Option<u64>,
    ) -> &Second {
        let mut clock = self.clock.unwrap_or_default();
        if let Some(headroom) = reading.headroom {
            self.governor.add_headroom(clock.last_frame, headroom);
        }
        self.intervals.sort_unstable_by(f64::total_cmp);
        let frames = self.intervals.len() as u32;
        let length = clock.last_frame - clock.second_start;
        let fps = if length > 0.0 {
            f64::from(frames) / length
        } else {
            0.0
        };
        let busy = std::mem::take(&mut self.busy);
        let rung = self.rung();
        self.seconds.push(Second {
            seconds: clock.last_frame - clock.first_frame,
            frames,
            fps,
            frame_ms_p50: percentile(&self.intervals, 0.5),
            frame_ms_p95: percentile(&self.intervals, 0.95),
            frame_ms_p99: percentile(&self.intervals, 0.99),
            busy_ms: (busy.frames > 0).then(|| busy.total_ms / f64::from(busy.frames)),
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
        self.late = 0;
        self.dropped = 0;
        clock.second_start = clock.last_frame;
        self.clock = Some(clock);
        &self.seconds[self.seconds.len() - 1]
    }
}

/// A percentile of sorted values; 0 of none.
fn percentile(sorted: &[f64], share: f64) -> f64 {
    let index = (share * (sorted.len().max(1) - 1) as f64).round() as usize;
    sorted.get(index).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn session(governed: bool) -> Session {
        Session::new(SoakSettings {
            rate: 100.0,
            governed,
            seconds: 10.5,
        })
    }

    /// Adds a frame every `interval` seconds until the session is over.
    fn drive(session: &mut Session, interval: f64, busy: f64) {
        let mut at = 5.0;
        while !session.is_over() {
            if session.add_frame(at, Some(busy)).full {
                session.close_second(&ThermalReading::default(), 1, Some(2));
            }
            at += interval;
        }
    }

    #[test]
    fn a_steady_run_is_ten_equal_seconds() {
        let mut session = session(true);
        drive(&mut session, 0.01, 5.0);
        let seconds = session.seconds();
        let totals = session.totals();
        assert_eq!(
            (seconds.len(), totals.late, totals.dropped, totals.changes),
            (10, 0, 0, 0)
        );
        for second in seconds {
            assert!((99.0..101.0).contains(&second.fps), "{second:?}");
            assert!((second.frame_ms_p99 - 10.0).abs() < 1e-6, "{second:?}");
        }
        let last = &seconds[9];
        assert!((last.seconds - 10.0).abs() < 0.2, "{last:?}");
        assert_eq!((last.busy_ms, last.resident_bytes), (Some(5.0), Some(2)));
    }

    #[test]
    fn slow_frames_move_the_governor_only_if_it_is_on() {
        for governed in [true, false] {
            let mut session = session(governed);
            drive(&mut session, 0.02, 19.0);
            // At the governor's last step each frame is shown for two refreshes.
            assert!(
                session.totals().dropped >= if governed { 100 } else { 400 },
                "{:?}",
                session.totals()
            );
            assert_eq!(
                (
                    session.totals().changes > 0,
                    session.ladder().1 > 0,
                    session.quality() != FrameQuality::FULL
                ),
                (governed, governed, governed)
            );
        }
    }

    /// A display that was to make 120 refreshes a second and makes 60 holds frames up by itself:
    /// that is no reason to draw less.
    #[test]
    fn a_display_at_half_its_expected_rate_costs_no_quality() {
        for busy in [None, Some(7.5)] {
            let run = |follow: bool| {
                let mut session = Session::new(SoakSettings {
                    rate: 120.0,
                    governed: true,
                    seconds: 20.0,
                });
                for frame in 0..1200 {
                    if follow && frame == 20 {
                        assert!(
                            session.set_rate(60.0)
                                && !session.set_rate(59.94)
                                && !session.set_rate(f64::NAN)
                        );
                    }
                    if session.add_frame(f64::from(frame) / 60.0, busy).full {
                        session.close_second(&ThermalReading::default(), 0, None);
                    }
                }
                session
            };
            let followed = run(true);
            let promised = run(false);
            assert_eq!(
                (followed.quality(), followed.ladder().1),
                (FrameQuality::FULL, 0),
                "{busy:?}"
            );
            assert!(
                followed.settings().rate == 60.0
                    && followed.seconds()[1..]
                        .iter()
                        .all(|second| second.dropped == 0),
                "{busy:?}"
            );
            assert!(
                promised.ladder().1 > 0,
                "{busy:?}: quality must fall without it, or this test shows nothing"
            );
        }
    }

    #[test]
    fn idle_time_counts_for_nothing() {
        let mut session = session(true);
        for k in 0..50 {
            let event = session.add_frame(0.01 * f64::from(k), None);
            assert_eq!(event, FrameEvent::default());
        }
        session.skip_idle(1000.0);
        let full = (0..60).any(|k| session.add_frame(1000.0 + 0.01 * f64::from(k), None).full);
        let second = *session.close_second(&ThermalReading::default(), 0, None);
        assert!(
            full && second.dropped == 0 && (0.9..1.2).contains(&second.seconds),
            "{second:?}"
        );
    }
}
