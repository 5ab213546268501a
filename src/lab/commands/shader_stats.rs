//! `effigy-lab shader-stats`: what a driver's compiler made of each shader, as a table: instructions,
//! registers and spills, as the driver counts them.

use effigy_cli::{
    options::DeviceArgs,
    output::{CSV, JSON, Output},
};
use effigy_render::vulkan::{
    Probe,
    statistics::{self, Executable, StatisticValue},
};
use serde_json::json;
use std::fmt::Write;

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    device: DeviceArgs,
    /// Print JSON, or write it to a file
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", value_parser = JSON.parser())]
    json: Option<Output>,
    /// Also write the result as comma-separated values
    #[arg(long, value_name = "FILE", value_parser = CSV.parser())]
    csv: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let (gpu, executables) = statistics::all(&args.device.gpu(), &effigy_demo::avatar()?)?;
    let probe = &gpu.probe;
    if let Some(out) = &args.csv {
        out.write(csv(probe, &executables)?)?;
    }
    if let Some(out) = &args.json {
        let all = json!({ "device": probe.name, "driver": probe.driver, "shaders": executables });
        out.write_json(&all)?;
    } else {
        println!(
            "{} ({})\n\n{}",
            probe.name,
            probe.driver,
            table(&executables)
        );
    }
    Ok(())
}

/// A line per statistic.
fn csv(probe: &Probe, executables: &[Executable]) -> anyhow::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "device",
        "shader",
        "constants",
        "executable",
        "subgroup",
        "statistic",
        "value",
    ])?;
    for executable in executables {
        let subgroup = executable.subgroup.to_string();
        for statistic in &executable.statistics {
            writer.write_record([
                &probe.name,
                &executable.shader,
                &executable.constants,
                &executable.executable,
                &subgroup,
                &statistic.name,
                &statistic.value.to_string(),
            ])?;
        }
    }
    Ok(writer.into_inner()?)
}

/// A line per executable and a column per statistic. Executables of one shader with equal
/// statistics share a line; statistics that are 0 everywhere are named below the table.
fn table(executables: &[Executable]) -> String {
    let mut rows: Vec<ShaderRow> = Vec::new();
    for executable in executables {
        match rows.iter_mut().find(|row| row.is_equal(executable)) {
            Some(row) => row.pipelines += 1,
            None => rows.push(ShaderRow {
                executable,
                pipelines: 1,
            }),
        }
    }
    let (columns, zero) = columns(executables);
    let titles = ["shader", "executable", "pipelines", "subgroup"]
        .into_iter()
        .chain(columns.iter().copied());
    let mut grid: Vec<Vec<String>> = header(titles);
    grid.extend(rows.iter().map(|row| row.cells(&columns)));
    let mut text = align(&grid);
    if !zero.is_empty() {
        let _ = write!(text, "\n0 everywhere: {}", zero.join(", "));
    }
    text
}

/// A line of the table.
struct ShaderRow<'a> {
    executable: &'a Executable,
    /// Pipelines whose executables came out equal.
    pipelines: usize,
}

impl ShaderRow<'_> {
    fn is_equal(&self, other: &Executable) -> bool {
        let own = self.executable;
        own.shader == other.shader
            && own.executable == other.executable
            && own.statistics == other.statistics
    }

    fn cells(&self, columns: &[&str]) -> Vec<String> {
        let Self {
            executable,
            pipelines,
        } = self;
        let mut cells = vec![
            executable.shader.clone(),
            executable.executable.clone(),
            pipelines.to_string(),
            executable.subgroup.to_string(),
        ];
        for name in columns {
            cells.push(value(executable, name).map_or("–".into(), |value| short(*value)));
        }
        cells
    }
}

/// The statistics that are not 0 somewhere, and the others, both as the driver orders them.
fn columns(executables: &[Executable]) -> (Vec<&str>, Vec<&str>) {
    let mut names: Vec<&str> = Vec::new();
    for executable in executables {
        for statistic in &executable.statistics {
            if !names.contains(&statistic.name.as_str()) {
                names.push(&statistic.name);
            }
        }
    }
    let is_zero = |value: &StatisticValue| {
        matches!(
            value,
            StatisticValue::Bool(false)
                | StatisticValue::Signed(0)
                | StatisticValue::Unsigned(0)
                | StatisticValue::Float(0.0)
        )
    };
    names.into_iter().partition(|name| {
        executables
            .iter()
            .filter_map(|executable| value(executable, name))
            .any(|value| !is_zero(value))
    })
}

fn value<'a>(executable: &'a Executable, name: &str) -> Option<&'a StatisticValue> {
    executable
        .statistics
        .iter()
        .find(|statistic| statistic.name == name)
        .map(|statistic| &statistic.value)
}

fn short(value: StatisticValue) -> String {
    match value {
        StatisticValue::Float(value) => format!("{value:.2}"),
        value => value.to_string(),
    }
}

/// Titles with a word per line, so that they widen their columns little.
fn header<'a>(titles: impl Iterator<Item = &'a str>) -> Vec<Vec<String>> {
    let words: Vec<Vec<&str>> = titles.map(|title| title.split(' ').collect()).collect();
    let lines = words.iter().map(Vec::len).max().unwrap_or(0);
    // Titles end on the last line: a title of one word has its word there.
    let word = |title: &Vec<&str>, line: usize| {
        let index = (line + title.len()).checked_sub(lines);
        index.map_or("", |index| title[index]).to_owned()
    };
    (0..lines)
        .map(|line| words.iter().map(|title| word(title, line)).collect())
        .collect()
}

/// Names to the left, numbers to the right.
fn align(grid: &[Vec<String>]) -> String {
    let columns = grid.first().map_or(0, Vec::len);
    let widths: Vec<usize> = (0..columns)
        .map(|column| {
            grid.iter()
                .map(|row| row[column].chars().count())
                .max()
                .unwrap_or(0)
        })
        .collect();
    let mut text = String::new();
    for row in grid {
        let mut line = String::new();
        for (column, (cell, &width)) in row.iter().zip(&widths).enumerate() {
            let _ = if column < 2 {
                write!(line, "{cell:width$}  ")
            } else {
                write!(line, "{cell:>width$}  ")
            };
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_render::vulkan::statistics::Statistic;

    fn executable_with(shader: &str, executable: &str, values: &[(&str, u64)]) -> Executable {
        let statistic = |&(name, value): &(&str, u64)| Statistic {
            name: name.into(),
            description: String::new(),
            value: StatisticValue::Unsigned(value),
        };
        Executable {
            shader: shader.into(),
            constants: "1 2".into(),
            executable: executable.into(),
            subgroup: 64,
            statistics: values.iter().map(statistic).collect(),
        }
    }

    #[test]
    fn equal_executables_share_a_line_and_zeros_are_named() {
        let table = table(&[
            executable_with(
                "raster.vert",
                "main",
                &[("Instruction Count", 120), ("Spills", 0)],
            ),
            executable_with(
                "raster.vert",
                "main",
                &[("Instruction Count", 120), ("Spills", 0)],
            ),
            executable_with(
                "raster.vert",
                "binning",
                &[("Instruction Count", 60), ("Spills", 0)],
            ),
            executable_with("a.comp", "main", &[("Registers", 7)]),
        ]);
        let lines: Vec<Vec<&str>> = table
            .lines()
            .map(|line| line.split_whitespace().collect())
            .collect();
        assert_eq!(lines[0], ["Instruction"]);
        assert_eq!(
            lines[1],
            [
                "shader",
                "executable",
                "pipelines",
                "subgroup",
                "Count",
                "Registers"
            ]
        );
        assert_eq!(lines[2], ["raster.vert", "main", "2", "64", "120", "–"]);
        assert_eq!(lines[3], ["raster.vert", "binning", "1", "64", "60", "–"]);
        assert_eq!(lines[4], ["a.comp", "main", "1", "64", "–", "7"]);
        assert_eq!(
            lines.last().map(|line| line.join(" ")).as_deref(),
            Some("0 everywhere: Spills")
        );
    }
}
