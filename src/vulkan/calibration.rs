//! What the device's clock says at a moment of the host's: by calibrated timestamps where the driver has them, else by a timestamp that is
//! submitted alone and waited for.

use super::{
    device::Gpu,
    error::{During, Result},
    instance::Instance,
    probe::Probe,
};
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
    /// Whether the driver has read both clocks at once.
    pub calibrated: bool,
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
    /// Reads both clocks. Without calibrated timestamps the queue should be idle, or it takes as long as what is under way. None where the
    /// device has no timestamps.
    pub fn moment(&self) -> Option<Moment> {
        if self.probe.timestamp_bits == 0 {
            return None;
        }
        match &self.calibration {
            Some(calibration) => self.nearest(true, || calibration.tick()),
            None => self.submitted().inspect_err(|error| tracing::debug!("the device's clock can't be read: {error}")).ok()?,
        }
    }

    /// The best of some readings.
    fn nearest(&self, calibrated: bool, mut tick: impl FnMut() -> Option<u64>) -> Option<Moment> {
        let mut read = || {
            let before = Instant::now();
            let tick = tick()?;
            let within = before.elapsed() / 2;
            Some(Moment { host: before + within, tick: tick & self.probe.tick_mask(), within, calibrated })
        };
        (0..TRIES).filter_map(|_| read()).min_by_key(|moment| moment.within)
    }

    /// Has the device write its clock, and waits for that.
    fn submitted(&self) -> Result<Option<Moment>> {
        let device = &self.raw;
        let info = vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(1);
        // SAFETY: `info` outlives the call.
        let pool = unsafe { device.create_query_pool(&info, None) }.during("vkCreateQueryPool")?;
        self.name(pool, "clock");
        let mut failed = Ok(());
        let moment = self.nearest(false, || {
            // SAFETY: the command buffer is recording; the pool is alive, and `run` waits.
            failed = self.run("reading the device's clock", |commands| unsafe {
                device.cmd_reset_query_pool(commands, pool, 0, 1);
                device.cmd_write_timestamp(commands, vk::PipelineStageFlags::BOTTOM_OF_PIPE, pool, 0);
            });
            let mut tick = [0u64];
            // SAFETY: the query was written, or the call says that it is not ready.
            let read = unsafe { device.get_query_pool_results(pool, 0, &mut tick, vk::QueryResultFlags::TYPE_64) };
            (failed.is_ok() && read.is_ok()).then_some(tick[0])
        });
        if !matches!(failed, Err(super::Error::Timeout { .. })) {
            // SAFETY: nothing uses it any more: what was submitted is done.
            unsafe { device.destroy_query_pool(pool, None) };
        }
        failed.map(|()| moment)
    }
}
