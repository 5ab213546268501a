//! Reads the device's clock where the driver has calibrated timestamps.

use super::{logical::Device, probe::Probe};
use ash::{ext, khr, vk};

/// The extension of calibrated timestamps, under either of its names.
pub(crate) enum CalibrationExtension {
    Khr(khr::calibrated_timestamps::Device),
    Ext(ext::calibrated_timestamps::Device),
}

impl CalibrationExtension {
    /// Of a device that was opened with the extension. None where it can't read the device's own
    /// clock.
    pub fn new(device: &Device, probe: &Probe) -> Option<Self> {
        let entry = &device.instance.entry;
        let instance = &device.instance.raw;
        let physical = probe.physical;
        if probe.clock_extension()? == khr::calibrated_timestamps::NAME {
            let loader = khr::calibrated_timestamps::Instance::new(entry, instance);
            // SAFETY: the device has the extension, as its probe says.
            let domains =
                unsafe { loader.get_physical_device_calibrateable_time_domains(physical) };
            reads_device(domains.ok()?).then(|| {
                Self::Khr(khr::calibrated_timestamps::Device::new(
                    instance,
                    &device.raw,
                ))
            })
        } else {
            let loader = ext::calibrated_timestamps::Instance::new(entry, instance);
            // SAFETY: the device has the extension, as its probe says.
            let domains =
                unsafe { loader.get_physical_device_calibrateable_time_domains(physical) };
            reads_device(domains.ok()?).then(|| {
                Self::Ext(ext::calibrated_timestamps::Device::new(
                    instance,
                    &device.raw,
                ))
            })
        }
    }

    /// The time on the device's clock now, ticks.
    pub fn tick(&self) -> Option<u64> {
        let info =
            [vk::CalibratedTimestampInfoKHR::default().time_domain(vk::TimeDomainKHR::DEVICE)];
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

/// Whether the device's own clock is among those that can be read.
fn reads_device(domains: Vec<vk::TimeDomainKHR>) -> bool {
    domains.contains(&vk::TimeDomainKHR::DEVICE)
}
