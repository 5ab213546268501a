//! When frames are shown: submission times go in, refreshes without a new frame come out.

/// A display that shows one frame at every refresh, first in, first out.
#[derive(Clone, Copy, Debug)]
pub struct Cadence {
    /// Seconds from one frame to the next, if none is late.
    period: f64,
    /// When the last frame was due, seconds.
    due: Option<f64>,
}

impl Cadence {
    /// A display that shows a frame every `period` seconds.
    pub fn new(period: f64) -> Self {
        Self { period, due: None }
    }

    /// Seconds from one frame to the next.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Sets the seconds from one frame to the next, from now on.
    pub fn set_period(&mut self, period: f64) {
        self.period = period;
    }

    /// Leaves out a time in which no frame was wanted.
    pub fn skip_idle(&mut self) {
        self.due = None;
    }

    /// Adds a frame submitted at `seconds`. Returns the refreshes that it missed. Up to half a
    /// period of delay is not a miss: the frame before may have taken that much more than its time.
    pub fn add_frame(&mut self, seconds: f64) -> u32 {
        let due = self.due.map_or(seconds, |due| due + self.period);
        let missed = ((seconds - due) / self.period).round().max(0.0);
        // An early frame is shown when it is due, but is credited at most one period.
        self.due = Some((due + missed * self.period).min(seconds + self.period));
        missed as u32
    }

    /// When to begin the next frame so that it is neither late nor waits, seconds. None before the
    /// first frame.
    pub fn next_frame(&self) -> Option<f64> {
        self.due.map(|due| due + self.period)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn missed(times: impl Iterator<Item = f64>) -> u32 {
        let mut cadence = Cadence::new(0.01);
        times.map(|at| cadence.add_frame(at)).sum()
    }

    #[test]
    fn frames_a_tenth_too_slow_miss_every_tenth_refresh() {
        assert_eq!(missed((0..1000).map(|k| 0.01 * f64::from(k))), 0);
        assert!((99..=101).contains(&missed((0..1000).map(|k| 0.011 * f64::from(k)))));
        // Long and short frames in turn fit, since two are in flight.
        let uneven = |k| 0.01 * f64::from(k) + if k % 2 == 0 { 0.004 } else { 0.0 };
        assert_eq!(missed((0..1000).map(uneven)), 0);
        // One hitch of four refreshes, then in step again.
        let hitch = |k| 0.01 * f64::from(k) + if k > 500 { 0.04 } else { 0.0 };
        assert_eq!(missed((0..1000).map(hitch)), 4);
    }

    #[test]
    fn idle_time_is_no_hitch_and_early_frames_save_nothing() {
        let mut cadence = Cadence::new(0.01);
        assert_eq!((cadence.next_frame(), cadence.add_frame(1.0)), (None, 0));
        cadence.skip_idle();
        assert_eq!(cadence.add_frame(9.0), 0);
        for k in 1..100 {
            assert_eq!(cadence.add_frame(9.0 + 0.001 * f64::from(k)), 0);
        }
        assert!(cadence.add_frame(9.2) >= 8, "a pause after a burst counts");
    }
}
