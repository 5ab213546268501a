//! What the device's clock says at a moment of the host's, where the driver has calibrated timestamps.

use super::{device::Gpu, instance::Instance, probe::Probe};
use ash::{ext, khr, vk};
use std::{
    ffi::CStr,
    time::{Duration, Instant},
};

/// Readings tried; the one between the nearest two of the host's counts.
const TRIES: usize = 16;

/// The same moment on both clocks.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    pub host: Instant,
    /// The device's ticks, of which [`Probe::timestamp_bits`] count.
    pub tick: u64,
    /// How far the two may be apart.
    pub within: Duration,
}

/// The extension under either of its names.
pub(super) enum Calibration {
    Khr(khr::calibrated_timestamps::Device),
    Ext(ext::calibrated_timestamps::Device),
}

impl Calibration {
    /// The name that a device knows it by.
    pub fn extension(probe: &Probe) -> Option<&'static CStr> {
        let names = [khr::calibrated_timestamps::NAME, ext::calibrated_timestamps::NAME];
        names.into_iter().find(|name| probe.timestamp_bits > 0 && probe.has(name))
    }

    /// Of a device that was made with it. None where it can't read the device's own clock.
    pub fn new(instance: &Instance, probe: &Probe, device: &ash::Device) -> Option<Self> {
        let (entry, raw) = (&instance.entry, &instance.raw);
        let khr = Self::extension(probe)? == khr::calibrated_timestamps::NAME;
        // SAFETY: the device has the extension, as its probe says.
        let domains = unsafe {
            if khr {
                khr::calibrated_timestamps::Instance::new(entry, raw).get_physical_device_calibrateable_time_domains(probe.physical)
            } else {
                ext::calibrated_timestamps::Instance::new(entry, raw).get_physical_device_calibrateable_time_domains(probe.physical)
            }
        };
        domains.ok()?.contains(&vk::TimeDomainKHR::DEVICE).then(|| match khr {
            true => Self::Khr(khr::calibrated_timestamps::Device::new(raw, device)),
            false => Self::Ext(ext::calibrated_timestamps::Device::new(raw, device)),
        })
    }

    fn tick(&self) -> Option<u64> {
        let info = [vk::CalibratedTimestampInfoKHR::default().time_domain(vk::TimeDomainKHR::DEVICE)];
        // SAFETY: the device has the extension and the domain.
        let read = unsafe {
            match self {
                Self::Khr(loader) => loader.get_calibrated_timestamps(&info),
                Self::Ext(loader) => loader.get_calibrated_timestamps(&info),
            }
        };
        read.ok()?.0.first().copied()
    }
}

impl Gpu {
    /// Reads both clocks. None where the driver can't.
    pub fn moment(&self) -> Option<Moment> {
        let calibration = self.calibration.as_ref()?;
        let read = || {
            let before = Instant::now();
            let tick = calibration.tick()?;
            let within = before.elapsed() / 2;
            Some(Moment { host: before + within, tick: tick & self.probe.tick_mask(), within })
        };
        (0..TRIES).filter_map(|_| read()).min_by_key(|moment| moment.within)
    }
}
