//! The files that a benchmark writes: JSON, CSV, and the picture of a sweep.

use crate::measure::bench::{Report, plot, table};
use anyhow::Context;
use std::path::{Path, PathBuf};

/// Where JSON goes.
#[derive(Clone, Debug)]
pub enum Json {
    Stdout,
    File(PathBuf),
}

impl Json {
    pub fn is_stdout(&self) -> bool {
        matches!(self, Self::Stdout)
    }
}

/// Reads `-` or a file's name. It must end in `.json`: `bench --json body.avatar` names an avatar, which nobody wants overwritten.
pub fn json(text: &str) -> Result<Json, String> {
    if text == "-" {
        return Ok(Json::Stdout);
    }
    let path = PathBuf::from(text);
    let fits = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    fits.then_some(Json::File(path)).ok_or_else(|| format!("`{text}` does not end in .json; for the standard output write `--json -`"))
}

/// A picture to draw.
#[derive(Clone, Debug)]
pub enum Pareto {
    Svg(PathBuf),
    Png(PathBuf),
}

/// Reads the name of a picture.
pub fn pareto(text: &str) -> Result<Pareto, String> {
    let path = PathBuf::from(text);
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    match ending.as_str() {
        "svg" => Ok(Pareto::Svg(path)),
        "png" => Ok(Pareto::Png(path)),
        _ => Err(format!("`{text}` ends in neither .svg nor .png")),
    }
}

/// Writes what was asked for, and says so unless the JSON goes to the standard output.
pub fn write(report: &Report, json: Option<&Json>, csv: Option<&Path>, pictures: &[Pareto]) -> anyhow::Result<()> {
    let quiet = json.is_some_and(Json::is_stdout);
    let save = |path: &Path, bytes: &[u8]| -> anyhow::Result<()> {
        std::fs::write(path, bytes).with_context(|| format!("{} can't be written", path.display()))?;
        if !quiet {
            println!("wrote {}", path.display());
        }
        Ok(())
    };
    if let Some(sweep) = &report.sweep {
        let size = format!("{} × {}", report.size[0], report.size[1]);
        let title = format!("{}, {} Gaussians, {size}, on {}", report.avatar.name, report.avatar.gaussians, report.device.name);
        for picture in pictures {
            match picture {
                Pareto::Svg(path) => save(path, plot::svg(sweep, &title)?.as_bytes())?,
                Pareto::Png(path) => save(path, &plot::png(sweep, &title)?)?,
            }
        }
    }
    if let Some(path) = csv {
        save(path, &table::csv(&table::rows(report))?)?;
    }
    let text = || serde_json::to_string_pretty(report).map(|text| text + "\n");
    match json {
        Some(Json::File(path)) => save(path, text()?.as_bytes()),
        Some(Json::Stdout) => {
            print!("{}", text()?);
            Ok(())
        }
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_are_none_of_ours_are_not_written_over() {
        assert!(matches!(json("out/a.JSON"), Ok(Json::File(_))));
        assert!(matches!(json("-"), Ok(Json::Stdout)));
        assert!(json("body.avatar").is_err_and(|error| error.contains("body.avatar")));
        assert!(matches!((pareto("a.svg"), pareto("a.PNG")), (Ok(Pareto::Svg(_)), Ok(Pareto::Png(_)))));
        assert!(pareto("front").is_err());
    }
}
