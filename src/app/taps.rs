//! Taps: one finger's comings and goings go in, double taps and long presses come out.

use glam::DVec2;

/// A finger may stray so far and still tap, points.
const SLOP: f64 = 12.0;
/// A tap takes no longer, and neither does the pause between two, seconds.
const TAP: f64 = 0.3;
/// A finger that stays so long presses, seconds.
const LONG: f64 = 0.5;

/// A finger on the screen, or a tap that is over: where, px, and since when, seconds.
#[derive(Clone, Copy, Debug)]
struct Touch {
    id: u64,
    at: DVec2,
    clock: f64,
}

/// Follows the one finger that may be tapping.
#[derive(Clone, Debug, Default)]
pub struct Taps {
    finger: Option<Touch>,
    last: Option<Touch>,
    /// All fingers that are down.
    down: Vec<u64>,
}

impl Taps {
    pub fn finger_down(&mut self, id: u64, at: DVec2, clock: f64) {
        self.down.retain(|&known| known != id);
        self.down.push(id);
        // A second finger makes it another gesture.
        self.finger = (self.down.len() == 1).then_some(Touch { id, at, clock });
        self.last = self.last.filter(|_| self.finger.is_some());
    }

    /// `scale` is how many px a point has.
    pub fn finger_moved(&mut self, id: u64, to: DVec2, scale: f64) {
        if self.finger.is_some_and(|finger| finger.id == id && finger.at.distance(to) > SLOP * scale) {
            self.cancel();
        }
    }

    /// True where this makes a double tap.
    pub fn finger_up(&mut self, id: u64, clock: f64, scale: f64) -> bool {
        self.down.retain(|&known| known != id);
        let Some(tap) = self.finger.take_if(|finger| finger.id == id).filter(|finger| clock - finger.clock <= TAP) else { return false };
        let second = self.last.is_some_and(|last| tap.clock - last.clock <= TAP && last.at.distance(tap.at) <= 3.0 * SLOP * scale);
        self.last = (!second).then_some(Touch { clock, ..tap });
        second
    }

    /// When a finger that is down will have pressed for long, seconds.
    pub fn due(&self) -> Option<f64> {
        self.finger.map(|finger| finger.clock + LONG)
    }

    /// True once for a finger that has pressed for long.
    pub fn held(&mut self, clock: f64) -> bool {
        self.finger.take_if(|finger| clock - finger.clock >= LONG).is_some()
    }

    /// What the fingers do is no tap.
    pub fn cancel(&mut self) {
        self.finger = None;
        self.last = None;
    }

    /// Nothing is down any more, as far as anyone will say.
    pub fn forget(&mut self) {
        *self = Self::default();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: DVec2 = DVec2::new(100.0, 100.0);

    fn tap(taps: &mut Taps, at: DVec2, clock: f64) -> bool {
        taps.finger_down(1, at, clock);
        taps.finger_moved(1, at + 3.0, 1.0);
        taps.finger_up(1, clock + 0.1, 1.0)
    }

    #[test]
    fn two_quick_taps_on_one_spot_are_a_double_tap_and_three_are_not_two() {
        let mut taps = Taps::default();
        assert!(!tap(&mut taps, HERE, 0.0));
        assert!(tap(&mut taps, HERE, 0.3));
        assert!(!tap(&mut taps, HERE, 0.6), "the third begins anew");
        assert!(tap(&mut taps, HERE, 0.9));
        for (second, at) in [(0.5, HERE), (0.2, HERE + 90.0)] {
            let mut taps = Taps::default();
            tap(&mut taps, HERE, 0.0);
            assert!(!tap(&mut taps, at, second), "{second} s, {at}");
        }
    }

    #[test]
    fn a_finger_that_stays_presses_once_and_its_lifting_is_no_tap() {
        let mut taps = Taps::default();
        taps.finger_down(4, HERE, 1.0);
        assert_eq!(taps.due(), Some(1.5));
        assert!(!taps.held(1.4) && taps.held(1.5) && !taps.held(1.6));
        assert!(taps.due().is_none() && !taps.finger_up(4, 1.7, 1.0));
        assert!(!tap(&mut taps, HERE, 1.8), "a press and a tap are no double tap");
    }

    #[test]
    fn drags_and_second_fingers_neither_tap_nor_press() {
        let mut taps = Taps::default();
        taps.finger_down(1, HERE, 0.0);
        taps.finger_moved(1, HERE + 20.0, 1.0);
        assert!(taps.due().is_none());
        taps.finger_up(1, 0.1, 1.0);
        taps.finger_down(1, HERE, 1.0);
        taps.finger_moved(1, HERE + 20.0, 3.0);
        assert!(taps.due().is_some(), "20 px are little where a point has 3");
        taps.finger_down(2, HERE + 50.0, 1.1);
        assert!(taps.due().is_none() && !taps.finger_up(2, 1.2, 1.0) && !taps.finger_up(1, 1.2, 1.0));
        assert!(!tap(&mut taps, HERE, 1.25));
    }
}
