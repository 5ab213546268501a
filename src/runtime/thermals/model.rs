//! A thermal model of a phone: the load of its GPU goes in; temperature, headroom and clock come
//! out.
//!
//! A mass warms with the power drawn and cools towards the air (first order: one resistance, one
//! capacity). The clock follows the load, as phones' clocks do, up to a cap that falls with every
//! degree above a limit.

use std::time::Duration;

/// The constants of a phone. The default behaves like the paper's (Snapdragon 8 Elite): under a
/// load of 89 % at 120 frames a second it keeps its clock for ten minutes, then settles where it
/// draws 90.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phone {
    /// Temperature of the air around it, °C.
    pub air: f64,
    /// Temperature above the air's that a constant power leads to, K a watt.
    pub kelvin_a_watt: f64,
    /// Time after which a change of power has had 63 % of its effect, seconds.
    pub time_constant: f64,
    /// Power with an idle GPU, watts.
    pub idle: f64,
    /// Power that a busy GPU adds at its highest clock, watts.
    pub busy: f64,
    /// Temperature above which the system lowers the clock, °C.
    pub limit: f64,
    /// Share of the highest clock that is taken away for each degree above the limit.
    pub cap_a_kelvin: f64,
    /// The lowest clock, as a share of the highest.
    pub lowest: f64,
    /// Share of the time that the GPU is busy while its clock follows the load.
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

/// The state of a phone over time.
#[derive(Clone, Debug)]
pub struct PhoneModel {
    phone: Phone,
    temperature: f64,
    clock: f64,
}

impl PhoneModel {
    /// A phone that has been idle for long.
    pub fn new(phone: Phone) -> Self {
        Self {
            phone,
            temperature: phone.air + phone.kelvin_a_watt * phone.idle,
            clock: 1.0,
        }
    }

    /// Changes the air's temperature, °C.
    pub fn set_air(&mut self, air: f64) {
        self.phone.air = air;
    }

    /// Its temperature, °C.
    pub fn temperature(&self) -> f64 {
        self.temperature
    }

    /// The GPU's clock, as a share of the highest.
    pub fn clock(&self) -> f64 {
        self.clock
    }

    /// Headroom as `AThermal_getThermalHeadroom` gives it: 0 at an idle phone's temperature, 1 at
    /// the limit.
    pub fn headroom(&self) -> f64 {
        let cold = Phone::default().air + self.phone.kelvin_a_watt * self.phone.idle;
        (self.temperature - cold) / (self.phone.limit - cold)
    }

    /// Lets time pass. `work` is the GPU time wanted, at the highest clock, as a share of that
    /// time.
    pub fn advance(&mut self, time: Duration, work: f64) {
        let phone = &self.phone;
        let seconds = time.as_secs_f64();
        let cap = (1.0 - phone.cap_a_kelvin * (self.temperature - phone.limit).max(0.0))
            .max(phone.lowest);
        self.clock = (work.max(0.0) / phone.target)
            .clamp(phone.lowest, 1.0)
            .min(cap);
        let busy = (work.max(0.0) / self.clock).min(1.0);
        // Voltage follows the clock, and power its square.
        let power = phone.idle + phone.busy * busy * self.clock.powi(3);
        let rest = phone.air + phone.kelvin_a_watt * power;
        self.temperature =
            rest + (self.temperature - rest) * (-seconds / phone.time_constant).exp();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames a second that are drawn under a load, of `wanted`, minute by minute.
    fn rates(work: f64, minutes: usize, wanted: f64) -> Vec<f64> {
        let mut model = PhoneModel::new(Phone::default());
        let mut minute = || {
            let mut drawn = 0.0;
            for _ in 0..60 {
                model.advance(Duration::from_secs(1), work);
                drawn += wanted * (model.clock() / work).min(1.0);
            }
            drawn / 60.0
        };
        (0..minutes).map(|_| minute()).collect()
    }

    /// The paper's figure: 120 frames a second for ten minutes, about 90 from then on.
    #[test]
    fn it_throttles_like_the_papers_phone() {
        let rates = rates(0.89, 20, 120.0);
        assert!(rates[..9].iter().all(|&rate| rate > 119.9), "{rates:?}");
        assert!(
            rates[12..].iter().all(|rate| (84.0..96.0).contains(rate)),
            "{rates:?}"
        );
        assert!(rates[19] > rates[12] - 3.0, "it goes on falling: {rates:?}");
    }

    #[test]
    fn little_work_never_heats_it_to_the_limit() {
        assert!(rates(0.5, 60, 120.0).iter().all(|&rate| rate == 120.0));
        let mut model = PhoneModel::new(Phone::default());
        assert!(model.headroom().abs() < 1e-9);
        for _ in 0..7200 {
            model.advance(Duration::from_secs(1), 0.5);
        }
        assert!(
            (0.2..0.9).contains(&model.headroom()),
            "{}",
            model.headroom()
        );
    }
}
