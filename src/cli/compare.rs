//! `effigy compare`: two files of `effigy bench --json`, or of `effigy soak`, against each other.

use crate::files;
use anyhow::{Context, ensure};
use effigy_measure::{
    bench::{
        self,
        compare::{BenchNumber, Change},
    },
    soak,
};
use std::path::{Path, PathBuf};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// First measurement: JSON that `effigy bench --json` or `effigy soak` wrote
    a: PathBuf,
    /// Second measurement, of the same command
    b: PathBuf,
    /// Leave out what differs by less than this, per cent; not for soaks
    #[arg(long, value_name = "PERCENT", default_value_t = 0.0)]
    above: f64,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let texts = [files::read_text(&args.a)?, files::read_text(&args.b)?];
    if texts.iter().all(|text| soak::compare::read(text).is_ok()) {
        return soaks(&args.a, &args.b);
    }
    let parse = |path: &Path, text: &str| {
        bench::compare::read(text).with_context(|| format!("{} can't be compared", path.display()))
    };
    let [a, b] = &texts;
    let comparison = bench::compare::compare(&parse(&args.a, a)?, &parse(&args.b, b)?);
    ensure!(
        !comparison.lines.is_empty(),
        "the two have no case in common: {}",
        comparison.alone.join(", ")
    );
    for warning in &comparison.warnings {
        println!("note: {warning}");
    }
    let mut title = "";
    for line in &comparison.lines {
        if !is_above(line, args.above) {
            continue;
        }
        if line.title != title {
            println!(
                "\n{}\n  {:32}{:>16}{:>16}{:>12}",
                line.title, "", "first", "second", "change"
            );
            title = &line.title;
        }
        println!(
            "  {:32}{:>16}{:>16}{:>12}",
            line.name,
            number(line.a),
            number(line.b),
            change(line.change())
        );
    }
    for row in &comparison.alone {
        println!("not compared: {row}");
    }
    Ok(())
}

/// Prints two soaks against each other.
pub fn soaks(a: &Path, b: &Path) -> anyhow::Result<()> {
    let read = |path: &Path| {
        soak::compare::read(&files::read_text(path)?)
            .with_context(|| format!("{} can't be compared", path.display()))
    };
    let (lines, differences) = soak::compare::compare(&read(a)?, &read(b)?);
    for difference in differences {
        println!("note: {difference}");
    }
    println!("  {:26}{:>16}{:>16}{:>12}", "", "first", "second", "change");
    let cell = |value: Option<f64>| value.map_or("–".to_owned(), number);
    for line in lines {
        let [a, b] = line.values;
        let change = match (a, b) {
            (Some(a), Some(b)) if a != 0.0 && b != 0.0 => format!("{:.3}×", b / a),
            _ => "–".to_owned(),
        };
        println!(
            "  {:26}{:>16}{:>16}{change:>12}",
            line.name,
            cell(a),
            cell(b)
        );
    }
    Ok(())
}

/// Whether a line changed by more than `percent`. Decibels count by the change of the error that
/// they stand for.
fn is_above(line: &BenchNumber, percent: f64) -> bool {
    match line.change() {
        _ if percent <= 0.0 => true,
        Change::Ratio(ratio) => (ratio - 1.0).abs() * 100.0 > percent,
        Change::Decibel(difference) => {
            100.0 * (10f64.powf(difference.abs() / 20.0) - 1.0) > percent
        }
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

/// Five significant digits, or all digits of a whole number.
fn number(value: f64) -> String {
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
    fn numbers_have_five_significant_digits() {
        let written = [
            0.0,
            17.0,
            123_456.0,
            0.123_456_7,
            12.345_678,
            98_765.43,
            0.000_012_345_6,
            f64::INFINITY,
        ]
        .map(number);
        assert_eq!(
            written,
            [
                "0",
                "17",
                "123456",
                "0.12346",
                "12.346",
                "98765",
                "0.000012346",
                "exact"
            ]
        );
    }
}
