//! `effigy devices --shader-stats`: what a driver's compiler made of each shader, as a table.

use crate::{
    demo,
    vulkan::{
        GpuOptions, Probe,
        statistics::{self, Executable, Value},
    },
};
use anyhow::Context;
use serde_json::json;
use std::{fmt::Write, path::Path};

/// Prints the table, or JSON; writes a file of comma-separated values where one is named.
pub fn run(device: Option<String>, json: bool, csv: Option<&Path>) -> anyhow::Result<()> {
    let (gpu, executables) = statistics::all(&GpuOptions::headless(device), &demo::avatar()?)?;
    let probe = &gpu.probe;
    if let Some(path) = csv {
        std::fs::write(path, self::csv(probe, &executables)?).with_context(|| format!("{} can't be written", path.display()))?;
    }
    if json {
        let all = json!({ "device": probe.name, "driver": probe.driver, "shaders": executables });
        println!("{}", serde_json::to_string_pretty(&all)?);
    } else {
        println!("{} ({})\n\n{}", probe.name, probe.driver, table(&executables));
    }
    Ok(())
}

/// A line a statistic.
fn csv(probe: &Probe, executables: &[Executable]) -> anyhow::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["device", "shader", "constants", "executable", "subgroup", "statistic", "value"])?;
    for made in executables {
        for statistic in &made.statistics {
            let numbers = [made.subgroup.to_string(), statistic.value.to_string()];
            let name = &statistic.name;
            writer.write_record([&probe.name, &made.shader, &made.constants, &made.executable, &numbers[0], name, &numbers[1]])?;
        }
    }
    Ok(writer.into_inner()?)
}

/// A line an executable and a column a statistic; executables of one shader that came out the same share a line, and statistics that
/// are 0 everywhere are named below.
fn table(executables: &[Executable]) -> String {
    let mut rows: Vec<(&Executable, usize)> = Vec::new();
    for made in executables {
        let same = |(row, _): &&mut (&Executable, usize)| {
            (&row.shader, &row.executable, &row.statistics) == (&made.shader, &made.executable, &made.statistics)
        };
        match rows.iter_mut().find(same) {
            Some((_, pipelines)) => *pipelines += 1,
            None => rows.push((made, 1)),
        }
    }
    let (columns, nothing) = columns(executables);
    let titles = ["shader", "executable", "pipelines", "subgroup"].into_iter().chain(columns.iter().copied());
    let mut grid: Vec<Vec<String>> = header(titles);
    for (made, pipelines) in rows {
        let mut row = vec![made.shader.clone(), made.executable.clone(), pipelines.to_string(), made.subgroup.to_string()];
        row.extend(columns.iter().map(|name| value(made, name).map_or("–".into(), |value| short(*value))));
        grid.push(row);
    }
    let mut text = align(&grid);
    if !nothing.is_empty() {
        let _ = write!(text, "\n0 everywhere: {}", nothing.join(", "));
    }
    text
}

/// The statistics that are not 0 somewhere, and the others, both as the driver orders them.
fn columns(executables: &[Executable]) -> (Vec<&str>, Vec<&str>) {
    let mut names: Vec<&str> = Vec::new();
    for statistic in executables.iter().flat_map(|made| &made.statistics) {
        if !names.contains(&statistic.name.as_str()) {
            names.push(&statistic.name);
        }
    }
    let is_some = |value: &Value| !matches!(value, Value::Bool(false) | Value::Signed(0) | Value::Unsigned(0) | Value::Float(0.0));
    names.into_iter().partition(|name| executables.iter().filter_map(|made| value(made, name)).any(is_some))
}

fn value<'a>(made: &'a Executable, name: &str) -> Option<&'a Value> {
    made.statistics.iter().find(|statistic| statistic.name == name).map(|statistic| &statistic.value)
}

fn short(value: Value) -> String {
    match value {
        Value::Float(value) => format!("{value:.2}"),
        value => value.to_string(),
    }
}

/// Titles a word a line, so that columns are no wider than they must be.
fn header<'a>(titles: impl Iterator<Item = &'a str>) -> Vec<Vec<String>> {
    let words: Vec<Vec<&str>> = titles.map(|title| title.split(' ').collect()).collect();
    let lines = words.iter().map(Vec::len).max().unwrap_or(0);
    // The last word stands on the last line.
    let word = |title: &Vec<&str>, line: usize| (line + title.len()).checked_sub(lines).map_or("", |at| title[at]).to_string();
    (0..lines).map(|line| words.iter().map(|title| word(title, line)).collect()).collect()
}

/// Names to the left, numbers to the right.
fn align(grid: &[Vec<String>]) -> String {
    let columns = grid.first().map_or(0, Vec::len);
    let widths: Vec<usize> = (0..columns).map(|column| grid.iter().map(|row| row[column].chars().count()).max().unwrap_or(0)).collect();
    let mut text = String::new();
    for row in grid {
        let mut line = String::new();
        for (column, (cell, &width)) in row.iter().zip(&widths).enumerate() {
            let _ = if column < 2 { write!(line, "{cell:width$}  ") } else { write!(line, "{cell:>width$}  ") };
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vulkan::statistics::Statistic;

    fn made(shader: &str, executable: &str, values: &[(&str, u64)]) -> Executable {
        let statistic =
            |&(name, value): &(&str, u64)| Statistic { name: name.into(), description: String::new(), value: Value::Unsigned(value) };
        Executable {
            shader: shader.into(),
            constants: "1 2".into(),
            executable: executable.into(),
            subgroup: 64,
            statistics: values.iter().map(statistic).collect(),
        }
    }

    #[test]
    fn the_table_merges_what_is_the_same_and_names_what_is_nothing() {
        let table = table(&[
            made("raster.vert", "main", &[("Instruction Count", 120), ("Spills", 0)]),
            made("raster.vert", "main", &[("Instruction Count", 120), ("Spills", 0)]),
            made("raster.vert", "binning", &[("Instruction Count", 60), ("Spills", 0)]),
            made("a.comp", "main", &[("Registers", 7)]),
        ]);
        let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split_whitespace().collect()).collect();
        assert_eq!(lines[0], ["Instruction"]);
        assert_eq!(lines[1], ["shader", "executable", "pipelines", "subgroup", "Count", "Registers"]);
        assert_eq!(lines[2], ["raster.vert", "main", "2", "64", "120", "–"]);
        assert_eq!(lines[3], ["raster.vert", "binning", "1", "64", "60", "–"]);
        assert_eq!(lines[4], ["a.comp", "main", "1", "64", "–", "7"]);
        assert_eq!(lines.last().map(|line| line.join(" ")).as_deref(), Some("0 everywhere: Spills"));
    }
}
