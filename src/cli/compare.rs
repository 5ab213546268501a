//! `effigy compare`: two files of `effigy bench --json` against each other.

use crate::measure::bench::compare::{self, Change, Line};
use anyhow::Context;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub struct Args {
    /// What to compare with, as `effigy bench --json` wrote it
    a: PathBuf,
    /// What to compare
    b: PathBuf,
    /// Leave out what differs by less than this, per cent
    #[arg(long, value_name = "PERCENT", default_value_t = 0.0)]
    above: f64,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let read = |path: &Path| {
        let text = std::fs::read_to_string(path).with_context(|| format!("{} can't be read", path.display()))?;
        compare::read(&text).with_context(|| format!("{} can't be compared", path.display()))
    };
    let comparison = compare::compare(&read(&args.a)?, &read(&args.b)?);
    anyhow::ensure!(!comparison.lines.is_empty(), "the two have no case in common: {}", comparison.alone.join(", "));
    comparison.warnings.iter().for_each(|warning| println!("note: {warning}"));
    let mut title = "";
    for line in comparison.lines.iter().filter(|line| is_above(line, args.above)) {
        if line.title != title {
            println!("\n{}\n  {:32}{:>16}{:>16}{:>12}", line.title, "", "first", "second", "change");
            title = &line.title;
        }
        println!("  {:32}{:>16}{:>16}{:>12}", line.name, number(line.a), number(line.b), change(line.change()));
    }
    comparison.alone.iter().for_each(|row| println!("not compared: {row}"));
    Ok(())
}

/// Whether a line changed by more than so many per cent; decibels count as they are.
fn is_above(line: &Line, percent: f64) -> bool {
    match line.change() {
        _ if percent <= 0.0 => true,
        Change::Ratio(ratio) => (ratio - 1.0).abs() * 100.0 > percent,
        Change::Decibel(difference) => 100.0 * (10f64.powf(difference.abs() / 20.0) - 1.0) > percent,
        Change::None => true,
    }
}

fn change(change: Change) -> String {
    match change {
        Change::Ratio(ratio) => format!("{ratio:.3}×"),
        Change::Decibel(difference) => format!("{difference:+.2} dB"),
        Change::None => "–".to_owned(),
    }
}

/// Five digits that count, or all of a whole number.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() {
        return "exact".to_owned();
    }
    if value.fract() == 0.0 {
        return format!("{value:.0}");
    }
    let digits = 4 - value.abs().log10().floor().clamp(-8.0, 4.0) as i32;
    format!("{value:.*}", digits.unsigned_abs() as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_five_digits_that_count() {
        let written = [0.0, 17.0, 123_456.0, 0.123_456_7, 12.345_678, 98_765.43, 0.000_012_345_6, f64::INFINITY].map(number);
        assert_eq!(written, ["0", "17", "123456", "0.12346", "12.346", "98765", "0.000012346", "exact"]);
    }
}
