//! The contents of a file of splats, in numbers: in its own unit and axes.

use super::text::{Distribution, line, thousands};
use effigy_core::{
    avatar::{Filter, ShCoefficients},
    io::splats::{Splats, Up},
};
use serde::Serialize;
use std::{fmt, path::Path};

/// Splats' counts and ranges. Lengths are in the file's unit.
#[derive(Serialize)]
pub struct SplatsSummary {
    kind: &'static str,
    name: String,
    gaussians: usize,
    /// Highest degree of view-dependent colour; 0 where it has none.
    harmonics: usize,
    /// The axis that points up, or is taken for it.
    up: Option<&'static str>,
    /// Along x, y, z.
    position: [Distribution; 3],
    /// Standard deviations of the Gaussians along their axes.
    scale: Distribution,
    /// 0 to 1.
    opacity: Distribution,
    /// Red, green, blue, seen from anywhere.
    color: [Distribution; 3],
    /// The low-pass that it was learned with.
    filter: Filter,
    bytes: u64,
}

impl SplatsSummary {
    pub fn new(path: &Path, splats: &Splats) -> Self {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let up = Up::ALL.iter().position(|&up| up == splats.up);
        Self {
            kind: "splats",
            name: name.into_owned(),
            gaussians: splats.len(),
            harmonics: splats.degree,
            up: up.map(|index| Up::NAMES[index]),
            position: [0, 1, 2].map(|axis| {
                Distribution::new(splats.position.iter().map(|at| f64::from(at[axis])))
            }),
            scale: Distribution::new(
                splats
                    .log_scale
                    .as_flattened()
                    .iter()
                    .map(|&scale| f64::from(scale).exp()),
            ),
            opacity: Distribution::new(
                splats
                    .opacity
                    .iter()
                    .map(|&logit| 1.0 / (1.0 + f64::from(-logit).exp())),
            ),
            color: [0, 1, 2].map(|channel| {
                let colors = splats.color.iter();
                Distribution::new(
                    colors.map(|color| 0.5 + ShCoefficients::CONSTANT * f64::from(color[channel])),
                )
            }),
            filter: splats.filter,
            bytes: path.metadata().map_or(0, |file| file.len()),
        }
    }
}

impl fmt::Display for SplatsSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        line(f, "splats", &self.name)?;
        line(f, "Gaussians", thousands(self.gaussians))?;
        match self.harmonics {
            0 => line(f, "harmonics", "none: colours do not depend on the view")?,
            degree => line(f, "harmonics", format_args!("degree {degree}"))?,
        }
        line(f, "up", self.up.unwrap_or_default())?;
        let [x, y, z] = &self.position;
        let [red, green, blue] = &self.color;
        for (name, values) in [
            ("x", x),
            ("y", y),
            ("z", z),
            ("deviation", &self.scale),
            ("opacity", &self.opacity),
            ("red", red),
            ("green", green),
            ("blue", blue),
        ] {
            let [min, median, max] = [values.min, values.median, values.max].map(short);
            line(f, name, format_args!("{min} to {max}, median {median}"))?;
        }
        line(f, "low-pass", format_args!("{} px²", self.filter))?;
        let each = self.bytes as f64 / self.gaussians.max(1) as f64;
        line(
            f,
            "file",
            format_args!(
                "{:.2} MB, {each:.1} bytes a Gaussian",
                self.bytes as f64 / 1e6
            ),
        )
    }
}

/// A number with four digits that count: scenes have any unit.
fn short(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_any_size_have_four_digits() {
        let shown = [0.003_000_4, 123.456, -20_480_000.0, 0.0, f64::INFINITY];
        let shown = shown.map(|number| short(number).to_string());
        assert_eq!(shown, ["0.003", "123.5", "-20480000", "0", "inf"]);
    }
}
