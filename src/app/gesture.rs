//! Turns events of mouse, trackpad and fingers into camera gestures, px.

use glam::DVec2;

/// Logarithm of the zoom of one notch of the wheel.
const ZOOM_PER_NOTCH: f64 = 0.12;
/// Logarithm of the zoom of scrolling by one px.
const ZOOM_PER_PX: f64 = 0.0035;
/// Fingers closer than this do not zoom, px: their distance is mostly noise.
const FINGERS_APART: f64 = 20.0;

/// A change of the view. The default changes nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gesture {
    /// Drag that turns the avatar, px.
    pub orbit: DVec2,
    /// Drag that moves the image, px.
    pub pan: DVec2,
    /// Logarithm of the magnification.
    pub zoom: f64,
    /// The point of the window that zooming leaves in place, px. None: its centre.
    pub about: Option<DVec2>,
}

/// A mouse button that drags.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// Orbits; pans with Shift.
    Left,
    /// Pans.
    Middle,
    /// Pans.
    Right,
}

/// Which buttons and fingers are down, and where.
#[derive(Clone, Debug, Default)]
pub struct Pointers {
    cursor: DVec2,
    button: Option<Button>,
    /// In the order in which they came down.
    fingers: Vec<Finger>,
}

/// A finger on the screen.
#[derive(Clone, Copy, Debug)]
struct Finger {
    id: u64,
    /// px.
    position: DVec2,
}

impl Pointers {
    /// A button goes down. It replaces one that is down already.
    pub fn press(&mut self, button: Button) {
        self.button = Some(button);
    }

    /// A button goes up.
    pub fn release(&mut self, button: Button) {
        if self.button == Some(button) {
            self.button = None;
        }
    }

    /// The mouse moves to a point, px. `shift`: the key is down.
    pub fn mouse_moved(&mut self, to: DVec2, shift: bool) -> Gesture {
        let by = to - self.cursor;
        self.cursor = to;
        match self.button {
            None => Gesture::default(),
            Some(Button::Left) if !shift => Gesture {
                orbit: by,
                ..Gesture::default()
            },
            Some(_) => Gesture {
                pan: by,
                ..Gesture::default()
            },
        }
    }

    /// The wheel turns by some notches; up is positive.
    pub fn wheel(&self, notches: f64) -> Gesture {
        Gesture {
            zoom: ZOOM_PER_NOTCH * notches,
            about: Some(self.cursor),
            ..Gesture::default()
        }
    }

    /// A trackpad scrolls by some px: this zooms, or pans while shift is down.
    pub fn scroll(&self, by: DVec2, shift: bool) -> Gesture {
        if shift {
            return Gesture {
                pan: by,
                ..Gesture::default()
            };
        }
        Gesture {
            zoom: ZOOM_PER_PX * by.y,
            about: Some(self.cursor),
            ..Gesture::default()
        }
    }

    /// A trackpad pinches. `by`: the magnification less 1. Some drivers report NaN, which is
    /// ignored.
    pub fn pinch(&self, by: f64) -> Gesture {
        let zoom = if by.is_finite() {
            by.clamp(-0.5, 1.0).ln_1p()
        } else {
            0.0
        };
        Gesture {
            zoom,
            about: Some(self.cursor),
            ..Gesture::default()
        }
    }

    /// A finger comes down at a point, px.
    pub fn finger_down(&mut self, id: u64, position: DVec2) {
        self.finger_up(id);
        self.fingers.push(Finger { id, position });
    }

    /// A finger lifts.
    pub fn finger_up(&mut self, id: u64) {
        self.fingers.retain(|finger| finger.id != id);
    }

    /// A finger moves to a point, px. One finger orbits. The first two of several pan with their
    /// middle and zoom with their distance.
    pub fn finger_moved(&mut self, id: u64, to: DVec2) -> Gesture {
        let Some(index) = self.fingers.iter().position(|finger| finger.id == id) else {
            return Gesture::default();
        };
        let from = self.fingers[index].position;
        self.fingers[index].position = to;
        match self.fingers.as_slice() {
            [_] => Gesture {
                orbit: to - from,
                ..Gesture::default()
            },
            [first, second, ..] if index < 2 => {
                let other = if index == 0 { second } else { first }.position;
                let middle = 0.5 * (to + other);
                let distance_before = from.distance(other).max(FINGERS_APART);
                let distance = to.distance(other).max(FINGERS_APART);
                Gesture {
                    pan: middle - 0.5 * (from + other),
                    zoom: (distance / distance_before).ln(),
                    about: Some(middle),
                    ..Gesture::default()
                }
            }
            _ => Gesture::default(),
        }
    }

    /// Stops following buttons and fingers that are down: their events will not come any more.
    pub fn cancel(&mut self) {
        self.button = None;
        self.fingers.clear();
    }

    /// Whether a button or a finger is down.
    pub fn is_dragging(&self) -> bool {
        self.button.is_some() || !self.fingers.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn left_orbits_and_right_middle_and_shift_pan() {
        let by = DVec2::new(10.0, -4.0);
        let drag = |button, shift| {
            let mut pointers = Pointers::default();
            pointers.mouse_moved(DVec2::splat(100.0), false);
            pointers.press(button);
            pointers.mouse_moved(DVec2::splat(100.0) + by, shift)
        };
        assert_eq!(
            drag(Button::Left, false),
            Gesture {
                orbit: by,
                ..Gesture::default()
            }
        );
        for (button, shift) in [
            (Button::Left, true),
            (Button::Middle, false),
            (Button::Right, true),
        ] {
            assert_eq!(
                drag(button, shift),
                Gesture {
                    pan: by,
                    ..Gesture::default()
                },
                "{button:?}, shift {shift}"
            );
        }
    }

    #[test]
    fn a_mouse_without_buttons_down_moves_nothing() {
        let mut pointers = Pointers::default();
        assert_eq!(
            pointers.mouse_moved(DVec2::new(50.0, 60.0), true),
            Gesture::default()
        );
        pointers.press(Button::Left);
        pointers.press(Button::Right);
        pointers.release(Button::Left);
        assert!(
            pointers.is_dragging(),
            "the button pressed last is still down"
        );
        pointers.release(Button::Right);
        assert_eq!(
            pointers.mouse_moved(DVec2::new(70.0, 60.0), false),
            Gesture::default()
        );
    }

    #[test]
    fn the_wheel_zooms_about_the_cursor() {
        let mut pointers = Pointers::default();
        pointers.mouse_moved(DVec2::new(20.0, 30.0), false);
        let zoom = pointers.wheel(1.0);
        assert!(zoom.zoom > 0.0 && zoom.about == Some(DVec2::new(20.0, 30.0)));
        assert_eq!(pointers.wheel(-1.0).zoom, -zoom.zoom);
        assert_eq!(
            pointers.scroll(DVec2::new(3.0, 9.0), true).pan,
            DVec2::new(3.0, 9.0)
        );
        assert!(pointers.scroll(DVec2::new(3.0, 9.0), false).zoom > 0.0);
        assert_eq!(pointers.pinch(f64::NAN).zoom, 0.0);
        assert!((pointers.pinch(0.1).zoom - 1.1_f64.ln()).abs() < 1e-12);
    }

    #[test]
    fn two_fingers_pan_and_zoom() {
        let mut pointers = Pointers::default();
        pointers.finger_down(7, DVec2::new(100.0, 100.0));
        pointers.finger_down(9, DVec2::new(200.0, 100.0));
        let apart = pointers.finger_moved(9, DVec2::new(300.0, 100.0));
        assert_eq!(
            (apart.pan, apart.orbit),
            (DVec2::new(50.0, 0.0), DVec2::ZERO)
        );
        assert!((apart.zoom - 2.0_f64.ln()).abs() < 1e-12, "{}", apart.zoom);
        assert_eq!(apart.about, Some(DVec2::new(200.0, 100.0)));
    }

    #[test]
    fn fingers_that_come_and_go_never_make_the_view_jump() {
        let mut pointers = Pointers::default();
        pointers.finger_down(1, DVec2::new(10.0, 10.0));
        pointers.finger_down(2, DVec2::new(500.0, 400.0));
        pointers.finger_down(3, DVec2::new(900.0, 10.0));
        assert_eq!(
            pointers.finger_moved(3, DVec2::new(0.0, 0.0)),
            Gesture::default(),
            "a third finger does nothing"
        );
        pointers.finger_up(1);
        assert_eq!(
            pointers.finger_moved(1, DVec2::new(90.0, 90.0)),
            Gesture::default(),
            "a lifted finger does nothing"
        );
        let pair = pointers.finger_moved(3, DVec2::new(2.0, 0.0));
        assert_eq!(
            pair.pan,
            DVec2::new(1.0, 0.0),
            "the third finger is now one of two"
        );
        pointers.finger_up(2);
        assert_eq!(
            pointers.finger_moved(3, DVec2::new(5.0, 1.0)).orbit,
            DVec2::new(3.0, 1.0)
        );
        pointers.finger_up(3);
        assert!(!pointers.is_dragging());
    }

    #[test]
    fn fingers_on_one_spot_do_not_zoom_without_bound() {
        let mut pointers = Pointers::default();
        pointers.finger_down(1, DVec2::ZERO);
        pointers.finger_down(2, DVec2::ZERO);
        assert_eq!(pointers.finger_moved(2, DVec2::new(5.0, 0.0)).zoom, 0.0);
    }
}
