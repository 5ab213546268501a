//! Progress bars of long jobs.

use indicatif::{HumanDuration, ProgressBar, ProgressStyle, WeakProgressBar};
use std::{
    fmt::Arguments,
    io::{self, IsTerminal},
    thread,
    time::Duration,
};

/// From the start to the first line where there is no terminal; each wait after it is twice as long.
const FIRST_LINE: Duration = Duration::from_secs(5);
/// The longest wait for a line.
const LONGEST_WAIT: Duration = Duration::from_secs(60);

fn bar(length: u64, template: &str) -> ProgressBar {
    // A template that indicatif can't read costs its layout, not the job.
    let style =
        ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(length).with_style(style);
    if !io::stderr().is_terminal() {
        let weak = bar.downgrade();
        thread::spawn(move || print_lines(&weak));
    }
    bar
}

/// Prints now and then how far a bar is that nobody sees, until it ends.
fn print_lines(bar: &WeakProgressBar) {
    let mut wait = FIRST_LINE;
    loop {
        thread::sleep(wait);
        wait = LONGEST_WAIT.min(2 * wait);
        let Some(bar) = bar.upgrade().filter(|bar| !bar.is_finished()) else {
            return;
        };
        eprintln!("{}", line(&bar));
    }
}

/// How far a bar is, in a line.
fn line(bar: &ProgressBar) -> String {
    let mut words = Vec::new();
    let length = bar.length().unwrap_or(0);
    if length > 0 {
        words.push(format!("{} of {length}", bar.position()));
    }
    words.extend(Some(bar.message()).filter(|message| !message.is_empty()));
    words.push(if length > 0 && bar.position() > 0 {
        format!("about {} left", HumanDuration(bar.eta()))
    } else {
        format!("{} so far", HumanDuration(bar.elapsed()))
    });
    words.join(", ")
}

/// A bar over items of one kind, with the time that is left. A length of 0 is set later.
pub fn items(length: u64, unit: &str) -> ProgressBar {
    bar(
        length,
        &format!("{{bar:40}} {{pos}}/{{len}} {unit}, {{eta}} left {{msg}}"),
    )
}

/// Says something beside a bar, whether it is shown or not: indicatif itself is silent where there
/// is no terminal.
pub fn say(bar: &ProgressBar, text: Arguments) {
    bar.suspend(|| eprintln!("{text}"));
}

/// The candidate that is tried while the ways to draw are timed.
pub fn tuning() -> ProgressBar {
    bar(0, "{msg} {elapsed}")
}

/// A bar over steps that take unequal times, with the name of the step and the time so far.
pub fn steps(length: u64) -> ProgressBar {
    bar(length, "{bar:30} {pos}/{len} {msg} {elapsed}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_how_far_it_is() {
        let bar = ProgressBar::hidden();
        bar.set_length(0);
        bar.set_message("reading");
        assert_eq!(line(&bar), "reading, 0 seconds so far");
        bar.set_length(8);
        bar.set_position(2);
        bar.set_message("");
        let said = line(&bar);
        assert!(
            said.starts_with("2 of 8, about ") && said.ends_with(" left"),
            "{said}"
        );
    }
}
