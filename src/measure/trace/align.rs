//! The device's clock on the host's time: moments of both go in, a mapping comes out.

use crate::vulkan::calibration::Moment;
use std::time::Instant;

/// Two moments less far apart say nothing of how fast one clock goes by the other, ns.
const APART: f64 = 5e8;

/// What is known of the device's clock.
#[derive(Clone, Copy, Debug)]
pub struct Clock {
    /// Ticks that count before it begins again at 0.
    pub mask: u64,
    /// Nanoseconds a tick, as the driver says.
    pub period: f64,
}

impl Clock {
    /// Ticks from one reading to another, which may lie before it.
    fn between(&self, from: u64, to: u64) -> f64 {
        let ahead = to.wrapping_sub(from) & self.mask;
        let behind = from.wrapping_sub(to) & self.mask;
        if ahead <= behind { ahead as f64 } else { -(behind as f64) }
    }
}

/// A device's clock in nanoseconds since the trace's start.
#[derive(Clone, Copy, Debug)]
pub struct Alignment {
    clock: Clock,
    tick: u64,
    at: f64,
    /// ns a tick, as measured.
    rate: f64,
    /// How far off it may be, ns.
    pub within: f64,
    /// Whether the driver has read both clocks at once.
    pub calibrated: bool,
}

impl Alignment {
    /// By moments at the start and the end of a trace that starts at `start`.
    pub fn new(clock: Clock, start: Instant, [first, last]: [Moment; 2]) -> Self {
        let at = |moment: Moment| since(start, moment.host);
        let ticks = clock.between(first.tick, last.tick);
        let apart = at(last) - at(first);
        let rate = if apart >= APART && ticks > 0.0 { apart / ticks } else { clock.period };
        let within = first.within.max(last.within).as_nanos() as f64;
        Self { clock, tick: first.tick, at: at(first), rate, within, calibrated: first.calibrated && last.calibrated }
    }

    /// ns since the trace's start.
    pub fn of(&self, tick: u64) -> f64 {
        self.at + self.rate * self.clock.between(self.tick, tick)
    }
}

/// ns from one moment to another, which may lie before it.
pub fn since(start: Instant, at: Instant) -> f64 {
    match at.checked_duration_since(start) {
        Some(after) => after.as_nanos() as f64,
        None => -(start.duration_since(at).as_nanos() as f64),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    const CLOCK: Clock = Clock { mask: (1 << 36) - 1, period: 10.0 };

    #[test]
    fn moments_give_offset_and_rate_over_a_wrap() {
        let start = Instant::now();
        let moment = |ns: u64, tick: u64| Moment {
            host: start + Duration::from_nanos(ns),
            tick: tick & CLOCK.mask,
            within: Duration::from_nanos(300),
            calibrated: true,
        };
        // The clock goes 1 part in 10,000 slow, and wraps in between.
        let first = (1u64 << 36) - 50_000_000;
        let alignment = Alignment::new(CLOCK, start, [moment(1000, first), moment(2_000_001_000, first + 199_980_000)]);
        assert!(alignment.calibrated && alignment.within == 300.0);
        assert!((alignment.of((first + 99_990_000) & CLOCK.mask) - 1_000_001_000.0).abs() < 1.0);
        assert!((alignment.of(first - 99_990) + 999_000.0).abs() < 1.0, "before the first moment");
    }
}
