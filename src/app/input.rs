//! Turns the window's input events into gestures and actions.

use crate::{
    action::{Action, KeyPress, key_action},
    gesture::{Button, Gesture, Pointers},
    playback::Repeat,
    tap_gesture::TapGesture,
};
use glam::DVec2;
use winit::{
    event::{
        ElementState, KeyEvent, MouseButton, MouseScrollDelta, Touch, TouchPhase, WindowEvent,
    },
    keyboard::ModifiersState,
};

/// Which buttons, fingers and modifier keys are down.
#[derive(Default)]
pub struct InputState {
    pointers: Pointers,
    taps: TapGesture,
    modifiers: ModifiersState,
}

impl InputState {
    /// The camera gesture of an event, if it is one. `consumed`: the panel handles the event.
    pub fn gesture(&mut self, event: &WindowEvent, consumed: bool) -> Option<Gesture> {
        let shift = self.modifiers.shift_key();
        match event {
            WindowEvent::CursorMoved { position, .. } => {
                let position = DVec2::new(position.x, position.y);
                Some(self.pointers.mouse_moved(position, shift))
            }
            WindowEvent::MouseInput { state, button, .. } => {
                self.mouse_button(*button, *state, consumed);
                None
            }
            WindowEvent::MouseWheel { delta, .. } if !consumed => Some(match delta {
                MouseScrollDelta::LineDelta(_, lines) => self.pointers.wheel(f64::from(*lines)),
                MouseScrollDelta::PixelDelta(by) => {
                    self.pointers.scroll(DVec2::new(by.x, by.y), shift)
                }
            }),
            WindowEvent::PinchGesture { delta, .. } if !consumed => {
                Some(self.pointers.pinch(*delta))
            }
            WindowEvent::Touch(touch) => self.finger(touch, consumed),
            _ => None,
        }
    }

    fn mouse_button(&mut self, button: MouseButton, state: ElementState, consumed: bool) {
        let button = match button {
            MouseButton::Left => Button::Left,
            MouseButton::Middle => Button::Middle,
            MouseButton::Right => Button::Right,
            _ => return,
        };
        match state {
            ElementState::Pressed if consumed => {}
            ElementState::Pressed => self.pointers.press(button),
            ElementState::Released => self.pointers.release(button),
        }
    }

    fn finger(&mut self, touch: &Touch, consumed: bool) -> Option<Gesture> {
        let position = DVec2::new(touch.location.x, touch.location.y);
        match touch.phase {
            TouchPhase::Started if consumed => None,
            TouchPhase::Started => {
                self.pointers.finger_down(touch.id, position);
                None
            }
            TouchPhase::Moved => Some(self.pointers.finger_moved(touch.id, position)),
            TouchPhase::Ended | TouchPhase::Cancelled => {
                self.pointers.finger_up(touch.id);
                None
            }
        }
    }

    /// Whether a touch completes a double tap. `consumed`: the panel handles the event. `now`:
    /// seconds. `scale`: px a point.
    pub fn is_double_tap(&mut self, touch: &Touch, consumed: bool, now: f64, scale: f64) -> bool {
        let position = DVec2::new(touch.location.x, touch.location.y);
        match touch.phase {
            TouchPhase::Started if consumed => self.taps.cancel(),
            TouchPhase::Started => self.taps.finger_down(touch.id, position, now),
            TouchPhase::Moved => self.taps.finger_moved(touch.id, position, scale),
            TouchPhase::Ended => return self.taps.finger_up(touch.id, now, scale),
            TouchPhase::Cancelled => self.taps.reset(),
        }
        false
    }

    /// When the finger that is down becomes a long press, seconds.
    pub fn long_press_at(&self) -> Option<f64> {
        self.taps.long_press_at()
    }

    /// Returns whether a finger has become a long press: true once for each. `now`: seconds.
    pub fn take_long_press(&mut self, now: f64) -> bool {
        self.taps.take_long_press(now)
    }

    /// The action of a key press, if it has one. `repeat`: the current setting of playback.
    pub fn key_action(&self, event: &KeyEvent, repeat: Repeat) -> Option<Action> {
        let press = KeyPress {
            key: &event.logical_key,
            shift: self.modifiers.shift_key(),
            control: self.modifiers.control_key(),
            is_repeated: event.repeat,
        };
        key_action(&press, repeat)
    }

    /// The modifier keys that are down have changed.
    pub fn set_modifiers(&mut self, modifiers: ModifiersState) {
        self.modifiers = modifiers;
    }

    /// Stops following buttons and fingers that are down: their events will not come any more.
    pub fn cancel(&mut self) {
        self.pointers.cancel();
        self.taps.reset();
    }
}
