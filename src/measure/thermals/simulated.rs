//! A simulated phone under a real load: what frames took on this device goes in, what they would take there comes out.
//!
//! The whole quality is as much work for it as the paper's avatar for the paper's phone: 89 % of the time that a frame has. What the governor
//! gives up takes as much less as it does on this device.

use super::{Model, Phone, Reading};
use std::{collections::VecDeque, time::Duration};

/// The model lets pass at least this time at once, seconds: the load is a mean over it.
const STEP: f64 = 0.25;
/// The first frames, from whose median it is learned what the whole quality takes here.
const LEARN: usize = 12;
/// What that takes of the phone's time, at its highest clock.
const LOAD: f64 = 0.89;

/// A clock that follows the load goes up all the way where the device is busy for longer than this share of the time.
const BUSY: f64 = 0.95;

/// Of so many frames the median counts: what others on this machine take from single ones is not the phone's.
const CALM: usize = 7;

/// A phone that heats so many times as fast as a real one.
#[derive(Clone, Debug)]
pub struct Simulated {
    model: Model,
    speed: f64,
    /// Time of a frame, seconds.
    period: f64,
    /// Of the first frames, seconds.
    learned: Vec<f64>,
    /// Of the last frames, seconds.
    recent: VecDeque<f64>,
    /// The phone's time a time of ours, once it is known.
    scale: Option<f64>,
    since: Option<f64>,
    /// Since then: time at the highest clock that was asked for, and time that it took, seconds.
    work: f64,
    took: f64,
}

impl Simulated {
    /// `speed`: seconds of the phone's a second of ours; `rate`: frames a second that it is to draw.
    pub fn new(phone: Phone, speed: f64, rate: f64) -> Self {
        let model = Model::new(phone);
        Self {
            model,
            speed,
            period: 1.0 / rate,
            learned: Vec::with_capacity(LEARN),
            recent: VecDeque::new(),
            scale: None,
            since: None,
            work: 0.0,
            took: 0.0,
        }
    }

    pub fn read(&self) -> Reading {
        let model = &self.model;
        let (headroom, celsius, clock) = (Some(model.headroom()), Some(model.temperature()), Some(model.clock()));
        Reading { headroom, celsius, clock, ..Reading::default() }
    }

    /// As [`super::Thermals::frame`].
    pub fn frame(&mut self, seconds: f64, busy: f64) -> f64 {
        let Some(scale) = self.scale.or_else(|| self.learn(busy)) else { return busy };
        let since = *self.since.get_or_insert(seconds);
        let passed = seconds - since;
        if passed >= STEP {
            let wanted = if self.took > BUSY * passed { 1.0 } else { self.work / passed };
            self.model.pass(Duration::from_secs_f64(self.speed * passed), wanted);
            (self.since, self.work, self.took) = (Some(seconds), 0.0, 0.0);
        }
        let work = scale * self.usual(busy);
        let took = work / self.model.clock();
        (self.work, self.took) = (self.work + work, self.took + took);
        took
    }

    /// The median of the last frames, this one among them.
    fn usual(&mut self, busy: f64) -> f64 {
        self.recent.push_back(busy);
        if self.recent.len() > CALM {
            self.recent.pop_front();
        }
        let mut sorted: Vec<f64> = self.recent.iter().copied().collect();
        sorted.sort_unstable_by(f64::total_cmp);
        sorted[sorted.len() / 2]
    }

    fn learn(&mut self, busy: f64) -> Option<f64> {
        self.learned.push(busy);
        if self.learned.len() == LEARN {
            self.learned.sort_unstable_by(f64::total_cmp);
            let usual = self.learned[LEARN / 2];
            self.scale = (usual > 0.0).then(|| LOAD * self.period / usual);
            self.learned.clear();
        }
        self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One frame of four takes three times as long, by nobody's doing.
    #[test]
    fn a_machine_that_others_disturb_heats_the_phone_no_more() {
        let mut phone = Simulated::new(Phone::default(), 20.0, 30.0);
        let late = (0..600).filter(|frame| phone.frame(f64::from(*frame) / 30.0, if frame % 4 == 3 { 0.03 } else { 0.01 }) > 1.0 / 30.0);
        assert!(late.count() <= LEARN / 4, "frames that were disturbed are late on the phone too");
    }

    /// Twenty minutes of the phone's in one: half of it cool, the rest throttled; and cool throughout where the work is halved.
    #[test]
    fn the_phone_throttles_halfway_through_whatever_the_device_takes() {
        for (busy, halved) in [(0.001, false), (0.03, false), (0.001, true)] {
            let mut phone = Simulated::new(Phone::default(), 20.0, 30.0);
            let (mut now, mut times) = (0.0, Vec::new());
            while now < 60.0 {
                let took = phone.frame(now, if halved && now > 2.0 { 0.5 * busy } else { busy });
                now += took.max(1.0 / 30.0);
                times.push((now, took));
            }
            let late = |from: f64, to: f64| {
                let within: Vec<_> = times.iter().filter(|time| (from..to).contains(&time.0)).collect();
                within.iter().filter(|time| time.1 > 1.0 / 30.0).count() as f64 / within.len() as f64
            };
            assert!(late(1.0, 27.0) < 0.01, "{busy} {halved}: {}", late(1.0, 27.0));
            let (hot, expected) = (late(38.0, 60.0), if halved { 0.0 } else { 1.0 });
            assert!((hot - expected).abs() < 0.05, "{busy} {halved}: {hot}");
            let rate = times.iter().filter(|time| time.0 > 45.0).count() as f64 / 15.0;
            assert!(halved || (20.0..25.0).contains(&rate), "30 frames a second become {rate}, as 120 become 90");
        }
    }
}
