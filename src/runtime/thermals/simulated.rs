//! A simulated phone under a real load: the times of frames on this device go in, the times that
//! they would take on the phone come out.
//!
//! A frame at full quality is as much work for it as the paper's avatar is for the paper's phone:
//! 89 % of a frame's time. Lower qualities take less by the same factor as on this device.

use super::{
    model::{Phone, PhoneModel},
    reading::ThermalReading,
};
use std::{collections::VecDeque, time::Duration};

/// Shortest step of the model, seconds: the load is a mean over it.
const STEP: f64 = 0.25;
/// The median of this many first frames is the time of full quality on this device.
const CALIBRATION_FRAMES: usize = 12;
/// Load of full quality on the phone at its highest clock.
const LOAD: f64 = 0.89;
/// Load above which a clock that follows the load goes up all the way.
const SATURATED_LOAD: f64 = 0.95;
/// The median of this many last frames counts, so that other programs on this machine, which
/// disturb single frames, don't heat the phone.
const MEDIAN_FRAMES: usize = 7;

/// A phone that draws this device's frames and heats faster than a real one by some factor.
#[derive(Clone, Debug)]
pub struct Simulated {
    model: PhoneModel,
    speed: f64,
    /// Time from one frame to the next at the promised rate, seconds.
    period: f64,
    /// Times of the first frames on this device, until [`CALIBRATION_FRAMES`] are known, seconds.
    first_frames: Vec<f64>,
    /// Times of the last frames on this device, seconds.
    recent: VecDeque<f64>,
    /// The phone's time for a second of this device's, once it is known.
    scale: Option<f64>,
    /// When the current step began, seconds.
    step_start: Option<f64>,
    /// Work in this step: time at the phone's highest clock, seconds.
    work: f64,
    /// Time that this work takes at its clocks, seconds.
    busy: f64,
}

impl Simulated {
    /// `speed` is the phone's seconds in a second of real time; `rate` is the promised rate, frames
    /// a second.
    pub fn new(phone: Phone, speed: f64, rate: f64) -> Self {
        Self {
            model: PhoneModel::new(phone),
            speed,
            period: 1.0 / rate,
            first_frames: Vec::with_capacity(CALIBRATION_FRAMES),
            recent: VecDeque::new(),
            scale: None,
            step_start: None,
            work: 0.0,
            busy: 0.0,
        }
    }

    /// The phone's readings now.
    pub fn read(&self) -> ThermalReading {
        ThermalReading {
            headroom: Some(self.model.headroom()),
            celsius: Some(self.model.temperature()),
            clock: Some(self.model.clock()),
            ..ThermalReading::default()
        }
    }

    /// Adds a frame that kept this device busy for `busy` seconds until `seconds`. Returns the time
    /// that it takes on the phone, seconds; `busy` while the first frames are measured.
    pub fn add_frame(&mut self, seconds: f64, busy: f64) -> f64 {
        let Some(scale) = self.scale.or_else(|| self.calibrate(busy)) else {
            return busy;
        };
        let passed = seconds - *self.step_start.get_or_insert(seconds);
        if passed >= STEP {
            let work = if self.busy > SATURATED_LOAD * passed {
                1.0
            } else {
                self.work / passed
            };
            self.model
                .advance(Duration::from_secs_f64(self.speed * passed), work);
            self.step_start = Some(seconds);
            self.work = 0.0;
            self.busy = 0.0;
        }
        let work = scale * self.recent_median(busy);
        let busy_on_phone = work / self.model.clock();
        self.work += work;
        self.busy += busy_on_phone;
        busy_on_phone
    }

    /// The median of the last frames, including this one.
    fn recent_median(&mut self, busy: f64) -> f64 {
        self.recent.push_back(busy);
        if self.recent.len() > MEDIAN_FRAMES {
            self.recent.pop_front();
        }
        let mut sorted: Vec<f64> = self.recent.iter().copied().collect();
        sorted.sort_unstable_by(f64::total_cmp);
        sorted[sorted.len() / 2]
    }

    /// Adds one of the first frames. Returns the scale once enough of them are known.
    fn calibrate(&mut self, busy: f64) -> Option<f64> {
        self.first_frames.push(busy);
        if self.first_frames.len() == CALIBRATION_FRAMES {
            self.first_frames.sort_unstable_by(f64::total_cmp);
            let median = self.first_frames[CALIBRATION_FRAMES / 2];
            self.scale = (median > 0.0).then(|| LOAD * self.period / median);
            self.first_frames.clear();
        }
        self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One frame of four takes three times as long, as beside another busy program.
    #[test]
    fn single_slow_frames_do_not_heat_the_phone() {
        let mut phone = Simulated::new(Phone::default(), 20.0, 30.0);
        let late = (0..600).filter(|frame| {
            phone.add_frame(
                f64::from(*frame) / 30.0,
                if frame % 4 == 3 { 0.03 } else { 0.01 },
            ) > 1.0 / 30.0
        });
        assert!(
            late.count() <= CALIBRATION_FRAMES / 4,
            "disturbed frames are late on the phone too"
        );
    }

    /// Twenty minutes of the phone's time in one: half of it cool, the rest throttled; cool
    /// throughout if the work is halved.
    #[test]
    fn the_phone_throttles_halfway_on_any_device() {
        for (busy, halved) in [(0.001, false), (0.03, false), (0.001, true)] {
            let mut phone = Simulated::new(Phone::default(), 20.0, 30.0);
            let mut now = 0.0;
            let mut times = Vec::new();
            while now < 60.0 {
                let took = phone.add_frame(
                    now,
                    if halved && now > 2.0 {
                        0.5 * busy
                    } else {
                        busy
                    },
                );
                now += took.max(1.0 / 30.0);
                times.push((now, took));
            }
            let late = |from: f64, to: f64| {
                let within: Vec<_> = times
                    .iter()
                    .filter(|time| (from..to).contains(&time.0))
                    .collect();
                within.iter().filter(|time| time.1 > 1.0 / 30.0).count() as f64
                    / within.len() as f64
            };
            assert!(
                late(1.0, 27.0) < 0.01,
                "{busy} {halved}: {}",
                late(1.0, 27.0)
            );
            let hot = late(38.0, 60.0);
            let expected = if halved { 0.0 } else { 1.0 };
            assert!((hot - expected).abs() < 0.05, "{busy} {halved}: {hot}");
            let rate = times.iter().filter(|time| time.0 > 45.0).count() as f64 / 15.0;
            assert!(
                halved || (20.0..25.0).contains(&rate),
                "30 frames a second become {rate}, as 120 become 90"
            );
        }
    }
}
