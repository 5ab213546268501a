//! How often what a driver takes away may be made anew: losses and good frames go in, whether to go on comes out.

/// How often in a row a lost surface may be made anew.
const SURFACES: u32 = 5;
/// A device that has drawn for so long since it was lost is as good as one that never was, seconds.
const FORGIVEN: f64 = 5.0;

/// What was lost of late.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Losses {
    surfaces: u32,
    /// Devices that were opened.
    opened: u32,
    device: Device,
}

/// How the device has fared.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Device {
    #[default]
    Well,
    /// It was lost, and nothing has been drawn since.
    Lost,
    /// It was lost, and has drawn since a time, on a clock that only rises, seconds.
    Drawing(f64),
}

impl Losses {
    /// A device is about to be opened. Gives how many were before.
    pub fn open(&mut self) -> u32 {
        self.opened += 1;
        self.opened - 1
    }

    /// The window's surface was lost. True where another may be made.
    pub fn surface(&mut self) -> bool {
        self.surfaces += 1;
        self.surfaces <= SURFACES
    }

    /// The device was lost. True where it may be opened again.
    pub fn device(&mut self) -> bool {
        std::mem::replace(&mut self.device, Device::Lost) == Device::Well
    }

    /// A frame was drawn at a time.
    pub fn drawn(&mut self, clock: f64) {
        self.surfaces = 0;
        self.device = match self.device {
            Device::Lost => Device::Drawing(clock),
            Device::Drawing(since) if clock - since >= FORGIVEN => Device::Well,
            device => device,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_device_may_be_lost_once_in_a_while_but_not_twice_in_a_row() {
        let mut losses = Losses::default();
        assert!(losses.device() && !losses.device());
        let mut losses = Losses::default();
        for loss in 0..100 {
            assert!(losses.device(), "loss {loss}");
            (0..7).for_each(|second| losses.drawn(10.0 * f64::from(loss) + f64::from(second)));
        }
        assert!(losses.device());
        losses.drawn(2000.0);
        losses.drawn(2004.0);
        assert!(!losses.device(), "four seconds of frames are not enough");
        losses.drawn(9000.0);
        assert!(!losses.device(), "time without a frame says nothing");
    }

    #[test]
    fn surfaces_are_counted_from_one_frame_to_the_next() {
        let mut losses = Losses::default();
        for _ in 0..3 {
            assert!((0..SURFACES).all(|_| losses.surface()));
            losses.drawn(0.0);
        }
        (0..SURFACES).for_each(|_| assert!(losses.surface()));
        assert!(!losses.surface());
    }
}
