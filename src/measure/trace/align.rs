//! The device's clock on the host's time: moments of both, or only what must have come before what, go in; a mapping comes out.

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

/// What a frame says of the two clocks: the device began it after the host submitted it, and ended it before the host knew.
#[derive(Clone, Copy, Debug)]
pub struct Bracket {
    /// ns since the trace's start.
    pub submitted: f64,
    pub finished: f64,
    /// Ticks.
    pub began: u64,
    pub ended: u64,
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
    /// Calibrated timestamps, or fitted.
    pub calibrated: bool,
}

impl Alignment {
    /// By moments at the start and the end of a trace that starts at `start`.
    pub fn calibrated(clock: Clock, start: Instant, [first, last]: [Moment; 2]) -> Self {
        let at = |moment: Moment| since(start, moment.host);
        let ticks = clock.between(first.tick, last.tick);
        let apart = at(last) - at(first);
        let rate = if apart >= APART && ticks > 0.0 { apart / ticks } else { clock.period };
        let within = first.within.max(last.within).as_nanos() as f64;
        Self { clock, tick: first.tick, at: at(first), rate, within, calibrated: true }
    }

    /// By what frames say: in the middle of what all of them allow. None without frames. Where they contradict each other, as where a
    /// clock drifts, in the middle of that.
    pub fn fitted(clock: Clock, brackets: &[Bracket]) -> Option<Self> {
        let tick = brackets.first()?.began;
        let place = |ticks: u64| clock.period * clock.between(tick, ticks);
        let least = brackets.iter().map(|b| b.submitted - place(b.began)).fold(f64::NEG_INFINITY, f64::max);
        let most = brackets.iter().map(|b| b.finished - place(b.ended)).fold(f64::INFINITY, f64::min);
        let within = 0.5 * (most - least).abs();
        Some(Self { clock, tick, at: 0.5 * (least + most), rate: clock.period, within, calibrated: false })
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
        };
        // The clock goes 1 part in 10,000 slow, and wraps in between.
        let first = (1u64 << 36) - 50_000_000;
        let alignment = Alignment::calibrated(CLOCK, start, [moment(1000, first), moment(2_000_001_000, first + 199_980_000)]);
        assert!(alignment.calibrated && alignment.within == 300.0);
        assert!((alignment.of((first + 99_990_000) & CLOCK.mask) - 1_000_001_000.0).abs() < 1.0);
        assert!((alignment.of(first - 99_990) + 999_000.0).abs() < 1.0, "before the first moment");
    }

    #[test]
    fn frames_bracket_the_offset() {
        let truth = |tick: u64| 5e6 + 10.0 * tick as f64;
        let bracket = |tick: u64, slack: f64| Bracket {
            submitted: truth(tick) - slack,
            finished: truth(tick + 1000) + 2000.0 + slack,
            began: tick,
            ended: tick + 1000,
        };
        let brackets: Vec<_> = (0..50).map(|k| bracket(100_000 * k, 1000.0 + 500.0 * (k % 7) as f64)).collect();
        let Some(fitted) = Alignment::fitted(CLOCK, &brackets) else { panic!("there are frames") };
        assert!(!fitted.calibrated && (fitted.of(777) - truth(777)).abs() <= fitted.within && fitted.within <= 2001.0, "{fitted:?}");
        assert!(Alignment::fitted(CLOCK, &[]).is_none());
    }
}
