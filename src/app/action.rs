//! What the user can ask of the viewer, and the keys that ask for it.

use super::playback::Repeat;
use winit::keyboard::{Key, NamedKey};

/// Seconds that a scrub key goes forwards or back.
const SCRUB: f64 = 1.0;

/// A wish, from a key or from the overlay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    PlayOrPause,
    /// By so many frames of the clip.
    Step(i32),
    /// By so many seconds.
    Scrub(f64),
    /// To a time of the clip, seconds.
    Seek(f64),
    /// By so many clips.
    Next(i32),
    /// A clip by its number.
    Choose(usize),
    /// An avatar of the shelf by its number.
    Avatar(usize),
    /// The one after the one that is shown.
    NextAvatar,
    Speed(f64),
    Repeat(Repeat),
    ResetView,
    Follow(bool),
    FullScreen,
    LeaveFullScreenOrQuit,
    Screenshot,
    /// By RenderDoc, where it is attached.
    Capture,
    /// Hand what is left of a crash to another app.
    Share,
    Overlay,
    NextBackground,
    /// Display-referred RGB, 0 to 1.
    Background([f32; 3]),
    Quit,
}

/// The keys and what they do, for the overlay and `effigy view --help`.
pub const KEYS: [(&str, &str); 14] = [
    ("Space", "play or pause"),
    ("Left Right", "a frame back or on"),
    ("Shift+Left", "a second back, or on with Right"),
    ("P N", "previous or next clip"),
    ("A", "next avatar"),
    ("L", "repeat: off, clip, all"),
    ("R", "reset the view"),
    ("B", "next background"),
    ("S", "screenshot"),
    ("C", "capture a frame by RenderDoc"),
    ("H F1", "show or hide this panel"),
    ("F F11", "full screen"),
    ("Q", "quit"),
    ("Esc", "leave full screen, then quit"),
];

/// What mouse, trackpad and fingers do.
pub const POINTERS: [(&str, &str); 4] = [
    ("drag", "orbit: left button, one finger"),
    ("pan", "right or middle button, Shift, two fingers"),
    ("zoom", "wheel, trackpad, pinch"),
    ("taps", "two reset the view, a long one shows or hides this panel"),
];

/// Keys and pointers as a help page.
pub fn help() -> String {
    let lines = POINTERS.iter().chain(&KEYS).map(|(key, what)| format!("  {key:<12} {what}\n"));
    format!("In the window:\n{}", lines.collect::<String>())
}

/// What a key asks for. `again`: it comes from holding the key down, which only steps and scrubs answer to.
pub fn action(key: &Key, shift: bool, again: bool, repeat: Repeat) -> Option<Action> {
    let action = match key {
        Key::Named(named) => match named {
            NamedKey::Space => Action::PlayOrPause,
            NamedKey::ArrowLeft if shift => Action::Scrub(-SCRUB),
            NamedKey::ArrowRight if shift => Action::Scrub(SCRUB),
            NamedKey::ArrowLeft => Action::Step(-1),
            NamedKey::ArrowRight => Action::Step(1),
            NamedKey::F1 => Action::Overlay,
            NamedKey::F11 => Action::FullScreen,
            NamedKey::BrowserBack if cfg!(target_os = "android") => Action::Quit,
            NamedKey::Escape => Action::LeaveFullScreenOrQuit,
            _ => return None,
        },
        Key::Character(character) => match character.to_lowercase().as_str() {
            "a" => Action::NextAvatar,
            "n" => Action::Next(1),
            "p" => Action::Next(-1),
            "l" => Action::Repeat(match repeat {
                Repeat::Off => Repeat::Clip,
                Repeat::Clip => Repeat::All,
                Repeat::All => Repeat::Off,
            }),
            "r" => Action::ResetView,
            "b" => Action::NextBackground,
            "s" => Action::Screenshot,
            "c" => Action::Capture,
            "h" => Action::Overlay,
            "f" => Action::FullScreen,
            "q" => Action::Quit,
            _ => return None,
        },
        _ => return None,
    };
    (!again || matches!(action, Action::Step(_) | Action::Scrub(_))).then_some(action)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(text: &str) -> Key {
        Key::Character(text.into())
    }

    #[test]
    fn a_held_key_steps_but_does_not_toggle() {
        let of = |key: Key, shift, again| action(&key, shift, again, Repeat::Off);
        assert_eq!(of(Key::Named(NamedKey::ArrowRight), false, true), Some(Action::Step(1)));
        assert_eq!(of(Key::Named(NamedKey::ArrowLeft), true, true), Some(Action::Scrub(-SCRUB)));
        assert_eq!(of(Key::Named(NamedKey::Space), false, true), None);
        assert_eq!(of(Key::Named(NamedKey::Space), false, false), Some(Action::PlayOrPause));
    }

    #[test]
    fn letters_work_with_caps_lock_and_the_repeat_key_goes_round() {
        assert_eq!(action(&key("S"), false, false, Repeat::Off), Some(Action::Screenshot));
        let mut repeat = Repeat::Off;
        for expected in [Repeat::Clip, Repeat::All, Repeat::Off] {
            assert_eq!(action(&key("l"), false, false, repeat), Some(Action::Repeat(expected)));
            repeat = expected;
        }
        assert_eq!(action(&key("ß"), false, false, Repeat::Off), None);
    }
}
