//! A reading of the heat at one time.

/// Readings of the sensors at one time. None if the system has no such sensor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThermalReading {
    /// Thermal headroom used up: 0 is cool, at 1 the system lowers the clock much, as Android's
    /// `AThermal` defines it.
    pub headroom: Option<f64>,
    /// Temperature of the warmest sensor, °C.
    pub celsius: Option<f64>,
    /// Mean clock of the CPU's cores, or clock of the simulated GPU, as a share of the highest.
    pub clock: Option<f64>,
    /// Charge of the battery, 0 to 1.
    pub battery: Option<f64>,
    /// Power drawn from the battery, watts.
    pub watts: Option<f64>,
}
