//! A phone's heat, simulated: how busy its GPU is goes in, temperature, headroom and the clock that the system leaves it come out.
//!
//! A mass that warms with the power drawn and cools towards the air (first order: one resistance, one capacity), a clock that follows the load
//! as such phones' do, and a cap on that clock that falls with every degree above a limit.

use std::time::Duration;

/// What a phone is. The default is as the paper's (Snapdragon 8 Elite): at a load of 89 % at 120 frames a second it keeps its clock for ten
/// minutes, then settles where it draws 90.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phone {
    /// Of the air around it, °C.
    pub air: f64,
    /// How much warmer than the air it gets in the end, K a watt.
    pub kelvin_a_watt: f64,
    /// After this time a change of power has had 63 % of its effect, seconds.
    pub time_constant: f64,
    /// Power with an idle GPU, and what a busy one adds at its highest clock, watts.
    pub idle: f64,
    pub busy: f64,
    /// Where the system begins to lower the clock, °C, by which share of the highest a degree, and how far.
    pub limit: f64,
    pub cap_a_kelvin: f64,
    pub lowest: f64,
    /// Which share of the time a GPU is busy where its clock follows the load.
    pub target: f64,
}

impl Default for Phone {
    fn default() -> Self {
        Self {
            air: 25.0,
            kelvin_a_watt: 8.0,
            time_constant: 1430.0,
            idle: 1.0,
            busy: 5.0,
            limit: 44.9,
            cap_a_kelvin: 0.5,
            lowest: 0.3,
            target: 0.9,
        }
    }
}

/// The phone over time.
#[derive(Clone, Debug)]
pub struct Model {
    phone: Phone,
    temperature: f64,
    clock: f64,
}

impl Model {
    /// Cold: as warm as when it lies idle.
    pub fn new(phone: Phone) -> Self {
        Self { phone, temperature: phone.air + phone.kelvin_a_watt * phone.idle, clock: 1.0 }
    }

    /// Changes the air's temperature, °C.
    pub fn set_air(&mut self, air: f64) {
        self.phone.air = air;
    }

    /// °C
    pub fn temperature(&self) -> f64 {
        self.temperature
    }

    /// Share of the highest clock that the GPU runs at.
    pub fn clock(&self) -> f64 {
        self.clock
    }

    /// What `AThermal_getThermalHeadroom` would say: 0 is an idle phone's temperature, 1 the limit's.
    pub fn headroom(&self) -> f64 {
        let cold = Phone::default().air + self.phone.kelvin_a_watt * self.phone.idle;
        (self.temperature - cold) / (self.phone.limit - cold)
    }

    /// Lets time pass. `work`: GPU time at the highest clock that was asked for, as a share of that time.
    pub fn pass(&mut self, time: Duration, work: f64) {
        let phone = &self.phone;
        let seconds = time.as_secs_f64();
        let cap = (1.0 - phone.cap_a_kelvin * (self.temperature - phone.limit).max(0.0)).max(phone.lowest);
        self.clock = (work.max(0.0) / phone.target).clamp(phone.lowest, 1.0).min(cap);
        let busy = (work.max(0.0) / self.clock).min(1.0);
        // Voltage follows the clock, and power its square.
        let power = phone.idle + phone.busy * busy * self.clock.powi(3);
        let rest = phone.air + phone.kelvin_a_watt * power;
        self.temperature = rest + (self.temperature - rest) * (-seconds / phone.time_constant).exp();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames a second that a work leaves, of `wanted`, minute by minute.
    fn rates(work: f64, minutes: usize, wanted: f64) -> Vec<f64> {
        let mut model = Model::new(Phone::default());
        let mut minute = || {
            let mut drawn = 0.0;
            for _ in 0..60 {
                model.pass(Duration::from_secs(1), work);
                drawn += wanted * (model.clock() / work).min(1.0);
            }
            drawn / 60.0
        };
        (0..minutes).map(|_| minute()).collect()
    }

    /// The paper's figure: 120 frames a second for ten minutes, about 90 from then on.
    #[test]
    fn left_alone_it_throttles_as_the_papers_phone_does() {
        let rates = rates(0.89, 20, 120.0);
        assert!(rates[..9].iter().all(|&rate| rate > 119.9), "{rates:?}");
        assert!(rates[12..].iter().all(|rate| (84.0..96.0).contains(rate)), "{rates:?}");
        assert!(rates[19] > rates[12] - 3.0, "it goes on falling: {rates:?}");
    }

    #[test]
    fn little_work_never_heats_it_to_the_limit() {
        assert!(rates(0.5, 60, 120.0).iter().all(|&rate| rate == 120.0));
        let mut model = Model::new(Phone::default());
        assert!(model.headroom().abs() < 1e-9);
        (0..7200).for_each(|_| model.pass(Duration::from_secs(1), 0.5));
        assert!((0.2..0.9).contains(&model.headroom()), "{}", model.headroom());
    }
}
