//! How often lost surfaces and devices may be replaced: losses and frames go in, the decision
//! whether to go on comes out.

use crate::options::{DriverLoss, Rehearsal};
use effigy_render::vulkan::Error;

/// Surfaces in a row that may be replaced.
const SURFACES: u32 = 5;
/// After this many seconds of frames, a device counts as one that was never lost.
const FORGIVEN: f64 = 5.0;

/// The call at which a rehearsed loss happens.
pub const REHEARSAL: &str = "a rehearsal";

/// Recent losses, and losses that are yet to be simulated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recovery {
    surfaces: u32,
    opened_devices: u32,
    device: DeviceHealth,
    rehearsals: Vec<Rehearsal>,
}

/// How the device has fared.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum DeviceHealth {
    #[default]
    Good,
    /// It was lost, and nothing has been drawn since.
    Lost,
    /// It was lost, and has drawn since a time, on a clock that never goes back, seconds.
    Recovering { since: f64 },
}

impl Recovery {
    /// `rehearsals`: losses to simulate.
    pub fn new(rehearsals: Vec<Rehearsal>) -> Self {
        Self {
            rehearsals,
            ..Self::default()
        }
    }

    /// A device is about to be opened. Fails if its lack of memory is to be simulated.
    pub fn open_device(&mut self) -> Result<(), Error> {
        let number = self.opened_devices;
        self.opened_devices += 1;
        self.rehearse(&[DriverLoss::Memory], number)
    }

    /// The window's surface was lost. Returns whether another one may be created.
    pub fn surface_lost(&mut self) -> bool {
        self.surfaces += 1;
        self.surfaces <= SURFACES
    }

    /// The device was lost. Returns whether it may be opened again.
    pub fn device_lost(&mut self) -> bool {
        let was_good = self.device == DeviceHealth::Good;
        self.device = DeviceHealth::Lost;
        was_good
    }

    /// A frame was drawn at a time, seconds.
    pub fn frame_drawn(&mut self, now: f64) {
        self.surfaces = 0;
        self.device = match self.device {
            DeviceHealth::Lost => DeviceHealth::Recovering { since: now },
            DeviceHealth::Recovering { since } if now - since >= FORGIVEN => DeviceHealth::Good,
            device => device,
        };
    }

    /// Fails as if something had been lost, if one of these losses is to be simulated at this
    /// number.
    pub fn rehearse(&mut self, losses: &[DriverLoss], number: u32) -> Result<(), Error> {
        let is_due =
            |rehearsal: &Rehearsal| rehearsal.number == number && losses.contains(&rehearsal.loss);
        let Some(due) = self.rehearsals.iter().position(is_due) else {
            return Ok(());
        };
        Err(match self.rehearsals.remove(due).loss {
            DriverLoss::Surface => Error::SurfaceLost(REHEARSAL),
            DriverLoss::Device => Error::DeviceLost(REHEARSAL),
            DriverLoss::Memory => Error::OutOfMemory {
                memory: "device",
                call: REHEARSAL,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_device_may_be_lost_now_and_then_but_not_twice_in_a_row() {
        let mut recovery = Recovery::default();
        assert!(recovery.device_lost() && !recovery.device_lost());
        let mut recovery = Recovery::default();
        for loss in 0..100 {
            assert!(recovery.device_lost(), "loss {loss}");
            for second in 0..7 {
                recovery.frame_drawn(10.0 * f64::from(loss) + f64::from(second));
            }
        }
        assert!(recovery.device_lost());
        recovery.frame_drawn(2000.0);
        recovery.frame_drawn(2004.0);
        assert!(
            !recovery.device_lost(),
            "four seconds of frames are not enough"
        );
        recovery.frame_drawn(9000.0);
        assert!(
            !recovery.device_lost(),
            "time without a frame does not count"
        );
    }

    #[test]
    fn surfaces_are_counted_from_one_frame_to_the_next() {
        let mut recovery = Recovery::default();
        for _ in 0..3 {
            assert!((0..SURFACES).all(|_| recovery.surface_lost()));
            recovery.frame_drawn(0.0);
        }
        for _ in 0..SURFACES {
            assert!(recovery.surface_lost());
        }
        assert!(!recovery.surface_lost());
    }

    #[test]
    fn a_rehearsed_loss_happens_once_at_its_number() {
        let rehearsal = |loss, number| Rehearsal { loss, number };
        let mut recovery = Recovery::new(vec![
            rehearsal(DriverLoss::Device, 2),
            rehearsal(DriverLoss::Memory, 1),
        ]);
        let frame = [DriverLoss::Surface, DriverLoss::Device];
        assert!(recovery.open_device().is_ok());
        assert!(matches!(
            recovery.open_device(),
            Err(Error::OutOfMemory { .. })
        ));
        assert!(recovery.rehearse(&frame, 1).is_ok());
        assert!(matches!(
            recovery.rehearse(&frame, 2),
            Err(Error::DeviceLost(_))
        ));
        assert!(recovery.rehearse(&frame, 2).is_ok());
    }
}
