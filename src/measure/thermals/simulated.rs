//! A simulated phone under a real load: what frames took on this device goes in, what they would take there comes out.
//!
//! The whole quality is as much work for it as the paper's avatar for the paper's phone: 89 % of the time that a frame has. What the governor
//! gives up takes as much less as it does on this device.

use super::{Model, Phone, Reading};
use std::time::Duration;

/// The model lets pass at least this time at once, seconds: the load is a mean over it.
const STEP: f64 = 0.25;
/// The first frames, from whose median it is learned what the whole quality takes here.
const LEARN: usize = 12;
/// What that takes of the phone's time, at its highest clock.
const LOAD: f64 = 0.89;

/// A phone that heats so many times as fast as a real one.
#[derive(Clone, Debug)]
pub struct Simulated {
    model: Model,
    speed: f64,
    /// Time of a frame, seconds.
    period: f64,
    /// Of the first frames, seconds.
    learned: Vec<f64>,
    /// The phone's time a time of ours, once it is known.
    scale: Option<f64>,
    since: Option<f64>,
    work: f64,
}

impl Simulated {
    /// `speed`: seconds of the phone's a second of ours; `rate`: frames a second that it is to draw.
    pub fn new(phone: Phone, speed: f64, rate: f64) -> Self {
        let model = Model::new(phone);
        Self { model, speed, period: 1.0 / rate, learned: Vec::with_capacity(LEARN), scale: None, since: None, work: 0.0 }
    }

    pub fn read(&self) -> Reading {
        let model = &self.model;
        let (headroom, celsius, clock) = (Some(model.headroom()), Some(model.temperature()), Some(model.clock()));
        Reading { headroom, celsius, clock, ..Reading::default() }
    }

    /// As [`super::Thermals::frame`].
    pub fn frame(&mut self, seconds: f64, busy: f64) -> f64 {
        let Some(scale) = self.scale.or_else(|| self.learn(busy)) else { return busy };
        let work = scale * busy;
        self.work += work;
        let since = *self.since.get_or_insert(seconds);
        if seconds - since >= STEP {
            self.model.pass(Duration::from_secs_f64(self.speed * (seconds - since)), self.work / (seconds - since));
            (self.since, self.work) = (Some(seconds), 0.0);
        }
        work / self.model.clock()
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

    /// Twenty minutes of the phone's in one: half of it cool, the rest throttled; and cool throughout where the work is halved.
    #[test]
    fn the_phone_throttles_halfway_through_whatever_the_device_takes() {
        for (busy, halved) in [(0.001, false), (0.03, false), (0.001, true)] {
            let mut phone = Simulated::new(Phone::default(), 20.0, 30.0);
            let frame = |at: usize| phone.frame(at as f64 / 30.0, if halved && at > 60 { 0.5 * busy } else { busy });
            let times: Vec<f64> = (0..1800).map(frame).collect();
            let late = |from: usize, to: usize| times[from..to].iter().filter(|time| **time > 1.0 / 30.0).count();
            assert_eq!(late(30, 800), 0, "{busy} {halved}");
            assert_eq!(late(1000, 1800), if halved { 0 } else { 800 }, "{busy} {halved}");
        }
    }
}
