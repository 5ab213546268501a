//! Progress bars of long jobs.

use indicatif::{ProgressBar, ProgressStyle};
use std::fmt::Arguments;

fn bar(length: u64, template: &str) -> ProgressBar {
    // A template that indicatif can't read costs its layout, not the job.
    let style =
        ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(length).with_style(style)
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
