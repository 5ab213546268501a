//! A simulated phone under a real load: what frames took on this device goes in, what they would take there comes out.

use super::{Model, Phone, Reading};
use std::time::Duration;

/// The model lets pass at least this time at once, seconds: the load is a mean over it.
const STEP: f64 = 0.25;

/// A phone that heats so many times as fast as a real one.
#[derive(Clone, Debug)]
pub struct Simulated {
    model: Model,
    speed: f64,
    since: Option<f64>,
    busy: f64,
}

impl Simulated {
    /// `speed`: seconds of the phone's a second of ours.
    pub fn new(phone: Phone, speed: f64) -> Self {
        Self { model: Model::new(phone), speed, since: None, busy: 0.0 }
    }

    pub fn read(&self) -> Reading {
        let model = &self.model;
        let (headroom, celsius, clock) = (Some(model.headroom()), Some(model.temperature()), Some(model.clock()));
        Reading { headroom, celsius, clock, ..Reading::default() }
    }

    /// As [`super::Thermals::frame`].
    pub fn frame(&mut self, seconds: f64, busy: f64) -> f64 {
        self.busy += busy;
        let since = *self.since.get_or_insert(seconds);
        if seconds - since >= STEP {
            self.model.pass(Duration::from_secs_f64(self.speed * (seconds - since)), self.busy / (seconds - since));
            (self.since, self.busy) = (Some(seconds), 0.0);
        }
        busy / self.model.clock()
    }
}
