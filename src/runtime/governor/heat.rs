//! Where heat is going: readings of thermal headroom go in, a forecast comes out.

use std::collections::VecDeque;

/// Readings older than this are dropped, seconds.
const SPAN: f64 = 20.0;
/// A slope over a shorter time is mostly noise, seconds.
const MIN_SLOPE_SPAN: f64 = 8.0;
/// How far the forecast looks ahead, seconds.
const AHEAD: f64 = 20.0;

/// Headroom at a time.
#[derive(Clone, Copy, Debug)]
struct HeadroomReading {
    seconds: f64,
    headroom: f64,
}

/// The last readings of headroom and their trend. Headroom is 0 for a cool device and 1 where the
/// system lowers the clock much, as Android's `AThermal` defines it.
#[derive(Clone, Debug, Default)]
pub struct HeatTrend {
    readings: VecDeque<HeadroomReading>,
}

impl HeatTrend {
    /// Adds a reading. Readings that are not finite or not later than the last are ignored: Android
    /// answers NaN when asked too often.
    pub fn add_reading(&mut self, seconds: f64, headroom: f64) {
        if !seconds.is_finite() || !headroom.is_finite() {
            return;
        }
        if let Some(last) = self.readings.back()
            && seconds <= last.seconds
        {
            return;
        }
        self.readings
            .push_back(HeadroomReading { seconds, headroom });
        while let Some(first) = self.readings.front()
            && seconds - first.seconds > SPAN
        {
            self.readings.pop_front();
        }
    }

    /// The last reading. None without one, or if it is too old to hold at this time.
    pub fn current(&self, seconds: f64) -> Option<f64> {
        let last = self.readings.back()?;
        (seconds - last.seconds <= SPAN).then_some(last.headroom)
    }

    /// Change of headroom a second, by least squares. 0 if readings are too few or too close in
    /// time.
    pub fn slope(&self) -> f64 {
        let (Some(first), Some(last)) = (self.readings.front(), self.readings.back()) else {
            return 0.0;
        };
        if self.readings.len() < 3 || last.seconds - first.seconds < MIN_SLOPE_SPAN {
            return 0.0;
        }
        let count = self.readings.len() as f64;
        let mean_seconds = self.readings.iter().map(|r| r.seconds).sum::<f64>() / count;
        let mean_headroom = self.readings.iter().map(|r| r.headroom).sum::<f64>() / count;
        let mut covariance = 0.0;
        let mut variance = 0.0;
        for reading in &self.readings {
            let offset = reading.seconds - mean_seconds;
            covariance += offset * (reading.headroom - mean_headroom);
            variance += offset * offset;
        }
        if variance > 0.0 {
            covariance / variance
        } else {
            0.0
        }
    }

    /// Headroom [`AHEAD`] seconds from now if the trend goes on.
    pub fn forecast(&self, seconds: f64) -> Option<f64> {
        Some(self.current(seconds)? + AHEAD * self.slope())
    }

    /// Drops all but the last reading: the load has changed, and the slope before says nothing of
    /// the slope after.
    pub fn reset_slope(&mut self) {
        let last = self.readings.pop_back();
        self.readings.clear();
        self.readings.extend(last);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_is_followed_and_bad_readings_are_ignored() {
        let mut heat = HeatTrend::default();
        assert_eq!((heat.current(0.0), heat.slope()), (None, 0.0));
        for second in 0..60 {
            heat.add_reading(f64::from(second), 0.5 + 0.002 * f64::from(second));
            heat.add_reading(f64::from(second) + 0.5, f64::NAN);
            heat.add_reading(f64::from(second) - 5.0, 9.0);
        }
        assert!((heat.slope() - 0.002).abs() < 1e-9, "{}", heat.slope());
        let forecast = heat.forecast(59.0).expect("there are readings");
        assert!((forecast - 0.658).abs() < 1e-9);
        assert_eq!(heat.current(100.0), None);
        heat.reset_slope();
        assert_eq!((heat.slope(), heat.current(60.0)), (0.0, Some(0.618)));
    }
}
