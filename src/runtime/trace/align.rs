//! The device's clock on the host's time: moments read on both clocks go in, a mapping comes out.

use effigy_render::vulkan::ClockMoment;
use std::time::Instant;

/// Moments closer together than this are too close to measure the clocks' relative rate, ns.
const MIN_DISTANCE: f64 = 5e8;

/// The device's timestamp counter.
#[derive(Clone, Copy, Debug)]
pub struct Clock {
    /// Mask of the valid bits of a timestamp: it wraps to 0 after this.
    pub mask: u64,
    /// Nanoseconds a tick, according to the driver.
    pub period: f64,
}

impl Clock {
    /// Ticks from one timestamp to another; negative if the other is earlier.
    fn ticks_between(&self, from: u64, to: u64) -> f64 {
        let ahead = to.wrapping_sub(from) & self.mask;
        let behind = from.wrapping_sub(to) & self.mask;
        if ahead <= behind {
            ahead as f64
        } else {
            -(behind as f64)
        }
    }
}

/// Maps a device's timestamps to nanoseconds since the trace's start.
#[derive(Clone, Copy, Debug)]
pub struct ClockAlignment {
    clock: Clock,
    /// A timestamp, and the same moment in ns since the trace's start.
    tick: u64,
    tick_ns: f64,
    /// Nanoseconds a tick, as measured.
    rate: f64,
    /// Largest error, ns.
    pub within: f64,
    /// Whether the driver read both clocks at once.
    pub calibrated: bool,
}

impl ClockAlignment {
    /// Aligns by moments read near the start and the end of a trace. The trace starts at `start`.
    pub fn new(clock: Clock, start: Instant, first: ClockMoment, last: ClockMoment) -> Self {
        let first_ns = nanoseconds_since(start, first.host);
        let distance = nanoseconds_since(start, last.host) - first_ns;
        let ticks = clock.ticks_between(first.tick, last.tick);
        let rate = if distance >= MIN_DISTANCE && ticks > 0.0 {
            distance / ticks
        } else {
            clock.period
        };
        Self {
            clock,
            tick: first.tick,
            tick_ns: first_ns,
            rate,
            within: first.within.max(last.within).as_nanos() as f64,
            calibrated: first.calibrated && last.calibrated,
        }
    }

    /// A timestamp in nanoseconds since the trace's start.
    pub fn nanoseconds(&self, tick: u64) -> f64 {
        self.tick_ns + self.rate * self.clock.ticks_between(self.tick, tick)
    }
}

/// Nanoseconds from one moment to another; negative if the other is earlier.
pub fn nanoseconds_since(start: Instant, at: Instant) -> f64 {
    match at.checked_duration_since(start) {
        Some(after) => after.as_nanos() as f64,
        None => -(start.duration_since(at).as_nanos() as f64),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    const CLOCK: Clock = Clock {
        mask: (1 << 36) - 1,
        period: 10.0,
    };

    #[test]
    fn moments_give_offset_and_rate_over_a_wrap() {
        let start = Instant::now();
        let moment = |ns: u64, tick: u64| ClockMoment {
            host: start + Duration::from_nanos(ns),
            tick: tick & CLOCK.mask,
            within: Duration::from_nanos(300),
            calibrated: true,
        };
        // The clock is 1 part in 10,000 slow, and wraps in between.
        let first = (1u64 << 36) - 50_000_000;
        let alignment = ClockAlignment::new(
            CLOCK,
            start,
            moment(1000, first),
            moment(2_000_001_000, first + 199_980_000),
        );
        assert!(alignment.calibrated && alignment.within == 300.0);
        let halfway = alignment.nanoseconds((first + 99_990_000) & CLOCK.mask);
        assert!((halfway - 1_000_001_000.0).abs() < 1.0);
        let before = alignment.nanoseconds(first - 99_990);
        assert!((before + 999_000.0).abs() < 1.0, "before the first moment");
    }
}
