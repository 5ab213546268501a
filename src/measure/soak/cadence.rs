//! When frames are shown: the times at which they are handed over go in, refreshes that had nothing new to show come out.

/// A display that shows a frame at every refresh, first in, first out.
#[derive(Clone, Copy, Debug)]
pub struct Cadence {
    /// Seconds from one frame to the next, where none is late.
    period: f64,
    /// When the last frame was to be handed over.
    due: Option<f64>,
}

impl Cadence {
    /// For frames that each have so many seconds.
    pub fn new(period: f64) -> Self {
        Self { period, due: None }
    }

    pub fn period(&self) -> f64 {
        self.period
    }

    /// Frames have another time from now on.
    pub fn set_period(&mut self, period: f64) {
        self.period = period;
    }

    /// Time in which no frame was wanted counts for nothing.
    pub fn rest(&mut self) {
        self.due = None;
    }

    /// A frame is handed over. Gives the refreshes that it missed: half a period is its own, for that is how long another in front of it may
    /// have taken more than its time.
    pub fn frame(&mut self, at: f64) -> u32 {
        let due = self.due.map_or(at, |due| due + self.period);
        let missed = ((at - due) / self.period).round().max(0.0);
        // A frame that comes early is shown when it is due, but nobody owes it the time that it was early for twice.
        self.due = Some((due + missed * self.period).min(at + self.period));
        missed as u32
    }

    /// When to begin the next frame, so that none is drawn for nothing. None before the first.
    pub fn next(&self) -> Option<f64> {
        self.due.map(|due| due + self.period)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn missed(times: impl Iterator<Item = f64>) -> u32 {
        let mut cadence = Cadence::new(0.01);
        times.map(|at| cadence.frame(at)).sum()
    }

    #[test]
    fn frames_that_are_a_tenth_slow_miss_every_tenth_refresh() {
        assert_eq!(missed((0..1000).map(|k| 0.01 * f64::from(k))), 0);
        assert!((99..=101).contains(&missed((0..1000).map(|k| 0.011 * f64::from(k)))));
        // Long and short in turn fit, for two are under way at a time.
        assert_eq!(missed((0..1000).map(|k| 0.01 * f64::from(k) + if k % 2 == 0 { 0.004 } else { 0.0 })), 0);
        // One hitch of four refreshes, then in step again.
        assert_eq!(missed((0..1000).map(|k| 0.01 * f64::from(k) + if k > 500 { 0.04 } else { 0.0 })), 4);
    }

    #[test]
    fn a_rest_is_no_hitch_and_early_frames_buy_nothing() {
        let mut cadence = Cadence::new(0.01);
        assert_eq!((cadence.next(), cadence.frame(1.0)), (None, 0));
        cadence.rest();
        assert_eq!(cadence.frame(9.0), 0);
        (1..100).for_each(|k| assert_eq!(cadence.frame(9.0 + 0.001 * f64::from(k)), 0));
        assert!(cadence.frame(9.2) >= 8, "a pause after a burst is seen");
    }
}
