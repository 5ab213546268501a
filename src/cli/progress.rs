//! Progress of long jobs: a bar on a terminal, and a line now and then where there is none.

use indicatif::{
    HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle, TermLike,
};
use std::{
    fmt::{Arguments, Write},
    io::{self, IsTerminal},
    sync::{Mutex, PoisonError},
    time::{Duration, Instant},
};

/// Without a terminal nothing is said before.
const FIRST: Duration = Duration::from_secs(5);
/// Longest time between two lines without a terminal.
const LONGEST: Duration = Duration::from_secs(60);

/// A bar whose `rest` is a template of indicatif's; `{left}` in it is the time that `left` expects,
/// and nothing as long as that is zero.
fn bar(
    length: u64,
    width: usize,
    rest: &str,
    left: impl Fn(&ProgressState) -> Duration + Clone + Send + Sync + 'static,
) -> ProgressBar {
    let is_terminal = io::stderr().is_terminal();
    let template = match width {
        1.. if is_terminal => format!("{{bar:{width}}} {rest}"),
        _ => rest.to_owned(),
    };
    let write_left = move |state: &ProgressState, to: &mut dyn Write| {
        let left = left(state);
        if !left.is_zero() {
            // A bar without it is no fault.
            let _ = write!(to, ", {:#} left", HumanDuration(left));
        }
    };
    // A template that indicatif can't read costs its layout, not the job.
    let style = ProgressStyle::with_template(&template)
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .with_key("left", write_left);
    let (target, tick) = if is_terminal {
        (ProgressDrawTarget::stderr(), Duration::from_millis(200))
    } else {
        let lines = ProgressDrawTarget::term_like(Box::new(Lines::default()));
        (lines, Duration::from_secs(1))
    };
    // One of 0 would show a full bar.
    let length = (length > 0).then_some(length);
    let bar = ProgressBar::with_draw_target(length, target).with_style(style);
    // Time goes on while a step takes long.
    bar.enable_steady_tick(tick);
    bar
}

/// A bar over items of one kind, with the time that is left. A length of 0 is set later: until then
/// it shows its message alone.
pub fn items(length: u64, unit: &'static str) -> ProgressBar {
    let bar = bar(length, 40, "{done}{left} {msg}", ProgressState::eta);
    let done = move |state: &ProgressState, to: &mut dyn Write| {
        // A bar without it is no fault.
        let _ = write_done(state.pos(), state.len(), unit, to);
    };
    let style = bar.style().with_key("done", done);
    bar.with_style(style)
}

fn write_done(done: u64, all: Option<u64>, unit: &str, to: &mut dyn Write) -> std::fmt::Result {
    match all {
        None | Some(0) => Ok(()),
        Some(all) => write!(to, "{done}/{all} {unit}"),
    }
}

/// A bar over steps with names, with the time so far and what is left if the others take as long.
pub fn steps(length: u64) -> ProgressBar {
    let rest = "{pos}/{len} {msg} {elapsed}{left}";
    bar(length, 30, rest, ProgressState::eta)
}

/// A bar over the share of a job that says itself what is left, in thousandths.
pub fn share() -> ProgressBar {
    bar(1000, 30, "{msg}", |_| Duration::ZERO)
}

/// What is done of a job that ends after so long at the latest.
pub fn within(limit: Duration) -> ProgressBar {
    let left = move |state: &ProgressState| limit.saturating_sub(state.elapsed());
    bar(0, 0, "{msg} {elapsed}{left}", left)
}

/// What is done of a job whose end nobody knows.
pub fn open_ended() -> ProgressBar {
    bar(0, 0, "{msg} {elapsed}", |_| Duration::ZERO)
}

/// Says something beside a bar, whether there is a terminal or not.
pub fn say(bar: &ProgressBar, text: Arguments) {
    bar.suspend(|| eprintln!("{text}"));
}

/// Where a bar is drawn without a terminal: of what it shows, a line now and then goes to standard
/// error.
#[derive(Debug)]
struct Lines {
    begun: Instant,
    drawn: Mutex<DrawnLine>,
}

#[derive(Debug)]
struct DrawnLine {
    text: String,
    /// From the begin to the next line.
    next: Duration,
}

impl Default for Lines {
    fn default() -> Self {
        Self {
            begun: Instant::now(),
            drawn: Mutex::new(DrawnLine {
                text: String::new(),
                next: FIRST,
            }),
        }
    }
}

impl DrawnLine {
    /// The line to write at a time since the begin, where one is due: rarer and rarer.
    fn take(&mut self, now: Duration) -> Option<String> {
        let text = std::mem::take(&mut self.text);
        let line = text.trim();
        if line.is_empty() || now < self.next {
            return None;
        }
        self.next = now + now.clamp(FIRST, LONGEST);
        Some(line.to_owned())
    }
}

impl Lines {
    fn drawn(&self) -> std::sync::MutexGuard<'_, DrawnLine> {
        self.drawn.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl TermLike for Lines {
    fn width(&self) -> u16 {
        200
    }

    fn move_cursor_up(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_down(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_right(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_left(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn write_line(&self, text: &str) -> io::Result<()> {
        self.write_str(text)
    }

    fn write_str(&self, text: &str) -> io::Result<()> {
        self.drawn().text.push_str(text);
        Ok(())
    }

    fn clear_line(&self) -> io::Result<()> {
        self.drawn().text.clear();
        Ok(())
    }

    fn flush(&self) -> io::Result<()> {
        if let Some(line) = self.drawn().take(self.begun.elapsed()) {
            eprintln!("{line}");
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_much_is_done_is_shown_once_it_is_known() {
        let shown = |done, all| {
            let mut text = String::new();
            write_done(done, all, "frames", &mut text).unwrap();
            text
        };
        assert_eq!(shown(0, None), "");
        assert_eq!(shown(3, Some(0)), "");
        assert_eq!(shown(3, Some(12)), "3/12 frames");
    }

    #[test]
    fn without_a_terminal_a_line_comes_now_and_then() {
        let mut drawn = DrawnLine {
            text: String::new(),
            next: FIRST,
        };
        let mut at = |seconds: u64| {
            drawn.text = format!("{seconds}   ");
            drawn.take(Duration::from_secs(seconds))
        };
        let said: Vec<String> = (0..300).filter_map(&mut at).collect();
        assert_eq!(
            said,
            ["5", "10", "20", "40", "80", "140", "200", "260"].map(str::to_owned)
        );
        assert_eq!(drawn.take(Duration::from_secs(1000)), None);
    }
}
