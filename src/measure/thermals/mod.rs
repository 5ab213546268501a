//! How warm a device is and how fast it may run: the system's own readings, a simulated phone's, or ones that were recorded.

pub mod model;
pub mod recorded;
mod simulated;
mod system;

pub use model::{Model, Phone};
pub use recorded::Recorded;
pub use simulated::Simulated;
pub use system::System;

/// What is known at a moment. None is what the system does not tell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// Thermal headroom used up: 0 is cool, 1 is where the system takes much of the clock away, as Android's `AThermal` has it.
    pub headroom: Option<f64>,
    /// Of the warmest sensor, °C.
    pub celsius: Option<f64>,
    /// Mean clock of the processor's cores, or the simulated GPU's, as a share of the highest.
    pub clock: Option<f64>,
    /// Charge of the battery, 0 to 1, and what is drawn from it, watts.
    pub battery: Option<f64>,
    pub watts: Option<f64>,
}

/// Where readings come from.
pub enum Thermals {
    System(Box<System>),
    Simulated(Simulated),
    Recorded(Recorded),
}

impl Thermals {
    /// `seconds`: time on a clock that only rises.
    pub fn read(&mut self, seconds: f64) -> Reading {
        match self {
            Self::System(system) => system.read(),
            Self::Simulated(simulated) => simulated.read(),
            Self::Recorded(recorded) => Reading { headroom: recorded.at(seconds), ..Reading::default() },
        }
    }

    /// A frame has kept the device busy for a time until now. Gives the time that it takes on the clock that is left: the same, but where
    /// heat is simulated.
    pub fn frame(&mut self, seconds: f64, busy: f64) -> f64 {
        match self {
            Self::Simulated(simulated) => simulated.frame(seconds, busy),
            Self::System(_) | Self::Recorded(_) => busy,
        }
    }
}
