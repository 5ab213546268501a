//! The time on the device's clock at a moment of the host's: by calibrated timestamps where the
//! driver has them, else by a timestamp that is submitted alone and waited for.

use super::{error::Result, gpu::Gpu, handle::QueryPool};
use ash::vk;
use std::time::{Duration, Instant};

/// Readings tried; the one between the nearest two of the host's counts.
const TRIES: usize = 16;

/// A moment on the clocks of the host and of the device.
#[derive(Clone, Copy, Debug)]
pub struct ClockMoment {
    /// The host's monotonic clock.
    pub host: Instant,
    /// The device's ticks, of which `Probe::timestamp_bits` count.
    pub tick: u64,
    /// How far the two may be apart.
    pub within: Duration,
    /// Whether the driver has read both clocks at once.
    pub calibrated: bool,
}

impl Gpu {
    /// Reads both clocks. Without calibrated timestamps the queue should be idle, or it takes as
    /// long as what is under way. None if the device has no timestamps.
    pub fn moment(&self) -> Option<ClockMoment> {
        if self.probe.timestamp_bits == 0 {
            return None;
        }
        match &self.calibration {
            Some(calibration) => self.nearest(true, || calibration.tick()),
            None => match self.submitted() {
                Ok(moment) => moment,
                Err(error) => {
                    tracing::debug!("the device's clock can't be read: {error}");
                    None
                }
            },
        }
    }

    /// The best of some readings.
    fn nearest(
        &self,
        calibrated: bool,
        mut tick: impl FnMut() -> Option<u64>,
    ) -> Option<ClockMoment> {
        let mut read = || {
            let before = Instant::now();
            let tick = tick()?;
            let within = before.elapsed() / 2;
            Some(ClockMoment {
                host: before + within,
                tick: tick & self.probe.tick_mask(),
                within,
                calibrated,
            })
        };
        (0..TRIES)
            .filter_map(|_| read())
            .min_by_key(|moment| moment.within)
    }

    /// Has the device write its clock, and waits for that.
    fn submitted(&self) -> Result<Option<ClockMoment>> {
        let pool = QueryPool::timestamps(&self.device, 1, "clock")?;
        let mut outcome = Ok(());
        let moment = self.nearest(false, || {
            outcome = self.write_timestamp(&pool);
            let mut tick = [0];
            (outcome.is_ok() && pool.read(&mut tick).is_ok()).then_some(tick[0])
        });
        outcome.map(|()| moment)
    }

    /// Has the device write its clock to the first query of a pool, and waits for that.
    fn write_timestamp(&self, pool: &QueryPool) -> Result<()> {
        let stage = vk::PipelineStageFlags::BOTTOM_OF_PIPE;
        // SAFETY: the command buffer is recording; the pool is alive, and `run` waits.
        self.run("reading the device's clock", |commands| unsafe {
            self.raw
                .cmd_reset_query_pool(commands.raw(), pool.raw(), 0, 1);
            self.raw
                .cmd_write_timestamp(commands.raw(), stage, pool.raw(), 0);
        })
    }
}
