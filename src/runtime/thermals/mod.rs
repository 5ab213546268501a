//! How warm a device is and how fast it may run: readings of the system, of a simulated phone, or
//! of an earlier run.

pub mod model;
mod reading;
pub mod recorded;
mod simulated;
mod system;

pub use model::{Phone, PhoneModel};
pub use reading::ThermalReading;
pub use recorded::Recorded;
pub use simulated::Simulated;
pub use system::System;

/// A source of readings.
pub enum Thermals {
    /// The system's own sensors.
    System(Box<System>),
    /// A simulated phone under this device's load.
    Simulated(Simulated),
    /// Headroom that an earlier soak recorded.
    Recorded(Recorded),
}

impl Thermals {
    /// The readings at a time on a monotonic clock, seconds.
    pub fn read(&mut self, seconds: f64) -> ThermalReading {
        match self {
            Self::System(system) => system.read(),
            Self::Simulated(simulated) => simulated.read(),
            Self::Recorded(recorded) => ThermalReading {
                headroom: recorded.at(seconds),
                ..ThermalReading::default()
            },
        }
    }

    /// Adds a frame that kept the device busy for `busy` seconds until `seconds`. Returns the time
    /// that it takes at the current clock, seconds: `busy` itself unless heat is simulated.
    pub fn add_frame(&mut self, seconds: f64, busy: f64) -> f64 {
        match self {
            Self::Simulated(simulated) => simulated.add_frame(seconds, busy),
            Self::System(_) | Self::Recorded(_) => busy,
        }
    }
}
