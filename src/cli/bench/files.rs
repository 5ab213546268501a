//! The files that a benchmark writes: JSON, CSV, and the chart of a sweep.

use crate::output::Output;
use effigy_measure::{
    bench::{BenchReport, plot, table},
    report::chart_title,
};

/// Writes the files that were asked for, and prints their names.
pub fn write(
    report: &BenchReport,
    json: Option<&Output>,
    csv: Option<&Output>,
    charts: &[Output],
) -> anyhow::Result<()> {
    let save = |out: &Output, bytes: &[u8]| -> anyhow::Result<()> {
        out.write(bytes)?;
        if !out.is_stdout() {
            println!("wrote {}", out.display());
        }
        Ok(())
    };
    if let Some(sweep) = &report.sweep {
        let title = chart_title(&report.avatar, report.size, &report.device);
        for chart in charts {
            match chart.ending() {
                "svg" => save(chart, plot::svg(sweep, &title)?.as_bytes())?,
                _ => save(chart, &plot::png(sweep, &title)?)?,
            }
        }
    }
    if let Some(path) = csv {
        save(path, &table::csv(&table::rows(report))?)?;
    }
    match json {
        Some(out) => save(
            out,
            (serde_json::to_string_pretty(report)? + "\n").as_bytes(),
        ),
        None => Ok(()),
    }
}
