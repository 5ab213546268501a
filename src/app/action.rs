//! The user's actions, and their keys.

use crate::{playback::Repeat, views::StandardView};
use winit::keyboard::{Key, NamedKey};

/// How far a scrub key goes, seconds.
const SCRUB: f64 = 1.0;
/// Logarithm of the zoom of a key.
const ZOOM: f64 = 0.2;

/// Something that the user asks for with a key, a tap or the panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Play if paused, else pause.
    PlayOrPause,
    /// Pause, and go on by some frames of the clip, or back.
    Step(i32),
    /// Go forwards or back by some seconds.
    Scrub(f64),
    /// Go to a time of the clip, seconds.
    Seek(f64),
    /// Go on by some clips, or back.
    Next(i32),
    /// Show the clip with an index.
    Choose(usize),
    /// Load and show the avatar with an index in the file list.
    Avatar(usize),
    /// Load and show the avatar after the one that is shown.
    NextAvatar,
    /// Play at a speed, seconds of the clip a second.
    Speed(f64),
    /// Set what happens at the end of a clip.
    Repeat(Repeat),
    /// Show all of the avatar from the front.
    ResetView,
    /// Show the avatar from a side, or its face.
    View(StandardView),
    /// Zoom towards what is in the middle: the logarithm of the magnification.
    Zoom(f64),
    /// Whether the view moves with the avatar.
    Follow(bool),
    /// Enter or leave full screen.
    FullScreen,
    /// Leave full screen, or quit if the window is not in it.
    LeaveFullScreenOrQuit,
    /// Save a PNG.
    Screenshot,
    /// Capture a frame with RenderDoc, if it is attached.
    Capture,
    /// Share the report of an earlier crash with another app.
    Share,
    /// Survey the device, or end the survey that runs.
    Survey,
    /// Share what the survey found with another app.
    ShareSurvey,
    /// Show or hide the panel.
    Overlay,
    /// Show or hide the list of keys.
    Keys,
    /// Show or hide the files to open.
    Open,
    /// Show the next of the predefined backgrounds.
    NextBackground,
    /// Set the background: display-referred RGB, 0 to 1.
    Background([f32; 3]),
    /// Close the window.
    Quit,
}

/// The keys and what they do, for the panel and `effigy view --help`.
pub const KEYS: [(&str, &str); 18] = [
    ("Space", "play or pause"),
    ("Left Right", "a frame back or on"),
    ("Shift+Left", "a second back, or on with Right"),
    ("P N", "previous or next clip"),
    ("A", "next avatar"),
    ("L", "repeat: off, clip, all"),
    ("R", "reset the view"),
    ("1 to 6", "front, left, back, right, top, face"),
    ("+ -", "zoom in or out"),
    ("Ctrl+O", "open a file"),
    ("B", "next background"),
    ("S", "screenshot"),
    ("C", "capture a frame with RenderDoc"),
    ("H F1", "show or hide the panel"),
    ("?", "show or hide these keys"),
    ("F F11", "full screen"),
    ("Q", "quit"),
    ("Esc", "leave full screen, then quit"),
];

/// Gestures of mouse, trackpad and fingers, and their effects.
pub const POINTERS: [(&str, &str); 5] = [
    ("drag", "orbit: left button, one finger"),
    ("pan", "right or middle button, Shift, two fingers"),
    ("zoom", "wheel, trackpad, pinch"),
    (
        "taps",
        "double: reset the view; long: show or hide the panel",
    ),
    ("drop files", "show an avatar or splats, play motion"),
];

/// Keys and pointers as a help page.
pub fn help() -> String {
    let lines = POINTERS
        .iter()
        .chain(&KEYS)
        .map(|(key, what)| format!("  {key:<12} {what}\n"));
    format!("In the window:\n{}", lines.collect::<String>())
}

/// A key press.
pub struct KeyPress<'a> {
    /// The key, as the keyboard's layout has it.
    pub key: &'a Key,
    /// Shift is down.
    pub shift: bool,
    /// Control is down.
    pub control: bool,
    /// The system repeats the key because it is held down.
    pub is_repeated: bool,
}

/// The action of a key press, if it has one. Held keys only step, scrub and zoom. `repeat`: the
/// current setting, which the key L changes to the next.
pub fn key_action(press: &KeyPress, repeat: Repeat) -> Option<Action> {
    let shift = press.shift;
    let action = match press.key {
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
            "o" if press.control => Action::Open,
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
            "?" => Action::Keys,
            "+" | "=" => Action::Zoom(ZOOM),
            "-" => Action::Zoom(-ZOOM),
            digit => {
                let number: usize = digit.parse().ok()?;
                Action::View(*StandardView::ALL.get(number.checked_sub(1)?)?)
            }
        },
        _ => return None,
    };
    let repeats = matches!(action, Action::Step(_) | Action::Scrub(_) | Action::Zoom(_));
    (repeats || !press.is_repeated).then_some(action)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The action of a key, pressed once without Shift.
    fn press(text: &str, repeat: Repeat) -> Option<Action> {
        let key = Key::Character(text.into());
        let press = KeyPress {
            key: &key,
            shift: false,
            control: false,
            is_repeated: false,
        };
        key_action(&press, repeat)
    }

    #[test]
    fn a_held_key_steps_but_does_not_toggle() {
        let action_of = |key, shift, is_repeated| {
            let press = KeyPress {
                key: &Key::Named(key),
                shift,
                control: false,
                is_repeated,
            };
            key_action(&press, Repeat::Off)
        };
        let left = action_of(NamedKey::ArrowLeft, true, true);
        let right = action_of(NamedKey::ArrowRight, false, true);
        assert_eq!(left, Some(Action::Scrub(-SCRUB)));
        assert_eq!(right, Some(Action::Step(1)));
        assert_eq!(action_of(NamedKey::Space, false, true), None);
        let space = action_of(NamedKey::Space, false, false);
        assert_eq!(space, Some(Action::PlayOrPause));
    }

    #[test]
    fn letters_work_with_caps_lock_and_l_cycles_repeat() {
        assert_eq!(press("S", Repeat::Off), Some(Action::Screenshot));
        let mut repeat = Repeat::Off;
        for expected in [Repeat::Clip, Repeat::All, Repeat::Off] {
            assert_eq!(press("l", repeat), Some(Action::Repeat(expected)));
            repeat = expected;
        }
        assert_eq!(press("ß", Repeat::Off), None);
    }

    #[test]
    fn numbers_choose_views_and_signs_zoom() {
        assert_eq!(
            press("1", Repeat::Off),
            Some(Action::View(StandardView::Front))
        );
        assert_eq!(
            press("6", Repeat::Off),
            Some(Action::View(StandardView::Face))
        );
        for none in ["0", "7", "10", "1a"] {
            assert_eq!(press(none, Repeat::Off), None, "{none}");
        }
        assert_eq!(press("=", Repeat::Off), press("+", Repeat::Off));
        assert_eq!(press("-", Repeat::Off), Some(Action::Zoom(-ZOOM)));
        assert_eq!(press("?", Repeat::Off), Some(Action::Keys));
        let open = |control| {
            let press = KeyPress {
                key: &Key::Character("o".into()),
                shift: false,
                control,
                is_repeated: false,
            };
            key_action(&press, Repeat::Off)
        };
        assert_eq!([open(true), open(false)], [Some(Action::Open), None]);
        let held = KeyPress {
            key: &Key::Character("+".into()),
            shift: false,
            control: false,
            is_repeated: true,
        };
        assert_eq!(key_action(&held, Repeat::Off), Some(Action::Zoom(ZOOM)));
    }
}
