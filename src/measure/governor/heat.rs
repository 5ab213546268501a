//! Where heat is going: readings of thermal headroom go in, what it will be in a while comes out.

use std::collections::VecDeque;

/// Readings further back than this are forgotten, seconds.
const SPAN: f64 = 20.0;
/// A slope over less is mostly noise, seconds.
const SHORT: f64 = 8.0;
/// How far ahead to look, seconds.
const AHEAD: f64 = 20.0;

/// The last readings. 0 is cool, 1 is where the system takes away much of the clock, as Android's `AThermal` has it.
#[derive(Clone, Debug, Default)]
pub struct Heat {
    readings: VecDeque<(f64, f64)>,
}

impl Heat {
    /// A reading at a time, seconds. What is no number says nothing: Android answers NaN where it is asked too often.
    pub fn read(&mut self, seconds: f64, headroom: f64) {
        if !(seconds.is_finite() && headroom.is_finite()) || self.readings.back().is_some_and(|&(last, _)| seconds <= last) {
            return;
        }
        self.readings.push_back((seconds, headroom));
        while self.readings.front().is_some_and(|&(first, _)| seconds - first > SPAN) {
            self.readings.pop_front();
        }
    }

    /// The last reading. None where there is none, or the last is too old to say anything of now.
    pub fn now(&self, seconds: f64) -> Option<f64> {
        self.readings.back().filter(|&&(at, _)| seconds - at <= SPAN).map(|&(_, headroom)| headroom)
    }

    /// Change a second, by least squares. 0 of readings too few or too near each other.
    pub fn slope(&self) -> f64 {
        let count = self.readings.len() as f64;
        let span = self.readings.back().zip(self.readings.front()).map_or(0.0, |(last, first)| last.0 - first.0);
        if self.readings.len() < 3 || span < SHORT {
            return 0.0;
        }
        let mean = |of: fn(&(f64, f64)) -> f64| self.readings.iter().map(of).sum::<f64>() / count;
        let (middle, level) = (mean(|r| r.0), mean(|r| r.1));
        let (along, spread) =
            self.readings.iter().fold((0.0, 0.0), |(a, s), &(t, h)| (a + (t - middle) * (h - level), s + (t - middle) * (t - middle)));
        if spread > 0.0 { along / spread } else { 0.0 }
    }

    /// What it will be in a while, going on as it does.
    pub fn soon(&self, seconds: f64) -> Option<f64> {
        self.now(seconds).map(|headroom| headroom + AHEAD * self.slope())
    }

    /// The slope from before the load changed says nothing of the slope after.
    pub fn changed(&mut self) {
        let last = self.readings.pop_back();
        self.readings.clear();
        self.readings.extend(last);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_is_followed_and_nonsense_is_not() {
        let mut heat = Heat::default();
        assert_eq!((heat.now(0.0), heat.slope()), (None, 0.0));
        for second in 0..60 {
            heat.read(f64::from(second), 0.5 + 0.002 * f64::from(second));
            heat.read(f64::from(second) + 0.5, f64::NAN);
            heat.read(f64::from(second) - 5.0, 9.0);
        }
        assert!((heat.slope() - 0.002).abs() < 1e-9, "{}", heat.slope());
        assert!(heat.soon(59.0).is_some_and(|soon| (soon - 0.658).abs() < 1e-9));
        assert_eq!(heat.now(100.0), None);
        heat.changed();
        assert_eq!((heat.slope(), heat.now(60.0)), (0.0, Some(0.618)));
    }
}
