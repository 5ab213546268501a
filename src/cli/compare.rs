//! `effigy compare`: two files of `effigy bench --json`, or of `effigy soak`, against each other.

use crate::{
    files,
    output::{CHART, Output},
};
use anyhow::{Context, ensure};
use effigy_measure::{
    bench::{
        self, BenchReport,
        compare::{BenchNumber, Change},
        sizes::{self, NamedReport},
    },
    report::chart_title,
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
    /// Also chart error and time against the avatar's size, of the cases in which it has a height,
    /// to an .svg or a .png; each line is named as its file is; not for soaks
    #[arg(long, value_name = "FILE", value_parser = CHART.parser())]
    chart: Option<Output>,
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
    let [a, b] = [parse(&args.a, a)?, parse(&args.b, b)?];
    let comparison = bench::compare::compare(&a, &b);
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
                "\n{}\n  {:32}{:>16}{:>16}{:>12}  second is",
                line.title, "", "first", "second", "change"
            );
            title = &line.title;
        }
        println!(
            "  {:32}{:>16}{:>16}{:>12}  {}",
            line.name,
            number(line.a),
            number(line.b),
            change(line.change()),
            judged(line.is_better())
        );
    }
    for row in &comparison.alone {
        println!("not compared: {row}");
    }
    match &args.chart {
        Some(out) => write_chart(out, [(&args.a, &a), (&args.b, &b)]),
        None => Ok(()),
    }
}

/// Charts measurements, each with the file that it was read from.
fn write_chart(out: &Output, measured: [(&PathBuf, &BenchReport); 2]) -> anyhow::Result<()> {
    let names = measured.map(|(path, _)| {
        let name = path.file_stem().unwrap_or_default();
        name.to_string_lossy().into_owned()
    });
    let reports: [NamedReport; 2] = std::array::from_fn(|k| NamedReport {
        name: &names[k],
        report: measured[k].1,
    });
    let first = measured[0].1;
    let title = chart_title(&first.avatar, first.size, &first.device);
    match out.ending() {
        "svg" => out.write(sizes::svg(&reports, &title)?),
        _ => out.write(sizes::png(&reports, &title)?),
    }
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
    println!(
        "  {:26}{:>16}{:>16}{:>12}  second is",
        "", "first", "second", "change"
    );
    let cell = |value: Option<f64>| value.map_or("–".to_owned(), number);
    for line in lines {
        let [a, b] = line.values;
        let change = match (a, b) {
            (Some(a), Some(b)) if a != 0.0 && b != 0.0 => format!("{:.3}×", b / a),
            _ => "–".to_owned(),
        };
        println!(
            "  {:26}{:>16}{:>16}{change:>12}  {}",
            line.name,
            cell(a),
            cell(b),
            judged(line.is_better())
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

/// Empty where a number is no better and no worse, or neither is.
fn judged(is_better: Option<bool>) -> &'static str {
    match is_better {
        Some(true) => "better",
        Some(false) => "worse",
        None => "",
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
