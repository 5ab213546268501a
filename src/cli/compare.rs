//! `effigy compare`: two files of `effigy bench --json`, or of `effigy soak`, against each other.

use crate::{
    files,
    output::{CHART, Output},
};
use anyhow::{Context, ensure};
use effigy_measure::{
    bench::{BenchReport, size_chart},
    report::{ReadError, chart_title},
    soak::SoakReport,
    table::{Change, ComparedNumber, Comparison},
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
    /// Also chart error and time against the avatar's size, of the cases in which it has a height,
    /// to an .svg or a .png; each line is named as its file is; not for soaks
    #[arg(long, value_name = "FILE", value_parser = CHART.parser())]
    chart: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let texts = [files::read_text(&args.a)?, files::read_text(&args.b)?];
    if texts.iter().all(|text| SoakReport::read(text).is_ok()) {
        return soaks(&args.a, &args.b);
    }
    let [a, b] = [&args.a, &args.b].map(|path| read(path, BenchReport::read));
    let (a, b) = (a?, b?);
    let comparison = a.compared_with(&b);
    ensure!(
        !comparison.lines.is_empty(),
        "the two have no case in common: {}",
        comparison.alone.join(", ")
    );
    print(&comparison, args.above);
    let Some(out) = &args.chart else {
        return Ok(());
    };
    let [first, second] = [&args.a, &args.b].map(|path| {
        let name = path.file_stem().unwrap_or_default();
        name.to_string_lossy().into_owned()
    });
    let title = chart_title(&a.avatar, a.size, &a.device);
    let chart = size_chart(&[(&first, &a), (&second, &b)], title)?;
    out.write(chart.encoded(out.ending())?)
}

/// Prints two soaks against each other.
pub fn soaks(a: &Path, b: &Path) -> anyhow::Result<()> {
    let [a, b] = [a, b].map(|path| read(path, SoakReport::read));
    print(&a?.compared_with(&b?), 0.0);
    Ok(())
}

/// Reads a report.
fn read<T>(path: &Path, parse: fn(&str) -> Result<T, ReadError>) -> anyhow::Result<T> {
    let text = files::read_text(path)?;
    parse(&text).with_context(|| format!("{} can't be compared", path.display()))
}

/// Prints the lines that differ by more than `above` per cent, under the title of their row.
fn print(comparison: &Comparison, above: f64) {
    for warning in &comparison.warnings {
        println!("note: {warning}");
    }
    let mut title = None;
    for line in &comparison.lines {
        if !is_above(line, above) {
            continue;
        }
        if title != Some(&line.title) {
            if !line.title.is_empty() {
                println!("\n{}", line.title);
            }
            println!(
                "  {:32}{:>16}{:>16}{:>12}  second is",
                "", "first", "second", "change"
            );
            title = Some(&line.title);
        }
        let [a, b] = line.values.map(|value| value.map_or("–".into(), number));
        let judged = match line.is_better() {
            Some(true) => "better",
            Some(false) => "worse",
            None => "",
        };
        println!(
            "  {:32}{a:>16}{b:>16}{:>12}  {judged}",
            line.name,
            change(line.change())
        );
    }
    for row in &comparison.alone {
        println!("not compared: {row}");
    }
}

/// Whether a line changed by more than `percent`. Decibels count by the change of the error that
/// they stand for.
fn is_above(line: &ComparedNumber, percent: f64) -> bool {
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
