//! Recognises double taps and long presses of one finger.

use glam::DVec2;

/// How far a finger may move and still tap, points.
const SLOP: f64 = 12.0;
/// Longest tap, and longest pause between the two of a double tap, seconds.
const TAP: f64 = 0.3;
/// After this time a finger that stays down is a long press, seconds.
const LONG: f64 = 0.5;

/// A finger on the screen, or a finished tap.
#[derive(Clone, Copy, Debug)]
struct Touch {
    id: u64,
    /// px.
    position: DVec2,
    /// When it came down, or when the tap ended, seconds.
    since: f64,
}

/// Follows the one finger that may be tapping. Times are seconds on a clock that never goes back.
#[derive(Clone, Debug, Default)]
pub struct TapGesture {
    finger: Option<Touch>,
    last_tap: Option<Touch>,
    /// All fingers that are down.
    down: Vec<u64>,
}

impl TapGesture {
    /// A finger comes down at a point, px.
    pub fn finger_down(&mut self, id: u64, position: DVec2, now: f64) {
        self.down.retain(|&known| known != id);
        self.down.push(id);
        if self.down.len() == 1 {
            self.finger = Some(Touch {
                id,
                position,
                since: now,
            });
        } else {
            // Two fingers pan and zoom.
            self.cancel();
        }
    }

    /// A finger moves to a point, px. `scale`: px a point.
    pub fn finger_moved(&mut self, id: u64, to: DVec2, scale: f64) {
        let strayed = |finger: Touch| finger.position.distance(to) > SLOP * scale;
        if self
            .finger
            .is_some_and(|finger| finger.id == id && strayed(finger))
        {
            self.cancel();
        }
    }

    /// A finger lifts. Returns whether this completes a double tap. `scale`: px a point.
    pub fn finger_up(&mut self, id: u64, now: f64, scale: f64) -> bool {
        self.down.retain(|&known| known != id);
        let Some(finger) = self.finger.take_if(|finger| finger.id == id) else {
            return false;
        };
        if now - finger.since > TAP {
            return false;
        }
        let is_second = self.last_tap.is_some_and(|last| {
            finger.since - last.since <= TAP
                && last.position.distance(finger.position) <= 3.0 * SLOP * scale
        });
        let tap = Touch {
            since: now,
            ..finger
        };
        self.last_tap = (!is_second).then_some(tap);
        is_second
    }

    /// When the finger that is down becomes a long press, seconds.
    pub fn long_press_at(&self) -> Option<f64> {
        self.finger.map(|finger| finger.since + LONG)
    }

    /// Returns whether a finger has become a long press: true once for each.
    pub fn take_long_press(&mut self, now: f64) -> bool {
        self.finger
            .take_if(|finger| now - finger.since >= LONG)
            .is_some()
    }

    /// The fingers that are down make another gesture.
    pub fn cancel(&mut self) {
        self.finger = None;
        self.last_tap = None;
    }

    /// No more events of the fingers that are down will come.
    pub fn reset(&mut self) {
        *self = Self::default();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: DVec2 = DVec2::new(100.0, 100.0);

    fn tap(taps: &mut TapGesture, at: DVec2, clock: f64) -> bool {
        taps.finger_down(1, at, clock);
        taps.finger_moved(1, at + 3.0, 1.0);
        taps.finger_up(1, clock + 0.1, 1.0)
    }

    #[test]
    fn two_quick_taps_on_one_spot_are_a_double_tap() {
        let mut taps = TapGesture::default();
        assert!(!tap(&mut taps, HERE, 0.0));
        assert!(tap(&mut taps, HERE, 0.3));
        assert!(!tap(&mut taps, HERE, 0.6), "the third is a first one again");
        assert!(tap(&mut taps, HERE, 0.9));
        for (second, at) in [(0.5, HERE), (0.2, HERE + 90.0)] {
            let mut taps = TapGesture::default();
            tap(&mut taps, HERE, 0.0);
            assert!(!tap(&mut taps, at, second), "{second} s, {at}");
        }
    }

    #[test]
    fn a_long_press_is_reported_once_and_is_no_tap() {
        let mut taps = TapGesture::default();
        taps.finger_down(4, HERE, 1.0);
        assert_eq!(taps.long_press_at(), Some(1.5));
        assert!(
            !taps.take_long_press(1.4) && taps.take_long_press(1.5) && !taps.take_long_press(1.6)
        );
        assert!(taps.long_press_at().is_none() && !taps.finger_up(4, 1.7, 1.0));
        assert!(
            !tap(&mut taps, HERE, 1.8),
            "a long press and a tap are no double tap"
        );
    }

    #[test]
    fn drags_and_second_fingers_neither_tap_nor_press() {
        let mut taps = TapGesture::default();
        taps.finger_down(1, HERE, 0.0);
        taps.finger_moved(1, HERE + 20.0, 1.0);
        assert!(taps.long_press_at().is_none());
        taps.finger_up(1, 0.1, 1.0);
        taps.finger_down(1, HERE, 1.0);
        taps.finger_moved(1, HERE + 20.0, 3.0);
        assert!(
            taps.long_press_at().is_some(),
            "20 px are little if a point has 3"
        );
        taps.finger_down(2, HERE + 50.0, 1.1);
        assert!(
            taps.long_press_at().is_none()
                && !taps.finger_up(2, 1.2, 1.0)
                && !taps.finger_up(1, 1.2, 1.0)
        );
        assert!(!tap(&mut taps, HERE, 1.25));
    }
}
